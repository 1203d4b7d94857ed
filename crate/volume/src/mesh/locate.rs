//! Where in a mesh a place in space is, and whether a straight line stays inside.

use glam::DVec3;

use crate::mesh::{FACES, NONE, TetId, TetMesh};

/// A barycentric coordinate of the end of a line may be this far below 0 in a tetrahedron that the line stays in: lines along
/// the boundary and through edges are inside, whatever rounding makes of them. In lengths, it is this share of a tetrahedron's
/// height, which is not seen; rounding of coordinates is below it as long as a tetrahedron's height is not below
/// 10⁻⁶ of the line's length.
pub(crate) const GRAZING: f64 = 1e-9;

/// Barycentric weights of a place in a tetrahedron; one is negative for each face that it is beyond.
#[inline]
pub(crate) fn weights([a, b, c, d]: [DVec3; 4], point: DVec3) -> [f64; 4] {
    let (ab, ac, ad, ap) = (b - a, c - a, d - a, point - a);
    let across = ac.cross(ad);
    let scale = 1.0 / ab.dot(across);
    let turned = ap.cross(ab);
    let of_b = ap.dot(across) * scale;
    let of_c = -ad.dot(turned) * scale;
    let of_d = ac.dot(turned) * scale;
    [1.0 - of_b - of_c - of_d, of_b, of_c, of_d]
}

/// Barycentric weights of both ends of a line in a tetrahedron, times six times its volume, and that.
#[inline]
fn scaled_weights([a, b, c, d]: [DVec3; 4], from: DVec3, to: DVec3) -> ([[f64; 4]; 2], f64) {
    let (ab, ac, ad) = (b - a, c - a, d - a);
    let across = ac.cross(ad);
    let whole = ab.dot(across);
    let weights = |place: DVec3| {
        let ap = place - a;
        let turned = ap.cross(ab);
        let (of_b, of_c, of_d) = (ap.dot(across), -ad.dot(turned), ac.dot(turned));
        [whole - of_b - of_c - of_d, of_b, of_c, of_d]
    };
    ([weights(from), weights(to)], whole)
}

/// The tetrahedra that lines may go through.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sight<'a> {
    pub(crate) mesh: &'a TetMesh,
    /// `#T × 4`, as [`TetMesh::neighbors`], without those that lines may not enter.
    pub(crate) neighbors: &'a [[u32; 4]],
}

/// Where a line begins.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Start {
    /// At a vertex.
    Vertex(u32),
    /// On an edge.
    Edge([u32; 2]),
    /// In a tetrahedron.
    Inside(u32),
}

/// What a line is about to do at a face that it goes through.
pub(crate) enum Crossing {
    /// Go on.
    On,
    /// It is known that the rest is inside.
    Known,
}

impl Sight<'_> {
    /// Where the straight line between two places ends if it stays inside: the last tetrahedron that it was followed into.
    /// `may_enter` tells which tetrahedra it may go through; `crossing` is told the corners of each face that it goes through.
    pub(crate) fn walk(
        self,
        start: Start,
        [from, to]: [DVec3; 2],
        may_enter: impl Fn(u32) -> bool,
        mut crossing: impl FnMut([u32; 3]) -> Crossing,
    ) -> Option<u32> {
        let mut current = self.first(start, to, &may_enter)?;
        let mut came_from = NONE;
        // A line crosses a tetrahedron once, but rounding may lead it around an edge.
        for _ in 0..self.mesh.tetrahedron_count() + 4 {
            let corners = &self.mesh.tetrahedra()[current as usize];
            let neighbors = &self.neighbors[current as usize];
            let ([at_start, at_end], whole) = scaled_weights(self.mesh.corners(TetId(current)), from, to);
            let beyond = -GRAZING * whole;
            let mut exit: Option<([f64; 2], usize)> = None;
            let mut is_inside = true;
            for corner in 0..4 {
                // Beyond this face is the end of the line, and the line has not come through it.
                if at_end[corner] < beyond {
                    is_inside = false;
                    if neighbors[corner] != came_from || came_from == NONE {
                        let own = [at_start[corner].max(0.0), at_end[corner]];
                        // The line leaves by the face at the least share of it, `start / (start - end)`.
                        let is_first =
                            exit.is_none_or(|([start, end], _)| own[0] * (start - end) < start * (own[0] - own[1]));
                        if is_first {
                            exit = Some((own, corner));
                        }
                    }
                }
            }
            if is_inside {
                return Some(current);
            }
            let (_, corner) = exit?;
            if neighbors[corner] == NONE || !may_enter(neighbors[corner]) {
                return None;
            }
            if matches!(crossing(FACES[corner].map(|other| corners[other])), Crossing::Known) {
                return Some(current);
            }
            came_from = current;
            current = neighbors[corner];
        }
        None
    }

    /// Whether a line to a place begins inside: in one of the tetrahedra around its start.
    pub(crate) fn leaves(self, start: Start, to: DVec3, may_enter: impl Fn(u32) -> bool) -> bool {
        self.first(start, to, may_enter).is_some()
    }

    /// How many tetrahedra are looked at for that.
    pub(crate) fn around(self, start: Start) -> usize {
        match start {
            Start::Inside(_) => 1,
            Start::Vertex(vertex) | Start::Edge([vertex, _]) => self.mesh.around().row(vertex).len(),
        }
    }

    /// The tetrahedron that a line begins in.
    fn first(self, start: Start, to: DVec3, may_enter: impl Fn(u32) -> bool) -> Option<u32> {
        let [vertex, other] = match start {
            Start::Inside(tetrahedron) => return may_enter(tetrahedron).then_some(tetrahedron),
            Start::Vertex(vertex) => [vertex; 2],
            Start::Edge(ends) => ends,
        };
        let mut best: Option<(f64, u32)> = None;
        for &tetrahedron in self.mesh.around().row(vertex) {
            let corners = self.mesh.tetrahedra()[tetrahedron as usize];
            if !corners.contains(&other) || !may_enter(tetrahedron) {
                continue;
            }
            let weights = weights(self.mesh.corners(TetId(tetrahedron)), to);
            // It leaves into the tetrahedron where it is inside of all faces that meet at the start.
            let faces = (0..4).filter(|&corner| corners[corner] != vertex && corners[corner] != other);
            let least = faces.map(|corner| weights[corner]).fold(f64::INFINITY, f64::min);
            if least >= -GRAZING && best.is_none_or(|(most, _)| least > most) {
                best = Some((least, tetrahedron));
            }
            if least > GRAZING {
                break;
            }
        }
        best.map(|(_, tetrahedron)| tetrahedron)
    }
}
