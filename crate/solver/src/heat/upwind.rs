//! Distance along a field, from warmer vertices to cooler ones.
//!
//! Distance φ whose gradient is the field X grows along each edge e by X · e. Each vertex has the mean of what that makes of its warmer
//! neighbors' distances, upwind (Courant, Isaacson, Rees, "On the solution of nonlinear hyperbolic differential equations by finite
//! differences", 1952). So warmest first, each vertex follows from others, and nothing is solved. Least squares, `L φ = div X`, would
//! spread what the field errs by somewhere over all of the mesh.

use std::ops::Range;

use bytemuck::Zeroable;
use bytemuck::allocation::zeroed_vec;

use crate::extremum::{either, larger, smaller};
use crate::operator::Laplacian;

/// How many edges of a mesh end at each vertex.
#[derive(Debug, Clone)]
pub(super) struct Upwind {
    /// `#V + 1`, where the edges of each vertex begin, in a list of them from both their ends.
    start: Vec<u32>,
    /// The unit of lengths.
    unit: f64,
}

/// Stands for a distance that is not known: times no flow it is 0, and times the least one far above any sum of others, which are
/// measured in edges.
const UNKNOWN: f64 = f64::MAX;
const LEAST_UNKNOWN_SUM: f64 = 1e200;

/// At least so many inflows of a vertex are read: most have no more, and a loop that always ends at the same place is what the processor
/// guesses right.
const FEW: usize = 4;

/// What comes to each vertex along its edges from warmer ones, in one place, so that the pass, which goes to and fro over the mesh, reads
/// little of it.
pub(super) struct Inflows {
    /// `#V`, where those of each vertex end. They begin where its edges do.
    ends: Vec<u32>,
    /// Two for each edge, one of which counts.
    inflows: Vec<Inflow>,
}

/// What comes to a vertex along an edge.
#[derive(Clone, Copy, Zeroable)]
struct Inflow {
    /// The warmer end.
    from: u32,
    flow: f32,
    rise: f32,
    length: f64,
}

/// What goes on along an edge, from its lower vertex to its higher one.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct EdgeField {
    /// Heat that flows: its stiffness times the fall of the logarithm of heat, to any scale. It counts for so much.
    pub(super) flow: f32,
    /// What distance grows by, in the unit of lengths.
    pub(super) rise: f32,
    /// What distance grows by at most: the edge's length, in the unit of lengths.
    pub(super) length: f64,
}

impl Inflows {
    /// Adds the field of the edges from a vertex to higher ones, which are given with it.
    #[inline]
    pub(super) fn add(&mut self, low: u32, edges: impl Iterator<Item = (u32, EdgeField)>) {
        let mut own = self.ends[low as usize];
        for (high, EdgeField { flow, rise, length }) in edges {
            let end = &mut self.ends[high as usize];
            // Which end is warmer is as good as random, and a wrong guess of the processor would cost more than to write to both. What
            // does not count is overwritten by the next, or has no flow.
            self.inflows[own as usize] = Inflow { from: high, flow: (-flow).max(0.0), rise: -rise, length };
            self.inflows[*end as usize] = Inflow { from: low, flow: flow.max(0.0), rise, length };
            own += u32::from(flow < 0.0);
            *end += u32::from(flow > 0.0);
        }
        self.ends[low as usize] = own;
    }

    /// Those of a vertex that has these edges, and perhaps some without flow.
    fn of(&self, vertex: u32, Range { start, end }: Range<usize>) -> &[Inflow] {
        let few = (start + FEW).max(self.ends[vertex as usize] as usize);
        &self.inflows[start..few.min(end)]
    }
}

impl Upwind {
    /// Of the [edges](Laplacian::edges) of a stiffness matrix, in this unit of lengths.
    pub(super) fn new(laplacian: &Laplacian, unit: f64) -> Self {
        let vertices = laplacian.size();
        let mut start = vec![0_u32; vertices + 1];
        for ends in laplacian.edges().map(|(ends, _)| ends) {
            ends.into_iter().for_each(|end| start[end as usize + 1] += 1);
        }
        for vertex in 0..vertices {
            start[vertex + 1] += start[vertex];
        }
        Self { start, unit }
    }

    /// Without any yet.
    pub(super) fn inflows(&self) -> Inflows {
        let (vertices, count) = (self.start.len() - 1, self.start[self.start.len() - 1] as usize);
        Inflows { ends: self.start[..vertices].to_vec(), inflows: zeroed_vec(count) }
    }

    /// Distances (`#V`) by falling `heat` (`#V`, or its logarithm), none of them above a warmer neighbor's and the edge between, nor
    /// below `floor`, which is told the vertex and its distance else. Those below infinity in `known` (`#V`) stay; infinite where heat
    /// tells nothing.
    ///
    /// Means are of what is not bounded so: else they would change with the order of vertices as warm as each other.
    pub(super) fn distances(
        &self,
        inflows: &Inflows,
        heat: &[f64],
        known: &[f64],
        floor: impl Fn(u32, f64) -> f64,
    ) -> Vec<f64> {
        let inverse = 1.0 / self.unit;
        let mut distances: Vec<Pair> =
            known.iter().map(|&distance| [smaller(inverse * distance, UNKNOWN); 2]).collect();
        let unknown = (0..).zip(&distances).filter(|&(_, &[distance, _])| distance == UNKNOWN);
        let mut order: Vec<u64> = Vec::with_capacity(distances.len());
        order.extend(unknown.map(|(vertex, _)| warmest_first(heat[vertex as usize], vertex)));
        order.sort_unstable();
        for vertex in order.into_iter().map(|key| key as u32) {
            let own = inflows.of(vertex, self.edges_of(vertex));
            let [mut flow, mut sum, nearest] = total(own, &distances, |_| true);
            if sum > LEAST_UNKNOWN_SUM {
                [flow, sum, _] = total(own, &distances, |distance| distance < UNKNOWN);
            }
            if flow > 0.0 {
                let mean = smaller(sum / flow, UNKNOWN);
                let least = smaller(mean, nearest);
                distances[vertex as usize] = [mean, larger(inverse * floor(vertex, self.unit * least), least)];
            }
        }
        let in_file = |[_, distance]: Pair| distance * if distance < UNKNOWN { self.unit } else { f64::INFINITY };
        distances.into_iter().map(in_file).collect()
    }

