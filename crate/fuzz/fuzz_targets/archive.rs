//! Files that are packed, as the program opens them.
#![no_main]

use heatwalk_fuzz::budget::within_budget;
use heatwalk_fuzz::reading::{check_model, check_sentence};

const NAMES: [&str; 4] = ["a.zip", "a.obj.gz", "a.msh.gz", "a.3mf"];

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let Some((&name, file)) = bytes.split_first() else { return };
    let name = NAMES[usize::from(name) % NAMES.len()];
    match within_budget(file.len(), || heatwalk_files::surface_or_points_of_bytes(name, file)) {
        Ok(model) => check_model(&model),
        Err(error) => check_sentence(&format!("{error:#}")),
    }
});
