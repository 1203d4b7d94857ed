//! Distance and paths inside of tetrahedral meshes.
//!
//! A [`TetSoup`] is what a file holds, or what fills a closed surface.

pub mod fill;
pub mod io;
mod soup;

pub use soup::TetSoup;
