//! Legacy files: text lines, between them numbers as text or, big-endian, as bytes.

use super::piece::{Piece, VTK, cell};
use crate::error::{Error, Result};
use crate::io::budget::Budget;
use crate::io::scalar::{Scalar, whole};
use crate::io::text;

const HEADER: &[u8] = b"# vtk datafile";

pub fn has_header(bytes: &[u8]) -> bool {
    bytes.get(..HEADER.len()).is_some_and(|start| start.eq_ignore_ascii_case(HEADER))
}

/// The rest of a file.
struct Rest<'a> {
    budget: &'a Budget,
    bytes: &'a [u8],
    length: usize,
    is_binary: bool,
}

pub fn read<'a>(budget: &'a Budget, bytes: &[u8]) -> Result<Piece<'a>> {
    let mut rest = Rest { budget, bytes, length: bytes.len(), is_binary: false };
    rest.line();
    rest.line();
    let encoding = rest.line().unwrap_or_default();
    rest.is_binary = match encoding.trim().to_ascii_uppercase().as_str() {
        "ASCII" => false,
        "BINARY" => true,
        _ => return Err(VTK.line(3, "expected ASCII or BINARY; save the file again")),
    };
    let mut piece = Piece::new(budget);
    let mut cells: Option<Cells> = None;
    let mut types = Vec::new();
    while let Some(line) = rest.line() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let keyword = words.first().map(|word| word.to_ascii_uppercase()).unwrap_or_default();
        let count = |place: usize| words.get(place).and_then(|word| word.parse::<usize>().ok());
        let broken = || rest.broken(&format!("{} is no {keyword} statement", text::quoted(line.trim())));
        match keyword.as_str() {
            "DATASET" => check(words.get(1).copied().unwrap_or_default())?,
            "POINTS" => {
                let (count, scalar) = count(1).zip(scalar(words.get(2))).ok_or_else(broken)?;
                let coordinates = rest.numbers(scalar, count.checked_mul(3).ok_or_else(broken)?)?;
                piece.set_positions(&coordinates)?;
            }
            "VERTICES" | "LINES" => {
                piece.thin += rest.cells(count(1).zip(count(2)).ok_or_else(broken)?)?.ends.len();
            }
            "POLYGONS" | "TRIANGLE_STRIPS" => {
                let cells = rest.cells(count(1).zip(count(2)).ok_or_else(broken)?)?;
                let kind = if keyword == "POLYGONS" { cell::POLYGON } else { cell::STRIP };
                piece.add_cells(&cells.points, &cells.ends, |_| Some(kind))?;
            }
            "CELLS" => cells = Some(rest.cells(count(1).zip(count(2)).ok_or_else(broken)?)?),
            "CELL_TYPES" => types = rest.numbers(Scalar::I32, count(1).ok_or_else(broken)?)?,
            "FIELD" => rest.skip_field(count(2).ok_or_else(broken)?)?,
            "METADATA" => while rest.line().is_some_and(|line| !line.trim().is_empty()) {},
            // Attributes are the last of a file.
            "POINT_DATA" | "CELL_DATA" => break,
            _ => {}
        }
    }
    if let Some(cells) = cells {
        piece.add_cells(&cells.points, &cells.ends, |index| types.get(index).copied().and_then(whole))?;
    }
    Ok(piece)
}

fn check(dataset: &str) -> Result<()> {
    if dataset.eq_ignore_ascii_case("POLYDATA") || dataset.eq_ignore_ascii_case("UNSTRUCTURED_GRID") {
        return Ok(());
    }
    Err(Error::Unsupported {
        format: "VTK",
        feature: format!("the dataset {dataset}"),
        remedy: "extract its surface and save it as polygonal data".to_owned(),
    })
}

fn scalar(word: Option<&&str>) -> Option<Scalar> {
    word.and_then(|word| Scalar::parse(word))
}

/// Cells by their points.
struct Cells {
    points: Vec<f64>,
    /// Of each cell, where its points end.
    ends: Vec<f64>,
}

