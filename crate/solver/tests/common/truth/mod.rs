//! Right distances on small meshes.

pub mod brute_force;
mod double_double;
