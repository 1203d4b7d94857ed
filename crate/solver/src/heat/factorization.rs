//! All that is factored of a surface.

use std::sync::{Arc, Mutex};

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::{Surface, memory};

use crate::cost::Costs;
use crate::dijkstra;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::heat::method::HeatMethod;
use crate::heat::triangles::Triangles;
use crate::operator::Operators;
use crate::options::FactorOptions;

/// Bytes that the triangles of the operators, the matrices and what exact distances need take at once, a face.
const BYTES_PER_FACE: u64 = 268;

/// A surface with its factored heat and Poisson matrices: expensive to make, cheap to ask.
#[derive(Debug)]
pub struct Factorization {
    pub(super) method: HeatMethod<Triangles>,
    /// The wavefront of the last exact region, kept for its memory.
    pub(super) front: Mutex<Option<Wavefront>>,
}

impl Factorization {
    /// Factors a surface.
    ///
    /// # Errors
    /// [`BadParameter`](crate::Error::BadParameter); [`Cancelled`](crate::Error::Cancelled);
    /// [`NotPositiveDefinite`](crate::Error::NotPositiveDefinite); [`TooLarge`](crate::Error::TooLarge) where the factors
    /// do not fit, before any is made; [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn new(surface: impl Into<Arc<Surface>>, options: FactorOptions, progress: Progress<'_>) -> Result<Self> {
        Self::weighted(surface, None, options, progress)
    }

    /// The same where faces have costs.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Panics
    /// Where there is not one cost a face.
    pub fn weighted(
        surface: impl Into<Arc<Surface>>,
        costs: Option<Costs>,
        options: FactorOptions,
        progress: Progress<'_>,
    ) -> Result<Self> {
        let surface = surface.into();
        options.check()?;
        report(progress, Stage::Assembling, 0.0)?;
        memory::require(BYTES_PER_FACE * surface.face_count() as u64, "assembling the matrices")?;
        let extent = dijkstra::extent(&surface, costs.as_ref());
        let exact = ExactGeometry::new(Arc::clone(&surface));
        let exact = Arc::new(costs.as_ref().map_or(exact.clone(), |costs| exact.weighted(costs)));
        let triangles = Triangles::new(surface, costs, options, extent, exact);
        Ok(Self { method: HeatMethod::new(triangles, options, progress)?, front: Mutex::default() })
    }

    /// Changes the options; factors the matrices that this touches, with the order found before where the operator
    /// stays. Going back to a boundary condition and time of late factors nothing.
    ///
    /// # Errors
    /// As [`Factorization::new`]. After an error it still answers, with the old options: the old factors go only when the
    /// new ones are there.
    pub fn set_options(&mut self, options: FactorOptions, progress: Progress<'_>) -> Result<()> {
        options.check()?;
        let own = self.options();
        if (options.operator, options.solver) == (own.operator, own.solver) {
            return self.method.set_options(options, progress);
        }
        report(progress, Stage::Assembling, 0.0)?;
        self.method = HeatMethod::new(self.triangles().with_options(options), options, progress)?;
        Ok(())
    }

    fn triangles(&self) -> &Triangles {
        self.method.discretization()
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<Surface> {
        self.triangles().surface()
    }

    /// What a unit of length costs, where that is not 1 everywhere.
    pub fn costs(&self) -> Option<&Costs> {
        self.triangles().costs()
    }

    /// The operators that are factored.
    pub fn operators(&self) -> &Operators {
        self.triangles().operators()
    }

    /// What exact distances and paths need of the surface.
    pub fn exact_geometry(&self) -> &Arc<ExactGeometry> {
        self.triangles().exact()
    }

    /// The options in force.
    pub fn options(&self) -> FactorOptions {
        self.method.options()
    }

    /// The diffusion time t, in the file's unit squared: m h², or more on long surfaces, where heat would underflow.
    pub fn time(&self) -> f64 {
        self.method.time()
    }

    /// m in t = m h², with the t that holds.
    pub fn time_factor(&self) -> f64 {
        self.method.time_factor()
    }

    /// Stored entries of all factors that the options need, zeros inside supernodes counted; 0 for conjugate gradients.
    pub fn factor_nonzeros(&self) -> usize {
        self.method.factor_nonzeros()
    }
}
