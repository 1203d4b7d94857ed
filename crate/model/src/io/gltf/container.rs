//! The GLB container and the buffers: binary chunk, data URIs and files beside the mesh.

use std::cell::OnceCell;

use base64::Engine as _;
use draco_core::Mesh;
use gltf::json::{Index, Root, buffer};
use percent_encoding::percent_decode_str;

use super::format::{GLB_MAGIC, GLTF, element};
use super::meshopt::Compression;
use crate::error::{Error, Result};
use crate::io::base64::BASE64;
use crate::io::budget::Budget;
use crate::io::reader::Resources;
use crate::io::text::without_mark;

/// A larger number is no version: there is none above 2, and each takes years.
const LAST_VERSION: u32 = 99;
const JSON_CHUNK: &[u8] = b"JSON";
const BINARY_CHUNK: &[u8] = b"BIN\0";

/// The two chunks of a GLB file, or a plain JSON file.
pub struct Container<'a> {
    pub json: &'a [u8],
    pub binary: Option<&'a [u8]>,
}

fn byte(at: usize) -> String {
    format!("byte {at}")
}

pub fn open(bytes: &[u8]) -> Result<Container<'_>> {
    if !bytes.starts_with(GLB_MAGIC) {
        if !without_mark(bytes).trim_ascii_start().starts_with(b"{") {
            return Err(GLTF.at(byte(0), "the file begins neither as GLB nor as JSON; export it again"));
        }
        return Ok(Container { json: bytes, binary: None });
    }
    let cut_short = |at: usize| GLTF.at(byte(at), "the GLB file is cut short; copy it again");
    let version = word(bytes, 4).ok_or_else(|| cut_short(bytes.len()))?;
    if version > LAST_VERSION {
        return Err(GLTF
            .at(byte(GLB_MAGIC.len()), format!("the GLB file is damaged: {version} is no version; export it again")));
    }
    if version != 2 {
        return Err(Error::Unsupported {
            format: "GLB",
            feature: format!("version {version}"),
            remedy: "export the file as glTF 2.0".to_owned(),
        });
    }
    let mut json = None;
    let mut binary = None;
    let mut offset = 12;
    while let (Some(length), Some(kind)) = (word(bytes, offset), bytes.get(offset + 4..offset + 8)) {
        let start = offset + 8;
        let end = start.checked_add(length as usize);
        match (kind, end.and_then(|end| bytes.get(start..end))) {
            (JSON_CHUNK, Some(chunk)) => json = json.or(Some(chunk)),
            (BINARY_CHUNK, Some(chunk)) => binary = binary.or(Some(chunk)),
            (JSON_CHUNK | BINARY_CHUNK, None) => return Err(cut_short(bytes.len())),
            (_, Some(_)) => {}
            // What some programs leave behind the end.
            (_, None) => break,
        }
        offset = start + length as usize;
    }
    Ok(Container { json: json.ok_or_else(|| cut_short(offset))?, binary })
}

fn word(bytes: &[u8], offset: usize) -> Option<u32> {
    bytes.get(offset..)?.first_chunk().map(|&bytes| u32::from_le_bytes(bytes))
}

/// The buffers, each resolved when something first reads it: a file may refer to textures that nobody needs, and name
/// buffers without bytes for those who cannot read compressed ones.
pub struct Buffers<'a> {
    pub budget: &'a Budget,
    root: &'a Root,
    binary: Option<&'a [u8]>,
    resources: Resources<'a>,
    /// What files and data URIs hold.
    resolved: Vec<OnceCell<Vec<u8>>>,
    /// What compressed views hold.
    decoded: Vec<OnceCell<Vec<u8>>>,
    /// What views compressed by Draco hold.
    meshes: Vec<OnceCell<Mesh>>,
}

impl<'a> Buffers<'a> {
    pub fn new(budget: &'a Budget, root: &'a Root, binary: Option<&'a [u8]>, resources: Resources<'a>) -> Self {
        let resolved = root.buffers.iter().map(|_| OnceCell::new()).collect();
        let decoded = root.buffer_views.iter().map(|_| OnceCell::new()).collect();
        let meshes = root.buffer_views.iter().map(|_| OnceCell::new()).collect();
        Self { budget, root, binary, resources, resolved, decoded, meshes }
    }

    /// The bytes of a view, with its stride.
    pub fn view(&self, index: Index<buffer::View>) -> Result<(&[u8], Option<usize>)> {
        let view = element(&self.root.buffer_views, index, "buffer view")?;
        let damaged = |problem: &str| {
            GLTF.at(format!("buffer view {}", index.value()), format!("{problem}; export the file again"))
        };
        let slice = match Compression::of(view).map_err(damaged)? {
            None => self.slice(index, view)?,
            Some(compression) => get_or_try_init(&self.decoded[index.value()], || {
                self.budget.take(compression.bytes())?;
                compression.decode(self.slice(index, &compression.source)?).map_err(damaged)
            })?,
        };
        // A stride of 0 is what some exporters write for "tightly packed".
        Ok((slice, view.byte_stride.map(|stride| stride.0).filter(|&stride| stride > 0)))
    }

