use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};

use crate::buffer::mesh_buffer;
use crate::context::Context;
use crate::error::Error;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shared::Shared;
use crate::vertex::vertex_layout;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Vertex {
    position: Vec3,
    /// Unit length.
    normal: Vec3,
    /// Their meaning is the shader's own.
    tags: Vec2,
}

/// How finely round parts are cut.
#[derive(Clone, Copy)]
pub(crate) struct Detail {
    /// Points around an axis.
    sectors: u32,
    /// Steps along a round end.
    round_steps: u32,
}

impl Detail {
    /// Smooth at the size of a pin or a walker.
    pub(crate) const FINE: Self = Self { sectors: 16, round_steps: 5 };
    /// Enough for one of thousands.
    pub(crate) const COARSE: Self = Self { sectors: 5, round_steps: 1 };
}

/// A small closed figure put together from turned parts.
pub(crate) struct Solid {
    detail: Detail,
    vertices: Vec<Vertex>,
    indices: Vec<u16>,
}

impl Solid {
    pub(crate) fn new(detail: Detail) -> Self {
        Self { detail, vertices: Vec::new(), indices: Vec::new() }
    }

    /// Turns a profile of (height, radius) pairs, from bottom to top, around an axis through `base`.
    pub(crate) fn turned(&mut self, base: Vec3, axis: Vec3, profile: &[(f32, f32)], tags: [f32; 2]) {
        let axis = axis.normalize();
        let (right, ahead) = axis.any_orthonormal_pair();
        let first = self.vertices.len() as u16;
        let sectors = self.detail.sectors;
        for (index, &(height, radius)) in profile.iter().enumerate() {
            let below = profile[index.saturating_sub(1)];
            let above = profile[(index + 1).min(profile.len() - 1)];
            let (rise, growth) = (above.0 - below.0, above.1 - below.1);
            for sector in 0..=sectors {
                let (sin, cos) = (TAU * sector as f32 / sectors as f32).sin_cos();
                let radial = cos * right + sin * ahead;
                let position = base + height * axis + radius * radial;
                let normal = (rise * radial - growth * axis).normalize();
                self.vertices.push(Vertex { position, normal, tags: tags.into() });
            }
        }
        let row = sectors as u16 + 1;
        for ring in 0..profile.len() as u16 - 1 {
            for sector in 0..sectors as u16 {
                let corner = first + ring * row + sector;
                self.indices.extend([corner, corner + 1, corner + row]);
                self.indices.extend([corner + 1, corner + row + 1, corner + row]);
            }
        }
    }

    /// A ball, stretched along the axis by `half_height / radius`.
    pub(crate) fn ball(&mut self, center: Vec3, axis: Vec3, half_height: f32, radius: f32, tags: [f32; 2]) {
        let steps = self.detail.round_steps;
        let profile: Vec<(f32, f32)> = (0..=2 * steps)
            .map(|step| {
                let (sin, cos) = (PI * step as f32 / (2 * steps) as f32).sin_cos();
                (-half_height * cos, radius * sin)
            })
            .collect();
        self.turned(center, axis, &profile, tags);
    }

    /// A rounded limb between two points, with a radius at each.
    pub(crate) fn limb(&mut self, from: (Vec3, f32), to: (Vec3, f32), tags: [f32; 2]) {
        let length = from.0.distance(to.0);
        let steps = self.detail.round_steps;
        let cap = |center: f32, radius: f32, start: f32| {
            (0..=steps).map(move |step| {
                let (sin, cos) = (start + 0.5 * PI * step as f32 / steps as f32).sin_cos();
                (center - radius * cos, radius * sin)
            })
        };
        let profile: Vec<(f32, f32)> = cap(0.0, from.1, 0.0).chain(cap(length, to.1, 0.5 * PI)).collect();
        self.turned(from.0, to.0 - from.0, &profile, tags);
    }

    pub(crate) fn upload(&self, context: &Context) -> Result<SolidBuffers, Error> {
        let vertex = wgpu::BufferUsages::VERTEX;
        let index = wgpu::BufferUsages::INDEX;
        Ok(SolidBuffers {
            vertices: mesh_buffer(context, "solid vertices", bytemuck::cast_slice(&self.vertices), vertex)?,
            indices: mesh_buffer(context, "solid indices", bytemuck::cast_slice(&self.indices), index)?,
            index_count: self.indices.len() as u32,
        })
    }
}

/// A solid on the device.
pub(crate) struct SolidBuffers {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
}

impl SolidBuffers {
    pub(crate) const LAYOUT: wgpu::VertexBufferLayout<'static> =
        vertex_layout!(Vertex, per Vertex: 0 => position, 1 => normal, 2 => tags);

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, instances: u32) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        pass.draw_indexed(0..self.index_count, 0, 0..instances);
    }
}

/// How instances of a solid are drawn.
pub(crate) struct SolidPipelines {
    pub(crate) drawn: wgpu::RenderPipeline,
    pub(crate) shadow: wgpu::RenderPipeline,
}

impl SolidPipelines {
    pub(crate) fn new(
        context: &Context,
        shared: &Shared,
        module: &wgpu::ShaderModule,
        [label, vertex, fragment]: [&str; 3],
        instance: wgpu::VertexBufferLayout<'static>,
    ) -> Self {
        let recipe = PipelineRecipe {
            label,
            layouts: &[Some(&shared.frame_layout), Some(&shared.lighting.layout)],
            module,
            vertex,
            fragment,
            buffers: &[Some(SolidBuffers::LAYOUT), Some(instance)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Solid,
        };
        let casting = PipelineRecipe { layouts: &[Some(&shared.frame_layout)], ..recipe.clone() };
        Self { drawn: recipe.build(context), shadow: casting.build_shadow(context) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_and_limbs_have_unit_normals_that_point_outwards() {
        let mut solid = Solid::new(Detail::FINE);
        let center = Vec3::new(1.0, 2.0, 3.0);
        solid.ball(center, Vec3::Y, 0.5, 0.5, [0.0; 2]);
        for &Vertex { position, normal, .. } in &solid.vertices {
            assert!(normal.is_normalized());
            assert!(normal.dot((position - center).normalize()) > 0.98, "profile differences turn a normal a little");
        }
        solid.limb((Vec3::ZERO, 0.2), (Vec3::X, 0.1), [0.0; 2]);
        assert!(solid.vertices.iter().all(|vertex| vertex.normal.is_normalized()));
        assert!(solid.indices.iter().all(|&index| usize::from(index) < solid.vertices.len()));
    }
}
