//! VTK (Kitware, "VTK File Formats"): the surfaces of polygonal data and unstructured grids, in legacy files (`.vtk`), ASCII or
//! binary, and in XML files (`.vtp`, `.vtu`), ASCII, base64 or appended, compressed by zlib or not. Of curved cells the corners are
//! read.

mod array;
mod base64;
mod document;
mod legacy;
mod piece;

use crate::error::{Error, Result};
use crate::soup::Soup;

/// Whether the file begins as one of either kind does.
pub fn has_header(bytes: &[u8]) -> bool {
    legacy::has_header(bytes) || document::has_header(bytes)
}

pub fn read(name: &str, bytes: &[u8]) -> Result<Soup> {
    let pieces = if document::has_header(bytes) { document::read(bytes)? } else { vec![legacy::read(bytes)?] };
    let mut soup = Soup::default();
    let (count, has_volumes) = (pieces.len(), pieces.iter().any(|piece| piece.has_volumes));
    for (index, piece) in pieces.into_iter().enumerate() {
        let first = soup.positions.len() as u32;
        let triangles = piece.faces.triangulate_all(&piece.positions)?;
        soup.triangles.extend(triangles.into_iter().map(|corners| corners.map(|vertex| first + vertex)));
        soup.positions.extend(piece.positions);
        soup.end_part(if count == 1 { name.to_owned() } else { format!("{name} {index}") });
    }
    if soup.triangles.is_empty() && has_volumes {
        return Err(Error::Unsupported {
            format: "VTK",
            feature: "a mesh whose cells are no faces (tetrahedra, hexahedra, ...)".to_owned(),
            remedy: "extract its surface and save that".to_owned(),
        });
    }
    Ok(soup)
}
