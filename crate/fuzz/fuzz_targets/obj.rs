//! Files of OBJ.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heatwalk_fuzz::reading::mesh("a.obj", bytes));
