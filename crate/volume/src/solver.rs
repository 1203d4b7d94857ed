//! One object that answers by any method.

use std::borrow::Cow;
use std::sync::Arc;

use heatwalk::{Parameters, Progress, go_on};

use crate::distance::{VolumeDistance, VolumeMethod};
use crate::error::{Error, Result};
use crate::heat::{self, VolumeHeat};
use crate::march::March;
use crate::measured::Measured;
use crate::mesh::TetMesh;
use crate::path::VolumePath;
use crate::point::{TetPoint, TetSource};

/// Mean edges around the sources that are marched ahead of quick answers by heat.
const QUICK_EDGES: f64 = 3.0;

/// How distances are found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeOptions {
    /// By which method.
    pub method: VolumeMethod,
    /// Vertices farther than this, in the file's unit, stay at infinity, and no work is done there unless the mesh is riddled; positive. Infinite for
    /// [`VolumeMethod::Heat`], which finds all distances at once.
    pub max_distance: f64,
    /// The options of [`VolumeMethod::Heat`]; the operator is not among them, since tetrahedra have one.
    pub heat: Parameters,
}

impl Default for VolumeOptions {
    fn default() -> Self {
        Self { method: VolumeMethod::default(), max_distance: f64::INFINITY, heat: Parameters::default() }
    }
}

impl VolumeOptions {
    /// This method with all else at its default.
    pub fn by(method: VolumeMethod) -> Self {
        Self { method, ..Self::default() }
    }

    /// For an answer in a fraction of the time, as while a source is dragged: with a smaller region of the march by
    /// [`VolumeMethod::Heat`].
    #[must_use]
    pub fn quick(self) -> Self {
        Self { heat: Parameters { exact_radius: self.heat.exact_radius.at_most(QUICK_EDGES), ..self.heat }, ..self }
    }

    fn check(&self) -> Result<()> {
        let bad = |range| {
            let (name, value) = ("the maximum distance", self.max_distance.to_string());
            Err(heatwalk::Error::BadParameter { name, value, range }.into())
        };
        if self.max_distance.is_nan() || self.max_distance <= 0.0 {
            return bad("a positive number");
        }
        if self.method == VolumeMethod::Heat && self.max_distance.is_finite() {
            return bad("infinite for heat, which finds all distances at once");
        }
        Ok(())
    }
}

/// Distances and paths in a mesh by any [`VolumeMethod`]. What a method needs is made when it is first asked for, and kept.
#[derive(Debug)]
pub struct VolumeSolver {
    mesh: Arc<TetMesh>,
    measured: Measured,
    heat: Option<VolumeHeat>,
}

impl VolumeSolver {
    /// Of a mesh where all costs are 1.
    pub fn new(mesh: impl Into<Arc<TetMesh>>) -> Self {
        let mesh = mesh.into();
        let measured = Measured::new(&mesh, None).expect("without costs there is nothing to refuse");
        Self { mesh, measured, heat: None }
    }

