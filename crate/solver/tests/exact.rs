//! Exact distance: against closed forms, against itself, and against another program.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::exact_distances::{self, Field, Known};
use crate::common::truth::Random;
use crate::common::{any_triangles, band, book, flat, nearest, soup, square, surface, two_squares};
use glam::DVec3;
use heatwalk::exact::{ExactGeometry, Wavefront, exact_distance};
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{Element, Error, FaceId, HalfedgeId, InputVertex, Path, Place, Soup, Surface, VertexId, go_on};
use heatwalk_shapes as shapes;

/// Everything is the length of a path, and lost to rounding is less than this share.
const EXACT: f64 = 1e-9;

fn start(surface: &Arc<Surface>, sources: &[(Place, f64)], targets: &[Place]) -> Wavefront {
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(surface)));
    Wavefront::with_targets(geometry, sources, targets).expect("valid sources and targets")
}

fn finished(surface: &Arc<Surface>, sources: &[(Place, f64)], targets: &[Place]) -> Wavefront {
    let mut wavefront = start(surface, sources, targets);
    assert!(wavefront.advance(f64::INFINITY, usize::MAX).expect("room for windows") && wavefront.is_done());
    wavefront
}

/// Distance along an edge bounds the difference of the values at its ends; sources are at their start values.
fn check_lipschitz(wavefront: &Wavefront, surface: &Surface, sources: &[(Place, f64)]) {
    let values = wavefront.values();
    for face in surface.mesh().faces() {
        for k in 0..3 {
            let [a, b] = [surface.faces()[face][k], surface.faces()[face][(k + 1) % 3]];
            let (from, to) = (values[a], values[b]);
            assert!(!from.is_nan() && from.is_infinite() == to.is_infinite(), "{a} {from}, {b} {to}");
            let length = surface.position(a).distance(surface.position(b));
            let difference = if from.is_finite() { (from - to).abs() } else { 0.0 };
            assert!(difference <= length + EXACT * from.max(to), "{a} at {from}, {b} at {to}, {length} apart");
        }
    }
    for &(location, offset) in sources {
        if let Place::Vertex(VertexId(point)) = location {
            assert!(values[VertexId(point)] <= offset);
        }
    }
}

/// A path goes through the faces it names, from `from` to a source, and is as long as the value says.
fn check_path(surface: &Surface, path: &Path, from: Place, value: f64, sources: &[(Place, f64)]) {
    assert_eq!(path.points.len(), path.normals.len());
    let [first, last] = [path.points[0], path.points[path.points.len() - 1]].map(|point| point.position);
    assert_eq!(first, from.position(surface));
    let offset = sources.iter().filter(|source| source.0.position(surface) == last).map(|source| source.1);
    let offset = offset.min_by(f64::total_cmp).expect("the path ends at a source");
    for pair in path.points.windows(2) {
        for point in pair {
            let corners = surface.faces()[pair[0].face];
            let lies_in_face = point.location.support(surface).all(|(corner, _)| corners.contains(&corner));
            assert!(lies_in_face, "{point:?} is not in {:?} {corners:?}", pair[0].face);
        }
    }
    let error = path.length() + offset - value;
    assert!(error.abs() <= EXACT * value, "{from:?}: {} for {value}", path.length() + offset);
}

fn random_location(surface: &Surface, random: &mut Random) -> Place {
    let (a, b) = (random.share(), random.share());
    match random.below(3) {
        0 => Place::Vertex(VertexId::from_index(random.below(surface.vertex_count()))),
        1 => Place::Edge { halfedge: HalfedgeId(random.below(surface.mesh().halfedge_count()) as u32), fraction: a },
        _ => {
            let weights = [a, (1.0 - a) * b, (1.0 - a) * (1.0 - b)];
            Place::Face { face: FaceId(random.below(surface.face_count()) as u32), weights }
        }
    }
}

