//! What waves spread in: which tetrahedra they may enter, at which cost, and the edges that they bend around.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use super::nodes::Nodes;
use crate::corner::Corner;
use crate::error::{Error, Result};
use crate::lists::Lists;
use crate::mesh::locate::{GRAZING, weights};
use crate::mesh::quality::dihedral_angles;
use crate::mesh::{Crossing, EDGES, FACES, NONE, Sight, Start, TetId, TetMesh};

/// So many tetrahedra around a place, looked at for a line that begins there or for what is refracted, count as a face that is passed.
pub(super) const AROUND: usize = 64;

/// Costs of tetrahedra that are not walls.
pub const COSTS: RangeInclusive<f64> = 1e-3..=1e3;

/// Waves bend around edges whose angle inside the mesh is above π by this, in radians: more than rounding, and less than what takes
/// a line through the edge's ends out of sight.
const CONCAVE: f64 = 1e-10;

/// Edges whose angle inside the mesh is above π by this, in radians, are sharp: less is between the faces of a round obstacle, whose edges
/// waves bend around one after another.
const SHARP: f64 = 0.5;

/// Nodes of a riddled mesh, at most, if all edges of its boundary are sharp: to see which of them see each other takes some seconds then, and
/// 100 MB. Where a share of the edges is, that times its square: 0.4 to 1 where tetrahedra between points at random are taken out, 0 on
/// round solids, where waves come as far and take less.
const NODES: f64 = 70_000.0;

/// The tetrahedra of a mesh with what it costs to go through them.
#[derive(Debug)]
pub(crate) struct Medium {
    /// `#T × 4`, as of the mesh, without walls; none where there are no walls.
    neighbors: Option<Vec<[u32; 4]>>,
    /// `#T`; none where all cost the same.
    costs: Option<Vec<f64>>,
    /// Where all cost the same, that.
    cost: f64,
    /// Of each vertex, the other ends of the boundary's concave edges.
    concave: Lists,
    /// Where the mesh is riddled.
    nodes: Option<Nodes>,
}

/// The concave edges of a boundary.
struct ConcaveEdges {
    /// Of each vertex, their other ends.
    concave: Lists,
    /// The ends of the sharp ones.
    sharp: Vec<[u32; 2]>,
    /// How many edges the boundary has.
    edges: usize,
}

impl Medium {
    /// All of a mesh at cost 1, or at `costs` (`#T`; infinite for walls).
    ///
    /// # Errors
    /// [`Error::CostCount`]; [`Error::BadCost`]; [`Error::AllWalls`].
    pub(crate) fn new(mesh: &TetMesh, costs: Option<&[f64]>) -> Result<Self> {
        let mut medium = Self { neighbors: None, costs: None, cost: 1.0, concave: Lists::default(), nodes: None };
        if let Some(costs) = costs {
            medium.set_costs(mesh, costs)?;
        }
        let ConcaveEdges { concave, sharp, edges } = medium.concave_edges(mesh);
        medium.concave = concave;
        let is_open = |&vertex: &u32| mesh.around().row(vertex).iter().any(|&around| medium.cost(around).is_finite());
        let nodes = (0..mesh.vertex_count() as u32).filter(is_open).count() + sharp.len();
        let share = sharp.len() as f64 / edges as f64;
        if medium.is_uniform() && nodes as f64 <= NODES * share * share {
            medium.nodes = Some(Nodes::new(mesh, &sharp));
        }
        Ok(medium)
    }

