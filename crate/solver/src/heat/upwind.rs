//! Distance along a field, from warmer vertices to cooler ones.
//!
//! Distance φ whose gradient is the field X grows along each edge e by X · e. Each vertex has the mean of what that makes of its warmer
//! neighbors' distances, upwind (Courant, Isaacson, Rees, "On the solution of nonlinear hyperbolic differential equations by finite
//! differences", 1952). So warmest first, each vertex follows from others, and nothing is solved. Least squares, `L φ = div X`, would
//! spread what the field errs by somewhere over all of the mesh.

use crate::extremum::smaller;
use crate::operator::Laplacian;

/// The edges of a mesh, from each of their ends.
#[derive(Debug, Clone)]
pub(super) struct Upwind {
    /// `#V + 1`, where the spokes of each vertex begin.
    start: Vec<u32>,
    spokes: Vec<Spoke>,
    /// `#E`, in the unit.
    lengths: Vec<f32>,
    /// The unit of lengths.
    unit: f64,
}

/// An edge of a vertex.
#[derive(Debug, Clone, Copy, Default)]
struct Spoke {
    other: u32,
    edge: u32,
}

/// Stands for a distance that is not known: times no flow it is 0, and times the least one far above any sum of others, which are
/// measured in edges.
const UNKNOWN: f64 = f64::MAX;
const LEAST_UNKNOWN_SUM: f64 = 1e200;

/// What comes to a vertex from warmer ones.
#[derive(Clone, Copy)]
struct Inflow {
    flow: f64,
    /// Of what their distances and edges make of its distance, times flow.
    sum: f64,
}

/// What goes on along an edge, from its lower vertex to its higher one.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct EdgeField {
    /// Heat that flows: its stiffness times the fall of the logarithm of heat, to any scale. It counts for so much.
    pub(super) flow: f32,
    /// What distance grows by, in the unit of lengths.
    pub(super) rise: f32,
}

impl Upwind {
    /// Of the [edges](Laplacian::edges) of a stiffness matrix, which have these lengths (`#E`) in this unit.
    pub(super) fn new(laplacian: &Laplacian, unit: f64, lengths: Vec<f32>) -> Self {
        let vertices = laplacian.size();
        let mut start = vec![0_u32; vertices + 1];
        for ends in laplacian.edges().map(|(ends, _)| ends) {
            ends.into_iter().for_each(|end| start[end as usize + 1] += 1);
        }
        for vertex in 0..vertices {
            start[vertex + 1] += start[vertex];
        }
        let mut next = start.clone();
        let mut spokes = vec![Spoke::default(); start[vertices] as usize];
        for (edge, [a, b]) in (0..).zip(laplacian.edges().map(|(ends, _)| ends)) {
            for [own, other] in [[a, b], [b, a]] {
                let place = &mut next[own as usize];
                spokes[*place as usize] = Spoke { other, edge };
                *place += 1;
            }
        }
        Self { start, spokes, lengths, unit }
    }

    /// Lengths of the edges (`#E`), in the unit.
    pub(super) fn lengths(&self) -> &[f32] {
        &self.lengths
    }

    /// Distances (`#V`) along a field (`#E`), by falling `heat` (`#V`, or its logarithm). Those below infinity in `known` (`#V`) stay;
    /// infinite where no edges lead to one of them.
    pub(super) fn distances(&self, field: &[EdgeField], heat: &[f64], known: Vec<f64>) -> Vec<f64> {
        let (mut distances, inverse) = (known, 1.0 / self.unit);
        distances.iter_mut().for_each(|distance| *distance = smaller(inverse * *distance, UNKNOWN));
        let unknown = (0..).zip(&distances).filter(|&(_, &distance)| distance == UNKNOWN);
        let mut order: Vec<u64> = unknown.map(|(vertex, _)| warmest_first(heat[vertex as usize], vertex)).collect();
        order.sort_unstable();
        let mut left: Vec<u32> = Vec::new();
        for vertex in order.into_iter().map(|key| key as u32) {
            let mut inflow = self.inflow(vertex, field, &distances, |_| true);
            if inflow.sum > LEAST_UNKNOWN_SUM {
                inflow = self.inflow(vertex, field, &distances, |distance| distance < UNKNOWN);
            }
            if inflow.flow > 0.0 {
                distances[vertex as usize] = inflow.sum / inflow.flow;
            } else {
                left.push(vertex);
            }
        }
        self.complete(left, &mut distances);
        distances
            .iter_mut()
            .for_each(|distance| *distance *= if *distance < UNKNOWN { self.unit } else { f64::INFINITY });
        distances
    }

