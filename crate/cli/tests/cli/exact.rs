//! Exact distances, and errors against them.

use crate::{difference, distances, flat, folder, json};

fn straight_from_first() -> Vec<f64> {
    flat().positions.iter().map(|at| at.x.hypot(at.z)).collect()
}

#[test]
fn exact_distances_on_a_flat_square_are_straight() {
    let folder = folder("exact");
    let exact = distances(&folder, &["flat.ply", "--source", "0", "--exact"]);
    assert!(difference(&exact, &straight_from_first()) < 1e-9, "{exact:?}");
    let torus = distances(&folder, &["torus.ply", "--source", "0", "--exact"]);
    assert!(torus[0] == 0.0 && torus[1..].iter().all(|value| value.is_finite() && *value > 0.0));
}

#[test]
fn exact_distances_need_no_factors() {
    let folder = folder("exact_report");
    let answer = json(&folder, &["distance", "flat.ply", "--source", "0", "--exact", "--repeat", "3"]);
    assert_eq!(answer["factor_nonzeros"], 0);
    assert!(answer.get("time_factor").is_none() && answer.get("exact_below").is_none());
    for key in ["read", "build", "precompute", "solve"] {
        assert!(answer["timings_ms"][key].as_f64().unwrap() >= 0.0, "{key}");
    }
    assert!((answer["max_distance"].as_f64().unwrap() - 2.0_f64.sqrt()).abs() < 1e-9, "{answer}");
    assert_eq!(answer["unreachable"], 0);
    // What a search needs of the surface belongs to building it.
    assert_eq!(answer["timings_ms"]["precompute"], 0.0);
}

#[test]
fn exact_distances_end_at_other_components() {
    let folder = folder("exact_components");
    let exact = distances(&folder, &["two.obj", "--source", "0", "--exact"]);
    assert!(exact[3..].iter().all(|value| value.is_infinite()), "{exact:?}");
    for (value, wanted) in exact.iter().zip([0.0, 1.0, 1.0]) {
        // Rounding of one unfolded face.
        assert!((value - wanted).abs() < 1e-12, "{exact:?}");
    }
}

#[test]
fn compare_tells_the_relative_error() {
    let folder = folder("compare");
    let arguments = ["flat.ply", "--source", "0", "--near", "0"];
    let answer = json(&folder, &[&["distance"], &arguments[..], &["--compare"]].concat());
    let (heat, straight) = (distances(&folder, &arguments), straight_from_first());
    let errors: Vec<f64> =
        heat.iter().zip(straight).skip(1).map(|(heat, straight)| 100.0 * (heat - straight).abs() / straight).collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let max = errors.iter().copied().fold(0.0, f64::max);
    assert!(mean > 0.1 && max > mean, "the heat method is not exact: {mean} {max}");
    for (key, expected) in [("mean_error_percent", mean), ("max_error_percent", max)] {
        let value = answer[key].as_f64().unwrap();
        // Exact distances are good to 10⁻⁹, the smallest is 1 / 8.
        assert!((value - expected).abs() < 1e-5, "{key}: {value} {expected}");
    }
    assert!(json(&folder, &[&["distance"], &arguments[..]].concat()).get("mean_error_percent").is_none());
    let whole = json(&folder, &["distance", "flat.ply", "--source", "0", "--near", "inf", "--compare"]);
    assert_eq!(whole["max_error_percent"], 0.0);
}
