//! What every part of the reader knows of glTF.

use gltf::json;

use crate::error::Result;
use crate::io::reader::Reporter;

/// The first bytes of a GLB file.
pub const GLB_MAGIC: &[u8] = b"glTF";

/// Some kilobytes of JSON can name one mesh thousands of times, and some of compressed data can describe millions of
/// vertices; beyond this many (1.6 GB as f64) we give up.
pub const MAX_VERTICES: usize = 1 << 26;

pub const GLTF: Reporter = Reporter("glTF");

/// The element of a top-level array that an index names.
pub fn element<'a, T>(elements: &'a [T], index: json::Index<T>, kind: &str) -> Result<&'a T> {
    let index = index.value();
    elements.get(index).ok_or_else(|| {
        GLTF.at(format!("{kind} {index}"), format!("there are only {} of them; export the file again", elements.len()))
    })
}
