//! Lists of windows and bundles.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::super::samples::{Numbers, fan};
use super::*;

fn all(list: &List) -> Vec<Beam> {
    let mut all = Vec::new();
    for_each(&list.windows, &list.bundles, |window| all.push(window));
    all
}

/// A list of windows one after the other, some of them in bundles of random sizes.
fn list(numbers: &mut Numbers) -> List {
    let mut list = List::default();
    let mut windows = fan(numbers, 60).into_iter();
    while windows.len() > 0 {
        if numbers.next() < 0.5 {
            list.push(windows.next().expect("a window"));
        } else {
            let count = 1 + (12.0 * numbers.next()) as usize;
            let some: Vec<Beam> = windows.by_ref().take(count).collect();
            list.push_bundle(Bundle::new(some, 1.0));
        }
    }
    list.close();
    list
}

/// Bundles lie between windows, each behind another one.
fn assert_in_order(list: &List) {
    let last = list.windows.len().saturating_sub(1);
    assert!(list.bundles.iter().all(|(after, bundle)| (*after as usize) < last && bundle.len() > 0));
    assert!(list.bundles.windows(2).all(|pair| pair[0].0 < pair[1].0));
    assert!(all(list).windows(2).all(|pair| pair[0].root < pair[1].root));
}

#[test]
fn bundles_lie_between_windows_and_hold_the_rest() {
    let mut numbers = Numbers::new(11);
    for _ in 0..300 {
        let mut list = list(&mut numbers);
        assert_in_order(&list);
        assert_eq!((list.count(), all(&list).len()), (60, 60));
        let before = all(&list);
        assert!(list.nearest() <= window::nearest(&before).map(|nearest| nearest + 1e-12));
        list.open();
        assert!(list.is_plain() && list.windows == before);
        list.gather(1.0);
        assert_in_order(&list);
        assert_eq!((list.windows.len(), list.bundles.len()), (2, 1));
        assert_eq!(all(&list), before);
    }
}

#[test]
fn what_is_not_kept_is_followed_by_windows_of_the_bundle_beside() {
    let mut numbers = Numbers::new(13);
    for _ in 0..300 {
        let mut list = list(&mut numbers);
        let (before, outside) = (all(&list), list.windows.clone());
        let is_kept = |window: &Beam| !window.root.is_multiple_of(3);
        list.retain(&is_kept);
        assert_in_order(&list);
        let mut expected = before;
        expected.retain(|window| is_kept(window) || !outside.contains(window));
        assert_eq!(all(&list), expected);
    }
}

#[test]
fn clipping_a_list_is_clipping_its_windows() {
    let mut numbers = Numbers::new(17);
    let mut lost = 0;
    for _ in 0..300 {
        let mut list = list(&mut numbers);
        let mut expected = all(&list);
        // So far that some rays at both ends are farther than by way of the half-edge's ends.
        let [first, last] = [&expected[0], &expected[59]];
        let values = [first.at(0.0) - 0.5 * numbers.next(), last.at(1.0) - 0.5 * numbers.next()];
        window::clip(&mut expected, 1.0, values);
        list.clip(1.0, values);
        assert_in_order(&list);
        assert_eq!(all(&list), expected);
        lost += 60 - expected.len();
    }
    assert!(lost > 3_000, "{lost}");
}
