//! How long heat flows.

use crate::options::{LinearSolver, TimeStep};

/// Heat falls by about one e-fold per √t of distance. √t is at least the surface's extent over this: the e-folds that the
/// heat of a source leaves room for, less an eighth for triangles that slow heat down.
const EFOLDS: f64 = 1200.0;

/// The same where the time is chosen for conjugate gradients, which leave noise at 10⁻¹² of the largest heat.
const ITERATED_EFOLDS: f64 = 27.0;

/// Root-mean-square deviation of edge lengths, as a share of their mean, up to which a mesh is even and from which on
/// it is not.
const EVENNESS: [f64; 2] = [0.15, 0.25];

/// m on even meshes and on others, where so short a time would follow the edges, up to the extents of `RESOLUTIONS`.
/// Measured on forty cases; the exact region takes the first rings, where a short time is too coarse on any mesh.
const SUITED_FACTORS: [f64; 2] = [0.3, 1.0];

/// Extents in mean edges up to which these hold. Beyond, m grows with the power of 2/3: what heat errs by for following
/// the edges falls as 1/m, what it errs by for rounding the distance off grows as √t, and so their sum falls with the
/// size of the edges.
const RESOLUTIONS: [f64; 2] = [80.0, 120.0];

/// m in t = m h², as given or chosen, but large enough for heat to reach everywhere.
pub(super) fn time_factor(
    step: TimeStep,
    solver: LinearSolver,
    suited_factor: f64,
    mean_edge: f64,
    extent: f64,
) -> f64 {
    let (factor, efolds) = match (step, solver) {
        (TimeStep::Automatic, LinearSolver::ConjugateGradients) => (suited_factor, ITERATED_EFOLDS),
        (TimeStep::Automatic, LinearSolver::Cholesky) => (suited_factor, EFOLDS),
        (TimeStep::Factor(factor), _) => (factor, EFOLDS),
    };
    factor.max((extent / (efolds * mean_edge)).powi(2))
}

/// m by the deviation of edge lengths as a share of their mean, and the extent in mean edges.
pub(super) fn suited_factor(deviation: f64, extent: f64) -> f64 {
    let [even, uneven] = EVENNESS;
    let unevenness = ((deviation - even) / (uneven - even)).clamp(0.0, 1.0);
    let [factor, resolution] = [SUITED_FACTORS, RESOLUTIONS].map(|[low, high]| low + (high - low) * unevenness);
    factor * (extent / resolution).max(1.0).powf(2.0 / 3.0)
}
