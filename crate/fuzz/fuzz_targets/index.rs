//! Indices of distances: any bytes, and those of small surfaces of any kind, sound and with a byte changed.
#![no_main]

use std::num::NonZeroUsize;
use std::sync::Arc;

use arbitrary::Arbitrary;
use heatwalk::{DistanceOptions, DistanceSolver, Method, Surface, go_on};
use heatwalk_fuzz::budget::within_budget;
use heatwalk_fuzz::distances::ROUNDING;
use heatwalk_fuzz::soups::AnySoup;
use heatwalk_index::DistanceIndex;

#[derive(Arbitrary, Debug)]
enum Input<'a> {
    Bytes(&'a [u8]),
    Index { soup: AnySoup, from: u8, changed: (u16, u8) },
}

libfuzzer_sys::fuzz_target!(|input: Input| match input {
    Input::Bytes(bytes) => {
        let _ = within_budget(bytes.len(), || DistanceIndex::from_bytes(bytes));
    }
    Input::Index { soup, from, changed } => {
        let Ok(surface) = Surface::build(&soup.0) else { return };
        let surface = Arc::new(surface);
        let Ok(index) = DistanceIndex::build(&surface, NonZeroUsize::MIN, &mut go_on) else { return };
        let mut bytes = Vec::new();
        index.write(&mut bytes).expect("room in memory");
        let read = DistanceIndex::from_bytes(&bytes).expect("what was written can be read");
        assert_eq!(read, index);
        let inputs = read.vertex_count();
        let from = usize::from(from) % inputs;
        if let Some(source) = surface.vertex_of_input(heatwalk::InputVertex(from as u32)) {
            let mut solver = DistanceSolver::new(Arc::clone(&surface));
            let exact = solver.distance(&[source], &DistanceOptions::by(Method::Exact), &mut go_on);
            let exact = solver.of_inputs(&exact.expect("a vertex of the surface"));
            let largest = exact.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
            for (to, exact) in exact.into_iter().enumerate() {
                let bounds = read.distance(from, to).expect("vertices of the input");
                assert!(bounds.lower <= bounds.upper, "{bounds:?}");
                let is_right = if exact.is_infinite() {
                    bounds.lower.is_infinite()
                } else {
                    bounds.lower <= exact + ROUNDING * largest && bounds.upper >= exact - ROUNDING * largest
                };
                assert!(is_right, "{bounds:?} for {exact}");
            }
        }
        let (at, by) = changed;
        let at = usize::from(at) % bytes.len();
        bytes[at] = bytes[at].wrapping_add(by);
        if by != 0 {
            DistanceIndex::from_bytes(&bytes).expect_err("a changed byte is found out");
        }
    }
});
