//! Bounds that distance keeps on any surface: no vertex is farther than a neighbour and the edge between, and none is nearer than
//! in a straight line through space. What heat makes of a mesh need not keep them.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;

use crate::cost::Costs;
use crate::exact::{ExactGeometry, after};
use crate::extremum::{larger, smaller};
use heatwalk_surface::{FaceId, HalfedgeId, Source, Surface, VertexId};

/// What the bounds of distances on a surface take.
#[derive(Debug)]
pub(super) struct Bounds {
    /// `#E`, its ends and its length: which edges keep the bounds is seen at a glance.
    edges: Vec<([u32; 2], f64)>,
    /// What a unit of length costs at least.
    least_cost: f64,
}

/// What rounding makes of a sum of lengths, as a share of one.
const ROUNDING: f64 = 1e-13;

impl Bounds {
    /// On a surface whose faces have costs, or not.
    pub(super) fn new(geometry: &ExactGeometry, costs: Option<&Costs>) -> Self {
        let edge = |halfedge: HalfedgeId| {
            let (frame, k) = geometry.frame_of(halfedge.0);
            let faces = geometry.across(halfedge.0).map(|(other, _)| other / 3);
            let cost = faces.map(|face| cost(geometry, face)).fold(cost(geometry, halfedge.0 / 3), smaller);
            ([frame[k].vertex, frame[after(k)].vertex], cost * frame[k].length)
        };
        Self {
            edges: geometry.surface().edges().representatives().map(edge).collect(),
            least_cost: costs.map_or(1.0, |costs| costs.of_faces().iter().copied().fold(f64::INFINITY, smaller)),
        }
    }

    /// `#E`, ends and length of each edge.
    pub(super) fn edges(&self) -> &[([u32; 2], f64)] {
        &self.edges
    }

    /// Straight lines from these sources.
    pub(super) fn starts(&self, surface: &Surface, sources: &[Source]) -> Starts {
        Starts::new(surface, sources, self.least_cost)
    }

    /// Makes distances (`#V`) that are below no straight line keep to the way along edges. What is infinite comes to be as far.
    ///
    /// They stay above straight lines, since no edge is shorter.
    pub(super) fn keep(&self, geometry: &ExactGeometry, values: &mut [f64]) {
        let mut low = Vec::new();
        for &(ends, length) in &self.edges {
            let [a, b] = ends.map(|end| values[end as usize]);
            if (a - b).abs() > length * (1.0 + ROUNDING) {
                low.push(if a < b { ends[0] } else { ends[1] });
            }
        }
        relax(geometry, low, values);
    }
}

/// What a unit of length costs in a face.
fn cost(geometry: &ExactGeometry, face: u32) -> f64 {
    geometry.costs().map_or(1.0, |costs| costs.of(FaceId(face)))
}

/// Lowers distances to those of neighbors and the edges between, as in the search of Dijkstra (1959), from some vertices on.
fn relax(geometry: &ExactGeometry, from: Vec<u32>, values: &mut [f64]) {
    // Bits of numbers that are not negative order as the numbers do.
    let waiting = from.into_iter().map(|vertex| Reverse((values[vertex as usize].to_bits(), vertex)));
    let mut queue: BinaryHeap<Reverse<(u64, u32)>> = waiting.collect();
    while let Some(Reverse((bits, vertex))) = queue.pop() {
        let value = f64::from_bits(bits);
        if value > values[vertex as usize] {
            continue;
        }
        for (face, k) in geometry.surface().corners_of_vertex(VertexId(vertex)) {
            let [from, out, last] = geometry.frame(face.0).seen_from(k);
            for (other, length) in [(out.vertex, from.length), (last.vertex, last.length)] {
                let through = value + cost(geometry, face.0) * length;
                let known = &mut values[other as usize];
                if through < *known {
                    *known = through;
                    queue.push(Reverse((through.to_bits(), other)));
                }
            }
        }
    }
}

/// The sources as a tree: each parts those after it from those before it along an axis.
pub(super) struct Starts {
    least_cost: f64,
    starts: Vec<Start>,
}

struct Start {
    place: DVec3,
    initial: f64,
    /// The least initial distance in the part of the tree below, its own included.
    least: f64,
    axis: usize,
}

impl Starts {
    fn new(surface: &Surface, sources: &[Source], least_cost: f64) -> Self {
        let start = |source: &Source| {
            let (place, initial) = (source.place().position(surface), source.initial_distance());
            Start { place, initial, least: initial, axis: 0 }
        };
        let mut starts: Vec<Start> = sources.iter().map(start).collect();
        grow(&mut starts);
        Self { least_cost, starts }
    }

    /// The distance of the nearest one in a straight line, or some distance that is at most `enough` where there is any.
    #[inline]
    pub(super) fn straight(&self, from: DVec3, enough: f64) -> f64 {
        // Where there is one source, or others are far, that at the root tells enough.
        let mut nearest = self.starts.get(self.starts.len() / 2).map_or(f64::INFINITY, |root| self.to(root, from));
        if nearest > enough {
            self.search(&self.starts, (from, 0.0), enough, &mut nearest);
        }
        nearest
    }

    #[inline]
    fn to(&self, start: &Start, from: DVec3) -> f64 {
        start.initial + self.least_cost * from.distance(start.place)
    }

    /// Of a part of the tree that is at least this far away.
    fn search(&self, part: &[Start], (from, away): (DVec3, f64), enough: f64, nearest: &mut f64) {
        let middle = part.len() / 2;
        let Some(start) = part.get(middle) else { return };
        if *nearest <= enough || start.least + self.least_cost * away >= *nearest {
            return;
        }
        *nearest = smaller(self.to(start, from), *nearest);
        let ahead = from[start.axis] - start.place[start.axis];
        let (below, above) = (&part[..middle], &part[middle + 1..]);
        let (near, far) = if ahead < 0.0 { (below, above) } else { (above, below) };
        for (part, away) in [(near, away), (far, larger(away, ahead.abs()))] {
            if !part.is_empty() {
                self.search(part, (from, away), enough, nearest);
            }
        }
    }
}

/// Makes a tree of some starts, whose root is in the middle. Returns the least initial distance.
fn grow(part: &mut [Start]) -> f64 {
    let middle = part.len() / 2;
    let Some(first) = part.first().map(|start| start.place) else { return f64::INFINITY };
    let bound = |by: fn(DVec3, DVec3) -> DVec3| part.iter().map(|start| start.place).fold(first, by);
    let size = (bound(DVec3::max) - bound(DVec3::min)).to_array();
    let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
    part.select_nth_unstable_by(middle, |a, b| a.place[axis].total_cmp(&b.place[axis]));
    let (below, rest) = part.split_at_mut(middle);
    let Some((root, above)) = rest.split_first_mut() else { return f64::INFINITY };
    root.axis = axis;
    root.least = smaller(root.initial, smaller(grow(below), grow(above)));
    root.least
}
