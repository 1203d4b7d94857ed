//! The regular icosahedron.

use glam::DVec3;

/// The corners of a regular icosahedron, of length 1.
pub(super) fn icosahedron() -> Vec<DVec3> {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    (0..12)
        .map(|index| {
            let sign = |bit: usize| if index >> bit & 1 == 0 { 1.0 } else { -1.0 };
            let mut corner = [0.0; 3];
            corner[index / 4] = sign(0);
            corner[(index / 4 + 1) % 3] = golden * sign(1);
            DVec3::from_array(corner).normalize()
        })
        .collect()
}

/// Corners of the faces of a regular icosahedron, ascending.
pub(super) fn faces_of(corners: &[DVec3]) -> impl Iterator<Item = [usize; 3]> + '_ {
    // Neighboring corners are at an angle of 63.4°, others at 116.6° or 180°.
    let is_edge = |a: usize, b: usize| corners[a].dot(corners[b]) > 0.0;
    let triples = (0..12).flat_map(|a| (a + 1..12).flat_map(move |b| (b + 1..12).map(move |c| [a, b, c])));
    triples.filter(move |&[a, b, c]| is_edge(a, b) && is_edge(b, c) && is_edge(c, a))
}
