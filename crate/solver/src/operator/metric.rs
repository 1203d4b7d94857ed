//! All operators of one metric.

use heatwalk_base::union_find::UnionFind;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{HalfedgeId, VertexId};

use crate::cost::Costs;
use crate::error::Result;
use crate::extremum::larger;
use crate::operator::elements::{Elements, require_triangles};
use crate::operator::intrinsic::IntrinsicTriangulation;
use crate::operator::laplacian::{Discretization, Laplacian};
use crate::operator::relocate;
use crate::options::Operator;

/// Share of the lumped mass that the circumcentric one is at least.
const LEAST_MASS: f64 = 0.1;

/// Linear elements, stiffness, mass, gradient and divergence of a triangulation with edge lengths. Functions have one value
/// per vertex (`#V`). Fields have one vector per triangle, in coordinates of its own: x along the side from corner 0 to
/// corner 1, y to its left.
#[derive(Debug, Clone)]
pub struct Operators {
    pub(crate) elements: Elements,
    laplacian: Laplacian,
    /// Per vertex, counted from 0 in the order of their first vertices.
    components: Vec<u32>,
}

impl Operators {
    /// Of a surface, on the triangles that `operator` chooses. Those of [`Operator::Plain`] are the surface's faces, in
    /// order; others differ in number.
    pub fn new(surface: &Surface, operator: Operator) -> Self {
        Self::weighted(surface, None, operator)
    }

    /// Whether the operators of a surface are the same whatever [`Operator`] chooses: its faces are Delaunay, and none is repaired.
    #[cold]
    pub fn agree(surface: &Surface) -> bool {
        surface.is_oriented_manifold()
            && IntrinsicTriangulation::delaunay_within(surface, &[]).flips() == 0
            && relocate::relocated(surface).1 == 0
    }

    /// The same where faces have costs, which make all lengths in them so many times as large. No edge between faces of
    /// different costs is flipped.
    ///
    /// The cotan weights stay, the mass of a face grows with the square of its cost, and the gradient of a distance there has
    /// its cost for a length.
    pub fn weighted(surface: &Surface, costs: Option<&Costs>, operator: Operator) -> Self {
        let of_faces = || costs.map(|costs| costs.of_faces().as_slice()).unwrap_or_default();
        let elements = match operator {
            Operator::Delaunay => IntrinsicTriangulation::delaunay_within(surface, of_faces()).elements(),
            Operator::Plain => plain(surface, of_faces()),
            Operator::Relocate => plain(&surface.with_positions(relocate::relocated(surface).0), of_faces()),
        };
        Self::assemble(elements, surface.components().as_slice().to_vec())
    }

    /// Of a metric given by lengths: `lengths` are those of the sides from corner 0 to 1, 1 to 2 and 2 to 0 of each of
    /// `faces`. An edge has the same length in all its faces. Vertices are counted from 0, and each is in some face.
    ///
    /// # Errors
    /// [`BadParameter`](crate::Error::BadParameter) for lengths that make no triangle.
    ///
    /// # Panics
    /// Where there is not one triple of lengths for each face, or where some vertex is in no face.
    pub fn from_lengths(faces: &[[VertexId; 3]], lengths: &[[f64; 3]]) -> Result<Self> {
        assert_eq!(faces.len(), lengths.len(), "one triple of lengths for each face");
        require_triangles(lengths)?;
        let faces: Vec<[u32; 3]> = faces.iter().map(|face| face.map(|vertex| vertex.0)).collect();
        let ends = |side: usize| {
            let (face, k) = (faces[side / 3], side % 3);
            let (a, b) = (face[k], face[(k + 1) % 3]);
            (a.min(b), a.max(b))
        };
        let mut sides: Vec<usize> = (0..3 * faces.len()).collect();
        sides.sort_unstable_by_key(|&side| ends(side));
        let mut is_boundary = vec![false; sides.len()];
        for edge in sides.chunk_by(|&a, &b| ends(a) == ends(b)) {
            if let [side] = *edge {
                is_boundary[side] = true;
            }
        }
        let components = components(&faces);
        let elements = Elements::from_lengths(faces, lengths.as_flattened(), |side| is_boundary[side]);
        Ok(Self::assemble(elements, components))
    }

    /// Of an intrinsic triangulation. With one sheet its triangles are in order.
    pub fn of_triangulation(triangulation: &IntrinsicTriangulation) -> Self {
        let elements = triangulation.clone().elements();
        let components = components(&elements.faces);
        Self::assemble(elements, components)
    }

    fn assemble(elements: Elements, components: Vec<u32>) -> Self {
        let laplacian = Laplacian::of_elements(components.len(), &elements);
        Self { elements, laplacian, components }
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.components.len()
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.elements.faces.len()
    }

    /// The corners of a triangle. Two of them may be the same vertex.
    pub fn corners(&self, triangle: usize) -> [VertexId; 3] {
        self.elements.faces[triangle].map(VertexId)
    }

