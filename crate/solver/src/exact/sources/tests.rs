//! How the work of a search grows with the number of sources.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use heatwalk_shapes as shapes;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Place, Soup};

use super::*;

/// How often windows are looked at, to divide half-edges among them, until all is done, and how many windows there are.
fn work(soup: &Soup, places: &[Place]) -> [f64; 2] {
    let geometry = Arc::new(ExactGeometry::new(Surface::build(soup).expect("a surface")));
    let mut wavefront = Wavefront::new(geometry, places).expect("sources");
    assert!(wavefront.advance(f64::INFINITY, usize::MAX).expect("memory"));
    [wavefront.waiting.envelope().looked_at as f64, wavefront.windows() as f64]
}

#[test]
fn work_grows_with_the_sources_of_an_edge_as_their_number() {
    let face = FaceId(100);
    let on_edge = |share: f64| Place::Edge { halfedge: face.halfedge(0), fraction: share };
    let in_face = |share: f64| Place::Face { face, weights: [0.1 + 0.7 * share, 0.2, 0.7 - 0.7 * share] };
    let families: [(&str, &dyn Fn(f64) -> Place); 2] = [("an edge", &on_edge), ("a face", &in_face)];
    for soup in [shapes::icosphere(2), shapes::terrain(12)] {
        for (family, place) in families {
            let of_count = |count: usize| {
                // In no order.
                let share = |number: usize| ((number * 7 % count) as f64 + 0.5) / count as f64;
                work(&soup, &(0..count).map(|number| place(share(number))).collect::<Vec<_>>())
            };
            let [few, many] = [300, 4_800].map(of_count);
            let [looked_at, windows] = [0, 1].map(|k| (many[k] / few[k]).ln() / 16.0_f64.ln());
            assert!(looked_at < 1.2 && windows < 1.1, "{family}: n^{looked_at:.2}, of windows n^{windows:.2}");
        }
    }
}
