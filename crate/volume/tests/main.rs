//! The tests of the crate's public interface, in one program: each would be linked with all of it.

mod common;
mod crowd;
mod depth;
mod fill;
mod heat;
mod io;
mod march;
mod mesh;
mod path;
mod riddled;
mod section;
mod shapes;
