//! Cracks: boundaries that run along each other a little apart, where a surface was cut, or exported patch by patch.
//!
//! Boundary vertices that are nearest to each other become one where that closes a crack: where edges that bound the surface on
//! both sides of it come together (Barequet & Kumar, "Repairing CAD models", 1997, section 4, match boundary edges too). No
//! vertex moves farther than its triangles allow, and none that is not on a boundary moves at all.

mod reach;
mod rule;

pub use rule::WeldRule;

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;
use heatwalk_base::csr::NONE;
use heatwalk_base::sort;

use crate::edges::{Corners, Edges};
use crate::element::{Element, HalfedgeId, VertexId};
use crate::triangle::{area_vector, length, unit};
use reach::Reaching;

/// Cracks no wider than this share of the diagonal of the bounding box are closed if nothing else is said.
const AUTOMATIC: f64 = 1e-4;

/// No vertex moves farther than this share of the least altitude of the triangles at it, so that none collapses or turns over.
const OF_ALTITUDE: f64 = 0.05;

/// Triangles on the same side of an edge, with more than this cosine between them (6°), are layers, as a decal is on a wall, and
/// not the two sides of a crack. 6° is what a vertex of each that moves by [`OF_ALTITUDE`] tilts them.
const LAYERED: f64 = 0.9945;

/// Vertices of layers stay where they are, and what is left is matched again, so many times at most: where layers cover layers
/// that cover cracks, the last of these stay open.
const MOST_ROUNDS: u32 = 8;

/// What closes the cracks of a triangle list.
pub struct Closed {
    /// `#V`, the vertex that each becomes: itself, or an earlier one.
    pub target: Vec<u32>,
    /// How many become an earlier one.
    pub count: usize,
    /// How far the farthest of them moves.
    pub width: f64,
}

/// A triangle list without duplicate and degenerate triangles.
pub struct Triangles<'a> {
    pub positions: &'a [DVec3],
    pub faces: &'a [[VertexId; 3]],
    pub edges: &'a Edges,
    pub corners: &'a Corners,
}

impl Triangles<'_> {
    /// What closes the cracks; none where there are no cracks that the rule closes.
    pub fn closed(&self, rule: WeldRule) -> Option<Closed> {
        let halfedges = (0..3 * self.faces.len() as u32).map(HalfedgeId);
        let boundary: Vec<HalfedgeId> = match rule {
            WeldRule::Exact => return None,
            _ => halfedges.filter(|&halfedge| self.edges.is_single(halfedge)).collect(),
        };
        if boundary.is_empty() {
            return None;
        }
        let rims = Rims::new(self, &boundary, rule)?;
        let target = rims.targets()?;
        let moved = (0..).zip(&target).filter(|&(vertex, &target)| vertex != target);
        let width =
            |(vertex, &target): (u32, &u32)| length(self.positions[vertex as usize] - self.positions[target as usize]);
        let widths: Vec<f64> = moved.map(width).collect();
        Some(Closed { count: widths.len(), width: widths.into_iter().fold(0.0, f64::max), target })
    }

    fn ends(&self, halfedge: HalfedgeId) -> [u32; 2] {
        let (face, k) = (self.faces[halfedge.triangle().index()], halfedge.corner());
        [face[k].0, face[(k + 1) % 3].0]
    }

    /// The side of an edge where its triangle lies: a unit vector at right angles to the edge.
    fn side(&self, halfedge: HalfedgeId) -> DVec3 {
        let [start, end] = self.ends(halfedge).map(|vertex| self.positions[vertex as usize]);
        let face = self.faces[halfedge.triangle().index()].map(|vertex| self.positions[vertex.index()]);
        unit(area_vector(face)).cross(unit(end - start))
    }
}

/// The boundaries of a triangle list. Lengths are shares of the diagonal of the bounding box.
struct Rims<'a> {
    triangles: &'a Triangles<'a>,
    halfedges: &'a [HalfedgeId],
    /// The boundary vertices, ascending.
    vertices: Vec<u32>,
    /// `#vertices`
    points: Vec<DVec3>,
    /// `#vertices`, how far each may move.
    reach: Vec<f64>,
    /// `#halfedges`, the ends of each by their places in `vertices`.
    ends: Vec<[u32; 2]>,
}

impl<'a> Rims<'a> {
    fn new(triangles: &'a Triangles<'a>, halfedges: &'a [HalfedgeId], rule: WeldRule) -> Option<Self> {
        let positions = triangles.positions;
        let bound = |by: fn(DVec3, DVec3) -> DVec3| positions.iter().copied().reduce(by);
        let (low, high) = (bound(DVec3::min)?, bound(DVec3::max)?);
        // Halves, so that what is as large as numbers can be does not overflow.
        let half_diagonal = length(0.5 * high - 0.5 * low);
        let half_centre = 0.25 * high + 0.25 * low;
        let point = |vertex: u32| (0.5 * positions[vertex as usize] - half_centre) / half_diagonal;
        let widest = match rule {
            WeldRule::Exact => 0.0,
            WeldRule::Automatic => AUTOMATIC,
            WeldRule::Within(width) => 0.5 * (width / half_diagonal),
        };
        let mut vertices: Vec<u32> = halfedges.iter().flat_map(|&halfedge| triangles.ends(halfedge)).collect();
        sort::sort(&mut vertices);
        vertices.dedup();
        let mut place = vec![NONE; positions.len()];
        for (&vertex, number) in vertices.iter().zip(0..) {
            place[vertex as usize] = number;
        }
        let altitude = |&corner: &HalfedgeId| {
            let face = triangles.faces[corner.triangle().index()].map(|vertex| point(vertex.0));
            let longest = [0, 1, 2].map(|k| face[k].distance(face[(k + 1) % 3])).into_iter().fold(0.0, f64::max);
            if longest > 0.0 { area_vector(face).length() / longest } else { 0.0 }
        };
        let reach = |&vertex: &u32| {
            let altitudes = triangles.corners.row(VertexId(vertex)).iter().map(altitude);
            (OF_ALTITUDE * altitudes.fold(f64::INFINITY, f64::min)).min(widest)
        };
        Some(Self {
            triangles,
            halfedges,
            points: vertices.iter().map(|&vertex| point(vertex)).collect(),
            reach: vertices.iter().map(reach).collect(),
            ends: halfedges.iter().map(|&halfedge| triangles.ends(halfedge).map(|end| place[end as usize])).collect(),
            vertices,
        })
    }

