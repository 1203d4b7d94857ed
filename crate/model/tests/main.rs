//! The tests of the crate's public interface, in one program: each would be linked with all of it.

mod appearance;
mod brains;
mod gltf;
mod gltf_extensions;
mod io;
mod meshes;
mod obj;
mod odd;
#[cfg(feature = "packed")]
mod packed;
mod reading;
mod threemf;
mod vtk;
