//! The shape of tetrahedra.

use glam::DVec3;

use crate::mesh::{TetId, TetMesh};

/// Dihedral angles of all tetrahedra, in degrees: the fewer are small or near 180, the better the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quality {
    /// The least.
    pub least_angle: f64,
    /// The largest.
    pub largest_angle: f64,
    /// The mean over tetrahedra of the least angle of each; 70.5 where all are regular.
    pub mean_least_angle: f64,
}

impl TetMesh {
    /// The dihedral angles of its tetrahedra.
    pub fn quality(&self) -> Quality {
        let (mut least, mut largest, mut sum) = (f64::INFINITY, 0.0, 0.0);
        for tetrahedron in 0..self.tetrahedron_count() as u32 {
            let angles = dihedral_angles(self.scaled_corners(TetId(tetrahedron)));
            let own_least = angles.iter().copied().fold(f64::INFINITY, f64::min);
            largest = angles.iter().copied().fold(largest, f64::max);
            least = own_least.min(least);
            sum += own_least;
        }
        Quality {
            least_angle: least.to_degrees(),
            largest_angle: largest.to_degrees(),
            mean_least_angle: (sum / self.tetrahedron_count() as f64).to_degrees(),
        }
    }
}

/// Angles between the faces of a positively oriented tetrahedron at its edges, in the order of [`EDGES`](crate::mesh::EDGES), in
/// radians.
pub(crate) fn dihedral_angles(corners: [DVec3; 4]) -> [f64; 6] {
    crate::mesh::EDGES.map(|[a, b]| {
        let [c, d] = others(a, b);
        let axis = corners[b] - corners[a];
        let [to_c, to_d] = [c, d].map(|corner| axis.cross(corners[corner] - corners[a]));
        to_c.cross(to_d).length().atan2(to_c.dot(to_d))
    })
}

/// The two corners that an edge has not.
fn others(a: usize, b: usize) -> [usize; 2] {
    let mut others = (0..4).filter(|&corner| corner != a && corner != b);
    [others.next().expect("four corners"), others.next().expect("four corners")]
}
