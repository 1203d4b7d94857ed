//! Random windows merged, against all of them at many places.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::super::samples::{Numbers, least};
use super::super::window::{SLIVER, THIN};
use super::*;

/// Places of the half-edge that are looked at.
const SAMPLES: u32 = 256;
/// What a window that is not kept may be nearer by: a border is found to 1e-11 of the leads around it.
const BOUND: f64 = 1e-10;

/// Windows of the middle of a half-edge and more of it, each of which is the nearest somewhere or nearly so.
fn windows(numbers: &mut Numbers, count: usize) -> Vec<Beam> {
    (0..count)
        .map(|number| {
            let window = numbers.window(0.0);
            let offset = 2.0 - window.depth + 0.05 * numbers.next();
            Beam { offset, root: number as u32, ..window }
        })
        .collect()
}

#[test]
fn each_place_is_kept_by_the_nearest_of_all_windows() {
    let mut numbers = Numbers::new(5);
    for (sliver, count) in [(THIN, 1), (THIN, 2), (SLIVER, 7), (THIN, 40), (SLIVER, 300)].repeat(40) {
        let all = windows(&mut numbers, count);
        let mut merged = all.clone();
        assert!(Merge::default().merge(&mut merged, sliver));
        assert!(merged.len() <= 3 * count, "{} of {count}", merged.len());
        assert!(merged.iter().all(Beam::is_wide));
        assert!(merged.windows(2).all(|pair| pair[0].begin <= pair[1].begin && !pair[0].overlaps(&pair[1], sliver)));
        for sample in 0..SAMPLES {
            let place = (f64::from(sample) + 0.5) / f64::from(SAMPLES);
            let (expected, found) = (least(&all, place), least(&merged, place));
            assert!(found == expected || (found - expected).abs() < BOUND, "{found} for {expected} at {place}");
        }
    }
}

#[test]
fn windows_of_many_sources_are_merged_in_n_log_n() {
    for count in [100, 1_000, 10_000] {
        // Of a row of sources, each is the nearest of a part of the half-edge.
        let of_source = |number: usize| {
            let x = (number * 7 % count) as f64 / count as f64;
            Beam { begin: 0.0, end: 1.0, x, depth: 0.1, offset: 0.0, root: number as u32 }
        };
        let mut list: Vec<Beam> = (0..count).map(of_source).collect();
        let mut merge = Merge::default();
        assert!(merge.merge(&mut list, THIN));
        assert_eq!(list.len(), count);
        let bound = count * (count.ilog2() as usize + 1);
        assert!(merge.looked_at <= bound, "{} windows looked at for {count}", merge.looked_at);
    }
}

#[test]
fn nothing_and_a_window_alone_stay_as_they_are() {
    let mut list = Vec::new();
    assert!(Merge::default().merge(&mut list, THIN) && list.is_empty());
    let window = Numbers::new(3).window(0.0);
    list.push(window);
    assert!(Merge::default().merge(&mut list, THIN));
    assert_eq!(list, [window]);
}
