//! The commands on tetrahedra.

mod commands;
mod distance;
mod input;

pub use commands::{info, path};
pub use distance::distance;
pub use input::Input;
