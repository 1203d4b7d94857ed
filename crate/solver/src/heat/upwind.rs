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
}

/// What goes on along an edge, from its lower vertex to its higher one.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct EdgeField {
    /// Heat that flows: its stiffness times the fall of the logarithm of heat, to any scale. It counts for so much.
    pub(super) flow: f32,
    /// What distance grows by, in the unit of lengths.
    pub(super) rise: f32,
}

impl Inflows {
    /// Adds the field of the edges from a vertex to higher ones, which are given with it.
    #[inline]
    pub(super) fn add(&mut self, low: u32, edges: impl Iterator<Item = (u32, EdgeField)>) {
        for (high, EdgeField { flow, rise }) in edges {
            // Which end is warmer is as good as random, so that nothing branches on it: a wrong guess of the processor would cost more.
            let is_low_cooler = flow < 0.0;
            let cooler = select_unpredictable(is_low_cooler, low, high);
            let end = &mut self.ends[cooler as usize];
            let turned = f32::from_bits(rise.to_bits() ^ u32::from(is_low_cooler) << 31);
            let inflow = Inflow { from: low ^ high ^ cooler, flow: flow.abs(), rise: turned };
            // What has no flow is overwritten by the next.
            self.inflows[*end as usize] = inflow;
            *end += u32::from(flow != 0.0);
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
        let mut order: Vec<u64> = Vec::with_capacity(distances.len());
        order.extend(unknown.map(|(vertex, _)| warmest_first(heat[vertex as usize], vertex)));
        sort_by_upper_half(&mut order);
        for vertex in order.into_iter().map(|key| key as u32) {
            let own = inflows.of(vertex, self.edges_of(vertex));
            let [mut flow, mut sum] = total(own, &distances, |_| true);
            if sum > LEAST_UNKNOWN_SUM {
                [flow, sum] = total(own, &distances, |distance| distance < UNKNOWN);
            }
            if flow > 0.0 {
                distances[vertex as usize] = smaller(sum / flow, UNKNOWN);
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

/// The sum of flows from vertices whose distances count, and that of what distance is by each of them, times its flow.
#[inline]
fn total(inflows: &[Inflow], distances: &[f64], counts: impl Fn(f64) -> bool) -> [f64; 2] {
    let counted = inflows.iter().map(|&Inflow { from, flow, rise }| (distances[from as usize], flow, rise));
    counted.filter(|&(distance, ..)| counts(distance)).fold([0.0; 2], |[whole, sum], (distance, flow, rise)| {
        let flow = f64::from(flow);
        [whole + flow, sum + flow * (distance + f64::from(rise))]
    })
}

const DIGIT_BITS: usize = 11;

/// Sorts by the upper half alone, least digits first, so that what is equal there stays as it was.
fn sort_by_upper_half(keys: &mut Vec<u64>) {
    let mut sorted = vec![0; keys.len()];
    for shift in (u32::BITS..u64::BITS).step_by(DIGIT_BITS) {
        let digit = |key: u64| (key >> shift) as usize & ((1 << DIGIT_BITS) - 1);
        let mut places = [0_u32; 1 << DIGIT_BITS];
        keys.iter().for_each(|&key| places[digit(key)] += 1);
        let mut before = 0;
        for place in &mut places {
            before += std::mem::replace(place, before);
        }
        for &key in &*keys {
            let place = &mut places[digit(key)];
            sorted[*place as usize] = key;
            *place += 1;
        }
        std::mem::swap(keys, &mut sorted);
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

    fn known(first: f64) -> Vec<f64> {
        vec![first, f64::INFINITY, f64::INFINITY, f64::INFINITY]
    }

    #[test]
    fn distance_grows_from_the_warmest_to_the_coolest() {
        let field = [EdgeField { flow: 1.0, rise: 1.0 }; 3];
        assert_eq!(distances(field, [3.0, 2.0, 1.0, 0.0], known(5.0)), [5.0, 5.5, 6.0, 6.5]);
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
        assert_eq!(distances(field, [3.0, 2.0, 0.0, 1.0], known), [0.0, 1.0, 2.0, 0.0]);
    }

    #[test]
    fn keys_are_sorted_by_their_upper_half_and_keep_their_order_where_it_is_equal() {
        let scattered = |index: u64| index.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut keys: Vec<u64> = (0..1000).map(|index| scattered(index % 700) >> 32 << 32 | (1000 - index)).collect();
        let mut expected = keys.clone();
        expected.sort_by_key(|key| key >> 32);
        sort_by_upper_half(&mut keys);
        assert_eq!(keys, expected);
    }

    #[test]
    fn what_heat_does_not_tell_is_infinite() {
        let none = [EdgeField::default(); 3];
        assert_eq!(distances(none, [0.0; 4], known(0.0)), known(0.0));
    }

    #[test]
    fn what_no_known_vertex_reaches_is_infinite() {
        let field = [EdgeField { flow: 1.0, rise: 1.0 }; 3];
        let distances = distances(field, [3.0, 2.0, 1.0, 0.0], known(f64::INFINITY));
        assert!(distances.iter().all(|distance| *distance == f64::INFINITY), "{distances:?}");
    }
}
