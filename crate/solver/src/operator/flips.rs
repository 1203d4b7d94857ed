//! What becomes of places of a surface while edges are flipped.

use heatwalk_base::csr::distribute;
use heatwalk_base::parallel;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element as _, FaceId, HalfedgeId};

use crate::operator::intrinsic::{IntrinsicTriangulation, next, previous};

/// The flips that made the faces of a surface Delaunay, in their order: tells where a place of a face lies on the triangles.
#[derive(Debug, Clone)]
pub struct Flips {
    flips: Vec<Flip>,
    /// `#F + 1`, where in `numbers` those of each face begin.
    start: Vec<u32>,
    /// Of each face the numbers of the flips that it was in, ascending.
    numbers: Vec<u32>,
}

/// Triangles (a, b, c) and (b, a, d), which became (c, d, b) and (d, c, a).
#[derive(Debug, Clone, Copy)]
struct Flip {
    /// The slots of the edge: from a to b and back, then from c to d and back.
    slots: [u32; 2],
    /// Lengths of c–d, d–b, b–c, c–a and a–d.
    lengths: [f64; 5],
}

impl IntrinsicTriangulation {
    /// The Delaunay triangulation of the half-edge mesh of a surface, with the flips that lead to it. It is a single sheet always:
    /// cuts and boundary stay, and triangles may be obtuse opposite these.
    pub fn delaunay_of_sheet(surface: &Surface) -> (Self, Flips) {
        let mut triangulation = Self::of_surface(surface);
        let mut flips: Vec<Flip> = Vec::new();
        triangulation.flip_to_delaunay(0..3 * surface.face_count() as u32, |flipped, slot| {
            let twin = flipped.twin(HalfedgeId(slot)).expect("only an edge of two faces is flipped").0;
            let sides = [slot, next(slot), previous(slot), next(twin), previous(twin)];
            flips.push(Flip { slots: [slot, twin], lengths: sides.map(|side| flipped.length(HalfedgeId(side))) });
        });
        let face = |index: usize| Some(flips[index / 2].slots[index % 2] as usize / 3);
        let number = |index: usize| index as u32 / 2;
        let (start, numbers) = distribute(surface.face_count(), 2 * flips.len(), parallel::ONE, face, number);
        (triangulation, Flips { flips, start, numbers })
    }
}

impl Flips {
    /// The triangle that a place of a face lies on after all flips, and its barycentric weights there, of the corners that the
    /// triangle's slots leave. The weights of the face are non-negative, of sum 1, as those of a [`Place`](crate::Place) of a
    /// [`SurfacePoint`](crate::SurfacePoint) are.
    pub fn relocated(&self, face: FaceId, weights: [f64; 3]) -> (FaceId, [f64; 3]) {
        let mut at = (face, weights);
        let mut done = 0;
        loop {
            let own = self.start[at.0.index()] as usize..self.start[at.0.index() + 1] as usize;
            let own = &self.numbers[own];
            let Some(&number) = own.get(own.partition_point(|&number| number < done)) else { return at };
            at = self.flips[number as usize].relocated(at);
            done = number + 1;
        }
    }
}

impl Flip {
    /// Where a place of one of the two triangles lies after the flip.
    fn relocated(&self, (face, weights): (FaceId, [f64; 3])) -> (FaceId, [f64; 3]) {
        let [cd, db, bc, ca, ad] = self.lengths;
        let [slot, twin] = self.slots;
        // In the plane, c at the origin, d along x, b above and a below.
        let b = corner(cd, bc, db, 1.0);
        let a = corner(cd, ca, ad, -1.0);
        let (c, d) = ([0.0, 0.0], [cd, 0.0]);
        let mut place = [0.0; 2];
        let is_first = face.0 == slot / 3;
        let (edge, corners) = if is_first { (slot, [a, b, c]) } else { (twin, [b, a, d]) };
        for (corner, side) in corners.into_iter().zip([edge, next(edge), previous(edge)]) {
            let weight = weights[side as usize % 3];
            place = [0, 1].map(|axis| place[axis] + weight * corner[axis]);
        }
        let (edge, corners) = if place[1] >= 0.0 { (slot, [c, d, b]) } else { (twin, [d, c, a]) };
        let mut relocated = [0.0; 3];
        let shares = weights_in(corners, place);
        for (weight, side) in shares.into_iter().zip([edge, next(edge), previous(edge)]) {
            relocated[side as usize % 3] = weight;
        }
        (FaceId(edge / 3), relocated)
    }
}

