//! What is found out about triangles before they are drawn: [bounds](Bounds), a [hierarchy](Hierarchy) for [picking](Picker),
//! and what they keep off the [light](Shade). The worker makes it and the viewer uses it; it knows neither the solver nor a
//! graphics device.

mod bounds;
mod contact;
mod hierarchy;
mod occlusion;
mod pick;
mod ray;
mod scatter;
mod shade;

pub use bounds::Bounds;
pub use contact::{CONTACT_SIZE, Floor};
pub use hierarchy::{Corners, Hierarchy};
pub use occlusion::{Cube, OCCLUSION_SIZE};
pub use pick::{Picker, cast_at_all};
pub use ray::{Hit, Ray};
pub use shade::Shade;
