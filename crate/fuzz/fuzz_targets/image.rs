//! Basis Universal images.
#![no_main]

/// Texels either way, so that an input takes no more than a few milliseconds.
const WANTED: u32 = 256;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    match heatwalk_basis::decode(bytes, WANTED) {
        Ok(image) => assert_eq!(image.texels.len(), 4 * image.width as usize * image.height as usize),
        Err(error) => heatwalk_fuzz::reading::check_sentence(&error.to_string()),
    }
});
