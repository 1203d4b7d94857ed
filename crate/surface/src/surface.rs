//! The surface that distances are computed on: welded vertices, clean oriented triangles, half-edges.
//!
//! A welded vertex is one position and one unknown. Where the triangles are not an oriented manifold (an edge of three
//! faces, a Möbius strip) the half-edge mesh is cut, and several of its vertices share one welded vertex; heat, distance
//! and paths live on welded vertices and do not see the cut.

mod connectivity;
mod pose;
mod walls;

pub use walls::Walls;

use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use heatwalk_base::csr::{Csr, NONE};
use heatwalk_base::parallel;

use self::connectivity::{Connectivity, component_count};
use crate::cracks::WeldRule;
use crate::edges::{Corners, Edges};
use crate::element::{
    CutVertex, CutVertexData, Element, FaceData, FaceId, HalfedgeId, InputTriangle, InputTriangleData, InputVertex,
    InputVertexData, VertexData, VertexId,
};
use crate::error::{Error, Result};
use crate::halfedge::HalfedgeMesh;
use crate::memory;
use crate::soup::{Part, Soup};
use crate::triangle;
use crate::weld::weld;

/// Bytes that welding, edges and half-edges take at once, a triangle of the soup: about as many as are kept.
const BYTES_PER_TRIANGLE: u64 = 128;

/// What was found and done while a [`Surface`] was built.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BuildReport {
    /// Vertices of the input.
    pub input_vertices: usize,
    /// Welded vertices, the unknowns.
    pub vertices: usize,
    /// Faces kept.
    pub faces: usize,
    /// Polygons of the input that these are cut from; a triangle is one.
    pub polygons: usize,
    /// Input vertices that became one with an earlier one.
    pub welded_vertices: usize,
    /// Those of them that became one with a vertex of another position, on the other side of a crack; input vertices of one
    /// position count once.
    pub crack_vertices: usize,
    /// How far the farthest of them was from the one that it became, in the file's unit.
    pub crack_width: f64,
    /// Input vertices that no kept face uses.
    pub unreferenced_vertices: usize,
    /// Triangles dropped for a repeated corner or no area.
    pub degenerate_faces: usize,
    /// Triangles dropped because an earlier one has the same three vertices.
    pub duplicate_faces: usize,
    /// Faces whose orientation was reversed to agree with their neighbours.
    pub flipped_faces: usize,
    /// Edges of three faces or more.
    pub non_manifold_edges: usize,
    /// Connected components; touching in one vertex is enough.
    pub components: usize,
    /// Loops of edges that have one face only.
    pub boundary_loops: usize,
    /// Vertices − edges + faces.
    pub euler_characteristic: i64,
}

/// Tells surfaces apart. Each built surface has an id of its own in the program; a clone shares it, being the same surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SurfaceId(u64);

impl SurfaceId {
    fn unique() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

/// A welded triangle surface with its connectivity. Build it with [`Surface::build`].
#[derive(Debug, Clone)]
pub struct Surface {
    id: SurfaceId,
    /// Of the surface that was built, in whatever pose it is now.
    connectivity: SurfaceId,
    mesh: HalfedgeMesh,
    edges: Edges,
    positions: VertexData<DVec3>,
    faces: FaceData<[VertexId; 3]>,
    corners: Corners,
    vertex_of_cut: CutVertexData<VertexId>,
    vertex_of_input: InputVertexData<Option<VertexId>>,
    inputs_of_vertex: Csr<VertexId, InputVertex>,
    /// Number [`NONE`] where the triangle was dropped.
    face_of_triangle: InputTriangleData<FaceId>,
    triangle_of_face: FaceData<InputTriangle>,
    /// As those of [`Soup::polygons`].
    polygons: Vec<Range<usize>>,
    /// Empty where each vertex is of one input vertex.
    inputs_of_face: FaceData<[InputVertex; 3]>,
    components: VertexData<u32>,
    is_boundary: VertexData<bool>,
    is_oriented_manifold: bool,
    /// Whether paths never cross a face; empty where there are no walls.
    is_wall: FaceData<bool>,
    mean_edge: f64,
    report: BuildReport,
}

impl Surface {
    /// Welds, cleans and orients a soup, on the caller's thread alone.
    ///
    /// # Errors
    /// As [`Self::build_by`].
    pub fn build(soup: &Soup) -> Result<Self> {
        Self::build_on(soup, parallel::ONE)
    }

