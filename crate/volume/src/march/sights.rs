//! Distance in riddled meshes: shortest paths over lines of sight between the places that paths may bend at (Dijkstra 1959).
//!
//! Who sees whom is the same from both ends, and so are the shortest paths over lines of sight. Those that end at a vertex are pulled
//! taut, from the same one of their ends whichever was the source. So every distance is the length of a path inside, not above any along
//! edges, and the same there and back: what a march of waves cannot promise where most of them are in the way of something before
//! they come to a vertex.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::sync::atomic::{AtomicU8, Ordering};

use super::medium::Medium;
use crate::mesh::{NONE, Start, TetMesh};
use crate::path::{Corner, length_of, pull};
use crate::point::{TetPoint, TetSource};

/// A distance replaces another if it is below it by this share: what is less is rounding, which depends on the order of sums.
const GAIN: f64 = 1e-12;

/// Places that paths may bend at, and which of them see each other.
#[derive(Debug)]
pub(super) struct Nodes {
    /// The vertices, and after them a place on each sharp edge. More of these would make better first guesses; where on an edge a path
    /// bends, [pulling](pull) finds by itself.
    corners: Vec<Corner>,
    /// Of each pair, once it was asked: [`CLEAR`] or [`BLOCKED`].
    lines: Vec<AtomicU8>,
}

/// Places on edges are about in the middle, within this share of the edge: lines between the very middles of the edges around a
/// quadrilateral have equal lengths, and of two ways that are equally long one would be taken there and the other one back.
const SPREAD: f64 = 0.1;

/// Its multiples, less their whole parts, are spread evenly, and no two are one.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

const UNKNOWN: u8 = 0;
const CLEAR: u8 = 1;
const BLOCKED: u8 = 2;

impl Nodes {
    /// With places on these edges.
    pub(super) fn new(mesh: &TetMesh, edges: &[[u32; 2]]) -> Self {
        let vertices = (0..).zip(mesh.positions()).map(|(vertex, &place)| Corner::at(place, Start::Vertex(vertex)));
        let on_edge = |(number, &ends): (usize, &[u32; 2])| {
            let [a, b] = ends.map(|end| mesh.positions()[end as usize]);
            let share = 0.5 + SPREAD * ((number as f64 * GOLDEN).fract() - 0.5);
            Corner::at(a.lerp(b, share), Start::Edge(ends))
        };
        let corners: Vec<Corner> = vertices.chain(edges.iter().enumerate().map(on_edge)).collect();
        let pairs = corners.len() * (corners.len() - 1) / 2;
        Self { lines: (0..pairs).map(|_| AtomicU8::new(UNKNOWN)).collect(), corners }
    }

    fn see(&self, mesh: &TetMesh, medium: &Medium, a: u32, b: u32) -> bool {
        let [low, high] = [a.min(b), a.max(b)].map(|node| node as usize);
        if low == high {
            return true;
        }
        let line = &self.lines[high * (high - 1) / 2 + low];
        if line.load(Ordering::Relaxed) == UNKNOWN {
            let is_clear = medium.sees(mesh, [self.corners[low], self.corners[high]]);
            line.store(if is_clear { CLEAR } else { BLOCKED }, Ordering::Relaxed);
        }
        line.load(Ordering::Relaxed) == CLEAR
    }
}

/// A search in work.
pub(crate) struct Sights<'a> {
    mesh: &'a TetMesh,
    medium: &'a Medium,
    nodes: &'a Nodes,
    tree: Tree,
    offers: BinaryHeap<Reverse<(u64, u32)>>,
    /// Those without a final distance.
    open: Vec<u32>,
    /// Lines that were followed.
    work: usize,
}

/// Shortest paths over lines of sight.
#[derive(Debug, Clone)]
pub(crate) struct Tree {
    sources: Vec<TetSource>,
    /// Of each node its distance, and the node before; the number of a source comes after those of nodes. None where infinite.
    steps: Vec<(f64, u32)>,
}

impl<'a> Sights<'a> {
    pub(super) fn new(mesh: &'a TetMesh, medium: &'a Medium, nodes: &'a Nodes, sources: &[TetSource]) -> Self {
        let count = nodes.corners.len() as u32;
        let tree = Tree { sources: sources.to_vec(), steps: vec![(f64::INFINITY, NONE); nodes.corners.len()] };
        let (offers, open) = (BinaryHeap::new(), (0..count).collect());
        let mut search = Self { mesh, medium, nodes, tree, offers, open, work: 0 };
        for (by, source) in (count..).zip(sources) {
            let node = match source.point {
                TetPoint::Vertex(vertex) => Some(vertex.0),
                TetPoint::Inside { .. } => None,
            };
            search.spread(source.point.corner(mesh), node, source.initial_distance, by);
        }
        search
    }

