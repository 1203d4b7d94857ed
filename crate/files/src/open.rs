//! Mesh files as readers take them.

use std::fs;
use std::io::{Error, ErrorKind, Read};
use std::path::{Component, Path};

use anyhow::{Context, Result, bail};
use flate2::read::MultiGzDecoder;
use heatwalk_model::io::{self, Archive, Budget, Resources};
use heatwalk_volume::io::Format;

/// The first bytes of what gzip has packed (RFC 1952, 2.3.1).
const GZIP_MAGIC: &[u8] = b"\x1F\x8B";
/// Bytes that are unpacked at once.
const CHUNK: usize = 1 << 16;
/// Meshes of an archive that a message names.
const NAMED: usize = 5;

/// A mesh file.
pub struct MeshFile<'a> {
    /// Its name without that of its folder, and without `.gz`.
    pub name: &'a str,
    /// What it holds.
    pub bytes: &'a [u8],
    /// By the size of the file on the disk.
    pub budget: &'a Budget,
    /// What it refers to, beside or below it.
    pub resources: Resources<'a>,
}

/// Reads a file, which may be packed by gzip (`.gz`), or an archive with one mesh and what that refers to (`.zip`).
///
/// # Errors
/// Where the file cannot be read or unpacked, and those of `read`.
pub fn open<T>(path: &Path, read: impl FnOnce(MeshFile) -> Result<T>) -> Result<T> {
    let bytes = read_file(path).with_context(|| format!("cannot read {}", path.display()))?;
    opened(path, &bytes, path.parent(), read)
}

/// The same of the bytes of a file. `folder`: where that is from which it may bring in others.
pub fn opened<T>(
    path: &Path,
    bytes: &[u8],
    folder: Option<&Path>,
    read: impl FnOnce(MeshFile) -> Result<T>,
) -> Result<T> {
    let budget = &Budget::of_file(bytes.len());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if has_extension(&name, "zip") && bytes.starts_with(io::ARCHIVE_MAGIC) {
        let archive = Archive::open(budget, "ZIP", bytes).with_context(|| path.display().to_string())?;
        if let Some(mesh) = mesh_of(&archive).with_context(|| path.display().to_string())? {
            let bytes = archive.read(mesh).with_context(|| path.display().to_string())?;
            let name = mesh.rsplit('/').next().unwrap_or(mesh);
            let resources = |uri: &str| archive.read(resolve(mesh, uri, archive.paths())?).ok();
            return read(MeshFile { name, bytes: &bytes, budget, resources: &resources });
        }
    }
    let resources = |uri: &str| {
        let file = folder.filter(|_| is_beside(Path::new(uri)))?.join(uri);
        read_file(&file).ok().and_then(|bytes| budget.admit(bytes).ok())
    };
    if bytes.starts_with(GZIP_MAGIC) {
        let bytes = unpack(budget, bytes).with_context(|| path.display().to_string())?;
        return read(MeshFile { name: without_gz(&name), bytes: &bytes, budget, resources: &resources });
    }
    read(MeshFile { name: &name, bytes, budget, resources: &resources })
}

/// Whether the file may hold tetrahedra, by its name.
pub fn may_hold_tetrahedra(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    has_extension(&name, "zip") || Format::of_name(without_gz(&name)).is_some()
}

/// Whether a file is a mesh by its name, or may be one that is packed.
pub fn names_mesh(name: &str) -> bool {
    has_extension(name, "zip") || is_mesh(without_gz(name))
}

fn is_mesh(path: &str) -> bool {
    io::names_mesh(path) || Format::of_name(path).is_some()
}

/// Devices and pipes may never end, so only plain files are read.
fn read_file(path: &Path) -> Result<Vec<u8>> {
    if !fs::metadata(path)?.is_file() {
        return Err(Error::new(ErrorKind::InvalidInput, "it is not a file").into());
    }
    Ok(fs::read(path)?)
}

/// A mesh may bring in files beside or below it, never from elsewhere on the disk.
fn is_beside(uri: &Path) -> bool {
    uri.components().all(|component| matches!(component, Component::Normal(_) | Component::CurDir))
}

fn has_extension(name: &str, extension: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, own)| own.eq_ignore_ascii_case(extension))
}

fn without_gz(name: &str) -> &str {
    if has_extension(name, "gz") { &name[..name.len() - ".gz".len()] } else { name }
}

fn unpack(budget: &Budget, packed: &[u8]) -> Result<Vec<u8>> {
    let mut decoder = MultiGzDecoder::new(packed);
    let (mut bytes, mut chunk) = (Vec::new(), vec![0; CHUNK]);
    loop {
        let count = decoder.read(&mut chunk).context("what gzip has packed is damaged or cut short; copy it again")?;
        if count == 0 {
            return Ok(bytes);
        }
        budget.reserve(&mut bytes, count)?;
        bytes.extend_from_slice(&chunk[..count]);
    }
}

/// The mesh of an archive; none where the archive itself is a mesh, as 3MF files are.
fn mesh_of<'a>(archive: &'a Archive) -> Result<Option<&'a str>> {
    let paths = archive.paths();
    // What systems put beside the files of the user.
    let is_hidden = |path: &str| path.split('/').any(|step| step.starts_with('.') || step == "__MACOSX");
    // A pair of files of TetGen is one mesh.
    let is_second = |path: &str| {
        let node = path.strip_suffix(".ele").map(|stem| format!("{stem}.node"));
        node.is_some_and(|node| paths.contains(&node))
    };
    let meshes = paths.iter().map(String::as_str);
    let meshes: Vec<&str> = meshes.filter(|path| is_mesh(path) && !is_hidden(path) && !is_second(path)).collect();
    match meshes[..] {
        [mesh] => Ok(Some(mesh)),
        [] if paths.iter().any(|path| has_extension(path, "model")) => Ok(None),
        [] => bail!("the archive holds no mesh of a format known here"),
        [..] => {
            let more = if meshes.len() > NAMED { ", ..." } else { "" };
            let named = meshes[..meshes.len().min(NAMED)].join(", ");
            bail!("the archive holds {} meshes ({named}{more}); unpack it and name one", meshes.len())
        }
    }
}

/// The path of the file that a mesh refers to: relative to the mesh, else by its name alone where one file has it.
fn resolve<'a>(mesh: &str, uri: &str, paths: &'a [String]) -> Option<&'a str> {
    let uri = uri.replace('\\', "/");
    let mut steps: Vec<&str> = mesh.split('/').collect();
    steps.pop();
    for step in uri.split('/') {
        match step {
            ".." => drop(steps.pop()),
            "" | "." => {}
            step => steps.push(step),
        }
    }
    let wanted = steps.join("/");
    let file_name = |path: &str| path.rsplit('/').next().unwrap_or_default().to_lowercase();
    let mut named = paths.iter().filter(|path| file_name(path) == file_name(&wanted));
    let alone = named.next().filter(|_| named.next().is_none());
    paths.iter().find(|path| **path == wanted).or(alone).map(String::as_str)
}
