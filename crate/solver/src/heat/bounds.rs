//! Bounds that distance keeps on any mesh: no vertex is farther than a neighbour and the edge between, and none is nearer than
//! in a straight line through space. What heat makes of a mesh need not keep them.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;
use heatwalk_base::sort::sort;

use crate::extremum::{larger, smaller};
use crate::heat::point_source::PointSource;

/// What the bounds of distances on a mesh take.
#[derive(Debug)]
pub struct Bounds {
    /// The ends of each edge, and what it is long, times what a unit of length costs there.
    edges: Vec<([u32; 2], f64)>,
    /// `#V + 1`, where the edges of each vertex begin in `around`.
    start: Vec<u32>,
    /// The numbers of these edges.
    around: Vec<u32>,
    /// What a unit of length costs at least.
    least_cost: f64,
}

/// All edges are looked at to and fro so often at most. It takes a hundredth of what the search takes for as many, and leaves few to it
/// where few edges in a row are to lower what is along them.
const MOST_SWEEPS: usize = 4;

/// Fewer than a vertex in so many are quicker searched from.
const FEW: usize = 16;

impl Bounds {
    /// By the edges of so many vertices, with what each costs, which is no less than the straight line between its ends at the
    /// least cost.
    pub fn new(vertices: usize, edges: impl Iterator<Item = ([u32; 2], f64)>, least_cost: f64) -> Self {
        let edges: Vec<([u32; 2], f64)> = edges.collect();
        let mut start = vec![0; vertices + 1];
        edges.iter().flat_map(|&(ends, _)| ends).for_each(|end| start[end as usize + 1] += 1);
        for vertex in 1..start.len() {
            start[vertex] += start[vertex - 1];
        }
        let mut next = start.clone();
        let mut around = vec![0; 2 * edges.len()];
        for (edge, end) in (0..).zip(&edges).flat_map(|(edge, &(ends, _))| ends.map(|end| (edge, end))) {
            let place = &mut next[end as usize];
            around[*place as usize] = edge;
            *place += 1;
        }
        Self { edges, start, around, least_cost }
    }

    /// Makes distances (`#V`) from some sources keep to straight lines and to the way along edges. What is infinite comes to be as far.
    ///
    /// No edge is shorter than the straight line between its ends, so that what edges lower stays above straight lines. The result does
    /// not depend on the order of vertices.
    pub(super) fn keep(&self, positions: &[DVec3], sources: &[PointSource], values: &mut [f64]) {
        let starts = Starts::new(sources, self.least_cost);
        for (value, &position) in values.iter_mut().zip(positions) {
            *value = larger(*value, starts.straight(position, *value));
        }
        let mut lowered = Vec::new();
        for sweep in 0..MOST_SWEEPS {
            lowered.clear();
            let lower = |edge| lower(edge, values, &mut lowered);
            if sweep % 2 == 0 {
                self.edges.iter().for_each(lower);
            } else {
                self.edges.iter().rev().for_each(lower);
            }
            if FEW * lowered.len() < values.len() {
                break;
            }
        }
        // An edge keeps the bound if neither of its ends was lowered in the last sweep.
        sort(&mut lowered);
        lowered.dedup();
        self.search(lowered, values);
    }

    /// Lowers distances to those of neighbors and the edges between, as in the search of Dijkstra (1959), from some vertices on.
    fn search(&self, from: Vec<u32>, values: &mut [f64]) {
        // Bits of numbers that are not negative order as the numbers do.
        let waiting = from.into_iter().map(|vertex| Reverse((values[vertex as usize].to_bits(), vertex)));
        let mut queue: BinaryHeap<Reverse<(u64, u32)>> = waiting.collect();
        while let Some(Reverse((bits, vertex))) = queue.pop() {
            let value = f64::from_bits(bits);
            if value > values[vertex as usize] {
                continue;
            }
            for (end, length) in self.edges_of(vertex) {
                let through = value + length;
                let known = &mut values[end as usize];
                if through < *known {
                    *known = through;
                    queue.push(Reverse((through.to_bits(), end)));
                }
            }
        }
    }

    /// The other ends of a vertex's edges, and what these cost.
    #[inline]
    fn edges_of(&self, vertex: u32) -> impl Iterator<Item = (u32, f64)> {
        let range = self.start[vertex as usize] as usize..self.start[vertex as usize + 1] as usize;
        self.around[range].iter().map(move |&edge| {
            let ([a, b], length) = self.edges[edge as usize];
            (a ^ b ^ vertex, length)
        })
    }
}

/// Lowers the distance at the farther end of an edge to that at the other one and the edge, and tells which end it was.
#[inline]
fn lower(&([a, b], length): &([u32; 2], f64), values: &mut [f64], lowered: &mut Vec<u32>) {
    let (at_a, at_b) = (values[a as usize], values[b as usize]);
    // Which end is farther is as good as random, so that it is asked for only where it matters.
    if (at_a - at_b).abs() > length {
        let (far, near) = if at_a > at_b { (a, at_b) } else { (b, at_a) };
        values[far as usize] = near + length;
        lowered.push(far);
    }
}

/// The sources as a tree: each parts those after it from those before it along an axis.
struct Starts {
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
    fn new(sources: &[PointSource], least_cost: f64) -> Self {
        let start = |source: &PointSource| {
            let (place, initial) = (source.position, source.initial_distance());
            Start { place, initial, least: initial, axis: 0 }
        };
        let mut starts: Vec<Start> = sources.iter().map(start).collect();
        grow(&mut starts);
        Self { least_cost, starts }
    }

    /// The distance of the nearest one in a straight line, or some distance that is at most `enough` where there is any.
    #[inline]
    fn straight(&self, from: DVec3, enough: f64) -> f64 {
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
