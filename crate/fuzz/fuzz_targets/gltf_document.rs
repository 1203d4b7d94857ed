//! GLB files that are sound as such and say anything.
#![no_main]

use heatwalk_fuzz::documents::gltf::GlbFile;
use heatwalk_fuzz::reading;

libfuzzer_sys::fuzz_target!(|file: GlbFile| reading::mesh("a.glb", &file.0));