    /// What comes to a vertex from those around whose distances count.
    #[inline]
    fn inflow(&self, vertex: u32, field: &[EdgeField], distances: &[f64], counts: impl Fn(f64) -> bool) -> Inflow {
        let mut inflow = Inflow { flow: 0.0, sum: 0.0 };
        for &Spoke { other, edge } in self.spokes(vertex) {
            let (distance, EdgeField { flow, rise }) = (distances[other as usize], field[edge as usize]);
            if !counts(distance) {
                continue;
            }
            // Which vertices are warmer is as good as random, and a wrong guess of the processor would cost more than this.
            let sign = if other < vertex { 1.0 } else { -1.0 };
            let flow = f64::from((sign * flow).max(0.0));
            inflow.sum += flow * (distance + f64::from(sign * rise));
            inflow.flow += flow;
        }
        inflow
    }

    /// What heat does not tell is no farther than along the edges.
    fn complete(&self, mut left: Vec<u32>, distances: &mut [f64]) {
        loop {
            let before = left.len();
            left.retain(|&vertex| {
                let through =
                    |&Spoke { other, edge }: &Spoke| distances[other as usize] + f64::from(self.lengths[edge as usize]);
                let least = self.spokes(vertex).iter().map(through).fold(UNKNOWN, f64::min);
                distances[vertex as usize] = least;
                least == UNKNOWN
            });
            if left.is_empty() || left.len() == before {
                return;
            }
        }
    }

    fn spokes(&self, vertex: u32) -> &[Spoke] {
        &self.spokes[self.start[vertex as usize] as usize..self.start[vertex as usize + 1] as usize]
    }
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

    /// The edges 0–1, 1–2 and 2–3 of stiffness 1, two units long.
    fn path() -> Upwind {
        let mut entries = [(1, -1.0), (2, -1.0), (3, -1.0)];
        let stiffness = SymmetricMatrix::from_entries(&[1.0, 2.0, 2.0, 1.0], &[0, 1, 2, 3, 3], &mut entries);
        Upwind::new(&Laplacian { stiffness, mass: vec![1.0; 4] }, 0.5, vec![2.0; 3])
    }

    fn known(first: f64) -> Vec<f64> {
        vec![first, f64::INFINITY, f64::INFINITY, f64::INFINITY]
    }

    #[test]
    fn distance_grows_from_the_warmest_to_the_coolest() {
        let field = [EdgeField { flow: 1.0, rise: 1.0 }; 3];
        assert_eq!(path().distances(&field, &[3.0, 2.0, 1.0, 0.0], known(5.0)), [5.0, 5.5, 6.0, 6.5]);
    }

    #[test]
    fn the_coolest_has_the_mean_of_both_sides_by_flow() {
        let field = [
            EdgeField { flow: 1.0, rise: 2.0 },
            EdgeField { flow: 3.0, rise: 2.0 },
            EdgeField { flow: -1.0, rise: -4.0 },
        ];
        let known = vec![0.0, f64::INFINITY, f64::INFINITY, 0.0];
        // 1 along the first edge, then (3 · 2 + 1 · 2) / 4.
        assert_eq!(path().distances(&field, &[3.0, 2.0, 0.0, 1.0], known), [0.0, 1.0, 2.0, 0.0]);
    }

    #[test]
    fn what_heat_does_not_tell_is_as_far_as_along_edges() {
        let none = [EdgeField::default(); 3];
        assert_eq!(path().distances(&none, &[0.0; 4], known(0.0)), [0.0, 1.0, 2.0, 3.0]);
    }

    #[test]
    fn what_no_known_vertex_reaches_is_infinite() {
        let field = [EdgeField { flow: 1.0, rise: 1.0 }; 3];
        let distances = path().distances(&field, &[3.0, 2.0, 1.0, 0.0], known(f64::INFINITY));
        assert!(distances.iter().all(|distance| *distance == f64::INFINITY), "{distances:?}");
    }
}