/// From random sources to random targets: values are symmetric, Lipschitz and those of paths; stopping is harmless.
fn try_shape(soup: &Soup, rounds: usize, seed: u64) {
    let surface = Arc::new(surface(soup));
    let mut random = Random::new(seed);
    for _ in 0..rounds {
        let source = random_location(&surface, &mut random);
        let targets: Vec<_> = (0..20).map(|_| random_location(&surface, &mut random)).collect();
        let sources = [(source, 0.25 * surface.mean_edge())];
        let wavefront = finished(&surface, &sources, &targets);
        check_lipschitz(&wavefront, &surface, &sources);
        for (index, (&target, &value)) in targets.iter().zip(wavefront.target_values()).enumerate() {
            if let Place::Vertex(VertexId(point)) = target {
                let here = wavefront.values()[VertexId(point)];
                assert!(value == here || (value - here).abs() <= EXACT * here, "{value} and {here}");
            }
            match wavefront.path_from_target(index) {
                Ok(path) => check_path(&surface, &path, target, value, &sources),
                Err(error) => assert!(error == Error::Unreachable && value.is_infinite()),
            }
        }
        for _ in 0..20 {
            let point = random.below(surface.vertex_count()) as u32;
            let value = wavefront.values()[VertexId(point)];
            match wavefront.path_from_vertex(VertexId(point)) {
                Ok(path) => check_path(&surface, &path, Place::Vertex(VertexId(point)), value, &sources),
                Err(error) => assert!(error == Error::Unreachable && value.is_infinite()),
            }
        }
        let back = finished(&surface, &[(targets[0], sources[0].1)], &[source]);
        let (there, back) = (wavefront.target_values()[0], back.target_values()[0]);
        assert!(there == back || (there - back).abs() <= EXACT * there, "{there} there, {back} back");
    }
}

#[test]
fn plane_is_straight() {
    let surface = Arc::new(surface(&square(12)));
    let mut random = Random::new(5);
    for _ in 0..10 {
        let source = random_location(&surface, &mut random);
        let targets: Vec<_> = (0..40).map(|_| random_location(&surface, &mut random)).collect();
        let wavefront = finished(&surface, &[(source, 0.0)], &targets);
        let at_vertices = wavefront.values().iter().copied().zip(surface.positions().iter().copied());
        let places = targets.iter().map(|target| target.position(&surface));
        for (value, position) in at_vertices.chain(wavefront.target_values().iter().copied().zip(places)) {
            let straight = position.distance(source.position(&surface));
            assert!((value - straight).abs() <= EXACT * straight, "{value} for {straight}");
        }
    }
}

#[test]
fn cube_around_an_edge() {
    let corner = |x: u32, y: u32, z: u32| DVec3::new(f64::from(x), f64::from(y), f64::from(z));
    let positions = (0..8).map(|i| corner(i & 1, i >> 1 & 1, i >> 2)).collect();
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let surface = Arc::new(surface(&soup(positions, triangles)));
    let wavefront = finished(&surface, &[(Place::Vertex(VertexId(0)), 0.0)], &[]);
    let far = nearest(&surface, DVec3::ONE);
    // Two squares side by side.
    assert!((wavefront.values()[far] - 5.0_f64.sqrt()).abs() < EXACT);
}

#[test]
fn reflex_boundary_bends_paths() {
    // An L of three unit squares: paths between its ends bend at the inner corner (1, 1).
    let positions =
        flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0), (1.0, 1.0), (2.0, 1.0), (0.0, 2.0), (1.0, 2.0)]);
    let triangles = vec![[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [3, 4, 7], [3, 7, 6]];
    let surface = Arc::new(surface(&soup(positions, triangles)));
    let at = |x, y| nearest(&surface, DVec3::new(x, y, 0.0));
    let source = [(Place::Vertex(at(2.0, 1.0)), 0.0)];
    let wavefront = finished(&surface, &source, &[]);
    let bent = at(0.0, 2.0);
    let value = wavefront.values()[bent];
    assert!((value - (1.0 + 2.0_f64.sqrt())).abs() < EXACT, "{value}");
    check_path(&surface, &wavefront.path_from_vertex(bent).expect("a path"), Place::Vertex(bent), value, &source);
}

#[test]
fn closed_shapes() {
    try_shape(&shapes::icosphere(3), 4, 1);
    try_shape(&shapes::torus(2.0, 0.7, 24, 12), 4, 2);
}

#[test]
fn bounded_shapes() {
    try_shape(&square(8), 4, 3);
    try_shape(&shapes::cylinder(4.0, 16, 8), 3, 4);
    try_shape(&shapes::strip(3.0, 40.0, 3), 3, 5);
}

