//! The commands on tetrahedra.

mod commands;
mod input;

pub use commands::{distance, info, path};
pub use input::Input;