    /// Welds, cleans and orients a soup, on so many threads. The surface is the same, to the last bit, however many.
    ///
    /// # Errors
    /// As [`Self::build_by`].
    ///
    /// # Panics
    /// Where there are no threads, as on wasm32, and more than one is asked for.
    pub fn build_on(soup: &Soup, threads: NonZeroUsize) -> Result<Self> {
        Self::build_by(soup, WeldRule::default(), threads)
    }

    /// Welds by a rule, cleans and orients a soup, on so many threads.
    ///
    /// Cracks are closed between boundary vertices that are nearest to each other, where edges of both sides come together, and
    /// are narrower than 5 % of the least altitude of the triangles there; of the vertices that become one the first keeps its
    /// place. Layers, such as a decal on a wall, stay apart.
    ///
    /// # Errors
    /// [`IndexOutOfRange`](crate::Error::IndexOutOfRange); [`NotFinite`](crate::Error::NotFinite) and
    /// [`TooFar`](crate::Error::TooFar) for a used vertex;
    /// [`Empty`](crate::Error::Empty) where no triangle of non-zero area is left; [`OutOfMemory`](crate::Error::OutOfMemory).
    ///
    /// # Panics
    /// Where there are no threads, as on wasm32, and more than one is asked for.
    pub fn build_by(soup: &Soup, rule: WeldRule, threads: NonZeroUsize) -> Result<Self> {
        let triangles: usize = soup.parts.iter().map(Part::len).sum();
        memory::require(BYTES_PER_TRIANGLE * triangles as u64, "building the surface")?;
        let welded = weld(soup, rule, threads)?;
        let (positions, mut faces, mut edges, mut corners) =
            (welded.positions, welded.faces, welded.edges, welded.corners);
        let triangle_of_face = welded.triangle_of_face;
        let (mut twins, do_agree) = edges.twins(faces.as_slice(), threads);
        let flipped = if do_agree { Vec::new() } else { edges.faces_to_flip(faces.as_slice()) };
        if !flipped.is_empty() {
            let mut is_flipped: FaceData<bool> = vec![false; faces.len()].into();
            for &face in &flipped {
                faces[face].swap(1, 2);
                is_flipped[face] = true;
            }
            edges = edges.flipped(|face| is_flipped[face]);
            for corner in corners.items_mut() {
                let (face, k) = (corner.triangle(), corner.corner());
                if k > 0 && is_flipped[face] {
                    *corner = face.halfedge(3 - k);
                }
            }
            twins = edges.twins(faces.as_slice(), threads).0;
        }
        let Connectivity { mesh, vertex_of_cut, is_boundary, is_oriented_manifold, boundary_loops, components } =
            Connectivity::new(faces.as_slice(), &corners, &edges, twins, threads);
        let sums = EdgeSums::new(&edges, &faces, &positions, threads);
        let unreferenced = welded.vertex_of_input.iter().filter(|vertex| vertex.is_none()).count();
        let mut is_first = vec![true; soup.polygons.len()];
        let of_polygon = |&triangle: &InputTriangle| polygon_of(&soup.polygons, triangle);
        let seen = triangle_of_face.iter().filter_map(of_polygon);
        let further = seen.filter(|&polygon| !std::mem::replace(&mut is_first[polygon], false)).count();
        let report = BuildReport {
            input_vertices: soup.positions.len(),
            vertices: positions.len(),
            faces: faces.len(),
            polygons: faces.len() - further,
            welded_vertices: soup.positions.len() - unreferenced - positions.len(),
            crack_vertices: welded.crack_vertices,
            crack_width: welded.crack_width,
            unreferenced_vertices: unreferenced,
            degenerate_faces: welded.degenerate_faces,
            duplicate_faces: welded.duplicate_faces,
            flipped_faces: flipped.len(),
            non_manifold_edges: sums.branching,
            components: component_count(&components),
            boundary_loops,
            euler_characteristic: positions.len() as i64 - sums.count as i64 + faces.len() as i64,
        };
        let inputs_of_face = if report.welded_vertices == 0 {
            FaceData::default()
        } else {
            let inputs = |face: FaceId| {
                let inputs = soup.triangles[triangle_of_face[face].index()].map(InputVertex);
                let at = |vertex| inputs.into_iter().find(|&input| welded.vertex_of_input[input] == Some(vertex));
                faces[face].map(|vertex| at(vertex).expect("a corner there"))
            };
            parallel::collect(faces.len(), threads, |face| inputs(FaceId::from_index(face))).into()
        };
        let mut face_of_triangle = parallel::collect(soup.triangles.len(), threads, |_| FaceId(NONE));
        parallel::map_parts(parallel::ranges(face_of_triangle.len(), threads), &mut face_of_triangle, |own, faces| {
            for (face, triangle) in triangle_of_face.enumerate() {
                if let Some(place) = faces.get_mut(triangle.index().wrapping_sub(own.start)) {
                    *place = face;
                }
            }
        });
        let id = SurfaceId::unique();
        Ok(Self {
            id,
            connectivity: id,
            inputs_of_vertex: Csr::group(positions.len(), welded.vertex_of_input.as_slice(), threads),
            mesh,
            edges,
            positions,
            faces,
            corners,
            vertex_of_cut,
            vertex_of_input: welded.vertex_of_input,
            face_of_triangle: face_of_triangle.into(),
            triangle_of_face,
            polygons: soup.polygons.clone(),
            inputs_of_face,
            components,
            is_boundary,
            is_oriented_manifold,
            is_wall: FaceData::default(),
            mean_edge: sums.length / sums.count as f64,
            report,
        })
    }

