//! Where the steps work.

use std::path::Path;

/// The folder of the whole project.
pub fn workspace() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("crate/xtask lies two folders down")
}
