//! A mesh that is shown.

use glam::Vec3;
use heatwalk_bake::{BoundingSphere, Hierarchy, Picker};

use crate::appearance::{MeshAppearance, ModelBuffers};
use crate::check;
use crate::context::Context;
use crate::error::Error;
use crate::surface::MeshBuffers;
use crate::tint::TintBuffer;

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

/// The vertices of a mesh in another pose; world space.
pub struct MeshPose {
    /// `#D × 3`.
    pub positions: Vec<Vec3>,
    /// `#D × 3`, unit length.
    pub normals: Vec<Vec3>,
}

impl MeshArrays {
    fn check(&self) -> Result<(), Error> {
        check::mesh(&self.positions, &self.normals, &self.triangles)?;
        self.appearance.check(self.positions.len(), self.triangles.len())?;
        let found = self.hierarchy.order().len();
        if found != self.triangles.len() {
            return Err(Error::WrongLength { what: "hierarchy", expected: self.triangles.len(), found });
        }
        Ok(())
    }
}

/// A mesh on the device and in the picker.
pub(crate) struct Mesh {
    pub(crate) buffers: MeshBuffers,
    pub(crate) model: Option<ModelBuffers>,
    pub(crate) bounds: BoundingSphere,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) picker: Picker,
}

impl Mesh {
    /// None for a mesh without triangles.
    pub(crate) fn new(context: &Context, arrays: MeshArrays) -> Result<Option<Self>, Error> {
        arrays.check()?;
        let Some(bounds) = BoundingSphere::of_points(arrays.positions.iter()).filter(|_| !arrays.triangles.is_empty())
        else {
            return Ok(None);
        };
        let MeshArrays { positions, normals, triangles, hierarchy, appearance } = arrays;
        let buffers = MeshBuffers::new(context, &positions, &normals, &triangles)?;
        let is_bare = appearance.is_empty();
        let model = (!is_bare).then(|| ModelBuffers::new(context, positions.len(), triangles.len(), appearance));
        let model = model.transpose()?;
        Ok(Some(Self { buffers, model, bounds, normals, picker: Picker::new(positions, triangles, hierarchy) }))
    }

    /// Moves the vertices.
    ///
    /// # Errors
    /// When there are more or fewer, or one is no finite place; the mesh then stays as it is.
    pub(crate) fn pose(&mut self, context: &Context, pose: MeshPose) -> Result<(), Error> {
        let MeshPose { positions, normals } = pose;
        let (expected, found) = (3 * self.normals.len(), 3 * positions.len());
        if found != expected {
            return Err(Error::WrongLength { what: "posed positions", expected, found });
        }
        check::same_length("posed normals", &positions, &normals)?;
        check::places("posed positions", &positions)?;
        check::vectors("posed normals", &normals)?;
        self.upload_pose(context, &positions, &normals);
        self.picker.pose(positions);
        self.normals = normals;
        self.forget_order();
        Ok(())
    }

    /// Has blended triangles put in order anew.
    pub(crate) fn forget_order(&mut self) {
        if let Some(model) = &mut self.model {
            model.blended.ahead = None;
        }
    }

    pub(crate) fn positions(&self) -> impl Iterator<Item = &Vec3> + Clone {
        self.picker.positions().iter()
    }

    /// Draws it with one vertex a corner from now on. `appearance`: that which it was made with.
    pub(crate) fn part_corners(&mut self, context: &Context, appearance: MeshAppearance) -> Result<(), Error> {
        let positions: Vec<Vec3> = self.positions().copied().collect();
        let triangles = self.picker.triangles();
        let face_count = triangles.len();
        let parted: Vec<[u32; 3]> = (0..face_count as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        let [positions, normals] = [&positions, &self.normals].map(|vectors| of_corners(vectors, triangles));
        let mut buffers = MeshBuffers::new(context, &positions, &normals, &parted)?;
        buffers.tints = Some(TintBuffer::new(context, face_count)?);
        if self.model.is_some() {
            let MeshAppearance { texcoords, colors, runs } = appearance;
            let texcoords = if texcoords.is_empty() { texcoords } else { of_corners(&texcoords, triangles) };
            let colors = if colors.is_empty() { colors } else { of_corners(&colors, triangles) };
            let parted = MeshAppearance { texcoords, colors, runs };
            self.model = Some(ModelBuffers::new(context, 3 * face_count, face_count, parted)?);
        }
        self.buffers = buffers;
        Ok(())
    }

    /// Uploads a pose, by corners where these are drawn.
    fn upload_pose(&self, context: &Context, positions: &[Vec3], normals: &[Vec3]) {
        if self.buffers.tints.is_none() {
            return self.buffers.pose(context, positions, normals);
        }
        let triangles = self.picker.triangles();
        let [positions, normals] = [positions, normals].map(|vectors| of_corners(vectors, triangles));
        self.buffers.pose(context, &positions, &normals);
    }
}

/// Values of vertices as values of corners.
fn of_corners<T: Copy>(of_vertices: &[T], triangles: &[[u32; 3]]) -> Vec<T> {
    triangles.as_flattened().iter().map(|&vertex| of_vertices[vertex as usize]).collect()
}
