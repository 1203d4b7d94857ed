//! What readers have in common: how they reach other files, and how they say what is wrong.

use glam::DVec3;

use super::text;
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

    /// That a face names a vertex that there is not. `vertex`: as the file counts, from `first`.
    pub fn no_vertex(&self, place: impl Into<String>, vertex: u64, vertices: usize, first: u8) -> Error {
        let problem = format!("vertex {vertex} does not exist; there are {vertices}, counted from {first}");
        self.at(place, problem)
    }

    /// The next three words as a position.
    pub fn position<'a>(&self, mut next: impl FnMut() -> Option<&'a str>, line: usize) -> Result<DVec3> {
        let mut coordinates = [0.0; 3];
        for (count, coordinate) in coordinates.iter_mut().enumerate() {
            let word = next();
            *coordinate = word.and_then(text::number).ok_or_else(|| {
                let found = match word {
                    None => format!("there are {count}; the file may be cut short: copy or export it again"),
                    _ => text::why_no_number(word),
                };
                self.line(line, format!("a vertex needs three numbers, but {found}"))
            })?;
        }
        Ok(coordinates.into())
    }
}

/// The first numbers of a line; 0 where there is none, or one that is not finite.
pub fn numbers<const N: usize>(arguments: &str) -> [f32; N] {
    let mut words = arguments.split_whitespace().map(|word| word.parse().unwrap_or(0.0));
    std::array::from_fn(|_| words.next().filter(|number: &f32| number.is_finite()).unwrap_or(0.0))
}