    /// What tells this surface from all others.
    pub fn id(&self) -> SurfaceId {
        self.id
    }

    /// Refuses a thing of another surface.
    ///
    /// # Errors
    /// [`ForeignSurface`](crate::Error::ForeignSurface) with the name of the thing.
    pub fn require_own(&self, owner: SurfaceId, thing: &'static str) -> Result<()> {
        if owner == self.id { Ok(()) } else { Err(Error::ForeignSurface { thing }) }
    }

    /// Number of welded vertices.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// Number of faces.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// All welded vertices.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + DoubleEndedIterator + Clone + use<> {
        self.positions.ids()
    }

    /// `#V × 3`, in order of the first input vertex there, in the file's unit. Large surfaces whose order is scattered are
    /// renumbered, so that neighbours on the surface are neighbours in memory.
    #[inline]
    pub fn positions(&self) -> &VertexData<DVec3> {
        &self.positions
    }

    /// `#F × 3` corners of the kept triangles, in the input's order unless renumbered as the
    /// [vertices](Self::positions) are.
    #[inline]
    pub fn faces(&self) -> &FaceData<[VertexId; 3]> {
        &self.faces
    }

    /// Half-edges; triangle `f` of the mesh is face `f`, in the same orientation and order of corners.
    #[inline]
    pub fn mesh(&self) -> &HalfedgeMesh {
        &self.mesh
    }

    /// Which half-edges lie on the same edge, over all cuts.
    pub fn edges(&self) -> &Edges {
        &self.edges
    }

    /// The welded vertex that a vertex of the half-edge mesh is a copy of. Cut vertex `i` is welded vertex `i` for every
    /// `i < #V`; further copies come after.
    pub fn vertex_of_cut(&self, vertex: CutVertex) -> VertexId {
        self.vertex_of_cut[vertex]
    }

    /// The welded vertex that an input vertex became; `None` where no kept face uses it, or there is none such.
    pub fn vertex_of_input(&self, vertex: InputVertex) -> Option<VertexId> {
        self.vertex_of_input.get(vertex).copied().flatten()
    }

    /// The same where there has to be one.
    ///
    /// # Errors
    /// [`Error::UnreferencedVertex`].
    pub fn require_vertex(&self, vertex: InputVertex) -> Result<VertexId> {
        self.vertex_of_input(vertex).ok_or(Error::UnreferencedVertex { vertex: vertex.index() })
    }

    /// Of every input vertex the welded vertex that it became; `None` where no kept face uses it.
    pub fn vertices_of_inputs(&self) -> &InputVertexData<Option<VertexId>> {
        &self.vertex_of_input
    }

    /// That of the first vertex of the input that is on the surface.
    pub fn first_vertex(&self) -> VertexId {
        self.vertex_of_input.iter().copied().flatten().next().unwrap_or(VertexId(0))
    }

    /// Values of vertices in the order of the input's vertices; `absent` for those that no kept face uses.
    pub fn to_inputs(&self, values: &VertexData<f64>, absent: f64) -> Vec<f64> {
        self.vertex_of_input.iter().map(|vertex| vertex.map_or(absent, |vertex| values[vertex])).collect()
    }

    /// The input vertices welded into a vertex, ascending; one at least.
    pub fn inputs_of_vertex(&self, vertex: VertexId) -> &[InputVertex] {
        self.inputs_of_vertex.row(vertex)
    }

    /// The face that an input triangle became; `None` where it was dropped, or there is none such.
    pub fn face_of_triangle(&self, triangle: InputTriangle) -> Option<FaceId> {
        self.face_of_triangle.get(triangle).copied().filter(|face| face.0 != NONE)
    }

