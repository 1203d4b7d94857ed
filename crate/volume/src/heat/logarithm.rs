//! The field of the logarithm of heat, −√(t + c) ∇log u, no longer than 1, as what it adds along each edge, and distance along it.
//!
//! Distance is the limit of −√t log u for short times (Varadhan, "On the behavior of the fundamental solution of the heat
//! equation with variable coefficients", 1967). Heat falls exponentially, so that its logarithm is what is nearly linear in a
//! tetrahedron: it points along distance where the gradient of heat leans towards the warmest corner. A difference along an edge is
//! all that stiffness takes of a field, so that no tetrahedron is looked at, and costs are those of stiffness and mass.
//!
//! Distance φ grows along the field X as fast as X is long, `X · ∇φ = |X|²`. Stiffness makes of that a sum over edges for each vertex,
//! and of these only those to warmer vertices are taken, as upwind schemes do (Courant, Isaacson, Rees, "On the solution of nonlinear
//! hyperbolic differential equations by finite differences", 1952). So each vertex follows from warmer ones, and nothing is solved.
//! Least squares, `L φ = div X`, would spread what the field errs by somewhere over all of the mesh.

use std::f64::consts::PI;

use glam::DVec3;
use heatwalk::heat::WarmestFirst;
use heatwalk::operator::Laplacian;
use heatwalk_base::logarithm::ln;

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
    /// `#V`, what the logarithm of heat is too great by.
    reflected: Vec<f64>,
    /// `#V + 1`, where the edges of each vertex begin.
    start: Vec<u32>,
    edges: Vec<Edge>,
    /// The unit of lengths and weights, so that they are near 1.
    unit: f64,
}

/// An edge of a vertex.
#[derive(Debug, Clone, Copy, Default)]
struct Edge {
    other: u32,
    weight: f32,
    length: f32,
}

impl Logarithm {
    /// `costs` are those of the [edges](Laplacian::edges), `unit` is a usual length.
    pub(super) fn new(mesh: &TetMesh, medium: &Medium, laplacian: &Laplacian, costs: &[f64], unit: f64) -> Self {
        let vertices = laplacian.size();
        let mut start = vec![0_u32; vertices + 1];
        for end in laplacian.edges().flat_map(|(ends, _)| ends) {
            start[end as usize + 1] += 1;
        }
        for vertex in 0..vertices {
            start[vertex + 1] += start[vertex];
        }
        let mut next = start.clone();
        let mut both = vec![Edge::default(); start[vertices] as usize];
        for (([a, b], weight), &cost) in laplacian.edges().zip(costs) {
            for [own, other] in [[a, b], [b, a]] {
                let place = &mut next[own as usize];
                both[*place as usize] = Edge { other, weight: (weight / unit) as f32, length: (cost / unit) as f32 };
                *place += 1;
            }
        }
        let too_great = |angle: f64| if angle > 0.0 { REFLECTED * (4.0 * PI / angle).ln() } else { 0.0 };
        let reflected = solid_angles(mesh, medium).into_iter().map(too_great).collect();
        Self { reflected, start, edges: both, unit }
    }

    /// As [`HeatDiscretization::along_logarithm`](heatwalk::heat::HeatDiscretization::along_logarithm).
    pub(super) fn distances(&self, laplacian: &Laplacian, heat: &[f64], time: f64, known: Vec<f64>) -> Vec<f64> {
        // Stiffness of obtuse tetrahedra may let heat fall below 0, where its size still is that of the heat around.
        let logarithms: Vec<f64> = heat.iter().map(|heat| ln(heat.abs().max(f64::MIN_POSITIVE))).collect();
        let nodes = self.nodes(laplacian, &logarithms, time);
        let unknown = (0..).zip(&known).filter(|(_, distance)| distance.is_infinite());
        let order = WarmestFirst::new(&logarithms, unknown.map(|(vertex, _)| vertex));
        let mut distances = known;
        for vertex in order {
            let least = LEAST_INFLOW * laplacian.mass[vertex as usize] / (time * self.unit);
            if let Some(distance) = self.upwind(&nodes, &distances, vertex, least) {
                distances[vertex as usize] = distance;
            }
        }
        distances
    }

    /// The distance of a vertex by the warmer ones around whose distances are known; none where less than `least` heat comes from them,
    /// relative to the vertex's own.
    #[inline]
    fn upwind(&self, nodes: &[Node], distances: &[f64], vertex: u32, least: f64) -> Option<f64> {
        let own = nodes[vertex as usize];
        let (mut sum, mut weights) = (0.0, 0.0);
        for edge in self.edges(vertex) {
            let (node, distance) = (&nodes[edge.other as usize], distances[edge.other as usize]);
            if distance < f64::INFINITY {
                let increment = 0.5 * (own.rate + node.rate) * (node.value - own.value);
                let length = self.unit * f64::from(edge.length);
                let weight = f64::from(edge.weight.max(0.0)) * (node.heat - own.heat).max(0.0);
                sum += weight * (distance + increment.clamp(-length, length));
                weights += weight;
            }
        }
        (weights > least).then(|| sum / weights)
    }

    fn edges(&self, vertex: u32) -> &[Edge] {
        &self.edges[self.start[vertex as usize] as usize..self.start[vertex as usize + 1] as usize]
    }

    /// What the field is made of at each vertex.
    fn nodes(&self, laplacian: &Laplacian, logarithms: &[f64], time: f64) -> Vec<Node> {
        // Of Δ² and Δ⁴, with Δ the difference along an edge, the sums over the edges of each vertex times their weights.
        let mut sums = vec![[0.0; 2]; logarithms.len()];
        for (low, &value) in logarithms.iter().enumerate() {
            let mut own = sums[low];
            for (high, weight) in laplacian.edges_from(low) {
                let other = logarithms[high as usize];
                let square = (other - value) * (other - value);
                let [squares, quartics] = [weight * square, weight * square * square];
                own = [own[0] + squares, own[1] + quartics];
                let sums = &mut sums[high as usize];
                *sums = [sums[0] + squares, sums[1] + quartics];
            }
            sums[low] = own;
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
        let node = |(((&heat, &sums), &mass), &reflected): (((&f64, &[f64; 2]), &f64), &f64)| Node {
            heat,
            value: heat - reflected,
            rate: rate(sums, 2.0 * mass),
        };
        logarithms.iter().zip(&sums).zip(&laplacian.mass).zip(&self.reflected).map(node).collect()
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
