//! How good tetrahedra are.

use glam::DVec3;

use crate::soup::TetSoup;

/// The least and the greatest of the angles between faces, in radians; of no tetrahedra, an empty range. Those without volume have
/// angles that are no numbers and are left out.
pub fn dihedral_angles(soup: &TetSoup) -> [f64; 2] {
    let (mut least, mut greatest) = (1.0_f64, -1.0_f64);
    for tetrahedron in &soup.tetrahedra {
        let [a, b, c, d] = tetrahedron.map(|corner| soup.positions[corner as usize]);
        // Unit normals of the faces, all outward or all inward.
        let normals = [(c - b).cross(d - b), (d - a).cross(c - a), (b - a).cross(d - a), (c - a).cross(b - a)]
            .map(DVec3::normalize);
        for j in 0..4 {
            for i in 0..j {
                let cosine = -normals[i].dot(normals[j]);
                (least, greatest) = (least.min(cosine), greatest.max(cosine));
            }
        }
    }
    [greatest.clamp(-1.0, 1.0).acos(), least.clamp(-1.0, 1.0).acos()]
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
