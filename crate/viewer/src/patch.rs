//! Patches: triangles that lie on the surface, a little above it, and let it through where they are not opaque. They cast no shadow,
//! are not picked, and need no order, since each hides the surface beneath and nothing else.

use glam::Vec3;

use crate::appearance::{MeshAppearance, ModelBuffers};
use crate::check;
use crate::context::Context;
use crate::error::Error;
use crate::image::Image;
use crate::material::{BoundMaterial, Material};
use crate::model::ModelRenderer;
use crate::surface::MeshBuffers;

/// Triangles on the surface; world space.
pub struct PatchArrays {
    /// `#D × 3`.
    pub positions: Vec<Vec3>,
    /// `#D × 3`, unit length.
    pub normals: Vec<Vec3>,
    /// `#F × 3`, indices into the positions.
    pub triangles: Vec<[u32; 3]>,
    /// How they look, in materials of their own.
    pub appearance: MeshAppearance,
}

/// Patches on the device.
pub(crate) struct Patches {
    pub(crate) buffers: MeshBuffers,
    pub(crate) model: ModelBuffers,
    pub(crate) materials: Vec<BoundMaterial>,
}

impl Patches {
    /// None without triangles.
    pub(crate) fn new(
        context: &Context,
        models: &ModelRenderer,
        arrays: PatchArrays,
        materials: &[Material],
        images: &[Image],
    ) -> Result<Option<Self>, Error> {
        let PatchArrays { positions, normals, triangles, appearance } = arrays;
        check::mesh(&positions, &normals, &triangles)?;
        appearance.check(positions.len(), triangles.len())?;
        if triangles.is_empty() {
            return Ok(None);
        }
        Ok(Some(Self {
            buffers: MeshBuffers::new(context, &positions, &normals, &triangles)?,
            model: ModelBuffers::new(context, positions.len(), triangles.len(), appearance)?,
            materials: models.bind(context, materials, images),
        }))
    }
}
