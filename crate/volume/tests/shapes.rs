//! Meshes made in code.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::PI;

use crate::common::mesh;
use heatwalk_volume::shapes;

#[test]
fn shapes_are_whole_and_of_the_size_of_a_demonstration() {
    for name in shapes::names() {
        let mesh = mesh(&shapes::by_name(name).unwrap());
        let report = mesh.report();
        assert_eq!((report.components, report.flat_tetrahedra, report.duplicate_tetrahedra), (1, 0, 0), "{name}");
        assert!((30_000..100_000).contains(&report.tetrahedra), "{name}: {}", report.tetrahedra);
        let surface = heatwalk::Surface::build(&mesh.boundary().soup).unwrap();
        assert_eq!(surface.report().boundary_loops, 0, "{name}");
    }
    assert!(shapes::by_name("teapot").is_none());
}

#[test]
fn a_pipe_and_a_cave_have_good_angles_and_the_volume_of_their_forms() {
    let angle = 0.28_f64;
    let spheres = (4.0 * PI - 12.0 * 2.0 * PI * (1.0 - angle.cos())) * (1.0 - 0.5_f64.powi(3)) / 3.0;
    // By Pappus, that of a straight pipe as long as its middle line.
    let pipe = PI * 0.33_f64.powi(2) * (3.0 * 1.2 + 2.0 * PI * 0.55);
    // What chords of circles of 30 and of 15 edges cut off, up to (2π/15)² / 6 = 3 % of an area.
    for (name, expected, most) in [("pipe", pipe, 0.02), ("cave", spheres, 0.02)] {
        let mesh = mesh(&shapes::by_name(name).unwrap());
        let share = mesh.report().volume / expected;
        assert!((share - 1.0).abs() < most, "{name}: {share}");
        let quality = mesh.quality();
        assert!(quality.least_angle > 15.0 && quality.largest_angle < 150.0, "{name}: {quality:?}");
        assert!(quality.mean_least_angle > 35.0, "{name}: {quality:?}");
    }
    let genus = |name: &str| {
        let soup = mesh(&shapes::by_name(name).unwrap()).boundary().soup;
        let vertices = soup.positions.len() as i64 - soup.triangles.len() as i64 / 2;
        1 - vertices / 2
    };
    // The pillars join the two spheres to one surface.
    assert_eq!((genus("pipe"), genus("cave")), (0, 11));
}
