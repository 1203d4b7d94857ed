//! Distance in riddled meshes: shortest paths over lines of sight between the places that paths may bend at (Dijkstra 1959).
//!
//! Who sees whom is the same from both ends, and so are the shortest paths over lines of sight. Those that end at a vertex are pulled
//! taut, from the same one of their ends whichever was the source. So every distance is the length of a path inside, not above any along
//! edges, and the same there and back: what a march of waves cannot promise where most of them are in the way of something before
//! they come to a vertex.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;

use super::medium::Medium;
use super::nodes::Nodes;
use crate::mesh::{Crossing, NONE, Start, TetMesh};
use crate::path::{Corner, length_of, pull};
use crate::point::TetSource;

/// A distance replaces another if it is below it by this share: what is less is rounding, which depends on the order of sums.
const GAIN: f64 = 1e-12;

/// A search in work.
pub(crate) struct Sights<'a> {
    mesh: &'a TetMesh,
    medium: &'a Medium,
    nodes: &'a Nodes,
    tree: Tree,
    offers: BinaryHeap<Reverse<(u64, u32)>>,
    /// Those that have their distance.
    is_settled: Vec<bool>,
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
        let count = nodes.positions.len();
        let tree = Tree { sources: sources.to_vec(), steps: vec![(f64::INFINITY, NONE); count] };
        let (offers, is_settled) = (BinaryHeap::new(), vec![false; count]);
        let mut search = Self { mesh, medium, nodes, tree, offers, is_settled, work: 0 };
        for (by, source) in (count as u32..).zip(sources) {
            let (place, start) = (source.point.position(mesh), source.point.start(mesh));
            if let Start::Vertex(vertex) = start {
                search.offer(vertex, source.initial_distance, by);
                if nodes.sees_all() {
                    continue;
                }
            }
            for node in nodes.seen_from(mesh, medium, place, start, f64::INFINITY) {
                search.offer(node, source.initial_distance + place.distance(nodes.positions[node as usize]), by);
            }
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
            if self.is_settled[node as usize] || distance > self.tree.steps[node as usize].0 {
                continue;
            }
            self.is_settled[node as usize] = true;
            let seen = self.nodes.seen(self.mesh, self.medium, node);
            self.work += seen.len();
            for &other in seen {
                let place = self.nodes.positions[node as usize];
                self.offer(other, distance + place.distance(self.nodes.positions[other as usize]), node);
            }
        }
        f64::INFINITY
    }

    fn offer(&mut self, node: u32, distance: f64, by: u32) {
        let (least, _) = self.tree.steps[node as usize];
        // What is seen from one end only is on the verge of being hidden.
        let is_mutual = || {
            by as usize >= self.nodes.positions.len()
                || self.nodes.seen(self.mesh, self.medium, node).binary_search(&by).is_ok()
        };
        if distance < least * (1.0 - GAIN) && is_mutual() {
            self.tree.steps[node as usize] = (distance, by);
            self.offers.push(Reverse((distance.to_bits(), node)));
        }
    }

    /// The distances of vertices (`#V`), and the paths.
    pub(super) fn finish(self) -> (Vec<f64>, Tree) {
        let Self { mesh, medium, nodes, mut tree, is_settled, .. } = self;
        for (step, is_settled) in tree.steps.iter_mut().zip(is_settled) {
            if !is_settled {
                *step = (f64::INFINITY, NONE);
            }
        }
        let distance = |vertex: u32| {
            let start = Start::Vertex(vertex);
            tree.path(mesh, medium, nodes, nodes.positions[vertex as usize], start).map_or(f64::INFINITY, |path| path.0)
        };
        ((0..mesh.vertex_count() as u32).map(distance).collect(), tree)
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
        place: DVec3,
        start: Start,
    ) -> Option<(f64, Vec<Corner>)> {
        let mut path = vec![Corner { place, start, cost: 1.0 }];
        let mut next = match start {
            Start::Vertex(vertex) => self.steps[vertex as usize].1,
            _ => self.nearest(mesh, medium, nodes, place, start)?,
        };
        let source = loop {
            if next == NONE {
                return None;
            }
            match (next as usize).checked_sub(nodes.positions.len()) {
                Some(source) => break self.sources[source],
                None => {
                    let place = nodes.positions[next as usize];
                    path.push(Corner { place, start: nodes.start(next), cost: 1.0 });
                    next = self.steps[next as usize].1;
                }
            }
        };
        let there = source.point.position(mesh);
        if path[path.len() - 1].place != there {
            path.push(Corner { place: there, start: source.point.start(mesh), cost: 1.0 });
        }
        // Pulled from the same end whichever is the source.
        let is_turned = place.to_array() > there.to_array();
        if is_turned {
            path.reverse();
        }
        if path.len() > 2 {
            pull(mesh, medium, &mut path);
        }
        let length = length_of(&path);
        if is_turned {
            path.reverse();
        }
        Some((source.initial_distance + length, path))
    }

    /// The node or source that a place has its distance by.
    fn nearest(&self, mesh: &TetMesh, medium: &Medium, nodes: &Nodes, place: DVec3, start: Start) -> Option<u32> {
        let through = |node: u32| self.steps[node as usize].0 + place.distance(nodes.positions[node as usize]);
        let seen = nodes.seen_from(mesh, medium, place, start, f64::INFINITY).into_iter();
        let mut best = seen.map(|node| (through(node), node)).min_by(|a, b| a.0.total_cmp(&b.0));
        let may_enter = |tetrahedron: u32| medium.cost(tetrahedron).is_finite();
        for (number, source) in (nodes.positions.len() as u32..).zip(&self.sources) {
            let there = source.point.position(mesh);
            let straight = source.initial_distance + place.distance(there);
            if best.is_none_or(|(least, _)| straight < least)
                && medium.sight(mesh).walk(start, [place, there], may_enter, |_| Crossing::On).is_some()
            {
                best = Some((straight, number));
            }
        }
        best.filter(|(distance, _)| distance.is_finite()).map(|(_, by)| by)
    }
}
