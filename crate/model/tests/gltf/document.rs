//! glTF documents made in code.

use heatwalk_model::{Model, Result};
use heatwalk_surface::Soup;
use serde_json::{Value, json};

use crate::reading::read_model;

/// Builds a glTF document around a growing buffer.
pub struct Builder {
    pub root: Value,
    pub binary: Vec<u8>,
}

impl Builder {
    pub fn new(nodes: Value, meshes: Value) -> Self {
        let mut root = json!({ "asset": { "version": "2.0" }, "accessors": [], "bufferViews": [] });
        root["nodes"] = nodes;
        root["meshes"] = meshes;
        Self { root, binary: Vec::new() }
    }

    pub fn view(&mut self, bytes: &[u8]) -> usize {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() });
        self.binary.extend(bytes);
        let views = self.root["bufferViews"].as_array_mut().unwrap();
        views.push(view);
        views.len() - 1
    }

    pub fn accessor(&mut self, component: u32, kind: &str, count: usize, bytes: &[u8]) -> &mut Value {
        let view = self.view(bytes);
        let accessors = self.root["accessors"].as_array_mut().unwrap();
        accessors.push(json!({ "bufferView": view, "componentType": component, "type": kind, "count": count }));
        accessors.last_mut().unwrap()
    }

    pub fn floats(&mut self, kind: &str, count: usize, values: &[f32]) -> &mut Value {
        self.accessor(5126, kind, count, &values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>())
    }

    pub fn glb(&self) -> Vec<u8> {
        let mut root = self.root.clone();
        root["buffers"] = json!([{ "byteLength": self.binary.len() }]);
        let mut text = root.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF\x02\0\0\0".to_vec();
        bytes.extend((28 + text.len() as u32 + self.binary.len() as u32).to_le_bytes());
        bytes.extend((text.len() as u32).to_le_bytes());
        bytes.extend(b"JSON");
        bytes.extend(text);
        bytes.extend((self.binary.len() as u32).to_le_bytes());
        bytes.extend(b"BIN\0");
        bytes.extend(&self.binary);
        bytes
    }

    pub fn gltf(&self, uri: &str) -> String {
        let mut root = self.root.clone();
        root["buffers"] = json!([{ "byteLength": self.binary.len(), "uri": uri }]);
        root.to_string()
    }

    pub fn read(&self) -> Result<Soup> {
        self.model().map(|model| model.soup)
    }

    pub fn model(&self) -> Result<Model> {
        read_model("mesh.glb", self.glb())
    }
}

const SQUARE: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];

/// A unit square: accessor 0 positions, accessor 1 the indices of two triangles.
pub fn square(nodes: Value) -> Builder {
    let mut builder =
        Builder::new(nodes, json!([{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }]));
    builder.floats("VEC3", 4, &SQUARE);
    builder.accessor(5121, "SCALAR", 6, &[0, 1, 2, 0, 2, 3]);
    builder
}
