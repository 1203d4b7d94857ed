//! A surface in units of its own size, so that nothing depends on the unit of the file or on how far the origin is.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_base::csr::distribute;
use heatwalk_base::parallel;

use super::triangles::{Features, Triangle};
use crate::element::{Element, FaceId};
use crate::index::Bounds;
use crate::point::Place;
use crate::surface::Surface;
use crate::triangle;

/// Places are told apart down to this many roundings of a coordinate.
const ROUNDINGS: f64 = 64.0;

/// Portals of a contact are no farther apart than this share of the diagonal of the scene, even on a coarse mesh.
const MOST_SPACING: f64 = 0.0075;

/// Parts that a line along which there are portals is cut into at most: several times as many as of the widest spacing make the
/// diagonal.
const MOST_CUTS: f64 = 1024.0;

/// Cosine of the angle between faces from which on the surface bends at a side: 30°.
const BENT: f64 = 0.866;

/// The number of parts that a line is cut into, no longer than the spacing but where that is no length to speak of.
pub fn cuts(length: f64, spacing: f64) -> u32 {
    (length / spacing).ceil().clamp(1.0, MOST_CUTS) as u32
}

/// Lengths here are shares of the diagonal of the surface's bounding box, places are relative to its centre.
pub struct Scene<'a> {
    pub surface: &'a Surface,
    /// Threads that look for contacts.
    pub threads: NonZeroUsize,
    /// `#V`.
    points: Vec<DVec3>,
    /// `#F`.
    normals: Vec<DVec3>,
    /// `#F`, length of the longest side.
    longest: Vec<f64>,
    /// Half the diagonal, in the file's unit: a number where the diagonal is none.
    half_diagonal: f64,
    /// Lengths below this are noise.
    pub rounding: f64,
    /// Portals are no nearer to each other than that, even on a fine mesh.
    pub least_spacing: f64,
    /// `#components`.
    pub bounds: Vec<Bounds>,
    /// `#components`, mean length of the sides of the triangles.
    mean_sides: Vec<f64>,
    /// The faces of each component: `#components + 1`, where each list begins, and the lists.
    first_face: Vec<u32>,
    faces: Vec<u32>,
}

impl<'a> Scene<'a> {
    /// Of a surface.
    pub fn new(surface: &'a Surface, threads: NonZeroUsize) -> Self {
        let Bounds { low, high } = Bounds::of_points(surface.positions().iter().copied());
        let half_diagonal = triangle::length(0.5 * high - 0.5 * low);
        let half_centre = 0.25 * high + 0.25 * low;
        let points: Vec<DVec3> =
            surface.positions().iter().map(|&position| (0.5 * position - half_centre) / half_diagonal).collect();
        let farthest = low.abs().max(high.abs()).max_element() / half_diagonal;
        let components = surface.report().components;
        let component = |face: usize| Some(surface.component(surface.faces().as_slice()[face][0]) as usize);
        let face_count = surface.face_count();
        let (first_face, faces) = distribute(components, face_count, parallel::ONE, component, |face| face as u32);
        let rounding = ROUNDINGS * f64::EPSILON * farthest.max(1.0);
        let mut scene = Self {
            surface,
            threads,
            points,
            normals: Vec::new(),
            longest: vec![0.0; face_count],
            half_diagonal,
            rounding,
            least_spacing: rounding,
            bounds: Vec::with_capacity(components),
            mean_sides: Vec::with_capacity(components),
            first_face,
            faces,
        };
        let normal = |face| triangle::unit(triangle::area_vector(scene.triangle(face)));
        scene.normals = (0..face_count as u32).map(normal).collect();
        for component in 0..components {
            let (mut bounds, mut perimeters) = (Bounds::EMPTY, 0.0);
            let own = scene.first_face[component] as usize..scene.first_face[component + 1] as usize;
            for index in own.clone() {
                let face = scene.faces[index];
                let [p, q, r] = scene.triangle(face);
                let sides = [p.distance(q), q.distance(r), r.distance(p)];
                bounds = bounds.around(Bounds::of_points([p, q, r]));
                perimeters += sides[0] + sides[1] + sides[2];
                scene.longest[face as usize] = sides[0].max(sides[1]).max(sides[2]);
            }
            scene.bounds.push(bounds);
            scene.mean_sides.push(perimeters / (3 * own.len()) as f64);
        }
        scene
    }

