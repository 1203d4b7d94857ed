//! XML files of VTK that are sound as such and say anything, as surfaces and as tetrahedra.
#![no_main]

use heatwalk_fuzz::documents::vtk::VtkFile;
use heatwalk_fuzz::reading;

libfuzzer_sys::fuzz_target!(|file: VtkFile| {
    reading::mesh("a.vtu", &file.0);
    reading::tetrahedra("a.vtu", &file.0, &[]);
});
