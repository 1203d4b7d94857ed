//! Cuts through meshes, tetrahedra pulled apart, and surfaces of equal distance.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common;

use std::collections::HashMap;
use std::f64::consts::{PI, SQRT_2};
use std::sync::Arc;

use crate::common::mesh;
use glam::DVec3;
use heatwalk_volume::section::{Cut, Faces, Plane, Section, Shells};
use heatwalk_volume::{Error, TetMesh, TetPoint, VolumeDistance, VolumeOptions, VolumeSolver, shapes};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

/// Sums of a few thousand areas and volumes of size 1, computed in 53 bits.
const ROUNDING: f64 = 1e-11;

type Triangle = [DVec3; 3];

fn plane(normal: DVec3, offset: f64) -> Plane {
    Plane { normal, offset }
}

fn random_plane(random: &mut SplitMix64) -> Plane {
    loop {
        let direction = 2.0 * DVec3::from_array(random.random()) - 1.0;
        // The closed form for a cube divides by the normal's coordinates.
        if direction.abs().min_element() > 0.05 {
            return Plane::through(DVec3::from_array(random.random()) - 0.5, direction).unwrap();
        }
    }
}

fn triangles(positions: &[DVec3], triangles: &[[u32; 3]]) -> Vec<Triangle> {
    triangles.iter().map(|corners| corners.map(|corner| positions[corner as usize])).collect()
}

fn section_triangles(section: &Section) -> Vec<Triangle> {
    triangles(&section.positions, &section.triangles)
}

fn boundary(mesh: &TetMesh) -> Vec<Triangle> {
    let soup = mesh.boundary().soup;
    triangles(&soup.positions, &soup.triangles)
}

fn vector_area(triangles: &[Triangle]) -> DVec3 {
    triangles.iter().map(|[a, b, c]| (b - a).cross(c - a) / 2.0).sum()
}

fn area(triangles: &[Triangle]) -> f64 {
    triangles.iter().map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum()
}

/// By the divergence theorem.
fn volume(triangles: &[Triangle]) -> f64 {
    triangles.iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum()
}

/// What of triangles is before a plane, or beyond it.
fn clipped(triangles: &[Triangle], plane: &Plane, is_beyond: bool) -> Vec<Triangle> {
    let depth = |place: DVec3| if is_beyond { plane.beyond(place) } else { -plane.beyond(place) };
    let stays = |place: DVec3| if is_beyond { depth(place) > 0.0 } else { depth(place) >= 0.0 };
    let mut clipped = Vec::new();
    for triangle in triangles {
        let mut polygon = Vec::new();
        for k in 0..3 {
            let [a, b] = [triangle[k], triangle[(k + 1) % 3]];
            if stays(a) {
                polygon.push(a);
            }
            if stays(a) != stays(b) {
                polygon.push(a.lerp(b, depth(a) / (depth(a) - depth(b))));
            }
        }
        clipped.extend((2..polygon.len()).map(|k| [polygon[0], polygon[k - 1], polygon[k]]));
    }
    clipped
}

/// Volume of the cube of edge 2 before a plane, and the area that it has in the plane.
fn cube_before(Plane { normal, offset }: &Plane) -> [f64; 2] {
    let product = normal.x * normal.y * normal.z;
    let sum = |power: i32| -> f64 {
        let corners = (0..8).map(|index| DVec3::from_array([0, 1, 2].map(|bit| f64::from(2 * (index >> bit & 1) - 1))));
        corners.map(|corner| -corner.x * corner.y * corner.z * (offset - normal.dot(corner)).max(0.0).powi(power)).sum()
    };
    [sum(3) / (6.0 * product), sum(2) / (2.0 * product)]
}

