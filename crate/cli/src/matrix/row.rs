//! Rows as bytes.

use std::fmt::Write as _;

use super::npy;
use crate::number::Number;
use crate::output::MatrixFormat;
use crate::place::Place;

/// What a row is, in the file or before it is put together.
#[derive(Debug)]
pub enum Layout {
    /// The numbers of all columns.
    Dense(Number),
    /// How many entries there are (`u64`), their columns (`u32` each) and their numbers.
    Sparse(Number),
    /// A line of text, by the vertices of the columns.
    Text(Number, Vec<usize>),
    /// A line of text for each entry.
    Triples(Number, Vec<usize>),
}

impl Layout {
    /// `is_limited`: whether entries may be left out; `targets`: the vertices of the columns.
    pub fn new(format: MatrixFormat, number: Number, is_limited: bool, targets: &[usize]) -> Self {
        match (format, is_limited) {
            (MatrixFormat::Npy, _) => Self::Dense(number),
            (MatrixFormat::Npz, _) => Self::Sparse(number),
            (MatrixFormat::Csv, false) => Self::Text(number, targets.to_vec()),
            (MatrixFormat::Csv, true) => Self::Triples(number, targets.to_vec()),
        }
    }

    /// What the file begins with.
    pub fn head(&self, [rows, columns]: [usize; 2]) -> Vec<u8> {
        match self {
            Self::Dense(number) => npy::header(number.descriptor(), &format!("({rows}, {columns})")),
            Self::Sparse(_) => Vec::new(),
            Self::Text(_, targets) => {
                let numbers: String = targets.iter().map(|target| format!(",{target}")).collect();
                format!("source{numbers}\n").into_bytes()
            }
            Self::Triples(..) => b"source,target,distance\n".to_vec(),
        }
    }

    /// At most, about.
    pub fn bytes_per_row(&self, columns: usize) -> usize {
        match self {
            Self::Dense(number) => number.bytes() * columns,
            Self::Sparse(number) => 8 + (4 + number.bytes()) * columns,
            Self::Text(..) => 24 * columns,
            Self::Triples(..) => 40 * columns,
        }
    }

    /// The distances from a source of all columns.
    pub fn row(&self, source: &Place, values: &[f64]) -> Vec<u8> {
        let entries = || values.iter().copied().enumerate().filter(|(_, value)| value.is_finite());
        match self {
            Self::Dense(number) => {
                let mut bytes = Vec::with_capacity(number.bytes() * values.len());
                values.iter().for_each(|&value| number.push(value, &mut bytes));
                bytes
            }
            Self::Sparse(number) => {
                let count = entries().count();
                let mut bytes = Vec::with_capacity(self.bytes_per_row(count));
                bytes.extend((count as u64).to_le_bytes());
                entries().for_each(|(column, _)| bytes.extend((column as u32).to_le_bytes()));
                entries().for_each(|(_, value)| number.push(value, &mut bytes));
                bytes
            }
            Self::Text(number, _) => {
                let mut line = source.in_table();
                for &value in values {
                    // Writing to a String cannot fail.
                    let _ = write!(line, ",{}", number.written(value));
                }
                line.push('\n');
                line.into_bytes()
            }
            Self::Triples(number, targets) => {
                let (mut lines, source) = (String::new(), source.in_table());
                for (column, value) in entries() {
                    let _ = writeln!(lines, "{source},{},{}", targets[column], number.written(value));
                }
                lines.into_bytes()
            }
        }
    }
}
