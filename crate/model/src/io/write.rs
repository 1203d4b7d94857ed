//! Meshes with their distances, and paths, as bytes of a file.

use std::fmt::Write as _;

use glam::DVec3;
use heatwalk_surface::{Part, Soup};

#[cfg(feature = "gltf")]
mod container;
#[cfg(feature = "gltf")]
mod glb;
#[cfg(feature = "gifti")]
pub mod overlay;
#[cfg(feature = "gltf")]
pub use container::GlbFile;
#[cfg(feature = "gltf")]
pub use glb::distance_glb;

/// Binary little-endian PLY with `x y z distance` as doubles, all vertices of the input in its order and the triangles of its parts.
/// `distance`: one value an input vertex, may be infinite.
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
        soup.parts.iter().map(Part::len).sum::<usize>()
    )
    .into_bytes();
    for (position, distance) in soup.positions.iter().zip(distance) {
        for value in [position.x, position.y, position.z, *distance] {
            bytes.extend(value.to_le_bytes());
        }
    }
    push_faces(&mut bytes, soup);
    bytes
}

/// CSV with columns of distances by their names, a row an input vertex: 17 significant digits, which give every double back,
/// and `inf` where nothing leads.
///
/// # Panics
/// If the columns are not equally long.
pub fn distance_csv(columns: &[(&str, &[f64])]) -> Vec<u8> {
    let rows = columns.first().map_or(0, |(_, values)| values.len());
    assert!(columns.iter().all(|(_, values)| values.len() == rows), "one distance for each vertex");
    let mut text = String::from("vertex");
    columns.iter().for_each(|(name, _)| text.extend([",", name]));
    for vertex in 0..rows {
        // Writing to a String cannot fail.
        let _ = write!(text, "\n{vertex}");
        for (_, values) in columns {
            let _ = write!(text, ",{:.16e}", values[vertex]);
        }
    }
    text.push('\n');
    text.into_bytes()
}

/// How many bytes the beginning of a NumPy file is a multiple of.
const NPY_ALIGNMENT: usize = 64;

/// A NumPy file (format 1.0 of `numpy.lib.format`) of doubles, one an input vertex, `inf` where nothing leads.
pub fn distance_npy(distance: &[f64]) -> Vec<u8> {
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}", distance.len());
    // Magic string, version and length are ten bytes, and a line feed ends it.
    let padded = (10 + header.len() + 1).next_multiple_of(NPY_ALIGNMENT);
    header.extend(std::iter::repeat_n(' ', padded - 10 - header.len() - 1));
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.into_bytes());
    bytes.extend(distance.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}

/// Binary little-endian PLY with floats `x y z`, gray vertex colors `red green blue` that grow with distance, and a float `weight`,
/// the same as a number: distance over the largest one, 1 where nothing leads. Blender takes the colors as a color attribute.
///
/// # Panics
/// If there is not one distance for each vertex.
pub fn weights_ply(soup: &Soup, distance: &[f64]) -> Vec<u8> {
    assert_eq!(soup.positions.len(), distance.len(), "one distance for each vertex");
    let largest = largest_finite(distance);
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment geodesic distance by Heatwalk\nelement vertex {}\n\
         property float x\nproperty float y\nproperty float z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float weight\n\
         element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        soup.positions.len(),
        soup.parts.iter().map(Part::len).sum::<usize>()
    )
    .into_bytes();
    for (position, &distance) in soup.positions.iter().zip(distance) {
        let weight = share(distance, largest);
        bytes.extend(position.as_vec3().to_array().iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend([(255.0 * weight).round() as u8; 3]);
        bytes.extend(weight.to_le_bytes());
    }
    push_faces(&mut bytes, soup);
    bytes
}

/// Faces of a binary PLY.
fn push_faces(bytes: &mut Vec<u8>, soup: &Soup) {
    for triangle in soup.ranges().into_iter().flat_map(|range| &soup.triangles[range]) {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|corner| corner.to_le_bytes()));
    }
}

fn largest_finite(distance: &[f64]) -> f64 {
    distance.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max)
}

/// A distance over the largest one; 1 where nothing leads, 0 where none is larger than 0.
fn share(distance: f64, largest: f64) -> f32 {
    if distance < largest { (distance / largest) as f32 } else { f32::from(u8::from(distance > 0.0)) }
}

/// OBJ with the points of paths and a line through those of each.
pub fn polylines_obj(paths: &[Vec<DVec3>]) -> Vec<u8> {
    let mut text = String::from("# path on a surface by Heatwalk\n");
    let mut before = 0;
    for points in paths {
        for point in points {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "v {} {} {}", point.x, point.y, point.z);
        }
        text.push('l');
        for index in 1..=points.len() {
            let _ = write!(text, " {}", before + index);
        }
        text.push('\n');
        before += points.len();
    }
    text.into_bytes()
}
