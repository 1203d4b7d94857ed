//! Triangles of a surface as the heat method takes them.

mod logarithm;
pub(super) mod region;
mod time;
mod unit;
mod upwind;

use std::sync::Arc;

use glam::DVec3;
use heatwalk_base::sort;
use heatwalk_surface::{FaceId, HalfedgeId, Source, Surface, VertexId};

use crate::cost::Costs;
use crate::exact::{ExactGeometry, after};
use crate::extremum::{larger, smaller};
use crate::heat::bounds::Bounds;
use crate::heat::constraint::Constraint;
use crate::heat::discretization::HeatDiscretization;
use crate::heat::field::{Field, RightSide};
use crate::heat::point_source::PointSource;
use crate::heat::region::ExactRegion;
use crate::operator::{Discretization, Laplacian, Operators};
use crate::options::{FactorOptions, LinearSolver, Operator};
use logarithm::Logarithm;

/// A surface with the triangles that carry its operators.
#[derive(Debug)]
pub(super) struct Triangles {
    surface: Arc<Surface>,
    /// What a unit of length costs, where that is not 1 everywhere.
    costs: Option<Costs>,
    operators: Operators,
    /// For factors of the Delaunay triangulation.
    logarithm: Option<Logarithm>,
    /// The m that suits the triangles.
    suited_factor: f64,
    /// Largest distance along edges, in the file's unit times cost.
    extent: f64,
    exact: Arc<ExactGeometry>,
}

impl Triangles {
    pub(super) fn new(
        surface: Arc<Surface>,
        costs: Option<Costs>,
        options: FactorOptions,
        extent: f64,
        exact: Arc<ExactGeometry>,
    ) -> Self {
        let operators = Operators::weighted(&surface, costs.as_ref(), options.operator);
        let suited_factor = time::suited_factor(&operators, extent);
        let has_logarithm = (options.operator, options.solver) == (Operator::Delaunay, LinearSolver::Cholesky);
        let logarithm = has_logarithm.then(|| {
            let bumpiness = exact.bumpiness(&operators.laplacian().mass);
            Logarithm::new(&operators, bumpiness, bounds(&exact, costs.as_ref()))
        });
        Self { surface, costs, operators, logarithm, suited_factor, extent, exact }
    }

    /// The same surface with the triangles of other options.
    pub(super) fn with_options(&self, options: FactorOptions) -> Self {
        let (surface, exact) = (Arc::clone(&self.surface), Arc::clone(&self.exact));
        Self::new(surface, self.costs.clone(), options, self.extent, exact)
    }

    pub(super) fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    pub(super) fn costs(&self) -> Option<&Costs> {
        self.costs.as_ref()
    }

    pub(super) fn operators(&self) -> &Operators {
        &self.operators
    }

    pub(super) fn exact(&self) -> &Arc<ExactGeometry> {
        &self.exact
    }

    fn logarithm_for(&self, field: Field) -> Option<&Logarithm> {
        self.logarithm.as_ref().filter(|_| field == Field::Logarithm)
    }

    /// A source of the surface.
    pub(super) fn source(&self, source: &Source) -> PointSource {
        let place = source.place();
        let least = |costs: &Costs| {
            place.faces(&self.surface).into_iter().map(|face| costs.of(face)).fold(f64::INFINITY, f64::min)
        };
        PointSource {
            constraint: Constraint::new(place.support(&self.surface), source.initial_distance()),
            position: place.position(&self.surface),
            cost: self.costs.as_ref().map_or(1.0, least),
        }
    }
}

impl Discretization for Triangles {
    const ROUNDS: bool = Operators::ROUNDS;

    fn laplacian(&self) -> &Laplacian {
        self.operators.laplacian()
    }

    fn components(&self) -> &[u32] {
        self.operators.components()
    }
}

impl HeatDiscretization for Triangles {
    fn positions(&self) -> &[DVec3] {
        self.surface.positions().as_slice()
    }

    fn boundary(&self) -> Vec<bool> {
        self.surface.boundary_vertices().as_slice().to_vec()
    }

    /// The vertices in the order of the file.
    fn numbering(&self) -> Option<Vec<u32>> {
        let surface = &self.surface;
        let first_input = |vertex: VertexId| surface.inputs_of_vertex(vertex)[0];
        if surface.vertices().is_sorted_by_key(first_input) {
            return None;
        }
        let mut vertices: Vec<u32> = surface.vertices().map(|vertex| vertex.0).collect();
        sort::sort_by_key(&mut vertices, |&vertex| first_input(VertexId(vertex)));
        Some(vertices)
    }

    fn mean_edge(&self) -> f64 {
        self.operators.mean_edge()
    }

    fn extent(&self) -> f64 {
        self.extent
    }

    fn time_factor(&self, field: Field) -> f64 {
        let least = self.logarithm_for(field).map_or(0.0, Logarithm::least_time_factor);
        larger(self.suited_factor, least)
    }

    fn has_logarithm(&self) -> bool {
        self.logarithm.is_some()
    }

    fn logarithm_mass(&self) -> Option<&Arc<[f64]>> {
        self.logarithm.as_ref().map(Logarithm::mass)
    }

    fn unit_field(&self, heat: &[f64], region: &ExactRegion<'_>) -> RightSide {
        unit::right_side(&self.operators.elements, heat, region)
    }

    fn along_logarithm(&self, heat: &[f64], time: f64, known: Vec<f64>) -> Vec<f64> {
        let logarithm = self.logarithm.as_ref().expect("asked for where there is one");
        logarithm.distances(&self.operators, heat, time, known)
    }

    /// The unit field keeps what the paper makes of it.
    fn bounds(&self, field: Field) -> Option<&Bounds> {
        self.logarithm_for(field).map(Logarithm::bounds)
    }
}

/// Bounds on a surface whose faces have costs, or not.
fn bounds(geometry: &ExactGeometry, costs: Option<&Costs>) -> Bounds {
    let surface = geometry.surface();
    // A cost that all faces have is in the lengths of the geometry.
    let cost = |face: u32| geometry.costs().map_or(1.0, |costs| costs.of(FaceId(face)));
    let edge = |halfedge: HalfedgeId| {
        let (frame, k) = geometry.frame_of(halfedge.0);
        let faces = geometry.across(halfedge.0).map(|(other, _)| other / 3);
        let cost = faces.map(cost).fold(cost(halfedge.0 / 3), smaller);
        ([frame[k].vertex, frame[after(k)].vertex], cost * frame[k].length)
    };
    let least_cost = costs.map_or(1.0, |costs| costs.of_faces().iter().copied().fold(f64::INFINITY, smaller));
    Bounds::new(surface.vertex_count(), surface.edges().representatives().map(edge), least_cost)
}
