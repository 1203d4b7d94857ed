//! Files of Gmsh, of each version.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heatwalk_fuzz::reading::tetrahedra("a.msh", bytes, &[]));
