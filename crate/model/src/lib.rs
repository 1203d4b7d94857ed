//! Models: what mesh files hold. The triangles, which `heatwalk-surface` makes a surface of, how they look and move, cameras and
//! lights; readers and writers.
//!
//! File bytes → [`read`](io::read) → [`Model`], whose [`soup`](Model::soup) is what distance is measured on.

pub mod appearance;
mod camera;
mod error;
pub mod io;
mod light;
mod model;
pub mod motion;

pub use appearance::Appearance;
pub use camera::{Camera, Projection};
pub use error::{Error, Result};
pub use light::{Light, LightKind};
pub use model::Model;
pub use motion::Motion;
