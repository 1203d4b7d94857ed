//! Places that shortest paths may bend at where a mesh is riddled: its vertices, and places on the edges that they bend around.

use std::sync::OnceLock;

use glam::DVec3;

use super::cone::Cone;
use super::medium::Medium;
use crate::lists::Lists;
use crate::mesh::locate::{GRAZING, weights};
use crate::mesh::{EDGES, FACES, NONE, Start, TetId, TetMesh};

/// Places on each concave edge, evenly apart. One takes the errors of a march over vertices to a fourth; what is left is that
/// another place would be better, which [pulling](crate::path) finds by itself.
const ON_EDGE: usize = 1;

/// Pairs of nodes that may see each other, at most: about 100 MB. Where there would be more, nodes see only what is as near as that
/// allows where they are spread evenly over the box of the mesh.
const PAIRS: f64 = (1 << 25) as f64;

/// Vertices, and places on edges after them.
#[derive(Debug)]
pub(super) struct Nodes {
    /// Where they are.
    pub(super) positions: Vec<DVec3>,
    /// Of each place that is no vertex, the ends of its edge.
    edges: Vec<[u32; 2]>,
    /// `#T`, places on the edges of each tetrahedron.
    of_tetrahedron: Lists,
    /// Of each node those that it sees within the reach, ascending, once it was asked.
    seen: Vec<OnceLock<Vec<u32>>>,
    reach: f64,
}

impl Nodes {
    /// With places on these edges, whose ends ascend, in ascending order.
    pub(super) fn new(mesh: &TetMesh, edges: &[[u32; 2]]) -> Self {
        let vertices = mesh.vertex_count();
        let mut positions = mesh.positions().to_vec();
        for [a, b] in edges.iter().map(|ends| ends.map(|end| mesh.positions()[end as usize])) {
            positions.extend((1..=ON_EDGE).map(|place| a.lerp(b, place as f64 / (ON_EDGE + 1) as f64)));
        }
        let mut places: Vec<(u32, u32)> = Vec::new();
        for (tetrahedron, corners) in (0..).zip(mesh.tetrahedra()) {
            for ends in EDGES.map(|ends| ends.map(|corner| corners[corner])) {
                if let Ok(edge) = edges.binary_search(&[ends[0].min(ends[1]), ends[0].max(ends[1])]) {
                    let first = vertices + edge * ON_EDGE;
                    places.extend((first..first + ON_EDGE).map(|place| (tetrahedron, place as u32)));
                }
            }
        }
        let (low, high) = mesh.bounds();
        let share = PAIRS / (positions.len() as f64).powi(2);
        Self {
            edges: edges.to_vec(),
            of_tetrahedron: Lists::group(mesh.tetrahedron_count(), || places.iter().copied()),
            seen: vec![OnceLock::new(); positions.len()],
            reach: if share >= 1.0 { f64::INFINITY } else { 0.5 * share.cbrt() * (high - low).max_element() },
            positions,
        }
    }

    /// Where in the mesh a node is.
    pub(super) fn start(&self, node: u32) -> Start {
        let vertices = self.positions.len() - self.edges.len() * ON_EDGE;
        match (node as usize).checked_sub(vertices) {
            None => Start::Vertex(node),
            Some(place) => Start::Edge(self.edges[place / ON_EDGE]),
        }
    }

    /// Whether nodes see however far.
    pub(super) fn sees_all(&self) -> bool {
        self.reach.is_infinite()
    }

    /// The nodes that a node sees, ascending.
    pub(super) fn seen(&self, mesh: &TetMesh, medium: &Medium, node: u32) -> &[u32] {
        let (place, start) = (self.positions[node as usize], self.start(node));
        self.seen[node as usize].get_or_init(|| self.seen_from(mesh, medium, place, start, self.reach))
    }

    /// The nodes that are seen from a place and are no farther than so much, ascending: cones are followed from tetrahedron to
    /// tetrahedron through their faces.
    pub(super) fn seen_from(
        &self,
        mesh: &TetMesh,
        medium: &Medium,
        place: DVec3,
        start: Start,
        reach: f64,
    ) -> Vec<u32> {
        let mut seen = Vec::new();
        let neighbors = medium.sight(mesh).neighbors;
        let mut waiting: Vec<(u32, Option<Cone>)> =
            medium.touching(mesh, start, place).into_iter().map(|tetrahedron| (tetrahedron, None)).collect();
        while let Some((tetrahedron, cone)) = waiting.pop() {
            let positions = mesh.corners(TetId(tetrahedron));
            let corners = mesh.tetrahedra()[tetrahedron as usize];
            for &node in corners.iter().chain(self.of_tetrahedron.row(tetrahedron)) {
                let there = self.positions[node as usize];
                // Nodes of the tetrahedra that the place touches are near whatever the reach.
                let is_seen = cone.as_ref().is_none_or(|cone| place.distance(there) <= reach && cone.sees(there));
                if is_seen && there != place {
                    seen.push(node);
                }
            }
            if positions.iter().all(|corner| corner.distance(place) > reach) {
                continue;
            }
            let own = weights(positions, place);
            for ((face, &next), weight) in FACES.iter().zip(&neighbors[tetrahedron as usize]).zip(own) {
                // Lines from the place leave by the faces that it is on the inner side of.
                if next == NONE || weight <= GRAZING {
                    continue;
                }
                let face = face.map(|corner| positions[corner]);
                let beyond = match &cone {
                    None => Cone::new(place, face),
                    Some(cone) => cone.narrowed(face),
                };
                waiting.extend(beyond.map(|cone| (next, Some(cone))));
            }
        }
        seen.sort_unstable();
        seen.dedup();
        seen
    }
}
