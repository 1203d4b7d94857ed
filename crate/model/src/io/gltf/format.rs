//! What every part of the reader knows of glTF.

use gltf::json;

use crate::error::Result;
use crate::io::reader::Reporter;

/// The first bytes of a GLB file.
pub const GLB_MAGIC: &[u8] = b"glTF";

pub const GLTF: Reporter = Reporter("glTF");

/// The element of a top-level array that an index names.
pub fn element<'a, T>(elements: &'a [T], index: json::Index<T>, kind: &str) -> Result<&'a T> {
    let index = index.value();
    elements.get(index).ok_or_else(|| {
        GLTF.at(format!("{kind} {index}"), format!("there are only {} of them; export the file again", elements.len()))
    })
}
