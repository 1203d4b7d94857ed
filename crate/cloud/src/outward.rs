//! Normals that came with the points: which of those nearby are on the other side of something thin, and what is outside.

use std::collections::HashMap;

use glam::DVec3;

/// Least cosine between normals of one side: those of faces at a right angle, and a little more.
const SAME_SIDE: f64 = -0.1;

/// Unit normals of points, zero where there is none; none at all where none came along.
pub struct Outward(Vec<DVec3>);

impl Outward {
    /// Of some of the points whose normals these are; a point that has twins of the same place gets the mean of theirs.
    pub fn new(points: &[u32], twins: &[[u32; 2]], normals: &[DVec3]) -> Self {
        if normals.is_empty() {
            return Self(Vec::new());
        }
        let unit = |point: u32| normals[point as usize].normalize_or_zero();
        let mut sums: HashMap<u32, DVec3> = HashMap::new();
        for &[first, twin] in twins {
            *sums.entry(first).or_insert_with(|| unit(first)) += unit(twin);
        }
        let normal = |&point: &u32| sums.get(&point).map_or_else(|| unit(point), |sum| sum.normalize_or_zero());
        Self(points.iter().map(normal).collect())
    }

    /// That of a point, if it is known.
    pub fn normal(&self, point: u32) -> Option<DVec3> {
        self.0.get(point as usize).copied().filter(|&normal| normal != DVec3::ZERO)
    }

    /// Whether two points may be on the same side, as far as their normals tell.
    pub fn is_same_side(&self, one: u32, other: u32) -> bool {
        match (self.normal(one), self.normal(other)) {
            (Some(one), Some(other)) => one.dot(other) >= SAME_SIDE,
            _ => true,
        }
    }

    /// How far a triangle faces outward: its area vector along the normals of its points.
    pub fn along(&self, triangle: [u32; 3], positions: &[DVec3]) -> f64 {
        let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
        let normals = triangle.iter().filter_map(|&vertex| self.normal(vertex));
        (b - a).cross(c - a).dot(normals.sum())
    }
}
