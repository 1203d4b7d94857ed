//! A sparse matrix as SciPy's `load_npz` reads it: compressed rows (CSR) in a zip archive of arrays.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read, Seek, SeekFrom, Write};

use anyhow::Result;
use rawzip::ZipArchiveWriter;

use super::npy;
use crate::number::Number;

/// Which part of a row is wanted.
#[derive(Clone, Copy, PartialEq)]
enum Wanted {
    Columns,
    Numbers,
}

/// Puts a matrix together from its rows, one after another in `rows`, in passes over these.
pub fn assemble(rows: &File, number: Number, [row_count, columns]: [usize; 2], output: &File) -> Result<()> {
    let counts = counts(rows, number, row_count)?;
    let entries: u64 = counts.iter().sum();
    // Indices of SciPy have 32 bits where all fit.
    let is_short = entries.max(columns as u64) <= i32::MAX as u64;
    let index = if is_short { "<i4" } else { "<i8" };
    let mut archive = ZipArchiveWriter::new(BufWriter::new(output));

    let mut add =
        |name: &str, descriptor: &str, shape: &str, write: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>| {
            let (mut entry, config) = archive.new_file(name).start()?;
            let mut writer = config.wrap(&mut entry);
            writer.write_all(&npy::header(descriptor, shape))?;
            write(&mut writer)?;
            let (_, descriptor) = writer.finish()?;
            entry.finish(descriptor)?;
            anyhow::Ok(())
        };
    let of_entries = format!("({entries},)");
    add("indices.npy", index, &of_entries, &mut |writer| {
        each(rows, number, &counts, Wanted::Columns, |bytes| {
            if is_short {
                return writer.write_all(bytes);
            }
            let (columns, _) = bytes.as_chunks::<4>();
            columns
                .iter()
                .try_for_each(|&column| writer.write_all(&u64::from(u32::from_le_bytes(column)).to_le_bytes()))
        })
    })?;
    add("indptr.npy", index, &format!("({},)", row_count + 1), &mut |writer| {
        let mut start = 0_u64;
        for count in [0].iter().chain(&counts) {
            start += count;
            writer.write_all(&start.to_le_bytes()[..if is_short { 4 } else { 8 }])?;
        }
        Ok(())
    })?;
    add("format.npy", "|S3", "()", &mut |writer| writer.write_all(b"csr"))?;
    add("shape.npy", "<i8", "(2,)", &mut |writer| {
        [row_count, columns].iter().try_for_each(|&length| writer.write_all(&(length as u64).to_le_bytes()))
    })?;
    add("data.npy", number.descriptor(), &of_entries, &mut |writer| {
        each(rows, number, &counts, Wanted::Numbers, |bytes| writer.write_all(bytes))
    })?;
    archive.finish()?.flush()?;
    Ok(())
}

/// How many entries each row has.
fn counts(mut rows: &File, number: Number, row_count: usize) -> io::Result<Vec<u64>> {
    rows.seek(SeekFrom::Start(0))?;
    let mut reader = BufReader::new(rows);
    let mut count = || {
        let mut bytes = [0; 8];
        reader.read_exact(&mut bytes)?;
        let count = u64::from_le_bytes(bytes);
        reader.seek_relative((count * (4 + number.bytes() as u64)) as i64)?;
        Ok(count)
    };
    (0..row_count).map(|_| count()).collect()
}

/// Gives the columns or the numbers of each row in turn.
fn each(
    mut rows: &File,
    number: Number,
    counts: &[u64],
    wanted: Wanted,
    mut give: impl FnMut(&[u8]) -> io::Result<()>,
) -> io::Result<()> {
    rows.seek(SeekFrom::Start(0))?;
    let mut reader = BufReader::new(rows);
    for &count in counts {
        let mut bytes = vec![0; 8 + count as usize * (4 + number.bytes())];
        reader.read_exact(&mut bytes)?;
        let (columns, numbers) = bytes[8..].split_at(4 * count as usize);
        give(if wanted == Wanted::Columns { columns } else { numbers })?;
    }
    Ok(())
}
