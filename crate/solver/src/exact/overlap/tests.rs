//! Shares of random pairs of windows, against both distances at many places.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::super::samples::Numbers;
use super::*;

/// Places of an interval that are looked at.
const SAMPLES: u32 = 64;
/// What the loser may be nearer by: a zero is found to 1e-11 of the leads around it.
const BOUND: f64 = 1e-10;

impl Numbers {
    /// Two windows with a lead of some thousandths at a random place of their overlap, so that it may change twice.
    fn overlap(&mut self) -> [Beam; 2] {
        let first = self.window(0.5);
        let second = self.window(0.0);
        let (begin, end) = (first.begin.max(second.begin), first.end.min(second.end));
        let place = begin + (end - begin) * self.next();
        let offset = first.at(place) - second.at(place) + 4e-3 * (self.next() - 0.5);
        [first, Beam { offset, root: 1, ..second }]
    }
}

#[test]
fn each_place_is_kept_by_the_nearer_window() {
    let mut numbers = Numbers::new(1);
    let mut changes = [0; 3];
    for _ in 0..20_000 {
        let [first, second] = numbers.overlap();
        let shares = Overlap::new(&first, &second).shares();
        let shares = shares.as_slice();
        assert_eq!(shares[0].1, first.begin.min(second.begin));
        assert_eq!(shares[shares.len() - 1].2, first.end.max(second.end));
        assert!(shares.windows(2).all(|pair| pair[0].2 == pair[1].1 && pair[0].0 != pair[1].0), "{shares:?}");
        let covers = |window: &Beam, place: f64| window.begin <= place && place <= window.end;
        for &(is_first, begin, end) in shares {
            let (keeper, other) = if is_first { (&first, &second) } else { (&second, &first) };
            for sample in 0..SAMPLES {
                let place = begin + (end - begin) * (f64::from(sample) + 0.5) / f64::from(SAMPLES);
                assert!(covers(keeper, place));
                if covers(other, place) {
                    let lead = keeper.at(place) - other.at(place);
                    assert!(lead < BOUND, "{lead} at {place} of {first:?} and {second:?}");
                }
            }
        }
        let is_within = |place: f64| covers(&first, place) && covers(&second, place);
        let inside = shares[1..].iter().filter(|share| is_within(share.1) && share.1 > first.begin.max(second.begin));
        changes[inside.filter(|share| share.1 < first.end.min(second.end)).count()] += 1;
    }
    // One never wins, they meet once, or they meet twice.
    assert!(changes.iter().all(|&count| count > 500), "{changes:?}");
}

#[test]
fn windows_that_touch_keep_what_they_have() {
    let first = Beam { begin: 0.0, end: 0.5, x: 0.2, depth: 1.0, offset: 0.0, root: 0 };
    let second = Beam { begin: 0.5, end: 1.0, x: 0.8, root: 1, ..first };
    assert_eq!(Overlap::new(&first, &second).shares().as_slice(), [(true, 0.0, 0.5), (false, 0.5, 1.0)]);
    assert_eq!(Overlap::new(&second, &first).shares().as_slice(), [(false, 0.0, 0.5), (true, 0.5, 1.0)]);
}
