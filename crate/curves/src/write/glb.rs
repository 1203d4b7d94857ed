//! Isolines as lines of a GLB file.

use heatwalk_model::io::write::GlbFile;
use serde_json::{Value, json};

use crate::isolines::{Isolines, Kind};

/// `mode` of a primitive that is pairs of vertices (glTF 2.0, 5.24.4).
const LINES: u32 = 1;

/// A node and a mesh an isoline that has curves, called by its value, which `extras` has as a number; a girth is called so.
pub fn glb(isolines: &Isolines) -> Vec<u8> {
    let mut file = GlbFile::default();
    let (mut nodes, mut meshes) = (Vec::new(), Vec::new());
    let curved = isolines.isolines.iter().enumerate().filter(|(_, isoline)| !isoline.curves.is_empty());
    for (index, isoline) in curved {
        let (mut positions, mut indices) = (Vec::new(), Vec::new());
        for curve in &isoline.curves {
            let first = positions.len() as u32;
            let count = curve.points.len() as u32;
            positions.extend(curve.points.iter().map(|point| point.as_vec3().to_array()));
            let segments = 0..curve.triangles.len() as u32;
            indices.extend(segments.flat_map(|index| [first + index, first + (index + 1) % count]));
        }
        let primitive = json!({
            "mode": LINES,
            "attributes": { "POSITION": file.bounded(&positions, "VEC3") },
            "indices": file.indices(&indices),
        });
        let (name, extras) = match &isolines.kind {
            Kind::Isolines => (format!("isoline {}", isoline.value), json!({ "distance": isoline.value })),
            Kind::Girth | Kind::Paths(_) => (isolines.name(index), json!({})),
            Kind::Borders(cells) => (isolines.name(index), json!({ "cells": cells[index] })),
        };
        nodes.push(json!({ "name": name, "mesh": meshes.len() }));
        meshes.push(json!({ "primitives": [primitive], "extras": extras }));
    }
    file.finish(root(nodes, meshes))
}

fn root(nodes: Vec<Value>, meshes: Vec<Value>) -> Value {
    let mut root = json!({ "asset": { "version": "2.0", "generator": "Heatwalk" }, "scene": 0 });
    // Lists of nothing are not allowed.
    if nodes.is_empty() {
        root["scenes"] = json!([{}]);
        return root;
    }
    root["scenes"] = json!([{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }]);
    root["nodes"] = nodes.into();
    root["meshes"] = meshes.into();
    root
}
