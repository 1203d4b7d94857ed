//! What a file says of itself.

use crate::io::error::{Error, Result};
use crate::io::input::{Encoding, Input};

pub const GMSH: &str = "Gmsh";

/// Between sections, and in all of a text file.
pub const TEXT: Encoding = Encoding::Text { comment: None };

/// How a version lays out nodes and elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// Of versions 2: each row with its number.
    Rows,
    /// Of version 4.0: blocks of rows, each row with its number.
    TaggedBlocks,
    /// Of version 4.1: blocks of rows, the numbers of nodes before their places.
    Blocks,
}

pub fn unsupported_version(input: &Input, version: &str) -> Error {
    let version = if version.is_empty() { "?" } else { version };
    input.unsupported(format!("version {version} of the format"), "save it as version 4.1 or 2.2").into()
}

/// What the first section tells.
pub struct Header {
    pub layout: Layout,
    pub encoding: Encoding,
    /// Whether sizes have eight bytes, not four.
    pub has_long_sizes: bool,
}

impl Header {
    pub fn read(input: &mut Input) -> Result<Self> {
        let version = input.word().unwrap_or_default();
        let layout = match version {
            "2" | "2.0" | "2.1" | "2.2" => Layout::Rows,
            "4" | "4.0" => Layout::TaggedBlocks,
            "4.1" => Layout::Blocks,
            _ => return Err(unsupported_version(input, version)),
        };
        let is_binary = match input.int("0 for text or 1 for bytes")? {
            0 => false,
            1 => true,
            other => return Err(input.damaged(&format!("0 or 1 is expected, but {other} is found")).into()),
        };
        let has_long_sizes = match input.int("the size of numbers")? {
            8 => true,
            4 => false,
            other => return Err(input.damaged(&format!("numbers of {other} bytes are not known")).into()),
        };
        if !is_binary {
            return Ok(Self { layout, encoding: TEXT, has_long_sizes });
        }
        input.line();
        let is_little = match input.rest().first_chunk::<4>() {
            Some(&one) if one == 1_i32.to_le_bytes() => true,
            Some(&one) if one == 1_i32.to_be_bytes() => false,
            _ => return Err(input.damaged("the number 1 is expected, which tells the order of bytes").into()),
        };
        input.seek(input.position() + size_of::<i32>());
        Ok(Self { layout, encoding: Encoding::Binary { is_little }, has_long_sizes })
    }
}
