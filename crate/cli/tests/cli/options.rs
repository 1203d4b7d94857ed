//! The options of the heat method.

use std::fs;
use std::path::Path;

use heatwalk_model::io::write;

use crate::{difference, distances, flat, folder, json};

/// What is reported of distances from vertex 0.
fn figure(folder: &Path, name: &str, options: &[&str]) -> f64 {
    json(folder, &[&["distance", "--source", "0"], options].concat())[name].as_f64().unwrap()
}

#[test]
fn options_change_the_answer() {
    let folder = folder("options");
    let max = |options: &[&str]| figure(&folder, "max_distance", &[&["grid.ply", "--near", "0"], options].concat());
    assert_eq!(max(&[]), max(&["--t", "auto"]));
    assert_ne!(max(&[]), max(&["--t", "20"]));
    assert_ne!(max(&["--boundary", "neumann"]), max(&["--boundary", "dirichlet"]));
    max(&["--boundary", "average"]);
}

#[test]
fn the_time_factor_is_reported() {
    let folder = folder("time_factor");
    let factor =
        |options: &[&str]| figure(&folder, "time_factor", &[&["flat.ply", "--method", "heat"], options].concat());
    assert_eq!(factor(&["--t", "2.5"]), 2.5);
    assert_eq!(factor(&["--t", "auto"]), factor(&[]));
    assert!(factor(&[]) > 0.0);
}

#[test]
fn both_linear_solvers_agree() {
    let folder = folder("solver");
    // Where the time is chosen, they have different fields.
    for options in
        [&["torus.ply", "--t", "1"][..], &["torus.ply", "--t", "5"], &["grid.ply", "--t", "1", "--boundary", "average"]]
    {
        let of = |solver| {
            let places = ["--source", "0", "--source", "7:0.2,0.3,0.5", "--near", "0", "--solver", solver];
            distances(&folder, &[options, &places].concat())
        };
        // Conjugate gradients stop at a residual of 10⁻¹², which the matrices of so small meshes, and heat that falls
        // by some orders of magnitude, make this much of.
        assert!(difference(&of("cg"), &of("cholesky")) < 1e-6, "{options:?}");
    }
    let nonzeros = |solver| {
        let arguments = ["distance", "torus.ply", "--source", "0", "--solver", solver];
        json(&folder, &arguments)["factor_nonzeros"].as_u64().unwrap()
    };
    assert_eq!(nonzeros("cg"), 0);
    assert!(nonzeros("cholesky") > 0);
}

#[test]
fn the_delaunay_operator_is_the_best_on_bad_triangles() {
    let folder = folder("operator");
    let mut soup = flat();
    for position in &mut soup.positions {
        position.x -= 3.0 * position.z;
    }
    let none = vec![0.0; soup.positions.len()];
    fs::write(folder.join("sheared.ply"), write::distance_ply(&soup, &none)).unwrap();
    let centre = soup.positions[40];
    let straight: Vec<f64> = soup.positions.iter().map(|at| (*at - centre).length()).collect();
    let of =
        |options: &[&str]| distances(&folder, &[&["sheared.ply", "--source", "40", "--near", "0"], options].concat());
    let delaunay = of(&["--operator", "delaunay"]);
    assert_eq!(difference(&delaunay, &of(&[])), 0.0, "it is the default");
    for operator in ["plain", "relocate"] {
        let other = of(&["--operator", operator]);
        assert!(difference(&delaunay, &straight) < difference(&other, &straight), "{operator}: {other:?}");
    }
    assert!(difference(&of(&["--operator", "plain"]), &of(&["--operator", "relocate"])) > 1e-6);
}

#[test]
fn distances_are_exact_near_the_sources() {
    let folder = folder("near");
    let below = |mesh: &str, near: &[&str]| {
        let arguments = [&["distance", mesh, "--source", "0", "--operator", "plain"], near].concat();
        json(&folder, &arguments)["exact_below"].clone()
    };
    assert_eq!(below("torus.ply", &["--near", "0"]), 0.0);
    let mean_edge = json(&folder, &["info", "torus.ply"])["mean_edge"].as_f64().unwrap();
    let radius = below("torus.ply", &["--near", "3"]).as_f64().unwrap();
    // Sums of the same lengths in another order.
    assert!((radius - 3.0 * mean_edge).abs() < 1e-12, "{radius}");
    assert_eq!(below("torus.ply", &[]), below("torus.ply", &["--near", "auto"]));
    // JSON has no infinity.
    assert!(below("torus.ply", &["--near", "inf"]).is_null());

    let straight: Vec<f64> = flat().positions.iter().map(|at| at.x.hypot(at.z)).collect();
    let near = distances(&folder, &["flat.ply", "--source", "0", "--operator", "plain", "--near", "3"]);
    let radius = below("flat.ply", &["--near", "3"]).as_f64().unwrap();
    for (near, straight) in near.iter().zip(&straight).filter(|&(_, &straight)| straight < radius) {
        assert!((near - straight).abs() < 1e-9, "{near} {straight}");
    }
    let whole = distances(&folder, &["flat.ply", "--source", "0", "--near", "inf"]);
    assert!(difference(&whole, &straight) < 1e-9);
}