    /// As [`super::March::advance`].
    pub(super) fn advance(&mut self, radius: f64, work: usize) -> f64 {
        while let Some(&Reverse((bits, node))) = self.offers.peek() {
            let distance = f64::from_bits(bits);
            if distance >= radius || self.work >= work {
                return distance.min(radius);
            }
            self.offers.pop();
            if let Ok(index) = self.open.binary_search(&node) {
                self.open.remove(index);
                self.spread(self.nodes.corners[node as usize], Some(node), distance, node);
            }
        }
        f64::INFINITY
    }

    /// Offers a distance to all that see a place, which may be a node.
    fn spread(&mut self, from: Corner, number: Option<u32>, distance: f64, by: u32) {
        let Self { mesh, medium, nodes, .. } = *self;
        for &node in &self.open {
            let there = nodes.corners[node as usize];
            let through = distance + from.place.distance(there.place);
            let (least, _) = self.tree.steps[node as usize];
            if through < least * (1.0 - GAIN) {
                self.work += 1;
                let is_seen = match number {
                    Some(number) => nodes.see(mesh, medium, number, node),
                    None => medium.sees(mesh, [from, there]),
                };
                if is_seen {
                    self.tree.steps[node as usize] = (through, by);
                    self.offers.push(Reverse((through.to_bits(), node)));
                }
            }
        }
    }

    /// The distances of vertices (`#V`), and the paths.
    pub(super) fn finish(self) -> (Vec<f64>, Tree) {
        let Self { mesh, medium, nodes, mut tree, open, .. } = self;
        for node in open {
            tree.steps[node as usize] = (f64::INFINITY, NONE);
        }
        let distance = |&from: &Corner| tree.path(mesh, medium, nodes, from).map_or(f64::INFINITY, |path| path.0);
        (nodes.corners[..mesh.vertex_count()].iter().map(distance).collect(), tree)
    }
}

impl Tree {
    /// Whether a vertex has its distance straight from a source.
    pub(super) fn is_straight(&self, vertex: u32) -> bool {
        let (_, by) = self.steps[vertex as usize];
        by != NONE && by as usize >= self.steps.len()
    }

    /// The distance of a place and the path from there to its source; none where there is none.
    pub(super) fn path(
        &self,
        mesh: &TetMesh,
        medium: &Medium,
        nodes: &Nodes,
        from: Corner,
    ) -> Option<(f64, Vec<Corner>)> {
        let mut path = vec![from];
        let mut next = match from.start {
            Start::Vertex(vertex) => self.steps[vertex as usize].1,
            _ => self.nearest(mesh, medium, nodes, from)?,
        };
        while (next as usize) < nodes.corners.len() {
            path.push(nodes.corners[next as usize]);
            next = self.steps[next as usize].1;
        }
        let source = self.sources.get(next as usize - nodes.corners.len())?;
        let there = source.point.corner(mesh);
        if path[path.len() - 1].place != there.place {
            path.push(there);
        }
        // Pulled from the same end whichever is the source.
        let is_turned = from.place.to_array() > there.place.to_array();
        if is_turned {
            path.reverse();
        }
        pull(mesh, medium, &mut path);
        let length = length_of(&path);
        if is_turned {
            path.reverse();
        }
        Some((source.initial_distance + length, path))
    }

    /// The node or source that a place has its distance by.
    fn nearest(&self, mesh: &TetMesh, medium: &Medium, nodes: &Nodes, from: Corner) -> Option<u32> {
        let steps = nodes.corners.iter().zip(&self.steps).map(|(&node, &(distance, _))| (distance, node));
        let sources = self.sources.iter().map(|source| (source.initial_distance, source.point.corner(mesh)));
        let through = |(initial, there): (f64, Corner)| (initial + from.place.distance(there.place), there);
        let mut ways: Vec<(u32, (f64, Corner))> = (0..).zip(steps.chain(sources).map(through)).collect();
        ways.retain(|(_, (distance, _))| distance.is_finite());
        ways.sort_by(|(_, a), (_, b)| a.0.total_cmp(&b.0));
        ways.into_iter().find(|&(_, (_, there))| medium.sees(mesh, [from, there])).map(|(by, _)| by)
    }
}
