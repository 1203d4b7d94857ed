//! The field of the logarithm of heat, −√(t + c) ∇log u, no longer than 1, as what it adds along each edge, and distance along it.
//!
//! Distance is the limit of −√t log u for short times (Varadhan, "On the behavior of the fundamental solution of the heat
//! equation with variable coefficients", 1967). Heat falls exponentially, so that its logarithm is what is nearly linear in a
//! tetrahedron: it points along distance where the gradient of heat leans towards the warmest corner. A difference along an edge is
//! all that stiffness takes of a field, so that no tetrahedron is looked at, and costs are those of stiffness and mass.
//!
//! Distance follows the field from warmer vertices to cooler ones ([`Upwind`]), along edges of positive stiffness.

use std::f64::consts::PI;

use glam::DVec3;
use heatwalk::heat::{EdgeField, Upwind};
use heatwalk::operator::Laplacian;

use crate::heat::lengths::edge_cost;
use crate::march::Medium;
use crate::mesh::{FACES, TetId, TetMesh};

/// A slower fall than this is none of distance, and the field has this length there.
const LEAST_LENGTH: f64 = 0.7;

/// At no vertex is a unit of the logarithm more than so many √t of distance.
const MOST_RATE: f64 = 3.0;

/// Where heat comes head-on to a vertex that sees a solid angle Ω of 4π, it is 4π / Ω times that of the wave alone, as none leaves
/// through the boundary, and its logarithm is greater by that of 4π / Ω. Along the boundary it is not; this share of it is taken off.
const REFLECTED: f64 = 0.4;

/// Of the heat that a vertex takes in, at least this share comes by edges of positive weight from warmer vertices. Where less does,
/// obtuse tetrahedra have let heat through against its fall, and it tells nothing of distance.
const LEAST_INFLOW: f64 = 0.1;

/// What distance along the field needs of a mesh.
#[derive(Debug)]
pub(super) struct Logarithm {
    upwind: Upwind,
    /// `#V`, what the logarithm of heat is too great by.
    reflected: Vec<f64>,
    /// The unit of lengths and weights, so that they are near 1.
    unit: f64,
}

impl Logarithm {
    /// At the least cost around each edge; `unit` is a usual length.
    pub(super) fn new(mesh: &TetMesh, medium: &Medium, laplacian: &Laplacian, unit: f64) -> Self {
        let length = |(ends, _)| (edge_cost(mesh, medium, ends) / unit) as f32;
        let upwind = Upwind::new(laplacian, unit, laplacian.edges().map(length).collect());
        let too_great = |angle: f64| if angle > 0.0 { REFLECTED * (4.0 * PI / angle).ln() } else { 0.0 };
        let reflected = solid_angles(mesh, medium).into_iter().map(too_great).collect();
        Self { upwind, reflected, unit }
    }

    /// Distances (`#V`) along the field of `heat` (`#V`) that has flowed for this time, in the unit of the lengths, squared. Those below
    /// infinity in `known` (`#V`) stay; infinite where no edges lead to one of them.
    pub(super) fn distances(&self, laplacian: &Laplacian, heat: &[f64], time: f64, known: Vec<f64>) -> Vec<f64> {
        let nodes = self.nodes(laplacian, heat, time);
        let along = |(([low, high], weight), &length): (([u32; 2], f64), &f32)| {
            let [low, high] = [low, high].map(|end| nodes[end as usize]);
            let rise = 0.5 * (low.rate + high.rate) * (low.value - high.value) / self.unit;
            EdgeField {
                flow: (weight.max(0.0) / self.unit * (low.heat - high.heat)) as f32,
                rise: (rise as f32).clamp(-length, length),
            }
        };
        let field: Vec<EdgeField> = laplacian.edges().zip(self.upwind.lengths()).map(along).collect();
        let logarithms: Vec<f64> = nodes.iter().map(|node| node.heat).collect();
        let least_flow = |vertex: u32| LEAST_INFLOW * laplacian.mass[vertex as usize] / (time * self.unit);
        self.upwind.distances(&field, &logarithms, known, |vertex| least_flow(vertex) as f32)
    }

    /// What the field is made of at each vertex.
    fn nodes(&self, laplacian: &Laplacian, heat: &[f64], time: f64) -> Vec<Node> {
        // Of Δ² and Δ⁴, with Δ the difference along an edge, the sums over the edges of each vertex times their weights. Stiffness of obtuse
        // tetrahedra may let heat fall below 0, where its size still is that of the heat around.
        let value = |heat: &f64| heat.abs().max(f64::MIN_POSITIVE).ln();
        let mut sums: Vec<(f64, [f64; 2])> = heat.iter().map(|heat| (value(heat), [0.0; 2])).collect();
        for (ends, weight) in laplacian.edges() {
            let [low, high] = ends.map(|end| sums[end as usize].0);
            let square = (low - high) * (low - high);
            let [squares, quartics] = [weight * square, weight * square * square];
            for end in ends {
                let sums = &mut sums[end as usize].1;
                *sums = [sums[0] + squares, sums[1] + quartics];
            }
        }
        let least = 1.0 / (MOST_RATE * MOST_RATE * time);
        let rate = |[squares, quartics]: [f64; 2], mass: f64| {
            if squares < least * mass {
                return time.sqrt();
            }
            // The sum of squares is 2 M k² for e^(−k·x). It solves `(M / t + L) u = 0` on alike tetrahedra where
            // M / t = Σ w (cosh Δ − 1): k² is less than 1 / t by a 24th of the sum of fourth powers over M, which c makes up for.
            let square = time * squares / mass + quartics / (12.0 * squares);
            (square.clamp(LEAST_LENGTH * LEAST_LENGTH, 1.0) * mass / squares).sqrt()
        };
        let node = |((&(heat, sums), &mass), &reflected): ((&(f64, [f64; 2]), &f64), &f64)| Node {
            heat,
            value: heat - reflected,
            rate: rate(sums, 2.0 * mass),
        };
        sums.iter().zip(&laplacian.mass).zip(&self.reflected).map(node).collect()
    }
}

/// The solid angle (`#V`) of the tetrahedra around each vertex that are no walls.
fn solid_angles(mesh: &TetMesh, medium: &Medium) -> Vec<f64> {
    let mut angles = vec![0.0; mesh.vertex_count()];
    for (tetrahedron, corners) in (0..).zip(mesh.tetrahedra()) {
        if medium.cost(tetrahedron).is_finite() {
            let places = mesh.corners(TetId(tetrahedron));
            for (corner, &vertex) in corners.iter().enumerate() {
                let others = FACES[corner].map(|other| places[other] - places[corner]);
                angles[vertex as usize] += solid_angle(others);
            }
        }
    }
    angles
}

/// Of three directions (Van Oosterom and Strackee 1983).
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let [long_a, long_b, long_c] = [a, b, c].map(DVec3::length);
    let whole = long_a * long_b * long_c + a.dot(b) * long_c + b.dot(c) * long_a + c.dot(a) * long_b;
    2.0 * a.dot(b.cross(c)).abs().atan2(whole)
}

/// What the field is made of at a vertex.
#[derive(Clone, Copy)]
struct Node {
    /// The logarithm of heat.
    heat: f64,
    /// The same without what is thrown back.
    value: f64,
    /// How much distance a unit of the logarithm is, so that the field around is as long as it should be.
    rate: f64,
}
