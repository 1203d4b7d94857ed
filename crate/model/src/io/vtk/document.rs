//! XML files: pieces with arrays of numbers, in the document or appended to it.

use std::iter;

use miniz_oxide::inflate::decompress_slice_iter_to_slice;
use quick_xml::events::BytesStart;

use super::base64::Base64;
use super::piece::{Piece, VTK, cell};
use crate::error::{Error, Result};
use crate::io::budget::Budget;
use crate::io::scalar::{Scalar, whole};
use crate::io::text;
use crate::io::xml::{Document, Node, attributes, find, has_root};

const ROOT: &[u8] = b"<VTKFile";
const APPENDED: &[u8] = b"<AppendedData";

pub fn has_header(bytes: &[u8]) -> bool {
    has_root(bytes, ROOT)
}

/// How arrays of a file are written.
struct Encoding<'a> {
    budget: &'a Budget,
    is_little: bool,
    /// Of lengths before data.
    header: Scalar,
    is_compressed: bool,
    /// What follows the underscore, where there is one.
    appended: &'a [u8],
    is_appended_raw: bool,
}

/// An array that is read.
struct Array {
    /// The element around it: `Points`, `Polys`, `Strips`, `Cells`.
    section: String,
    name: String,
    numbers: Vec<f64>,
}

pub fn read<'a>(budget: &'a Budget, bytes: &[u8]) -> Result<Vec<Piece<'a>>> {
    // What is appended raw is no XML.
    let end = find(bytes, APPENDED).unwrap_or(bytes.len());
    let text = String::from_utf8_lossy(&bytes[..end]);
    let mut encoding = Encoding::appended(budget, &bytes[end..]);
    let mut document = Document::new(VTK, "document", &text);
    let (mut pieces, mut arrays) = (Vec::new(), Vec::new());
    let mut section = String::new();
    let mut thin = 0;
    while let Some(node) = document.next()? {
        match node {
            Node::Start { element, is_empty } => match element.local_name().as_ref() {
                "VTKFile" => encoding.read(&element)?,
                name @ ("Points" | "Verts" | "Lines" | "Polys" | "Strips" | "Cells" | "PointData" | "CellData") => {
                    name.clone_into(&mut section);
                }
                "DataArray" if matches!(section.as_str(), "Points" | "Polys" | "Strips" | "Cells") => {
                    let text = if is_empty { String::new() } else { document.text("DataArray")? };
                    arrays
                        .push(encoding.array(&section, &element, &text).map_err(|problem| document.broken(&problem))?);
                }
                // Points and lines are told of by their number alone.
                "Piece" => {
                    let count = |wanted: &str| {
                        let own = attributes(&element).find(|(name, _)| *name == wanted);
                        own.and_then(|(_, count)| count.parse::<usize>().ok()).unwrap_or_default()
                    };
                    thin = count("NumberOfVerts").saturating_add(count("NumberOfLines"));
                }
                _ => {}
            },
            Node::End(name) if name == "Piece" => {
                let mut piece = piece(budget, &std::mem::take(&mut arrays))?;
                piece.thin += thin;
                pieces.push(piece);
            }
            Node::End(_) | Node::Text(_) => {}
        }
    }
    Ok(pieces)
}

fn piece<'a>(budget: &'a Budget, arrays: &[Array]) -> Result<Piece<'a>> {
    let array = |section: &str, name: &str| {
        let array = arrays.iter().find(|array| array.section == section && (name.is_empty() || array.name == name));
        array.map_or(&[][..], |array| &array.numbers)
    };
    let mut piece = Piece::new(budget);
    piece.set_positions(array("Points", ""))?;
    for (section, kind) in [("Polys", cell::POLYGON), ("Strips", cell::STRIP)] {
        piece.add_cells(array(section, "connectivity"), array(section, "offsets"), |_| Some(kind))?;
    }
    let types = array("Cells", "types");
    let kind = |index: usize| types.get(index).copied().and_then(whole);
    piece.add_cells(array("Cells", "connectivity"), array("Cells", "offsets"), kind)?;
    Ok(piece)
}

impl<'a> Encoding<'a> {
    /// With the element of what is appended, up to the end of the file.
    fn appended(budget: &'a Budget, element: &'a [u8]) -> Self {
        let start = find(element, b">").map_or(element.len(), |end| end + 1);
        let (tag, data) = element.split_at(start);
        let data = find(data, b"_").map_or(&[][..], |underscore| &data[underscore + 1..]);
        let is_raw = find(tag, b"\"raw\"").or(find(tag, b"'raw'")).is_some();
        Self {
            budget,
            is_little: true,
            header: Scalar::U32,
            is_compressed: false,
            appended: data,
            is_appended_raw: is_raw,
        }
    }

