//! What the tests of the readers share. Of damaged copies of a small file, an error is fine, a panic or an index out of
//! range is not.

mod damage;

use heatwalk_model::{Model, Result, io};
use heatwalk_surface::Soup;

pub use damage::damaged_copies;

pub fn read(name: &str, bytes: impl AsRef<[u8]>) -> Result<Soup> {
    read_model(name, bytes).map(|model| model.soup)
}

pub fn read_model(name: &str, bytes: impl AsRef<[u8]>) -> Result<Model> {
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

fn read_damaged(name: &str, bytes: &[u8]) {
    if let Ok(soup) = read(name, bytes) {
        assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
    }
}
