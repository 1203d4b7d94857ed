//! STL, ASCII and binary. Every triangle brings its own three vertices; welding is the surface builder's work.

use glam::DVec3;

use super::budget::Budget;
use super::reader::Reporter;
use crate::error::Result;
use crate::soup::Soup;

const STL: Reporter = Reporter("STL");
/// 80 bytes of free text and the number of triangles.
const HEADER: usize = 84;
/// Normal, three corners (12 × f32) and two bytes of attributes.
const RECORD: usize = 50;

fn binary_count(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(80..HEADER)?;
    Some(u32::from_le_bytes([count[0], count[1], count[2], count[3]]) as usize)
}

/// Whether the length is exactly what the count in a binary header asks for. Such a file may well begin with "solid".
pub fn is_binary(bytes: &[u8]) -> bool {
    binary_count(bytes).is_some_and(|count| count > 0 && count.checked_mul(RECORD) == Some(bytes.len() - HEADER))
}

/// Whether the file begins as ASCII STL does.
pub fn is_ascii(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(1024)];
    let has = |word: &[u8]| start.windows(word.len()).any(|window| window.eq_ignore_ascii_case(word));
    start.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
        && (has(b"facet") || has(b"endsolid"))
}

pub fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    if !is_binary(bytes) && is_ascii(bytes) {
        read_ascii(budget, name, bytes)
    } else {
        read_binary(budget, name, bytes)
    }
}

fn read_binary(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    let truncated = |problem: String| STL.at(format!("byte {}", bytes.len()), problem);
    let count = binary_count(bytes)
        .ok_or_else(|| truncated("the file is shorter than an STL header; save it again".to_owned()))?;
    let records = bytes[HEADER..].chunks_exact(RECORD);
    if records.len() < count {
        return Err(truncated(format!("{} of {count} triangles are missing; save it again", count - records.len())));
    }
    let mut positions = budget.list(3 * count)?;
    for record in records.take(count) {
        for corner in record[12..48].chunks_exact(12) {
            let coordinate =
                |i: usize| f64::from(f32::from_le_bytes([corner[i], corner[i + 1], corner[i + 2], corner[i + 3]]));
            positions.push(DVec3::new(coordinate(0), coordinate(4), coordinate(8)));
        }
    }
    budget.take_items::<[u32; 3]>(count)?;
    let triangles = (0..count as u32).map(|triangle| [0, 1, 2].map(|corner| 3 * triangle + corner)).collect();
    Ok(Soup::single(name, positions, triangles))
}

fn read_ascii(budget: &Budget, file: &str, bytes: &[u8]) -> Result<Soup> {
    let text = String::from_utf8_lossy(bytes);
    let mut soup = Soup::default();
    let mut name = file;
    let mut corners: Vec<DVec3> = Vec::new();
    let mut complete = true;
    for (index, line) in text.lines().enumerate() {
        let number = index + 1;
        let (keyword, arguments) = line.trim().split_once(char::is_whitespace).unwrap_or((line.trim(), ""));
        match keyword.to_ascii_lowercase().as_str() {
            "solid" => {
                soup.end_part(name);
                name = if arguments.trim().is_empty() { file } else { arguments.trim() };
            }
            "facet" => {
                corners.clear();
                complete = false;
            }
            "vertex" => budget.push(&mut corners, STL.vertex(arguments, number)?)?,
            "endfacet" => {
                if corners.len() != 3 {
                    return Err(STL.line(number, format!("a facet has {} corners instead of 3", corners.len())));
                }
                let first = soup.positions.len() as u32;
                budget.push(&mut soup.triangles, [first, first + 1, first + 2])?;
                budget.reserve(&mut soup.positions, corners.len())?;
                soup.positions.append(&mut corners);
                complete = true;
            }
            _ => {}
        }
    }
    if !complete {
        return Err(STL.at("end of file", "the last facet is cut short; save the file again"));
    }
    soup.end_part(name);
    Ok(soup)
}
