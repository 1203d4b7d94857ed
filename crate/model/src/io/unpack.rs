//! Files that gzip has packed (RFC 1952), and archives with one mesh and what that refers to.

use std::borrow::Cow;
use std::io::Read;

use flate2::bufread::MultiGzDecoder;

use super::archive::{self, Archive};
use super::budget::Budget;
use super::reader::Reporter;
use crate::error::Result;

/// The first bytes of what gzip has packed (2.3.1).
const GZIP_MAGIC: &[u8] = b"\x1F\x8B";
/// Bytes that are unpacked at once.
const CHUNK: usize = 1 << 16;
/// Meshes of an archive that a message names.
const NAMED: usize = 5;

/// A mesh file as readers take it.
pub struct Unpacked<'a> {
    name: Cow<'a, str>,
    bytes: Cow<'a, [u8]>,
    /// That it was in, and its path there.
    archive: Option<(Archive<'a>, String)>,
}

impl<'a> Unpacked<'a> {
    /// Of a file that may be packed by gzip, or an archive (`.zip`) with one file for which `is_mesh` says so by its path. An archive that is a
    /// mesh itself, as 3MF files are, stays as it is.
    ///
    /// # Errors
    /// [`Error::Malformed`](crate::Error::Malformed) where it is damaged, and for an archive without a mesh or with several; those of
    /// [`Archive::read`].
    pub fn of(budget: &'a Budget, name: &'a str, bytes: &'a [u8], is_mesh: fn(&str) -> bool) -> Result<Self> {
        if has_extension(name, "zip") && bytes.starts_with(archive::MAGIC) {
            let archive = Archive::open(budget, "ZIP", bytes)?;
            if let Some(mesh) = mesh_of(&archive, is_mesh)? {
                let (bytes, mesh) = (archive.read(mesh)?.into(), mesh.to_owned());
                let name = mesh.rsplit('/').next().unwrap_or(&mesh).to_owned().into();
                return Ok(Self { name, bytes, archive: Some((archive, mesh)) });
            }
        }
        if bytes.starts_with(GZIP_MAGIC) {
            let bytes = unpacked(budget, name, bytes)?.into();
            return Ok(Self { name: without_gz(name).into(), bytes, archive: None });
        }
        Ok(Self { name: name.into(), bytes: bytes.into(), archive: None })
    }

    /// Its name: in an archive that without folders, else as it was without `.gz`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What it holds.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Whether it was in an archive, in which all is that it refers to.
    pub fn is_of_archive(&self) -> bool {
        self.archive.is_some()
    }

    /// The bytes of a file of the archive that it refers to.
    pub fn resource(&self, uri: &str) -> Option<Vec<u8>> {
        let (archive, mesh) = self.archive.as_ref()?;
        archive.read(resolve(mesh, uri, archive.paths())?).ok()
    }
}

/// Whether a name ends in this, whatever the case of its letters.
pub fn has_extension(name: &str, extension: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, own)| own.eq_ignore_ascii_case(extension))
}

/// The name of a file before gzip has packed it.
pub fn without_gz(name: &str) -> &str {
    if has_extension(name, "gz") { &name[..name.len() - ".gz".len()] } else { name }
}

fn unpacked(budget: &Budget, name: &str, packed: &[u8]) -> Result<Vec<u8>> {
    let mut decoder = MultiGzDecoder::new(packed);
    let (mut bytes, mut chunk) = (Vec::new(), vec![0; CHUNK]);
    let damaged = |_| Reporter("gzip").at(name, "it is damaged or cut short; copy it again");
    loop {
        let count = decoder.read(&mut chunk).map_err(damaged)?;
        if count == 0 {
            return Ok(bytes);
        }
        budget.reserve(&mut bytes, count)?;
        bytes.extend_from_slice(&chunk[..count]);
    }
}

/// The mesh of an archive; none where the archive itself is a mesh.
fn mesh_of<'a>(archive: &'a Archive, is_mesh: fn(&str) -> bool) -> Result<Option<&'a str>> {
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
    let refused = |problem: String| Err(Reporter("ZIP").at("archive", problem));
    match meshes[..] {
        [mesh] => Ok(Some(mesh)),
        [] if paths.iter().any(|path| has_extension(path, "model")) => Ok(None),
        [] => refused("it holds no mesh of a format known here; unpack it and see what it holds".to_owned()),
        [..] => {
            let more = if meshes.len() > NAMED { ", ..." } else { "" };
            let named = meshes[..meshes.len().min(NAMED)].join(", ");
            refused(format!("it holds {} meshes ({named}{more}); unpack it and name one", meshes.len()))
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
