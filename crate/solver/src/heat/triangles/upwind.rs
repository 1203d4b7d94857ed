//! Distance along a field, from warmer vertices to cooler ones.
//!
//! Distance φ whose gradient is the field X grows along each edge e by X · e. Each vertex has the mean of what that makes of its warmer
//! neighbors' distances, upwind (Courant, Isaacson, Rees, "On the solution of nonlinear hyperbolic differential equations by finite
//! differences", 1952). So warmest first, each vertex follows from others, and nothing is solved. Least squares, `L φ = div X`, would
//! spread what the field errs by somewhere over all of the mesh.

use std::hint::select_unpredictable;
use std::ops::Range;

use bytemuck::Zeroable;
use bytemuck::allocation::zeroed_vec;

use crate::extremum::smaller;
use crate::heat::order::WarmestFirst;
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

/// What comes to a vertex along an edge, in as few bytes as may be: the pass waits for them.
#[derive(Clone, Copy, Zeroable)]
struct Inflow {
    /// The warmer end.
    from: u32,
    flow: f32,
    /// Its bits turned over: where all are 0, it is far.
    length: u16,
    /// What distance grows by, [`WHOLE`] for the length.
    rise: u16,
}

/// The most that distance may grow by along an edge: its length.
pub(super) const WHOLE: f32 = u16::MAX as f32;
const WHOLE_INVERSE: f64 = 1.0 / WHOLE as f64;

/// The length of an edge in half precision, rounded down by a thousandth at most: from 1/64 of the unit, below which it is as
/// precise as there, to sixteen million units.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Length(u16);

impl Length {
    /// How many bits of a number in single precision it has not.
    const BITS_LESS: u32 = 13;
    /// Takes the range of its exponents to the least of single precision.
    const SHIFT: f32 = f32::from_bits((127 - 120) << 23);

    pub(super) fn at_most(length: f64) -> Self {
        let bits = (length as f32).next_down().clamp(0.0, 1e7) * Self::SHIFT;
        Self((bits.to_bits() >> Self::BITS_LESS) as u16)
    }

    #[inline]
    pub(super) fn get(self) -> f32 {
        f32::from_bits(u32::from(self.0) << Self::BITS_LESS) * Self::SHIFT.recip()
    }
}

/// What goes on along an edge, from its lower vertex to its higher one.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct EdgeField {
    /// Heat that flows: its stiffness times the fall of the logarithm of heat, to any scale. It counts for so much.
    pub(super) flow: f32,
    /// What distance grows by, [`WHOLE`] for the length; of the sign of the flow.
    pub(super) rise: f32,
    /// In the unit of lengths. Distance grows by no more.
    pub(super) length: Length,
}

