//! Bundles against the same windows, each of which crosses the same faces by itself.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::super::crossing::Crossing;
use super::super::samples::{Numbers, fan};
use super::super::window::nearest;
use super::*;

/// Rounding across some faces, relative to lengths of at least 1.
const ROUNDING: f64 = 1e-12;

/// The sides of a triangle whose first one lies on the x axis from the origin.
fn sides(length: f64, [x, y]: [f64; 2]) -> [Side; 3] {
    let corners = [[0.0, 0.0], [length, 0.0], [x, y]];
    let edge = |k: usize| [0, 1].map(|axis| corners[(k + 1) % 3][axis] - corners[k][axis]);
    std::array::from_fn(|k| {
        let ([x, y], [back_x, back_y]) = (edge(k), edge((k + 2) % 3));
        let (length, back) = (x.hypot(y), back_x.hypot(back_y));
        let cos = -(x * back_x + y * back_y) / (length * back);
        Side { length, cos, sin: (back_x * y - back_y * x).abs() / (length * back), vertex: k as u32, next_on_edge: 0 }
    })
}

/// A point in the light of some windows of a half-edge of this length, off an end of one of them by up to `aside`.
fn corner(numbers: &mut Numbers, windows: &[Beam], length: f64, aside: f64) -> [f64; 2] {
    let window = &windows[(numbers.next() * windows.len() as f64) as usize];
    let height = length * (0.3 + numbers.next());
    let along = window.end + (window.end - window.x) * height / window.depth;
    [along + aside * (numbers.next() - 0.5), height]
}

fn assert_same(bundle: &Bundle, windows: &[Beam]) {
    assert_eq!(bundle.len(), windows.len());
    for (found, expected) in bundle.clone().zip(windows) {
        for (found, expected) in [
            (found.begin, expected.begin),
            (found.end, expected.end),
            (found.x, expected.x),
            (found.depth, expected.depth),
            (found.offset, expected.offset),
        ] {
            assert!((found - expected).abs() < ROUNDING * expected.abs().max(1.0), "{found} for {expected}");
        }
        assert_eq!(found.root, expected.root);
    }
}

#[test]
fn windows_of_a_bundle_cross_faces_as_they_do_alone() {
    let mut numbers = Numbers::new(3);
    let (mut crossed, mut seen, mut most_seen) = (0, 0, 0);
    for _ in 0..400 {
        let (mut windows, mut length) = (fan(&mut numbers, 40), 1.0);
        let mut bundle = Bundle::new(windows.clone(), length);
        while windows.len() > 3 && length < 20.0 {
            let aside = if numbers.next() < 0.5 { 0.0 } else { 0.5 };
            let opposite = corner(&mut numbers, &windows, length, aside);
            let sides = sides(length, opposite);
            let [base, right, left] = &sides;
            let sides = [base, right, left];
            let [to_left, middle, to_right] = bundle.split(opposite);
            assert_eq!(to_left.len() + middle.len() + to_right.len(), windows.len());
            let crossings: Vec<Crossing> = windows.iter().map(|&window| Crossing::new(window, opposite)).collect();
            let (first, rest) = crossings.split_at(to_left.len());
            let (between, last) = rest.split_at(middle.len());
            assert!(first.iter().chain(last).all(|crossing| !crossing.sees_corner(0.0)));
            let beams = |crossings: &[Crossing], way: fn(&Crossing, [&Side; 3]) -> Option<Beam>| -> Vec<Beam> {
                crossings.iter().filter_map(|crossing| way(crossing, sides)).collect()
            };
            assert!(beams(first, Crossing::to_right).is_empty() && beams(last, Crossing::to_left).is_empty());
            let (of_left, of_right) = (beams(first, Crossing::to_left), beams(last, Crossing::to_right));
            let [to_left, to_right] = [
                to_left.across(&Motion::to_left(sides), left.length),
                to_right.across(&Motion::to_right(sides), right.length),
            ];
            assert_same(&to_left, &of_left);
            assert_same(&to_right, &of_right);
            (crossed, seen, most_seen) = (crossed + 1, seen + between.len(), most_seen.max(between.len()));
            (bundle, windows, length) = if of_left.len() > of_right.len() {
                (to_left, of_left, left.length)
            } else {
                (to_right, of_right, right.length)
            };
        }
    }
    assert!(crossed > 1_000 && seen < 3 * crossed && most_seen < 12, "{crossed}, {seen}, {most_seen}");
}

#[test]
fn no_window_is_nearer_than_the_bound_of_its_bundle() {
    let mut numbers = Numbers::new(5);
    for _ in 0..400 {
        let (windows, length) = (fan(&mut numbers, 40), 1.0);
        let bundle = Bundle::new(windows.clone(), length);
        let opposite = [3.0 + numbers.next(), 0.5 + numbers.next()];
        let sides = sides(length, opposite);
        let [base, right, left] = &sides;
        let sides = [base, right, left];
        let crossed: Vec<Beam> =
            windows.iter().filter_map(|&window| Crossing::new(window, opposite).to_left(sides)).collect();
        for (bundle, windows, length) in [
            (bundle.clone(), &windows, length),
            (bundle.across(&Motion::to_left(sides), left.length), &crossed, left.length),
        ] {
            let Some(nearest) = nearest(windows) else { continue };
            let bound = bundle.least([0.0, length]);
            assert!(bound <= nearest + ROUNDING, "{bound} for {nearest}");
            let ends = [windows[0].begin, windows[windows.len() - 1].end];
            let bound = bundle.least(ends);
            assert!(bound <= nearest + ROUNDING && bound > nearest - 0.3, "{bound} for {nearest}");
        }
    }
}
