//! Meshes with their distances, and paths, as bytes of a file.

use std::fmt::Write as _;

use glam::DVec3;

use crate::soup::Soup;

#[cfg(feature = "gltf")]
mod container;
#[cfg(feature = "gltf")]
mod glb;
#[cfg(feature = "gltf")]
pub use container::GlbFile;
#[cfg(feature = "gltf")]
pub use glb::distance_glb;

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
