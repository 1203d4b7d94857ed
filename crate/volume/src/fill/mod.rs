//! Tetrahedra inside of any closed surface: isosurface stuffing ([Labelle & Shewchuk 2007](https://doi.org/10.1145/1276377.1276448))
//! over generalized winding numbers.
//!
//! Inside is where the surface winds around a point more than half a time, so that assemblies of overlapping parts, soups and
//! surfaces with small holes are filled, too.
//!
//! ```
//! use std::num::NonZeroUsize;
//! use heatwalk::{Surface, go_on};
//! use heatwalk_shapes::icosphere;
//! use heatwalk_volume::fill::{Resolution, Solid};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let soup = icosphere(3);
//! let solid = Solid::new(&soup, &Surface::build(&soup)?, NonZeroUsize::MIN)?;
//! println!("about {} tetrahedra", solid.estimate(Resolution::Cells(20.0))?.tetrahedra);
//! let filled = solid.fill(Resolution::Cells(20.0), &mut go_on)?;
//! let volume = filled.report.surface_volume.expect("it has no holes");
//! assert!((filled.report.volume / volume - 1.0).abs() < 0.01);
//! let [least, greatest] = filled.report.dihedral_angles;
//! assert!(least > 9.0 && greatest < 162.0, "degrees");
//! # Ok(())
//! # }
//! ```

mod error;
mod field;
mod hierarchy;
mod lattice;
mod orientation;
mod quality;
mod sample;
mod solid;
mod stencil;
mod stuffing;
mod triangle;

pub use error::{Error, Result};
pub use solid::{Estimate, FillReport, Filled, Resolution, Solid};
