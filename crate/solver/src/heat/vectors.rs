//! Diffusion of tangent vectors for a short time, after which they point as they did at the nearest source of them (Sharp, Soliman,
//! Crane, "The vector heat method", 2019), and the sign of distance from curves by that of their normals (Feng & Crane, "A heat method for
//! generalized signed distance", 2024).

use std::sync::{Arc, OnceLock};

use glam::DVec3;
use heatwalk_sparse::{Progress, Scalar, System, c64};
use heatwalk_surface::{Element, FaceId, Place, Surface, ToPoint, VertexData, VertexId};

use super::flow::{Condition, HeatFlow};
use super::systems::Systems;
use crate::error::{Error, Result};
use crate::exact::ExactGeometry;
use crate::operator::intrinsic::IntrinsicTriangulation;
use crate::operator::{ConnectionLaplacian, Frames, Operators, TangentPlane};
use crate::options::LinearSolver;

/// A vector whose part along the surface is a smaller share of it is square to the surface: rounding.
const SQUARE: f64 = 1e-12;

/// √t is at least this share of how far the surface extends, so that heat arrives everywhere.
const LEAST_REACH: f64 = 1.0 / 250.0;

/// One step of diffusion of tangent vectors, factored.
#[derive(Debug)]
pub struct VectorHeat {
    pub(super) surface: Arc<Surface>,
    pub(super) frames: Frames,
    /// `#V` of the half-edge mesh: where the surface is no manifold, a vertex has a plane for each of its fans.
    pub(super) planes: Vec<TangentPlane>,
    pub(super) systems: Arc<Systems>,
    /// In the file's unit, squared.
    time: f64,
    pub(super) diffusion: System<c64>,
    /// Made when it is first needed.
    heat: OnceLock<HeatFlow>,
    /// Laid out when it is first needed.
    pub(super) geometry: OnceLock<ExactGeometry>,
}

impl VectorHeat {
    /// On the intrinsic Delaunay triangulation, for a time of the squared mean edge; on surfaces that extend farther than a few hundred mean
    /// edges for a longer one.
    ///
    /// # Errors
    /// [`NotPositiveDefinite`](crate::Error::NotPositiveDefinite) on degenerate triangles; [`OutOfMemory`](crate::Error::OutOfMemory);
    /// [`Cancelled`](crate::Error::Cancelled).
    pub fn new(surface: &Arc<Surface>, progress: Progress<'_>) -> Result<Self> {
        let mut frames = Frames::new(IntrinsicTriangulation::of_surface(surface))?;
        frames.flip_to_delaunay();
        let operators = Operators::of_triangulation(frames.triangulation());
        let time = operators.mean_edge().max(LEAST_REACH * surface.bounding_radius()).powi(2);
        let systems = Systems::new(operators, LinearSolver::Cholesky, progress)?;
        let matrix = ConnectionLaplacian::new(&frames, systems.operators()).heat_matrix(time);
        let diffusion = systems.system_of(matrix, progress)?;
        let planes = frames.in_space(surface);
        let (heat, geometry) = (OnceLock::new(), OnceLock::new());
        Ok(Self { surface: Arc::clone(surface), frames, planes, systems, time, diffusion, heat, geometry })
    }

    /// The tangent planes of vertices (`#V`), whose numbers those of the [connection Laplacian](Self::connection_laplacian) are. Where
    /// the surface is no manifold, they are those of the first fan of each.
    pub fn tangent_planes(&self) -> &[TangentPlane] {
        &self.planes[..self.surface.vertex_count()]
    }

    /// That of the intrinsic Delaunay triangulation, `#V` of the half-edge mesh, whose first ones are those of the surface.
    pub fn connection_laplacian(&self) -> ConnectionLaplacian {
        ConnectionLaplacian::new(&self.frames, self.systems.operators())
    }

