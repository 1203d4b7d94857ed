//! Isolines of a distance on a surface, the surface cut along them into strips, and strips unrolled into the plane.
//!
//! A [`Field`] is a surface with a value at each vertex, linear on each triangle; [`Field::refined`] divides triangles where the
//! distance that it stands for is not. [`Levels`] are the values whose isolines are
//! wanted; [`Isolines::trace`] finds the curves, [`Strips::cut`] the strips between them, [`Sheet::unroll`] their plane
//! shapes; [`Borders`] are those of cells, and [`decal`] lays an image on a surface. [`mod@write`]
//! makes files of curves.

mod area;
mod borders;
pub mod clip;
mod decal;
mod division;
mod error;
mod field;
mod isolines;
mod levels;
mod refine;
mod sheet;
mod strips;
mod unroll;
pub mod write;

pub use borders::{Borders, Tile};
pub use decal::{Patch, decal};
pub use division::Division;
pub use error::{Error, MAX_DEFECT, MOST_LEVELS, NotDevelopable, Result};
pub use field::{Field, is_continuous};
pub use isolines::{Curve, Isoline, Isolines, Kind, PathKind};
pub use levels::Levels;
pub use refine::{MOST_ROUNDS, Places, Refined, TRUE_TO};
pub use sheet::{Plane, Sheet};
pub use strips::Strips;