#[test]
fn shapes_that_are_no_manifold() {
    try_shape(&band(24, 1), 4, 6);
    try_shape(&book(3, 6), 4, 7);
    // Two squares with one vertex in common.
    let mut bow_tie = square(4);
    let first = bow_tie.positions.len() as u32;
    let corner =
        bow_tie.positions.iter().position(|&position| position == DVec3::new(1.0, 1.0, 0.0)).expect("a corner");
    let other = square(4);
    bow_tie.positions.extend(other.positions.iter().map(|&position| position + DVec3::new(1.0, 1.0, 0.0)));
    let shared = |vertex| if vertex == 0 { corner as u32 } else { vertex + first };
    bow_tie.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(shared)));
    try_shape(&bow_tie, 4, 8);
    let surface = Arc::new(surface(&bow_tie));
    let [from, to] = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0)].map(|position| nearest(&surface, position));
    let wavefront = finished(&surface, &[(Place::Vertex(from), 0.0)], &[]);
    assert!((wavefront.values()[to] - (1.0 + 2.0_f64.sqrt())).abs() < EXACT);
}

#[test]
fn badly_shaped_faces() {
    let mut random = Random::new(12);
    let mut crumpled = square(10);
    for position in &mut crumpled.positions {
        position.x *= 1e-4;
        position.z = 1e-3 * random.share();
    }
    try_shape(&crumpled, 4, 9);
    // Edges a billion times shorter than others, and angles as near to 0 and π.
    let mut pinched = square(8);
    for position in &mut pinched.positions {
        if position.x > 0.4 && position.x < 0.6 {
            position.x = 0.5 + 1e-9 * (position.x - 0.5);
        }
        position.z = 0.1 * (position.x * 9.0).sin() * (position.y * 7.0).cos();
    }
    try_shape(&pinched, 4, 10);
}

#[test]
fn pieces_without_a_source_are_infinite() {
    let (two, first) = two_squares(3);
    let surface = Arc::new(surface(&two));
    let wavefront = finished(&surface, &[(Place::Vertex(VertexId(0)), 0.0)], &[Place::Vertex(VertexId(first))]);
    for (value, position) in wavefront.values().iter().zip(surface.positions()) {
        assert_eq!(value.is_infinite(), position.z > 0.5);
    }
    assert_eq!(wavefront.path_from_vertex(VertexId(first)), Err(Error::Unreachable));
    assert_eq!(wavefront.path_from_target(0), Err(Error::Unreachable));
}

#[test]
fn several_sources_are_the_least_of_each() {
    let surface = Arc::new(surface(&shapes::icosphere(3)));
    let mut random = Random::new(21);
    let sources: Vec<_> = (0..5).map(|i| (random_location(&surface, &mut random), 0.1 * f64::from(i))).collect();
    let together = finished(&surface, &sources, &[]);
    check_lipschitz(&together, &surface, &sources);
    let each: Vec<_> = sources.iter().map(|&source| finished(&surface, &[source], &[])).collect();
    for (point, &value) in together.values().iter().enumerate() {
        let least = each.iter().map(|alone| alone.values()[VertexId::from_index(point)]).fold(f64::INFINITY, f64::min);
        assert!((value - least).abs() <= EXACT * least, "{value} for {least}");
        let path = together.path_from_vertex(VertexId(point as u32)).expect("a path");
        check_path(&surface, &path, Place::Vertex(VertexId::from_index(point)), value, &sources);
    }
}

#[test]
fn sources_on_one_edge_are_the_least_of_each() {
    for soup in [shapes::icosphere(2), shapes::terrain(9)] {
        let surface = Arc::new(surface(&soup));
        let mut random = Random::new(31);
        let halfedge = FaceId(60).halfedge(0);
        let on_edge = |fraction: f64| (Place::Edge { halfedge, fraction }, 0.0);
        let sources: Vec<_> = (0..80).map(|_| on_edge(random.share())).collect();
        let together = finished(&surface, &sources, &[]);
        let each: Vec<_> = sources.iter().map(|&source| finished(&surface, &[source], &[])).collect();
        for vertex in surface.vertices() {
            let value = together.values()[vertex];
            let least = each.iter().map(|alone| alone.values()[vertex]).fold(f64::INFINITY, f64::min);
            assert!((value - least).abs() <= EXACT * least, "{value} for {least}");
            let path = together.path_from_vertex(vertex).expect("a path");
            check_path(&surface, &path, Place::Vertex(vertex), value, &sources);
        }
    }
}

