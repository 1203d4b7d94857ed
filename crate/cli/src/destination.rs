//! Where files are written: on the disk as a whole, or to standard output.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::ops::ControlFlow;
#[cfg(unix)]
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use tempfile::{Builder, NamedTempFile};

/// In place of a file: standard output.
pub const STANDARD: &str = "-";

/// Whether a file is standard output: `-`, or `-.ply` of another format than the usual one.
pub fn is_standard(path: &Path) -> bool {
    let name = path.to_str().and_then(|name| name.strip_prefix(STANDARD));
    name.is_some_and(|rest| rest.is_empty() || rest.starts_with('.') && !rest.contains('/'))
}

/// Writes to standard output, and tells whether to go on: not where whoever reads the pipe has seen enough, which is no error.
pub fn print(bytes: &[u8]) -> Result<ControlFlow<()>> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(bytes).and_then(|()| stdout.flush()) {
        Ok(()) => Ok(ControlFlow::Continue(())),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(ControlFlow::Break(())),
        Err(error) => bail!("cannot write to standard output: {error}"),
    }
}

/// Whether a file can be written, without a change to it.
pub fn check(path: &Path) -> io::Result<()> {
    if path.exists() {
        OpenOptions::new().write(true).open(path)?;
    }
    if is_special(path) { Ok(()) } else { beside(&target(path)).map(drop) }
}

/// Writes a file beside the one of this path, whose place it takes when it is whole: where the disk is full or the program is ended,
/// what was there stays.
pub fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if is_special(path) {
        return fs::write(path, bytes);
    }
    let path = target(path);
    let mut file = beside(&path)?;
    file.write_all(bytes)?;
    if let Ok(earlier) = fs::metadata(&path) {
        file.as_file().set_permissions(earlier.permissions())?;
    }
    file.persist(path)?;
    Ok(())
}

/// A device or a pipe has no place to take.
fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|file| !file.is_file())
}

/// The file that a link leads to.
pub fn target(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

/// A file in the same folder, removed at its end.
pub fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = Builder::new();
    builder.prefix(".heatwalk-");
    // As the user has files made, not for the user alone.
    #[cfg(unix)]
    builder.permissions(fs::Permissions::from_mode(0o666));
    builder.tempfile_in(folder)
}