    fn set_costs(&mut self, mesh: &TetMesh, costs: &[f64]) -> Result<()> {
        if costs.len() != mesh.tetrahedron_count() {
            return Err(Error::CostCount { costs: costs.len(), tetrahedra: mesh.tetrahedron_count() });
        }
        let is_allowed = |cost: f64| COSTS.contains(&cost) || cost == f64::INFINITY;
        if let Some((tetrahedron, &cost)) = costs.iter().enumerate().find(|&(_, &cost)| !is_allowed(cost)) {
            return Err(Error::BadCost { tetrahedron, cost, least: *COSTS.start(), most: *COSTS.end() });
        }
        let mut finite = costs.iter().copied().filter(|cost| cost.is_finite());
        self.cost = finite.next().ok_or(Error::AllWalls)?;
        if finite.any(|cost| cost != self.cost) || costs.contains(&f64::INFINITY) {
            self.costs = Some(costs.to_vec());
        }
        if costs.contains(&f64::INFINITY) {
            let is_wall = |tetrahedron: u32| tetrahedron != NONE && costs[tetrahedron as usize].is_infinite();
            let open = |&neighbor: &u32| if is_wall(neighbor) { NONE } else { neighbor };
            let neighbors = mesh.neighbors().iter();
            self.neighbors = Some(neighbors.map(|neighbors| neighbors.each_ref().map(open)).collect());
        }
        Ok(())
    }

    /// The cost of a tetrahedron.
    #[inline]
    pub(crate) fn cost(&self, tetrahedron: u32) -> f64 {
        self.costs.as_ref().map_or(self.cost, |costs| costs[tetrahedron as usize])
    }

    /// Whether all that are no walls cost the same.
    pub(crate) fn is_uniform(&self) -> bool {
        self.costs.as_ref().is_none_or(|costs| costs.iter().all(|&cost| cost == self.cost || cost.is_infinite()))
    }

    /// The cost of all, where they have one and there are no walls.
    pub(crate) fn uniform_cost(&self) -> Option<f64> {
        self.costs.is_none().then_some(self.cost)
    }

    /// The least of those that are no walls.
    pub(crate) fn least_cost(&self) -> f64 {
        self.costs.as_ref().map_or(self.cost, |costs| costs.iter().copied().fold(f64::INFINITY, f64::min))
    }

    /// Whether some are walls.
    pub(crate) fn has_walls(&self) -> bool {
        self.neighbors.is_some()
    }

    /// The other ends of the concave edges at a vertex.
    pub(crate) fn concave(&self, vertex: u32) -> &[u32] {
        self.concave.row(vertex)
    }

    /// Where paths may bend in a riddled mesh; none in others.
    pub(super) fn nodes(&self) -> Option<&Nodes> {
        self.nodes.as_ref()
    }

    /// The tetrahedra that are no walls and that a place touches.
    pub(crate) fn touching(&self, mesh: &TetMesh, Corner { start, place, .. }: Corner) -> Vec<u32> {
        let is_open = |tetrahedron: &u32| self.cost(*tetrahedron).is_finite();
        match start {
            Start::Vertex(vertex) => mesh.around().row(vertex).iter().copied().filter(is_open).collect(),
            Start::Edge([a, b]) => mesh.around_edge([a, b]).filter(is_open).collect(),
            Start::Inside(tetrahedron) => {
                let weights = weights(mesh.corners(TetId(tetrahedron)), place);
                let beyond = self.sight(mesh).neighbors[tetrahedron as usize];
                let touched =
                    beyond.into_iter().zip(weights).filter(|&(other, weight)| other != NONE && weight <= GRAZING);
                touched.map(|(other, _)| other).chain([tetrahedron]).collect()
            }
        }
    }

    /// Whether the straight line between two places stays in tetrahedra of the cost at the first, and ends on the second one's side of a crack,
    /// where that has vertices of equal position on both sides.
    pub(crate) fn sees(&self, mesh: &TetMesh, ends: [Corner; 2]) -> bool {
        self.sees_in(mesh, ends, &mut 0)
    }

    /// The same; adds the faces that were passed to `passed`.
    pub(super) fn sees_in(&self, mesh: &TetMesh, [a, b]: [Corner; 2], passed: &mut usize) -> bool {
        let sight = self.sight(mesh);
        *passed += 1 + (sight.around(a.start) + sight.around(b.start)) / AROUND;
        let may_enter = |tetrahedron: u32| self.cost(tetrahedron) == a.cost;
        let are_in_one = || {
            let of_b = self.touching(mesh, b);
            self.touching(mesh, a).iter().any(|tetrahedron| may_enter(*tetrahedron) && of_b.contains(tetrahedron))
        };
        // A line along a crack may be followed on one side of it alone, but it comes from both.
        are_in_one()
            || [[a, b], [b, a]].into_iter().any(|[from, to]| {
                let crossing = |_| {
                    *passed += 1;
                    Crossing::On
                };
                let end = sight.walk(from.start, [from.place, to.place], may_enter, crossing);
                end.is_some_and(|end| self.touches(mesh, end, to))
            })
    }