    /// All faces, in the order of the input's triangles.
    pub fn faces_in_input_order(&self) -> impl Iterator<Item = FaceId> {
        self.face_of_triangle.iter().copied().filter(|face| face.0 != NONE)
    }

    /// The input triangle that became a face.
    pub fn triangle_of_face(&self, face: FaceId) -> InputTriangle {
        self.triangle_of_face[face]
    }

    /// Whether an edge is between faces that a polygon of the input was cut into.
    pub fn is_within_polygon(&self, halfedge: HalfedgeId) -> bool {
        let of = |at: HalfedgeId| polygon_of(&self.polygons, self.triangle_of_face[at.triangle()]);
        let mut others = self.edges.around(halfedge).skip(1).peekable();
        others.peek().is_some() && of(halfedge).is_some_and(|polygon| others.all(|other| of(other) == Some(polygon)))
    }

    /// The input vertices at a face's corners, in the order of [`faces`](Self::faces).
    pub fn inputs_of_face(&self, face: FaceId) -> [InputVertex; 3] {
        let only = || self.faces[face].map(|vertex| self.inputs_of_vertex(vertex)[0]);
        self.inputs_of_face.get(face).copied().unwrap_or_else(only)
    }

    /// Edges that welding has joined, as along UV seams: faces there have different vertices of the input. One half-edge of each.
    #[must_use]
    pub fn seams(&self) -> Vec<HalfedgeId> {
        if self.inputs_of_face.is_empty() {
            return Vec::new();
        }
        let ends = |side: HalfedgeId| {
            let (inputs, k) = (self.inputs_of_face(side.triangle()), side.corner());
            let [a, b] = [inputs[k], inputs[(k + 1) % 3]];
            [a.min(b), a.max(b)]
        };
        let is_seam = |&edge: &HalfedgeId| self.edges.around(edge).any(|side| ends(side) != ends(edge));
        self.edges.representatives().filter(is_seam).collect()
    }

    /// `#V`, the connected component of each vertex, counted from 0 in order of their first vertices.
    pub fn components(&self) -> &VertexData<u32> {
        &self.components
    }

    /// The connected component of a vertex, counted from 0.
    #[inline]
    pub fn component(&self, vertex: VertexId) -> u32 {
        self.components[vertex]
    }

    /// `#V`, whether an edge with one face only ends at the vertex. Cuts are not boundary.
    pub fn boundary_vertices(&self) -> &VertexData<bool> {
        &self.is_boundary
    }

    /// Whether no edge had to be cut: every edge has one face, or two that agree in orientation.
    pub fn is_oriented_manifold(&self) -> bool {
        self.is_oriented_manifold
    }

    /// Mean length of the edges, in the file's unit.
    pub fn mean_edge(&self) -> f64 {
        self.mean_edge
    }

    /// What was found and done while the surface was built.
    pub fn report(&self) -> &BuildReport {
        &self.report
    }