    /// The places of a vertex's edges.
    fn edges_of(&self, vertex: u32) -> Range<usize> {
        self.start[vertex as usize] as usize..self.start[vertex as usize + 1] as usize
    }
}

/// The distance of a vertex by the mean of its inflows, and the same by no more than edges.
type Pair = [f64; 2];

/// The sum of flows from vertices whose distances count, that of what distance is by each of them, times its flow, and the least
/// that it is by an edge.
#[inline]
fn total(inflows: &[Inflow], distances: &[Pair], counts: impl Fn(f64) -> bool) -> [f64; 3] {
    let counted = inflows.iter().map(|inflow| (distances[inflow.from as usize], inflow));
    let none = [0.0, 0.0, UNKNOWN];
    counted.filter(|&([distance, _], _)| counts(distance)).fold(none, |[whole, sum, nearest], (pair, inflow)| {
        let [flow, rise] = [inflow.flow, inflow.rise].map(f64::from);
        let by_edge = either(flow > 0.0, pair[1] + inflow.length, UNKNOWN);
        [whole + flow, sum + flow * (pair[0] + rise), smaller(by_edge, nearest)]
    })
}

/// Orders vertices by falling heat, to 24 bits, and in its lower half is the vertex.
fn warmest_first(heat: f64, vertex: u32) -> u64 {
    let bits = (heat as f32).to_bits();
    // As integers, the bits of negative numbers order the other way round.
    let falling = if bits >> 31 == 0 { !bits & (u32::MAX >> 1) } else { bits };
    u64::from(falling) << 32 | u64::from(vertex)
}

#[cfg(test)]
mod tests {
    use heatwalk_sparse::SymmetricMatrix;

    use super::*;

    /// The edges 0–1, 1–2 and 2–3 of stiffness 1.
    fn path() -> Upwind {
        let mut entries = [(1, -1.0), (2, -1.0), (3, -1.0)];
        let stiffness = SymmetricMatrix::from_entries(&[1.0, 2.0, 2.0, 1.0], &[0, 1, 2, 3, 3], &mut entries);
        Upwind::new(&Laplacian { stiffness, mass: vec![1.0; 4] }, 0.5)
    }

    fn distances(field: [EdgeField; 3], heat: [f64; 4], known: &[f64]) -> Vec<f64> {
        let (path, mut inflows) = (path(), path().inflows());
        (0..).zip(field).for_each(|(low, field)| inflows.add(low, [(low + 1, field)].into_iter()));
        path.distances(&inflows, &heat, known, |_, _| 0.0)
    }

    fn known(first: f64) -> Vec<f64> {
        vec![first, f64::INFINITY, f64::INFINITY, f64::INFINITY]
    }

    #[test]
    fn distance_grows_from_the_warmest_to_the_coolest() {
        let field = [EdgeField { flow: 1.0, rise: 1.0, length: 1.0 }; 3];
        assert_eq!(distances(field, [3.0, 2.0, 1.0, 0.0], &known(5.0)), [5.0, 5.5, 6.0, 6.5]);
    }

    #[test]
    fn no_distance_grows_by_more_than_an_edge_from_any_warmer_neighbor() {
        let field = [
            EdgeField { flow: 1.0, rise: 3.0, length: 2.0 },
            EdgeField { flow: 3.0, rise: 4.0, length: 9.0 },
            EdgeField { flow: -1.0, rise: -9.0, length: 4.0 },
        ];
        let known = vec![0.0, f64::INFINITY, f64::INFINITY, 0.0];
        // 2 along the first edge, not 3. Then (3 · (2 + 4) + 1 · 9) / 4 = 6.75, but the last edge has a length of 4.
        assert_eq!(distances(field, [3.0, 2.0, 0.0, 1.0], &known), [0.0, 1.0, 2.0, 0.0]);
    }

    #[test]
    fn the_coolest_has_the_mean_of_both_sides_by_flow() {
        let field = [
            EdgeField { flow: 1.0, rise: 2.0, length: 4.0 },
            EdgeField { flow: 3.0, rise: 2.0, length: 4.0 },
            EdgeField { flow: -1.0, rise: -4.0, length: 4.0 },
        ];
        let known = vec![0.0, f64::INFINITY, f64::INFINITY, 0.0];
        // 1 along the first edge, then (3 · 2 + 1 · 2) / 4.
        assert_eq!(distances(field, [3.0, 2.0, 0.0, 1.0], &known), [0.0, 1.0, 2.0, 0.0]);
    }

    #[test]
    fn what_heat_does_not_tell_is_infinite() {
        let none = [EdgeField::default(); 3];
        assert_eq!(distances(none, [0.0; 4], &known(0.0)), known(0.0));
    }

    #[test]
    fn what_no_known_vertex_reaches_is_infinite() {
        let field = [EdgeField { flow: 1.0, rise: 1.0, length: 1.0 }; 3];
        let distances = distances(field, [3.0, 2.0, 1.0, 0.0], &known(f64::INFINITY));
        assert!(distances.iter().all(|distance| *distance == f64::INFINITY), "{distances:?}");
    }
}