    fn read(&mut self, root: &BytesStart) -> Result<()> {
        let unsupported = |feature: String, remedy: &str| {
            Err(Error::Unsupported { format: "VTK", feature, remedy: remedy.to_owned() })
        };
        for (name, value) in attributes(root) {
            match (name, &*value) {
                ("type", "PolyData" | "UnstructuredGrid") => {}
                ("type", other) => {
                    return unsupported(format!("the dataset {other}"), "extract its surface and save it as PolyData");
                }
                ("byte_order", order) => self.is_little = order != "BigEndian",
                ("header_type", kind) => self.header = if kind == "UInt64" { Scalar::U64 } else { Scalar::U32 },
                ("compressor", "vtkZLibDataCompressor") => self.is_compressed = true,
                ("compressor", other) => {
                    return unsupported(format!("compression by {other}"), "save it compressed by zlib or not at all");
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The array of an element; what is wrong with it otherwise.
    fn array(&self, section: &str, element: &BytesStart, content: &str) -> std::result::Result<Array, String> {
        let (mut name, mut scalar, mut format, mut offset) = (String::new(), None, String::new(), None);
        for (key, value) in attributes(element) {
            match key {
                "Name" => name = value.into_owned(),
                "type" => scalar = Scalar::parse(&value),
                "format" => format = value.into_owned(),
                "offset" => offset = value.parse::<usize>().ok(),
                _ => {}
            }
        }
        let _loan = self.budget.loan();
        let damaged = || format!("the array {name:?} is damaged or cut short; save the file again");
        let scalar = scalar.ok_or_else(|| format!("the array {name:?} has no type of numbers; save the file again"))?;
        let bytes = match format.as_str() {
            "appended" => {
                let data = offset.and_then(|offset| self.appended.get(offset..)).ok_or_else(damaged)?;
                let source = if self.is_appended_raw { Source::Raw(data) } else { Source::Base64(Base64::new(data)) };
                self.bytes(source)
            }
            "binary" => self.bytes(Source::Base64(Base64::new(content.as_bytes()))),
            _ => {
                let no_number =
                    |word| format!("in the array {name:?} a number should be, but {}", text::why_no_number(Some(word)));
                let mut numbers = Vec::new();
                for word in content.split_ascii_whitespace() {
                    let number = text::number(word).ok_or_else(|| no_number(word))?;
                    self.budget.push(&mut numbers, number).map_err(|_| damaged())?;
                }
                return Ok(Array { section: section.to_owned(), name, numbers });
            }
        };
        let bytes = bytes.ok_or_else(damaged)?;
        let numbers = scalar.numbers(self.budget, &bytes, self.is_little).map_err(|_| damaged())?;
        Ok(Array { section: section.to_owned(), name, numbers })
    }

    /// The bytes of an array, inflated, which are lent; none where they are damaged, or the budget has no room for them.
    fn bytes(&self, mut source: Source) -> Option<Vec<u8>> {
        let mut lengths = |count: usize| {
            let bytes = source.take(self.budget, count.checked_mul(self.header.size())?)?;
            let lengths = self.header.numbers(self.budget, &bytes, self.is_little).ok()?.into_iter();
            lengths
                .map(|length| whole(length).and_then(|length| usize::try_from(length).ok()))
                .collect::<Option<Vec<_>>>()
        };
        if !self.is_compressed {
            let length = lengths(1)?[0];
            return source.take(self.budget, length);
        }
        // The number of blocks, the length of a block and of the last one where that is shorter, then that of each packed block.
        let [blocks, length, last] = lengths(3)?[..] else { return None };
        let packed = lengths(blocks)?;
        let length_of = |index: usize| if index + 1 == blocks && last > 0 { last } else { length };
        let total = (0..blocks).try_fold(0_usize, |sum, index| sum.checked_add(length_of(index)))?;
        self.budget.lend(total as u64).ok()?;
        let mut bytes = Vec::with_capacity(total);
        for (index, &packed) in packed.iter().enumerate() {
            let packed = source.take(self.budget, packed)?;
            let start = bytes.len();
            bytes.resize(start + length_of(index), 0);
            let inflated = decompress_slice_iter_to_slice(&mut bytes[start..], iter::once(&packed[..]), true, false);
            bytes.truncate(start + inflated.ok()?);
        }
        Some(bytes)
    }
}

/// Bytes that are taken one after another.
enum Source<'a> {
    Raw(&'a [u8]),
    Base64(Base64<'a>),
}

impl Source<'_> {
    /// The next bytes, which are lent; none where there are not so many, or the budget has no room for them.
    fn take(&mut self, budget: &Budget, count: usize) -> Option<Vec<u8>> {
        match self {
            Self::Raw(bytes) => {
                let (own, rest) = bytes.split_at_checked(count)?;
                budget.lend(count as u64).ok()?;
                *bytes = rest;
                Some(own.to_vec())
            }
            Self::Base64(text) => text.take(budget, count),
        }
    }
}
