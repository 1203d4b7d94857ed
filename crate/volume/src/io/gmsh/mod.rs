//! Gmsh (`.msh`; "Gmsh reference manual", sections "MSH file format" and "Legacy formats"): versions 2.0 to 2.2, 4.0 and 4.1, text
//! or bytes in either order. Sections other than nodes and elements are skipped.

mod element;
mod nodes;
mod section;

use self::nodes::Nodes;
use self::section::{Layout, Section};
use super::cells::{CellCounts, NamedCells};
use super::error::{Error, Result};
use super::input::{Encoding, Input};
use crate::soup::TetSoup;

const GMSH: &str = "Gmsh";

const HEADER: &[u8] = b"$MeshFormat";
/// Of version 1.
const OLD_HEADER: &[u8] = b"$NOD";

const TEXT: Encoding = Encoding::Text { comment: None };

pub fn has_header(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    start.starts_with(HEADER) || start.starts_with(OLD_HEADER)
}

pub fn read(bytes: &[u8]) -> Result<(TetSoup, CellCounts)> {
    let mut input = Input::new(GMSH, bytes, TEXT);
    let mut header = None;
    let (mut nodes, mut cells) = (Nodes::default(), NamedCells::default());
    while let Some(word) = input.word() {
        let Some(name) = word.strip_prefix('$').filter(|name| !name.starts_with("End")) else { continue };
        match (name, &header) {
            ("MeshFormat", _) => header = Some(Header::read(&mut input)?),
            ("NOD" | "ELM", _) => return Err(unsupported_version(&input, "1")),
            ("Nodes" | "Elements", None) => {
                return Err(input.damaged("the section $MeshFormat has to come before this one").into());
            }
            ("Nodes", Some(header)) => input = Section::new(input, header).nodes(&mut nodes)?,
            ("Elements", Some(header)) => input = Section::new(input, header).elements(&mut cells)?,
            _ => skip(&mut input, name),
        }
    }
    if header.is_none() {
        return Err(input.damaged("there is no section $MeshFormat").into());
    }
    let (positions, numbers) = nodes.finish()?;
    let cells = cells.finish(GMSH, |tag| numbers.get(tag))?;
    Ok(cells.into_soup(positions))
}

/// Goes on behind a section; where it does not end, at the end.
fn skip(input: &mut Input, section: &str) {
    let end = format!("$End{section}");
    let place = input.rest().windows(end.len()).position(|window| window == end.as_bytes());
    input.seek(place.map_or(usize::MAX, |place| input.position() + place + end.len()));
}

fn unsupported_version(input: &Input, version: &str) -> Error {
    input.unsupported(format!("version {version} of the format"), "save it as version 4.1 or 2.2").into()
}

/// What the first section tells.
struct Header {
    layout: Layout,
    encoding: Encoding,
    /// Whether sizes have eight bytes, not four.
    has_long_sizes: bool,
}

impl Header {
    fn read(input: &mut Input) -> Result<Self> {
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
