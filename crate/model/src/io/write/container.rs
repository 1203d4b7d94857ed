//! GLB: the container and the buffer of a glTF file that is written (glTF 2.0, 3.6 and 4).

use serde_json::{Value, json};

const INT: u32 = 5125;
const FLOAT: u32 = 5126;
pub(super) const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// A GLB file that grows: its buffer with views and accessors. The rest is JSON.
#[derive(Default)]
pub struct GlbFile {
    binary: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
}

impl GlbFile {
    pub(super) fn view(&mut self, bytes: &[u8]) -> Value {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() });
        self.binary.extend(bytes);
        view
    }

    /// The index of a new accessor. Its numbers have the byte order of the machine, little-endian wherever this runs.
    pub(super) fn accessor<T: bytemuck::NoUninit>(
        &mut self,
        rows: &[T],
        component: u32,
        kind: &str,
        count: usize,
        target: u32,
    ) -> usize {
        let mut view = self.view(bytemuck::cast_slice(rows));
        view["target"] = target.into();
        self.views.push(view);
        let view = self.views.len() - 1;
        self.accessors.push(json!({ "bufferView": view, "componentType": component, "count": count, "type": kind }));
        self.accessors.len() - 1
    }

    /// The index of a new accessor of floats for vertices, with the bounds that positions must have; `kind`: `SCALAR`, `VEC3`.
    pub fn bounded<const N: usize>(&mut self, rows: &[[f32; N]], kind: &str) -> usize {
        let index = self.accessor(rows.as_flattened(), FLOAT, kind, rows.len(), ARRAY_BUFFER);
        let bound = |start: f32, better: fn(f32, f32) -> f32| -> Vec<f32> {
            (0..N).map(|i| rows.iter().map(|row| row[i]).fold(start, better)).collect()
        };
        self.accessors[index]["min"] = bound(f32::INFINITY, f32::min).into();
        self.accessors[index]["max"] = bound(f32::NEG_INFINITY, f32::max).into();
        index
    }

    /// The index of a new accessor of indices of vertices.
    pub fn indices(&mut self, indices: &[u32]) -> usize {
        self.accessor(indices, INT, "SCALAR", indices.len(), ELEMENT_ARRAY_BUFFER)
    }

    /// The bytes of the file. `root`: the object of glTF, without accessors, views and buffers.
    pub fn finish(self, mut root: Value) -> Vec<u8> {
        let Self { mut binary, views, accessors } = self;
        binary.resize(binary.len().next_multiple_of(4), 0);
        // Lists of nothing are not allowed.
        if !accessors.is_empty() {
            root["accessors"] = accessors.into();
            root["bufferViews"] = views.into();
            root["buffers"] = json!([{ "byteLength": binary.len() }]);
        }
        let mut text = root.to_string().into_bytes();
        // Chunks are padded to four bytes, JSON with spaces.
        text.resize(text.len().next_multiple_of(4), b' ');
        let length = 12 + 8 + text.len() + 8 + binary.len();
        let mut bytes = Vec::with_capacity(length);
        bytes.extend(b"glTF");
        bytes.extend([2, length as u32].iter().flat_map(|word| word.to_le_bytes()));
        for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &binary)] {
            bytes.extend((chunk.len() as u32).to_le_bytes());
            bytes.extend(kind);
            bytes.extend(chunk);
        }
        bytes
    }
}