    /// The bytes of a view, to keep.
    pub fn copy(&self, index: Index<buffer::View>) -> Result<Vec<u8>> {
        let (bytes, _) = self.view(index)?;
        self.budget.take(bytes.len() as u64)?;
        Ok(bytes.to_vec())
    }

    /// The mesh that a view is compressed from, by what decodes its bytes.
    pub fn mesh(&self, index: Index<buffer::View>, decode: impl FnOnce(&[u8]) -> Result<Mesh>) -> Result<&Mesh> {
        let (bytes, _) = self.view(index)?;
        get_or_try_init(&self.meshes[index.value()], || decode(bytes))
    }

    /// The bytes of a view, or of what it is decoded from.
    fn slice(&self, index: Index<buffer::View>, view: &buffer::View) -> Result<&[u8]> {
        element(&self.root.buffers, view.buffer, "buffer")?;
        let buffer = view.buffer.value();
        let bytes = self.bytes(buffer)?;
        let start = view.byte_offset.map_or(Some(0), |offset| usize::try_from(offset.0).ok());
        let length = usize::try_from(view.byte_length.0).ok();
        let range = start.zip(length).and_then(|(start, length)| Some(start..start.checked_add(length)?));
        range.and_then(|range| bytes.get(range)).ok_or_else(|| {
            GLTF.at(
                format!("buffer view {}", index.value()),
                format!("it reaches beyond its buffer of {} bytes; the file is cut short", bytes.len()),
            )
        })
    }

    /// Length of all that has been read so far, compressed and decoded.
    pub fn resolved_bytes(&self) -> usize {
        let read = self.resolved.iter().chain(&self.decoded).filter_map(OnceCell::get);
        self.binary.map_or(0, <[u8]>::len) + read.map(Vec::len).sum::<usize>()
    }

    fn bytes(&self, index: usize) -> Result<&[u8]> {
        match (&self.root.buffers[index].uri, self.binary) {
            (Some(uri), _) => get_or_try_init(&self.resolved[index], || self.resolve(index, uri)).map(Vec::as_slice),
            (None, Some(binary)) if index == 0 => Ok(binary),
            _ => Err(GLTF.at(place(index), "it has neither a URI nor a binary chunk; export the file again")),
        }
    }

    fn resolve(&self, index: usize, uri: &str) -> Result<Vec<u8>> {
        self.fetch(uri, || place(index))
    }

    /// The bytes behind a URI: those of a data URI, or of a file beside the mesh.
    pub fn fetch(&self, uri: &str, place: impl Fn() -> String) -> Result<Vec<u8>> {
        // Data URIs are those of RFC 2397; the name of a scheme may be in capitals.
        if let Some((_, data)) = uri.split_once(':').filter(|(scheme, _)| scheme.eq_ignore_ascii_case("data")) {
            let (kind, encoded) = data
                .split_once(',')
                .ok_or_else(|| GLTF.at(place(), "its data URI has no comma before the data; export the file again"))?;
            let bytes: Vec<u8> = percent_decode_str(encoded).collect();
            let is_base64 = kind.rsplit(';').next().is_some_and(|last| last.trim().eq_ignore_ascii_case("base64"));
            if !is_base64 {
                return Ok(bytes);
            }
            return decode_base64(&bytes)
                .ok_or_else(|| GLTF.at(place(), "its base64 data is damaged; export the file again"));
        }
        let uri = percent_decode_str(uri).decode_utf8_lossy().into_owned();
        (self.resources)(&uri).ok_or(Error::MissingResource { uri })
    }
}

fn place(buffer: usize) -> String {
    format!("buffer {buffer}")
}

/// `OnceCell::get_or_try_init`, which the standard library does not offer yet.
fn get_or_try_init<T>(cell: &OnceCell<T>, init: impl FnOnce() -> Result<T>) -> Result<&T> {
    match cell.get() {
        Some(value) => Ok(value),
        None => init().map(|value| cell.get_or_init(|| value)),
    }
}

/// Either alphabet of RFC 4648; lines may be broken.
fn decode_base64(text: &[u8]) -> Option<Vec<u8>> {
    let letters = text.iter().filter(|letter| !letter.is_ascii_whitespace()).map(|letter| match letter {
        b'-' => b'+',
        b'_' => b'/',
        &letter => letter,
    });
    BASE64.decode(letters.collect::<Vec<u8>>()).ok()
}
