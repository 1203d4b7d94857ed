//! Mesh primitives to triangles: lists, strips and fans, indexed or not.

use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;

use super::accessor::{Accessors, number};
use super::format::GLTF;
use crate::error::Result;

/// The accessor of the positions if the primitive is made of triangles; points and lines are no surface.
pub fn triangles_over(primitive: &Primitive) -> Result<Option<u32>> {
    match primitive.mode {
        Checked::Valid(Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) => {}
        Checked::Valid(_) => return Ok(None),
        Checked::Invalid => return Err(GLTF.at("primitive", "its mode is unknown; export the file again")),
    }
    Ok(positions(primitive))
}

/// The accessor of the positions if the primitive is made of points.
pub fn points_over(primitive: &Primitive) -> Option<u32> {
    positions(primitive).filter(|_| primitive.mode == Checked::Valid(Mode::Points))
}

/// A primitive without positions is allowed and shows nothing.
fn positions(primitive: &Primitive) -> Option<u32> {
    primitive.attributes.get(&Checked::Valid(Semantic::Positions)).map(|&index| number(index))
}

/// Appends the triangles of the primitive, whose `count` vertices start at `first`.
pub fn append_triangles(
    accessors: Accessors,
    primitive: &Primitive,
    first: usize,
    count: usize,
    triangles: &mut Vec<[u32; 3]>,
) -> Result<()> {
    let start = triangles.len();
    let budget = accessors.buffers.budget;
    match (accessors.compressed, primitive.indices) {
        (Some(compressed), _) => {
            budget.reserve(triangles, compressed.triangles().len())?;
            triangles.extend(compressed.triangles());
        }
        (None, Some(index)) => {
            let corners = accessors.indices(number(index))?;
            budget.reserve(triangles, connected(primitive.mode, corners.len()))?;
            connect(primitive.mode, corners.len(), |corner| corners[corner], triangles);
        }
        (None, None) => {
            budget.reserve(triangles, connected(primitive.mode, count))?;
            connect(primitive.mode, count, |corner| corner as u32, triangles);
        }
    }
    for (index, triangle) in triangles.iter_mut().enumerate().skip(start) {
        for corner in triangle {
            if *corner as usize >= count {
                return Err(heatwalk_surface::Error::IndexOutOfRange {
                    triangle: index,
                    vertex: (*corner).into(),
                    vertices: count,
                }
                .into());
            }
            *corner += first as u32;
        }
    }
    Ok(())
}

/// How many triangles so many corners make.
fn connected(mode: Checked<Mode>, corners: usize) -> usize {
    match mode {
        Checked::Valid(Mode::TriangleStrip | Mode::TriangleFan) => corners.saturating_sub(2),
        _ => corners / 3,
    }
}

fn connect(mode: Checked<Mode>, corners: usize, vertex: impl Fn(usize) -> u32, triangles: &mut Vec<[u32; 3]>) {
    match mode {
        Checked::Valid(Mode::TriangleStrip) => triangles.extend((2..corners).map(|last| {
            // Every second triangle of a strip runs the other way (glTF 2.0, 3.7.2.1).
            let turned = last % 2;
            [vertex(last - 2), vertex(last - 1 + turned), vertex(last - turned)]
        })),
        Checked::Valid(Mode::TriangleFan) => {
            triangles.extend((2..corners).map(|last| [vertex(last - 1), vertex(last), vertex(0)]));
        }
        _ => triangles.extend((0..corners / 3).map(|t| [vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)])),
    }
}