    /// Stiffness and mass.
    pub fn laplacian(&self) -> &Laplacian {
        &self.laplacian
    }

    /// `#V`, the part of the triangles around each vertex that is nearer to it than to their other corners, in the file's unit squared:
    /// ¼ Σ w l² over its edges (Meyer, Desbrun, Schröder, Barr, "Discrete differential-geometry operators for triangulated
    /// 2-manifolds", 2003, section 3.3). Weights w are negative at some edges between costs, so it is at least a share of the lumped mass.
    pub(crate) fn circumcentric_mass(&self) -> Vec<f64> {
        let mut mass = vec![0.0; self.vertex_count()];
        for (index, (&face, shape)) in self.elements.faces.iter().zip(&self.elements.shapes).enumerate() {
            let eighth = 0.125 * self.elements.share(index);
            let [ab, bc, ca] = shape.sides();
            for ((cotan, side), opposite) in shape.cotans().into_iter().zip([bc, ca, ab]).zip(0..) {
                for end in [(opposite + 1) % 3, (opposite + 2) % 3] {
                    mass[face[end] as usize] += eighth * cotan * side * side;
                }
            }
        }
        mass.iter().zip(&self.laplacian.mass).map(|(&mass, &lumped)| larger(mass, LEAST_MASS * lumped)).collect()
    }

    /// The connected component of each vertex (`#V`), counted from 0 in the order of their first vertices.
    pub fn components(&self) -> &[u32] {
        &self.components
    }

    /// Mean length of the edges, in the unit of the lengths.
    pub fn mean_edge(&self) -> f64 {
        self.elements.mean_edge
    }

    /// Root-mean-square deviation of a triangle's sides from their mean, as a share of it: 0 where all are equilateral.
    pub fn deviation(&self) -> f64 {
        self.elements.deviation
    }

    /// Area of all triangles, in the file's unit squared.
    pub fn area(&self) -> f64 {
        self.elements.area()
    }

    /// How much larger triangles are where most of the surface is than where most vertices are: the geometric mean of
    /// their areas, weighted by area, over that of an equilateral triangle with the mean edge. About 1 where all are of
    /// one size.
    pub fn grading(&self) -> f64 {
        self.elements.grading()
    }

    /// Edges of the triangles: vertices, the lower first, and length. Edges of the same vertices whose lengths differ by a
    /// share of `tolerance` at most are there once.
    pub fn edges(&self, tolerance: f64) -> Vec<([VertexId; 2], f64)> {
        let edges = self.elements.edges(tolerance).into_iter();
        edges.map(|(ends, length)| (ends.map(VertexId), length)).collect()
    }

    /// `#triangles × 2`, gradient of a function (`#V`).
    pub fn gradient(&self, values: &[f64]) -> Vec<[f64; 2]> {
        let triangles = self.elements.faces.iter().zip(&self.elements.shapes);
        triangles.map(|(face, shape)| shape.gradient(face.map(|vertex| values[vertex as usize]))).collect()
    }

    /// `#V`, divergence of a field (`#triangles × 2`), integrated over each vertex's part of the surface. Its sign is that
    /// of the stiffness, which is −Δ: `L φ` equals it where the field is ∇φ.
    pub fn divergence(&self, field: &[[f64; 2]]) -> Vec<f64> {
        let mut divergence = vec![0.0; self.vertex_count()];
        for (triangle, (shape, &vector)) in self.elements.shapes.iter().zip(field).enumerate() {
            self.elements.add_divergence(triangle, shape.divergence(vector), &mut divergence);
        }
        divergence
    }
}

impl Discretization for Operators {
    const ROUNDS: bool = true;

    fn laplacian(&self) -> &Laplacian {
        &self.laplacian
    }

    fn components(&self) -> &[u32] {
        &self.components
    }
}

/// The faces of a surface as they are, with lengths that count as many times as their costs say, if there are any.
fn plain(surface: &Surface, costs: &[f64]) -> Elements {
    let faces: Vec<[u32; 3]> = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
    let sides = 3 * faces.len();
    let is_boundary = |side: usize| surface.mesh().twin(HalfedgeId(side as u32)).0 as usize >= sides;
    let mut lengths = surface.side_lengths();
    for (sides, cost) in lengths.chunks_exact_mut(3).zip(costs) {
        sides.iter_mut().for_each(|length| *length *= cost);
    }
    Elements::from_lengths(faces, &lengths, is_boundary)
}

/// Per vertex, the connected component of the faces around.
fn components(faces: &[[u32; 3]]) -> Vec<u32> {
    let count = faces.as_flattened().iter().max().map_or(0, |&last| last as usize + 1);
    let mut is_used = vec![false; count];
    let connected = UnionFind::new(count);
    for &[a, b, c] in faces {
        connected.join(a, b);
        connected.join(b, c);
        for vertex in [a, b, c] {
            is_used[vertex as usize] = true;
        }
    }
    assert!(is_used.iter().all(|&used| used), "every vertex is in some face");
    connected.sets().0
}
