//! Reads damaged copies of a small file: an error is fine, a panic or an index out of range is not.

use heatwalk::io;

const DAMAGED_COPIES: usize = 3000;

/// Every prefix of the file.
pub fn cut_short_at_every_byte(name: &str, bytes: &[u8]) {
    (0..bytes.len()).for_each(|length| read(name, &bytes[..length]));
}

/// Copies with one to three random bytes replaced, the same at every run.
pub fn flip_bytes(name: &str, bytes: &[u8]) {
    let mut state = 1_u64;
    let mut random = |below: usize| {
        // Multiplier and increment of Knuth's MMIX.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    for _ in 0..DAMAGED_COPIES {
        let mut damaged = bytes.to_vec();
        for _ in 0..=random(3) {
            damaged[random(bytes.len())] = random(256) as u8;
        }
        read(name, &damaged);
    }
}

fn read(name: &str, bytes: &[u8]) {
    if let Ok(soup) = io::read(name, bytes, &|_| None) {
        assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
    }
}
