//! ZIP archives (PKWARE, "ZIP File Format Specification" 6.3), opened by rawzip and inflated by miniz_oxide, a file at a time.

use std::collections::HashMap;
use std::iter;

use miniz_oxide::inflate::decompress_slice_iter_to_slice;
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveEntryWayfinder, ZipSliceArchive};

use super::budget::Budget;
use super::reader::Reporter;
use crate::error::{Error, Result};

/// The first bytes of an archive.
pub const MAGIC: &[u8] = b"PK\x03\x04";

const MOST_FILES: usize = 10_000;

/// The files of an archive.
pub struct Archive<'a> {
    reporter: Reporter,
    budget: &'a Budget,
    archive: ZipSliceArchive<&'a [u8]>,
    /// In the order of the archive, without folders.
    paths: Vec<String>,
    files: HashMap<String, (ZipArchiveEntryWayfinder, CompressionMethod)>,
}

impl<'a> Archive<'a> {
    /// `format` is what errors call it. Two files of one path are refused: programs would differ in which one they take.
    ///
    /// # Errors
    /// [`Error::Malformed`], [`Error::OverBudget`].
    pub fn open(budget: &'a Budget, format: &'static str, bytes: &'a [u8]) -> Result<Self> {
        let reporter = Reporter(format);
        let damaged = |_| reporter.at("archive", "it is damaged or cut short; copy it again");
        let archive = ZipArchive::from_slice(bytes).map_err(damaged)?;
        let (mut paths, mut files) = (Vec::new(), HashMap::new());
        let mut entries = archive.entries();
        while let Some(entry) = entries.next_entry().map_err(damaged)? {
            if files.len() == MOST_FILES {
                return Err(reporter.at("archive", format!("it holds more than {MOST_FILES} files; save it again")));
            }
            if entry.is_dir() {
                continue;
            }
            let path = String::from_utf8_lossy(entry.file_path().as_ref()).replace('\\', "/");
            budget.take(2 * path.len() as u64)?;
            if files.insert(path.clone(), (entry.wayfinder(), entry.compression_method())).is_some() {
                return Err(reporter.at(path, "two files of the archive have this name; pack it again"));
            }
            budget.push(&mut paths, path)?;
        }
        Ok(Self { reporter, budget, archive, paths, files })
    }

    /// The paths of its files, as they are written but for separators, which are slashes.
    pub fn paths(&self) -> &[String] {
        &self.paths
    }

    /// The contents of a file.
    ///
    /// # Errors
    /// [`Error::Malformed`] where it is not there or damaged, [`Error::Unsupported`] where it is encrypted or packed by a method other
    /// than deflation, [`Error::OverBudget`].
    pub fn read(&self, path: &str) -> Result<Vec<u8>> {
        let broken = |problem: &str| self.reporter.at(path, problem);
        let damaged = || broken("it is damaged or cut short; copy the file again");
        let unsupported = |feature: String, remedy: &str| Error::Unsupported {
            format: self.reporter.0,
            feature,
            remedy: remedy.to_owned(),
        };
        let (wayfinder, method) = self.files.get(path).ok_or_else(|| broken("it is not in the file; save it again"))?;
        let entry = self.archive.get_entry(*wayfinder).map_err(|_| damaged())?;
        if entry.local_header().flags().is_encrypted() {
            return Err(unsupported(format!("encryption ({path})"), "save it without protection"));
        }
        let packed = entry.data();
        let size = usize::try_from(entry.claim_verifier().uncompressed_size).map_err(|_| damaged())?;
        let mut bytes = self.budget.list(size)?;
        bytes.resize(size, 0);
        let unpacked = match *method {
            CompressionMethod::STORE if packed.len() == size => {
                bytes.copy_from_slice(packed);
                Some(size)
            }
            CompressionMethod::STORE => None,
            CompressionMethod::DEFLATE => {
                decompress_slice_iter_to_slice(&mut bytes, iter::once(packed), false, true).ok()
            }
            other => {
                return Err(unsupported(
                    format!("packing by method {} ({path})", other.as_u16()),
                    "pack it by deflation",
                ));
            }
        };
        if unpacked == Some(size) { Ok(bytes) } else { Err(damaged()) }
    }
}
