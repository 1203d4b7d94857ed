//! Arrays as NumPy writes them (NEP 1, version 1.0).

/// What an array in the order of C begins with; `shape` as Python writes a tuple.
pub fn header(descriptor: &str, shape: &str) -> Vec<u8> {
    const ALIGNED: usize = 64;
    const BEFORE: usize = 10;
    let mut dictionary = format!("{{'descr': '{descriptor}', 'fortran_order': False, 'shape': {shape}, }}");
    let length = (BEFORE + dictionary.len() + 1).next_multiple_of(ALIGNED) - BEFORE;
    dictionary.push_str(&" ".repeat(length - dictionary.len() - 1));
    dictionary.push('\n');
    [b"\x93NUMPY\x01\x00", (length as u16).to_le_bytes().as_slice(), dictionary.as_bytes()].concat()
}
