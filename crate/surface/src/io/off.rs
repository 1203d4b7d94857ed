//! Object File Format (Geomview): `[ST][C][N][4]OFF`, ASCII.

use glam::DVec3;

use super::budget::Budget;
use super::reader::Reporter;
use super::triangulate::Polygons;
use crate::error::{Error, Result};
use crate::soup::Soup;

const OFF: Reporter = Reporter("OFF");

/// Whether the first word is an OFF header.
pub fn has_keyword(bytes: &[u8]) -> bool {
    let line = bytes.split(|byte| byte.is_ascii_whitespace()).next().unwrap_or_default();
    // Some exporters write the first count against the keyword: "OFF2904 5804 0".
    let end = line.iter().rposition(|byte| !byte.is_ascii_digit()).map_or(0, |last| last + 1);
    std::str::from_utf8(&line[..end]).is_ok_and(|word| Header::parse(word).is_some())
}

/// What the keyword says of a vertex line. Normals, colours and texture coordinates follow the position.
struct Header {
    homogeneous: bool,
}

impl Header {
    fn parse(word: &str) -> Option<Self> {
        let rest = word.strip_prefix("ST").unwrap_or(word);
        let rest = rest.strip_prefix('C').unwrap_or(rest);
        let rest = rest.strip_prefix('N').unwrap_or(rest);
        let (homogeneous, rest) = rest.strip_prefix('4').map_or((false, rest), |rest| (true, rest));
        (rest == "OFF").then_some(Self { homogeneous })
    }
}

pub fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = text
        .lines()
        .enumerate()
        .map(|(index, line)| (index + 1, line.split('#').next().unwrap_or_default().trim()))
        .filter(|(_, line)| !line.is_empty());
    let ends = |what: &str| OFF.at("end of file", format!("{what}; the file is cut short, save it again"));

    let (number, first) = lines.next().ok_or_else(|| ends("there is no header"))?;
    let keyword_end = first.find("OFF").map_or(0, |start| start + 3);
    let (keyword, rest) = first.split_at(keyword_end);
    // The keyword is optional in the format.
    let header = if keyword.is_empty() { Some(Header { homogeneous: false }) } else { Header::parse(keyword) }
        .ok_or_else(|| OFF.line(number, format!("{keyword:?} is not an OFF header; save it as plain OFF")))?;
    if rest.trim_start().starts_with("BINARY") {
        return Err(Error::Unsupported {
            format: "OFF",
            feature: "binary OFF".to_owned(),
            remedy: "save it as ASCII OFF or binary PLY".to_owned(),
        });
    }
    let (number, counts) =
        if rest.trim().is_empty() { lines.next().ok_or_else(|| ends("there are no counts"))? } else { (number, rest) };
    let mut counts = counts.split_whitespace().map(str::parse::<u64>);
    let (Some(Ok(vertices)), Some(Ok(faces))) = (counts.next(), counts.next()) else {
        return Err(OFF.line(number, "expected the numbers of vertices and faces"));
    };

    let least = if header.homogeneous { 4 } else { 3 };
    // A line takes at least two bytes a number, so a count beyond that is a lie and must not be reserved.
    let mut positions = budget.list((bytes.len() / 6).min(vertices as usize))?;
    while (positions.len() as u64) < vertices {
        let Some((number, line)) = lines.next() else {
            return Err(ends(&format!("{} of {vertices} vertices are missing", vertices - positions.len() as u64)));
        };
        let mut coordinates = [0.0, 0.0, 0.0, 1.0];
        let mut words = line.split_whitespace();
        for coordinate in &mut coordinates[..least] {
            *coordinate = words.next().and_then(|word| word.parse().ok()).ok_or_else(|| {
                OFF.line(number, format!("vertex {} needs {least} numbers; correct the line", positions.len()))
            })?;
        }
        let [x, y, z, w] = coordinates;
        budget.push(&mut positions, DVec3::new(x, y, z) / w)?;
    }

    let mut polygons = Polygons::new(budget);
    for face in 0..faces {
        let Some((number, line)) = lines.next() else {
            return Err(ends(&format!("{} of {faces} faces are missing", faces - face)));
        };
        let mut words = line.split_whitespace().map(str::parse::<u64>);
        let Some(Ok(corners)) = words.next() else {
            return Err(OFF.line(number, format!("face {face} must begin with its number of corners")));
        };
        for corner in 0..corners {
            let Some(Ok(vertex)) = words.next() else {
                return Err(
                    OFF.line(number, format!("corner {corner} of face {face} is not a vertex index; correct the line"))
                );
            };
            polygons.corner(vertex, positions.len())?;
        }
        polygons.close()?;
    }
    let triangles = polygons.triangulate_all(&positions)?;
    Ok(Soup::single(name, positions, triangles))
}