/// Each edge has as many triangles on one side as on the other, except where `is_rim` allows both of its ends.
fn check_closed(triangles: &[Triangle], is_rim: impl Fn(DVec3) -> bool) {
    let mut edges: HashMap<[[u64; 3]; 2], i32> = HashMap::new();
    // Adding 0 makes a zero positive.
    let bits = |place: DVec3| place.to_array().map(|x| (x + 0.0).to_bits());
    for triangle in triangles {
        for k in 0..3 {
            let ends = [triangle[k], triangle[(k + 1) % 3]];
            if ends.iter().all(|&end| is_rim(end)) {
                continue;
            }
            let [a, b] = ends.map(bits);
            *edges.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    let open = edges.values().filter(|&&count| count != 0).count();
    assert_eq!(open, 0, "of {} edges", edges.len());
}

fn check_section(mesh: &TetMesh, section: &Section) {
    for (triangle, corners) in section.triangles.iter().zip(section_triangles(section)) {
        let [a, b, c] = corners;
        let normal = section.normals[triangle[0] as usize];
        assert!((normal.length() - 1.0).abs() < 1e-12);
        assert!((b - a).cross(c - a).dot(normal) >= -1e-15);
        assert!(
            triangle
                .iter()
                .all(|&corner| section.tetrahedra[corner as usize] == section.tetrahedra[triangle[0] as usize])
        );
    }
    for ((&position, &tetrahedron), &weights) in section.positions.iter().zip(&section.tetrahedra).zip(&section.weights)
    {
        let point = TetPoint::Inside { tetrahedron, weights }.checked(mesh).unwrap();
        assert!(point.position(mesh).distance(position) < 1e-12);
        assert!(weights.iter().all(|&weight| weight >= 0.0));
    }
}

#[test]
fn a_cap_has_the_area_of_the_cross_section_and_closes_what_stays() {
    let mut random = SplitMix64::seed_from_u64(3);
    let meshes = [mesh(&shapes::cube(5, 0.2)), mesh(&shapes::cube(8, 0.0))];
    for _ in 0..50 {
        let plane = random_plane(&mut random);
        let [expected_volume, expected_area] = cube_before(&plane);
        for mesh in &meshes {
            let section = Section::of_cut(mesh, &Cut::Plane(plane));
            check_section(mesh, &section);
            let cap = section_triangles(&section);
            assert!((area(&cap) - expected_area).abs() < ROUNDING, "{plane:?}: {} {expected_area}", area(&cap));
            assert!((vector_area(&cap) - expected_area * plane.normal).length() < ROUNDING);
            let closed = [cap, clipped(&boundary(mesh), &plane, false)].concat();
            assert!((volume(&closed) - expected_volume).abs() < ROUNDING, "{} {expected_volume}", volume(&closed));
            assert!(vector_area(&closed).length() < ROUNDING);
        }
    }
}

#[test]
fn planes_through_vertices_and_along_faces_count_once() {
    let mesh = mesh(&shapes::cube(4, 0.0));
    let third = 3_f64.sqrt().recip();
    let cases = [
        (plane(DVec3::Z, 0.0), 4.0, 4.0),
        (plane(-DVec3::Z, 0.0), 4.0, 4.0),
        (plane(DVec3::X, 0.5), 4.0, 6.0),
        (plane(DVec3::Y, 1.0), 0.0, 8.0),
        (plane(DVec3::new(1.0, 1.0, 0.0) / SQRT_2, 0.0), 4.0 * SQRT_2, 4.0),
        (plane(DVec3::new(1.0, 0.0, -1.0) / SQRT_2, 0.0), 4.0 * SQRT_2, 4.0),
        (plane(DVec3::splat(third), 0.0), 3.0 * 3_f64.sqrt(), 4.0),
        (plane(DVec3::new(-third, third, third), 0.0), 3.0 * 3_f64.sqrt(), 4.0),
    ];
    for (plane, expected_area, expected_volume) in cases {
        let cap = section_triangles(&Section::of_cut(&mesh, &Cut::Plane(plane)));
        assert!((area(&cap) - expected_area).abs() < ROUNDING, "{plane:?}: {}", area(&cap));
        assert!(cap.iter().all(|&triangle| area(&[triangle]) > 0.0));
        check_closed(&cap, |place| place.abs().max_element() > 1.0 - ROUNDING);
        let closed = [cap, clipped(&boundary(&mesh), &plane, false)].concat();
        assert!((volume(&closed) - expected_volume).abs() < ROUNDING, "{plane:?}: {}", volume(&closed));
    }
}

#[test]
fn caps_of_a_ball_are_discs() {
    let mesh = mesh(&shapes::ball(12, 0.2));
    for height in [-0.7, 0.0, 0.3, 0.9] {
        let section = Section::of_cut(&mesh, &Cut::Plane(plane(DVec3::Z, height)));
        let expected = PI * (1.0 - height * height);
        // The ball is a polyhedron whose edges, of up to 0.12, are L²/8 = 0.002 below the sphere.
        let missing = 1.0 - area(&section_triangles(&section)) / expected;
        assert!((0.0..0.03).contains(&missing), "{height}: {missing}");
        check_closed(&section_triangles(&section), |place| place.length() > 0.99);
    }
}

#[test]
fn caps_of_a_wedge_meet_at_its_edge() {
    let mut random = SplitMix64::seed_from_u64(4);
    let meshes = [mesh(&shapes::cube(5, 0.2)), mesh(&shapes::cube(4, 0.0))];
    let axes = [plane(DVec3::X, 0.0), plane(DVec3::Z, 0.5)];
    let random = std::iter::from_fn(|| Some([random_plane(&mut random), random_plane(&mut random)]));
    for planes in std::iter::once(axes).chain(random.take(40)) {
        for mesh in &meshes {
            let section = Section::of_cut(mesh, &Cut::Wedge(planes));
            check_section(mesh, &section);
            let caps = section_triangles(&section);
            let sticks_out = |place: &DVec3| planes.iter().any(|plane| plane.beyond(*place) < -1e-12);
            assert!(!section.positions.iter().any(sticks_out));
            check_closed(&caps, |place| place.abs().max_element() > 1.0 - ROUNDING);
            // What is taken away is bounded by the caps, seen from behind, and by what the boundary loses.
            let lost = clipped(&clipped(&boundary(mesh), &planes[0], true), &planes[1], true);
            assert!((vector_area(&lost) - vector_area(&caps)).length() < ROUNDING);
            let one_cap = clipped(&section_triangles(&Section::of_cut(mesh, &Cut::Plane(planes[0]))), &planes[1], true);
            let other_cap =
                clipped(&section_triangles(&Section::of_cut(mesh, &Cut::Plane(planes[1]))), &planes[0], true);
            let expected = area(&one_cap) + area(&other_cap);
            assert!((area(&caps) - expected).abs() < ROUNDING, "{planes:?}: {} {expected}", area(&caps));
        }
    }
    let caps = Section::of_cut(&meshes[1], &Cut::Wedge(axes));
    assert!((area(&section_triangles(&caps)) - 3.0).abs() < ROUNDING);
}

#[test]
fn nothing_cut_away_has_no_caps_and_all_tetrahedra() {
    let mesh = mesh(&shapes::ball(3, 0.2));
    assert!(Section::of_cut(&mesh, &Cut::Whole).triangles.is_empty());
    assert!(Section::of_cut(&mesh, &Cut::Plane(plane(DVec3::X, 2.0))).triangles.is_empty());
    assert!(Section::of_cut(&mesh, &Cut::Plane(plane(DVec3::X, -2.0))).triangles.is_empty());
    let all = Section::of(&mesh, &Cut::Whole, Faces::Tetrahedra);
    assert_eq!(all.triangles.len(), mesh.report().boundary_faces);
    assert!(Section::of_tetrahedra(&mesh, &Cut::Plane(plane(DVec3::X, -2.0))).positions.is_empty());
}

#[test]
fn tetrahedra_that_stay_are_whole() {
    let mesh = mesh(&shapes::cave(0.5, 3, 0.15));
    let planes = [plane(DVec3::X, 0.1), plane(DVec3::new(0.6, 0.0, 0.8), -0.2)];
    for cut in [Cut::Whole, Cut::Plane(planes[1]), Cut::Wedge(planes)] {
        let of_each = (0..mesh.tetrahedron_count() as u32).map(|tetrahedron| {
            let [a, b, c, d] = mesh.corners(heatwalk_volume::TetId(tetrahedron));
            if cut.removes((a + b + c + d) / 4.0) { 0.0 } else { (b - a).cross(c - a).dot(d - a) / 6.0 }
        });
        let of_each: Vec<f64> = of_each.collect();
        let expected: f64 = of_each.iter().sum();
        let section = Section::of_tetrahedra(&mesh, &cut);
        check_section(&mesh, &section);
        check_closed(&section_triangles(&section), |_| false);
        assert!((volume(&section_triangles(&section)) - expected).abs() < ROUNDING);
        let exploded = Section::exploded(&mesh, &cut, 0.5);
        assert_eq!(exploded.triangles.len(), 4 * of_each.iter().filter(|&&volume| volume > 0.0).count());
        for (faces, &own) in section_triangles(&exploded).chunks(4).zip(of_each.iter().filter(|&&volume| volume > 0.0))
        {
            check_closed(faces, |_| false);
            assert!((volume(faces) - own).abs() < 1e-12);
        }
    }
    check_section(&mesh, &Section::exploded(&mesh, &Cut::Whole, 0.0));
    let wide = Section::exploded(&mesh, &Cut::Whole, 1.0);
    let reach = wide.positions.iter().map(|position| position.length()).fold(0.0, f64::max);
    // Centroids are within an edge of the boundary.
    assert!((reach - 2.0).abs() < 0.2, "{reach}");
}

#[test]
fn sections_interpolate_values_and_know_gradients() {
    let mut solver = VolumeSolver::new(mesh(&shapes::cube(4, 0.2)));
    let mesh = Arc::clone(solver.mesh());
    let section = Section::of_cut(&mesh, &Cut::Plane(plane(DVec3::new(0.0, 0.6, 0.8), 0.123)));
    let linear = |place: DVec3| 3.0 + place.dot(DVec3::new(1.0, -2.0, 0.5));
    let values: Vec<f64> = mesh.positions().iter().map(|&place| linear(place)).collect();
    for (value, &position) in section.interpolate(&mesh, &values).unwrap().iter().zip(&section.positions) {
        assert!((value - linear(position)).abs() < 1e-12);
    }
    // A plane through vertices takes nothing from the infinities above.
    let flat = Section::of_cut(&mesh, &Cut::Plane(plane(DVec3::Y, 0.0)));
    let corner = |place: &DVec3| if place.y > 0.01 { f64::INFINITY } else { 1.0 };
    let infinite: Vec<f64> = mesh.positions().iter().map(corner).collect();
    let values = flat.interpolate(&mesh, &infinite).unwrap();
    for (value, weights) in values.iter().zip(flat.tetrahedra.iter().zip(&flat.weights)) {
        let corners = mesh.tetrahedra()[weights.0.index()].iter().zip(weights.1);
        let is_infinite =
            corners.into_iter().any(|(&corner, &weight)| weight > 0.0 && infinite[corner as usize].is_infinite());
        assert!(if is_infinite { value.is_infinite() } else { (value - 1.0).abs() < 1e-12 }, "{value}");
    }
    let distance = solver.distance(&[heatwalk::VertexId(0)], &VolumeOptions::default()).unwrap();
    let expected = distance.gradient(&mesh).unwrap();
    for (gradient, tetrahedron) in section.gradients(&mesh, &distance).unwrap().iter().zip(&section.tetrahedra) {
        assert_eq!(*gradient, expected[tetrahedron.index()]);
    }
    assert!(matches!(section.interpolate(&mesh, &[1.0]), Err(Error::ValueCount { values: 1, .. })));
    let other = common::mesh(&shapes::cube(4, 0.2));
    assert_eq!(section.interpolate(&other, &infinite).unwrap_err(), Error::ForeignMesh { what: "section" });
    assert_eq!(section.gradients(&other, &distance).unwrap_err(), Error::ForeignMesh { what: "section" });
}

/// A cube of edge 2 with the distance from its middle.
fn from_middle(cells: usize, jitter: f64) -> (Arc<TetMesh>, VolumeDistance) {
    let mut solver = VolumeSolver::new(mesh(&shapes::cube(cells, jitter)));
    let mesh = Arc::clone(solver.mesh());
    let middle = mesh.locate(DVec3::ZERO).unwrap();
    let distance = solver.distance(&[middle], &VolumeOptions::default()).unwrap();
    (mesh, distance)
}

fn shell_triangles(shells: &Shells) -> Vec<Triangle> {
    triangles(&shells.positions, &shells.triangles)
}

#[test]
fn shells_around_a_source_are_spheres() {
    for (cells, jitter) in [(16, 0.2), (16, 0.0)] {
        let (mesh, distance) = from_middle(cells, jitter);
        // Vertices of the mesh without jitter are at just 0.5.
        for radius in [0.5, 0.7, 0.913] {
            let shells = Shells::of(&mesh, &distance, &[radius], &Cut::Whole).unwrap();
            let sphere = shell_triangles(&shells);
            check_closed(&sphere, |_| false);
            // Interpolated along edges of up to √3 · 1.4 cells, distance is up to L²/(8 r) too large, area twice that share.
            let edge = 3_f64.sqrt() * (1.0 + 2.0 * jitter) * 2.0 / cells as f64;
            let share = 2.0 * edge * edge / (8.0 * radius * radius);
            let missing = 1.0 - area(&sphere) / (4.0 * PI * radius * radius);
            assert!((0.0..share).contains(&missing), "{radius}: {missing}, at most {share}");
            assert!(volume(&sphere) > 0.0);
            for ((position, normal), &value) in shells.positions.iter().zip(&shells.normals).zip(&shells.values) {
                assert_eq!(value, radius);
                assert!((normal.length() - 1.0).abs() < 1e-12);
                assert!(normal.dot(position.normalize()) > 0.9);
                let there = distance.at(&mesh, mesh.locate(*position).unwrap()).unwrap();
                assert!((there - radius).abs() < 1e-9, "{there}");
            }
        }
    }
}

#[test]
fn shells_have_every_level_in_one_answer() {
    let (mesh, distance) = from_middle(8, 0.2);
    let levels = [0.9, 0.3, 0.6, 5.0, 0.3];
    let all = Shells::of(&mesh, &distance, &levels, &Cut::Whole).unwrap();
    let count = |levels: &[f64]| Shells::of(&mesh, &distance, levels, &Cut::Whole).unwrap().triangles.len();
    assert_eq!(all.triangles.len(), count(&[0.3]) + count(&[0.6]) + count(&[0.9]));
    assert_eq!(count(&[5.0]), 0);
    let of_one =
        |triangle: &[u32; 3]| triangle.iter().all(|&k| all.values[k as usize] == all.values[triangle[0] as usize]);
    assert!(all.triangles.iter().all(of_one));
    let refused = Shells::of(&mesh, &distance, &[f64::NAN], &Cut::Whole).unwrap_err();
    assert_eq!(refused.code(), "bad-level");
    let other = common::mesh(&shapes::cube(2, 0.0));
    assert!(matches!(Shells::of(&other, &distance, &[0.5], &Cut::Whole), Err(Error::ForeignMesh { .. })));
}

#[test]
fn shells_are_clipped_at_the_planes_of_a_cut() {
    let (mesh, distance) = from_middle(10, 0.2);
    let whole = shell_triangles(&Shells::of(&mesh, &distance, &[0.8], &Cut::Whole).unwrap());
    let mut random = SplitMix64::seed_from_u64(8);
    for _ in 0..30 {
        let planes = [random_plane(&mut random), random_plane(&mut random)];
        let cut = Cut::Plane(planes[0]);
        let shells = Shells::of(&mesh, &distance, &[0.8], &cut).unwrap();
        assert!(shells.positions.iter().all(|&place| planes[0].beyond(place) < 1e-12));
        let expected = clipped(&whole, &planes[0], false);
        assert!((vector_area(&shell_triangles(&shells)) - vector_area(&expected)).length() < ROUNDING);
        let rest = Shells::in_cut(&mesh, &distance, &[0.8], &cut).unwrap();
        assert!(rest.positions.iter().all(|&place| planes[0].beyond(place) > -1e-12));
        let areas = [&shells, &rest].map(|part| area(&shell_triangles(part)));
        assert!((areas[0] + areas[1] - area(&whole)).abs() < ROUNDING);
        check_closed(&shell_triangles(&shells), |place| planes[0].beyond(place) > -1e-12);

        let shells = Shells::of(&mesh, &distance, &[0.8], &Cut::Wedge(planes)).unwrap();
        let inside = |place: &DVec3| planes.iter().all(|plane| plane.beyond(*place) > 1e-12);
        assert!(!shells.positions.iter().any(inside));
        let removed = area(&clipped(&clipped(&whole, &planes[0], true), &planes[1], true));
        assert!((area(&shell_triangles(&shells)) - (area(&whole) - removed)).abs() < ROUNDING);
        let rest = Shells::in_cut(&mesh, &distance, &[0.8], &Cut::Wedge(planes)).unwrap();
        assert!((area(&shell_triangles(&rest)) - removed).abs() < ROUNDING);
        let is_rim = |place: DVec3| planes.iter().any(|plane| plane.beyond(place).abs() < 1e-12);
        check_closed(&shell_triangles(&shells), is_rim);
        assert!(shells.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-12));
    }
}

#[test]
fn shells_leave_out_what_no_source_reaches() {
    let mut solver = VolumeSolver::new(mesh(&shapes::cube(6, 0.0)));
    let mesh = Arc::clone(solver.mesh());
    let options = VolumeOptions { max_distance: 0.7, ..VolumeOptions::default() };
    let distance = solver.distance(&[mesh.locate(DVec3::ZERO).unwrap()], &options).unwrap();
    let shells = Shells::of(&mesh, &distance, &[0.3, 0.69], &Cut::Whole).unwrap();
    assert!(!shells.triangles.is_empty());
    assert!(shells.positions.iter().all(|position| position.is_finite()));
}
