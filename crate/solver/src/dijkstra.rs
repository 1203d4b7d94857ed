//! Shortest paths along edges (Dijkstra 1959; towards one goal, Hart, Nilsson, Raphael 1968): lines along edges, an
//! upper bound for distance, and the way out of a dead end.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use heatwalk_base::csr::NONE;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, VertexId, triangle};

use crate::cost::Costs;
use crate::error::{Error, Result};

/// The shortest path along edges from one vertex to another, both included; one vertex where they are the same.
///
/// # Errors
/// [`Error::Surface`] for a vertex that does not exist; [`Error::Unreachable`] where no edges join them.
pub fn edge_path(surface: &Surface, from: VertexId, to: VertexId) -> Result<Vec<VertexId>> {
    path_between(surface, &mut Search::default(), from, to)
}

fn path_between(surface: &Surface, search: &mut Search, from: VertexId, to: VertexId) -> Result<Vec<VertexId>> {
    for vertex in [from, to] {
        surface.point(vertex)?;
    }
    // Nothing is shorter than an edge, and a vertex of many would have to look at them all.
    if from != to && surface.halfedge_between(from, to).is_some() {
        return Ok(vec![from, to]);
    }
    let component = |vertex: VertexId| surface.component(vertex);
    if component(from) != component(to) {
        return Err(Error::Unreachable);
    }
    let goal = surface.position(to);
    // No path along edges is shorter than the straight line.
    let ahead = |vertex: VertexId| triangle::length(goal - surface.position(vertex));
    search.run(surface, from, |vertex| vertex == to, ahead).ok_or(Error::Unreachable)
}

/// The line of shortest paths along edges through picked vertices in order, and back to the first where it is `closed`.
/// Where two paths meet, their vertex is there once; a closed line does not repeat its first vertex at the end.
///
/// # Errors
/// As [`edge_path`]; [`Error::BadParameter`] where no vertex is given.
pub fn edge_polyline(surface: &Surface, through: &[VertexId], closed: bool) -> Result<Vec<VertexId>> {
    let Some(&first) = through.first() else {
        return Err(Error::BadParameter { name: "line", value: "empty".to_owned(), range: "one vertex at least" });
    };
    surface.point(first)?;
    let mut line = vec![first];
    let mut search = Search::default();
    for pair in through.windows(2) {
        line.extend_from_slice(&path_between(surface, &mut search, pair[0], pair[1])?[1..]);
    }
    if closed {
        let back = path_between(surface, &mut search, through[through.len() - 1], first)?;
        line.extend_from_slice(&back[1..]);
        // The vertex in common, unless it is the only one.
        if line.len() > 1 {
            line.pop();
        }
    }
    Ok(line)
}

/// The shortest path along edges from `start` to the nearest vertex that is a `goal`, both ends included; `None` where
/// none can be reached.
pub(crate) fn nearest_goal(
    surface: &Surface,
    start: VertexId,
    goal: impl Fn(VertexId) -> bool,
) -> Option<Vec<VertexId>> {
    Search::default().run(surface, start, goal, |_| 0.0)
}

/// The memory of searches, which takes time for the vertices that each came to, not for all.
#[derive(Default)]
struct Search {
    /// `#V`, the length of the path behind each vertex, and the vertex before it.
    best: Vec<(f64, VertexId)>,
    reached: Vec<VertexId>,
}

impl Search {
    /// The same with a lower bound, from each vertex, of the path `ahead` to the goal. Vertices are visited in order of the path
    /// behind and the bound, and none beyond the goal.
    fn run(
        &mut self,
        surface: &Surface,
        start: VertexId,
        goal: impl Fn(VertexId) -> bool,
        ahead: impl Fn(VertexId) -> f64,
    ) -> Option<Vec<VertexId>> {
        const UNKNOWN: (f64, VertexId) = (f64::INFINITY, VertexId(NONE));
        self.best.resize(surface.vertex_count(), UNKNOWN);
        self.reached.drain(..).for_each(|vertex| self.best[vertex.index()] = UNKNOWN);
        let (best, reached) = (&mut self.best, &mut self.reached);
        // Bits of non-negative floats order as the floats do.
        let mut queue = BinaryHeap::from([Reverse((0, start, 0.0_f64.to_bits()))]);
        best[start.index()].0 = 0.0;
        reached.push(start);
        let end = loop {
            let Reverse((_, vertex, bits)) = queue.pop()?;
            let distance = f64::from_bits(bits);
            if distance > best[vertex.index()].0 {
                continue;
            }
            if goal(vertex) {
                break vertex;
            }
            let position = surface.position(vertex);
            for other in surface.neighbours(vertex) {
                let candidate = distance + triangle::length(surface.position(other) - position);
                let known = &mut best[other.index()];
                if candidate < known.0 {
                    if known.0.is_infinite() {
                        reached.push(other);
                    }
                    *known = (candidate, vertex);
                    queue.push(Reverse(((candidate + ahead(other)).to_bits(), other, candidate.to_bits())));
                }
            }
        };
        let step_back = |&vertex: &VertexId| Some(best[vertex.index()].1).filter(|before| before.0 != NONE);
        let mut path: Vec<VertexId> = std::iter::successors(Some(end), step_back).collect();
        path.reverse();
        Some(path)
    }
}

