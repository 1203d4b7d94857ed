//! Points as lines of text, and the surface between them.
#![no_main]

use heatwalk_cloud::text;
use heatwalk_fuzz::budget::within_budget;
use heatwalk_fuzz::reading::check_sentence;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    match within_budget(bytes.len(), || text::read_points("a.xyz", bytes)) {
        Ok(points) => assert!(points.normals.is_empty() || points.normals.len() == points.positions.len()),
        Err(error) => check_sentence(&error.to_string()),
    }
});
