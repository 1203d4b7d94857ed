//! Iso-surfaces within the solid, which let light through.

use encase::ShaderType;
use glam::Vec3;

use crate::appearance::MeshRun;
use crate::binding::uniform_layout;
use crate::blended::back_to_front;
use crate::buffer::{Growing, mesh_buffer};
use crate::context::Context;
use crate::error::Error;
use crate::inner::{Distances, InnerTriangles};
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::surface::{DISTANCE, NORMAL, POSITION, RAMP_BYTES, SurfaceRenderer};
use crate::uniform::Uniform;

/// The densest film: Beer and Lambert's law has no end for one that lets nothing through.
const MOST_OPAQUE: f32 = 0.98;

/// `Film` of shell.wgsl.
#[derive(Clone, Copy, Debug, ShaderType)]
struct FilmUniform {
    opacity: f32,
    // WebGL2 wants uniforms of whole 16 bytes.
    #[shader(size(12))]
    row: f32,
}

/// Shells that are shown.
pub(crate) struct Shells {
    positions: wgpu::Buffer,
    normals: wgpu::Buffer,
    distances: Distances,
    corners: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// In the order in which they are drawn.
    order: Growing,
    /// The line of sight of that order.
    ahead: Option<Vec3>,
}

impl Shells {
    /// None for such without triangles. `max`: the largest value of the field.
    ///
    /// # Errors
    /// When the arrays do not fit together, or the device, or are no finite places.
    pub(crate) fn new(context: &Context, mesh: InnerTriangles, max: f64) -> Result<Option<Self>, Error> {
        mesh.check()?;
        let InnerTriangles { positions, normals, values, triangles } = mesh;
        let (expected, found) = (positions.len(), values.len());
        if found != expected {
            return Err(Error::WrongLength { what: "distances of the shells", expected, found });
        }
        if triangles.is_empty() {
            return Ok(None);
        }
        let vertex = wgpu::BufferUsages::VERTEX;
        Ok(Some(Self {
            positions: mesh_buffer(context, "positions of the shells", bytemuck::cast_slice(&positions), vertex)?,
            normals: mesh_buffer(context, "normals of the shells", bytemuck::cast_slice(&normals), vertex)?,
            distances: Distances::new(context, values, max)?,
            corners: positions,
            triangles,
            order: Growing::new("triangles of the shells", wgpu::BufferUsages::INDEX),
            ahead: None,
        }))
    }

    /// `max`: the largest value of the field from now on.
    pub(crate) fn scale(&self, context: &Context, max: f64) {
        self.distances.scale(context, max);
    }

    /// Puts the triangles in order for a line of sight; too many stay as they came.
    pub(crate) fn sort(&mut self, context: &Context, ahead: Vec3) {
        if self.ahead == Some(ahead) {
            return;
        }
        let all = MeshRun { triangles: 0..self.triangles.len() as u32, material: 0 };
        match back_to_front(&self.corners, &self.triangles, &[all], ahead) {
            Some(order) => {
                let sorted: Vec<[u32; 3]> =
                    order.triangles.iter().map(|&triangle| self.triangles[triangle as usize]).collect();
                self.order.write(context, bytemuck::cast_slice(&sorted));
            }
            None if self.ahead.is_none() => self.order.write(context, bytemuck::cast_slice(&self.triangles)),
            None => {}
        }
        self.ahead = Some(ahead);
    }
}

/// Draws shells.
pub(crate) struct ShellRenderer {
    pipeline: wgpu::RenderPipeline,
    film: Uniform<FilmUniform>,
    group: wgpu::BindGroup,
}

impl ShellRenderer {
    pub(crate) fn new(context: &Context, shared: &Shared, surfaces: &SurfaceRenderer) -> Self {
        let layout = uniform_layout(context, "film layout");
        let film = Uniform::new(context, "film uniform");
        let pipeline = PipelineRecipe {
            label: "shells",
            layouts: &[
                Some(&shared.frame_layout),
                Some(&shared.lighting.layout),
                Some(&surfaces.style_layout),
                Some(&layout),
            ],
            module: &shader_module!(context, "shell"),
            vertex: "vs_shell",
            fragment: "fs_shell",
            buffers: &[Some(POSITION), Some(NORMAL), Some(DISTANCE)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Over,
        }
        .build(context);
        Self { pipeline, group: film.group(context, &layout, "film"), film }
    }

    /// `opacity`: of a shell that is seen straight on, 0..1. `row`: which of the [ramps](ramp_row) it is coloured by.
    pub(crate) fn set_film(&self, context: &Context, opacity: f32, row: usize) {
        let opacity = if opacity.is_finite() { opacity.clamp(0.0, MOST_OPAQUE) } else { 0.0 };
        // The middle of the row.
        self.film.write(context, &FilmUniform { opacity, row: 0.25 + 0.5 * row as f32 });
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, shells: &Shells, surfaces: &SurfaceRenderer) {
        let Some(order) = shells.order.get() else { return };
        pass.set_bind_group(2, &surfaces.group, &[]);
        pass.set_bind_group(3, &self.group, &[]);
        pass.set_pipeline(&self.pipeline);
        pass.set_vertex_buffer(0, shells.positions.slice(..));
        pass.set_vertex_buffer(1, shells.normals.slice(..));
        pass.set_vertex_buffer(2, shells.distances.buffer.slice(..));
        pass.set_index_buffer(order.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..3 * shells.triangles.len() as u32, 0, 0..1);
    }
}

/// Which of the two ramps shells are coloured by, 0 for that of the surface and 1 for that of the stripes: the more colourful
/// one, since either may be a plain white or black.
pub(crate) fn ramp_row(ramps: &[u8; RAMP_BYTES]) -> usize {
    let chroma = |&[red, green, blue, _]: &[u8; 4]| u32::from(red.max(green).max(blue) - red.min(green).min(blue));
    let [surface, stripes] = [0, 1].map(|row| {
        let texels = &ramps.as_chunks::<4>().0[row * ramps.len() / 8..][..ramps.len() / 8];
        texels.iter().map(chroma).sum::<u32>()
    });
    usize::from(stripes > surface)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_more_colorful_ramp_is_taken() {
        let mut ramps = [236; RAMP_BYTES];
        assert_eq!(ramp_row(&ramps), 0, "that of the surface where there is no difference");
        ramps[RAMP_BYTES - 4] = 40;
        assert_eq!(ramp_row(&ramps), 1);
        ramps[0] = 20;
        assert_eq!(ramp_row(&ramps), 0);
    }
}