/// The largest extent of a connected component along edges, where faces have costs or not, found by two sweeps over each; at
/// least half the true one.
pub(crate) fn extent(surface: &Surface, costs: Option<&Costs>) -> f64 {
    let mut sweep = Sweep::new(surface, costs);
    let mut first = vec![f32::INFINITY; surface.vertex_count()];
    let mut second = first.clone();
    let mut extent: f32 = 0.0;
    let mut components = 0;
    for vertex in surface.vertices() {
        if surface.component(vertex) == components {
            components += 1;
            let (end, _) = sweep.farthest(vertex, &mut first);
            extent = extent.max(sweep.farthest(end, &mut second).1);
        }
    }
    f64::from(extent) * surface.mean_edge()
}

/// Distances along edges from a vertex to all of its component, in mean edges and single precision, which an extent needs no
/// better. Vertices are taken from buckets of distance in any order and again when they got nearer (delta-stepping: Meyer
/// and Sanders 2003), which is cheaper than a heap and ends at the same distances. Where too many come again, because edges are far
/// shorter than buckets are wide, the rest are taken in exact order.
struct Sweep {
    /// `#P + 1`, where each vertex's edges begin.
    start: Vec<u32>,
    /// The vertex at the other end, and the length.
    edges: Vec<(VertexId, f32)>,
    /// Those of the component.
    reached: Vec<VertexId>,
    /// Vertices to take, by distance, in a circle longer than any edge. Their number is a power of two.
    buckets: Vec<Vec<(VertexId, f32)>>,
    /// The same in exact order, by the bits of their distances, which order as these do.
    sorted: BinaryHeap<Reverse<(u32, VertexId)>>,
    /// Buckets in a mean edge.
    density: f32,
}

impl Sweep {
    /// Width of a bucket in mean edges. Narrower ones are empty, in wider ones vertices are taken in vain.
    const WIDTH: f32 = 0.5;
    /// Most buckets, for meshes with edges far longer than the mean.
    const MOST: f32 = 4096.0;
    /// How often vertices are taken from buckets, on the mean.
    const TIMES: usize = 16;

    fn new(surface: &Surface, costs: Option<&Costs>) -> Self {
        let mut start = Vec::with_capacity(surface.vertex_count() + 1);
        let mut edges = Vec::with_capacity(surface.mesh().halfedge_count());
        let mut longest: f32 = 0.0;
        let faces = surface.faces().as_slice();
        start.push(0);
        for vertex in surface.vertices() {
            let position = surface.position(vertex);
            let mut add = |tip: VertexId, cost: f64| {
                let length = cost * triangle::length(surface.position(tip) - position) / surface.mean_edge();
                longest = longest.max(length as f32);
                edges.push((tip, length as f32));
            };
            for (face, k) in surface.corners_of_vertex(vertex) {
                let before = (k + 2) % 3;
                let cost = costs.map_or(1.0, |costs| costs.of(face));
                add(faces[face.index()][(k + 1) % 3], cost);
                // An inner edge leaves the vertex in the face on its left, but one with nothing there in none.
                let twin = surface.mesh().twin(face.halfedge(before));
                if twin.index() >= 3 * faces.len() {
                    add(faces[face.index()][before], cost);
                }
            }
            start.push(edges.len() as u32);
        }
        let width = Self::WIDTH.max(longest / Self::MOST);
        // One bucket more for the one at work, one for rounding.
        let circle = ((longest / width) as usize + 3).next_power_of_two();
        let buckets = vec![Vec::new(); circle];
        Self { start, edges, reached: Vec::new(), buckets, sorted: BinaryHeap::new(), density: width.recip() }
    }

    /// The farthest vertex of the component from `start`, the last one of several, with its distance. `best` holds infinity
    /// at every vertex of the component before, the distances after.
    fn farthest(&mut self, start: VertexId, best: &mut [f32]) -> (VertexId, f32) {
        let mask = self.buckets.len() - 1;
        best[start.index()] = 0.0;
        self.reached.clear();
        self.reached.push(start);
        self.buckets[0].push((start, 0.0));
        let (mut waiting, mut at, mut taken, mut is_sorted) = (1, 0, 0, false);
        while waiting > 0 {
            while let Some((vertex, distance)) = if is_sorted { self.nearest() } else { self.buckets[at & mask].pop() }
            {
                waiting -= 1;
                taken += 1;
                if !is_sorted && taken > Self::TIMES * self.reached.len() {
                    is_sorted = true;
                    let items = self.buckets.iter_mut().flat_map(|bucket| bucket.drain(..));
                    self.sorted.extend(items.map(|(vertex, distance)| Reverse((distance.to_bits(), vertex))));
                }
                if distance > best[vertex.index()] {
                    continue;
                }
                let row = self.start[vertex.index()] as usize..self.start[vertex.index() + 1] as usize;
                for &(tip, length) in &self.edges[row] {
                    let candidate = distance + length;
                    let known = &mut best[tip.index()];
                    if candidate < *known {
                        if known.is_infinite() {
                            self.reached.push(tip);
                        }
                        *known = candidate;
                        if is_sorted {
                            self.sorted.push(Reverse((candidate.to_bits(), tip)));
                        } else {
                            self.buckets[(candidate * self.density) as usize & mask].push((tip, candidate));
                        }
                        waiting += 1;
                    }
                }
            }
            at += 1;
        }
        let reached = self.reached.iter().map(|&vertex| (vertex, best[vertex.index()]));
        reached.max_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0))).unwrap_or((start, 0.0))
    }

    /// Takes the nearest of those in exact order.
    fn nearest(&mut self) -> Option<(VertexId, f32)> {
        self.sorted.pop().map(|Reverse((bits, vertex))| (vertex, f32::from_bits(bits)))
    }
}
