//! Meshes with their distances, and paths, as bytes of a file.

use std::fmt::Write as _;

use glam::DVec3;
#[cfg(feature = "gltf")]
use serde_json::json;

use crate::soup::Soup;

/// Binary little-endian PLY with `x y z distance` as doubles. `distance`: one value an input vertex, may be infinite.
///
/// # Panics
/// If there is not one distance for each vertex.
pub fn distance_ply(soup: &Soup, distance: &[f64]) -> Vec<u8> {
    assert_eq!(soup.positions.len(), distance.len(), "one distance for each vertex");
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment geodesic distance by Heatwalk\nelement vertex {}\n\
         property double x\nproperty double y\nproperty double z\nproperty double distance\n\
         element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        soup.positions.len(),
        soup.triangles.len()
    )
    .into_bytes();
    for (position, distance) in soup.positions.iter().zip(distance) {
        for value in [position.x, position.y, position.z, *distance] {
            bytes.extend(value.to_le_bytes());
        }
    }
    for triangle in &soup.triangles {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    bytes
}

/// GLB with `POSITION`, indices and two float attributes: `_REACHABLE` is 1 where the distance is finite and 0 elsewhere,
/// `_DISTANCE` is the distance, and 0 where that is infinite: a GLB file must not hold infinities (glTF 2.0, 3.6.2.2).
///
/// # Panics
/// If there is not one distance for each vertex.
#[cfg(feature = "gltf")]
pub fn distance_glb(soup: &Soup, distance: &[f64]) -> Vec<u8> {
    assert_eq!(soup.positions.len(), distance.len(), "one distance for each vertex");
    let positions: Vec<[f32; 3]> = soup.positions.iter().map(|position| position.as_vec3().to_array()).collect();
    let reachable: Vec<f32> = distance.iter().map(|distance| f32::from(u8::from(distance.is_finite()))).collect();
    let finite = |&distance: &f64| if distance.is_finite() { distance as f32 } else { 0.0 };
    let distance: Vec<f32> = distance.iter().map(finite).collect();
    let mut binary: Vec<u8> = Vec::new();
    let mut views = Vec::new();
    let mut view = |data: &mut dyn Iterator<Item = [u8; 4]>, target: u32| {
        let start = binary.len();
        binary.extend(data.flatten());
        views.push(json!({
            "buffer": 0, "byteOffset": start, "byteLength": binary.len() - start, "target": target
        }));
    };
    const ARRAY_BUFFER: u32 = 34962;
    const ELEMENT_ARRAY_BUFFER: u32 = 34963;
    view(&mut positions.iter().flatten().map(|value| value.to_le_bytes()), ARRAY_BUFFER);
    view(&mut distance.iter().map(|value| value.to_le_bytes()), ARRAY_BUFFER);
    view(&mut reachable.iter().map(|value| value.to_le_bytes()), ARRAY_BUFFER);
    view(&mut soup.triangles.iter().flatten().map(|corner| corner.to_le_bytes()), ELEMENT_ARRAY_BUFFER);

    let (lower, upper) = bounds(&positions);
    let ([least], [greatest]) = bounds(&distance.iter().map(|&value| [value]).collect::<Vec<_>>());
    const FLOAT: u32 = 5126;
    const UNSIGNED_INT: u32 = 5125;
    let count = positions.len();
    let root = json!({
        "asset": { "version": "2.0", "generator": "Heatwalk" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "_DISTANCE": 1, "_REACHABLE": 2 }, "indices": 3 }] }],
        "accessors": [
            { "bufferView": 0, "componentType": FLOAT, "count": count, "type": "VEC3", "min": lower.to_vec(), "max": upper.to_vec() },
            { "bufferView": 1, "componentType": FLOAT, "count": count, "type": "SCALAR",
              "min": [least], "max": [greatest] },
            { "bufferView": 2, "componentType": FLOAT, "count": count, "type": "SCALAR" },
            { "bufferView": 3, "componentType": UNSIGNED_INT, "count": 3 * soup.triangles.len(), "type": "SCALAR" }
        ],
        "bufferViews": views,
        "buffers": [{ "byteLength": binary.len() }]
    });
    let mut text = root.to_string().into_bytes();
    // Chunks are padded to four bytes, JSON with spaces; the binary one holds four-byte values only.
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

#[cfg(feature = "gltf")]
fn bounds<const N: usize>(rows: &[[f32; N]]) -> ([f32; N], [f32; N]) {
    let mut lower = [f32::INFINITY; N];
    let mut upper = [f32::NEG_INFINITY; N];
    for row in rows {
        for i in 0..N {
            lower[i] = lower[i].min(row[i]);
            upper[i] = upper[i].max(row[i]);
        }
    }
    (lower, upper)
}

/// OBJ with the points of a path and one line through them.
pub fn polyline_obj(points: &[DVec3]) -> Vec<u8> {
    let mut text = String::from("# path on a surface by Heatwalk\n");
    for point in points {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "v {} {} {}", point.x, point.y, point.z);
    }
    text.push('l');
    for index in 1..=points.len() {
        let _ = write!(text, " {index}");
    }
    text.push('\n');
    text.into_bytes()
}
