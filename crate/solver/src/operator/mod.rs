//! The discrete operators of a surface: what a metric gives. They are made of triangles with the lengths of their sides, so
//! that any metric that has lengths will do.

mod connection;
pub(crate) mod elements;
mod flips;
mod frames;
pub mod intrinsic;
pub mod laplacian;
mod metric;
mod relocate;
mod waiting;

pub use connection::ConnectionLaplacian;
pub use flips::Flips;
pub use frames::{Frames, TangentPlane};
pub use laplacian::{Discretization, Laplacian};
pub use metric::Operators;
