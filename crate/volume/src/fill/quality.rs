//! How good tetrahedra are.

use glam::DVec3;

use crate::soup::TetSoup;

/// The least and the greatest of the angles between faces, in radians; of no tetrahedra, an empty range. Those without volume have
/// angles that are no numbers and are left out.
pub fn dihedral_angles(soup: &TetSoup) -> [f64; 2] {
    let corners = |tetrahedron: &[u32; 4]| tetrahedron.map(|corner| soup.positions[corner as usize]);
    let wider = |[least, greatest]: [f64; 2], other: [f64; 2]| [least.min(other[0]), greatest.max(other[1])];
    angles(soup.tetrahedra.iter().map(|tetrahedron| cosines(corners(tetrahedron))).fold(NO_COSINES, wider))
}

/// The same of one tetrahedron.
pub fn dihedral_angles_of(corners: [DVec3; 4]) -> [f64; 2] {
    angles(cosines(corners))
}

const NO_COSINES: [f64; 2] = [1.0, -1.0];

fn angles([least, greatest]: [f64; 2]) -> [f64; 2] {
    [greatest, least].map(|cosine| cosine.clamp(-1.0, 1.0).acos())
}

/// The least and the greatest cosine of the angles between faces.
fn cosines([a, b, c, d]: [DVec3; 4]) -> [f64; 2] {
    // Unit normals of the faces, all outward or all inward.
    let normals =
        [(c - b).cross(d - b), (d - a).cross(c - a), (b - a).cross(d - a), (c - a).cross(b - a)].map(DVec3::normalize);
    let [mut least, mut greatest] = NO_COSINES;
    for j in 0..4 {
        for i in 0..j {
            let cosine = -normals[i].dot(normals[j]);
            (least, greatest) = (least.min(cosine), greatest.max(cosine));
        }
    }
    [least, greatest]
}

/// The volume of a tetrahedron, positive where its corners are oriented as the axes.
pub fn volume([a, b, c, d]: [DVec3; 4]) -> f64 {
    (b - a).cross(c - a).dot(d - a) / 6.0
}

/// The triangles on the surface: faces of one tetrahedron. None of them has a vertex that is not on the surface.
pub fn boundary(soup: &TetSoup, is_on_surface: &[bool]) -> Vec<[u32; 3]> {
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for &[a, b, c, d] in &soup.tetrahedra {
        for mut face in [[b, c, d], [a, c, d], [a, b, d], [a, b, c]] {
            if face.iter().all(|&vertex| is_on_surface[vertex as usize]) {
                face.sort_unstable();
                faces.push(face);
            }
        }
    }
    faces.sort_unstable();
    faces.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).map(|same| same[0]).collect()
}
