//! Files of 3MF.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heatwalk_fuzz::reading::mesh("a.3mf", bytes));
