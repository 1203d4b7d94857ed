//! Files of VTK, as surfaces and as tetrahedra.
#![no_main]

use heatwalk_fuzz::reading;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    reading::mesh("a.vtk", bytes);
    reading::tetrahedra("a.vtk", bytes, &[]);
});
