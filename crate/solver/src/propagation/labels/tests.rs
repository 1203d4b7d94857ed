use super::*;

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const LENGTH: f64 = 0.7;

fn labels() -> Labels<Fixed<1>> {
    let mut labels = Labels::new(2, Fixed, LENGTH, parallel::ONE).expect("memory");
    labels.clear();
    labels
}

fn bar(far: f64) -> Bar {
    Bar { length: LENGTH, ends: [far; 2] }
}

fn beam(begin: f64, end: f64) -> Beam {
    Beam { begin, end, x: 0.3, depth: 0.5, offset: 2.0, root: 1 }
}

#[test]
fn what_is_kept_crosses_once() {
    let mut labels = labels();
    assert!(labels.offer(0, &beam(0.1, 0.6), &bar(9.0)).is_some());
    assert_eq!(labels.take(0, 0, &bar(9.0)), Some(beam(0.1, 0.6)));
    assert_eq!(labels.take(0, 0, &bar(9.0)), None, "it has crossed");
    assert_eq!(labels.offer(0, &beam(0.1, 0.6), &bar(9.0)), None, "and is no nearer now");
}

#[test]
fn what_replaces_a_window_takes_its_place_and_what_crosses_leaves_its_own() {
    let mut labels = labels();
    let nearer = |beam: Beam, by: f64| Beam { offset: beam.offset - by, ..beam };
    let [first, second] = [beam(0.1, 0.6), beam(0.0, LENGTH)];
    assert!(labels.offer(0, &first, &bar(9.0)).is_some() && labels.offer(1, &second, &bar(9.0)).is_some());
    assert!(labels.offer(0, &nearer(first, 0.1), &bar(9.0)).is_some());
    assert_eq!(labels.take(0, 0, &bar(9.0)), Some(nearer(first, 0.1)));
    assert!(labels.offer(0, &nearer(first, 0.2), &bar(9.0)).is_some());
    assert_eq!(labels.take(1, 0, &bar(9.0)), Some(second), "nothing has been written over it");
    assert_eq!(labels.take(0, 0, &bar(9.0)), Some(nearer(first, 0.2)));
    assert_eq!(labels.waiting.len(), 2, "two at most have waited");
}

#[test]
fn what_is_too_narrow_or_too_far_is_not_kept() {
    let mut labels = labels();
    assert_eq!(labels.offer(0, &beam(0.3, 0.3 + 1e-14), &bar(9.0)), None, "too narrow");
    assert_eq!(labels.offer(0, &beam(0.0, LENGTH), &bar(1.0)), None, "the ends are nearer");
    assert_eq!(labels.offer(0, &beam(0.0, LENGTH), &bar(9.0)), Some(2.5));
    assert_eq!(labels.offer(0, &Beam { depth: 0.6, ..beam(0.0, LENGTH) }, &bar(9.0)), None, "another is nearer");
    assert_eq!(labels.take(0, 0, &bar(1.0)), None, "the ends have become nearer since");
}

#[test]
fn a_new_round_knows_nothing_of_the_last() {
    let mut labels = labels();
    assert!(labels.offer(0, &beam(0.0, LENGTH), &bar(9.0)).is_some());
    assert!(labels.value_of(0) < f32::INFINITY);
    labels.clear();
    assert_eq!((labels.value_of(0), labels.take(0, 0, &bar(9.0))), (f32::INFINITY, None));
}
