//! Gmsh (`.msh`; "Gmsh reference manual", sections "MSH file format" and "Legacy formats"): versions 2.0 to 2.2, 4.0 and 4.1, text
//! or bytes in either order. Sections other than nodes and elements are skipped.

mod element;
mod format;
mod nodes;
mod section;

use heatwalk_model::io::Budget;

use self::format::{GMSH, Header, TEXT, unsupported_version};
use self::nodes::Nodes;
use self::section::Section;
use super::cells::{NamedCells, NamedMesh};
use super::error::Result;
use super::input::Input;

const HEADER: &[u8] = b"$MeshFormat";
/// Of version 1.
const OLD_HEADER: &[u8] = b"$NOD";

pub fn has_header(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    start.starts_with(HEADER) || start.starts_with(OLD_HEADER)
}

pub fn read<'a>(budget: &'a Budget, bytes: &[u8]) -> Result<NamedMesh<'a>> {
    let mut input = Input::new(GMSH, bytes, TEXT);
    let mut header = None;
    let (mut nodes, mut cells) = (Nodes::new(budget), NamedCells::new(budget));
    while let Some(word) = input.word() {
        let Some(name) = word.strip_prefix('$').filter(|name| !name.starts_with("End")) else { continue };
        match (name, &header) {
            ("MeshFormat", _) => header = Some(Header::read(&mut input)?),
            ("NOD" | "ELM", _) => return Err(unsupported_version(&input, "1")),
            ("Nodes" | "ParametricNodes" | "Elements", None) => {
                return Err(input.damaged("the section $MeshFormat has to come before this one").into());
            }
            ("Nodes" | "ParametricNodes", Some(header)) => {
                input = Section::new(input, header).nodes(&mut nodes, name == "ParametricNodes")?;
            }
            ("Elements", Some(header)) => input = Section::new(input, header).elements(&mut cells)?,
            _ => skip(&mut input, name),
        }
    }
    if header.is_none() {
        return Err(input.damaged("there is no section $MeshFormat").into());
    }
    let (positions, numbers) = nodes.finish()?;
    Ok(NamedMesh { format: GMSH, positions, numbers, cells })
}

/// Goes on behind a section; where it does not end, at the end.
fn skip(input: &mut Input, section: &str) {
    let end = format!("$End{section}");
    let place = input.rest().windows(end.len()).position(|window| window == end.as_bytes());
    input.seek(place.map_or(usize::MAX, |place| input.position() + place + end.len()));
}
