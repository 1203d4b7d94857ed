//! Mesh files to and from bytes. Nothing here touches a file system: what a file refers to comes from the caller.
//!
//! Each format that can be read is a cargo feature: `3mf`, `gltf`, `obj`, `off`, `ply`, `stl`, `vtk`, all on by default. `3mf` brings
//! archives along (`zip`).

#![cfg_attr(
    not(all(
        feature = "3mf",
        feature = "gltf",
        feature = "obj",
        feature = "off",
        feature = "ply",
        feature = "stl",
        feature = "vtk"
    )),
    allow(
        dead_code,
        unreachable_code,
        unreachable_patterns,
        unused_variables,
        reason = "each reader uses some of what they share"
    )
)]

#[cfg(feature = "zip")]
mod archive;
#[cfg(any(feature = "gltf", feature = "vtk"))]
mod base64;
mod budget;
mod color;
mod empty;
#[cfg(feature = "gltf")]
mod gltf;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
#[cfg(feature = "ply")]
mod ply;
mod reader;
#[cfg(any(feature = "ply", feature = "vtk"))]
mod scalar;
mod seams;
#[cfg(feature = "stl")]
mod stl;
pub mod text;
#[cfg(feature = "3mf")]
mod threemf;
#[cfg(any(feature = "obj", feature = "off", feature = "ply", feature = "vtk"))]
pub mod triangulate;
#[cfg(feature = "vtk")]
pub mod vtk;
pub mod write;
#[cfg(any(feature = "3mf", feature = "vtk"))]
mod xml;

use glam::DVec3;

use crate::error::{Error, Result};
use crate::model::Model;

#[cfg(feature = "zip")]
pub use archive::{Archive, MAGIC as ARCHIVE_MAGIC};
pub use budget::{Budget, Loan};
pub use empty::expect_mesh;
pub use reader::Resources;

/// Reads a mesh. The first bytes tell the format where they can, the extension of `name` otherwise.
///
/// # Errors
/// [`Error::UnknownFormat`], [`Error::Malformed`], [`Error::Unsupported`], [`Error::MissingResource`],
/// [`Error::OverBudget`]; [`Error::Surface`] with `Empty` where the file holds no triangle, with `IndexOutOfRange` where one
/// names a missing vertex.
pub fn read(name: &str, bytes: &[u8], resources: Resources) -> Result<Model> {
    let budget = Budget::of_file(bytes.len());
    read_within(&budget, name, bytes, &|uri| budget.admit(resources(uri)?).ok())
}

