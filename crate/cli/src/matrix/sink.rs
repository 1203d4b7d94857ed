//! Where rows go.

use std::fs::{self, File};
use std::io;
use std::ops::ControlFlow;
use std::path::Path;

use anyhow::{Context, Result};

use super::npz;
use super::part::Part;
use super::row::Layout;
use crate::destination::{beside, is_standard, print, target};

/// A file that another run can go on with, or standard output.
pub enum Sink {
    File(Box<Part>),
    Standard { rows: usize },
}

impl Sink {
    /// `head`: what the file begins with, before all rows.
    pub fn open(path: &Path, head: &[u8], fingerprint: &str) -> Result<Self> {
        if !is_standard(path) {
            return Ok(Self::File(Box::new(Part::open(&target(path), head, fingerprint)?)));
        }
        // Whoever has seen enough says so again at the first row.
        let _ = print(head)?;
        Ok(Self::Standard { rows: 0 })
    }

    /// Rows that are written.
    pub fn rows(&self) -> usize {
        match self {
            Self::File(part) => part.rows(),
            Self::Standard { rows } => *rows,
        }
    }

    /// What becomes of finished rows where no more can be written.
    pub fn kept(&self) -> &'static str {
        match self {
            Self::File(_) => " and kept; the same command goes on from there",
            Self::Standard { .. } => "",
        }
    }

    /// Writes further rows, and tells whether anybody wants more.
    pub fn append(&mut self, rows: &[Vec<u8>]) -> Result<ControlFlow<()>> {
        match self {
            Self::File(part) => part.append(rows).map(ControlFlow::Continue),
            Self::Standard { rows: written } => {
                *written += rows.len();
                print(&rows.concat())
            }
        }
    }

    /// Makes the file, of all rows.
    pub fn finish(self, layout: &Layout, shape: [usize; 2]) -> Result<()> {
        let part = match self {
            Self::File(part) => part,
            Self::Standard { .. } => return Ok(()),
        };
        match layout {
            Layout::Sparse(number) => {
                let target = part.target();
                let put_together = || -> Result<()> {
                    let file = beside(target)?;
                    npz::assemble(part.file(), *number, shape, file.as_file())?;
                    keep_permissions(file.as_file(), target)?;
                    file.as_file().sync_all()?;
                    file.persist(target)?;
                    Ok(())
                };
                put_together().with_context(|| {
                    format!("cannot write {}; all rows are kept; the same command writes it again", target.display())
                })?;
                part.remove()
            }
            Layout::Dense(_) | Layout::Text(..) | Layout::Triples(..) => {
                keep_permissions(part.file(), part.target())?;
                part.persist()
            }
        }
    }
}

/// Gives a file the permissions of the one whose place it takes.
fn keep_permissions(file: &File, target: &Path) -> io::Result<()> {
    match fs::metadata(target) {
        Ok(earlier) => file.set_permissions(earlier.permissions()),
        Err(_) => Ok(()),
    }
}
