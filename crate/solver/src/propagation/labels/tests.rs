use super::*;

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const LENGTH: f64 = 0.7;

fn labels(sources: usize) -> Labels<Fixed<1>> {
    let mut labels = Labels::new(1, Fixed, LENGTH, parallel::ONE).expect("memory");
    labels.clear(sources);
    labels
}

fn bar(far: f64) -> Bar {
    Bar { length: LENGTH, ends: [far; 2], opposite: None }
}

fn beam(begin: f64, end: f64) -> Beam {
    Beam { begin, end, x: 0.3, depth: 0.5, offset: 2.0, root: 1 }
}

#[test]
fn what_is_kept_lies_in_what_was_offered() {
    for (begin, end) in [(0.0, LENGTH), (0.1, 0.6), (0.33333, 0.34), (1e-9, 0.2), (0.3, LENGTH - 1e-9)] {
        let mut labels = labels(2);
        assert!(labels.offer(0, &beam(begin, end), &bar(9.0)).is_some());
        let kept = labels.take(0, 0, &bar(9.0)).expect("it waits");
        assert!(kept.begin >= begin && kept.end <= end, "{kept:?}");
        assert!(kept.begin - begin < 1e-4 * LENGTH && end - kept.end < 1e-4 * LENGTH, "{kept:?}");
        assert_eq!(Beam { begin, end, ..kept }, beam(begin, end));
        assert_eq!(labels.take(0, 0, &bar(9.0)), None, "it has crossed");
    }
}

#[test]
fn what_is_too_narrow_or_too_far_is_not_kept() {
    let mut labels = labels(1);
    assert_eq!(labels.offer(0, &beam(0.3, 0.3 + 1e-6), &bar(9.0)), None, "narrower than a share");
    assert_eq!(labels.offer(0, &beam(0.0, LENGTH), &bar(1.0)), None, "the ends are nearer");
    assert_eq!(labels.offer(0, &beam(0.0, LENGTH), &bar(9.0)), Some(2.5));
    assert_eq!(labels.offer(0, &Beam { depth: 0.6, ..beam(0.0, LENGTH) }, &bar(9.0)), None, "another is nearer");
    assert_eq!(labels.take(0, 0, &bar(1.0)), None, "the ends have become nearer since");
}

#[test]
fn a_new_round_knows_nothing_of_the_last() {
    let mut labels = labels(1);
    assert!(labels.offer(0, &beam(0.0, LENGTH), &bar(9.0)).is_some());
    assert!(labels.value_of(0) < f32::INFINITY);
    labels.clear(1);
    assert_eq!((labels.value_of(0), labels.take(0, 0, &bar(9.0))), (f32::INFINITY, None));
}

#[test]
fn an_interval_at_the_end_of_a_half_edge_is_not_kept_as_all_of_it() {
    for length in (1..2000).map(|count| 0.1 * f64::from(count)) {
        // Shares of what is all but at the end may round to more than there are.
        let window = Window::from(beam(length, length));
        assert!(Label::new(&window, length, -1.0).is_none(), "{length}");
    }
}
