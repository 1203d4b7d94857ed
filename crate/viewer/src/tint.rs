//! The ground as a tint: one color a face. Since it jumps between faces, as distance does at walls, a tinted mesh has one
//! vertex for each corner of its faces.

use crate::buffer::mesh_buffer;
use crate::context::Context;
use crate::error::Error;
use crate::vertex::{Unorm8x4, attribute, single};

pub(crate) const TINT: wgpu::VertexBufferLayout<'static> =
    single::<Unorm8x4>(wgpu::VertexStepMode::Vertex, &[attribute::<Unorm8x4>(6)]);
/// Where the layout of a tinted mesh has its tints: after all that meshes may have besides.
pub(crate) const TINT_SLOT: u32 = 6;

/// Tints of corners, which strokes of a brush rewrite.
pub(crate) struct TintBuffer {
    buffer: wgpu::Buffer,
    /// What goes to the device; kept, so that a stroke allocates nothing.
    corners: Vec<Unorm8x4>,
}

impl TintBuffer {
    pub(crate) fn new(context: &Context, face_count: usize) -> Result<Self, Error> {
        let corners = vec![[0; 4]; 3 * face_count];
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        let buffer = mesh_buffer(context, "tints", bytemuck::cast_slice(&corners), usage)?;
        Ok(Self { buffer, corners })
    }

    pub(crate) fn write(&mut self, context: &Context, faces: &[Unorm8x4]) {
        for (corners, &tint) in self.corners.as_chunks_mut::<3>().0.iter_mut().zip(faces) {
            *corners = [tint; 3];
        }
        context.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&self.corners));
    }

    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(TINT_SLOT, self.buffer.slice(..));
    }
}
