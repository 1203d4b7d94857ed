//! A mesh that is shown.

use std::ops::Range;

use glam::Vec3;
use heatwalk_bake::{Bounds, Hierarchy, Picker};

use crate::check;
use crate::context::Context;
use crate::error::Error;
use crate::model::ModelBuffers;
use crate::surface::MeshBuffers;

/// A triangle mesh as the page hands it over; world space.
pub struct MeshArrays {
    /// `#D × 3`.
    pub positions: Vec<Vec3>,
    /// `#D × 3`, unit length.
    pub normals: Vec<Vec3>,
    /// `#F × 3`, indices into the positions.
    pub triangles: Vec<[u32; 3]>,
    /// Of the triangles.
    pub hierarchy: Hierarchy,
    /// How its file wants it to look.
    pub appearance: MeshAppearance,
}

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
pub struct MeshRun {
    /// A range of the triangles.
    pub triangles: Range<u32>,
    /// Index of the material; the default one where there is none of that index.
    pub material: u32,
}

impl MeshAppearance {
    fn is_empty(&self) -> bool {
        self.colors.is_empty() && self.runs.is_empty()
    }

    fn check(&self, vertex_count: usize, triangle_count: usize) -> Result<(), Error> {
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

impl MeshArrays {
    fn check(&self) -> Result<(), Error> {
        let vertex_count = self.positions.len();
        check::same_length("normals", &self.positions, &self.normals)?;
        check::places("positions", &self.positions)?;
        check::vectors("normals", &self.normals)?;
        self.appearance.check(vertex_count, self.triangles.len())?;
        let found = self.hierarchy.order().len();
        if found != self.triangles.len() {
            return Err(Error::WrongLength { what: "hierarchy", expected: self.triangles.len(), found });
        }
        for (triangle, corners) in self.triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertex_count) {
                return Err(Error::VertexOutOfRange { triangle, vertex, vertex_count });
            }
        }
        Ok(())
    }
}

/// A mesh on the device and in the picker.
pub(crate) struct Mesh {
    pub(crate) buffers: MeshBuffers,
    pub(crate) model: Option<ModelBuffers>,
    pub(crate) bounds: Bounds,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) picker: Picker,
}

impl Mesh {
    /// None for a mesh without triangles.
    pub(crate) fn new(context: &Context, arrays: MeshArrays) -> Result<Option<Self>, Error> {
        arrays.check()?;
        let Some(bounds) = Bounds::of_points(arrays.positions.iter()).filter(|_| !arrays.triangles.is_empty()) else {
            return Ok(None);
        };
        let MeshArrays { positions, normals, triangles, hierarchy, appearance } = arrays;
        let buffers = MeshBuffers::new(context, &positions, &normals, &triangles)?;
        let is_bare = appearance.is_empty();
        let model = (!is_bare).then(|| ModelBuffers::new(context, positions.len(), triangles.len(), appearance));
        let model = model.transpose()?;
        Ok(Some(Self { buffers, model, bounds, normals, picker: Picker::new(positions, triangles, hierarchy) }))
    }

    pub(crate) fn positions(&self) -> impl Iterator<Item = &Vec3> + Clone {
        self.picker.positions().iter()
    }
}
