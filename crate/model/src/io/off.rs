//! Object File Format (Geomview): `[ST][C][N][4][n]OFF`, ASCII.

use glam::DVec3;
use heatwalk_surface::{Soup, WarningCode, Warnings};

use super::budget::Budget;
use super::format::Format;
use super::reader::Reporter;
use super::text::{self, Words};
use super::triangulate::Polygons;
use crate::error::{Error, Result};
use crate::model::Model;

const OFF: Reporter = Reporter("OFF");

pub const FORMAT: Format = Format {
    extensions: &["off", "coff", "noff"],
    is: has_keyword,
    read: |budget, name, bytes, _| read(budget, name, bytes).map(Model::from),
    upward: None,
};

/// Whether the first word is an OFF header.
fn has_keyword(bytes: &[u8]) -> bool {
    let line = bytes.split(|byte| byte.is_ascii_whitespace()).next().unwrap_or_default();
    // Some exporters write the first count against the keyword: "OFF2904 5804 0".
    let end = line.iter().rposition(|byte| !byte.is_ascii_digit()).map_or(0, |last| last + 1);
    std::str::from_utf8(&line[..end]).is_ok_and(|word| Header::parse(word).is_some())
}

/// What the keyword says of a vertex.
#[derive(Clone, Copy, Default)]
struct Header {
    /// Coordinates, one more than three where they are homogeneous.
    coordinates: usize,
    /// Numbers that follow the position: normal, color, texture coordinates.
    further: usize,
    /// Whether the number of dimensions comes before the counts.
    has_dimension: bool,
}

impl Header {
    /// The letters are in the order of the format, or in any other: programs differ.
    fn parse(word: &str) -> Option<Self> {
        let mut rest = word.strip_suffix("OFF").or(word.strip_suffix("off").filter(|before| before.is_empty()))?;
        let mut header = Self { coordinates: 3, ..Self::default() };
        let mut seen = Vec::new();
        while !rest.is_empty() {
            let kinds = [("ST", 2), ("C", 4), ("N", 3), ("4", 0), ("n", 0)];
            let (kind, numbers) = kinds.into_iter().find(|(kind, _)| rest.starts_with(kind) && !seen.contains(kind))?;
            rest = &rest[kind.len()..];
            seen.push(kind);
            header.coordinates += usize::from(kind == "4");
            header.has_dimension |= kind == "n";
            header.further += numbers;
        }
        Some(header)
    }
}

fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    let text = String::from_utf8_lossy(bytes);
    let mut words = Words::new(text::lines(&text).map(|(number, line)| (number, text::statement(line))));
    let first = words.peek().unwrap_or_default();
    let keyword_end = first.find("OFF").or(first.find("off")).map_or(0, |start| start + 3);
    let (keyword, count) = first.split_at(keyword_end);
    // The keyword is optional in the format.
    let header = if keyword.is_empty() { Header::parse("OFF") } else { Header::parse(keyword) };
    let header = header.ok_or_else(|| {
        OFF.line(words.line(), format!("{} is not an OFF header; save it as plain OFF", text::quoted(keyword)))
    })?;
    words.skip_to(&words.rest()[keyword_end..]);
    if count.is_empty() && words.peek().is_some_and(|word| word.starts_with("BINARY")) {
        return Err(Error::Unsupported {
            format: "OFF",
            feature: "binary OFF".to_owned(),
            remedy: "save it as ASCII OFF or binary PLY".to_owned(),
        });
    }
    if header.has_dimension {
        match words.index("the number of dimensions")? {
            3 => {}
            other => {
                return Err(Error::Unsupported {
                    format: "OFF",
                    feature: format!("a space of {other} dimensions"),
                    remedy: "give every vertex three coordinates".to_owned(),
                });
            }
        }
    }
    let counts = [words.index("the number of vertices")?, words.index("the number of faces")?];
    words.pass_edges(header.coordinates);
    // A line a vertex and a face, with whatever follows on it, or one number after another, as the format has it.
    let by_lines = Mesh::read(budget, words.clone(), header, counts, true, bytes.len());
    if matches!(&by_lines, Ok(mesh) if mesh.rest.is_none()) {
        return by_lines?.soup(name);
    }
    match Mesh::read(budget, words, header, counts, false, bytes.len()) {
        Ok(mesh) if mesh.rest.is_none() => mesh.soup(name),
        _ => by_lines?.soup(name),
    }
}

fn ends(missing: &str) -> Error {
    OFF.at("end of file", format!("{missing}; the file is cut short, save it again"))
}

