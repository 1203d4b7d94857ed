//! Models as one module of the page hands them to the solver's.
#![no_main]

use heatwalk_fuzz::budget::within_budget;
use heatwalk_model::Model;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Some(model) = within_budget(bytes.len(), || Model::unpacked(bytes)) {
        assert!(Model::unpacked(&model.packed()).is_some(), "what was packed can be unpacked");
    }
});