    /// The faces around a vertex, over all copies of it, each with the corner (0 to 2) that lies there.
    #[inline]
    pub fn corners_of_vertex(&self, vertex: VertexId) -> impl Iterator<Item = (FaceId, usize)> + '_ {
        self.corners.row(vertex).iter().map(|corner| (corner.triangle(), corner.corner()))
    }

    /// The vertices joined to a vertex by an edge; each as often as a face has that edge.
    #[inline]
    pub fn neighbours(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.corners_of_vertex(vertex).flat_map(|(face, k)| {
            let corners = self.faces[face];
            [corners[(k + 1) % 3], corners[(k + 2) % 3]]
        })
    }

    /// A half-edge of a triangle that joins two vertices, in either direction.
    pub fn halfedge_between(&self, a: VertexId, b: VertexId) -> Option<HalfedgeId> {
        // From the one with fewer faces: the other may have as many as there are.
        let degree = |vertex| self.corners.row(vertex).len();
        let [start, end] = if degree(a) <= degree(b) { [a, b] } else { [b, a] };
        let mut sides = self.corners.row(start).iter().flat_map(|&corner| [corner, corner.previous_in_triangle()]);
        sides.find(|&side| start != end && self.ends(side).contains(&end))
    }

    /// The faces that have an edge, over all copies, ascending: one on a boundary, more than two where not manifold.
    #[inline]
    pub fn faces_of_edge(&self, halfedge: HalfedgeId) -> impl Iterator<Item = FaceId> + '_ {
        self.edges.around(self.edges.first(self.in_triangle(halfedge))).map(HalfedgeId::triangle)
    }

    /// A half-edge itself, or the one of a triangle that it runs along where it is one of the boundary.
    #[inline]
    pub(crate) fn in_triangle(&self, halfedge: HalfedgeId) -> HalfedgeId {
        if halfedge.index() < 3 * self.face_count() { halfedge } else { self.mesh.twin(halfedge) }
    }

    /// Greatest distance of a vertex from the centre of the box around all of them, in the file's unit.
    pub fn bounding_radius(&self) -> f64 {
        let first = self.positions[VertexId(0)];
        let box_of = |(low, high): (DVec3, DVec3), &position| (low.min(position), high.max(position));
        let (low, high) = self.positions.iter().fold((first, first), box_of);
        let centre = (low + high) * 0.5;
        self.positions.iter().map(|&position| triangle::length(position - centre)).fold(0.0, f64::max)
    }

    /// Position of a vertex.
    #[inline]
    pub fn position(&self, vertex: VertexId) -> DVec3 {
        self.positions[vertex]
    }

    /// Positions of a face's corners.
    #[inline]
    pub fn corners(&self, face: FaceId) -> [DVec3; 3] {
        self.faces[face].map(|vertex| self.positions[vertex])
    }

    /// `3 #F`, length of the half-edge that leaves each corner, in the file's unit.
    pub fn side_lengths(&self) -> Vec<f64> {
        let mut lengths = Vec::with_capacity(3 * self.face_count());
        for face in self.mesh.faces() {
            let [p, q, r] = self.corners(face);
            lengths.extend([q - p, r - q, p - r].map(triangle::length));
        }
        lengths
    }

    /// The vertices that a half-edge leaves and enters.
    #[inline]
    pub fn ends(&self, halfedge: HalfedgeId) -> [VertexId; 2] {
        [self.mesh.vertex(halfedge), self.mesh.tip(halfedge)].map(|vertex| self.vertex_of_cut[vertex])
    }

    /// Unit normal of a face, counter-clockwise corners seen from its tip.
    pub fn face_normal(&self, face: FaceId) -> DVec3 {
        triangle::unit(triangle::area_vector(self.corners(face)))
    }

    /// Area of a face.
    pub fn face_area(&self, face: FaceId) -> f64 {
        0.5 * triangle::length(triangle::area_vector(self.corners(face)))
    }

    /// Unit normal at a vertex: the mean of the face normals around it, weighted by angle; zero where they cancel.
    #[inline]
    pub fn vertex_normal(&self, vertex: VertexId) -> DVec3 {
        let weighted = self.corners_of_vertex(vertex).map(|(face, k)| {
            let mut corners = self.corners(face);
            corners.rotate_left(k);
            self.face_normal(face) * triangle::angle(corners)
        });
        triangle::unit(weighted.sum())
    }
}

/// Half-edges whose lengths are summed before anything else, so that rounding does not depend on the number of threads.
const BLOCK: usize = 1 << 12;

/// Sums over edges. A cut edge counts once, wherever the cut may run.
#[derive(Clone, Copy, Default)]
struct EdgeSums {
    length: f64,
    count: usize,
    /// Edges of three faces or more.
    branching: usize,
}

impl EdgeSums {
    fn new(
        edges: &Edges,
        faces: &FaceData<[VertexId; 3]>,
        positions: &VertexData<DVec3>,
        threads: NonZeroUsize,
    ) -> Self {
        let of_edge = |last: HalfedgeId| {
            let (face, k) = (faces[last.triangle()], last.corner());
            let length = triangle::length(positions[face[(k + 1) % 3]] - positions[face[k]]);
            Self { length, count: 1, branching: usize::from(edges.is_branching(last)) }
        };
        let halfedges = 3 * faces.len();
        let blocks = parallel::map(parallel::shares(halfedges.div_ceil(BLOCK), halfedges, threads), |blocks| {
            let of_block = |block: usize| edges.representatives_in(block * BLOCK..((block + 1) * BLOCK).min(halfedges));
            blocks.map(|block| of_block(block).map(of_edge).fold(Self::default(), Self::plus)).collect::<Vec<_>>()
        });
        blocks.into_iter().flatten().fold(Self::default(), Self::plus)
    }

    fn plus(self, other: Self) -> Self {
        Self {
            length: self.length + other.length,
            count: self.count + other.count,
            branching: self.branching + other.branching,
        }
    }
}

/// The number of the polygon that a triangle is a part of.
fn polygon_of(polygons: &[Range<usize>], triangle: InputTriangle) -> Option<usize> {
    let number = polygons.partition_point(|range| range.end <= triangle.index());
    polygons.get(number).filter(|range| range.contains(&triangle.index())).map(|_| number)
}
