//! Distance and paths inside of tetrahedral meshes.
//!
//! A [`TetSoup`] is what a file holds, or what fills a closed surface.

mod soup;

pub use soup::TetSoup;
