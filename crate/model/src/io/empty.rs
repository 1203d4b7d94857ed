//! Files without a mesh, and why there is none.

use heatwalk_surface::{Soup, WarningCode};

use crate::error::{Error, Result};

/// What a repository holds in the place of a large file.
const LFS_POINTER: &[u8] = b"version https://git-lfs.github.com/spec/";

/// Refuses what stands in the place of a mesh file: nothing, the pointer of Git LFS, a web page.
///
/// # Errors
/// [`Error::Surface`] with `Empty` where there is nothing but white space; [`Error::Malformed`].
pub fn expect_mesh(name: &str, bytes: &[u8]) -> Result<()> {
    let instead = |format: &'static str, problem: &str| {
        Err(Error::Malformed { format, place: name.to_owned(), problem: problem.to_owned() })
    };
    let start = bytes.trim_ascii_start();
    let begins = |word: &[u8]| start.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
    if start.is_empty() {
        return Err(Error::empty(format!("{name} is empty: nothing is in it; save or copy it again")));
    }
    if start.starts_with(LFS_POINTER) {
        return instead("Git LFS", "this is a pointer to the mesh, not the mesh; fetch it by `git lfs pull`");
    }
    if begins(b"<!doctype html") || begins(b"<html") {
        return instead("HTML", "this is a web page, not a mesh; download the file itself");
    }
    Ok(())
}

/// Whether a soup without triangles is points that a surface can be made of: not those that steer curves and surfaces of free form.
pub fn is_cloud(soup: &Soup) -> bool {
    let is_beside = |code| matches!(code, WarningCode::LinesLeftOut | WarningCode::NoEnd | WarningCode::Trailing);
    !soup.positions.is_empty() && soup.warnings.iter().all(|warning| is_beside(warning.code))
}

/// Why a file that was read holds no triangle: what was left out, or what there is instead.
pub fn reason(name: &str, soup: &Soup) -> Error {
    let left_out: Vec<String> = soup.warnings.iter().map(|warning| warning.what()).collect();
    let reason = match (soup.positions.len(), left_out.is_empty()) {
        (_, false) => format!("{name} holds no faces: {}", left_out.join("; ")),
        (0, true) => format!("{name} has a header and nothing else: neither vertices nor faces; save it again"),
        (1, true) => format!("{name} is a single point without faces; a surface has triangles"),
        (vertices, true) => {
            format!("{name} is a cloud of {vertices} points without faces; make a surface of it first")
        }
    };
    Error::empty(reason)
}
