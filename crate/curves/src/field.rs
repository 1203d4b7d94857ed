//! A surface with a distance at each vertex, and which of its triangles are neighbors.

use std::sync::Arc;

use glam::DVec3;
use heatwalk_surface::triangle;

use crate::error::{Error, Result};
use crate::levels::{Levels, SAME_DISTANCE};

/// In place of a half-edge: there is none.
pub(crate) const NONE: u32 = u32::MAX;

/// A triangle surface with a value at each vertex, which is linear on each triangle.
///
/// Half-edge `3 f + k` leads from corner `k` of triangle `f` to the next. Triangles are neighbors where an edge has two of
/// them and they agree in orientation; at a boundary, where three meet or where orientations differ, curves end.
#[derive(Debug, Clone)]
pub struct Field {
    mesh: Arc<Mesh>,
    distances: Vec<f64>,
}

#[derive(Debug)]
struct Mesh {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    edges: Edges,
}

impl Field {
    /// `positions` (`#V × 3`) and `distances` (`#V`) are in one unit, infinite where nothing leads; `triangles` (`#F × 3`)
    /// are counter-clockwise seen from outside.
    ///
    /// # Errors
    /// [`Error::CountMismatch`], [`Error::IndexOutOfRange`], [`Error::NotANumber`].
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>, distances: Vec<f64>) -> Result<Self> {
        let vertices = positions.len();
        if distances.len() != vertices {
            return Err(Error::CountMismatch { vertices, distances: distances.len() });
        }
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(Error::NotANumber { vertex, what: "position" });
        }
        if let Some(vertex) = distances.iter().position(|distance| distance.is_nan()) {
            return Err(Error::NotANumber { vertex, what: "distance" });
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(vertex) = corners.iter().map(|&corner| corner as usize).find(|&vertex| vertex >= vertices) {
                return Err(Error::IndexOutOfRange { triangle, vertex, vertices });
            }
        }
        Ok(Self { mesh: Arc::new(Mesh { edges: Edges::of(&triangles), positions, triangles }), distances })
    }

    /// The same with distances that are a level's up to rounding at that level: beyond it is then nothing of no width.
    pub(crate) fn at_levels(&self, levels: &Levels) -> Self {
        let finite = self.distances.iter().copied().filter(|distance| distance.is_finite());
        let tolerance = SAME_DISTANCE * finite.fold(0.0, |largest, distance| distance.abs().max(largest));
        let values = levels.values();
        let at_level = |&distance: &f64| {
            let above = values.partition_point(|&value| value < distance);
            let beside = values[above.saturating_sub(1)..].iter().take(2).copied();
            let nearest = beside.min_by(|a, b| (a - distance).abs().total_cmp(&(b - distance).abs()));
            nearest.filter(|value| (value - distance).abs() <= tolerance).unwrap_or(distance)
        };
        Self { mesh: Arc::clone(&self.mesh), distances: self.distances.iter().map(at_level).collect() }
    }

    /// `#V × 3`.
    pub fn positions(&self) -> &[DVec3] {
        &self.mesh.positions
    }

    /// `#F × 3`.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.mesh.triangles
    }

    /// `#V`.
    pub fn distances(&self) -> &[f64] {
        &self.distances
    }

    /// The largest finite distance; 0 where there is none.
    pub fn largest(&self) -> f64 {
        self.distances.iter().copied().filter(|distance| distance.is_finite()).fold(0.0, f64::max)
    }

    pub(crate) fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.mesh.triangles[triangle].map(|corner| self.mesh.positions[corner as usize])
    }

    /// The distances at the corners; none where one is infinite.
    pub(crate) fn corner_distances(&self, triangle: usize) -> Option<[f64; 3]> {
        let distances = self.mesh.triangles[triangle].map(|corner| self.distances[corner as usize]);
        distances.iter().all(|distance| distance.is_finite()).then_some(distances)
    }

    /// The vertices that a half-edge leaves and enters.
    pub(crate) fn ends(&self, halfedge: usize) -> [usize; 2] {
        let corners = self.mesh.triangles[halfedge / 3];
        let k = halfedge % 3;
        [corners[k] as usize, corners[(k + 1) % 3] as usize]
    }

    pub(crate) fn twin(&self, halfedge: usize) -> Option<usize> {
        self.mesh.edges.twin(halfedge)
    }

    /// The longest edge of the triangles that have such a vertex.
    pub fn longest_edge(&self, has: impl Fn(u32) -> bool) -> f64 {
        let chosen = (0..self.mesh.triangles.len()).filter(|&index| self.mesh.triangles[index].into_iter().any(&has));
        chosen.map(|index| longest(self.corners(index))).fold(0.0, f64::max)
    }

    pub(crate) fn edges(&self) -> &Edges {
        &self.mesh.edges
    }

    /// Where an edge is at a value: one end is below it, and the other is not. The same point from both sides, to the last
    /// bit, for it is always found from the end below.
    pub(crate) fn crossing(&self, halfedge: usize, value: f64) -> DVec3 {
        let ([below, above], share) = self.share_to_crossing(halfedge, value);
        let [below, above] = [below, above].map(|vertex| self.mesh.positions[vertex as usize]);
        if share == 1.0 { above } else { below.lerp(above, share) }
    }

    /// The ends of that edge, the one below first, and which share of the way between them it is.
    pub(crate) fn share_to_crossing(&self, halfedge: usize, value: f64) -> ([u32; 2], f64) {
        let [a, b] = self.ends(halfedge);
        let (below, above) = if self.distances[a] < value { (a, b) } else { (b, a) };
        let (low, high) = (self.distances[below], self.distances[above]);
        // Halves first: the difference of two large numbers may be none.
        let share = (0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low);
        ([below as u32, above as u32], share)
    }
}

