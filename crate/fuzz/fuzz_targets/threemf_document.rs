//! 3MF files that are sound as such and say anything.
#![no_main]

use heatwalk_fuzz::documents::threemf::ThreemfFile;
use heatwalk_fuzz::reading;

libfuzzer_sys::fuzz_target!(|file: ThreemfFile| reading::mesh("a.3mf", &file.0));
