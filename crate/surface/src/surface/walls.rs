//! Walls: faces and edges that no path crosses. They part what lies on their two sides, so that whatever is computed on the
//! surface respects them without knowing of them.

use heatwalk_base::csr::Csr;
use heatwalk_base::parallel;
use heatwalk_base::sort;

use super::connectivity::{Connectivity, component_count};
use super::{Surface, SurfaceId};
use crate::edges::Edges;
use crate::element::{Element, FaceData, FaceId, HalfedgeId, InputVertex, VertexId};
use crate::error::{Error, Result};

/// What no path crosses.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Walls {
    /// Faces that are not walked on. Paths may pass where two of them touch in a vertex.
    pub faces: Vec<FaceId>,
    /// Edges that are not crossed, as half-edges of triangles, in either direction. Paths may run along them on either side,
    /// and around the ends of a line of them.
    pub edges: Vec<HalfedgeId>,
}

impl Walls {
    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty() && self.edges.is_empty()
    }
}

impl Surface {
    /// The same surface parted at walls. Faces and half-edges of triangles keep their numbers. Vertices keep theirs on the
    /// first side of the walls; the other sides get copies of them, after all others, each with the input vertices of its own
    /// side. The faces of walls are components of
    /// their own. It is another surface, with an id of its own: no distance, path or point of this one holds there.
    ///
    /// # Errors
    /// [`NoSuchFace`](Error::NoSuchFace); [`NoSuchHalfedge`](Error::NoSuchHalfedge) also for one of the boundary.
    pub fn walled(&self, walls: &Walls) -> Result<Self> {
        let mut is_wall: FaceData<bool> = vec![false; self.face_count()].into();
        for &face in &walls.faces {
            if face.index() >= self.face_count() {
                return Err(Error::NoSuchFace { face: face.index(), faces: self.face_count() });
            }
            is_wall[face] = true;
        }
        let mut is_closed = vec![false; 3 * self.face_count()];
        for &halfedge in &walls.edges {
            if halfedge.index() >= is_closed.len() {
                return Err(Error::NoSuchHalfedge { halfedge: halfedge.index(), halfedges: is_closed.len() });
            }
            if !is_closed[halfedge.index()] {
                self.edges.around(halfedge).for_each(|halfedge| is_closed[halfedge.index()] = true);
            }
        }
        let class = |side: HalfedgeId| (!is_closed[side.index()]).then_some(is_wall[side.triangle()]);
        let edges = self.edges.parted(class);

        let mut faces = self.faces.clone();
        let mut copied: Vec<VertexId> = Vec::new();
        let mut inputs_of_copies: Vec<Vec<InputVertex>> = Vec::new();
        for vertex in self.vertices() {
            let is_touched = |&corner: &HalfedgeId| {
                is_wall[corner.triangle()] || sides(corner).iter().any(|side| is_closed[side.index()])
            };
            if !self.corners.row(vertex).iter().any(is_touched) {
                continue;
            }
            for sector in self.sectors(vertex, &is_wall, (&edges, &is_closed)).into_iter().skip(1) {
                let copy = VertexId::from_index(self.vertex_count() + copied.len());
                copied.push(vertex);
                // Those of all sectors for each would be as many as the square of the faces there.
                let mut inputs: Vec<InputVertex> =
                    sector.iter().map(|corner| self.inputs_of_face(corner.triangle())[corner.corner()]).collect();
                sort::sort(&mut inputs);
                inputs.dedup();
                inputs_of_copies.push(inputs);
                for corner in sector {
                    faces[corner.triangle()][corner.corner()] = copy;
                }
            }
        }

        let mut positions = self.positions.clone().into_vec();
        positions.extend(copied.iter().map(|&vertex| self.positions[vertex]));
        let corners = Csr::group(positions.len(), faces.as_slice().as_flattened(), parallel::ONE);
        let twins = edges.twins(faces.as_slice(), parallel::ONE).0;
        let Connectivity { mesh, vertex_of_cut, is_boundary, is_oriented_manifold, boundary_loops, components } =
            Connectivity::new(faces.as_slice(), &corners, &edges, twins, parallel::ONE);
        let mut report = self.report.clone();
        report.vertices = positions.len();
        report.components = component_count(&components);
        report.boundary_loops = boundary_loops;
        report.non_manifold_edges = edges.representatives().filter(|&edge| edges.is_branching(edge)).count();
        report.euler_characteristic =
            positions.len() as i64 - edges.representatives().count() as i64 + faces.len() as i64;
        let id = SurfaceId::unique();
        Ok(Self {
            id,
            connectivity: id,
            mesh,
            inputs_of_vertex: self.inputs_of_vertex.with(&inputs_of_copies),
            edges,
            positions: positions.into(),
            faces,
            corners,
            vertex_of_cut,
            components,
            is_boundary,
            is_oriented_manifold,
            is_wall,
            report,
            vertex_of_input: self.vertex_of_input.clone(),
            face_of_triangle: self.face_of_triangle.clone(),
            triangle_of_face: self.triangle_of_face.clone(),
            polygons: self.polygons.clone(),
            inputs_of_face: self.inputs_of_face.clone(),
            mean_edge: self.mean_edge,
        })
    }

    /// Whether a face is a wall of a surface that was [parted](Self::walled).
    pub fn is_wall(&self, face: FaceId) -> bool {
        self.is_wall.get(face).copied().unwrap_or(false)
    }

    /// Whether any face is a wall.
    pub fn has_walls(&self) -> bool {
        self.is_wall.iter().any(|&is_wall| is_wall)
    }

