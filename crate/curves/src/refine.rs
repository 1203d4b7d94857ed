//! A field divided where its isolines are, until these are true to the distance itself.
//!
//! Distance from sources is not linear on a triangle: an isoline that is found by its corners alone is a chord. Where the distance of
//! any place can be asked for, triangles that isolines cross are divided at the middles of their edges, as long as distances there
//! differ from the mean of the ends by more than the isoline may be off. Neighbors share these middles, so that nothing comes apart
//! (R. E. Bank, A. H. Sherman and A. Weiser, "Some refinement algorithms and data structures for regular local mesh refinement",
//! 1983).

use std::collections::HashMap;
use std::f64::consts::TAU;

use glam::DVec3;
use heatwalk_base::sort;
use heatwalk_surface::triangle;

use crate::field::{Field, longest};
use crate::levels::Levels;

/// By how much an isoline's length may be off, as a share of it: an estimate from distances that were asked for, and no bound.
pub const TRUE_TO: f64 = 1e-3;

/// Divisions one after another, at most: of edges as long as the model, a millionth is left.
pub const MOST_ROUNDS: usize = 20;

/// Places that are asked for, at most: a limit in time would give other isolines each time.
const MOST_PLACES: usize = 1 << 18;

/// Edges of which the middles tell whether a line is the source.
const ENOUGH: usize = 256;

/// Distances grow by less than this share of their usual slope where paths from two sides meet in a triangle, at an angle that matters.
const RIDGE: f64 = 0.95;

/// Circles around corners that paths bend at are sharper than those around the source: by no more than this, but for what is so
/// small that it does not matter.
const SHARPER: f64 = 10.0;

/// Isolines of which nothing is found yet are not looked for where they would be nearer to a corner than this share of the largest
/// distance.
const UNSEEN: f64 = 1e-6;

/// Places in triangles of a field, by their weights at the corners.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Places {
    /// `#P`, triangles.
    pub triangles: Vec<u32>,
    /// `#P × 3`, adding up to 1.
    pub weights: Vec<[f64; 3]>,
}

/// A field that is finer along isolines.
#[derive(Debug, Clone)]
pub struct Refined {
    /// The vertices of the field first.
    pub field: Field,
    /// Whether isolines are as true as they were to be, and not only nearer to it.
    pub is_true: bool,
}

/// A triangle that may be divided.
#[derive(Clone, Copy)]
struct Part {
    corners: [u32; 3],
    /// The triangle of the field.
    origin: u32,
    /// By how much distances in it differ from what its corners say, about.
    error: f64,
}

struct Refinement<'a> {
    field: &'a Field,
    /// What a unit of length costs.
    usual: f64,
    positions: Vec<DVec3>,
    distances: Vec<f64>,
    parts: Vec<Part>,
    /// Of the middle of each edge that is divided, its vertex, by the ends, the lesser first.
    middles: HashMap<[u32; 2], u32>,
    /// Of vertices that are not the field's, the weights in a triangle of it.
    weights: HashMap<(u32, u32), [f64; 3]>,
}

impl Field {
    /// Divides triangles along isolines until their lengths are right to [`TRUE_TO`]. Distances are those of shortest paths at the
    /// vertices; `ask` gives them at other places, once in each of so many `rounds` at most, which halve what they divide, or none where
    /// they are not known. Loops that lie inside of a triangle as a whole may be missed. A field whose source is a line along edges stays
    /// as it is.
    ///
    /// # Errors
    /// Those of `ask`.
    pub fn refined<E>(
        &self,
        levels: &Levels,
        rounds: usize,
        mut ask: impl FnMut(&Places) -> Result<Option<Vec<f64>>, E>,
    ) -> Result<Refined, E> {
        let mut refinement = Refinement::new(self);
        let (least, nearest) = refinement.edges_at_least();
        let middles = if nearest.is_empty() { Some(Vec::new()) } else { ask(&refinement.places(&nearest))? };
        // A line or a boundary is the source at its vertices, around which distances go in circles: chords are along it as it was meant.
        if middles.is_none_or(|middles| middles.iter().any(|&distance| distance > least)) {
            return Ok(Refined { field: self.clone(), is_true: false });
        }
        let mut left = MOST_PLACES;
        for _ in 0..rounds {
            let ends = refinement.edges_to_divide(levels);
            if ends.is_empty() {
                return Ok(Refined { field: refinement.into_field(), is_true: true });
            }
            if ends.len() > left {
                break;
            }
            left -= ends.len();
            let Some(distances) = ask(&refinement.places(&ends))? else { break };
            refinement.divide(&ends, &distances);
        }
        Ok(Refined { field: refinement.into_field(), is_true: false })
    }
}

