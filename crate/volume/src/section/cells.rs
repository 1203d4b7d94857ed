//! Whole tetrahedra: those that a cut leaves, together or pulled apart.

use glam::DVec3;

use super::cut::{Side, Sides};
use super::{Cut, Section};
use crate::mesh::{FACES, NONE, TetId, TetMesh};

impl Section {
    /// The faces around the tetrahedra that stay, those whose centroid a cut does not remove: where such a tetrahedron has no neighbor
    /// that stays, the boundary of the mesh included. Three vertices a triangle, with the normal of the triangle, outward.
    pub fn of_tetrahedra(mesh: &TetMesh, cut: &Cut) -> Self {
        let mut section = Self::empty(mesh);
        let stays = stays(mesh, cut);
        for tetrahedron in those_that(&stays) {
            for (corner, &neighbor) in mesh.neighbors()[tetrahedron.index()].iter().enumerate() {
                if neighbor == NONE || !stays[neighbor as usize] {
                    section.add_face(mesh, tetrahedron, corner, DVec3::ZERO);
                }
            }
        }
        section
    }

    /// The tetrahedra that stay, those whose centroid a cut does not remove, each as four faces and moved away from the middle of the
    /// mesh's bounding box by `gap` times how far its centroid is from there: 0 leaves all in place, 1 makes the mesh twice as wide.
    /// Their size stays. Three vertices a triangle, with the normal of the triangle, outward: twelve a tetrahedron, and about 1000 bytes.
    ///
    /// [`Section::tetrahedra`] and [`Section::weights`] are of the mesh, where nothing has moved.
    pub fn exploded(mesh: &TetMesh, cut: &Cut, gap: f64) -> Self {
        let mut section = Self::empty(mesh);
        let (low, high) = mesh.bounds();
        let middle = (low + high) / 2.0;
        let stays = stays(mesh, cut);
        section.reserve(4 * stays.iter().filter(|&&stays| stays).count());
        for tetrahedron in those_that(&stays) {
            let shift = gap * (centroid(mesh, tetrahedron) - middle);
            for corner in 0..4 {
                section.add_face(mesh, tetrahedron, corner, shift);
            }
        }
        section
    }

    /// Adds the face opposite a corner.
    fn add_face(&mut self, mesh: &TetMesh, tetrahedron: TetId, corner: usize, shift: DVec3) {
        let places = mesh.corners(tetrahedron);
        let [a, b, c] = FACES[corner].map(|corner| places[corner]);
        // Meshes have no flat tetrahedra, and so no degenerate faces; the normal of one would not matter.
        let normal = (b - a).cross(c - a).normalize_or(DVec3::Z);
        let first = self.positions.len() as u32;
        for corner in FACES[corner] {
            let mut weights = [0.0; 4];
            weights[corner] = 1.0;
            self.push(places[corner] + shift, normal, tetrahedron, weights);
        }
        self.triangles.push([first, first + 1, first + 2]);
    }
}

fn those_that(stay: &[bool]) -> impl Iterator<Item = TetId> + '_ {
    (0..stay.len() as u32).map(TetId).filter(|tetrahedron| stay[tetrahedron.index()])
}

fn centroid(mesh: &TetMesh, tetrahedron: TetId) -> DVec3 {
    mesh.corners(tetrahedron).iter().sum::<DVec3>() / 4.0
}

/// Whether each tetrahedron stays.
fn stays(mesh: &TetMesh, cut: &Cut) -> Vec<bool> {
    let sides = Sides::new(mesh, cut);
    let stays = |(tetrahedron, corners): (usize, &[u32; 4])| match sides.of(corners) {
        Side::Before => true,
        Side::Beyond => false,
        Side::Across(_) => !cut.removes(centroid(mesh, TetId(tetrahedron as u32))),
    };
    mesh.tetrahedra().iter().enumerate().map(stays).collect()
}
