//! What is found out about triangles before they are drawn: [bounds](BoundingSphere), a [hierarchy](Hierarchy) for [picking](Picker),
//! and what they keep off the [light](Shade). The worker makes it and the viewer uses it; it knows neither the solver nor a
//! graphics device.

mod bounding_sphere;
mod contact;
mod hierarchy;
mod occlusion;
mod pick;
mod ray;
mod scatter;
mod shade;

pub use bounding_sphere::BoundingSphere;
pub use contact::{CONTACT_SIZE, Floor};
pub use hierarchy::{Corners, Hierarchy};
pub use occlusion::{Cube, OCCLUSION_SIZE};
pub use pick::{Picker, cast_at_all};
pub use ray::{Hit, Ray};
pub use shade::Shade;