/// The words of a file.
trait File<'a> {
    fn index(&mut self, what: &str) -> Result<u64>;
    /// Passes the number of edges, which some files leave out: then a vertex follows, on a line of its own.
    fn pass_edges(&mut self, coordinates: usize);
    fn coordinate(&mut self, vertex: usize, header: Header, by_lines: bool) -> Result<f64>;
}

impl<'a, I: Iterator<Item = (usize, &'a str)>> File<'a> for Words<'a, I> {
    fn index(&mut self, what: &str) -> Result<u64> {
        let word = self.take().ok_or_else(|| ends(&format!("{what} is missing")))?;
        let expected = || format!("{what} is expected, but {} is found; correct the line", text::quoted(word));
        word.parse().map_err(|_| OFF.line(self.line(), expected()))
    }

    fn pass_edges(&mut self, coordinates: usize) {
        let is_on_line = !self.rest().is_empty();
        self.turn();
        if is_on_line || self.rest().split_ascii_whitespace().take(coordinates).count() == 1 {
            self.take();
        }
    }

    fn coordinate(&mut self, vertex: usize, header: Header, by_lines: bool) -> Result<f64> {
        let word = if by_lines && self.rest().is_empty() { None } else { self.take() };
        word.and_then(text::number).ok_or_else(|| {
            let Header { coordinates, .. } = header;
            let found = text::why_no_number(word);
            OFF.line(self.line(), format!("vertex {vertex} needs {coordinates} numbers, but {found}; correct the line"))
        })
    }
}

/// What the words of a file are.
struct Mesh<'a> {
    positions: Vec<DVec3>,
    polygons: Polygons<'a>,
    /// The line of each polygon.
    lines: Vec<usize>,
    /// The line of the first word behind the last face.
    rest: Option<usize>,
}

impl<'a> Mesh<'a> {
    /// `by_lines`: each vertex and each face begins a line, and what follows it there is passed over.
    fn read<'b>(
        budget: &'a Budget,
        mut words: Words<'b, impl Iterator<Item = (usize, &'b str)>>,
        header: Header,
        [vertices, faces]: [u64; 2],
        by_lines: bool,
        bytes: usize,
    ) -> Result<Self> {
        if by_lines && words.is_begun() {
            words.skip_to("");
        }
        // A vertex takes at least six bytes, so a count beyond that is a lie and must not be reserved.
        let mut positions = budget.list((bytes / 6).min(vertices as usize))?;
        while (positions.len() as u64) < vertices {
            let vertex = positions.len();
            if words.peek().is_none() {
                return Err(ends(&format!("{} of {vertices} vertices are missing", vertices - vertex as u64)));
            }
            let mut coordinates = [0.0, 0.0, 0.0, 1.0];
            for coordinate in &mut coordinates[..header.coordinates] {
                *coordinate = words.coordinate(vertex, header, by_lines)?;
            }
            if by_lines {
                words.skip_to("");
            } else {
                for _ in 0..header.further {
                    words.take();
                }
            }
            let [x, y, z, w] = coordinates;
            budget.push(&mut positions, DVec3::new(x, y, z) / w)?;
        }
        let mut polygons = Polygons::new(budget);
        let mut lines = budget.list((bytes / 6).min(faces as usize))?;
        for face in 0..faces {
            if words.peek().is_none() {
                return Err(ends(&format!("{} of {faces} faces are missing", faces - face)));
            }
            let line = words.line();
            for corner in 0..words.index("the number of corners of a face")? {
                if by_lines && words.rest().is_empty() {
                    return Err(OFF.line(line, format!("corner {corner} of face {face} is missing; correct the line")));
                }
                polygons.corner(words.index("a vertex of a face")?)?;
            }
            polygons.close()?;
            budget.push(&mut lines, line)?;
            if by_lines {
                words.skip_to("");
            }
        }
        let rest = words.peek().map(|_| words.line());
        Ok(Self { positions, polygons, lines, rest })
    }

    fn soup(self, name: &str) -> Result<Soup> {
        let Self { positions, polygons, lines, rest } = self;
        let mut warnings = Warnings::default();
        if let Some(line) = rest {
            warnings.add(WarningCode::Trailing, || format!("line {line}"));
        }
        let place = |face: usize| format!("line {}", lines[face]);
        polygons
            .check(positions.len())
            .map_err(|missing| OFF.no_vertex(place(missing.polygon), missing.vertex, positions.len(), 0))?;
        let (triangles, polygons) = polygons.triangulate_all(&positions, &mut warnings, place)?;
        Ok(Soup { polygons, warnings: warnings.into_vec(), ..Soup::single(name, positions, triangles) })
    }
}
