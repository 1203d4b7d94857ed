//! Paths inside of meshes.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::{around_sphere, mesh};
use glam::DVec3;
use heatwalk_volume::{Error, TetId, TetMesh, TetPoint, VolumeMethod, VolumeOptions, VolumeSolver, shapes};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

fn place(mesh: &TetMesh, random: &mut SplitMix64) -> TetPoint {
    if random.random::<f64>() < 0.5 {
        return TetPoint::Vertex(heatwalk::VertexId(random.random_range(0..mesh.vertex_count()) as u32));
    }
    let shares: [f64; 4] = random.random();
    let sum: f64 = shares.iter().sum();
    let tetrahedron = TetId(random.random_range(0..mesh.tetrahedron_count()) as u32);
    TetPoint::Inside { tetrahedron, weights: shares.map(|share| share / sum) }
}

/// Between random places, by a method: paths arrive, are never shorter than a straight line, stay inside, and are longer than the
/// march's distance by no more than these shares, from vertices and from places inside of tetrahedra.
fn check(method: VolumeMethod, [at_vertex, inside]: [f64; 2]) {
    for soup in [
        shapes::ball(4, 0.2),
        shapes::pierced_cube(0.4, 3, 0.15),
        shapes::cave(0.5, 3, 0.15),
        shapes::bent_tube(0.35, 4.5, 4, 0.1),
    ] {
        let mut solver = VolumeSolver::new(mesh(&soup));
        let mesh = Arc::clone(solver.mesh());
        let mut random = SplitMix64::seed_from_u64(11);
        for _ in 0..20 {
            let to = place(&mesh, &mut random);
            let distance = solver.distance(&[to], &VolumeOptions::by(method)).unwrap();
            let marched = solver.distance(&[to], &VolumeOptions::default()).unwrap();
            for _ in 0..5 {
                let from = place(&mesh, &mut random);
                let path = solver.path(&distance, from).unwrap();
                let [first, last] = [path.points[0], path.points[path.points.len() - 1]];
                assert!(first.distance(from.position(&mesh)) < 1e-12);
                assert!(last.distance(to.position(&mesh)) < 1e-12, "{from:?} to {to:?} ends at {last}");
                let straight = first.distance(last);
                assert!(path.length >= straight * (1.0 - 1e-12), "{} {straight}", path.length);
                let expected = marched.at(&mesh, from).unwrap();
                // Inside of a tetrahedron distance is interpolated, too short where it comes around an obstacle from both sides.
                let share = if matches!(from, TetPoint::Vertex(_)) { at_vertex } else { inside };
                let most = expected.max(straight) * (1.0 + share) + 1e-9;
                assert!(path.length <= most, "{from:?} to {to:?}: {} {expected}", path.length);
                for ends in path.points.windows(2) {
                    for share in [0.25, 0.5, 0.75] {
                        let between = ends[0].lerp(ends[1], share);
                        assert!(mesh.locate(between).is_some(), "{from:?} to {to:?} leaves at {between}");
                    }
                }
            }
        }
    }
}

#[test]
fn marched_paths_arrive_inside_and_are_as_short_as_the_distance() {
    check(VolumeMethod::March, [0.1, 0.15]);
}

#[test]
fn paths_down_heat_are_pulled_taut() {
    // Heat may choose the other way around an obstacle.
    check(VolumeMethod::Heat, [0.35, 0.35]);
}

/// Without corners that slide along edges the mean is 1.43 %.
#[test]
fn paths_around_a_sphere_are_little_longer_than_exact() {
    let mut solver = VolumeSolver::new(mesh(&shapes::cave(0.5, 5, 0.15)));
    let mesh = Arc::clone(solver.mesh());
    let mut random = SplitMix64::seed_from_u64(5);
    let mut vertex = || heatwalk::VertexId(random.random_range(0..mesh.vertex_count()) as u32);
    let mut excesses = Vec::new();
    for _ in 0..10 {
        let to = vertex();
        let distance = solver.distance(&[to], &VolumeOptions::default()).unwrap();
        for from in [0; 20].map(|_| vertex()) {
            let exact = around_sphere(0.5)(mesh.position(to), mesh.position(from));
            let path = solver.path(&distance, TetPoint::Vertex(from)).unwrap();
            if exact > 0.0 {
                excesses.push(path.length / exact - 1.0);
            }
        }
    }
    let mean = excesses.iter().sum::<f64>() / excesses.len() as f64;
    assert!(mean < 0.013, "{mean}");
}

#[test]
fn a_path_in_a_convex_body_is_one_straight_line() {
    let mut solver = VolumeSolver::new(mesh(&shapes::cube(5, 0.2)));
    for method in [VolumeMethod::March, VolumeMethod::Heat] {
        let distance = solver.distance(&[heatwalk::VertexId(0)], &VolumeOptions::by(method)).unwrap();
        let path = solver.path(&distance, TetPoint::Vertex(heatwalk::VertexId(100))).unwrap();
        assert_eq!(path.points.len(), 2, "{method}");
        let own = solver.path(&distance, TetPoint::Vertex(heatwalk::VertexId(0))).unwrap();
        assert_eq!((own.points.len(), own.length), (1, 0.0), "{method}");
    }
}

#[test]
fn a_path_between_costs_refracts_and_tells_its_cost() {
    let mesh = Arc::new(mesh(&shapes::cube(10, 0.0)));
    let middle = |tetrahedron: usize| mesh.corners(TetId(tetrahedron as u32)).iter().sum::<DVec3>().z / 4.0;
    let cost = |tetrahedron| if middle(tetrahedron) > 0.0 { 4.0 } else { 1.0 };
    let costs: Vec<f64> = (0..mesh.tetrahedron_count()).map(cost).collect();
    let mut solver = VolumeSolver::with_costs(Arc::clone(&mesh), &costs).unwrap();
    let [from, to] = [DVec3::new(-0.6, -0.6, 0.8), DVec3::new(0.6, 0.6, -0.8)].map(|place| mesh.locate(place).unwrap());
    let distance = solver.distance(&[to], &VolumeOptions::default()).unwrap();
    let path = solver.path(&distance, from).unwrap();
    let straight = from.position(&mesh).distance(to.position(&mesh));
    assert!(path.length > straight && path.cost < 2.5 * straight, "{path:?}");
    let expected = distance.at(&mesh, from).unwrap();
    assert!((path.cost - expected).abs() < 0.1 * expected, "{} {expected}", path.cost);
}

#[test]
fn rejects_what_cannot_be_reached_and_what_is_of_another_mesh() {
    let mut solver = VolumeSolver::new(mesh(&shapes::cube(2, 0.0)));
    let options = VolumeOptions { max_distance: 0.1, ..VolumeOptions::default() };
    let near = solver.distance(&[heatwalk::VertexId(0)], &options).unwrap();
    let far = TetPoint::Vertex(heatwalk::VertexId(26));
    assert_eq!(solver.path(&near, far).unwrap_err(), Error::Unreachable);
    let other = VolumeSolver::new(mesh(&shapes::cube(2, 0.0)));
    assert_eq!(other.path(&near, far).unwrap_err(), Error::ForeignMesh { what: "distance" });
}