    /// Vectors at points, carried to all vertices (`#V × 3`): each goes where its point is the nearest, in the plane of the normal of the
    /// vertex, and between two points lengths and directions go over into each other. Not numbers where no point reaches.
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::BadParameter`] for a vector that is zero, not finite or square to the surface; those of
    /// [`ToPoint::to_point`] and [`Self::new`].
    pub fn transport<P: ToPoint>(&self, vectors: &[(P, DVec3)], progress: Progress<'_>) -> Result<VertexData<DVec3>> {
        let mut supply = vec![c64::new(0.0, 0.0); self.planes.len()];
        let mut lengths = Vec::new();
        for &(point, vector) in vectors {
            let place = point.to_point(&self.surface)?.place();
            lengths.push((place, self.supply(place, vector, &mut supply)?));
        }
        let directions = self.diffusion.solve(&supply)?;
        let lengths = self.extended(&lengths, progress)?;
        let value = |vertex: VertexId| {
            let direction = directions[vertex.index()];
            self.planes[vertex.index()].vector(direction / direction.magnitude()) * lengths[vertex.index()]
        };
        Ok(self.surface.vertices().map(value).collect())
    }

    /// Numbers at points, carried to all vertices (`#V`): each vertex has that of the nearest point, and between two points they go over
    /// into each other. Not numbers where no point reaches.
    ///
    /// # Errors
    /// [`Error::NoSource`]; those of [`ToPoint::to_point`] and [`Self::new`].
    pub fn extend<P: ToPoint>(&self, numbers: &[(P, f64)], progress: Progress<'_>) -> Result<VertexData<f64>> {
        let placed = |&(point, number): &(P, f64)| Ok((point.to_point(&self.surface)?.place(), number));
        let placed = numbers.iter().map(placed).collect::<Result<Vec<_>>>()?;
        let extended = self.extended(&placed, progress)?;
        Ok(self.surface.vertices().map(|vertex| extended[vertex.index()]).collect())
    }

    /// Adds a vector at a place to the supply of the vertices around it. Returns how long it is along the surface.
    fn supply(&self, place: Place, vector: DVec3, supply: &mut [c64]) -> Result<f64> {
        let normal = self.normal(place);
        let along = vector - normal * vector.dot(normal);
        // Of a vector that is not finite, or zero, the comparison does not hold.
        if !(vector.is_finite() && along.length() > SQUARE * vector.length()) {
            let range = "a finite vector that is not square to the surface";
            return Err(Error::BadParameter { name: "the vector", value: vector.to_string(), range });
        }
        for (vertex, weight) in self.support(place) {
            let number = self.planes[vertex.index()].number(along);
            supply[vertex.index()] += number * (weight / number.magnitude());
        }
        Ok(along.length())
    }

    /// Of unit length.
    fn normal(&self, place: Place) -> DVec3 {
        match place.vertex(&self.surface) {
            Some(vertex) => self.planes[vertex.index()].normal,
            None => place
                .faces(&self.surface)
                .into_iter()
                .map(|face| self.surface.face_normal(face))
                .sum::<DVec3>()
                .normalize(),
        }
    }

    /// The vertices that a place is between, in the half-edge mesh, with its weights.
    fn support(&self, place: Place) -> Vec<(VertexId, f64)> {
        let faces = place.faces(&self.surface);
        let Some(&face) = faces.first() else { return Vec::new() };
        let weights = place.weights_in(&self.surface, face);
        let vertex = |k: usize| VertexId(self.surface.mesh().vertex(face.halfedge(k)).0);
        (0..3).filter(|&k| weights[k] > 0.0).map(|k| (vertex(k), weights[k])).collect()
    }

    fn scalars(&self, numbers: &[(Place, f64)]) -> Vec<f64> {
        let mut supply = vec![0.0; self.planes.len()];
        for &(place, number) in numbers {
            self.support(place).into_iter().for_each(|(vertex, weight)| supply[vertex.index()] += weight * number);
        }
        supply
    }

    /// The heat of numbers.
    pub(super) fn heat(&self, progress: Progress<'_>) -> Result<&HeatFlow> {
        if self.heat.get().is_none() {
            let heat = HeatFlow::new(&self.systems, self.time, Condition::Neumann, progress)?;
            // Of two that are made at once one is kept; they are the same.
            let _ = self.heat.set(heat);
        }
        Ok(self.heat.get().expect("it was made above"))
    }

