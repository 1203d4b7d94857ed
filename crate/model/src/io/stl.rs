//! STL, ASCII and binary. Every triangle brings its own three vertices; welding is the surface builder's work.

use glam::DVec3;
use heatwalk_surface::{Soup, WarningCode, Warnings};

use super::budget::Budget;
use super::format::Format;
use super::reader::Reporter;
use super::text::{self, Words};
use crate::error::Result;
use crate::model::Model;

const STL: Reporter = Reporter("STL");
/// 80 bytes of free text and the number of triangles.
const HEADER: usize = 84;
/// Normal, three corners (12 × f32) and two bytes of attributes.
const RECORD: usize = 50;

fn binary_count(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(80..HEADER)?;
    Some(u32::from_le_bytes([count[0], count[1], count[2], count[3]]) as usize)
}

pub const FORMAT: Format = Format {
    extensions: &["stl"],
    is: |bytes| is_binary(bytes) || is_ascii(bytes),
    read: |budget, name, bytes, _| read(budget, name, bytes).map(Model::from),
    upward: None,
};

/// Whether the length is exactly what the count in a binary header asks for. Such a file may well begin with "solid".
fn is_binary(bytes: &[u8]) -> bool {
    binary_count(bytes).is_some_and(|count| count > 0 && count.checked_mul(RECORD) == Some(bytes.len() - HEADER))
}

/// Whether the file begins as ASCII STL does, with a name of any length.
fn is_ascii(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    let has = |word: &[u8]| text.windows(word.len()).any(|window| window.eq_ignore_ascii_case(word));
    text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) && (has(b"facet") || has(b"endsolid"))
}

fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    if is_binary(bytes) {
        read_binary(budget, name, bytes)
    } else if is_ascii(bytes) {
        read_ascii(budget, name, bytes)
    } else if text::is_text(bytes) {
        Err(STL.at("byte 0", "text that begins with \"solid\" and has facets is expected; save the file again"))
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
    let mut warnings = Warnings::default();
    let end = HEADER + count * RECORD;
    if end < bytes.len() {
        warnings.add(WarningCode::Trailing, || format!("byte {end}"));
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
    Ok(Soup { warnings: warnings.into_vec(), ..Soup::single(name, positions, triangles) })
}

fn read_ascii(budget: &Budget, file: &str, bytes: &[u8]) -> Result<Soup> {
    let text = String::from_utf8_lossy(bytes);
    let mut solids = Solids::new(budget);
    let mut name = file;
    let mut words = Words::new(text::lines(&text));
    // Words of no meaning are passed over, normals among them: nobody needs these.
    while let Some(word) = words.take() {
        let line = words.line();
        match word.to_ascii_lowercase().as_str() {
            "solid" => {
                solids.end_facet(line)?;
                solids.soup.end_part(name);
                let (own, facets) = name_before(words.rest(), is_facet);
                name = if own.is_empty() { file } else { own };
                words.skip_to(facets);
            }
            "endsolid" => {
                solids.end_facet(line)?;
                solids.is_open = false;
                let (_, next) = name_before(words.rest(), |word, _| word.eq_ignore_ascii_case("solid"));
                words.skip_to(next);
            }
            "facet" => {
                solids.end_facet(line)?;
                solids.begun = Some(line);
                solids.is_open = true;
            }
            "vertex" => {
                solids.begun.get_or_insert(line);
                budget.push(&mut solids.corners, STL.position(|| words.take(), line)?)?;
            }
            "endfacet" => solids.add_facet(line)?,
            _ => {}
        }
    }
    let last = words.line();
    if let Some(begun) = solids.begun {
        return Err(STL.line(begun, "the facet is cut short by the end of the file; save it again"));
    }
    if solids.is_open {
        solids.warnings.add(WarningCode::NoEnd, || format!("line {last}"));
    }
    solids.soup.end_part(name);
    Ok(Soup { warnings: solids.warnings.into_vec(), ..solids.soup })
}

/// What is read of the solids so far.
struct Solids<'a> {
    budget: &'a Budget,
    soup: Soup,
    warnings: Warnings,
    /// Of the facet that has begun.
    corners: Vec<DVec3>,
    /// The line where it did.
    begun: Option<usize>,
    /// Whether a solid has facets and no end yet.
    is_open: bool,
}

impl<'a> Solids<'a> {
    fn new(budget: &'a Budget) -> Self {
        Self {
            budget,
            soup: Soup::default(),
            warnings: Warnings::default(),
            corners: Vec::new(),
            begun: None,
            is_open: false,
        }
    }

    fn add_facet(&mut self, line: usize) -> Result<()> {
        if self.corners.len() != 3 {
            return Err(STL.line(line, format!("a facet has {} corners instead of 3", self.corners.len())));
        }
        let first = self.soup.positions.len() as u32;
        self.budget.push(&mut self.soup.triangles, [first, first + 1, first + 2])?;
        self.budget.reserve(&mut self.soup.positions, self.corners.len())?;
        self.soup.positions.append(&mut self.corners);
        self.begun = None;
        Ok(())
    }

    /// Ends a facet that has begun, if there is one, where no `endfacet` does.
    fn end_facet(&mut self, line: usize) -> Result<()> {
        let Some(begun) = self.begun else { return Ok(()) };
        self.warnings.add(WarningCode::UnendedFacets, || format!("line {begun}"));
        self.add_facet(line)
    }
}

/// Whether a facet or the end of a solid begins with this word, by what is behind it: names may have the same words.
fn is_facet(word: &str, mut rest: &str) -> bool {
    let is = |word: &str, known| word.eq_ignore_ascii_case(known);
    let next = text::word(&mut rest).unwrap_or_default();
    let is_normal = is(next, "normal") && text::word(&mut rest).is_some_and(|word| text::number(word).is_some());
    is(word, "endsolid") || is(word, "facet") && (is(next, "outer") || is_normal)
}

/// The part of a line before the first word that `ends` it, given what is behind that, and what is left from there on.
fn name_before(line: &str, ends: impl Fn(&str, &str) -> bool) -> (&str, &str) {
    let mut rest = line;
    loop {
        let before = rest;
        let Some(word) = text::word(&mut rest) else { return (line.trim(), "") };
        if ends(word, rest) {
            return (line[..line.len() - before.len()].trim(), before);
        }
    }
}
