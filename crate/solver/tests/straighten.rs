//! Straightened paths: locally shortest, as an independent measure sees it, and equal to closed forms.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common;

use std::f64::consts::{PI, TAU};

use crate::common::exact_distances::{self, Field, Known};
use crate::common::shortness::{check_valid, largest_kink, sharpest_turn};
use crate::common::truth::Random;
use crate::common::{band, book, distance_from, nearest, solver, soup, square, stretched, surface};
use glam::{DVec3, Vec3Swizzles};
use heatwalk::{
    Boundary, Element, FaceId, HeatSolver, InputVertex, Path, Place, Soup, Surface, VertexId, descend, edge_path,
    straighten, straightest,
};
use heatwalk_shapes as shapes;

/// Straightens and checks all that must hold on any surface.
fn straightened(surface: &Surface, path: &Path) -> Path {
    let straight = straighten(surface, path).expect("a path of this surface");
    check_valid(surface, path);
    check_valid(surface, &straight);
    let ends = |path: &Path| [path.points[0].position, path.points[path.points.len() - 1].position];
    for (a, b) in ends(path).into_iter().zip(ends(&straight)) {
        // Rounding of weights of 0 that are left out.
        assert!(a.distance(b) <= 1e-12 * surface.mean_edge());
    }
    assert!(straight.length() <= path.length());
    // Turns short of π by 10⁻⁷ are left as straight. A line that passes a vertex within 10⁻¹⁴ of an edge is taken to go
    // through it, which moves angles by that over the thickness of the slivers there: 10⁻⁸ at the thinnest here.
    let turn = sharpest_turn(surface, &straight);
    assert!(turn >= PI - 1e-6, "a turn short of π by {:e}", PI - turn);
    // Rounding of a chain of unfoldings.
    let kink = largest_kink(surface, &straight);
    assert!(kink < 1e-10, "a kink of {kink:e}");
    straight
}

fn random_point(surface: &Surface, random: &mut Random) -> Place {
    if random.below(2) == 0 {
        return Place::Vertex(VertexId::from_index(random.below(surface.vertex_count())));
    }
    let a = random.share();
    let b = (1.0 - a) * random.share();
    let face = FaceId(random.below(surface.face_count()) as u32);
    let weights = if random.below(4) == 0 { [a, 1.0 - a, 0.0] } else { [a, b, 1.0 - a - b] };
    Place::Face { face, weights }
}

/// Descends and straightens between random points, and hands both on.
fn try_pairs(solver: &HeatSolver, pairs: usize, mut each: impl FnMut(DVec3, DVec3, &Path)) {
    let surface = solver.surface();
    let mut random = Random::new(3);
    for _ in 0..pairs {
        let [source, from] = [(); 2].map(|()| random_point(surface, &mut random));
        let distance = solver.distance(&[source]).expect("a source");
        let path = descend(surface, &distance, from).expect("reachable");
        each(from.position(surface), source.position(surface), &straightened(surface, &path));
    }
}

/// A walk along edges that chooses each next one at random.
fn random_walk(surface: &Surface, random: &mut Random, steps: usize) -> Path {
    let mut vertices = vec![VertexId::from_index(random.below(surface.vertex_count()))];
    for _ in 0..steps {
        let corners: Vec<_> = surface.corners_of_vertex(vertices[vertices.len() - 1]).collect();
        let (face, k) = corners[random.below(corners.len())];
        vertices.push(surface.faces()[face][(k + 1 + random.below(2)) % 3]);
    }
    Path::along_edges(surface, &vertices).expect("edges")
}

#[test]
fn plane() {
    try_pairs(&solver(&square(20), 1.0, Boundary::Neumann), 60, |from, to, path| {
        // Rounding of some ten crossings.
        assert!((path.length() - from.distance(to)).abs() < 1e-12, "{} for {}", path.length(), from.distance(to));
        let along = (to - from).normalize_or_zero();
        assert!(path.points.iter().all(|point| (point.position - from).cross(along).length() < 1e-12));
    });
}

#[test]
fn any_walk_in_the_plane_becomes_the_line() {
    let surface = surface(&square(12));
    let mut random = Random::new(8);
    for steps in 0..200 {
        let walk = random_walk(&surface, &mut random, steps);
        let [from, to] = [walk.points[0].position, walk.points[walk.points.len() - 1].position];
        // Rounding of some ten crossings.
        assert!((straightened(&surface, &walk).length() - from.distance(to)).abs() < 1e-12);
    }
}

/// The box [0, 1]³, its sides cut into `n × n` quads.
pub fn cube(n: u32) -> Soup {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for side in 0..6 {
        let first = positions.len() as u32;
        for i in 0..=n {
            for j in 0..=n {
                let mut position = DVec3::new(f64::from(i), f64::from(j), 0.0) / f64::from(n);
                position.z = f64::from(side / 3);
                positions.push(match side % 3 {
                    0 => position,
                    1 => position.zxy(),
                    _ => position.yzx(),
                });
            }
        }
        triangles.extend(common::grid_triangles(first, n));
    }
    soup(positions, triangles)
}