    /// Of a mesh where each unit of length costs `costs` (`#T`), 10⁻³ to 10³, or infinity for walls, which nothing enters.
    ///
    /// # Errors
    /// [`Error::CostCount`]; [`Error::BadCost`]; [`Error::AllWalls`].
    pub fn with_costs(mesh: impl Into<Arc<TetMesh>>, costs: &[f64]) -> Result<Self> {
        let mesh = mesh.into();
        let measured = Measured::new(&mesh, Some(costs))?;
        Ok(Self { mesh, measured, heat: None })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Arc<TetMesh> {
        &self.mesh
    }

    /// Makes what a method needs before its first question: factors for [`VolumeMethod::Heat`], nothing for the march. The questions
    /// do so by themselves.
    ///
    /// # Errors
    /// [`Error::Heat`]: of its options, of memory, of a matrix that cannot be factored; cancelled.
    pub fn prepare(&mut self, options: &VolumeOptions, progress: Progress<'_>) -> Result<()> {
        options.check()?;
        if options.method == VolumeMethod::March {
            return Ok(());
        }
        let factored = options.heat.factor_options();
        let Measured { mesh, medium, .. } = &self.measured;
        heat::prepare(&mut self.heat, mesh, medium, factored, progress)
    }

    /// Distance of every vertex from the nearest source, or the least sum of initial distance and distance.
    ///
    /// # Errors
    /// [`Error::Heat`] with `NoSource` where there is none; as [`TetPoint::checked`]; [`Error::BadInitialDistance`];
    /// [`Error::SourceInWall`]; as [`Self::prepare`].
    pub fn distance<S: Into<TetSource> + Copy>(
        &mut self,
        sources: &[S],
        options: &VolumeOptions,
    ) -> Result<VolumeDistance> {
        self.prepare(options, &mut go_on)?;
        if sources.is_empty() {
            return Err(heatwalk::Error::NoSource.into());
        }
        let sources = sources.iter().enumerate().map(|(number, &source)| self.checked(number, source.into()));
        let sources = sources.collect::<Result<Vec<TetSource>>>()?;
        let Measured { mesh, medium, .. } = &self.measured;
        let points = sources.iter().map(|source| source.point).collect();
        let initial_distances = sources.iter().map(|source| source.initial_distance).collect();
        let mut distance = VolumeDistance {
            mesh: mesh.id(),
            values: Vec::new(),
            method: options.method,
            sources: points,
            initial_distances,
            exact_below: f64::INFINITY,
            heat: None,
            origins: None,
        };
        match (options.method, &self.heat) {
            (VolumeMethod::Heat, Some(heat)) => {
                let found = heat::distance(heat, &sources, &options.heat)?;
                distance.values = found.values;
                distance.heat = Some(found.heat);
                distance.exact_below = found.exact_below;
            }
            _ => {
                let march = March::new(mesh, medium, &sources);
                let found = march.within(self.measured.scaled(options.max_distance));
                distance.values = found.distances;
                distance.exact_below = found.exact_below;
                distance.origins = Some(found.origins);
            }
        }
        Ok(self.measured.outside(distance))
    }

    /// A shortest path from a place to the nearest source. Where costs differ, it descends the distance and refracts as that does.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`] for a distance of another mesh; as [`TetPoint::checked`]; [`Error::Unreachable`].
    pub fn path(&self, distance: &VolumeDistance, from: TetPoint) -> Result<VolumePath> {
        distance.require(&self.mesh)?;
        let from = from.checked(&self.mesh)?;
        self.measured.path(&self.measured.inside(Cow::Borrowed(distance)), from)
    }

    /// The distance at a place. By the march it is that of the vertex, or else that of the path from there, exact where straight lines lead to
    /// the source; infinity where there is none. By heat it is interpolated in the tetrahedron, and straight to a source in the same one.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`] for a distance of another mesh; as [`TetPoint::checked`].
    pub fn at(&self, distance: &VolumeDistance, point: TetPoint) -> Result<f64> {
        let interpolated = distance.at(&self.mesh, point)?;
        let TetPoint::Inside { tetrahedron, .. } = point.checked(&self.mesh)? else { return Ok(interpolated) };
        let place = point.position(&self.mesh);
        if distance.method == VolumeMethod::Heat {
            let corners = self.mesh.tetrahedra()[tetrahedron.index()];
            let is_beside = |source: &TetPoint| match source {
                TetPoint::Vertex(vertex) => corners.contains(&vertex.0),
                TetPoint::Inside { tetrahedron: own, .. } => *own == tetrahedron,
            };
            let cost = self.measured.cost(tetrahedron);
            let sources = distance.sources.iter().zip(&distance.initial_distances);
            let straight = sources.filter(|(source, _)| is_beside(source));
            let straight =
                straight.map(|(source, initial)| initial + cost * source.position(&self.mesh).distance(place));
            return Ok(straight.fold(interpolated, f64::min));
        }
        match self.path(distance, point) {
            Ok(path) => {
                let end = path.points[path.points.len() - 1];
                let sources = distance.sources.iter().zip(&distance.initial_distances);
                let there = sources.filter(|(source, _)| source.position(&self.mesh) == end);
                Ok(path.cost + there.map(|(_, &initial)| initial).reduce(f64::min).unwrap_or(0.0))
            }
            Err(Error::Unreachable) => Ok(f64::INFINITY),
            Err(error) => Err(error),
        }
    }

    /// What all is computed in.
    pub(crate) fn measured(&self) -> &Measured {
        &self.measured
    }

    /// Stored entries of all factors; 0 where nothing is factored.
    pub fn factor_nonzeros(&self) -> usize {
        self.heat.as_ref().map_or(0, VolumeHeat::factor_nonzeros)
    }

    /// m in t = m h² of the heat method; none before it was asked.
    pub fn time_factor(&self) -> Option<f64> {
        self.heat.as_ref().map(VolumeHeat::time_factor)
    }

    fn checked(&self, number: usize, source: TetSource) -> Result<TetSource> {
        let source = source.checked(&self.mesh)?;
        let is_open = |tetrahedron: u32| self.measured.medium.cost(tetrahedron).is_finite();
        let is_reached = match source.point {
            TetPoint::Vertex(vertex) => {
                self.mesh.around().row(vertex.0).iter().any(|&tetrahedron| is_open(tetrahedron))
            }
            TetPoint::Inside { tetrahedron, .. } => is_open(tetrahedron.0),
        };
        if !is_reached {
            return Err(Error::SourceInWall { source_number: number });
        }
        Ok(self.measured.source(source))
    }
}
