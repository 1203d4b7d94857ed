//! Lengths in a mesh, and the time that suits them.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use heatwalk::heat::{Field, long_edge_factor};

use crate::march::Medium;
use crate::mesh::TetMesh;

/// Where some edges are long, √t is at least this share of them, so that heat is not lost within one; but m is at most that of the
/// paper, 1.
const LONG_EDGE_SHARE: f64 = 0.45;

/// Lengths in a mesh, at the costs around.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lengths {
    pub(super) mean_edge: f64,
    /// The m with which √t is that share of long edges.
    long_edge_factor: f64,
    /// An upper bound of the distance along edges.
    pub(super) extent: f64,
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
        let long_edge_factor = long_edge_factor(edges, mean_edge, LONG_EDGE_SHARE);
        // From the first vertex to any two others and back.
        Self { mean_edge, long_edge_factor, extent: 2.0 * extent }
    }

    /// m in t = m h² for a field. Its least, where edges are even, is by errors measured on cubes, balls and tubes.
    pub(super) fn time_factor(self, field: Field) -> f64 {
        let even = match field {
            Field::Unit => 0.5,
            Field::Logarithm => 0.6,
        };
        self.long_edge_factor.clamp(even, 1.0)
    }
}

/// The length of an edge at the least cost of the tetrahedra around it.
pub(super) fn edge_cost(mesh: &TetMesh, medium: &Medium, [a, b]: [u32; 2]) -> f64 {
    let least = || mesh.around_edge([a, b]).map(|tetrahedron| medium.cost(tetrahedron)).fold(f64::INFINITY, f64::min);
    medium.uniform_cost().unwrap_or_else(least) * mesh.positions()[a as usize].distance(mesh.positions()[b as usize])
}