    /// `#V`, the vertex that each vertex becomes; none where each stays itself.
    fn targets(mut self) -> Option<Vec<u32>> {
        let mut round = 1;
        loop {
            let cluster = self.clusters();
            let mut matched = self.matched(&cluster);
            let layered = self.layered(&matched);
            if layered.is_empty() || round == MOST_ROUNDS {
                matched.retain(|edge| self.ends_of(edge).all(|end| layered.binary_search(&end).is_err()));
                return self.closing(&cluster, &matched);
            }
            for vertex in layered {
                self.reach[vertex as usize] = 0.0;
            }
            round += 1;
        }
    }

    /// `#vertices`, the least number of those that each becomes one with. The two that are nearest to each other of all become
    /// one, then the nearest two of those that are left, and so on; none is farther from the one that it becomes than it may move.
    fn clusters(&self) -> Vec<u32> {
        let mut cluster: Vec<u32> = (0..self.vertices.len() as u32).collect();
        let mut left = Reaching::new(&self.points, &self.reach);
        let pair = |left: &Reaching, vertex: u32| {
            let (other, gap) = left.nearest(vertex)?;
            // Of numbers that are not negative, the bits are in the order of the numbers.
            Some(Reverse((gap.to_bits(), vertex.min(other), vertex.max(other), vertex)))
        };
        let mut waiting: BinaryHeap<_> = left.points().iter().filter_map(|&vertex| pair(&left, vertex)).collect();
        while let Some(Reverse((gap, first, second, vertex))) = waiting.pop() {
            let gap = f64::from_bits(gap);
            let least = left.reach(first).min(left.reach(second));
            // As reaches only become shorter, what still is within them is the nearest still.
            if gap <= least {
                cluster[second as usize] = first;
                left.remove(second);
                // What was moved here before may move so much less.
                left.shorten(first, least - gap);
            }
            waiting.extend(pair(&left, vertex));
        }
        // The one that each became is an earlier one, which is in its cluster already.
        for vertex in 0..cluster.len() {
            cluster[vertex] = cluster[cluster[vertex] as usize];
        }
        cluster
    }

    /// The half-edges, by their places, that come to lie on one edge, for each edge of several.
    fn matched(&self, cluster: &[u32]) -> Vec<Vec<u32>> {
        let key = |ends: [u32; 2]| {
            let [a, b] = ends.map(|end| cluster[end as usize]);
            [a.min(b), a.max(b)]
        };
        let mut keys: Vec<([u32; 2], u32)> = self.ends.iter().map(|&ends| key(ends)).zip(0..).collect();
        sort::sort(&mut keys);
        let edges = keys.chunk_by(|a, b| a.0 == b.0).filter(|edge| edge.len() > 1);
        edges.map(|edge| edge.iter().map(|&(_, halfedge)| halfedge).collect()).collect()
    }

    /// The ends of half-edges.
    fn ends_of<'e>(&'e self, edge: &'e [u32]) -> impl Iterator<Item = u32> + 'e {
        edge.iter().flat_map(|&halfedge| self.ends[halfedge as usize])
    }

    /// The ends of matched half-edges whose triangles are layers, ascending.
    fn layered(&self, matched: &[Vec<u32>]) -> Vec<u32> {
        let side = |&halfedge: &u32| self.triangles.side(self.halfedges[halfedge as usize]);
        let mut layered = Vec::new();
        for edge in matched {
            let sides: Vec<DVec3> = edge.iter().map(side).collect();
            let is_layered = |k: usize| sides[..k].iter().any(|other| other.dot(sides[k]) > LAYERED);
            if (1..sides.len()).any(is_layered) {
                layered.extend(self.ends_of(edge));
            }
        }
        sort::sort(&mut layered);
        layered.dedup();
        layered
    }

    /// `#V`, the vertex that each vertex becomes, where only ends of matched half-edges become another.
    fn closing(&self, cluster: &[u32], matched: &[Vec<u32>]) -> Option<Vec<u32>> {
        if matched.is_empty() {
            return None;
        }
        let mut is_end = vec![false; self.vertices.len()];
        for end in matched.iter().flat_map(|edge| self.ends_of(edge)) {
            is_end[end as usize] = true;
        }
        let mut target: Vec<u32> = (0..self.triangles.positions.len() as u32).collect();
        // The least vertex of each cluster that stays.
        let mut least = vec![NONE; self.vertices.len()];
        for (place, _) in is_end.iter().enumerate().filter(|&(_, &is_end)| is_end) {
            let least = &mut least[cluster[place] as usize];
            if *least == NONE {
                *least = self.vertices[place];
            }
            target[self.vertices[place] as usize] = *least;
        }
        Some(target)
    }
}
