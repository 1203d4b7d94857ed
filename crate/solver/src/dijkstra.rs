//! Shortest paths along edges (Dijkstra 1959; towards one goal, Hart, Nilsson, Raphael 1968): lines along edges, an
//! upper bound for distance, and the way out of a dead end.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::error::{Error, Result};
use heatwalk_surface::csr::NONE;
use heatwalk_surface::halfedge::Halfedge;
use heatwalk_surface::point::SurfacePoint;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::triangle;

/// The shortest way along edges from one point to another, both included; one point where they are the same.
///
/// # Errors
/// [`Error::BadVertex`] for a point that does not exist; [`Error::Unreachable`] where no edges join them.
pub fn edge_path(surface: &Surface, from: u32, to: u32) -> Result<Vec<u32>> {
    for point in [from, to] {
        SurfacePoint::Vertex(point).validated(surface)?;
    }
    let component = |point: u32| surface.component_of_point[point as usize];
    if component(from) != component(to) {
        return Err(Error::Unreachable);
    }
    let goal = surface.position(to);
    // No way along edges is shorter than the straight line.
    let ahead = |point: u32| triangle::length(goal - surface.position(point));
    way(surface, from, |point| point == to, ahead).ok_or(Error::Unreachable)
}

/// The line of shortest ways along edges through picked points in order, and back to the first where it is `closed`.
/// Where two ways meet, their point is there once; a closed line does not repeat its first point at the end.
///
/// # Errors
/// As [`edge_path`]; [`Error::BadParameter`] where no point is given.
pub fn edge_polyline(surface: &Surface, through: &[u32], closed: bool) -> Result<Vec<u32>> {
    let Some(&first) = through.first() else {
        return Err(Error::BadParameter { name: "line", value: "empty".to_owned(), range: "one point at least" });
    };
    SurfacePoint::Vertex(first).validated(surface)?;
    let mut line = vec![first];
    for pair in through.windows(2) {
        line.extend_from_slice(&edge_path(surface, pair[0], pair[1])?[1..]);
    }
    if closed {
        let back = edge_path(surface, through[through.len() - 1], first)?;
        line.extend_from_slice(&back[1..]);
        // The point in common, unless it is the only one.
        if line.len() > 1 {
            line.pop();
        }
    }
    Ok(line)
}

/// The shortest way along edges from `start` to the nearest point that is a `goal`, both ends included; `None` where
/// none can be reached.
pub(crate) fn way_to(surface: &Surface, start: u32, goal: impl Fn(u32) -> bool) -> Option<Vec<u32>> {
    way(surface, start, goal, |_| 0.0)
}

/// The same with a lower bound, from each point, of the way `ahead` to the goal. Points are visited in order of the way
/// behind and the bound, and none beyond the goal.
fn way(surface: &Surface, start: u32, goal: impl Fn(u32) -> bool, ahead: impl Fn(u32) -> f64) -> Option<Vec<u32>> {
    let mut best = vec![f64::INFINITY; surface.point_count()];
    let mut from = vec![NONE; surface.point_count()];
    // Bits of non-negative floats order as the floats do.
    let mut queue = BinaryHeap::from([Reverse((0, start, 0.0_f64.to_bits()))]);
    best[start as usize] = 0.0;
    let end = loop {
        let Reverse((_, point, bits)) = queue.pop()?;
        let distance = f64::from_bits(bits);
        if distance > best[point as usize] {
            continue;
        }
        if goal(point) {
            break point;
        }
        let position = surface.position(point);
        for other in surface.neighbours(point) {
            let candidate = distance + triangle::length(surface.position(other) - position);
            if candidate < best[other as usize] {
                best[other as usize] = candidate;
                from[other as usize] = point;
                queue.push(Reverse(((candidate + ahead(other)).to_bits(), other, candidate.to_bits())));
            }
        }
    };
    let step_back = |&point: &u32| Some(from[point as usize]).filter(|&before| before != NONE);
    let mut way: Vec<u32> = std::iter::successors(Some(end), step_back).collect();
    way.reverse();
    Some(way)
}

