//! Places that paths may bend at in riddled meshes.

use std::sync::OnceLock;

use crate::corner::Corner;
use crate::lists::Lists;
use crate::mesh::{Start, TetMesh};

/// Places on edges are about in the middle, within this share of the edge: lines between the very middles of the edges around a
/// quadrilateral have equal lengths, and of two ways that are equally long one would be taken there and the other one back.
const SPREAD: f64 = 0.1;

/// Its multiples, less their whole parts, are spread evenly, and no two are one.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Places that paths may bend at, and which of them see each other.
#[derive(Debug)]
pub(super) struct Nodes {
    /// The vertices, and after them a place on each sharp edge. More of these would make better first guesses; where on an edge a path
    /// bends, [pulling](super::taut::pull) finds by itself.
    pub(super) corners: Vec<Corner>,
    /// Of each vertex, itself and the places on the edges that it is the first end of.
    pub(super) of_vertex: Lists,
    /// Of each node, those that it sees among those tried; made by the first search, none where that would be too much work.
    pub(super) seen: OnceLock<Option<Lists>>,
}

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
        let count = mesh.vertex_count() as u32;
        let places = || (count..).zip(edges).map(|(node, &[first, _])| (first, node));
        let of_vertex = Lists::group(mesh.vertex_count(), || (0..count).map(|vertex| (vertex, vertex)).chain(places()));
        Self { corners, of_vertex, seen: OnceLock::new() }
    }
}
