//! Lists that random windows were added to, against all of these windows at many places.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::super::samples::Numbers;
use super::*;

/// Places of the half-edge that are looked at.
const SAMPLES: u32 = 256;
/// What a window that is not kept may be nearer by: a border is found to 1e-11 of the leads around it.
const BOUND: f64 = 1e-10;

fn least(windows: &[Window], place: f64) -> f64 {
    let covers = |window: &&Window| window.begin <= place && place <= window.end;
    windows.iter().filter(covers).map(|window| window.at(place)).fold(f64::INFINITY, f64::min)
}

/// Windows of one source each, as they leave a face: nearly in order, with gaps and overlaps.
fn leaving(numbers: &mut Numbers, first_root: u32) -> Vec<Window> {
    let mut windows: Vec<Window> = (0..6)
        .map(|number| {
            let Window { x, depth, .. } = numbers.window(0.0);
            let begin = (f64::from(number) + numbers.next()) / 7.0;
            let end = begin + 0.3 * numbers.next();
            Window::new(begin, end.min(1.0), [x, depth], 1.5 - depth + 0.1 * numbers.next(), first_root + number)
        })
        .collect();
    if numbers.next() < 0.3 {
        windows.swap(2, 3);
    }
    windows
}

#[test]
fn a_list_keeps_the_nearest_window_of_each_place() {
    let mut numbers = Numbers(7);
    let mut kept = 0;
    for _ in 0..2_000 {
        let mut lists = Lists::new(2);
        let mut all = Vec::new();
        for batch in 0..3 {
            let windows = leaving(&mut numbers, 100 * batch);
            lists.add(1, &windows);
            all.extend(windows);
        }
        let list = lists.at(1);
        assert!(list.iter().all(Window::is_wide));
        assert!(list.windows(2).all(|pair| pair[0].end <= pair[1].begin), "{list:#?}");
        for sample in 0..SAMPLES {
            let place = (f64::from(sample) + 0.5) / f64::from(SAMPLES);
            let (expected, found) = (least(&all, place), least(list, place));
            assert!(found == expected || (found - expected).abs() < BOUND, "{found} for {expected} at {place}");
        }
        for window in list {
            assert!((window.at(window.begin) - window.at_begin).abs() < BOUND, "{window:?}");
            assert!((window.at(window.end) - window.at_end).abs() < BOUND, "{window:?}");
        }
        kept += list.len();
        let mut taken = Vec::new();
        lists.take(1, &mut taken);
        assert!(lists.at(1).is_empty() && !taken.is_empty());
    }
    assert!(kept > 2_000 * 6, "{kept}");
}

#[test]
fn windows_of_one_source_become_one_unless_its_distance_has_fallen() {
    let source = [0.4, 0.5];
    let [left, right] = [(0.0, 0.5), (0.5, 1.0)].map(|(begin, end)| Window::new(begin, end, source, 2.0, 3));
    for windows in [[left, right], [right, left]] {
        let mut lists = Lists::new(1);
        lists.add(0, &windows[..1]);
        lists.add(0, &windows[1..]);
        assert_eq!(lists.at(0).iter().map(|window| (window.begin, window.end)).collect::<Vec<_>>(), [(0.0, 1.0)]);
    }
    let fallen = Window::new(0.5, 1.0, source, 1.9, 3);
    let mut lists = Lists::new(1);
    lists.add(0, &[left]);
    lists.add(0, &[fallen]);
    assert_eq!(lists.at(0).iter().map(|window| window.offset).collect::<Vec<_>>(), [2.0, 1.9]);
}
