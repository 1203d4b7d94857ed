//! Distances are a metric: the same both ways, and never shorter by way of a third place. Exact ones are so up to rounding,
//! propagated ones up to what a few windows of each half-edge miss.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod common;

use std::num::NonZeroU16;
use std::sync::Arc;

use common::{Damage, band, book, damaged, random, square, surface};
use heatwalk::exact::ExactGeometry;
use heatwalk::{Element, ExactSearch, Place, Propagation, PropagationOptions, Soup, Surface, VertexId, Windows};
use heatwalk_shapes as shapes;

/// Places of each surface.
const PLACES: usize = 8;

/// Shapes with and without boundary, torn, and squeezed to slivers, from whose jittered vertices saddles come.
fn surfaces() -> Vec<Surface> {
    let shapes: [fn() -> Soup; 6] = [
        || shapes::icosphere(3),
        || shapes::torus(2.0, 0.7, 36, 18),
        || shapes::high_genus(0.2),
        || square(18),
        || band(60, 1),
        || book(3, 10),
    ];
    let damages = [(0.0, 1.0, 0.0), (0.1, 1.0, 0.0), (0.1, 0.1, 0.1), (0.1, 1e-2, 0.0), (0.3, 1e-2, 0.1)];
    let each = shapes.iter().flat_map(|shape| damages.iter().map(move |damage| (shape(), *damage)));
    let soups = each
        .zip(0..)
        .map(|((soup, (jitter, squeeze, tear)), seed)| damaged(soup, seed, Damage { jitter, squeeze, tear }));
    soups.map(|soup| surface(&soup)).collect()
}

/// Distances between some places: `PLACES × PLACES`.
fn distances(geometry: &Arc<ExactGeometry>, places: &[VertexId], windows: Windows) -> Vec<Vec<f64>> {
    // Without an exact search, which would find all of these surfaces exactly.
    let options = PropagationOptions { windows, exact: ExactSearch::AtMost(0) };
    let from = |&place: &VertexId| {
        let mut propagation =
            Propagation::new(Arc::clone(geometry), &[Place::Vertex(place)], options).expect("a valid source");
        assert!(propagation.advance(f64::INFINITY, usize::MAX));
        places.iter().map(|&to| propagation.values()[to]).collect()
    };
    places.iter().map(from).collect()
}

#[test]
fn measure() {
    for windows in [Some(1), Some(2), Some(4), Some(8), None] {
        let (mut asym, mut tri) = ([0.0_f64; 2], [0.0_f64; 2]);
        let mut na = 0.0;
        for (n, surface) in surfaces().into_iter().enumerate() {
            let surface = Arc::new(surface);
            let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
            let mut seed = 77 + n as u64;
            let places: Vec<VertexId> =
                (0..PLACES).map(|_| VertexId::from_index(random(&mut seed, surface.vertex_count()))).collect();
            let windows = windows.map_or(Windows::All, |w| Windows::AtMost(NonZeroU16::new(w).unwrap()));
            let d = distances(&geometry, &places, windows);
            let (mut a0, mut t0) = (0.0_f64, 0.0_f64);
            for a in 0..PLACES {
                for b in 0..PLACES {
                    if d[a][b].is_finite() && a != b && d[a][b] > 0.0 {
                        let r = (d[a][b] - d[b][a]).abs() / d[a][b];
                        a0 = a0.max(r);
                        asym[1] += r;
                        na += 1.0;
                    }
                    for c in 0..PLACES {
                        let two = d[a][b] + d[b][c];
                        if two.is_finite() && two > 0.0 {
                            t0 = t0.max(d[a][c] / two - 1.0);
                        }
                    }
                }
            }
            println!("{windows:?} {n} V {} asym {a0:.3e} tri {t0:.3e}", surface.vertex_count());
            asym[0] = asym[0].max(a0);
            tri[0] = tri[0].max(t0);
        }
        println!("== {windows:?} asym {asym:?} mean {} tri {tri:?}", asym[1] / na);
    }
}