/// As [`read`], with what is left of a budget. What `resources` gives is for the caller to count.
///
/// # Errors
/// As [`read`].
pub fn read_within(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Model> {
    let model = read_format(budget, name, bytes, resources);
    // A reader may do without a part that it could not read.
    budget.finish()?;
    model
}

fn read_format(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Model> {
    let (stem, extension) = stem_and_extension(name);
    let bytes = text::decoded(bytes)?;
    expect_mesh(name, bytes)?;
    let format = Format::of(bytes, extension).ok_or_else(|| unknown(name, extension))?;
    let model: Result<Model> = match format {
        #[cfg(feature = "gltf")]
        Format::Gltf => gltf::read(budget, bytes, resources),
        #[cfg(feature = "obj")]
        Format::Obj => obj::read(budget, stem, bytes, resources),
        #[cfg(feature = "off")]
        Format::Off => off::read(budget, stem, bytes).map(Model::from),
        #[cfg(feature = "ply")]
        Format::Ply => ply::read(budget, stem, bytes),
        #[cfg(feature = "stl")]
        Format::Stl => stl::read(budget, stem, bytes).map(Model::from),
        #[cfg(feature = "3mf")]
        Format::ThreeMf => threemf::read(budget, stem, bytes),
        #[cfg(feature = "vtk")]
        Format::Vtk => vtk::read(budget, stem, bytes).map(Model::from),
    };
    let model = model?;
    if model.soup.triangles.is_empty() {
        return Err(empty::reason(name, &model.soup));
    }
    Ok(model)
}

/// Converters read the formats that have no good reader in Rust.
fn unknown(name: &str, extension: &str) -> Error {
    let convert = |format: &'static str, program: &str| Error::Unsupported {
        format,
        feature: "this format".to_owned(),
        remedy: format!("convert {name} to GLB, in {program} or by `assimp export`"),
    };
    match extension.to_ascii_lowercase().as_str() {
        "fbx" => convert("FBX", "Blender"),
        "dae" => convert("COLLADA", "Blender up to version 4.5"),
        _ => Error::UnknownFormat { name: name.to_owned() },
    }
}

/// Whether the extension of a name is that of a format read here.
pub fn names_mesh(name: &str) -> bool {
    let (_, extension) = stem_and_extension(name);
    Format::of_extension(extension).is_some()
}

/// What points up by the rules of the format of a file: Y in glTF, Z in 3MF. Other formats say nothing.
pub fn upward(name: &str, bytes: &[u8]) -> Option<DVec3> {
    let (_, extension) = stem_and_extension(name);
    match Format::of(text::without_mark(bytes), extension)? {
        #[cfg(feature = "gltf")]
        Format::Gltf => Some(DVec3::Y),
        #[cfg(feature = "3mf")]
        Format::ThreeMf => Some(DVec3::Z),
        _ => None,
    }
}

fn stem_and_extension(name: &str) -> (&str, &str) {
    let file_name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    file_name.rsplit_once('.').unwrap_or((file_name, ""))
}

#[derive(Clone, Copy)]
enum Format {
    #[cfg(feature = "gltf")]
    Gltf,
    #[cfg(feature = "obj")]
    Obj,
    #[cfg(feature = "off")]
    Off,
    #[cfg(feature = "ply")]
    Ply,
    #[cfg(feature = "stl")]
    Stl,
    #[cfg(feature = "3mf")]
    ThreeMf,
    #[cfg(feature = "vtk")]
    Vtk,
}

impl Format {
    /// By the first bytes where they tell, else by the extension.
    fn of(bytes: &[u8], extension: &str) -> Option<Self> {
        Self::of_bytes(bytes).or_else(|| Self::of_extension(extension))
    }

    fn of_bytes(bytes: &[u8]) -> Option<Self> {
        #[cfg(feature = "gltf")]
        if bytes.starts_with(gltf::GLB_MAGIC) || looks_like_gltf_json(bytes) {
            return Some(Self::Gltf);
        }
        #[cfg(feature = "ply")]
        if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
            return Some(Self::Ply);
        }
        #[cfg(feature = "off")]
        if off::has_keyword(bytes) {
            return Some(Self::Off);
        }
        #[cfg(feature = "3mf")]
        if bytes.starts_with(archive::MAGIC) {
            return Some(Self::ThreeMf);
        }
        #[cfg(feature = "vtk")]
        if vtk::has_header(bytes) {
            return Some(Self::Vtk);
        }
        #[cfg(feature = "stl")]
        if stl::is_binary(bytes) || stl::is_ascii(bytes) {
            return Some(Self::Stl);
        }
        None
    }

    fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            #[cfg(feature = "gltf")]
            "gltf" | "glb" => Some(Self::Gltf),
            #[cfg(feature = "obj")]
            "obj" => Some(Self::Obj),
            #[cfg(feature = "off")]
            "off" | "coff" | "noff" => Some(Self::Off),
            #[cfg(feature = "ply")]
            "ply" => Some(Self::Ply),
            #[cfg(feature = "stl")]
            "stl" => Some(Self::Stl),
            #[cfg(feature = "3mf")]
            "3mf" => Some(Self::ThreeMf),
            #[cfg(feature = "vtk")]
            "vtk" | "vtp" | "vtu" => Some(Self::Vtk),
            _ => None,
        }
    }
}

#[cfg(feature = "gltf")]
fn looks_like_gltf_json(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.starts_with(b"{") && text.windows(7).any(|window| window == b"\"asset\"")
}