    /// Whether a tetrahedron that a place is in, as it seems, is one of those that it touches, or leads to one by faces that it is on: which of
    /// them it is in is up to rounding, but on the other side of a crack it is in none.
    fn touches(&self, mesh: &TetMesh, tetrahedron: u32, corner: Corner) -> bool {
        let touching = self.touching(mesh, corner);
        let mut joined = vec![tetrahedron];
        let mut next = 0;
        while let Some(&tetrahedron) = joined.get(next) {
            if touching.contains(&tetrahedron) {
                return true;
            }
            next += 1;
            let weights = weights(mesh.corners(TetId(tetrahedron)), corner.place);
            let beyond = self.sight(mesh).neighbors[tetrahedron as usize];
            for (other, weight) in beyond.into_iter().zip(weights) {
                if other != NONE && weight.abs() <= GRAZING && !joined.contains(&other) {
                    joined.push(other);
                }
            }
        }
        false
    }

    /// Lines through the tetrahedra that are no walls.
    pub(crate) fn sight<'a>(&'a self, mesh: &'a TetMesh) -> Sight<'a> {
        Sight { mesh, neighbors: self.neighbors.as_deref().unwrap_or(mesh.neighbors()) }
    }

    /// The concave edges of the boundary of what is no wall.
    fn concave_edges(&self, mesh: &TetMesh) -> ConcaveEdges {
        let neighbors = self.sight(mesh).neighbors;
        let mut edges: Vec<[u32; 2]> = Vec::new();
        for (tetrahedron, (corners, neighbors)) in mesh.tetrahedra().iter().zip(neighbors).enumerate() {
            if self.cost(tetrahedron as u32).is_infinite() {
                continue;
            }
            for (face, _) in FACES.iter().zip(neighbors).filter(|&(_, &neighbor)| neighbor == NONE) {
                for k in 0..3 {
                    let [a, b] = [corners[face[k]], corners[face[(k + 1) % 3]]];
                    edges.push([a.min(b), a.max(b)]);
                }
            }
        }
        edges.sort_unstable();
        let (mut concave, mut sharp, mut count) = (Vec::new(), Vec::new(), 0);
        for sides in edges.chunk_by(|a, b| a == b) {
            count += 1;
            let [a, b] = sides[0];
            // Where parts meet in an edge only, lines cannot tell whether they may pass.
            let angle = if sides.len() > 2 { f64::INFINITY } else { self.angle_at_edge(mesh, [a, b]) };
            if angle > PI + CONCAVE {
                concave.extend([(a, b), (b, a)]);
            }
            if angle > PI + SHARP {
                sharp.push([a, b]);
            }
        }
        ConcaveEdges { concave: Lists::group(mesh.vertex_count(), || concave.iter().copied()), sharp, edges: count }
    }

    /// The angle of the tetrahedra around an edge, in radians.
    fn angle_at_edge(&self, mesh: &TetMesh, [a, b]: [u32; 2]) -> f64 {
        let mut sum = 0.0;
        for tetrahedron in mesh.around_edge([a, b]).filter(|&tetrahedron| self.cost(tetrahedron).is_finite()) {
            let corners = mesh.tetrahedra()[tetrahedron as usize];
            let is_it =
                |&&[i, j]: &&[usize; 2]| [corners[i], corners[j]] == [a, b] || [corners[j], corners[i]] == [a, b];
            let edge = EDGES.iter().position(|ends| is_it(&ends)).expect("a tetrahedron with both ends has the edge");
            sum += dihedral_angles(mesh.corners(TetId(tetrahedron)))[edge];
        }
        sum
    }
}