#[test]
fn over_an_edge_of_a_cube() {
    let solver = solver(&cube(10), 1.0, Boundary::Neumann);
    let surface = solver.surface();
    assert_eq!(surface.report().euler_characteristic, 2);
    let mut random = Random::new(1);
    for _ in 0..40 {
        // On the top and on the front, near enough to their common edge that no way over a third side is shorter.
        let mut tenth = || random.below(5) as f64 / 10.0;
        let [x, y, u, z] = [0.3 + tenth(), tenth(), 0.3 + tenth(), 1.0 - tenth()];
        let [top, front] = [DVec3::new(x, y, 1.0), DVec3::new(u, 0.0, z)];
        let [from, to] = [top, front].map(|position| nearest(surface, position));
        let distance = solver.distance(&[Place::Vertex(to)]).expect("a source");
        let path = descend(surface, &distance, Place::Vertex(from)).expect("reachable");
        let exact = (x - u).hypot(y + 1.0 - z);
        // Rounding of some ten crossings.
        let length = straightened(surface, &path).length();
        assert!((length - exact).abs() < 1e-12, "{length} for {exact}");
    }
}

#[test]
fn around_a_prism() {
    let segments = 24;
    let surface = surface(&shapes::cylinder(4.0, segments, 16));
    let chord = 2.0 * (PI / f64::from(segments)).sin();
    let on_side = |k: u32, y: f64| {
        let angle = TAU * f64::from(k) / f64::from(segments);
        let position = |offset: f64| DVec3::new(angle.cos(), y + offset, angle.sin());
        nearest(&surface, position(0.0))
    };
    let middle = surface.positions().iter().map(|position| position.y).sum::<f64>() / surface.vertex_count() as f64;
    for k in 0..9 {
        for rise in [-0.5, 0.25, 1.0] {
            let [from, to] = [on_side(0, middle), on_side(k, middle + rise)];
            let way = edge_path(&surface, from, to).expect("connected");
            let path = straightened(&surface, &Path::along_edges(&surface, &way).expect("edges"));
            let rise = surface.position(to).y - surface.position(from).y;
            let exact = (chord * f64::from(k)).hypot(rise);
            // Rounding of some ten crossings.
            assert!((path.length() - exact).abs() < 1e-12, "{} for {exact}", path.length());
        }
    }
}

#[test]
fn sphere() {
    let solver = solver(&shapes::icosphere(4), 1.0, Boundary::Neumann);
    try_pairs(&solver, 60, |from, to, path| {
        let arc = from.normalize().dot(to.normalize()).clamp(-1.0, 1.0).acos();
        // Edges of 0.07 lie 0.0006 inside the sphere; steps between faces of the same size lengthen by as much.
        assert!((path.length() / arc - 1.0).abs() < 0.002 || arc < 0.1, "{} for {arc}", path.length());
    });
}

#[test]
fn every_kind_of_surface() {
    let slivers = stretched(square(12), 1e-4);
    let needle = stretched(shapes::icosphere(3), 1e3);
    let shapes = [band(24, 1), band(24, 3), book(3, 6), slivers, needle, shapes::torus(2.0, 0.7, 24, 12)];
    for soup in shapes.into_iter().chain([shapes::maze(4, 3), shapes::uv_sphere(40, 20), shapes::grid(9, 9)]) {
        try_pairs(&solver(&soup, 1.0, Boundary::Neumann), 30, |_, _, _| {});
        let surface = surface(&soup);
        let mut random = Random::new(12);
        for steps in 0..60 {
            straightened(&surface, &random_walk(&surface, &mut random, steps));
        }
    }
}

#[test]
fn slivers_of_any_thickness() {
    let mut random = Random::new(15);
    for thickness in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8] {
        for soup in [shapes::grid(12, 12), shapes::icosphere(2)] {
            let surface = surface(&stretched(soup, thickness));
            for steps in 0..100 {
                straightened(&surface, &random_walk(&surface, &mut random, steps));
                let from = random_point(&surface, &mut random);
                let direction = DVec3::new(random.below(99) as f64 - 49.5, 0.3, random.below(99) as f64);
                let walk =
                    straightest(&surface, from, None, direction, 20.0 * surface.mean_edge()).expect("a direction");
                straightened(&surface, &walk.path);
            }
        }
    }
}

#[test]
fn rough_terrain() {
    let mut random = Random::new(6);
    for height in [0.01, 0.3, 3.0, 30.0] {
        let mut soup = shapes::grid(14, 14);
        for position in &mut soup.positions {
            position.y = height * random.share();
        }
        let surface = surface(&soup);
        for steps in 0..100 {
            straightened(&surface, &random_walk(&surface, &mut random, steps));
        }
    }
}

