//! Annotations (`.annot`): a color for each vertex, and a table of what colors mean, of version 1 or 2.

use std::collections::HashMap;

use super::bytes::{Bytes, FREESURFER};
use crate::error::Result;
use crate::io::budget::Budget;
use crate::io::labels::Labels;

pub fn read(budget: &Budget, bytes: &[u8]) -> Result<Labels> {
    let mut bytes = Bytes::new(bytes);
    let count = bytes.count()?;
    bytes.require(count.into(), 8)?;
    let mut colors = budget.list(count as usize)?;
    colors.resize(count as usize, 0);
    for _ in 0..count {
        let place = bytes.place();
        let vertex = bytes.count()?;
        let color = i32::from_be_bytes(bytes.take()?);
        let Some(own) = colors.get_mut(vertex as usize) else {
            return Err(FREESURFER.no_vertex(format!("byte {place}"), vertex.into(), count as usize, 0));
        };
        *own = color;
    }
    let table = table(budget, &mut bytes)?;
    let mut labels = Labels { names: Vec::new(), of_vertices: budget.list(colors.len())? };
    let mut label_of_color = HashMap::new();
    for (color, name) in table {
        label_of_color.entry(color).or_insert(labels.names.len() as u32);
        labels.names.push(name);
    }
    labels.of_vertices.extend(colors.iter().map(|color| label_of_color.get(color).copied()));
    Ok(labels)
}

/// Colors, as vertices have them, and names.
fn table(budget: &Budget, bytes: &mut Bytes) -> Result<Vec<(i32, String)>> {
    let none = |place: usize| {
        FREESURFER.at(format!("byte {place}"), "the annotation has no table of names; save it with its colors")
    };
    let place = bytes.place();
    if !matches!(bytes.count(), Ok(1)) {
        return Err(none(place));
    }
    let first = i32::from_be_bytes(bytes.take()?);
    // A negative number is that of the version; entries then have numbers, of which the largest comes first.
    let is_numbered = first < 0;
    let entries = if is_numbered { bytes.count()? } else { first.unsigned_abs() };
    let length = bytes.count()?;
    bytes.text(length)?;
    let entries = if is_numbered { bytes.count()? } else { entries };
    bytes.require(entries.into(), 20)?;
    let mut table = Vec::new();
    for _ in 0..entries {
        if is_numbered {
            bytes.count()?;
        }
        let length = bytes.count()?;
        let name = bytes.text(length)?;
        let [red, green, blue, _] = [bytes.count()?, bytes.count()?, bytes.count()?, bytes.count()?];
        let color = red.wrapping_add(green.wrapping_mul(1 << 8)).wrapping_add(blue.wrapping_mul(1 << 16));
        budget.push(&mut table, (color as i32, name))?;
    }
    if table.is_empty() { Err(none(place)) } else { Ok(table) }
}
