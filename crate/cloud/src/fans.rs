//! Triangles that fit together: around each point they do not overlap in its tangent plane, so that no edge has more than two.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use heatwalk_base::csr::NONE;

use crate::plane::Plane;

/// Least cosine between the normal of a triangle and those of the planes at all of its points: one that is square to a plane goes from sheet to
/// sheet.
const UPRIGHT: f64 = 0.1;
/// What triangles may overlap by, in radians: far more than rounding, far less than an angle.
const TOUCH: f64 = 1e-6;

/// The triangles taken so far.
pub struct Fans<'a> {
    positions: &'a [DVec3],
    planes: &'a [Plane],
    pub triangles: Vec<[u32; 3]>,
    /// Of each point the corner that came last; number [`NONE`] without any.
    last: Vec<u32>,
    /// Of corner `k` of triangle `t` at `3 t + k`, where it begins and how wide it is, in the plane at its point, and the corner there
    /// that came before.
    corners: Vec<([f64; 2], u32)>,
}

impl<'a> Fans<'a> {
    pub fn new(positions: &'a [DVec3], planes: &'a [Plane]) -> Self {
        Self { positions, planes, triangles: Vec::new(), last: vec![NONE; positions.len()], corners: Vec::new() }
    }

    /// All of these, which fit.
    pub fn of(positions: &'a [DVec3], planes: &'a [Plane], triangles: &[[u32; 3]]) -> Self {
        let mut fans = Self::new(positions, planes);
        for &triangle in triangles {
            fans.add(triangle, [0, 1, 2].map(|k| fans.angle(triangle, k)));
        }
        fans
    }

    /// Takes a triangle if it fits. Returns whether it does.
    pub fn take(&mut self, triangle: [u32; 3]) -> bool {
        let angles = [0, 1, 2].map(|k| self.angle(triangle, k));
        let normal = self.normal(triangle);
        let is_flat = |vertex: u32| normal.dot(self.planes[vertex as usize].normal).abs() >= UPRIGHT;
        let fits = (0..3).all(|k| is_flat(triangle[k]) && self.is_free(triangle[k], angles[k]))
            // Beside a point that lies square to a plane angles tell nothing.
            && (0..3).all(|k| self.beside(triangle, k).nth(1).is_none());
        if fits {
            self.add(triangle, angles);
        }
        fits
    }

    /// Takes a triangle whatever there is around its points in their planes, if no side gets a third one and its normal and those beside it
    /// are nearer to each other than this cosine tells. Triangles agree in orientation. Returns whether it does.
    pub fn take_unless_folded(&mut self, triangle: [u32; 3], cosine: f64) -> bool {
        let own = self.normal(triangle);
        let fits = own != DVec3::ZERO
            && (0..3).all(|k| {
                let mut beside = self.beside(triangle, k);
                match (beside.next(), beside.next()) {
                    (None, _) => true,
                    (Some(other), None) => own.dot(self.normal(other)) > cosine,
                    _ => false,
                }
            });
        if fits {
            let angles = [0, 1, 2].map(|k| self.angle(triangle, k));
            self.add(triangle, angles);
        }
        fits
    }

    fn normal(&self, triangle: [u32; 3]) -> DVec3 {
        let [a, b, c] = triangle.map(|vertex| self.positions[vertex as usize]);
        (b - a).cross(c - a).normalize_or_zero()
    }

    fn add(&mut self, triangle: [u32; 3], angles: [[f64; 2]; 3]) {
        for (vertex, angle) in triangle.into_iter().zip(angles) {
            let before = std::mem::replace(&mut self.last[vertex as usize], self.corners.len() as u32);
            self.corners.push((angle, before));
        }
        self.triangles.push(triangle);
    }

    /// The triangles at a side of another one.
    fn beside(&self, triangle: [u32; 3], k: usize) -> impl Iterator<Item = [u32; 3]> + '_ {
        let [a, b] = [triangle[k], triangle[(k + 1) % 3]];
        self.corners_of(a).map(|corner| self.triangles[corner as usize / 3]).filter(move |other| other.contains(&b))
    }

    fn corners_of(&self, point: u32) -> impl Iterator<Item = u32> + '_ {
        let next = |corner: u32| Some(corner).filter(|&corner| corner != NONE);
        std::iter::successors(next(self.last[point as usize]), move |&corner| next(self.corners[corner as usize].1))
    }

    /// Where a corner begins, counterclockwise, and how wide it is.
    fn angle(&self, triangle: [u32; 3], k: usize) -> [f64; 2] {
        let at = triangle[k] as usize;
        let of = |vertex: u32| self.planes[at].angle(self.positions[vertex as usize] - self.positions[at]);
        let [a, b] = [of(triangle[(k + 1) % 3]), of(triangle[(k + 2) % 3])];
        let width = (b - a).rem_euclid(TAU);
        if width <= PI { [a, width] } else { [b, TAU - width] }
    }

    fn is_free(&self, point: u32, [begin, width]: [f64; 2]) -> bool {
        self.corners_of(point).all(|corner| {
            let [other, other_width] = self.corners[corner as usize].0;
            let ahead = (other - begin).rem_euclid(TAU);
            ahead >= width - TOUCH && ahead + other_width <= TAU + TOUCH
        })
    }
}