impl Inflows {
    /// Adds the field of the edges from a vertex to higher ones, which are given with it.
    #[inline]
    pub(super) fn add(&mut self, low: u32, edges: impl Iterator<Item = (u32, EdgeField)>) {
        for (high, EdgeField { flow, rise, length }) in edges {
            // Which end is warmer is as good as random, so that nothing branches on it: a wrong guess of the processor would cost more.
            let is_low_cooler = flow < 0.0;
            let cooler = select_unpredictable(is_low_cooler, low, high);
            let end = &mut self.ends[cooler as usize];
            // What has no flow is overwritten by the next.
            let flows = u16::from(flow != 0.0);
            self.inflows[*end as usize] = Inflow {
                from: low ^ high ^ cooler,
                flow: flow.abs(),
                length: flows * !length.0,
                rise: (rise.abs() + 0.5) as u16,
            };
            *end += u32::from(flows);
        }
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

    /// Distances (`#V`) by falling `heat` (`#V`, or its logarithm). Those below infinity in `known` (`#V`) stay; infinite where heat tells
    /// nothing.
    pub(super) fn distances(&self, inflows: &Inflows, heat: &[f64], known: Vec<f64>) -> Vec<f64> {
        let (mut distances, inverse) = (known, 1.0 / self.unit);
        distances.iter_mut().for_each(|distance| *distance = smaller(inverse * *distance, UNKNOWN));
        let unknown = (0..).zip(&distances).filter(|&(_, &distance)| distance == UNKNOWN);
        for vertex in WarmestFirst::new(heat, unknown.map(|(vertex, _)| vertex)) {
            let own = inflows.of(vertex, self.edges_of(vertex));
            let [mut flow, mut sum, mut most] = total(own, &distances, |_| true);
            if sum > LEAST_UNKNOWN_SUM {
                [flow, sum, most] = total(own, &distances, |distance| distance < UNKNOWN);
            }
            if flow > 0.0 {
                distances[vertex as usize] = smaller(sum / flow, most);
            }
        }
        distances
            .iter_mut()
            .for_each(|distance| *distance *= if *distance < UNKNOWN { self.unit } else { f64::INFINITY });
        distances
    }

    /// The places of a vertex's edges.
    fn edges_of(&self, vertex: u32) -> Range<usize> {
        self.start[vertex as usize] as usize..self.start[vertex as usize + 1] as usize
    }
}

/// The sum of flows from vertices whose distances count, that of what distance is by each of them, times its flow, and the least that it
/// is by any of them and the length of the edge.
#[inline]
fn total(inflows: &[Inflow], distances: &[f64], counts: impl Fn(f64) -> bool) -> [f64; 3] {
    let counted = inflows.iter().map(|inflow| (distances[inflow.from as usize], inflow));
    let none = [0.0, 0.0, UNKNOWN];
    counted.filter(|&(distance, _)| counts(distance)).fold(none, |[whole, sum, most], (distance, inflow)| {
        let (flow, length) = (f64::from(inflow.flow), f64::from(Length(!inflow.length).get()));
        let rise = length * (f64::from(inflow.rise) * WHOLE_INVERSE);
        [whole + flow, sum + flow * (distance + rise), smaller(most, distance + length)]
    })
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

    fn distances(field: [EdgeField; 3], heat: [f64; 4], known: Vec<f64>) -> Vec<f64> {
        let (path, mut inflows) = (path(), path().inflows());
        (0..).zip(field).for_each(|(low, field)| inflows.add(low, [(low + 1, field)].into_iter()));
        path.distances(&inflows, &heat, known)
    }

    /// Each of three edges of a length of 15, in the unit of ½, is rounded to half a step at most.
    const ROUNDING: f64 = 3.0 * 0.5 * 0.5 * 15.0 * WHOLE_INVERSE;

    /// Of an edge of a length of 15.
    fn field(flow: f32, rise: f32) -> EdgeField {
        EdgeField { flow, rise: WHOLE / Length::at_most(15.0).get() * rise, length: Length::at_most(15.0) }
    }

    fn check(distances: &[f64], expected: [f64; 4]) {
        let is_near = |(a, b): (&f64, f64)| (a - b).abs() < ROUNDING;
        assert!(distances.iter().zip(expected).all(is_near), "{distances:?} for {expected:?}");
    }

    fn known(first: f64) -> Vec<f64> {
        vec![first, f64::INFINITY, f64::INFINITY, f64::INFINITY]
    }

    #[test]
    fn distance_grows_from_the_warmest_to_the_coolest() {
        check(&distances([field(1.0, 1.0); 3], [3.0, 2.0, 1.0, 0.0], known(5.0)), [5.0, 5.5, 6.0, 6.5]);
    }

    #[test]
    fn the_coolest_has_the_mean_of_both_sides_by_flow() {
        let field = [field(1.0, 2.0), field(3.0, 2.0), field(-1.0, -4.0)];
        let known = vec![0.0, f64::INFINITY, f64::INFINITY, 0.0];
        // 1 along the first edge, then (3 · 2 + 1 · 2) / 4.
        check(&distances(field, [3.0, 2.0, 0.0, 1.0], known), [0.0, 1.0, 2.0, 0.0]);
    }

    #[test]
    fn distance_grows_by_no_more_than_any_of_the_edges() {
        let length = Length::at_most(4.0);
        let edge = |flow: f32| EdgeField { flow, rise: WHOLE * flow, length };
        let field = [edge(1.0), edge(1.0), edge(-1.0)];
        let length = f64::from(length.get());
        let known = vec![0.0, f64::INFINITY, f64::INFINITY, 9.0];
        // By the mean, half of 4 + 2 and 9 + 2.
        check(&distances(field, [3.0, 2.0, 0.0, 1.0], known), [0.0, length / 2.0, length, 9.0]);
    }

    #[test]
    fn lengths_are_rounded_down_by_little() {
        for length in [1e-9, 1e-3, 0.02, 0.3, 1.0, 1.5, 40.0, 1e6] {
            let rounded = f64::from(Length::at_most(length).get());
            assert!(rounded < length && rounded >= length - length.max(1.0 / 64.0) / 1000.0, "{rounded} for {length}");
        }
    }

    #[test]
    fn what_heat_does_not_tell_is_infinite() {
        let none = [EdgeField::default(); 3];
        assert_eq!(distances(none, [0.0; 4], known(0.0)), known(0.0));
    }

    #[test]
    fn what_no_known_vertex_reaches_is_infinite() {
        let field = [field(1.0, 1.0); 3];
        let distances = distances(field, [3.0, 2.0, 1.0, 0.0], known(f64::INFINITY));
        assert!(distances.iter().all(|distance| *distance == f64::INFINITY), "{distances:?}");
    }
}
