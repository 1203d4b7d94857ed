//! How long heat flows.

use crate::options::{FactorOptions, LinearSolver, TimeStep};

/// Heat falls by about one e-fold per √t of distance. √t is at least the extent over this: the e-folds that the
/// heat of a source leaves room for, less an eighth for elements that slow heat down.
const EFOLDS: f64 = 1200.0;

/// The same where the time is chosen for conjugate gradients, which leave noise at 10⁻¹² of the largest heat.
const ITERATED_EFOLDS: f64 = 27.0;

/// Of the edges, all but this share are no long ones.
const LONG_EDGES: f64 = 0.01;

/// m in t = m h², h being the mean edge, as given or else the one that suits, but large enough for heat to reach as far as `extent`.
pub(super) fn time_factor(options: FactorOptions, suited: f64, mean_edge: f64, extent: f64) -> f64 {
    let (factor, efolds) = match (options.time_step, options.solver) {
        (TimeStep::Automatic, LinearSolver::ConjugateGradients) => (suited, ITERATED_EFOLDS),
        (TimeStep::Automatic, LinearSolver::Cholesky) => (suited, EFOLDS),
        (TimeStep::Factor(factor), _) => (factor, EFOLDS),
    };
    factor.max((extent / (efolds * mean_edge)).powi(2))
}

/// The m with which √t is this share of long edges. Heat is lost within edges that are longer, and its fall tells nothing of distance.
pub fn long_edge_factor(mut edges: Vec<f64>, mean_edge: f64, share: f64) -> f64 {
    let rank = ((1.0 - LONG_EDGES) * edges.len() as f64) as usize;
    let long = if edges.is_empty() { 0.0 } else { *edges.select_nth_unstable_by(rank, f64::total_cmp).1 };
    (share * long / mean_edge).powi(2)
}
