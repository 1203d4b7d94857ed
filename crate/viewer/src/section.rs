//! The section that closes a cut, or whole tetrahedra in the place of the surface.

use glam::Vec3;
use heatwalk_bake::{Hit, Ray, cast_at_all};

use crate::buffer::mesh_buffer;
use crate::context::Context;
use crate::error::Error;
use crate::inner::{Distances, InnerTriangles};
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::surface::{MeshBuffers, SurfaceRenderer, vertices};
use crate::vertex::Snorm8x4;

/// Triangles that are drawn as the surface is.
#[derive(Clone, Default)]
pub struct SectionArrays {
    /// The triangles; no values for a section without a field.
    pub mesh: InnerTriangles,
    /// `#N`, the direction in which distance grows, 127 for a unit, the fourth number unused; empty where the values are.
    pub tangents: Vec<[i8; 4]>,
}

/// A section that is shown.
pub(crate) struct Section {
    pub(crate) buffers: MeshBuffers,
    field: Option<(Distances, wgpu::Buffer)>,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// Least and greatest corner of its box.
    corners: [Vec3; 2],
}

impl Section {
    /// None for one without triangles. `max`: the largest value of the field.
    ///
    /// # Errors
    /// When the arrays do not fit together, or the device, or are no finite places.
    pub(crate) fn new(context: &Context, arrays: SectionArrays, max: f64) -> Result<Option<Self>, Error> {
        let SectionArrays { mesh, tangents } = arrays;
        mesh.check()?;
        let InnerTriangles { positions, normals, values, triangles } = mesh;
        let (expected, found) = (positions.len(), values.len());
        if found != 0 && found != expected {
            return Err(Error::WrongLength { what: "distances of the section", expected, found });
        }
        if tangents.len() != values.len() {
            let (expected, found) = (4 * values.len(), 4 * tangents.len());
            return Err(Error::WrongLength { what: "tangents of the section", expected, found });
        }
        if triangles.is_empty() {
            return Ok(None);
        }
        let buffers = MeshBuffers::new(context, &positions, &normals, &triangles)?;
        let field = if values.is_empty() { None } else { Some(field(context, values, &tangents, max)?) };
        let low = positions.iter().copied().reduce(Vec3::min).unwrap_or_default();
        let high = positions.iter().copied().reduce(Vec3::max).unwrap_or_default();
        Ok(Some(Self { buffers, field, positions, normals, triangles, corners: [low, high] }))
    }

    /// `max`: the largest value of the field from now on.
    pub(crate) fn scale(&self, context: &Context, max: f64) {
        if let Some((distances, _)) = &self.field {
            distances.scale(context, max);
        }
    }

    /// The nearest of its triangles on a ray.
    pub(crate) fn cast(&self, ray: Ray) -> Option<Hit> {
        if !ray.meets_box(self.corners) {
            return None;
        }
        cast_at_all(ray, &self.positions, &self.triangles)
    }

    /// Normals of the corners of a triangle.
    pub(crate) fn corner_normals(&self, triangle: u32) -> [Vec3; 3] {
        self.triangles[triangle as usize].map(|vertex| self.normals[vertex as usize])
    }

    /// Greatest distance of a vertex from a place.
    pub(crate) fn reach(&self, center: Vec3) -> f32 {
        self.positions.iter().map(|place| place.distance_squared(center)).fold(0.0, f32::max).sqrt()
    }
}

fn field(
    context: &Context,
    values: Vec<f32>,
    tangents: &[Snorm8x4],
    max: f64,
) -> Result<(Distances, wgpu::Buffer), Error> {
    let usage = wgpu::BufferUsages::VERTEX;
    let tangents = mesh_buffer(context, "tangents of the section", bytemuck::cast_slice(tangents), usage)?;
    Ok((Distances::new(context, values, max)?, tangents))
}

/// Draws sections.
pub(crate) struct SectionRenderer {
    field: wgpu::RenderPipeline,
    plain: wgpu::RenderPipeline,
}

impl SectionRenderer {
    pub(crate) fn new(context: &Context, shared: &Shared, surfaces: &SurfaceRenderer) -> Self {
        let module = shader_module!(context, "section");
        let pipeline = |label, fragment, has_field| {
            let (vertex, buffers) = vertices(has_field, false);
            PipelineRecipe {
                label,
                layouts: &[Some(&shared.frame_layout), Some(&shared.lighting.layout), Some(&surfaces.style_layout)],
                module: &module,
                vertex,
                fragment,
                buffers: &buffers,
                topology: wgpu::PrimitiveTopology::TriangleList,
                place: Place::Solid,
            }
            .build(context)
        };
        Self {
            field: pipeline("section with field", "fs_section", true),
            plain: pipeline("section without field", "fs_section_plain", false),
        }
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, section: &Section, surfaces: &SurfaceRenderer) {
        pass.set_bind_group(2, &surfaces.group, &[]);
        pass.set_pipeline(if section.field.is_some() { &self.field } else { &self.plain });
        if let Some((distances, tangents)) = &section.field {
            pass.set_vertex_buffer(2, distances.buffer.slice(..));
            pass.set_vertex_buffer(3, tangents.slice(..));
        }
        section.buffers.draw(pass);
    }
}
