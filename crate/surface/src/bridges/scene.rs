//! A surface in units of its own size, so that nothing depends on the unit of the file or on how far the origin is.

use std::num::NonZeroUsize;

use glam::DVec3;

use super::bounds::Bounds;
use super::triangles::Triangle;
use crate::csr::distribute;
use crate::element::{Element, FaceId};
use crate::parallel;
use crate::point::Place;
use crate::surface::Surface;
use crate::triangle;

/// Places are told apart down to this many roundings of a coordinate.
const ROUNDINGS: f64 = 64.0;

/// Portals of a contact are no farther apart than this share of the diagonal of the scene, even on a coarse mesh.
const MOST_SPACING: f64 = 0.0075;

/// Cosine of the angle between faces from which on the surface bends at a side: 30°.
const BENT: f64 = 0.866;

/// Lengths here are shares of the diagonal of the surface's bounding box, places are relative to its centre.
pub struct Scene<'a> {
    pub surface: &'a Surface,
    /// Threads that look for contacts.
    pub threads: NonZeroUsize,
    /// `#V`.
    points: Vec<DVec3>,
    /// `#F`.
    normals: Vec<DVec3>,
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
        let mut scene = Self {
            surface,
            threads,
            points,
            normals: Vec::new(),
            half_diagonal,
            rounding: ROUNDINGS * f64::EPSILON * farthest.max(1.0),
            least_spacing: 0.0,
            bounds: Vec::with_capacity(components),
            mean_sides: Vec::with_capacity(components),
            first_face,
            faces,
        };
        let normal = |face| triangle::unit(triangle::area_vector(scene.triangle(face)));
        scene.normals = (0..face_count as u32).map(normal).collect();
        for component in 0..components {
            let triangles = || scene.faces_of(component).iter().map(|&face| scene.triangle(face));
            let bounds = Bounds::of_points(triangles().flatten());
            let perimeter = |[p, q, r]: Triangle| p.distance(q) + q.distance(r) + r.distance(p);
            let mean_side = triangles().map(perimeter).sum::<f64>() / (3 * triangles().len()) as f64;
            scene.bounds.push(bounds);
            scene.mean_sides.push(mean_side);
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

    /// Whether the surface ends or bends at the sides of a face, from each corner to the next.
    pub fn is_rim(&self, face: u32) -> [bool; 3] {
        let own = self.normal(face);
        [0, 1, 2].map(|k| {
            let twin = self.surface.mesh().twin(FaceId(face).halfedge(k));
            let is_outer = twin.index() >= 3 * self.surface.face_count();
            is_outer || own.dot(self.normal(twin.triangle().0)) < BENT
        })
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
