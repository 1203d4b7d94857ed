//! Distance from the boundary, against closed forms.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_volume::{TetMesh, TetSoup, boundary_distance, shapes};

use crate::common::mesh;

const ROUNDING: f64 = 1e-12;

fn depths(mesh: &TetMesh) -> impl Iterator<Item = (DVec3, f64)> + '_ {
    let depths = boundary_distance(mesh).expect("depths");
    (0..mesh.vertex_count()).zip(depths).map(|(vertex, depth)| (mesh.position(VertexId(vertex as u32)), depth))
}

#[test]
fn in_a_cube_it_is_that_from_the_nearest_side() {
    let mesh = mesh(&shapes::cube(6, 0.2));
    for (position, depth) in depths(&mesh) {
        let expected = 1.0 - position.abs().max_element();
        assert!((depth - expected).abs() < ROUNDING && (expected > ROUNDING || depth == 0.0), "{depth} at {position}");
    }
}

/// The least distance of the boundary's triangles from the origin, which spheres of vertices around it have no nearer ones than.
fn flatness(mesh: &TetMesh) -> f64 {
    let boundary = mesh.boundary().soup;
    let plane = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|corner| boundary.positions[corner as usize]);
        a.dot((b - a).cross(c - a).normalize()).abs() / a.length()
    };
    boundary.triangles.iter().map(plane).fold(1.0, f64::min)
}

#[test]
fn in_a_ball_and_a_cave_it_is_that_from_the_spheres() {
    for (soup, inner) in [(shapes::ball(6, 0.1), None), (shapes::cave(0.4, 4, 0.1), Some(0.4))] {
        let mesh = mesh(&soup);
        // Triangles are inside of the spheres that their corners are on, by so much of the radius at most.
        let sagitta = 1.0 - flatness(&mesh);
        assert!(sagitta < 0.05);
        for (position, depth) in depths(&mesh) {
            let radius = position.length();
            let outside = 1.0 - radius;
            let expected = inner.map_or(outside, |inner| outside.min(radius - inner));
            assert!((depth - expected).abs() <= sagitta + ROUNDING, "{depth} for {expected} at {position}");
        }
    }
}

#[test]
fn components_that_overlap_have_their_own_boundaries() {
    let cube = shapes::cube(4, 0.0);
    let count = cube.positions.len() as u32;
    let beside = cube.positions.iter().map(|&position| 0.5 * position + DVec3::new(0.1, 0.2, 0.3));
    let positions = cube.positions.iter().copied().chain(beside).collect();
    let shifted = cube.tetrahedra.iter().map(|corners| corners.map(|corner| corner + count));
    let tetrahedra = cube.tetrahedra.iter().copied().chain(shifted).collect();
    let mesh = mesh(&TetSoup { positions, tetrahedra });
    assert_eq!(mesh.report().components, 2);
    let middles = depths(&mesh).filter(|&(_, depth)| depth > 0.49).map(|(_, depth)| depth);
    let deepest: Vec<f64> = middles.filter(|depth| *depth > 0.9 || (depth - 0.5).abs() < ROUNDING).collect();
    // The middle of each, and the layer around that of the large one, which is as deep as the small one's middle.
    assert_eq!(deepest.iter().filter(|&&depth| depth > 0.9).count(), 1);
    assert_eq!(deepest.len(), 1 + 26 + 1);
}
