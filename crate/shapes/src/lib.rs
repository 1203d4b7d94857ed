//! Generated surfaces: everything a page or a test needs without a file. All are deterministic, `y` is up, triangles
//! are counter-clockwise seen from outside.

use heatwalk_model::Model;
use heatwalk_surface::{Error, Result};

mod animal;
mod bodies;
mod figure;
mod horse;
mod implicit;
mod maze;
mod parametric;
mod robot;
mod skull;
mod solids;
mod terrain;
mod triceratops;
mod village;

pub use animal::animal;
pub use bodies::{high_genus, ring};
pub use horse::horse;
pub use maze::maze;
pub use parametric::{cylinder, grid, hemisphere, icosphere, strip, torus, uv_sphere};
pub use robot::robot;
pub use skull::skull;
pub use terrain::terrain;
pub use triceratops::triceratops;
pub use village::village;

const NAMES: [&str; 15] = [
    "animal",
    "robot",
    "horse",
    "triceratops",
    "skull",
    "maze",
    "high_genus",
    "ring",
    "hemisphere",
    "terrain",
    "village",
    "torus",
    "icosphere",
    "uv_sphere",
    "strip",
];
const NAMES_IN_WORDS: &str = "one of animal, robot, horse, triceratops, skull, maze, high_genus, ring, hemisphere, terrain, \
                              village, torus, icosphere, uv_sphere, strip";

/// The names that [`by_name`] takes.
pub fn names() -> &'static [&'static str] {
    &NAMES
}

/// A shape at its default resolution, 5,000 to 50,000 triangles.
///
/// # Errors
/// [`Error::BadParameter`] for a name that is not in [`names`].
pub fn by_name(name: &str) -> Result<Model> {
    let soup = match name {
        "animal" => animal(0.024),
        "robot" => return Ok(robot(0.036)),
        "horse" => horse(0.022),
        "triceratops" => triceratops(0.032),
        "skull" => skull(0.032),
        "maze" => maze(10, 6),
        "high_genus" => high_genus(0.065),
        "ring" => ring(0.034),
        "hemisphere" => hemisphere(48),
        "terrain" => terrain(128),
        "village" => village(),
        "torus" => torus(1.0, 0.4, 144, 60),
        "icosphere" => icosphere(5),
        "uv_sphere" => uv_sphere(96, 48),
        "strip" => strip(1.0, 40.0, 8),
        _ => {
            return Err(Error::BadParameter { name: "shape", value: name.to_owned(), range: NAMES_IN_WORDS });
        }
    };
    Ok(soup.into())
}
