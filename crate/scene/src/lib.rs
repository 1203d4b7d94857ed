//! What pictures of surfaces need, and the solver does not: [shapes] made in code, [vertices to draw](drawing),
//! [lines of the mesh](overlay), a [crowd] of walkers.

pub mod crowd;
pub mod drawing;
pub mod overlay;
mod random;
pub mod shapes;

pub use crowd::{Crowd, Walker};
pub use drawing::{DrawMesh, draw_mesh};