impl Rest<'_> {
    fn broken(&self, problem: &str) -> Error {
        VTK.at(
            format!("byte {}", self.length - self.bytes.len()),
            format!("{problem}; the file is damaged, save it again"),
        )
    }

    /// The next line; none at the end.
    fn line(&mut self) -> Option<String> {
        if self.bytes.is_empty() {
            return None;
        }
        let (length, text) = text::line_length(self.bytes);
        let line = String::from_utf8_lossy(&self.bytes[..text]).into_owned();
        self.bytes = &self.bytes[length..];
        Some(line)
    }

    fn numbers(&mut self, scalar: Scalar, count: usize) -> Result<Vec<f64>> {
        let short = |rest: &Self| rest.broken(&format!("{count} numbers should follow, and the file ends"));
        if self.is_binary {
            let length = count.checked_mul(scalar.size()).filter(|&length| length <= self.bytes.len());
            let (own, rest) = self.bytes.split_at(length.ok_or_else(|| short(self))?);
            self.bytes = rest;
            return scalar.numbers(self.budget, own, false);
        }
        // A number takes two bytes, so that a count beyond that must not be reserved.
        if count > self.bytes.len() {
            return Err(short(self));
        }
        let mut numbers = self.budget.list(count)?;
        while numbers.len() < count {
            let start = self.bytes.trim_ascii_start();
            let end = start.iter().position(u8::is_ascii_whitespace).unwrap_or(start.len());
            let word = std::str::from_utf8(&start[..end]).ok().filter(|word| !word.is_empty());
            let no_number = || self.broken(&format!("a number should follow, but {}", text::why_no_number(word)));
            numbers.push(word.and_then(text::number).ok_or_else(no_number)?);
            self.bytes = &start[end..];
        }
        Ok(numbers)
    }

    /// Cells, `counts` in their statement: before version 5 the number of points before those of each cell, since then where
    /// cells begin, then their points.
    fn cells(&mut self, (first, second): (usize, usize)) -> Result<Cells> {
        let before = self.bytes;
        let line = self.line().unwrap_or_default();
        if let Some(kind) = line.trim().strip_prefix("OFFSETS") {
            let broken = |rest: &Self| rest.broken("the offsets and the points of cells should follow");
            let scalar = Scalar::parse(kind.trim()).ok_or_else(|| broken(self))?;
            let mut ends = self.numbers(scalar, first)?;
            ends.drain(..ends.len().min(1));
            let mut line = self.line();
            // Binary numbers end with a line of their own.
            if line.as_ref().is_some_and(|line| line.trim().is_empty()) {
                line = self.line();
            }
            let kind = line.as_deref().and_then(|line| line.trim().strip_prefix("CONNECTIVITY"));
            let scalar = kind.and_then(|kind| Scalar::parse(kind.trim())).ok_or_else(|| broken(self))?;
            return Ok(Cells { points: self.numbers(scalar, second)?, ends });
        }
        self.bytes = before;
        let numbers = self.numbers(Scalar::I32, second)?;
        let mut cells = Cells { points: self.budget.list(numbers.len())?, ends: Vec::new() };
        let mut rest = &numbers[..];
        while let Some((&count, points)) = rest.split_first() {
            let count = whole(count).and_then(|count| usize::try_from(count).ok());
            let own = count.and_then(|count| points.get(..count));
            let own = own.ok_or_else(|| self.broken(&format!("cell {} has too few points", cells.ends.len())))?;
            cells.points.extend(own);
            self.budget.push(&mut cells.ends, cells.points.len() as f64)?;
            rest = &points[own.len()..];
        }
        Ok(cells)
    }

    /// Skips arrays, each with a line of its name, components, tuples and type.
    fn skip_field(&mut self, arrays: usize) -> Result<()> {
        let mut skipped = 0;
        while skipped < arrays {
            let Some(line) = self.line() else { return Ok(()) };
            let words: Vec<&str> = line.split_whitespace().collect();
            let [_, components, tuples, kind] = words[..] else { continue };
            let count = components.parse::<usize>().ok().zip(tuples.parse().ok());
            let count = count.and_then(|(components, tuples): (usize, usize)| components.checked_mul(tuples));
            let (count, scalar) =
                count.zip(Scalar::parse(kind)).ok_or_else(|| self.broken("this is no array of numbers"))?;
            self.numbers(scalar, count)?;
            skipped += 1;
        }
        Ok(())
    }
}