impl<'a> Refinement<'a> {
    fn new(field: &'a Field) -> Self {
        let slopes: Vec<f64> = (0..field.triangles().len()).map(|index| slope(field, index)).collect();
        // What a unit of length costs.
        let mut sorted = slopes.clone();
        let middle = sorted.len() / 2;
        let usual = if sorted.is_empty() { 1.0 } else { *sorted.select_nth_unstable_by(middle, f64::total_cmp).1 };
        let least = field.distances().iter().copied().fold(f64::INFINITY, f64::min);
        let part = |(index, &corners): (usize, &[u32; 3])| {
            let longest = longest(field.corners(index));
            let nearest =
                corners.map(|corner| field.distances()[corner as usize]).into_iter().fold(f64::INFINITY, f64::min);
            // Between paths from two sides distance grows more slowly. Else a circle of radius r is h² / 8 r from chords of length h.
            let is_between = slopes[index] < RIDGE * usual;
            let bent = SHARPER * (usual * longest).powi(2) / (8.0 * (nearest - least));
            let most = 0.5 * usual * longest;
            let error = if is_between || bent.is_nan() { most } else { bent.min(most) };
            Part { corners, origin: index as u32, error }
        };
        Self {
            field,
            usual,
            positions: field.positions().to_vec(),
            distances: field.distances().to_vec(),
            parts: field.triangles().iter().enumerate().map(part).collect(),
            middles: HashMap::new(),
            weights: HashMap::new(),
        }
    }

    fn into_field(self) -> Field {
        let triangles = self.parts.iter().map(|part| part.corners).collect();
        Field::new(self.positions, triangles, self.distances).expect("parts of a field are one")
    }

    /// The least distance, and some edges both of whose ends have it, as those of a line that is the source.
    fn edges_at_least(&self) -> (f64, Vec<([u32; 2], u32)>) {
        let least = self.distances.iter().copied().fold(f64::INFINITY, f64::min);
        let is_least = |side: &[u32; 2]| side.iter().all(|&end| self.distances[end as usize] <= least);
        let of = |part: &Part| {
            let origin = part.origin;
            sides(part.corners).into_iter().filter(is_least).map(move |side| (side, origin))
        };
        let finite = self.parts.iter().filter(|_| least.is_finite());
        (least, finite.flat_map(of).take(ENOUGH).collect())
    }

    /// The edges of triangles that isolines may cross which they are too coarse for, each with a triangle of the field.
    fn edges_to_divide(&self, levels: &Levels) -> Vec<([u32; 2], u32)> {
        let values = levels.values();
        let tolerances = self.tolerances(values);
        let mut ends = Vec::new();
        for part in &self.parts {
            let distances = self.distances_of(part);
            let low = distances.into_iter().fold(f64::INFINITY, f64::min) - part.error;
            let high = distances.into_iter().fold(0.0, f64::max) + part.error;
            let first = values.partition_point(|&value| value < low);
            let end = values.partition_point(|&value| value <= high);
            let is_coarse = high.is_finite() && tolerances[first.min(end)..end].iter().any(|&most| part.error > most);
            if is_coarse {
                ends.extend(sides(part.corners).map(|side| (side, part.origin)));
            }
        }
        sort::sort(&mut ends);
        ends.dedup_by_key(|&mut (side, _)| side);
        ends
    }

    fn distances_of(&self, part: &Part) -> [f64; 3] {
        part.corners.map(|corner| self.distances[corner as usize])
    }

    /// By how much the place of each isoline may be off. One that turns once around is longer by a turn for each unit that it is
    /// farther out.
    fn tolerances(&self, values: &[f64]) -> Vec<f64> {
        let mut lengths = vec![0.0; values.len()];
        for part in &self.parts {
            let distances = self.distances_of(part);
            let [a, b, c] = part.corners.map(|corner| self.positions[corner as usize]);
            let low = distances.into_iter().fold(f64::INFINITY, f64::min);
            let high = distances.into_iter().fold(f64::NEG_INFINITY, f64::max);
            let first = values.partition_point(|&value| value <= low);
            let end = if high.is_finite() { values.partition_point(|&value| value < high) } else { first };
            for level in first..end.max(first) {
                let mut ends = [(0, a, b), (1, b, c), (2, c, a)].into_iter().filter_map(|(k, from, to)| {
                    let [low, high] = [distances[k], distances[(k + 1) % 3]];
                    let is_crossed = (low < values[level]) != (high < values[level]);
                    is_crossed.then(|| from.lerp(to, (values[level] - low) / (high - low)))
                });
                if let (Some(from), Some(to)) = (ends.next(), ends.next()) {
                    lengths[level] += from.distance(to);
                }
            }
        }
        let largest = self.distances.iter().copied().filter(|distance| distance.is_finite()).fold(0.0, f64::max);
        lengths.into_iter().map(|length| if length > 0.0 { TRUE_TO * length / TAU } else { UNSEEN * largest }).collect()
    }

