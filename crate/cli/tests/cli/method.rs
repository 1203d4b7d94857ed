//! Which method finds distances, and those without factors: by a few windows of each half-edge, and exactly.

use std::fs;

use serde_json::Value;

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

fn found(answer: &Value) -> &str {
    answer["method"].as_str().expect("a method")
}

#[test]
fn the_answer_tells_what_found_it() {
    let folder = folder("method");
    let answer = |options: &[&str]| json(&folder, &[&["distance"], &TORUS[..], options].concat());
    // So small a mesh is exact at no cost.
    for options in [&[][..], &["--exact"], &["--method", "exact"], &["--method", "auto"]] {
        let answer = answer(options);
        assert_eq!(found(&answer), "exact", "{options:?}");
        assert!(answer["windows"] == "all", "{answer}");
        assert!(answer["windows_crossed"].as_u64().is_some_and(|windows| windows > 576), "{answer}");
        assert!(answer["factor_nonzeros"] == 0 && answer["timings_ms"]["precompute"] == 0.0, "{answer}");
        for key in ["exact_below", "stages_ms", "time_factor"] {
            assert!(answer.get(key).is_none(), "{options:?}: {answer}");
        }
    }
    let heat = answer(&["--method", "heat"]);
    assert!(found(&heat) == "heat" && heat.get("windows").is_none(), "{heat}");
    assert!(heat["timings_ms"]["precompute"].as_f64().is_some_and(|time| time > 0.0), "{heat}");

    let fine =
        ["distance", "shape:icosphere", "--source", "0", "--method", "propagation", "--repeat", "2", "--compare"];
    let few = json(&folder, &fine);
    assert_eq!(found(&few), "propagation");
    assert_eq!((&few["windows"], &few["unreachable"]), (&1.into(), &0.into()));
    let [below, max] = ["exact_below", "max_distance"].map(|key| few[key].as_f64().expect("a number"));
    assert!(0.0 < below && below < max, "{few}");
    let error = few["mean_error_percent"].as_f64().expect("a number");
    assert!(0.0 < error && error < 0.5, "{few}");
    let all = json(&folder, &[&fine[..], &["--windows", "all"]].concat());
    assert_eq!((found(&all), &all["max_error_percent"]), ("exact", &0.0.into()));
    assert!(all["windows_crossed"].as_u64() > few["windows_crossed"].as_u64(), "{all} {few}");
}

/// Each with a value that has an effect.
const HEAT_OPTIONS: [[&str; 2]; 6] = [
    ["--operator", "plain"],
    ["--t", "9"],
    ["--boundary", "dirichlet"],
    ["--near", "2"],
    ["--solver", "cg"],
    ["--multi", "summed"],
];

#[test]
fn an_option_of_heat_means_heat() {
    let folder = folder("method_heat");
    let ends = ["path", "torus.ply", "--from", "5", "--to", "150"];
    assert_eq!(found(&json(&folder, &ends)), "exact");
    let from = [&["distance"], &TORUS[..]].concat();
    for option in HEAT_OPTIONS {
        let [implied, explicit] =
            [&[][..], &["--method", "heat"]].map(|method| json(&folder, &[&from[..], &option, method].concat()));
        assert_eq!(found(&implied), "heat", "{option:?}");
        assert_eq!(implied["max_distance"], explicit["max_distance"], "{option:?}");
        let others = ["auto", "propagation", "exact"].map(|method| ["--method", method].to_vec());
        for method in others.into_iter().chain([vec!["--exact"]]) {
            let line = refused(&folder, &[&from[..], &option, &method].concat());
            assert!(line.contains(option[0]) && line.contains(&method.join(" ")), "{line}");
            if option[0] != "--multi" {
                let line = refused(&folder, &[&ends[..], &option, &method].concat());
                assert!(line.contains(option[0]) && line.contains(&method.join(" ")), "{line}");
            }
        }
        if option[0] != "--multi" {
            assert_eq!(found(&json(&folder, &[&ends[..], &option].concat())), "heat", "{option:?}");
        }
    }
}

#[test]
fn a_path_descends_the_distance_of_the_method() {
    let folder = folder("method_path");
    let ends = ["path", "shape:icosphere", "--from", "5", "--to", "150"];
    let exact = json(&folder, &[&ends[..], &["--exact"]].concat());
    let [shortest, distance] = ["length", "distance"].map(|key| exact[key].as_f64().expect("a number"));
    assert_eq!(shortest, distance);
    for method in ["auto", "propagation", "heat", "exact"] {
        let path = json(&folder, &[&ends[..], &["--method", method]].concat());
        assert_eq!(found(&path), if method == "auto" { "exact" } else { method });
        let [length, value] = ["length", "distance"].map(|key| path[key].as_f64().expect("a number"));
        // Rounding of what is traced.
        assert!(length >= shortest * (1.0 - 1e-9) && length < 1.01 * shortest, "{method}: {length} {shortest}");
        assert_eq!((value - distance).abs() < 1e-9, found(&path) == "exact", "{method}: {value} {distance}");
    }
}

#[test]
fn each_source_has_a_column_however_many_threads_there_are() {
    let folder = folder("each");
    let from = ["torus.ply", "--source", "0", "--source", "7:0.2,0.3,0.5", "--source", "150@0.5"];
    for method in [&[][..], &["--method", "propagation", "--windows", "1"], &["--method", "heat"]] {
        let alone = [2, 4, 6].map(|last| {
            let source = [&from[..1], &from[last - 1..=last], method].concat();
            distances(&folder, &source)
        });
        let mut files = Vec::new();
        for threads in [&["--threads", "1"][..], &["--threads", "3"], &[]] {
            let options = [&["distance"], &from[..], &["--each", "--output", "each.csv"], method, threads].concat();
            let answer = json(&folder, &options);
            let each = answer["each"].as_array().expect("answers");
            assert_eq!(each.len(), 3, "{answer}");
            assert!(each.iter().all(|each| each["unreachable"] == 0 && found(each) != "auto"), "{answer}");
            files.push(fs::read_to_string(folder.join("each.csv")).expect("a file"));
        }
        assert!(files.iter().all(|file| *file == files[0]), "{method:?}");
        let mut lines = files[0].lines();
        assert_eq!(lines.next(), Some("vertex,distance_0,distance_1,distance_2"));
        for (vertex, line) in lines.enumerate() {
            let cells: Vec<f64> = line.split(',').skip(1).map(|cell| cell.parse().expect("a number")).collect();
            assert_eq!(cells, [0, 1, 2].map(|source: usize| alone[source][vertex]), "{method:?}, {vertex}");
        }
    }
    let each = |options: &[&str]| refused(&folder, &[&["distance"], &from[..], options].concat());
    assert!(each(&["--each", "--output", "each.ply"]).contains(".csv"));
    assert!(each(&["--each", "--repeat", "3"]).contains("cannot be used"));
    assert!(each(&["--each", "--compare"]).contains("cannot be used"));
    assert!(each(&["--each", "--line", "0,5"]).contains("cannot be used"));
    assert!(each(&["--each", "--threads", "0"]).contains("--threads"));
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
    for heat in [["--method", "heat"], ["--near", "2"]] {
        for option in [["--max-distance", "1"], ["--windows", "3"]] {
            let line = refusal(&[heat, option].concat());
            assert!(line.contains(option[0]) && line.contains(heat[0]), "{line}");
        }
    }
    assert!(refusal(&["--exact", "--windows", "3"]).contains("--windows has no effect with --exact"));
}