#[test]
fn around_a_corner_of_the_boundary() {
    // The unit square without its upper right quarter.
    let mut soup = square(16);
    let positions = soup.positions.clone();
    soup.triangles.retain(|triangle| {
        let middle = triangle.map(|vertex| positions[vertex as usize]).iter().sum::<DVec3>() / 3.0;
        middle.x < 0.5 || middle.y < 0.5
    });
    let solver = solver(&soup, 1.0, Boundary::Neumann);
    let corner = DVec3::new(0.5, 0.5, 0.0);
    try_pairs(&solver, 200, |from, to, path| {
        // Seen past the corner, or bent around it.
        let is_apart = |p: DVec3, q: DVec3| p.x > 0.5 && q.y > 0.5 && (q - p).cross(corner - p).z > 0.0;
        let exact = match is_apart(from, to) || is_apart(to, from) {
            true => from.distance(corner) + corner.distance(to),
            false => from.distance(to),
        };
        // Rounding of some ten crossings.
        assert!((path.length() - exact).abs() < 1e-12, "{} for {exact}", path.length());
    });
}

#[test]
fn any_triangles() {
    common::for_any_triangles(21, |surface, random| {
        for steps in 0..30 {
            straightened(surface, &random_walk(surface, random, steps));
        }
    });
}

#[test]
fn any_unit() {
    let normal = straightened_length(1.0);
    for scale in [1e-150, 1e-20, 1e20, 1e149] {
        // Rounding of the coordinates by the scale, and what follows from it.
        assert!((straightened_length(scale) / scale / normal - 1.0).abs() < 1e-12, "{scale:e}");
    }
}

fn straightened_length(scale: f64) -> f64 {
    let mut torus = shapes::torus(2.0, 0.7, 30, 15);
    for position in &mut torus.positions {
        *position *= scale;
    }
    let surface = surface(&torus);
    let way = edge_path(&surface, VertexId(0), VertexId(217)).expect("connected");
    straighten(&surface, &Path::along_edges(&surface, &way).expect("edges")).expect("a path of this surface").length()
}

#[test]
fn a_way_there_and_back_is_a_point() {
    for soup in [square(6), band(12, 1), book(3, 4)] {
        let surface = surface(&soup);
        let mut way = edge_path(&surface, VertexId(0), VertexId(17)).expect("connected");
        way.extend(way.clone().into_iter().rev().skip(1));
        let path = straightened(&surface, &Path::along_edges(&surface, &way).expect("edges"));
        assert_eq!((path.points.len(), path.length()), (1, 0.0));
    }
}

#[test]
fn straight_paths_stay_as_they_are() {
    let surface = surface(&shapes::torus(2.0, 0.7, 24, 12));
    let mut random = Random::new(2);
    for _ in 0..40 {
        let from = random_point(&surface, &mut random);
        let direction = DVec3::new(random.below(99) as f64 - 49.0, random.below(99) as f64 - 49.0, 3.5);
        let walk = straightest(&surface, from, None, direction, 3.0).expect("a direction");
        let straight = straightened(&surface, &walk.path);
        // Rounding of one walk of some ten faces.
        assert!((walk.path.length() - 3.0).abs() < 1e-12 && straight.length() <= 3.0 + 1e-12);
        let again = straightened(&surface, &straight);
        assert!((again.length() - straight.length()).abs() < 1e-12);
    }
}

/// No path is shorter than the exact distance by another program, and most are no longer.
fn straightened_paths_are_mostly_shortest(meshes: &[Known]) {
    for Known { name, soup, fields } in meshes {
        let Field { source, exact, .. } = &fields[0];
        let (solver, distance) = distance_from(soup, *source as u32);
        let surface = solver.surface();
        let mut random = Random::new(14);
        let mut excess = Vec::new();
        for _ in 0..200 {
            let input = random.below(exact.len());
            let from = surface.vertex_of_input(InputVertex::from_index(input)).expect("a vertex in use");
            let path = descend(surface, &distance, Place::Vertex(from)).expect("reachable");
            let length = straightened(surface, &path).length();
            // Rounding of the file's exact values and of the sum.
            assert!(length >= exact[input] * (1.0 - 1e-9), "{name}: {length} is under {}", exact[input]);
            if exact[input] > 0.0 {
                excess.push(length / exact[input] - 1.0);
            }
        }
        excess.sort_by(f64::total_cmp);
        // Shortest of all where the path descended on the right side of every bump.
        assert!(excess[excess.len() / 2] < 1e-6, "{name}: {:e}", excess[excess.len() / 2]);
    }
}

#[test]
fn straightened_paths_are_mostly_shortest_on_small_meshes() {
    straightened_paths_are_mostly_shortest(&exact_distances::kept());
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
#[ignore = "needs HEATWALK_MESHES"]
fn straightened_paths_are_mostly_shortest_on_large_meshes() {
    straightened_paths_are_mostly_shortest(&exact_distances::large());
}
