//! How the work of a search grows with the number of sources.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::TAU;

use glam::DVec3;
use heatwalk_shapes as shapes;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, FaceId, Place, Soup, ToSource};

use super::*;

/// How often windows are looked at, to divide half-edges among them, until all is done, and how many windows there are.
fn work<S: ToSource>(soup: &Soup, sources: &[S]) -> [f64; 2] {
    let geometry = Arc::new(ExactGeometry::new(Surface::build(soup).expect("a surface")));
    let mut wavefront = Wavefront::new(geometry, sources).expect("sources");
    assert!(wavefront.advance(f64::INFINITY, usize::MAX).expect("memory"));
    [wavefront.waiting.envelope().looked_at as f64, wavefront.windows() as f64]
}

/// Triangles on one edge.
fn book(pages: usize) -> Soup {
    let mut positions = vec![DVec3::ZERO, DVec3::Z];
    positions.extend((0..pages).map(|page| {
        let (y, x) = (TAU * page as f64 / pages as f64).sin_cos();
        DVec3::new(x, y, 0.5)
    }));
    Soup::single("book", positions, (0..pages as u32).map(|page| [0, 1, page + 2]).collect())
}

#[test]
fn work_grows_with_the_pages_of_a_book_that_have_a_source_each_as_their_number() {
    let of_pages = |pages: usize| {
        let start = |page: usize| 0.2 * (page * 7 % pages) as f64 / pages as f64;
        let sources = (0..pages).map(|page| {
            let face = FaceId::from_index(page);
            (Place::Face { face, weights: [0.4, 0.4, 0.2] }, start(page))
        });
        work(&book(pages), &sources.collect::<Vec<_>>())[0]
    };
    let [few, many] = [100, 800].map(of_pages);
    let looked_at = (many / few).ln() / 8.0_f64.ln();
    assert!(looked_at < 1.2, "n^{looked_at:.2}");
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