    /// The corners of a vertex by sectors, which paths reach from each other. The first one keeps the vertex's number: an open
    /// one, where there is any; those of walls come last. `edges` are parted at the walls.
    fn sectors(
        &self,
        vertex: VertexId,
        is_wall: &FaceData<bool>,
        (edges, is_closed): (&Edges, &[bool]),
    ) -> Vec<Vec<HalfedgeId>> {
        let corners = self.corners.row(vertex);
        let (walls, open): (Vec<HalfedgeId>, Vec<HalfedgeId>) =
            corners.iter().partition(|corner| is_wall[corner.triangle()]);
        let has_closed_edge = open.iter().any(|&corner| sides(corner).iter().any(|side| is_closed[side.index()]));
        let mut sectors = if has_closed_edge { fans(edges, &open) } else { vec![open] };
        sectors.push(walls);
        sectors.retain(|sector| !sector.is_empty());
        sectors
    }
}

/// The half-edges of a corner's triangle that leave and enter its vertex.
fn sides(corner: HalfedgeId) -> [HalfedgeId; 2] {
    [corner, corner.previous_in_triangle()]
}

/// Corners of one vertex, one a face and ascending, by fans of faces that hang together by edges, in the order of the first
/// corner of each.
fn fans(edges: &Edges, corners: &[HalfedgeId]) -> Vec<Vec<HalfedgeId>> {
    let mut is_taken = vec![false; corners.len()];
    let mut fans = Vec::new();
    for first in 0..corners.len() {
        if std::mem::replace(&mut is_taken[first], true) {
            continue;
        }
        let mut fan = vec![corners[first]];
        let mut done = 0;
        while let Some(&corner) = fan.get(done) {
            done += 1;
            // The next half-edge of an edge leads to the one after it, so all are reached.
            for beside in sides(corner).map(|side| edges.next_on_edge(side).triangle()) {
                let index = corners.partition_point(|corner| corner.triangle() < beside);
                if !std::mem::replace(&mut is_taken[index], true) {
                    fan.push(corners[index]);
                }
            }
        }
        fans.push(fan);
    }
    fans
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use glam::DVec3;

    use super::*;
    use crate::cracks::WeldRule;
    use crate::soup::Soup;

    /// Pages on one edge, which is the first half-edge of each.
    fn book(pages: u32) -> Surface {
        let mut positions = vec![DVec3::ZERO, DVec3::Y];
        positions.extend((0..pages).map(|page| DVec3::new(1.0, 0.5, f64::from(page))));
        let triangles = (0..pages).map(|page| [0, 1, 2 + page]).collect();
        Surface::build(&Soup::single("book", positions, triangles)).expect("a surface")
    }

    #[test]
    fn each_half_edge_of_an_edge_is_looked_at_once() {
        let edges = book(500).edges;
        for is_alone in [false, true] {
            let looks = Cell::new(0);
            let parted = edges.parted(|_| {
                looks.set(looks.get() + 1);
                (!is_alone).then_some(true)
            });
            assert_eq!(looks.get(), 3 * 500);
            assert_eq!(parted.is_single(HalfedgeId(0)), is_alone);
        }
    }

    #[test]
    fn walls_come_back_as_seams_of_what_they_have_parted() {
        // Six triangles around the origin, two rings of them.
        let place = |index: u32, radius: f64| {
            let (sin, cos) = (f64::from(index) * std::f64::consts::TAU / 6.0).sin_cos();
            radius * DVec3::new(cos, sin, 0.0)
        };
        let positions =
            [DVec3::ZERO].into_iter().chain((0..6).map(|k| place(k, 1.0))).chain((0..6).map(|k| place(k, 2.0)));
        let next = |k: u32| (k + 1) % 6;
        let triangles = (0..6)
            .flat_map(|k| [[0, 1 + k, 1 + next(k)], [1 + k, 7 + k, 7 + next(k)], [1 + k, 7 + next(k), 1 + next(k)]]);
        let soup = Soup::single("disk", positions.collect(), triangles.collect());
        let surface = Surface::build(&soup).expect("a surface");
        assert!(surface.seams().is_empty());
        // From the boundary through the origin to the opposite ring: it parts vertices of the boundary and of the way, not its end.
        let vertices = [7, 1, 0, 4].map(VertexId);
        let edges: Vec<_> =
            vertices.windows(2).map(|ends| surface.halfedge_between(ends[0], ends[1]).expect("an edge")).collect();
        let walled = surface.walled(&Walls { faces: Vec::new(), edges }).expect("walls");
        assert_eq!(walled.vertex_count(), surface.vertex_count() + 3);
        let triangles = walled.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
        let again = Soup::single("walled", walled.positions().iter().copied().collect(), triangles);
        let rebuilt = Surface::build_by(&again, WeldRule::Exact, parallel::ONE).expect("a surface");
        assert_eq!(rebuilt.vertex_count(), surface.vertex_count());
        assert_eq!(rebuilt.seams().len(), 3);
        let parted = rebuilt.walled(&Walls { faces: Vec::new(), edges: rebuilt.seams() }).expect("walls");
        assert_eq!(parted.vertex_count(), walled.vertex_count());
        assert_eq!(parted.report().boundary_loops, walled.report().boundary_loops);
    }

    #[test]
    fn walls_at_a_vertex_take_room_in_proportion_to_its_faces() {
        let pages = 500;
        let book = book(pages);
        let walled = book.walled(&Walls { faces: Vec::new(), edges: vec![HalfedgeId(0)] }).expect("walls");
        assert_eq!(walled.report().components, pages as usize);
        let inputs: usize = walled.vertices().map(|vertex| walled.inputs_of_vertex(vertex).len()).sum();
        assert_eq!(inputs, 3 * pages as usize);
    }
}
