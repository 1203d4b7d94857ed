//! Draws a surface with its distance stripes, pins, a path and a walker, with wgpu.
//!
//! The viewer takes plain arrays and knows no solver. A long-lived [`Renderer`] holds the pipelines; buffers live with
//! the mesh they belong to. Each primitive is one `.rs` and one `.wgsl` of the same name; `build.rs` puts
//! shaders together. Colours are linear light in the shading and sRGB outside. On wasm32 the class `Viewer` is the face
//! towards JavaScript.

mod appearance;
mod arrow;
mod background;
mod binding;
mod blended;
mod buffer;
mod camera;
mod canvas;
mod capture;
mod check;
mod color;
mod context;
mod curve;
mod cut;
mod environment;
mod error;
mod gait;
mod ground;
mod image;
mod inner;
mod inside;
mod lighting;
mod material;
mod mesh;
mod model;
mod patch;
mod pin;
mod pipeline;
mod planes;
mod pose;
mod punctual;
mod renderer;
mod section;
mod shader;
mod shadow;
mod shared;
mod shell;
mod solid;
mod style;
mod surface;
mod targets;
mod tint;
mod uniform;
mod vertex;
mod walker;
#[cfg(target_arch = "wasm32")]
mod web;
mod wire;

pub use appearance::{MeshAppearance, MeshRun};
pub use camera::{Camera, Eye, Insets, View};
pub use canvas::Canvas;
pub use capture::Capture;
pub use context::{Backend, Context};
pub use environment::Surroundings;
pub use error::Error;
pub use heatwalk_bake::{BoundingSphere, Hierarchy, Ray, Shade};
pub use image::Image;
pub use inner::InnerTriangles;
pub use material::{CHANNELS, Material, TextureUse};
pub use mesh::{MeshArrays, MeshPose};
pub use patch::PatchArrays;
pub use pose::{CrowdPose, Pose, Track};
pub use punctual::{MOST_PUNCTUAL, PunctualLight};
pub use renderer::{Renderer, SurfaceHit};
pub use section::SectionArrays;
pub use style::{Blend, Finish, Pattern, RAMP_SIZE, Style};
pub use surface::RAMP_BYTES;
