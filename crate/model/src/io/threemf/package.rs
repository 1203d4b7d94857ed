//! The files inside of a 3MF file: an archive by the rules of OPC (ECMA-376, part 2).

use std::collections::HashMap;

use super::format::THREEMF;
use crate::error::Result;
use crate::io::archive::Archive;
use crate::io::budget::Budget;
use crate::io::xml::{Document, Node, attributes};

/// Where a package without relationships has its model.
const USUAL_MODEL: &str = "3D/3dmodel.model";

pub struct Package<'a> {
    pub budget: &'a Budget,
    archive: Archive<'a>,
    /// The paths in the archive by what they are looked up by.
    paths: HashMap<String, String>,
}

impl<'a> Package<'a> {
    pub fn open(budget: &'a Budget, bytes: &'a [u8]) -> Result<Self> {
        let archive = Archive::open(budget, THREEMF.0, bytes)?;
        let paths = archive.paths().iter().map(|path| (key(path), path.clone())).collect();
        Ok(Self { budget, archive, paths })
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
        let written = self.paths.get(&key(path)).map_or(path.trim_start_matches('/'), String::as_str);
        let bytes = self.archive.read(written)?;
        String::from_utf8(bytes).map_err(|_| THREEMF.at(written, "it is not text in UTF-8; save the model again"))
    }
}

/// How a path is looked up: without the slash at its beginning, in lower case (OPC compares paths so, by ASCII).
fn key(path: &str) -> String {
    path.trim_start_matches('/').to_ascii_lowercase()
}