#[test]
fn stopping_changes_nothing() {
    let surface = Arc::new(surface(&shapes::torus(2.0, 0.7, 32, 16)));
    let sources = [(Place::Vertex(VertexId(3)), 0.0)];
    let whole = finished(&surface, &sources, &[]);
    let mut steps = start(&surface, &sources, &[]);
    let mut radius = 0.0;
    while !steps.is_done() {
        radius += 0.37 * surface.mean_edge();
        while !steps.advance(radius, 50).expect("room for windows") {}
        assert!(steps.radius() >= radius);
        for (&value, &last) in steps.values().iter().zip(whole.values()) {
            assert!(value >= last && (last >= radius || value == last), "{value} at {radius}, {last} in the end");
        }
    }
    assert_eq!(steps.values(), whole.values());
    assert_eq!(steps.windows(), whole.windows());
}

#[test]
fn bad_requests_are_refused() {
    let surface = Arc::new(surface(&square(2)));
    assert_eq!(exact_distance::<Place>(&surface, &[], &mut go_on), Err(Error::NoSource));
    let offset = exact_distance(&surface, &[(Place::Vertex(VertexId(0)), -1.0)], &mut go_on);
    assert!(matches!(offset, Err(Error::Surface(SurfaceError::BadParameter { .. }))));
    let vertex = exact_distance(&surface, &[(Place::Vertex(VertexId(1000)), 0.0)], &mut go_on);
    assert!(matches!(vertex, Err(Error::Surface(SurfaceError::NoSuchVertex { .. }))));
    let values = exact_distance(&surface, &[(Place::Vertex(VertexId(0)), 1.0)], &mut go_on).expect("values");
    assert_eq!(values[VertexId(0)], 1.0);
}

/// Against the exact distances of pygeodesic (Kirsanov's implementation of Mitchell, Mount, Papadimitriou).
fn check_known(Known { name, soup, fields }: &Known) {
    let surface = Arc::new(surface(soup));
    for Field { source, exact, .. } in fields {
        let source = surface.vertex_of_input(InputVertex::from_index(*source)).expect("a used vertex");
        let sources = [(Place::Vertex(source), 0.0)];
        let wavefront = finished(&surface, &sources, &[]);
        assert_eq!(surface.vertices_of_inputs().len(), exact.len());
        for (&vertex, &exact) in surface.vertices_of_inputs().iter().flatten().zip(exact) {
            let value = wavefront.values()[vertex];
            assert!((value - exact).abs() <= EXACT * exact, "{name}, vertex {vertex}: {value} for {exact}");
        }
        let mut random = Random::new(31);
        for _ in 0..200 {
            let vertex = VertexId::from_index(random.below(surface.vertex_count()));
            let path = wavefront.path_from_vertex(vertex).expect("a connected mesh");
            let value = wavefront.values()[vertex];
            check_path(&surface, &path, Place::Vertex(vertex), value, &sources);
        }
    }
}

#[test]
fn another_program_agrees_on_small_meshes() {
    exact_distances::kept().iter().for_each(check_known);
}

/// On meshes with cuts, edges of three faces, slivers and loose pieces.
fn check_messy(soup: &Soup) {
    let surface = Arc::new(surface(soup));
    let mut random = Random::new(41);
    let sources = [(Place::Vertex(VertexId::from_index(random.below(surface.vertex_count()))), 0.0)];
    let wavefront = finished(&surface, &sources, &[]);
    check_lipschitz(&wavefront, &surface, &sources);
    for _ in 0..100 {
        let vertex = VertexId::from_index(random.below(surface.vertex_count()));
        let value = wavefront.values()[vertex];
        if value.is_finite() {
            let path = wavefront.path_from_vertex(vertex).expect("a path");
            check_path(&surface, &path, Place::Vertex(vertex), value, &sources);
        }
    }
}

#[test]
fn messy_shapes() {
    let mut random = Random::new(5);
    for soup in [any_triangles(60, &mut random), band(40, 1), shapes::skull(0.08), shapes::maze(4, 2)] {
        check_messy(&soup);
    }
}

#[cfg(not(target_arch = "wasm32"))]
mod large_meshes {
    use super::exact_distances;

    #[test]
    #[ignore = "needs HEATWALK_MESHES"]
    fn another_program_agrees() {
        exact_distances::large().iter().for_each(super::check_known);
    }

    #[test]
    #[ignore = "needs HEATWALK_MESHES"]
    fn messy_meshes() {
        for name in [
            "bague.off",
            "cow.off",
            "dragon.glb",
            "hemisphere.glb",
            "high_genus.off",
            "horse.off",
            "maze.glb",
            "skull.glb",
            "sphere3.glb",
            "triceratops.off",
        ] {
            super::check_messy(&exact_distances::read_mesh(&exact_distances::folder("table1").join(name)));
        }
    }
}

