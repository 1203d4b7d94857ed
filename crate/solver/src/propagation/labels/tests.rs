use super::*;

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn no_window_returns_when_rounds_begin_anew() {
    let mut labels = Labels::new(1, 1, 0.0).expect("memory");
    let beam = Beam { begin: 0.0, end: 1.0, x: 0.5, depth: 1.0, offset: 0.0, root: 0 };
    let bar = Bar { length: 1.0, ends: [2.0; 2], opposite: None };
    assert_eq!(labels.offer(0, &beam, &bar), Some(1.0));
    assert_eq!(labels.value_of(0), 1.0);
    for _ in 0..u16::MAX {
        labels.clear();
        assert_eq!(labels.value_of(0), f64::INFINITY);
    }
}
