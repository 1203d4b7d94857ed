//! Caps: where the planes of a cut cross a mesh.

use glam::DVec3;

use super::crossing::CROSSED;
use super::cut::{Side, Sides};
use super::{Cut, Plane, Section};
use crate::mesh::{FACES, TetId, TetMesh};

/// Corners of a polygon, at most: four where a plane crosses a tetrahedron, and one more where a second plane clips it.
const MOST_CORNERS: usize = 5;

/// A corner of the polygon of a plane in a tetrahedron.
#[derive(Debug, Clone, Copy, Default)]
struct Corner {
    place: DVec3,
    weights: [f64; 4],
    /// How far it is beyond the other plane of a wedge.
    beyond: f64,
}

/// A convex polygon without repeated corners.
#[derive(Debug, Default)]
struct Polygon {
    corners: [Corner; MOST_CORNERS],
    count: usize,
}

impl Polygon {
    /// Adds a corner where it is not the last one again, as where a plane goes through a vertex.
    fn push(&mut self, corner: Corner) {
        if self.count == 0 || self.corners[self.count - 1].place != corner.place {
            self.corners[self.count] = corner;
            self.count += 1;
        }
    }

    /// Its corners, once each; none where they bound no area.
    fn corners(&self) -> &[Corner] {
        let corners = &self.corners[..self.count];
        let corners = match corners {
            [first, rest @ .., last] if first.place == last.place && !rest.is_empty() => &corners[..self.count - 1],
            _ => corners,
        };
        if corners.len() < 3 { &[] } else { corners }
    }
}

/// A tetrahedron with how far its corners are beyond the plane of a cap, and beyond the other plane where there are two.
struct Cell<'a> {
    vertices: &'a [u32; 4],
    places: [DVec3; 4],
    own: [f64; 4],
    other: Option<[f64; 4]>,
}

impl Cell<'_> {
    /// The polygon of the cap's plane, as far as it is beyond the other one.
    fn polygon(&self) -> Polygon {
        let mask = (0..4).filter(|&corner| self.own[corner] > 0.0).fold(0, |mask, corner| mask | 1 << corner);
        let mut polygon = Polygon::default();
        for &[before, beyond] in CROSSED[mask].edges() {
            polygon.push(self.on_edge(before, beyond));
        }
        if self.other.is_some() { self.clipped(&polygon) } else { polygon }
    }

    /// Where the cap's plane crosses an edge, computed in the same order in each tetrahedron at that edge.
    fn on_edge(&self, before: usize, beyond: usize) -> Corner {
        let share = self.own[before] / (self.own[before] - self.own[beyond]);
        let between = |values: [f64; 4]| values[before] + share * (values[beyond] - values[before]);
        let mut weights = [0.0; 4];
        weights[before] = 1.0 - share;
        weights[beyond] = share;
        let [from, to] = [self.places[before], self.places[beyond]];
        Corner { place: from + share * (to - from), weights, beyond: self.other.map_or(0.0, between) }
    }

    /// The part beyond the other plane (Sutherland and Hodgman 1974).
    fn clipped(&self, polygon: &Polygon) -> Polygon {
        let mut clipped = Polygon::default();
        let corners = polygon.corners();
        for (index, &corner) in corners.iter().enumerate() {
            let next = corners[(index + 1) % corners.len()];
            if corner.beyond > 0.0 {
                clipped.push(corner);
            }
            if (corner.beyond > 0.0) != (next.beyond > 0.0) {
                clipped.push(self.on_both(&corner, &next));
            }
        }
        clipped
    }

    /// Where the side between two corners is on both planes. Weights in the face of that side are the cross product of what its
    /// corners are beyond one and the other plane, so that both caps and both tetrahedra at the face have the same bits.
    fn on_both(&self, a: &Corner, b: &Corner) -> Corner {
        let other = self.other.unwrap_or_default();
        let between = || {
            let share = a.beyond / (a.beyond - b.beyond);
            let weights = [0, 1, 2, 3].map(|k| a.weights[k] + share * (b.weights[k] - a.weights[k]));
            Corner { place: a.place.lerp(b.place, share), weights, beyond: 0.0 }
        };
        let Some(opposite) = (0..4).find(|&k| a.weights[k] == 0.0 && b.weights[k] == 0.0) else { return between() };
        let mut face = FACES[opposite];
        face.sort_unstable_by_key(|&corner| self.vertices[corner]);
        let cross = DVec3::from_array(face.map(|k| self.own[k])).cross(DVec3::from_array(face.map(|k| other[k])));
        let shares = (cross / cross.element_sum()).max(DVec3::ZERO);
        let shares = shares / shares.element_sum();
        // The two planes may be one up to rounding.
        if !shares.is_finite() {
            return between();
        }
        let mut weights = [0.0; 4];
        let mut place = DVec3::ZERO;
        for (k, share) in face.into_iter().zip(shares.to_array()) {
            weights[k] = share;
            place += share * self.places[k];
        }
        Corner { place, weights, beyond: 0.0 }
    }
}

impl Section {
    /// The caps that close what a cut leaves, without the boundary of the mesh: polygons in which its planes cross tetrahedra, with
    /// normals to the side that is taken away. Those of a wedge end where they meet. Empty for [`Cut::Whole`].
    ///
    /// What lies in a plane stays, so that a plane along faces has them once.
    ///
    /// ```
    /// use glam::DVec3;
    /// use heatwalk_volume::section::{Cut, Plane, Section};
    /// use heatwalk_volume::{TetMesh, shapes};
    ///
    /// let mesh = TetMesh::build(&shapes::cube(6, 0.2))?;
    /// let section = Section::of_cut(&mesh, &Cut::Plane(Plane { normal: DVec3::Z, offset: 0.1 }));
    /// let heights: Vec<f64> = mesh.positions().iter().map(|position| position.z).collect();
    /// assert!(section.interpolate(&mesh, &heights)?.iter().all(|height| (height - 0.1).abs() < 1e-12));
    /// # Ok::<(), heatwalk_volume::Error>(())
    /// ```
    pub fn of_cut(mesh: &TetMesh, cut: &Cut) -> Self {
        let mut section = Self::empty(mesh);
        let planes = cut.planes();
        if planes.is_empty() {
            return section;
        }
        let beyond = |plane: &Plane| mesh.positions().iter().map(|&place| plane.beyond(place)).collect();
        let beyond: Vec<Vec<f64>> = planes.iter().map(beyond).collect();
        let sides = Sides::new(mesh, cut);
        for (tetrahedron, vertices) in mesh.tetrahedra().iter().enumerate() {
            let Side::Across(crossed) = sides.of(vertices) else { continue };
            let places = mesh.corners(TetId(tetrahedron as u32));
            for plane in (0..planes.len()).filter(|plane| crossed >> plane & 1 == 1) {
                let values = |plane: usize| vertices.map(|vertex| beyond[plane][vertex as usize]);
                let other = (planes.len() == 2).then(|| values(1 - plane));
                let polygon = Cell { vertices, places, own: values(plane), other }.polygon();
                section.add(TetId(tetrahedron as u32), planes[plane].normal, &polygon);
            }
        }
        section
    }

    fn add(&mut self, tetrahedron: TetId, normal: DVec3, polygon: &Polygon) {
        let first = self.positions.len() as u32;
        let corners = polygon.corners();
        for corner in corners {
            self.push(corner.place, normal, tetrahedron, corner.weights);
        }
        for next in 2..corners.len() as u32 {
            self.triangles.push([first, first + next - 1, first + next]);
        }
    }
}
