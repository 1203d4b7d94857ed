//! Labels of vertices, of GIFTI and of FreeSurfer.
#![no_main]

use heatwalk_fuzz::budget::within_budget;
use heatwalk_fuzz::reading::check_sentence;
use heatwalk_model::io;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    match within_budget(bytes.len(), || io::read_labels(bytes)) {
        Ok(labels) => {
            for label in 0..labels.names.len() {
                let _ = labels.is_parcel(label);
                assert!(labels.vertices(label).all(|vertex| vertex < labels.of_vertices.len()));
            }
        }
        Err(error) => check_sentence(&error.to_string()),
    }
});
