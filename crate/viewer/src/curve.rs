use glam::Vec3;

use crate::buffer::Growing;
use crate::context::Context;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::vertex::{attribute, single};

const POINT_SIZE: u64 = size_of::<Vec3>() as u64;

/// The same points, shifted by one from slot to slot: a segment sees the point before, its ends and the point after.
const SHIFTED: [[wgpu::VertexAttribute; 1]; 4] =
    [[attribute::<Vec3>(0)], [attribute::<Vec3>(1)], [attribute::<Vec3>(2)], [attribute::<Vec3>(3)]];

/// Draws a path on the surface.
pub(crate) struct Curve {
    pipeline: wgpu::RenderPipeline,
    buffer: Growing,
    /// First point, all points, last point.
    points: Vec<Vec3>,
}

impl Curve {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let pipeline = PipelineRecipe {
            label: "curve",
            layouts: &[Some(&shared.frame_layout), Some(&shared.lighting.layout)],
            module: &shader_module!(context, "curve"),
            vertex: "vs_curve",
            fragment: "fs_curve",
            buffers: &SHIFTED.each_ref().map(|point| Some(single::<Vec3>(wgpu::VertexStepMode::Instance, point))),
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            place: Place::Solid,
        }
        .build(context);
        Self { pipeline, buffer: Growing::new("curve points", wgpu::BufferUsages::VERTEX), points: Vec::new() }
    }

    /// Replaces the polyline; world space, empty for none.
    pub(crate) fn set_points(&mut self, context: &Context, points: &[Vec3]) {
        self.points.clear();
        if let [first, .., last] = points {
            self.points.push(*first);
            // A repeated point makes a segment without a direction.
            for &point in points {
                if self.points.len() == 1 || self.points.last() != Some(&point) {
                    self.points.push(point);
                }
            }
            self.points.push(*last);
        }
        self.buffer.write(context, bytemuck::cast_slice(&self.points));
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let segments = self.points.len().saturating_sub(3) as u64;
        let Some(buffer) = self.buffer.get().filter(|_| segments > 0) else { return };
        pass.set_pipeline(&self.pipeline);
        for slot in 0..4 {
            let start = u64::from(slot) * POINT_SIZE;
            pass.set_vertex_buffer(slot, buffer.slice(start..start + segments * POINT_SIZE));
        }
        pass.draw(0..4, 0..segments as u32);
    }
}
