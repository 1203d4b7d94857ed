//! Triangles that are shown inside of a solid, as the page hands them over.

use glam::Vec3;

use crate::buffer::mesh_buffer;
use crate::check;
use crate::context::Context;
use crate::error::Error;
use crate::surface::UNREACHABLE;

/// Triangles with a distance; world space.
#[derive(Clone, Default)]
pub struct InnerTriangles {
    /// `#N × 3`.
    pub positions: Vec<Vec3>,
    /// `#N × 3`, unit length.
    pub normals: Vec<Vec3>,
    /// `#N`, in the unit of the field's values; infinite or NaN = unreachable.
    pub values: Vec<f32>,
    /// `#T × 3`, indices into the positions.
    pub triangles: Vec<[u32; 3]>,
}

impl InnerTriangles {
    /// # Errors
    /// When the arrays do not fit together, or a place or a normal is not finite. That there is a value a vertex is left to the
    /// caller.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check::same_length("normals", &self.positions, &self.normals)?;
        check::places("positions", &self.positions)?;
        check::vectors("normals", &self.normals)?;
        check::corners(&self.triangles, self.positions.len())
    }
}

/// Distances of vertices on the device, as shares of the field's largest, which may change.
pub(crate) struct Distances {
    pub(crate) buffer: wgpu::Buffer,
    values: Vec<f32>,
}

impl Distances {
    /// # Errors
    /// When they are more than the device allows.
    pub(crate) fn new(context: &Context, values: Vec<f32>, max: f64) -> Result<Self, Error> {
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        let buffer = mesh_buffer(context, "distances inside", bytemuck::cast_slice(&shares(&values, max)), usage)?;
        Ok(Self { buffer, values })
    }

    /// `max`: the largest value of the field from now on.
    pub(crate) fn scale(&self, context: &Context, max: f64) {
        context.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&shares(&self.values, max)));
    }
}

fn shares(values: &[f32], max: f64) -> Vec<f32> {
    let share = |&value: &f32| if value.is_finite() { (f64::from(value) / max) as f32 } else { UNREACHABLE };
    values.iter().map(share).collect()
}