/// By how much more than along an edge a distance may change there, as a share of it, by rounding.
const JUMP: f64 = 1e-6;

/// Whether a distance with a sign goes on within a triangle: beyond the ends of curves it jumps from positive to negative. `corners` and
/// `values` are in one unit; what is not reached is no jump.
pub fn is_continuous(corners: [DVec3; 3], values: [f64; 3]) -> bool {
    [(0, 1), (1, 2), (2, 0)].into_iter().all(|(a, b)| {
        let change = (values[a] - values[b]).abs();
        !change.is_finite() || change <= corners[a].distance(corners[b]) * (1.0 + JUMP)
    })
}

/// The longest edge of a triangle.
pub(crate) fn longest([a, b, c]: [DVec3; 3]) -> f64 {
    [b - a, c - b, a - c].map(triangle::length).into_iter().fold(0.0, f64::max)
}

/// Which half-edges lie on the same edge.
#[derive(Debug, Clone)]
pub(crate) struct Edges {
    /// `3 #F`, the half-edge on the other side; [`NONE`] where there is no one neighbor.
    others: Vec<u32>,
    /// `3 #F`, whether that leads the same way: the neighbor is oriented otherwise.
    is_turned: Vec<bool>,
    /// `3 #F`, the edge of each half-edge; an edge is a pair of vertices.
    numbers: Vec<u32>,
    count: usize,
}

impl Edges {
    /// The half-edge on the other side of an edge of two triangles that agree in orientation.
    pub(crate) fn twin(&self, halfedge: usize) -> Option<usize> {
        self.other(halfedge).filter(|_| !self.is_turned[halfedge])
    }

    /// The same where they need not agree.
    pub(crate) fn other(&self, halfedge: usize) -> Option<usize> {
        Some(self.others[halfedge]).filter(|&other| other != NONE).map(|other| other as usize)
    }

    /// Whether the neighbor across a half-edge is oriented otherwise.
    pub(crate) fn is_turned(&self, halfedge: usize) -> bool {
        self.is_turned[halfedge]
    }

    /// The edge that a half-edge lies on, counted from 0.
    pub(crate) fn number(&self, halfedge: usize) -> usize {
        self.numbers[halfedge] as usize
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    pub(crate) fn of(triangles: &[[u32; 3]]) -> Self {
        let ends = |halfedge: usize| {
            let (corners, k) = (triangles[halfedge / 3], halfedge % 3);
            (corners[k], corners[(k + 1) % 3])
        };
        let sorted_ends = |halfedge: u32| {
            let (a, b) = ends(halfedge as usize);
            (a.min(b), a.max(b))
        };
        let mut order: Vec<u32> = (0..3 * triangles.len() as u32).collect();
        order.sort_by_key(|&halfedge| (sorted_ends(halfedge), halfedge));
        let mut others = vec![NONE; order.len()];
        let mut is_turned = vec![false; order.len()];
        let mut numbers = vec![0; order.len()];
        let mut count = 0;
        for group in order.chunk_by(|&a, &b| sorted_ends(a) == sorted_ends(b)) {
            group.iter().for_each(|&halfedge| numbers[halfedge as usize] = count);
            count += 1;
            if let &[a, b] = group {
                (others[a as usize], others[b as usize]) = (b, a);
                group.iter().for_each(|&halfedge| is_turned[halfedge as usize] = ends(a as usize) == ends(b as usize));
            }
        }
        Self { others, is_turned, numbers, count: count as usize }
    }
}
