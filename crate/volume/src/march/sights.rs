//! Distance in riddled meshes: shortest paths over lines of sight between the places that paths may bend at (Dijkstra 1959).
//!
//! Who sees whom is the same from both ends, and so are the shortest paths over lines of sight. Those that end at a vertex are pulled
//! taut, from the same one of their ends whichever was the source. So every distance is the length of a path inside, not above any along
//! edges, and the same there and back: what a march of waves cannot promise where most of them are in the way of something before
//! they come to a vertex.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::medium::{AROUND, Medium};
use super::nodes::Nodes;
use super::taut::{length_of, pull};
use crate::corner::Corner;
use crate::lists::Lists;
use crate::mesh::{NONE, Start, TetMesh};
use crate::point::{TetPoint, TetSource};

/// A distance replaces another if it is below it by this share: what is less is rounding, which depends on the order of sums.
const GAIN: f64 = 1e-12;

/// Nodes that each is tried to see, at most, in the order of steps along edges to them. What is farther away than so many is seen over
/// others in between, and [pulling](pull) leaves those out. Where there are fewer nodes, all are tried.
const TRIED: usize = 200;

/// Faces that are passed for each node to see which of them see each other, at most, and in all where the mesh is small. Where that is not
/// enough, lines go through many flat tetrahedra or along places of many, and waves, which stop earlier, come as far.
const MOST_PASSED: usize = 8192;
const LEAST_PASSED: usize = 16_000_000;

/// Corners of all paths that are pulled, for each node, at most: each is looked at many times.
const MOST_CORNERS: usize = 64;
const LEAST_CORNERS: usize = 100_000;

impl Nodes {
    /// Of each node, those that it sees; none where that would be too much work.
    pub(super) fn seen(&self, mesh: &TetMesh, medium: &Medium) -> Option<&Lists> {
        let see = || {
            let count = self.corners.len();
            let most = (MOST_PASSED * count).max(LEAST_PASSED);
            let mut passed = 0;
            let mut pairs: Vec<[u32; 2]> = Vec::new();
            let mut last = vec![NONE; mesh.vertex_count()];
            for node in 0..count as u32 {
                let near = self.near(mesh, medium, node, &mut last, &mut passed);
                pairs.extend(near.into_iter().map(|other| [node.min(other), node.max(other)]));
                if passed > most {
                    return None;
                }
            }
            pairs.sort_unstable();
            pairs.dedup();
            // From the same end whichever asks.
            let mut seen: Vec<[u32; 2]> = Vec::with_capacity(pairs.len());
            for ends in pairs.into_iter().filter(|[a, b]| a != b) {
                if medium.sees_in(mesh, ends.map(|node| self.corners[node as usize]), &mut passed) {
                    seen.push(ends);
                }
                if passed > most {
                    return None;
                }
            }
            Some(Lists::group(count, || seen.iter().flat_map(|&[a, b]| [(a, b), (b, a)])))
        };
        self.seen.get_or_init(see).as_ref()
    }

    /// The nodes that one is tried to see. `last` keeps for which node each vertex was last come to; what is looked at counts as `passed`.
    fn near(&self, mesh: &TetMesh, medium: &Medium, node: u32, last: &mut [u32], passed: &mut usize) -> Vec<u32> {
        let mut vertices = match self.corners[node as usize].start {
            Start::Edge(ends) => ends.to_vec(),
            _ => vec![node],
        };
        vertices.iter().for_each(|&vertex| last[vertex as usize] = node);
        let ends = vertices.len();
        let mut near = Vec::with_capacity(TRIED);
        let (mut next, mut neighbors) = (0, 0);
        // All neighbors along edges, so that no distance is above the way along those.
        while next < vertices.len() && (next < neighbors || near.len() < TRIED) {
            let vertex = vertices[next];
            near.extend(self.of_vertex.row(vertex));
            let touching = medium.touching(mesh, self.corners[vertex as usize]);
            *passed += touching.len() / AROUND;
            for tetrahedron in touching {
                for other in mesh.tetrahedra()[tetrahedron as usize] {
                    if last[other as usize] != node {
                        last[other as usize] = node;
                        vertices.push(other);
                    }
                }
            }
            next += 1;
            if next == ends {
                neighbors = vertices.len();
            }
        }
        near
    }
}

/// A search in work.
pub(crate) struct Sights<'a> {
    mesh: &'a TetMesh,
    medium: &'a Medium,
    nodes: &'a Nodes,
    tree: Tree,
    seen: &'a Lists,
    offers: BinaryHeap<Reverse<(u64, u32)>>,
    /// Of each node, whether its distance is final.
    is_final: Vec<bool>,
    /// Offers that were taken.
    work: usize,
}

/// Shortest paths over lines of sight.
#[derive(Debug, Clone)]
pub(crate) struct Tree {
    sources: Vec<TetSource>,
    /// Of each node its distance, and the node before; the number of a source comes after those of nodes. None where infinite.
    steps: Vec<(f64, u32)>,
    /// Of each vertex, whether it sees its source; none before the search has ended.
    is_straight: Vec<bool>,
}

