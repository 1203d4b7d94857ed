//! Geodesic distance by the heat method: `(M + tL) u = δ`, `X = −∇u / |∇u|`, `L φ = div X`.
//!
//! The heat matrix is divided by t, so that no number here depends on the file's unit.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), algorithm 1; section 3.2.2 for the boundary.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::cholesky::{Factor, Symbolic};
use crate::dijkstra;
use crate::error::{Error, Result};
use crate::halfedge::FaceData;
use crate::laplacian::Laplacian;
use crate::ordering::Ordering;
use crate::sources::{self, SurfacePoint};
use crate::surface::Surface;
use crate::triangle;

/// Heat supplied at a source. Near the largest float, so that heat falls through 1,375 e-folds, not 708, before it
/// reaches the smallest normal float.
const SOURCE_HEAT: f64 = 1e290;

/// Heat falls by about one e-fold per √t of distance. √t is at least the surface's extent over this: the e-folds that
/// `SOURCE_HEAT` leaves room for, less an eighth for triangles that slow heat down.
const EFOLDS: f64 = 1200.0;

/// What heat does at the boundary of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Boundary {
    /// None flows out: lines of equal distance meet the boundary at right angles.
    #[default]
    Neumann,
    /// It is held at 0, except at sources. Pieces that are all boundary fall back to Neumann.
    Dirichlet,
    /// The mean of both, nearest to the true distance where the time factor is large.
    Average,
}

/// The dials of the method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// m in t = m h², h the mean edge; positive, no unit. Larger is smoother.
    pub time_factor: f64,
    /// What heat does at the boundary.
    pub boundary: Boundary,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { time_factor: 1.0, boundary: Boundary::Neumann }
    }
}

/// A stage of the precomputation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Building the matrices.
    Assembling,
    /// Choosing the elimination order.
    Ordering,
    /// Finding the pattern of the factors.
    Analysing,
    /// Factoring `L`.
    FactoringPoisson,
    /// Factoring `M / t + L`, for each boundary condition needed.
    FactoringHeat,
}

impl fmt::Display for Stage {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Assembling => "Assembling",
            Self::Ordering => "Ordering",
            Self::Analysing => "Analysing",
            Self::FactoringPoisson => "Factoring Poisson",
            Self::FactoringHeat => "Factoring heat",
        })
    }
}

/// Called before each stage with the fraction done so far, 0 to 1. `Break` ends the work with [`Error::Cancelled`].
pub type Progress<'a> = &'a mut dyn FnMut(Stage, f64) -> ControlFlow<()>;

fn report(progress: &mut dyn FnMut(Stage, f64) -> ControlFlow<()>, stage: Stage, done: f64) -> Result<()> {
    if progress(stage, done).is_break() { Err(Error::Cancelled) } else { Ok(()) }
}

/// The factored surface: expensive to make, cheap to ask.
#[derive(Debug)]
pub struct HeatSolver {
    surface: Arc<Surface>,
    parameters: Parameters,
    laplacian: Laplacian,
    symbolic: Arc<Symbolic>,
    poisson: Factor,
    /// Heat that does not leave; absent where the boundary condition does not need it.
    neumann: Option<Arc<Factor>>,
    /// Heat held at 0 where `held`; absent where the boundary condition does not need it.
    dirichlet: Option<Arc<Factor>>,
    /// Per point whether Dirichlet holds it: the boundary of pieces that also have an inside.
    held: Vec<bool>,
    /// Any point of each piece, where the Poisson solution is held at 0.
    pinned: Vec<u32>,
    /// Largest distance along edges, in the file's unit.
    extent: f64,
}

impl HeatSolver {
    /// Factors a surface.
    ///
    /// # Errors
    /// [`Error::BadParameter`]; [`Error::Cancelled`]; [`Error::NotPositiveDefinite`]; [`Error::OutOfMemory`].
    pub fn new(surface: impl Into<Arc<Surface>>, parameters: Parameters, progress: Progress<'_>) -> Result<Self> {
        check(parameters)?;
        let surface = surface.into();
        report(progress, Stage::Assembling, 0.0)?;
        let laplacian = Laplacian::new(&surface);
        let extent = dijkstra::extent(&surface);
        report(progress, Stage::Ordering, 0.1)?;
        let permutation = Symbolic::order(Ordering::default(), &laplacian.column_start, &laplacian.rows)?;
        report(progress, Stage::Analysing, 0.2)?;
        let symbolic = Symbolic::analyse(permutation, laplacian.column_start.clone(), laplacian.rows.clone())?;
        let symbolic = Arc::new(symbolic);

        let mut is_pinned = vec![false; surface.point_count()];
        let mut pinned = Vec::with_capacity(surface.report.components);
        for (point, &component) in surface.component_of_point.iter().enumerate() {
            if component as usize == pinned.len() {
                pinned.push(point as u32);
                is_pinned[point] = true;
            }
        }
        report(progress, Stage::FactoringPoisson, 0.3)?;
        let grounded = laplacian.combine(0.0, |point| is_pinned[point]);
        let poisson = symbolic.factor(&grounded, "Poisson")?;
        drop(grounded);

        let held = dirichlet_points(&surface);
        let mut solver = Self {
            surface,
            parameters,
            laplacian,
            symbolic,
            poisson,
            neumann: None,
            dirichlet: None,
            held,
            pinned,
            extent,
        };
        solver.factor_heat(parameters, 0.65, progress)?;
        Ok(solver)
    }

