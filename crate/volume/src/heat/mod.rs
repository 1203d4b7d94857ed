//! Tetrahedra as the heat method of the crate `heatwalk` takes them.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), section 3.2.3. Distances around the sources are those of the
//! [march](crate::march): in tetrahedra whose four corners it reached, the field is their gradient. Where the time step is automatic, it is
//! that of the [`Logarithm`] of heat.

mod elements;
mod lengths;
mod logarithm;
mod unit;

use std::sync::Arc;

use glam::DVec3;
use heatwalk::heat::{
    Bounds, Constraint, ExactRegion, Field, HeatDiscretization, HeatMethod, PointSource, RightSide, grow,
};
use heatwalk::operator::{Discretization, Laplacian};
use heatwalk::{FactorOptions, Parameters, Progress, Stage, VertexId};

use crate::error::Result;
use crate::march::{March, Medium};
use crate::mesh::TetMesh;
use crate::point::TetSource;
use elements::Elements;
pub(crate) use elements::gradient_in;
use lengths::Lengths;
use logarithm::Logarithm;

/// Work of the march in the exact region on any mesh: that of some 300 vertices.
const LEAST_WORK: f64 = 3000.0;

/// All that is factored of a mesh.
pub(crate) type VolumeHeat = HeatMethod<Tetrahedra>;

/// The tetrahedra of a mesh that are no walls.
#[derive(Debug)]
pub(crate) struct Tetrahedra {
    mesh: Arc<TetMesh>,
    medium: Arc<Medium>,
    elements: Elements,
    lengths: Lengths,
    logarithm: Logarithm,
    bounds: Bounds,
}

/// What the heat method finds.
pub(crate) struct Found {
    pub(crate) values: Vec<f64>,
    pub(crate) heat: Vec<f64>,
    pub(crate) exact_below: f64,
}

/// Makes ready what options need, of what was made ready before.
pub(crate) fn prepare(
    heat: &mut Option<VolumeHeat>,
    mesh: &Arc<TetMesh>,
    medium: &Arc<Medium>,
    options: FactorOptions,
    progress: Progress<'_>,
) -> Result<()> {
    options.time_step.check()?;
    match heat {
        Some(heat) if heat.options().solver == options.solver => heat.set_options(options, progress)?,
        _ => {
            if progress(Stage::Assembling, 0.0).is_break() {
                return Err(heatwalk::Error::Cancelled.into());
            }
            *heat = Some(HeatMethod::new(Tetrahedra::new(mesh, medium), options, progress)?);
        }
    }
    Ok(())
}

/// Distances from sources that were checked.
pub(crate) fn distance(method: &VolumeHeat, sources: &[TetSource], parameters: &Parameters) -> Result<Found> {
    parameters.exact_radius.check()?;
    let tetrahedra = method.discretization();
    let points: Vec<PointSource> = sources.iter().map(|source| tetrahedra.source(source)).collect();
    let heat = method.heat(&points, parameters.sources)?;
    let mut march = March::new(&tetrahedra.mesh, &tetrahedra.medium, sources);
    let work = (work(method.field()) * tetrahedra.mesh.vertex_count() as f64).max(LEAST_WORK) as usize;
    let advance = |radius, work| Ok(march.advance(radius, work));
    let radius = grow(parameters.exact_radius, &points, tetrahedra.lengths.mean_edge, work, advance)?;
    let distances = march.into_distances();
    let reached: Vec<VertexId> = (0..)
        .map(VertexId)
        .zip(&distances)
        .filter(|&(_, &distance)| distance < radius)
        .map(|(vertex, _)| vertex)
        .collect();
    let region = ExactRegion::new(&distances, reached, radius);
    let values = method.distances(&points, parameters.sources, &heat, &region)?;
    Ok(Found { values, heat: heat.values, exact_below: radius })
}

/// Work of the march for each vertex of the mesh where its radius is chosen. Where all vertices see the sources, half of them take 5.5;
/// around obstacles each takes more.
fn work(field: Field) -> f64 {
    match field {
        Field::Unit => 5.5,
        Field::Logarithm => 2.5,
    }
}

impl Tetrahedra {
    fn new(mesh: &Arc<TetMesh>, medium: &Arc<Medium>) -> Self {
        let elements = Elements::new(mesh, medium);
        let lengths = Lengths::of(mesh, medium);
        let edges: Vec<f64> =
            elements.laplacian().edges().map(|(ends, _)| lengths::edge_cost(mesh, medium, ends)).collect();
        let logarithm = Logarithm::new(mesh, medium, elements.laplacian(), &edges, lengths.mean_edge);
        let ends = elements.laplacian().edges().map(|(ends, _)| ends);
        let bounds = Bounds::new(mesh.vertex_count(), ends.zip(edges), medium.least_cost());
        Self { mesh: Arc::clone(mesh), medium: Arc::clone(medium), elements, lengths, logarithm, bounds }
    }

    fn source(&self, source: &TetSource) -> PointSource {
        let touched = self.medium.touching(&self.mesh, source.point.corner(&self.mesh)).into_iter();
        PointSource {
            constraint: Constraint::new(source.point.support(&self.mesh), source.initial_distance),
            position: source.point.position(&self.mesh),
            cost: touched.map(|tetrahedron| self.medium.cost(tetrahedron)).fold(f64::INFINITY, f64::min),
        }
    }
}

impl Discretization for Tetrahedra {
    const ROUNDS: bool = true;

    fn laplacian(&self) -> &Laplacian {
        self.elements.laplacian()
    }

    fn components(&self) -> &[u32] {
        self.elements.components()
    }
}

impl HeatDiscretization for Tetrahedra {
    fn positions(&self) -> &[DVec3] {
        self.mesh.positions()
    }

    fn boundary(&self) -> Vec<bool> {
        self.mesh.is_on_boundary()
    }

    fn mean_edge(&self) -> f64 {
        self.lengths.mean_edge
    }

    fn extent(&self) -> f64 {
        self.lengths.extent
    }

    fn time_factor(&self, field: Field) -> f64 {
        self.lengths.time_factor(field)
    }

    /// Where tetrahedra are obtuse in few places only, so that heat falls along edges.
    fn has_logarithm(&self) -> bool {
        self.elements.is_monotone()
    }

    fn unit_field(&self, heat: &[f64], region: &ExactRegion<'_>) -> RightSide {
        unit::right_side(&self.mesh, &self.medium, heat, region)
    }

    fn along_logarithm(&self, heat: &[f64], time: f64, known: Vec<f64>) -> Vec<f64> {
        self.logarithm.distances(self.elements.laplacian(), heat, time, known)
    }

    fn bounds(&self, _: Field) -> Option<&Bounds> {
        Some(&self.bounds)
    }
}