impl<'a> Sights<'a> {
    /// None where it would be too much work.
    pub(super) fn new(mesh: &'a TetMesh, medium: &'a Medium, nodes: &'a Nodes, sources: &[TetSource]) -> Option<Self> {
        let seen = nodes.seen(mesh, medium)?;
        let count = nodes.corners.len();
        let tree =
            Tree { sources: sources.to_vec(), steps: vec![(f64::INFINITY, NONE); count], is_straight: Vec::new() };
        let (offers, is_final) = (BinaryHeap::new(), vec![false; count]);
        let mut search = Self { mesh, medium, nodes, tree, seen, offers, is_final, work: 0 };
        for (by, source) in (count as u32..).zip(sources) {
            search.start(source, by);
        }
        Some(search)
    }

    /// Offers the distance of a source that is a node, or of all nodes that see another one.
    fn start(&mut self, source: &TetSource, by: u32) {
        let from = source.point.corner(self.mesh);
        let nodes = match source.point {
            TetPoint::Vertex(vertex) => vertex.0..vertex.0 + 1,
            TetPoint::Inside { .. } => 0..self.nodes.corners.len() as u32,
        };
        for node in nodes {
            if self.medium.sees(self.mesh, [from, self.nodes.corners[node as usize]]) {
                self.offer(source.initial_distance, from, node, by);
            }
        }
    }

    /// As [`super::March::advance`].
    pub(super) fn advance(&mut self, radius: f64, work: usize) -> f64 {
        while let Some(&Reverse((bits, node))) = self.offers.peek() {
            let distance = f64::from_bits(bits);
            if distance >= radius || self.work >= work {
                return distance.min(radius);
            }
            self.offers.pop();
            if !std::mem::replace(&mut self.is_final[node as usize], true) {
                let from = self.nodes.corners[node as usize];
                for &other in self.seen.row(node) {
                    self.offer(distance, from, other, node);
                }
            }
        }
        f64::INFINITY
    }

    /// Offers a node its distance over a place at this distance that it sees.
    fn offer(&mut self, distance: f64, from: Corner, node: u32, by: u32) {
        let through = distance + from.place.distance(self.nodes.corners[node as usize].place);
        let step = &mut self.tree.steps[node as usize];
        if through < step.0 * (1.0 - GAIN) {
            *step = (through, by);
            self.offers.push(Reverse((through.to_bits(), node)));
            self.work += 1;
        }
    }

    /// The distances of vertices (`#V`), the paths, and whether the distances are those of pulled paths: not where that would be too much
    /// work.
    pub(super) fn finish(self) -> (Vec<f64>, Tree, bool) {
        let Self { mesh, medium, nodes, mut tree, is_final, .. } = self;
        for (step, _) in tree.steps.iter_mut().zip(is_final).filter(|&(_, is_final)| !is_final) {
            *step = (f64::INFINITY, NONE);
        }
        let steps = &tree.steps[..mesh.vertex_count()];
        let is_pulled = tree.corners() <= (MOST_CORNERS * nodes.corners.len()).max(LEAST_CORNERS);
        let found = |(&from, &(distance, by)): (&Corner, &(f64, u32))| {
            if !is_pulled {
                return (distance, by as usize >= nodes.corners.len());
            }
            let path = distance.is_finite().then(|| tree.path(mesh, medium, nodes, from)).flatten();
            path.map_or((f64::INFINITY, false), |(distance, path)| (distance, path.len() <= 2))
        };
        let (distances, is_straight) = nodes.corners[..steps.len()].iter().zip(steps).map(found).unzip();
        tree.is_straight = is_straight;
        (distances, tree, is_pulled)
    }
}

impl Tree {
    /// How many corners the paths of all nodes have together.
    fn corners(&self) -> usize {
        let mut order: Vec<u32> = (0..self.steps.len() as u32).collect();
        order.retain(|&node| self.steps[node as usize].0.is_finite());
        order.sort_unstable_by(|&a, &b| self.steps[a as usize].0.total_cmp(&self.steps[b as usize].0));
        let mut corners = vec![0; self.steps.len()];
        for node in order {
            let (_, by) = self.steps[node as usize];
            corners[node as usize] = 1 + corners.get(by as usize).copied().unwrap_or(0_usize);
        }
        corners.into_iter().sum()
    }

