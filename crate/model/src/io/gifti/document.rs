//! The arrays of a document, and the table of its labels.

use std::iter;

use base64::Engine as _;
use miniz_oxide::inflate::decompress_slice_iter_to_slice;
use quick_xml::events::BytesStart;

use crate::error::{Error, Result};
use crate::io::base64::BASE64;
use crate::io::budget::Budget;
use crate::io::reader::{Reporter, Resources};
use crate::io::scalar::Scalar;
use crate::io::text;
use crate::io::xml::{Document, Node, attributes};

pub const GIFTI: Reporter = Reporter("GIFTI");

/// All that a file holds.
#[derive(Default)]
pub struct Contents {
    pub arrays: Vec<Array>,
    /// Keys and names.
    pub labels: Vec<(i64, String)>,
}

/// An array that is read.
pub struct Array {
    /// What its numbers mean, without `NIFTI_INTENT_`.
    pub intent: String,
    pub rows: usize,
    /// Numbers of a row.
    pub columns: usize,
    /// Row by row.
    pub numbers: Vec<f64>,
}

/// What an array says of itself.
#[derive(Default)]
struct Header {
    intent: String,
    kind: String,
    dimensions: Vec<usize>,
    encoding: String,
    is_little: bool,
    is_by_columns: bool,
    file: String,
    offset: usize,
}

pub fn read(budget: &Budget, bytes: &[u8], resources: Resources) -> Result<Contents> {
    let text = String::from_utf8_lossy(bytes);
    let mut document = Document::new(GIFTI, "document", &text);
    let mut contents = Contents::default();
    let mut header = None;
    while let Some(node) = document.next()? {
        let Node::Start { element, is_empty } = node else { continue };
        match element.local_name().as_ref() {
            "DataArray" => header = Some(Header::of(&element)),
            // A transform has numbers of its own in `MatrixData`.
            "Data" => {
                let Some(header) = header.take() else { continue };
                let text = if is_empty { String::new() } else { document.text("Data")? };
                let array = header.array(budget, &text, resources)?;
                contents.arrays.push(array.map_err(|problem| document.broken(&problem))?);
            }
            "Label" => {
                let key = attributes(&element).find(|(name, _)| matches!(*name, "Key" | "Index"));
                let key = key.and_then(|(_, key)| key.trim().parse().ok());
                let name = if is_empty { String::new() } else { document.text("Label")? };
                contents.labels.extend(key.map(|key| (key, name.trim().to_owned())));
            }
            _ => {}
        }
    }
    Ok(contents)
}

impl Header {
    fn of(element: &BytesStart) -> Self {
        let mut header = Self::default();
        for (name, value) in attributes(element) {
            match name {
                "Intent" => value.trim_start_matches("NIFTI_INTENT_").clone_into(&mut header.intent),
                "DataType" => value.trim_start_matches("NIFTI_TYPE_").clone_into(&mut header.kind),
                "Encoding" => header.encoding = value.into_owned(),
                "Endian" => header.is_little = value != "BigEndian",
                "ArrayIndexingOrder" => header.is_by_columns = value == "ColumnMajorOrder",
                "ExternalFileName" => header.file = value.into_owned(),
                "ExternalFileOffset" => header.offset = value.trim().parse().unwrap_or_default(),
                // `Dim0`, `Dim1`, ... in this order.
                name if name.starts_with("Dim") && name != "Dimensionality" => {
                    header.dimensions.push(value.trim().parse().unwrap_or_default());
                }
                _ => {}
            }
        }
        header
    }

    /// What is wrong with it, where that is of this array alone.
    fn array(self, budget: &Budget, text: &str, resources: Resources) -> Result<std::result::Result<Array, String>> {
        let intent = &self.intent;
        let rows = self.dimensions.first().copied().unwrap_or_default();
        let columns = self.dimensions.iter().skip(1).try_fold(1_usize, |product, &length| product.checked_mul(length));
        let count = columns.and_then(|columns| columns.checked_mul(rows));
        let (Some(columns), Some(count), Some(scalar)) = (columns, count, Scalar::parse(&self.kind)) else {
            return Ok(Err(format!("the array {intent} has no size or no type of numbers; save the file again")));
        };
        let damaged = || format!("the array {intent} is damaged or cut short; save the file again");
        let numbers = if self.encoding == "ASCII" {
            match words(budget, intent, text)? {
                Ok(numbers) => numbers,
                Err(problem) => return Ok(Err(problem)),
            }
        } else {
            let _loan = budget.loan();
            let Some(size) = count.checked_mul(scalar.size()) else { return Ok(Err(damaged())) };
            let bytes = match self.encoding.as_str() {
                "ExternalFileBinary" => {
                    let missing = || Error::MissingResource { uri: self.file.clone() };
                    let file = resources(&self.file).ok_or_else(missing)?;
                    let end = self.offset.checked_add(size);
                    end.and_then(|end| file.get(self.offset..end)).map(<[u8]>::to_vec)
                }
                encoding => decoded(budget, text, (encoding == "GZipBase64Binary").then_some(size))?,
            };
            match bytes.filter(|bytes| bytes.len() == size) {
                Some(bytes) => scalar.numbers(budget, &bytes, self.is_little)?,
                None => return Ok(Err(damaged())),
            }
        };
        if numbers.len() != count {
            return Ok(Err(damaged()));
        }
        let numbers = if self.is_by_columns && columns > 1 {
            let mut by_rows = budget.list(count)?;
            by_rows.extend((0..count).map(|place| numbers[place % columns * rows + place / columns]));
            by_rows
        } else {
            numbers
        };
        Ok(Ok(Array { intent: self.intent, rows, columns, numbers }))
    }
}

fn words(budget: &Budget, intent: &str, content: &str) -> Result<std::result::Result<Vec<f64>, String>> {
    let mut numbers = Vec::new();
    for word in content.split_ascii_whitespace() {
        match text::number(word) {
            Some(number) => budget.push(&mut numbers, number)?,
            None => {
                let found = text::why_no_number(Some(word));
                return Ok(Err(format!("in the array {intent} a number should be, but {found}")));
            }
        }
    }
    Ok(Ok(numbers))
}

/// The bytes of text in base64, which are lent; inflated where a size is given. None where they are damaged.
fn decoded(budget: &Budget, text: &str, inflated: Option<usize>) -> Result<Option<Vec<u8>>> {
    budget.lend(2 * text.len() as u64)?;
    let letters: Vec<u8> = text.bytes().filter(|letter| !letter.is_ascii_whitespace()).collect();
    let Ok(packed) = BASE64.decode(letters) else { return Ok(None) };
    let Some(size) = inflated else { return Ok(Some(packed)) };
    budget.lend(size as u64)?;
    let mut bytes = vec![0; size];
    let length = decompress_slice_iter_to_slice(&mut bytes, iter::once(&packed[..]), true, false);
    Ok(length.is_ok_and(|length| length == size).then_some(bytes))
}