    /// [`Self::extend`] to the vertices of the half-edge mesh.
    fn extended(&self, numbers: &[(Place, f64)], progress: Progress<'_>) -> Result<Vec<f64>> {
        if numbers.is_empty() {
            return Err(Error::NoSource);
        }
        let flow = self.heat(progress)?;
        let ones: Vec<(Place, f64)> = numbers.iter().map(|&(place, _)| (place, 1.0)).collect();
        let (sums, counts) = (flow.solve(&self.scalars(numbers))?, flow.solve(&self.scalars(&ones))?);
        Ok(sums.iter().zip(&counts).map(|(sum, count)| sum / count).collect())
    }

    /// Distance from straight lines in faces as their normals tell it (`#V`, in the file's unit), negative on their left, whether they make
    /// closed curves or broken ones.
    /// `known`: the distances of vertices beside them (`#V`), from which it goes on. Not a number on components where none is known.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(crate) fn signed_distance(
        &self,
        lines: impl Iterator<Item = (FaceId, [Place; 2])>,
        known: &VertexData<Option<f64>>,
        progress: Progress<'_>,
    ) -> Result<VertexData<f64>> {
        let (mesh, operators) = (self.surface.mesh(), self.systems.operators());
        let mut normals = vec![c64::new(0.0, 0.0); self.planes.len()];
        for (face, ends) in lines {
            let along = ends[1].position(&self.surface) - ends[0].position(&self.surface);
            let to_right = along.cross(self.surface.face_normal(face));
            let [start, end] = ends.map(|place| place.weights_in(&self.surface, face));
            for k in 0..3 {
                let vertex = mesh.vertex(face.halfedge(k)).index();
                let number = self.planes[vertex].number(to_right);
                // As long as it is, also where the vertex is bent away from the face.
                if number.magnitude() > 0.0 {
                    normals[vertex] += number * (0.5 * (start[k] + end[k]) * along.length() / number.magnitude());
                }
            }
        }
        let diffused = self.diffusion.solve(&normals)?;
        let unit = |[x, y]: [f64; 2]| {
            let length = x.hypot(y);
            if length > 0.0 { [x / length, y / length] } else { [0.0; 2] }
        };
        let field: Vec<[f64; 2]> = self.frames.in_faces(&diffused).into_iter().map(unit).collect();

        // Vertices of the half-edge mesh; the first ones have the numbers of those that they are copies of.
        let mut fixed: Vec<Option<f64>> = mesh.vertices().map(|copy| known[self.surface.vertex_of_cut(copy)]).collect();
        let components = operators.components();
        let mut is_reached = vec![false; self.planes.len()];
        (0..fixed.len())
            .filter(|&vertex| fixed[vertex].is_some())
            .for_each(|vertex| is_reached[components[vertex] as usize] = true);
        let mut is_grounded = is_reached.clone();
        for (vertex, fixed) in fixed.iter_mut().enumerate() {
            if !std::mem::replace(&mut is_grounded[components[vertex] as usize], true) {
                *fixed = Some(0.0);
            }
        }
        let laplacian = operators.laplacian();
        let mut right = operators.divergence(&field);
        for ([a, b], weight) in laplacian.edges() {
            for (from, to) in [(a as usize, b as usize), (b as usize, a as usize)] {
                right[to] += weight * fixed[from].unwrap_or(0.0);
            }
        }
        right.iter_mut().zip(&fixed).for_each(|(right, fixed)| *right = fixed.unwrap_or(*right));
        let matrix = laplacian.combine(|_| 0.0, |vertex| fixed[vertex].is_some());
        let values = self.systems.system_of(matrix, progress)?.solve(&right)?;
        let value = |vertex: VertexId| {
            let is_reached = is_reached[components[vertex.index()] as usize];
            if is_reached { values[vertex.index()] } else { f64::NAN }
        };
        Ok(self.surface.vertices().map(value).collect())
    }
}
