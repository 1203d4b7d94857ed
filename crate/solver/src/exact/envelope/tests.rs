//! How often windows are looked at until none overlap.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::super::samples::least;
use super::*;

#[test]
fn a_window_on_many_others_is_divided_among_them_in_a_few_rounds() {
    for count in [10_usize, 100, 1_000, 4_000] {
        // Nearer than every other one of them.
        let wide = Beam { begin: 0.0, end: 1.0, x: 0.3, depth: 1.0, offset: 0.0, root: 0 };
        let narrow = |number: usize| {
            let [begin, end] = [number, number + 1].map(|place| place as f64 / count as f64);
            let offset = if number.is_multiple_of(2) { 1e-3 } else { -1e-3 };
            Beam { begin, end, offset, root: 1 + number as u32, ..wide }
        };
        let mut list: Vec<Beam> = (0..count).map(narrow).collect();
        let mut envelope = Envelope::default();
        envelope.join(&mut list, &[wide]);
        assert_eq!(list.len(), count);
        for (number, part) in list.iter().enumerate() {
            let place = (number as f64 + 0.5) / count as f64;
            assert_eq!(least(&[*part], place), wide.at(place).min(narrow(number).at(place)));
        }
        let bound = (ROUNDS + 3) * (count + 2 * ROUNDS);
        assert!(envelope.looked_at < bound, "{} windows looked at for {count}", envelope.looked_at);
    }
}
