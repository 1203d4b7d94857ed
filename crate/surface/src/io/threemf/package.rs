//! The files inside of a 3MF file: an archive by the rules of OPC (ECMA-376, part 2).

use std::cell::Cell;
use std::collections::HashMap;

use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveEntryWayfinder, ZipSliceArchive};

use super::format::THREEMF;
use crate::error::{Error, Result};
use crate::io::xml::{Document, Node, attributes};

/// Bytes that may be unpacked of a file.
const MOST_BYTES: usize = 1 << 30;
/// What is packed tighter than this, and is not small, only claims to be a mesh: these are packed by 2 to 20.
const MOST_RATIO: usize = 250;
const SMALL_BYTES: usize = 1 << 24;
const MOST_FILES: usize = 10_000;

/// Where a package without relationships has its model.
const USUAL_MODEL: &str = "3D/3dmodel.model";

pub struct Package<'a> {
    archive: ZipSliceArchive<&'a [u8]>,
    /// By path, without the slash at its beginning, in lower case (OPC compares paths so, by ASCII).
    files: HashMap<String, (ZipArchiveEntryWayfinder, CompressionMethod)>,
    /// Bytes that may still be unpacked.
    left: Cell<usize>,
}

impl<'a> Package<'a> {
    pub fn open(bytes: &'a [u8]) -> Result<Self> {
        let damaged = |_| THREEMF.at("archive", "it is damaged or cut short; copy it again");
        let archive = ZipArchive::from_slice(bytes).map_err(damaged)?;
        let mut files = HashMap::new();
        let mut entries = archive.entries();
        while let Some(entry) = entries.next_entry().map_err(damaged)? {
            if files.len() == MOST_FILES {
                return Err(THREEMF.at("archive", format!("it holds more than {MOST_FILES} files; save it again")));
            }
            let path = String::from_utf8_lossy(entry.file_path().as_ref()).to_ascii_lowercase();
            files.insert(key(&path), (entry.wayfinder(), entry.compression_method()));
        }
        Ok(Self { archive, files, left: Cell::new(MOST_BYTES) })
    }

    /// The path of the model that is to be read.
    pub fn root(&self) -> Result<String> {
        let Ok(relationships) = self.text("_rels/.rels") else { return Ok(USUAL_MODEL.to_owned()) };
        let mut document = Document::new(THREEMF, "_rels/.rels", &relationships);
        while let Some(node) = document.next()? {
            let Node::Start { element, .. } = node else { continue };
            let (mut is_model, mut target) = (false, None);
            for (name, value) in attributes(&element) {
                match name {
                    "Type" => is_model = value.ends_with("/3dmodel"),
                    "Target" => target = Some(value.into_owned()),
                    _ => {}
                }
            }
            if let Some(target) = target.filter(|_| is_model) {
                return Ok(target);
            }
        }
        Ok(USUAL_MODEL.to_owned())
    }

    /// A file of the package as text.
    ///
    /// # Errors
    /// Where it is not there, damaged, encrypted, or too large.
    pub fn text(&self, path: &str) -> Result<String> {
        let broken = |problem: &str| THREEMF.at(path.trim_start_matches('/'), problem);
        let (wayfinder, method) = self
            .files
            .get(&key(&path.to_ascii_lowercase()))
            .ok_or_else(|| broken("it is not in the file; save the model again"))?;
        let damaged = || broken("it is damaged or cut short; copy the file again");
        let entry = self.archive.get_entry(*wayfinder).map_err(|_| damaged())?;
        if entry.local_header().flags().is_encrypted() {
            return Err(Error::Unsupported {
                format: "3MF",
                feature: format!("encryption ({path})"),
                remedy: "save the model without protection".to_owned(),
            });
        }
        let packed = entry.data();
        let most = self.left.get().min(SMALL_BYTES.max(packed.len().saturating_mul(MOST_RATIO)));
        let too_large =
            || broken("it takes too much room unpacked, so that the file is damaged or made to; save the model again");
        let bytes = match *method {
            CompressionMethod::STORE if packed.len() > most => return Err(too_large()),
            CompressionMethod::STORE => packed.to_vec(),
            CompressionMethod::DEFLATE => decompress_to_vec_with_limit(packed, most).map_err(|error| {
                if error.status == miniz_oxide::inflate::TINFLStatus::HasMoreOutput { too_large() } else { damaged() }
            })?,
            other => {
                return Err(Error::Unsupported {
                    format: "3MF",
                    feature: format!("packing by method {}", other.as_u16()),
                    remedy: "save the model again".to_owned(),
                });
            }
        };
        if entry.claim_verifier().uncompressed_size != bytes.len() as u64 {
            return Err(damaged());
        }
        self.left.set(self.left.get() - bytes.len());
        String::from_utf8(bytes).map_err(|_| broken("it is not text in UTF-8; save the model again"))
    }
}

/// How a path is looked up.
fn key(path: &str) -> String {
    path.trim_start_matches('/').to_owned()
}
