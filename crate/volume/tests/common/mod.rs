//! Exact distances, errors and random places, for tests of distance inside of meshes.
#![allow(dead_code, reason = "each test takes what it needs")]

pub mod riddled;

use std::f64::consts::TAU;

use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_volume::{TetMesh, TetSoup};

pub fn mesh(soup: &TetSoup) -> TetMesh {
    TetMesh::build(soup).unwrap()
}

/// The vertex nearest to a place.
pub fn nearest(mesh: &TetMesh, place: DVec3) -> VertexId {
    let far = |vertex: &usize| mesh.positions()[*vertex].distance_squared(place);
    VertexId((0..mesh.vertex_count()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap() as u32)
}

/// Mean and largest error relative to `truth`, where that is above 0.
pub fn errors(values: &[f64], truth: &[f64]) -> [f64; 2] {
    assert_eq!(values.len(), truth.len());
    let pairs = values.iter().zip(truth).filter(|&(_, &truth)| truth > 0.0);
    let errors: Vec<f64> = pairs.map(|(value, truth)| (value - truth).abs() / truth).collect();
    [errors.iter().sum::<f64>() / errors.len() as f64, errors.iter().copied().fold(0.0, f64::max)]
}

/// Distances of all vertices by a closed form.
pub fn truth(mesh: &TetMesh, from: DVec3, exact: impl Fn(DVec3, DVec3) -> f64) -> Vec<f64> {
    mesh.positions().iter().map(|&place| exact(from, place)).collect()
}

/// Around a cylinder along z, unrolled: tangents and an arc across, and straight along it.
pub fn around_cylinder(radius: f64) -> impl Fn(DVec3, DVec3) -> f64 {
    move |a, b| {
        let angle = (a.y.atan2(a.x) - b.y.atan2(b.x)).abs();
        let from_axis = [a, b].map(|place| place.truncate().length());
        around_circle(from_axis, angle.min(TAU - angle), radius).hypot(a.z - b.z)
    }
}

/// Around a sphere, in the plane of both places and its center.
pub fn around_sphere(radius: f64) -> impl Fn(DVec3, DVec3) -> f64 {
    move |a, b| around_circle([a.length(), b.length()], a.angle_between(b), radius)
}

fn around_circle([a, b]: [f64; 2], angle: f64, radius: f64) -> f64 {
    let free = |distance: f64| (radius / distance).min(1.0).acos();
    let arc = angle - free(a) - free(b);
    let tangent = |distance: f64| (distance * distance - radius * radius).max(0.0).sqrt();
    if arc > 0.0 {
        tangent(a) + tangent(b) + radius * arc
    } else {
        (a * a + b * b - 2.0 * a * b * angle.cos()).max(0.0).sqrt()
    }
}

/// Numbers that look random, the same on every machine: SplitMix64.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// From 0 to 1.
    pub fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.share() * count as f64) as usize).min(count - 1)
    }
}