    /// Whether a vertex has its distance straight from a source.
    pub(super) fn is_straight(&self, vertex: u32) -> bool {
        self.is_straight[vertex as usize]
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
        let mut next = self.first_step(mesh, medium, nodes, from)?;
        while (next as usize) < nodes.corners.len() {
            path.push(nodes.corners[next as usize]);
            next = self.steps[next as usize].1;
        }
        let source = self.sources[next as usize - nodes.corners.len()];
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

    /// The node or source that a place has its distance by: a source that it sees, or else, of a vertex, the one found by the search, and
    /// of other places the nearest over what they see.
    fn first_step(&self, mesh: &TetMesh, medium: &Medium, nodes: &Nodes, from: Corner) -> Option<u32> {
        let sees = |there: Corner| medium.sees(mesh, [from, there]);
        let through = |distance: f64, there: Corner| distance + from.place.distance(there.place);
        let mut nearest = (f64::INFINITY, NONE);
        match from.start {
            Start::Vertex(vertex) => nearest = self.steps[vertex as usize],
            _ => {
                for (node, (&there, &(distance, _))) in (0..).zip(nodes.corners.iter().zip(&self.steps)) {
                    let distance = through(distance, there);
                    if distance < nearest.0 * (1.0 - GAIN) && sees(there) {
                        nearest = (distance, node);
                    }
                }
            }
        }
        for (by, source) in (nodes.corners.len() as u32..).zip(&self.sources) {
            let there = source.point.corner(mesh);
            let distance = through(source.initial_distance, there);
            if distance < nearest.0 * (1.0 - GAIN) && sees(there) {
                nearest = (distance, by);
            }
        }
        nearest.0.is_finite().then_some(nearest.1)
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use std::f64::consts::TAU;

    use glam::{DMat3, DVec3};
    use heatwalk::VertexId;

    use super::*;
    use crate::march::March;
    use crate::soup::TetSoup;

    /// A prism that turns by so much, in radians, cut across into flat ones, of three tetrahedra each.
    fn twisted_slices(slices: u32, turn: f64) -> TetSoup {
        let positions = (0..=slices).flat_map(|slice| {
            let z = f64::from(slice) / f64::from(slices);
            let turned = DMat3::from_rotation_z(turn * z);
            [DVec3::ZERO, DVec3::X, DVec3::Y].map(|corner| turned * corner + z * DVec3::Z)
        });
        let tetrahedra = (0..slices).flat_map(|slice| {
            let [a, b, c, d, e, f] = [0, 1, 2, 3, 4, 5].map(|k| 3 * slice + k);
            [[a, b, c, d], [b, c, d, e], [c, d, e, f]]
        });
        TetSoup { positions: positions.collect(), tetrahedra: tetrahedra.collect() }
    }

    /// Tetrahedra around a vertex, whose rim goes up and down, so that paths bend around its lower corners.
    fn waves_around_vertex(count: u32) -> TetSoup {
        let rim = (0..count).map(|corner| {
            let (y, x) = (TAU * f64::from(corner) / f64::from(count)).sin_cos();
            DVec3::new(x, 0.0, y) * if corner % 2 == 0 { 0.5 } else { 1.0 }
        });
        let positions = [DVec3::Y].into_iter().chain(rim).chain([DVec3::NEG_Y, DVec3::ZERO]).collect();
        let (below, middle) = (count + 1, count + 2);
        let around = |corner: u32| {
            let next = corner % count + 1;
            [[middle, 0, next, corner], [middle, below, corner, next]]
        };
        TetSoup { positions, tetrahedra: (1..=count).flat_map(around).collect() }
    }

    /// `#V`, the ways along edges from a vertex, by relaxing all edges until none is shorter.
    fn along_edges(mesh: &TetMesh, from: usize) -> Vec<f64> {
        let mut ways = vec![f64::INFINITY; mesh.vertex_count()];
        ways[from] = 0.0;
        let mut changed = vec![from as u32];
        while let Some(here) = changed.pop() {
            for &other in mesh.adjacent().row(here) {
                let [a, b] = [here, other].map(|end| mesh.positions()[end as usize]);
                let way = ways[here as usize] + a.distance(b);
                if way < ways[other as usize] * (1.0 - 1e-13) {
                    ways[other as usize] = way;
                    changed.insert(0, other);
                }
            }
        }
        ways
    }

    /// Of a search from vertex 1 in a riddled mesh, whether paths are pulled; none where to see who sees whom is too much work. Whichever it is,
    /// no distance is above the way along edges or below the straight line.
    fn is_pulled(soup: &TetSoup) -> Option<bool> {
        let mesh = TetMesh::build(soup).unwrap();
        let medium = Medium::new(&mesh, None).unwrap();
        let sources = [TetPoint::Vertex(VertexId(1)).into()];
        let found = March::new(&mesh, &medium, &sources).within(f64::INFINITY);
        let edges = along_edges(&mesh, 1);
        for (to, (&value, along)) in mesh.positions().iter().zip(found.distances.iter().zip(edges)) {
            let straight = mesh.positions()[1].distance(*to);
            assert!(value >= straight * (1.0 - 1e-12) && value <= along * (1.0 + 1e-12), "{straight} {value} {along}");
        }
        let mut search = Sights::new(&mesh, &medium, medium.nodes().expect("a riddled mesh"), &sources)?;
        search.advance(f64::INFINITY, usize::MAX);
        let (_, _, is_pulled) = search.finish();
        assert_eq!(found.exact_below, if is_pulled { f64::INFINITY } else { 0.0 });
        Some(is_pulled)
    }

    #[test]
    fn what_would_be_too_much_work_is_left_out() {
        assert_eq!(is_pulled(&twisted_slices(100, 3.0 * TAU)), Some(true));
        assert_eq!(is_pulled(&twisted_slices(1000, 150.0 * TAU)), Some(false), "paths have many corners");
        assert_eq!(is_pulled(&waves_around_vertex(1000)), None, "vertices touch many tetrahedra");
    }
}
