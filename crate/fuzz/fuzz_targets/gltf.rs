//! Files of glTF and GLB, with Draco and meshopt.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heatwalk_fuzz::reading::mesh("a.glb", bytes));
