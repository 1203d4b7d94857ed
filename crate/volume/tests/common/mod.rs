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

/// Two of a mesh, apart.
pub fn two_of(mut soup: TetSoup) -> TetSoup {
    let count = soup.positions.len() as u32;
    let shifted: Vec<DVec3> = soup.positions.iter().map(|&position| position + 3.0 * DVec3::X).collect();
    soup.positions.extend(shifted);
    let renumbered: Vec<[u32; 4]> =
        soup.tetrahedra.iter().map(|corners| corners.map(|corner| corner + count)).collect();
    soup.tetrahedra.extend(renumbered);
    soup
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