/// The corner at these distances from the origin and from the end of an edge along x, on one of its sides.
fn corner(edge: f64, from_start: f64, from_end: f64, side: f64) -> [f64; 2] {
    let x = ((from_start - from_end) * (from_start + from_end) + edge * edge) / (2.0 * edge);
    [x, side * ((from_start - x) * (from_start + x)).max(0.0).sqrt()]
}

/// Barycentric weights of a place in a triangle of the plane, cut to those of places inside.
fn weights_in(corners: [[f64; 2]; 3], place: [f64; 2]) -> [f64; 3] {
    let area = |[a, b]: [[f64; 2]; 2]| {
        let [a, b] = [a, b].map(|corner| [corner[0] - place[0], corner[1] - place[1]]);
        (a[0] * b[1] - a[1] * b[0]).max(0.0)
    };
    let [a, b, c] = corners;
    let areas = [[b, c], [c, a], [a, b]].map(area);
    let sum: f64 = areas.iter().sum();
    if sum > 0.0 { areas.map(|area| area / sum) } else { [1.0, 0.0, 0.0] }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};
    use heatwalk_surface::Soup;

    use super::*;
    use crate::Place;

    /// A flat sheet of `n × n` quads, sheared so that most diagonals are flipped, some more than once.
    fn sheared(n: u32) -> Surface {
        let places = (0..=n).flat_map(|i| (0..=n).map(move |j| DVec2::new(f64::from(i), f64::from(j))));
        let wave = |place: DVec2| DVec3::new(place.x + 2.3 * place.y, place.y + 0.2 * (3.0 * place.x).sin(), 0.0);
        let vertex = |i, j| i * (n + 1) + j;
        let quads = (0..n).flat_map(|i| {
            (0..n).map(move |j| [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)])
        });
        let triangles = quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        Surface::build(&Soup::single("sheared", places.map(wave).collect(), triangles)).expect("a surface")
    }

    #[test]
    fn places_stay_where_they_are() {
        let surface = sheared(6);
        let (triangulation, flips) = IntrinsicTriangulation::delaunay_of_sheet(&surface);
        assert!(flips.numbers.len() > surface.face_count(), "faces are in several flips");
        for face in (0..surface.face_count()).map(FaceId::from_index) {
            for weights in [[0.2, 0.3, 0.5], [0.96, 0.03, 0.01], [0.0, 0.4, 0.6], [0.0, 0.0, 1.0]] {
                let position = Place::Face { face, weights }.position(&surface);
                let (triangle, weights) = flips.relocated(face, weights);
                let corner = |k: usize| surface.position(triangulation.ends(triangle.halfedge(k))[0]);
                let relocated: DVec3 = (0..3).map(|k| weights[k] * corner(k)).sum();
                // Lengths are a little more where there are flat triangles.
                assert!(relocated.distance(position) < 1e-9, "{relocated} for {position}");
            }
        }
    }

    #[test]
    fn one_sheet_remains_with_its_boundary() {
        let surface = sheared(6);
        let (triangulation, _) = IntrinsicTriangulation::delaunay_of_sheet(&surface);
        assert_eq!((triangulation.sheets(), triangulation.face_count()), (1, surface.face_count()));
        let open =
            (0..3 * surface.face_count()).filter(|&side| triangulation.twin(HalfedgeId::from_index(side)).is_none());
        assert_eq!(open.count(), 24);
    }
}
