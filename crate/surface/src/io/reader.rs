//! What readers have in common: how they reach other files, and how they say what is wrong.

use glam::DVec3;

use crate::error::{Error, Result};

/// Gives the bytes of a file that the mesh refers to (percent-decoded relative URI), if there are any.
pub type Resources<'a> = &'a dyn Fn(&str) -> Option<Vec<u8>>;

/// How each reader says that its format is broken.
#[derive(Clone, Copy)]
pub struct Reporter(pub &'static str);

impl Reporter {
    pub fn at(&self, place: impl Into<String>, problem: impl Into<String>) -> Error {
        Error::Malformed { format: self.0, place: place.into(), problem: problem.into() }
    }

    pub fn line(&self, number: usize, problem: impl Into<String>) -> Error {
        self.at(format!("line {number}"), problem)
    }

    /// The position on a vertex line, what follows it ignored.
    pub fn vertex(&self, arguments: &str, line: usize) -> Result<DVec3> {
        let mut words = arguments.split_whitespace();
        let mut coordinates = [0.0; 3];
        for coordinate in &mut coordinates {
            *coordinate = words
                .next()
                .and_then(|word| word.parse().ok())
                .ok_or_else(|| self.line(line, "a vertex needs three numbers; correct the line"))?;
        }
        Ok(coordinates.into())
    }
}

/// The first numbers of a line; 0 where there is none, or one that is not finite.
pub fn numbers<const N: usize>(arguments: &str) -> [f32; N] {
    let mut words = arguments.split_whitespace().map(|word| word.parse().unwrap_or(0.0));
    std::array::from_fn(|_| words.next().filter(|number: &f32| number.is_finite()).unwrap_or(0.0))
}

/// Without the mark that some programs put before text in UTF-8.
pub fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes)
}
