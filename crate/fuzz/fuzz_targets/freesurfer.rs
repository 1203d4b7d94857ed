//! Files of FreeSurfer's surfaces.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heatwalk_fuzz::reading::mesh("lh.white", bytes));
