//! Lists that random windows were added to, against all of these windows at many places.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::super::samples::{Numbers, least};
use super::super::window::nearest;
use super::*;

/// Places of the half-edge that are looked at.
const SAMPLES: u32 = 256;
/// What a window that is not kept may be nearer by: a border is found to 1e-11 of the leads around it.
const BOUND: f64 = 1e-10;

/// Rounding of distances of about 2.
const EPSILON: f64 = 4.0 * f64::EPSILON;

/// Windows of one source each, as they leave a face: nearly in order, with gaps and overlaps.
fn leaving(numbers: &mut Numbers, first_root: u32) -> Vec<Beam> {
    let mut windows: Vec<Beam> = (0..6)
        .map(|number| {
            let Beam { x, depth, .. } = numbers.window(0.0);
            let begin = (f64::from(number) + numbers.next()) / 7.0;
            let end = begin + 0.3 * numbers.next();
            let offset = 1.5 - depth + 0.1 * numbers.next();
            Beam { begin, end: end.min(1.0), x, depth, offset, root: first_root + number }
        })
        .collect();
    if numbers.next() < 0.3 {
        windows.swap(2, 3);
    }
    windows
}

#[test]
fn a_list_keeps_the_nearest_window_of_each_place() {
    let mut numbers = Numbers::new(7);
    let mut kept = 0;
    for _ in 0..2_000 {
        let mut lists = Lists::new(2);
        let mut all = Vec::new();
        for batch in 0..3 {
            let mut windows = leaving(&mut numbers, 100 * batch);
            all.extend_from_slice(&windows);
            lists.add(1, &mut windows);
        }
        let list = lists.at(1);
        assert!(list.iter().all(Beam::is_wide));
        assert!(list.windows(2).all(|pair| pair[0].end <= pair[1].begin), "{list:#?}");
        for sample in 0..SAMPLES {
            let place = (f64::from(sample) + 0.5) / f64::from(SAMPLES);
            let (expected, found) = (least(&all, place), least(list, place));
            assert!(found == expected || (found - expected).abs() < BOUND, "{found} for {expected} at {place}");
        }
        let nearest = nearest(list).expect("windows");
        let ends = list.iter().flat_map(|window| [window.at(window.begin), window.at(window.end)]);
        let samples = (0..SAMPLES).map(|sample| least(list, f64::from(sample) / f64::from(SAMPLES)));
        let found = ends.chain(samples).fold(f64::INFINITY, f64::min);
        assert!((nearest - EPSILON..nearest + 1.0 / f64::from(SAMPLES)).contains(&found), "{nearest}, {found}");
        kept += list.len();
        let mut taken = Vec::new();
        lists.take(1, &mut taken);
        assert!(lists.at(1).is_empty() && !taken.is_empty());
    }
    assert!(kept > 2_000 * 6, "{kept}");
}

#[test]
fn windows_of_one_source_become_one_unless_its_distance_has_fallen() {
    let left = Beam { begin: 0.0, end: 0.5, x: 0.4, depth: 0.5, offset: 2.0, root: 3 };
    let right = left.part(0.5, 1.0);
    for windows in [[left, right], [right, left]] {
        let mut lists = Lists::new(1);
        for window in windows {
            lists.add(0, &mut vec![window]);
        }
        assert_eq!(lists.at(0).iter().map(|window| (window.begin, window.end)).collect::<Vec<_>>(), [(0.0, 1.0)]);
    }
    let fallen = Beam { offset: 1.9, ..right };
    let mut lists = Lists::new(1);
    for window in [left, fallen] {
        lists.add(0, &mut vec![window]);
    }
    assert_eq!(lists.at(0).iter().map(|window| window.offset).collect::<Vec<_>>(), [2.0, 1.9]);
}

#[test]
fn a_window_is_current_until_its_root_is_nearer_by_more_than_rounding() {
    let window = Beam { begin: 0.0, end: 0.5, x: 0.4, depth: 0.5, offset: 2.0, root: 3 };
    let is_current = |window: &Beam, at_root: f64| window.is_current(at_root, 1e-14);
    assert!(is_current(&window, 2.0) && is_current(&window, 2.0_f64.next_down()) && !is_current(&window, 2.0 - 1e-9));
    let from_source = Beam { offset: 0.0, ..window };
    assert!(is_current(&from_source, 0.0) && is_current(&from_source, -1e-15) && !is_current(&from_source, -1e-9));
}

#[test]
fn windows_that_share_a_ray_stay_as_they_are() {
    let left = Beam { begin: 0.0, end: 0.5, x: 0.4, depth: 0.5, offset: 2.0, root: 3 };
    // From a source on the ray through 0.5, or nearly so.
    for overlap in [-1e-10, 0.0, 1e-10] {
        let right = Beam {
            begin: 0.5 - overlap,
            end: 1.0,
            x: 0.45,
            depth: 0.25,
            offset: left.at(0.5) - 0.065_f64.sqrt(),
            root: 4,
        };
        let mut lists = Lists::new(1);
        lists.add(0, &mut vec![left, right]);
        assert_eq!(lists.at(0), [left, right]);
    }
    let far = Beam { begin: 0.5 - 1e-6, end: 1.0, offset: 2.5, root: 4, ..left };
    let mut lists = Lists::new(1);
    lists.add(0, &mut vec![left, far]);
    assert_eq!(lists.at(0), [left, far.part(0.5, 1.0)]);
}
