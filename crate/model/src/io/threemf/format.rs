//! What every part of the reader knows of 3MF.

use crate::io::reader::Reporter;

pub const THREEMF: Reporter = Reporter("3MF");
