//! What the tests of the readers share. Of damaged copies of a small file, an error is fine, a panic or an index out of
//! range is not.

use heatwalk_surface::Result;
use heatwalk_surface::Soup;
use heatwalk_surface::io;

const DAMAGED_COPIES: usize = 3000;

pub fn read(name: &str, bytes: impl AsRef<[u8]>) -> Result<Soup> {
    io::read(name, bytes.as_ref(), &|_| None)
}

pub fn part_names(soup: &Soup) -> Vec<&str> {
    soup.parts.iter().map(|part| part.name.as_str()).collect()
}

/// Area of each triangle's projection on the plane z = 0, signed.
pub fn areas(soup: &Soup) -> Vec<f64> {
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|corner| soup.positions[corner as usize]);
        (b - a).cross(c - a).z / 2.0
    };
    soup.triangles.iter().map(area).collect()
}

/// Every prefix of the file.
pub fn cut_short_at_every_byte(name: &str, bytes: &[u8]) {
    (0..bytes.len()).for_each(|length| read_damaged(name, &bytes[..length]));
}

/// Copies with one to three random bytes replaced, the same at every run.
pub fn flip_bytes(name: &str, bytes: &[u8]) {
    damaged_copies(bytes).for_each(|damaged| read_damaged(name, &damaged));
}

/// The copies that [`flip_bytes`] reads.
pub fn damaged_copies(bytes: &[u8]) -> impl Iterator<Item = Vec<u8>> {
    let mut state = 1_u64;
    let mut random = move |below: usize| {
        // Multiplier and increment of Knuth's MMIX.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    (0..DAMAGED_COPIES).map(move |_| {
        let mut damaged = bytes.to_vec();
        for _ in 0..=random(3) {
            damaged[random(bytes.len())] = random(256) as u8;
        }
        damaged
    })
}

fn read_damaged(name: &str, bytes: &[u8]) {
    if let Ok(soup) = read(name, bytes) {
        assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
    }
}
