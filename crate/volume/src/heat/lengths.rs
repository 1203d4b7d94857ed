//! Lengths in a mesh, and the time that heat flows for.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use heatwalk::{FactorOptions, LinearSolver, TimeStep};

use crate::heat::field::Field;
use crate::march::Medium;
use crate::mesh::TetMesh;

/// Of the edges, all but this share are no long ones.
const LONG_EDGES: f64 = 0.01;

/// Where some edges are long, √t is at least this share of them, so that heat is not lost within one; but m is at most that of the
/// paper, 1.
const LONG_EDGE_SHARE: f64 = 0.45;

/// Heat falls by about one e-fold per √t of distance; √t is at least the extent over this, which the range of floats leaves room
/// for.
const EFOLDS: f64 = 1200.0;

/// The same for conjugate gradients, which leave noise at 10⁻¹² of the largest heat.
const ITERATED_EFOLDS: f64 = 27.0;

/// Lengths in a mesh, at the costs around.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lengths {
    pub(super) mean_edge: f64,
    /// All but a hundredth of the edges are no longer.
    long_edge: f64,
    /// An upper bound of the distance along edges.
    extent: f64,
}

impl Lengths {
    /// At the least cost around each edge.
    pub(super) fn of(mesh: &TetMesh, medium: &Medium) -> Self {
        let (mut edges, mut extent) = (Vec::new(), 0.0_f64);
        let mut distances = vec![f64::INFINITY; mesh.vertex_count()];
        let mut queue: BinaryHeap<Reverse<(u64, u32)>> = BinaryHeap::new();
        for first in 0..mesh.vertex_count() as u32 {
            if distances[first as usize].is_finite() {
                continue;
            }
            distances[first as usize] = 0.0;
            queue.push(Reverse((0, first)));
            while let Some(Reverse((bits, vertex))) = queue.pop() {
                let distance = f64::from_bits(bits);
                if distance > distances[vertex as usize] {
                    continue;
                }
                extent = extent.max(distance);
                for &other in mesh.adjacent().row(vertex) {
                    let edge = edge_cost(mesh, medium, [vertex, other]);
                    if edge.is_finite() && other > vertex {
                        edges.push(edge);
                    }
                    if distance + edge < distances[other as usize] {
                        distances[other as usize] = distance + edge;
                        queue.push(Reverse(((distance + edge).to_bits(), other)));
                    }
                }
            }
        }
        let mean_edge = edges.iter().sum::<f64>() / edges.len().max(1) as f64;
        let rank = ((1.0 - LONG_EDGES) * edges.len() as f64) as usize;
        let long_edge = if edges.is_empty() { 0.0 } else { *edges.select_nth_unstable_by(rank, f64::total_cmp).1 };
        // From the first vertex to any two others and back.
        Self { mean_edge, long_edge, extent: 2.0 * extent }
    }

    /// t = m h², but long enough for heat to reach everywhere.
    pub(super) fn time(self, options: FactorOptions, field: Field) -> f64 {
        let efolds = match (options.time_step, options.solver) {
            (TimeStep::Automatic, LinearSolver::ConjugateGradients) => ITERATED_EFOLDS,
            _ => EFOLDS,
        };
        let factor = match options.time_step {
            TimeStep::Automatic => {
                (LONG_EDGE_SHARE * self.long_edge / self.mean_edge).powi(2).clamp(field.time_factor(), 1.0)
            }
            TimeStep::Factor(factor) => factor,
        };
        (factor * self.mean_edge * self.mean_edge).max((self.extent / efolds).powi(2))
    }
}

/// The length of an edge at the least cost of the tetrahedra around it.
pub(super) fn edge_cost(mesh: &TetMesh, medium: &Medium, [a, b]: [u32; 2]) -> f64 {
    let least = || {
        let around = mesh.around().row(a).iter();
        let at_edge = around.filter(|&&tetrahedron| mesh.tetrahedra()[tetrahedron as usize].contains(&b));
        at_edge.map(|&tetrahedron| medium.cost(tetrahedron)).fold(f64::INFINITY, f64::min)
    };
    medium.uniform_cost().unwrap_or_else(least) * mesh.positions()[a as usize].distance(mesh.positions()[b as usize])
}
