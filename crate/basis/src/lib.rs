//! Decodes Basis Universal images in KTX 2.0 files, as glTF's `KHR_texture_basisu` has them: ETC1S with BasisLZ, UASTC plain or
//! packed by Zstandard. Texels come as they are stored, in sRGB or linear: what a material uses them for says which.

mod container;
mod error;
mod image;
#[cfg(target_arch = "wasm32")]
mod web;

pub use error::Error;
pub use image::{Image, LARGEST_SIDE, decode};
