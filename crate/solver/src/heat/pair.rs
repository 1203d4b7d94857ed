//! Heat and Poisson matrix made ready together.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::error::Result;
use crate::heat::flow::{Condition, HEAT_MATRIX, HeatFlow, Step};
use crate::heat::poisson::{POISSON_MATRIX, Poisson};
use crate::heat::systems::Systems;
use crate::operator::Discretization;

/// [`HeatFlow::new`] and [`Poisson::new`] in less time than both of them one after the other. `progress` is told the share of the work
/// done, 0 to 1.
///
/// # Errors
/// As they; [`Cancelled`](crate::Error::Cancelled).
pub fn factor_pair<D: Discretization>(
    systems: &Arc<Systems<D>>,
    time: f64,
    condition: Condition,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<(HeatFlow<D>, Poisson<D>)> {
    let poisson = Poisson::matrix(systems);
    let step = Step::lumped(systems, time, condition);
    let heat = step.matrix(systems.operators().laplacian());
    let [poisson, heat] = systems.systems([(poisson, POISSON_MATRIX), (heat, HEAT_MATRIX)], progress)?;
    Ok((HeatFlow::with_system(systems, step, heat), Poisson::with_system(systems, poisson)))
}
