//! Mesh files to and from bytes. Nothing here touches a file system: what a file refers to comes from the caller.
//!
//! Each format that can be read is a cargo feature: `3mf`, `freesurfer`, `gifti`, `gltf`, `obj`, `off`, `ply`, `stl`, `vtk`, all on by
//! default. `3mf` brings
//! archives along (`zip`). `unpack` reads meshes that are packed, too.

#![cfg_attr(
    not(all(
        feature = "3mf",
        feature = "freesurfer",
        feature = "gifti",
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
        unused_imports,
        unused_variables,
        reason = "each reader uses some of what they share"
    )
)]

#[cfg(feature = "zip")]
mod archive;
#[cfg(any(feature = "gifti", feature = "gltf", feature = "vtk"))]
mod base64;
mod budget;
mod color;
mod empty;
mod format;
#[cfg(feature = "freesurfer")]
mod freesurfer;
#[cfg(feature = "gifti")]
mod gifti;
#[cfg(feature = "gltf")]
mod gltf;
#[cfg(any(feature = "freesurfer", feature = "gifti"))]
pub mod labels;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
#[cfg(feature = "ply")]
mod ply;
mod reader;
#[cfg(any(feature = "gifti", feature = "ply", feature = "vtk"))]
mod scalar;
mod seams;
#[cfg(feature = "stl")]
mod stl;
pub mod text;
#[cfg(feature = "3mf")]
mod threemf;
#[cfg(any(feature = "obj", feature = "off", feature = "ply", feature = "vtk"))]
pub mod triangulate;
#[cfg(feature = "unpack")]
mod unpack;
#[cfg(feature = "vtk")]
pub mod vtk;
pub mod write;
#[cfg(any(feature = "3mf", feature = "gifti", feature = "vtk"))]
mod xml;

use format::Format;
use glam::DVec3;

use crate::error::{Error, Result};
use crate::model::Model;

#[cfg(feature = "zip")]
pub use archive::{Archive, MAGIC as ARCHIVE_MAGIC};
pub use budget::{Budget, Loan};
pub use empty::expect_mesh;
pub use reader::Resources;
#[cfg(feature = "unpack")]
pub use unpack::{Unpacked, has_extension, without_gz};

/// All formats, in the order in which bytes are asked whose they are.
const FORMATS: &[Format] = &[
    #[cfg(feature = "gltf")]
    gltf::FORMAT,
    #[cfg(feature = "ply")]
    ply::FORMAT,
    #[cfg(feature = "off")]
    off::FORMAT,
    #[cfg(feature = "3mf")]
    threemf::FORMAT,
    #[cfg(feature = "vtk")]
    vtk::FORMAT,
    #[cfg(feature = "gifti")]
    gifti::FORMAT,
    #[cfg(feature = "freesurfer")]
    freesurfer::FORMAT,
    #[cfg(feature = "stl")]
    stl::FORMAT,
    #[cfg(feature = "obj")]
    obj::FORMAT,
];

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
    let model = read_any_within(budget, name, bytes, resources)?;
    if model.soup.triangles.is_empty() { Err(empty::reason(name, &model.soup)) } else { Ok(model) }
}

/// As [`read_within`], or points alone of a file that holds no triangles but points: those that faces would be between.
///
/// # Errors
/// As [`read`].
pub fn read_mesh_or_points_within(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Model> {
    let model = read_any_within(budget, name, bytes, resources)?;
    let is_mesh_or_cloud = !model.soup.triangles.is_empty() || empty::is_cloud(&model.soup);
    if is_mesh_or_cloud { Ok(model) } else { Err(empty::reason(name, &model.soup)) }
}

fn read_any_within(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Model> {
    let model = read_format(budget, name, bytes, resources);
    // A reader may do without a part that it could not read.
    budget.finish()?;
    model
}

fn read_format(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Model> {
    let (stem, extension) = stem_and_extension(name);
    let bytes = text::decoded(bytes)?;
    expect_mesh(name, bytes)?;
    let format = format_of(bytes, extension).ok_or_else(|| unknown(name, extension))?;
    (format.read)(budget, stem, bytes, resources)
}

/// Reads labels of vertices: GIFTI by its first bytes, an annotation of FreeSurfer else.
///
/// # Errors
/// [`Error::Malformed`]; [`Error::Unsupported`] for several maps of labels in one file; [`Error::OverBudget`].
#[cfg(all(feature = "freesurfer", feature = "gifti"))]
pub fn read_labels(bytes: &[u8]) -> Result<labels::Labels> {
    let budget = Budget::of_file(bytes.len());
    let bytes = text::without_mark(bytes);
    if gifti::has_header(bytes) { gifti::labels(&budget, bytes) } else { freesurfer::read_annotation(&budget, bytes) }
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
    by_extension(extension).is_some()
}

/// What points up by the rules of the format of a file: Y in glTF, Z in 3MF, GIFTI and FreeSurfer. Other formats say nothing.
pub fn upward(name: &str, bytes: &[u8]) -> Option<DVec3> {
    let (_, extension) = stem_and_extension(name);
    format_of(text::without_mark(bytes), extension)?.upward
}

fn stem_and_extension(name: &str) -> (&str, &str) {
    let file_name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    file_name.rsplit_once('.').unwrap_or((file_name, ""))
}

/// By the first bytes where they tell, else by the extension.
fn format_of(bytes: &[u8], extension: &str) -> Option<&'static Format> {
    FORMATS.iter().find(|format| (format.is)(bytes)).or_else(|| by_extension(extension))
}

fn by_extension(extension: &str) -> Option<&'static Format> {
    let extension = extension.to_ascii_lowercase();
    FORMATS.iter().find(|format| format.extensions.contains(&extension.as_str()))
}
