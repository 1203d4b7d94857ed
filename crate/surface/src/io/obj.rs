//! Wavefront OBJ: vertices, polygons, objects and groups. Materials, normals and texture coordinates are not geometry.

use std::borrow::Cow;
use std::collections::HashMap;

use glam::DVec3;

use super::reader::Reporter;
use super::triangulate::Polygons;
use crate::error::Result;
use crate::soup::Soup;

const OBJ: Reporter = Reporter("OBJ");

/// Parts by object and group; a name met again continues its part.
struct Groups {
    names: Vec<String>,
    by_key: HashMap<(String, String), usize>,
    object: String,
    current: usize,
}

impl Groups {
    fn new(file: &str) -> Self {
        let by_key = HashMap::from([((String::new(), String::new()), 0)]);
        Self { names: vec![file.to_owned()], by_key, object: String::new(), current: 0 }
    }

    fn open(&mut self, object: &str, group: &str) {
        self.object = object.to_owned();
        let name = if group.is_empty() { object } else { group };
        let next = self.names.len();
        self.current = *self.by_key.entry((object.to_owned(), group.to_owned())).or_insert(next);
        if self.current == next {
            self.names.push(name.to_owned());
        }
    }
}

pub fn read(name: &str, bytes: &[u8]) -> Result<Soup> {
    let text = String::from_utf8_lossy(bytes);
    let mut positions: Vec<DVec3> = Vec::new();
    let mut polygons = Polygons::default();
    let mut part_of_polygon = Vec::new();
    let mut groups = Groups::new(name);
    let mut lines = text.lines().enumerate();
    while let Some((index, line)) = lines.next() {
        let number = index + 1;
        let mut line = Cow::Borrowed(line);
        while let Some(head) = line.strip_suffix('\\') {
            let tail = lines.next().map_or("", |(_, tail)| tail);
            line = Cow::Owned(format!("{head} {tail}"));
        }
        let statement = line.split('#').next().unwrap_or_default().trim();
        let (keyword, arguments) = statement.split_once(char::is_whitespace).unwrap_or((statement, ""));
        match keyword {
            "v" => positions.push(OBJ.vertex(arguments, number)?),
            "f" => {
                for word in arguments.split_whitespace() {
                    polygons.corner(corner(word, number, positions.len())?, positions.len())?;
                }
                polygons.close();
                part_of_polygon.push(groups.current);
            }
            "o" => groups.open(arguments.trim(), ""),
            "g" => {
                let object = std::mem::take(&mut groups.object);
                groups.open(&object, arguments.trim());
            }
            _ => {}
        }
    }
    assemble(positions, &polygons, &part_of_polygon, groups.names)
}

/// A 0-based vertex from `v`, `v/vt`, `v//vn` or `v/vt/vn`; negative counts back from the last vertex so far.
fn corner(word: &str, line: usize, vertices: usize) -> Result<u64> {
    let index = word.split('/').next().and_then(|index| index.parse::<i64>().ok());
    match index {
        Some(index) if index > 0 => Ok(index.unsigned_abs() - 1),
        Some(index) if index < 0 => (vertices as u64)
            .checked_sub(index.unsigned_abs())
            .ok_or_else(|| OBJ.line(line, format!("vertex {index} counts back beyond the {vertices} vertices so far"))),
        _ => Err(OBJ.line(line, format!("{word:?} is not a vertex index; they count from 1"))),
    }
}

/// Brings the polygons of each part together and drops parts without triangles.
fn assemble(positions: Vec<DVec3>, polygons: &Polygons, part_of_polygon: &[usize], names: Vec<String>) -> Result<Soup> {
    let mut members = vec![Vec::new(); names.len()];
    for (polygon, &part) in part_of_polygon.iter().enumerate() {
        members[part].push(polygon);
    }
    let mut soup = Soup { positions, ..Soup::default() };
    for (name, members) in names.into_iter().zip(members) {
        for polygon in members {
            polygons.triangulate(polygon, &soup.positions, &mut soup.triangles)?;
        }
        soup.end_part(name);
    }
    Ok(soup)
}
