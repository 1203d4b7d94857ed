//! The two files of TetGen, the nodes before the first NUL.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    heatwalk_fuzz::reading::tetrahedra("a.node", &bytes[..end], bytes.get(end + 1..).unwrap_or_default());
});