#[test]
fn distances_on_a_book_of_many_pages_are_those_of_two_of_them_laid_flat() {
    let (pages, n) = (60, 3);
    let surface = Arc::new(surface(&book(pages, n)));
    // From the spine, along it, and by page.
    let place = |vertex: VertexId| {
        let position = surface.position(vertex);
        (position.truncate().length(), position.z, position.y.atan2(position.x))
    };
    let between = |a: VertexId, b: VertexId| {
        let [(from, low, page), (to, high, other)] = [a, b].map(place);
        let is_same = (page - other).abs() < 1e-6;
        if is_same { (from - to).hypot(low - high) } else { (from + to).hypot(low - high) }
    };
    let mut random = Random::new(29);
    let outer: Vec<VertexId> = surface.vertices().filter(|&vertex| place(vertex).0 > 0.3).collect();
    for nearer_by in [0.0, 1e-3, -1e-3, 0.02] {
        // From the first page to the last, each source is nearer to the spine by as much.
        let mut started: Vec<(VertexId, f64)> =
            (0..2 * pages as usize).map(|_| (outer[random.below(outer.len())], 0.0)).collect();
        started.sort_by(|a, b| place(a.0).2.total_cmp(&place(b.0).2));
        for (number, (_, start)) in started.iter_mut().enumerate() {
            *start = 5.0 - nearer_by * number as f64;
        }
        let sources: Vec<_> = started.iter().map(|&(vertex, start)| (Place::Vertex(vertex), start)).collect();
        let wavefront = finished(&surface, &sources, &[]);
        for vertex in surface.vertices() {
            let ways = started.iter().map(|&(source, start)| start + between(source, vertex));
            let expected = ways.fold(f64::INFINITY, f64::min);
            let value = wavefront.values()[vertex];
            assert!((value - expected).abs() <= EXACT * expected, "{vertex}: {value}, not {expected}");
        }
    }
}

#[test]
fn each_page_of_a_book_is_the_nearest_beyond_a_part_of_the_spine() {
    let pages = 64;
    let mut soup = book(pages, 1);
    // Every other page has its back in front.
    soup.triangles.chunks_exact_mut(4).for_each(|pair| pair[..2].iter_mut().for_each(|corners| corners.swap(1, 2)));
    let surface = Arc::new(surface(&soup));
    let distance_to_spine = |vertex: VertexId| surface.position(vertex).truncate().length();
    let is_at_spine =
        |face: &FaceId| surface.faces()[*face].iter().filter(|&&vertex| distance_to_spine(vertex) < 0.5).count() == 2;
    let at_spine: Vec<FaceId> = surface.faces().ids().filter(is_at_spine).collect();
    assert_eq!(at_spine.len(), pages as usize);
    // By page, so far from the spine and so high.
    let place = |page: usize, from: f64, high: f64| {
        let face = at_spine[page];
        let corners = surface.faces()[face].map(|vertex| (distance_to_spine(vertex), surface.position(vertex).z));
        let outer = corners.iter().find(|corner| corner.0 > 0.5).expect("an outer corner").1;
        let at_height =
            |height: f64| if height > 0.5 { high - from * outer } else { 1.0 - from - (high - from * outer) };
        let weights = corners.map(|(out, height)| if out > 0.5 { from } else { at_height(height) });
        Place::Face { face, weights }
    };
    let count = pages as usize;
    let height = |page: usize| 0.1 + 0.8 * (page as f64 + 0.5) / f64::from(pages);
    let start = |page: usize| 1e-3 * (7 * page % count) as f64 / f64::from(pages);
    let sources: Vec<_> = (0..count).map(|page| (place(page, 0.05, height(page)), start(page))).collect();
    let across = |page: usize| (page + count / 2) % count;
    let targets: Vec<Place> = (0..count).map(|page| place(across(page), 0.02, height(page))).collect();
    let wavefront = finished(&surface, &sources, &targets);
    for (page, &value) in wavefront.target_values().iter().enumerate() {
        let ways = (0..count).map(|other| {
            let apart = if other == across(page) { 0.05 - 0.02 } else { 0.05 + 0.02 };
            start(other) + (height(other) - height(page)).hypot(apart)
        });
        let expected = ways.fold(f64::INFINITY, f64::min);
        assert!((value - expected).abs() <= EXACT, "{page}: {value}, not {expected}");
    }
}
