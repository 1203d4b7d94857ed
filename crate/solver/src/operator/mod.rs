//! The discrete operators of a surface: what a metric gives. They are made of triangles with the lengths of their sides, so
//! that any metric that has lengths will do.

pub(crate) mod elements;
pub mod intrinsic;
pub mod laplacian;
mod metric;
mod relocate;

pub use laplacian::{Discretization, Laplacian};
pub use metric::Operators;