    fn places(&self, ends: &[([u32; 2], u32)]) -> Places {
        let middle = |&(side, origin): &([u32; 2], u32)| self.middle_weights(side, origin);
        Places {
            triangles: ends.iter().map(|&(_, origin)| origin).collect(),
            weights: ends.iter().map(middle).collect(),
        }
    }

    /// The weights of the middle of an edge in a triangle of the field.
    fn middle_weights(&self, side: [u32; 2], origin: u32) -> [f64; 3] {
        let corners = self.field.triangles()[origin as usize];
        let weights = |vertex: u32| {
            let at_corner = corners.map(|corner| f64::from(u8::from(corner == vertex)));
            self.weights.get(&(vertex, origin)).copied().unwrap_or(at_corner)
        };
        let [a, b] = side.map(weights);
        std::array::from_fn(|k| 0.5 * (a[k] + b[k]))
    }

    fn divide(&mut self, ends: &[([u32; 2], u32)], distances: &[f64]) {
        self.middles.clear();
        for (&([a, b], _), &distance) in ends.iter().zip(distances) {
            self.middles.insert([a, b], self.positions.len() as u32);
            self.positions.push(0.5 * (self.positions[a as usize] + self.positions[b as usize]));
            self.distances.push(distance);
        }
        for part in std::mem::take(&mut self.parts) {
            let middles = sides(part.corners).map(|side| self.middles.get(&side).copied());
            for (side, middle) in sides(part.corners).into_iter().zip(middles) {
                if let Some(middle) = middle {
                    let weights = self.middle_weights(side, part.origin);
                    self.weights.insert((middle, part.origin), weights);
                }
            }
            let error = self.error_of_halves(part, middles);
            let (positions, usual) = (&self.positions, self.usual);
            split(part.corners, middles, positions, |corners| {
                let longest = longest(corners.map(|corner| positions[corner as usize]));
                self.parts.push(Part { corners, error: error.min(0.5 * usual * longest), ..part });
            });
        }
    }

    /// What is left of the error in the parts of a triangle, a quarter of what its middles say where all are known.
    fn error_of_halves(&self, part: Part, middles: [Option<u32>; 3]) -> f64 {
        let [Some(ab), Some(bc), Some(ca)] = middles else { return part.error };
        let distance = |vertex: u32| self.distances[vertex as usize];
        let off = |side: [u32; 2], middle| (distance(middle) - 0.5 * (distance(side[0]) + distance(side[1]))).abs();
        let found = sides(part.corners).into_iter().zip([ab, bc, ca]).map(|(side, middle)| off(side, middle));
        0.25 * found.fold(0.0, f64::max)
    }
}

/// The edges of a triangle, the lesser end first.
pub(crate) fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)])
}

/// Divides a triangle at middles of its edges, the first one between its first two corners.
pub(crate) fn split(corners: [u32; 3], middles: [Option<u32>; 3], positions: &[DVec3], mut give: impl FnMut([u32; 3])) {
    let turned = |by: usize| {
        let at = |k: usize| corners[(k + by) % 3];
        [at(0), at(1), at(2)]
    };
    match middles {
        [None, None, None] => give(corners),
        [Some(ab), Some(bc), Some(ca)] => {
            let [a, b, c] = corners;
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]].into_iter().for_each(give);
        }
        _ => {
            // Turned so that the edge before the first corner is whole and the next one is not.
            let by = (0..3).find(|&k| middles[k].is_some() && middles[(k + 2) % 3].is_none()).unwrap_or_default();
            let [a, b, c] = turned(by);
            let (Some(ab), bc) = (middles[by], middles[(by + 1) % 3]) else { return };
            let Some(bc) = bc else {
                [[a, ab, c], [ab, b, c]].into_iter().for_each(give);
                return;
            };
            give([ab, b, bc]);
            let length = |a: u32, b: u32| positions[a as usize].distance_squared(positions[b as usize]);
            let halves =
                if length(ab, c) < length(a, bc) { [[a, ab, c], [ab, bc, c]] } else { [[a, ab, bc], [a, bc, c]] };
            halves.into_iter().for_each(give);
        }
    }
}

/// By how much distance grows along a unit of a triangle, at most; 0 where it is not reached.
fn slope(field: &Field, index: usize) -> f64 {
    let Some([a, b, c]) = field.corner_distances(index) else { return 0.0 };
    let [p, q, r] = field.corners(index);
    let normal = triangle::area_vector([p, q, r]);
    let along = a * (r - q) + b * (p - r) + c * (q - p);
    let area = triangle::length(normal);
    if area > 0.0 { triangle::length(along) / area } else { 0.0 }
}
