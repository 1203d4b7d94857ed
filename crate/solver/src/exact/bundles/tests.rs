//! Distances by bundles on meshes whose windows are so few that they would cross alone, against those by windows that do.

#![cfg(not(target_arch = "wasm32"))]

use std::sync::Arc;

use super::super::samples::torn_terrain;
use super::*;
use heatwalk_shapes as shapes;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Place, Soup, VertexId};

/// Rounding, relative.
const ROUNDING: f64 = 1e-12;

/// From two vertices, one of which is farther, to all vertices and some points of faces, where so many windows become a bundle.
fn start(geometry: &Arc<ExactGeometry>, many: usize) -> Wavefront {
    let count = geometry.surface().vertex_count() as u32;
    let sources = [(Place::Vertex(VertexId(0)), 0.0), (Place::Vertex(VertexId(count / 3)), 0.2)];
    let faces = [17, 170, 1_700].map(|face| Place::Face { face: FaceId(face), weights: [0.2, 0.3, 0.5] });
    let mut wavefront = Wavefront::with_targets(Arc::clone(geometry), &sources, &faces).expect("sources and targets");
    wavefront.waiting.many = many;
    wavefront
}

/// Windows that wait in bundles.
fn bundled(wavefront: &Wavefront) -> usize {
    let (waiting, mut all) = (&wavefront.waiting, 0);
    wavefront.for_each_waiting(&mut |_, _| all += 1);
    all - wavefront.lit().map(|halfedge| waiting.at(halfedge).len()).sum::<usize>()
}

fn check(name: &str, soup: &Soup) {
    let geometry = Arc::new(ExactGeometry::new(Surface::build(soup).expect("a surface")));
    let mut alone = start(&geometry, usize::MAX);
    assert!(alone.advance(f64::INFINITY, usize::MAX).expect("memory"));
    let is_same = |found: f64, expected: f64| (found - expected).abs() <= ROUNDING * expected || found == expected;
    let mut together = start(&geometry, 6);
    for is_restarted in [false, true] {
        if is_restarted {
            // Left while bundles wait.
            together = start(&geometry, 6);
            assert!(!together.advance(f64::INFINITY, 20_000).expect("memory") && bundled(&together) > 0);
            together.restart(&alone.sources).expect("sources");
        }
        let mut most = 0;
        while !together.advance(f64::INFINITY, 2_000).expect("memory") {
            most = most.max(bundled(&together));
            let radius = together.radius();
            for (&found, &expected) in together.values().iter().zip(alone.values()) {
                assert!(found >= radius || is_same(found, expected), "{name}: {found} for {expected} before {radius}");
            }
        }
        assert!(most > 300, "{name}: {most} windows in bundles");
        for (&found, &expected) in together.values().iter().zip(alone.values()) {
            assert!(is_same(found, expected), "{name}: {found} for {expected}");
        }
        for (&found, &expected) in together.target_values().iter().zip(alone.target_values()) {
            assert!(is_same(found, expected), "{name}: {found} for {expected} at a target");
        }
    }
}

#[test]
fn distances_by_bundles_are_those_by_windows_alone() {
    check("a sphere", &shapes::icosphere(5));
    check("a torus", &shapes::torus(2.0, 0.7, 100, 50));
    check("a terrain", &torn_terrain(80, 997));
}
