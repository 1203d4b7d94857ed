//! Generated surfaces: everything a page or a test needs without a file. All are deterministic, `y` is up, triangles
//! are counter-clockwise seen from outside.

mod bodies;
mod implicit;
mod maze;
mod parametric;
mod terrain;

pub use bodies::{animal, high_genus, ring};
pub use maze::maze;
pub use parametric::{cylinder, grid, hemisphere, icosphere, strip, torus, uv_sphere};
pub use terrain::terrain;

use crate::error::{Error, Result};
use crate::soup::Soup;

const NAMES: [&str; 10] =
    ["animal", "maze", "high_genus", "ring", "hemisphere", "terrain", "torus", "icosphere", "uv_sphere", "strip"];
const NAMES_IN_WORDS: &str = "one of animal, maze, high_genus, ring, hemisphere, terrain, torus, icosphere, uv_sphere, \
                              strip";

/// The names that [`by_name`] takes.
pub fn names() -> &'static [&'static str] {
    &NAMES
}

/// A shape at its default resolution, 5,000 to 50,000 triangles.
///
/// # Errors
/// [`Error::BadParameter`] for a name that is not in [`names`].
pub fn by_name(name: &str) -> Result<Soup> {
    Ok(match name {
        "animal" => animal(0.021),
        "maze" => maze(10, 6),
        "high_genus" => high_genus(0.065),
        "ring" => ring(0.034),
        "hemisphere" => hemisphere(48),
        "terrain" => terrain(128),
        "torus" => torus(1.0, 0.4, 144, 60),
        "icosphere" => icosphere(5),
        "uv_sphere" => uv_sphere(96, 48),
        "strip" => strip(1.0, 40.0, 8),
        _ => {
            return Err(Error::BadParameter { name: "shape", value: name.to_owned(), range: NAMES_IN_WORDS });
        }
    })
}
