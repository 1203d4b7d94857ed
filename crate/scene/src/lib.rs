//! What pictures of surfaces need, and the solver does not: [vertices to draw](drawing), [lines of the mesh](overlay), [poses](posing) of
//! both, a [crowd] of walkers, [agents] that make way for each other, and the [transform](DrawTransform) to what is drawn.

pub mod agents;
pub mod crowd;
pub mod drawing;
mod flow;
mod footing;
mod lights;
pub mod overlay;
pub mod posing;
mod transform;
mod upright;

pub use agents::{Agent, Agents, Obstacle};
pub use crowd::{Crowd, Walker};
pub use drawing::{DrawMesh, draw_mesh};
pub use lights::light_rows;
pub use posing::{DrawPose, Posing};
pub use transform::DrawTransform;
pub use upright::upright;
