//! Distances without factors: by a few windows of each half-edge, and exactly.

use crate::{distances, folder, json, refused};

const TORUS: [&str; 3] = ["torus.ply", "--source", "0"];

#[test]
fn a_few_windows_are_near_to_the_exact_distance_and_never_below() {
    let folder = folder("windows");
    let exact = distances(&folder, &[&TORUS[..], &["--exact"]].concat());
    let mut last = f64::INFINITY;
    for windows in ["1", "8"] {
        let options = ["--method", "propagation", "--windows", windows];
        let values = distances(&folder, &[&TORUS[..], &options].concat());
        // Rounding of lengths unfolded through the faces between.
        assert!(values.iter().zip(&exact).all(|(value, exact)| *value >= exact * (1.0 - 1e-9)));
        let mean = values.iter().zip(&exact).skip(1).map(|(value, exact)| value / exact - 1.0).sum::<f64>() / 287.0;
        assert!(mean < 0.01 && mean <= last, "{windows} windows: {mean}");
        last = mean;
    }
}

#[test]
fn the_answer_tells_what_found_it() {
    let folder = folder("method");
    let answer = |options: &[&str]| json(&folder, &[&["distance"], &TORUS[..], options].concat());
    let found = |answer: &serde_json::Value| answer["method"].as_str().map(str::to_owned);
    assert_eq!(found(&answer(&[])).as_deref(), Some("heat"));
    // So small a mesh is exact at no cost.
    for options in [&["--exact"][..], &["--method", "exact"], &["--method", "auto"]] {
        let answer = answer(options);
        assert_eq!(found(&answer).as_deref(), Some("exact"), "{options:?}");
        assert!(
            answer["factor_nonzeros"] == 0 && answer.get("exact_below").is_none() && answer.get("windows").is_none()
        );
    }
    let fine =
        ["distance", "shape:icosphere", "--source", "0", "--method", "propagation", "--repeat", "2", "--compare"];
    let few = json(&folder, &fine);
    assert_eq!(found(&few).as_deref(), Some("propagation"));
    assert_eq!((&few["windows"], &few["unreachable"]), (&"2".into(), &0.into()));
    let [below, max] = ["exact_below", "max_distance"].map(|key| few[key].as_f64().expect("a number"));
    assert!(0.0 < below && below < max, "{few}");
    let error = few["mean_error_percent"].as_f64().expect("a number");
    assert!(0.0 < error && error < 0.5, "{few}");
    let all = json(&folder, &[&fine[..], &["--windows", "all"]].concat());
    assert_eq!((found(&all).as_deref(), &all["max_error_percent"]), (Some("exact"), &0.0.into()));
}

#[test]
fn what_is_farther_than_asked_for_stays_at_infinity() {
    let folder = folder("max_distance");
    let exact = distances(&folder, &[&TORUS[..], &["--exact"]].concat());
    for method in ["auto", "propagation", "exact"] {
        let near = distances(&folder, &[&TORUS[..], &["--method", method, "--max-distance", "1"]].concat());
        for (near, exact) in near.iter().zip(&exact) {
            assert!(if *exact <= 1.0 { near == exact } else { near.is_infinite() }, "{near} for {exact}");
        }
    }
}

#[test]
fn refuses_what_no_method_can_do() {
    let folder = folder("method_refused");
    let refusal = |options: &[&str]| refused(&folder, &[&["distance"], &TORUS[..], options].concat());
    assert!(refusal(&["--method", "guess"]).contains("propagation"));
    assert!(refusal(&["--method", "heat", "--exact"]).contains("cannot be used"));
    assert!(refusal(&["--windows", "0"]).contains("from 1"));
    assert!(refusal(&["--method", "auto", "--max-distance", "-1"]).contains("positive"));
    assert!(refusal(&["--max-distance", "1"]).contains("--method"));
}
