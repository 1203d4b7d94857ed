//! Files of OFF.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heatwalk_fuzz::reading::mesh("a.off", bytes));