/// The largest extent of a connected piece along edges, found by two sweeps over each; at least half the true one.
pub(crate) fn extent(surface: &Surface) -> f64 {
    let mut sweep = Sweep::new(surface);
    let mut first = vec![f32::INFINITY; surface.point_count()];
    let mut second = first.clone();
    let mut extent: f32 = 0.0;
    let mut pieces = 0;
    for point in 0..surface.point_count() as u32 {
        if surface.component_of_point[point as usize] == pieces {
            pieces += 1;
            let (end, _) = sweep.farthest(point, &mut first);
            extent = extent.max(sweep.farthest(end, &mut second).1);
        }
    }
    f64::from(extent) * surface.mean_edge
}

/// Distances along edges from a point to all of its piece, in mean edges and single precision, which an extent needs no
/// better. Points are taken from buckets of distance in any order and again when they got nearer (delta-stepping: Meyer
/// and Sanders 2003), which is cheaper than a heap and ends at the same distances.
struct Sweep {
    /// `#P + 1`, where each point's edges begin.
    start: Vec<u32>,
    /// The point at the other end, and the length.
    edges: Vec<(u32, f32)>,
    /// Those of the piece.
    reached: Vec<u32>,
    /// Points to take, by distance, in a circle longer than any edge. Their number is a power of two.
    buckets: Vec<Vec<(u32, f32)>>,
    /// Buckets in a mean edge.
    density: f32,
}

impl Sweep {
    /// Width of a bucket in mean edges. Narrower ones are empty, in wider ones points are taken in vain.
    const WIDTH: f32 = 0.5;
    /// Most buckets, for meshes with edges far longer than the mean.
    const MOST: f32 = 4096.0;

    fn new(surface: &Surface) -> Self {
        let mut start = Vec::with_capacity(surface.point_count() + 1);
        let mut edges = Vec::with_capacity(surface.mesh.halfedge_count());
        let mut longest: f32 = 0.0;
        let faces = surface.faces.as_slice();
        start.push(0);
        for point in 0..surface.point_count() as u32 {
            let position = surface.position(point);
            let mut add = |tip: u32| {
                let length = triangle::length(surface.position(tip) - position) / surface.mean_edge;
                longest = longest.max(length as f32);
                edges.push((tip, length as f32));
            };
            for (face, k) in surface.corners_of_point(point) {
                let before = (k + 2) % 3;
                add(faces[face.0 as usize][(k + 1) % 3]);
                // An inner edge leaves the point in the face on its left, but one with nothing there in none.
                let twin = surface.mesh.twin(Halfedge(3 * face.0 + before as u32));
                if twin.0 as usize >= 3 * faces.len() {
                    add(faces[face.0 as usize][before]);
                }
            }
            start.push(edges.len() as u32);
        }
        let width = Self::WIDTH.max(longest / Self::MOST);
        // One bucket more for the one at work, one for rounding.
        let circle = ((longest / width) as usize + 3).next_power_of_two();
        Self { start, edges, reached: Vec::new(), buckets: vec![Vec::new(); circle], density: width.recip() }
    }

    /// The farthest point of the piece from `start`, the last one of several, with its distance. `best` holds infinity
    /// at every point of the piece before, the distances after.
    fn farthest(&mut self, start: u32, best: &mut [f32]) -> (u32, f32) {
        let mask = self.buckets.len() - 1;
        best[start as usize] = 0.0;
        self.reached.clear();
        self.reached.push(start);
        self.buckets[0].push((start, 0.0));
        let (mut waiting, mut at) = (1, 0);
        while waiting > 0 {
            while let Some((point, distance)) = self.buckets[at & mask].pop() {
                waiting -= 1;
                if distance > best[point as usize] {
                    continue;
                }
                let row = self.start[point as usize] as usize..self.start[point as usize + 1] as usize;
                for &(tip, length) in &self.edges[row] {
                    let candidate = distance + length;
                    let known = &mut best[tip as usize];
                    if candidate < *known {
                        if known.is_infinite() {
                            self.reached.push(tip);
                        }
                        *known = candidate;
                        self.buckets[(candidate * self.density) as usize & mask].push((tip, candidate));
                        waiting += 1;
                    }
                }
            }
            at += 1;
        }
        let reached = self.reached.iter().map(|&point| (point, best[point as usize]));
        reached.max_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0))).unwrap_or((start, 0.0))
    }
}