    /// Changes parameters; factors the heat matrices that this touches, with the order found before.
    ///
    /// # Errors
    /// As [`HeatSolver::new`]. After an error the solver still answers, with the old parameters: the old factors go
    /// only when the new ones are there.
    pub fn set_parameters(&mut self, parameters: Parameters, progress: Progress<'_>) -> Result<()> {
        check(parameters)?;
        self.factor_heat(parameters, 0.0, progress)
    }

    /// Factors the heat matrices that are needed and absent, drops those not needed.
    fn factor_heat(&mut self, parameters: Parameters, done: f64, progress: Progress<'_>) -> Result<()> {
        let any_held = self.held.contains(&true);
        let boundary = if any_held { parameters.boundary } else { Boundary::Neumann };
        let wants_neumann = boundary != Boundary::Dirichlet;
        let wants_dirichlet = boundary != Boundary::Neumann;
        let time = self.time_with(parameters);
        let is_current = time == self.time();
        let mut neumann = self.neumann.clone().filter(|_| is_current && wants_neumann);
        let mut dirichlet = self.dirichlet.clone().filter(|_| is_current && wants_dirichlet);
        if wants_neumann && neumann.is_none() {
            report(progress, Stage::FactoringHeat, done)?;
            let values = self.laplacian.combine(1.0 / time, |_| false);
            neumann = Some(Arc::new(self.symbolic.factor(&values, "heat")?));
        }
        if wants_dirichlet && dirichlet.is_none() {
            report(progress, Stage::FactoringHeat, if wants_neumann { 0.5 * (done + 1.0) } else { done })?;
            let values = self.laplacian.combine(1.0 / time, |point| self.held[point]);
            dirichlet = Some(Arc::new(self.symbolic.factor(&values, "heat")?));
        }
        (self.parameters, self.neumann, self.dirichlet) = (parameters, neumann, dirichlet);
        Ok(())
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// The parameters in force.
    pub fn parameters(&self) -> Parameters {
        self.parameters
    }

    /// The diffusion time t, in the file's unit squared: m h², or more on long surfaces, where heat would underflow.
    pub fn time(&self) -> f64 {
        self.time_with(self.parameters)
    }

    fn time_with(&self, parameters: Parameters) -> f64 {
        let root = parameters.time_factor.sqrt() * self.surface.mean_edge;
        root.max(self.extent / EFOLDS).powi(2)
    }

    /// Stored entries of all factors together, zeros inside supernodes counted.
    pub fn factor_nonzeros(&self) -> usize {
        let heat = [&self.neumann, &self.dirichlet];
        self.poisson.nonzeros() + heat.into_iter().flatten().map(|factor| factor.nonzeros()).sum::<usize>()
    }

    /// Distance of every point from the nearest source.
    ///
    /// With several sources their heat is superposed, and each ends near 0, not at it: see [`Distance::values`].
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::BadVertex`] and [`Error::BadPoint`] for a source that is not on the surface.
    pub fn distance(&self, sources: &[SurfacePoint]) -> Result<Distance> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        let surface = &*self.surface;
        let sources: Vec<SurfacePoint> =
            sources.iter().map(|source| source.validated(surface)).collect::<Result<_>>()?;
        let heat = self.heat(&sources);
        let mut values = self.laplacian.divergence_of_descent(surface, &heat);
        for &point in &self.pinned {
            values[point as usize] = 0.0;
        }
        self.poisson.solve_in_place(&mut values);
        sources::shift(surface, &sources, &mut values);
        Ok(Distance { values, heat, sources })
    }

    /// Heat `u` after time t, of sources superposed, under the boundary condition.
    fn heat(&self, sources: &[SurfacePoint]) -> Vec<f64> {
        let mut supply = vec![0.0; self.surface.point_count()];
        for (point, amount) in sources::spread(&self.surface, sources) {
            supply[point as usize] += amount * SOURCE_HEAT;
        }
        match (&self.neumann, &self.dirichlet) {
            (Some(neumann), None) => {
                neumann.solve_in_place(&mut supply);
                supply
            }
            (None, Some(dirichlet)) => self.held_heat(dirichlet, &supply),
            (Some(neumann), Some(dirichlet)) => {
                let mut heat = self.held_heat(dirichlet, &supply);
                neumann.solve_in_place(&mut supply);
                for (heat, free) in heat.iter_mut().zip(&supply) {
                    *heat = 0.5 * (*heat + free);
                }
                heat
            }
            (None, None) => unreachable!("factor_heat leaves at least one heat factor"),
        }
    }

    /// Heat under Dirichlet conditions. Sources on the boundary must not be held at 0, or no heat would enter, but
    /// the factor holds every boundary point. So heat is prescribed there instead: `d = supply / diagonal` at these
    /// points gives a response `v` of the inside by one more solve, and the amount `s v` follows from the balance
    /// `dᵀ A (s v) = dᵀ supply`. For one source point on the boundary this is the exact solution of the matrix with
    /// that point free; for several it fixes their ratios.
    fn held_heat(&self, dirichlet: &Factor, supply: &[f64]) -> Vec<f64> {
        let time = self.time();
        let held = |point: usize| self.held[point];
        let mut inside = supply.to_vec();
        let mut response = vec![0.0; supply.len()];
        let mut any_on_boundary = false;
        let mut any_inside = false;
        for point in 0..supply.len() {
            if held(point) {
                inside[point] = 0.0;
                if supply[point] > 0.0 {
                    let diagonal = self.laplacian.column(point).start;
                    let entry = self.laplacian.stiffness[diagonal] + self.laplacian.mass[point] / time;
                    response[point] = supply[point] / entry;
                    any_on_boundary = true;
                }
            } else {
                any_inside |= supply[point] > 0.0;
            }
        }
        if any_inside {
            dirichlet.solve_in_place(&mut inside);
        }
        if !any_on_boundary {
            return inside;
        }
        let prescribed = response.clone();
        let outflow = self.apply_heat(&prescribed);
        for point in 0..response.len() {
            response[point] = if held(point) { 0.0 } else { -outflow[point] };
        }
        dirichlet.solve_in_place(&mut response);
        for point in 0..response.len() {
            response[point] += prescribed[point];
        }
        // Products of two heats would overflow; the ratio needs only the shape of d.
        let flow = self.apply_heat(&response);
        let from_inside = self.apply_heat(&inside);
        let (mut wanted, mut given) = (0.0, 0.0);
        for point in (0..flow.len()).filter(|&point| prescribed[point] > 0.0) {
            let shape = prescribed[point] / SOURCE_HEAT;
            wanted += shape * (supply[point] - from_inside[point]);
            given += shape * flow[point];
        }
        let amount = if given > 0.0 { wanted / given } else { 1.0 };
        inside.iter().zip(&response).map(|(inside, response)| inside + amount * response).collect()
    }

    /// `(M / t + L) u` with every point free.
    fn apply_heat(&self, heat: &[f64]) -> Vec<f64> {
        let time = self.time();
        let mut result = vec![0.0; heat.len()];
        for point in 0..heat.len() {
            result[point] += self.laplacian.mass[point] / time * heat[point];
            for entry in self.laplacian.column(point) {
                let row = self.laplacian.rows[entry] as usize;
                let value = self.laplacian.stiffness[entry];
                result[row] += value * heat[point];
                if row != point {
                    result[point] += value * heat[row];
                }
            }
        }
        result
    }
}

fn check(parameters: Parameters) -> Result<()> {
    let value = parameters.time_factor;
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(Error::BadParameter { name: "the time factor", value: value.to_string(), range: "a positive number" })
    }
}

/// The boundary points of pieces that also have other points.
fn dirichlet_points(surface: &Surface) -> Vec<bool> {
    let mut has_inside = vec![false; surface.report.components];
    for (&component, is_boundary) in surface.component_of_point.iter().zip(&surface.is_boundary_point) {
        has_inside[component as usize] |= !is_boundary;
    }
    let components = surface.component_of_point.iter();
    let held = components.zip(&surface.is_boundary_point).map(|(&c, &boundary)| boundary && has_inside[c as usize]);
    held.collect()
}

/// Distance from a set of sources.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    /// `#P`, in the file's unit, non-negative, never NaN; infinity on pieces without a source. Exactly 0 at a source
    /// that is the only one of its piece and a vertex. With several on a piece, the mean over the sources is 0 before
    /// values below 0 become 0.
    pub values: Vec<f64>,
    /// `#P`, heat after time t, to an arbitrary scale near 10²⁹⁰.
    pub heat: Vec<f64>,
    /// The sources, validated.
    pub sources: Vec<SurfacePoint>,
}

impl Distance {
    /// The largest finite distance.
    pub fn max(&self) -> f64 {
        self.values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max)
    }

    /// Number of points on pieces without a source.
    pub fn unreachable(&self) -> usize {
        self.values.iter().filter(|value| value.is_infinite()).count()
    }

    /// `#F × 3`, gradient of the distance on each face; zero where it is infinite.
    pub fn gradients(&self, surface: &Surface) -> FaceData<glam::DVec3> {
        let gradient = |face| {
            let values = surface.faces[face].map(|point| self.values[point as usize]);
            triangle::gradient(surface.corners(face), values)
        };
        surface.mesh.faces().map(gradient).collect::<Vec<_>>().into()
    }
}