    /// A length given in the file's unit.
    pub fn in_scene_unit(&self, length: f64) -> f64 {
        0.5 * (length / self.half_diagonal)
    }

    /// A length in the file's unit.
    pub fn in_file_unit(&self, length: f64) -> f64 {
        2.0 * (length * self.half_diagonal)
    }

    /// Corners of a face.
    #[inline]
    pub fn triangle(&self, face: u32) -> Triangle {
        self.surface.faces()[FaceId(face)].map(|vertex| self.points[vertex.index()])
    }

    /// Unit normal of a face; zero where there is none.
    #[inline]
    pub fn normal(&self, face: u32) -> DVec3 {
        self.normals[face as usize]
    }

    /// Length of the longest side of a face.
    #[inline]
    pub fn longest(&self, face: u32) -> f64 {
        self.longest[face as usize]
    }

    /// What a face tells of: the corners and sides that it shares with no larger one.
    pub fn features(&self, face: u32) -> Features {
        let is_largest = |other: u32| (self.longest(face), face) >= (self.longest(other), other);
        let corners = self.surface.faces()[FaceId(face)].map(|vertex| {
            let mut around = self.surface.corners_of_vertex(vertex);
            around.all(|(other, _)| is_largest(other.0))
        });
        let beyond = [0, 1, 2].map(|k| {
            let twin = self.surface.mesh().twin(FaceId(face).halfedge(k));
            (twin.index() < 3 * self.surface.face_count()).then(|| twin.triangle().0)
        });
        let sides = beyond.map(|other| other.is_none_or(is_largest));
        let is_bent = |other: u32| self.normal(face).dot(self.normal(other)) < BENT;
        Features { corners, sides, rims: [0, 1, 2].map(|k| sides[k] && beyond[k].is_none_or(is_bent)) }
    }

    /// Where a place of the surface is.
    pub fn point(&self, place: Place) -> DVec3 {
        place.support(self.surface).map(|(vertex, weight)| self.points[vertex.index()] * weight).sum()
    }

    /// The faces of a component.
    pub fn faces_of(&self, component: usize) -> &[u32] {
        &self.faces[self.first_face[component] as usize..self.first_face[component + 1] as usize]
    }

    /// How far apart the portals of two components are to be.
    #[inline]
    pub fn spacing(&self, [a, b]: [u32; 2]) -> f64 {
        self.mean_sides[a as usize].min(self.mean_sides[b as usize]).clamp(self.least_spacing, MOST_SPACING)
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use std::collections::HashMap;

    use super::super::tests::{assembled, cuboid, sphere};
    use super::*;

    #[test]
    fn each_corner_and_each_side_is_told_of_by_one_face() {
        let surface = assembled(&[cuboid([0.0; 3], [1.0; 3]), sphere([3.0, 0.0, 0.0], 1.0)]);
        let scene = Scene::new(&surface, parallel::ONE);
        let mut corners = vec![0; surface.vertex_count()];
        let mut sides = HashMap::new();
        for face in 0..surface.face_count() as u32 {
            let (features, vertices) = (scene.features(face), surface.faces()[FaceId(face)]);
            for k in 0..3 {
                let (a, b) = (vertices[k], vertices[(k + 1) % 3]);
                corners[a.index()] += u32::from(features.corners[k]);
                *sides.entry((a.min(b), a.max(b))).or_insert(0) += u32::from(features.sides[k]);
                assert!(features.sides[k] || !features.rims[k]);
            }
        }
        assert!(corners.into_iter().all(|count| count == 1));
        assert!(sides.into_values().all(|count| count == 1));
    }
}
