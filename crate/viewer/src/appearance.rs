//! How a file wants a mesh to look: attributes of vertices, and which triangles have which material.

use std::ops::Range;

use glam::Vec3;

use crate::buffer::{Growing, mesh_buffer};
use crate::context::Context;
use crate::error::Error;

/// Stands for the default one.
const DEFAULT_MATERIAL: u32 = u32::MAX;

/// How a file wants a mesh to look; nothing where it does not say.
#[derive(Default)]
pub struct MeshAppearance {
    /// `#D`, two sets of texture coordinates, or empty.
    pub texcoords: Vec<[f32; 4]>,
    /// `#D`, linear RGBA, 65535 for 1, or empty.
    pub colors: Vec<[u16; 4]>,
    /// Consecutive triangles of one material; those outside have the default one.
    pub runs: Vec<MeshRun>,
}

/// Consecutive triangles of one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshRun {
    /// A range of the triangles.
    pub triangles: Range<u32>,
    /// Index of the material; the default one where there is none of that index.
    pub material: u32,
}

impl MeshAppearance {
    pub(crate) fn is_empty(&self) -> bool {
        self.colors.is_empty() && self.runs.is_empty()
    }

    pub(crate) fn check(&self, vertex_count: usize, triangle_count: usize) -> Result<(), Error> {
        let attribute = |what, found| {
            if found == 0 || found == vertex_count {
                return Ok(());
            }
            Err(Error::WrongLength { what, expected: 4 * vertex_count, found: 4 * found })
        };
        attribute("texture coordinates", self.texcoords.len())?;
        attribute("vertex colors", self.colors.len())?;
        let is_wrong =
            |run: &&MeshRun| run.triangles.start > run.triangles.end || run.triangles.end as usize > triangle_count;
        match self.runs.iter().find(is_wrong) {
            Some(run) => Err(Error::WrongLength {
                what: "triangles",
                expected: run.triangles.start.max(run.triangles.end) as usize,
                found: triangle_count,
            }),
            None => Ok(()),
        }
    }
}

/// What a mesh with materials has beside its triangles.
pub(crate) struct ModelBuffers {
    pub(crate) texcoords: wgpu::Buffer,
    pub(crate) colors: wgpu::Buffer,
    /// Over all triangles.
    pub(crate) runs: Vec<MeshRun>,
    /// Those that are blended, in the order in which they are drawn.
    pub(crate) blended: BlendedBuffers,
}

/// Blended triangles in the order in which they are drawn.
pub(crate) struct BlendedBuffers {
    /// The line of sight that they were last put in order for; None where pose or materials have changed since.
    pub(crate) ahead: Option<Vec3>,
    pub(crate) triangles: Growing,
    /// Over these triangles; None where there are none, or too many to be put in order.
    pub(crate) draws: Option<Vec<MeshRun>>,
}

impl ModelBuffers {
    /// # Errors
    /// When one of the arrays is larger than the device allows.
    pub(crate) fn new(
        context: &Context,
        vertex_count: usize,
        triangle_count: usize,
        appearance: MeshAppearance,
    ) -> Result<Self, Error> {
        let MeshAppearance { mut texcoords, mut colors, mut runs } = appearance;
        texcoords.resize(vertex_count, [0.0; 4]);
        colors.resize(vertex_count, [u16::MAX; 4]);
        if runs.is_empty() {
            runs.push(MeshRun { triangles: 0..triangle_count as u32, material: DEFAULT_MATERIAL });
        }
        let vertex = wgpu::BufferUsages::VERTEX;
        Ok(Self {
            texcoords: mesh_buffer(context, "texture coordinates", bytemuck::cast_slice(&texcoords), vertex)?,
            colors: mesh_buffer(context, "vertex colors", bytemuck::cast_slice(&colors), vertex)?,
            runs,
            blended: BlendedBuffers {
                ahead: None,
                triangles: Growing::new("blended triangles", wgpu::BufferUsages::INDEX),
                draws: None,
            },
        })
    }
}
