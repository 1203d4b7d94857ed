//! Files of Medit, as text and as bytes.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heatwalk_fuzz::reading::tetrahedra("a.mesh", bytes, &[]));
