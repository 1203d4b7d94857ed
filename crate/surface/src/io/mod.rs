//! Mesh files to and from bytes. Nothing here touches a file system: what a file refers to comes from the caller.

mod gltf;
mod obj;
mod off;
mod ply;
mod stl;
mod triangulate;
pub mod write;

use glam::DVec3;

use crate::error::{Error, Result};
use crate::soup::Soup;

/// Gives the bytes of a file that the mesh refers to (percent-decoded relative URI), if there are any.
pub type Resources<'a> = &'a dyn Fn(&str) -> Option<Vec<u8>>;

/// Reads a mesh. The first bytes tell the format where they can, the extension of `name` otherwise.
///
/// # Errors
/// [`Error::UnknownFormat`], [`Error::Malformed`], [`Error::Unsupported`], [`Error::MissingResource`],
/// [`Error::IndexOutOfRange`], and [`Error::Empty`] where the file holds no triangle.
pub fn read(name: &str, bytes: &[u8], resources: Resources) -> Result<Soup> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let file_name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let (stem, extension) = file_name.rsplit_once('.').unwrap_or((file_name, ""));
    let format = Format::of_bytes(bytes)
        .or_else(|| Format::of_extension(extension))
        .ok_or_else(|| Error::UnknownFormat { name: name.to_owned() })?;
    let soup = match format {
        Format::Gltf => gltf::read(bytes, resources),
        Format::Obj => obj::read(stem, bytes),
        Format::Off => off::read(stem, bytes),
        Format::Ply => ply::read(stem, bytes),
        Format::Stl => stl::read(stem, bytes),
    }?;
    if soup.triangles.is_empty() {
        return Err(Error::Empty { reason: format!("{name} holds no faces; points and lines are not surfaces") });
    }
    Ok(soup)
}

#[derive(Clone, Copy)]
enum Format {
    Gltf,
    Obj,
    Off,
    Ply,
    Stl,
}

impl Format {
    fn of_bytes(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(gltf::GLB_MAGIC) || looks_like_gltf_json(bytes) {
            Some(Self::Gltf)
        } else if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
            Some(Self::Ply)
        } else if off::has_keyword(bytes) {
            Some(Self::Off)
        } else if stl::is_binary(bytes) || stl::is_ascii(bytes) {
            Some(Self::Stl)
        } else {
            None
        }
    }

    fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "gltf" | "glb" => Some(Self::Gltf),
            "obj" => Some(Self::Obj),
            "off" | "coff" | "noff" => Some(Self::Off),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            _ => None,
        }
    }
}

fn looks_like_gltf_json(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.starts_with(b"{") && text.windows(7).any(|window| window == b"\"asset\"")
}

/// How each reader says that its format is broken.
struct Reporter(&'static str);

impl Reporter {
    fn at(&self, place: impl Into<String>, problem: impl Into<String>) -> Error {
        Error::Malformed { format: self.0, place: place.into(), problem: problem.into() }
    }

    fn line(&self, number: usize, problem: impl Into<String>) -> Error {
        self.at(format!("line {number}"), problem)
    }

    /// The position on a vertex line, what follows it ignored.
    fn vertex(&self, arguments: &str, line: usize) -> Result<DVec3> {
        let mut words = arguments.split_whitespace();
        let mut coordinates = [0.0; 3];
        for coordinate in &mut coordinates {
            *coordinate = words
                .next()
                .and_then(|word| word.parse().ok())
                .ok_or_else(|| self.line(line, "a vertex needs three numbers; correct the line"))?;
        }
        Ok(coordinates.into())
    }
}
