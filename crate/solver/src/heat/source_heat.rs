//! Heat of the sources of a distance.

use crate::error::Result;
use crate::heat::constraint::Constraint;
use crate::heat::flow::HeatFlow;
use crate::heat::point_source::PointSource;
use crate::operator::Discretization;
use crate::options::MultiSource;
use heatwalk_sparse::Functional;

/// Heat at a source. Near the largest float, so that heat falls through 1,375 e-folds, not 708, before it reaches the
/// smallest normal float.
const SOURCE_HEAT: f64 = 1e290;

/// Heat of sources, and which of them it comes from.
#[derive(Debug)]
pub struct SourceHeat {
    /// `#V`, to an arbitrary scale near 10²⁹⁰.
    pub values: Vec<f64>,
    /// Per source whether it is the nearest one to any vertex: those that are not would have to take heat out.
    pub is_active: Vec<bool>,
}

impl SourceHeat {
    /// The mean of the heat by each flow.
    ///
    /// # Errors
    /// [`NotConverged`](crate::Error::NotConverged) of conjugate gradients;
    /// [`OutOfMemory`](crate::Error::OutOfMemory).
    ///
    /// # Panics
    /// Without a flow.
    pub(super) fn new<'a, D: Discretization + 'a>(
        flows: impl Iterator<Item = &'a HeatFlow<D>>,
        sources: &[PointSource],
        multi_source: MultiSource,
    ) -> Result<Self> {
        let mut answers = flows.map(|flow| match multi_source {
            MultiSource::Exact => exact(flow, sources),
            MultiSource::Summed => summed(flow, sources),
        });
        let mut mean = answers.next().expect("some heat system is always there")?;
        for answer in answers {
            let other = answer?;
            for (value, other) in mean.values.iter_mut().zip(&other.values) {
                *value = 0.5 * (*value + other);
            }
            for (active, there) in mean.is_active.iter_mut().zip(other.is_active) {
                *active |= there;
            }
        }
        Ok(mean)
    }
}

/// Heat that falls from source to source as its logarithm does over distance.
fn exact(flow: &HeatFlow<impl Discretization>, sources: &[PointSource]) -> Result<SourceHeat> {
    let least = sources.iter().map(PointSource::initial_distance).fold(f64::INFINITY, f64::min);
    let level =
        |source: &PointSource| ((least - source.initial_distance()) / flow.time().sqrt() + SOURCE_HEAT.ln()).exp();
    let mut is_active = vec![true; sources.len()];
    loop {
        let active: Vec<usize> = (0..sources.len()).filter(|&index| is_active[index]).collect();
        if let [single] = active[..]
            && let Some(values) = single_source(flow, &sources[single].constraint)?
        {
            return Ok(SourceHeat { values, is_active });
        }
        let constraint = |&index: &usize| {
            let source = &sources[index];
            Constraint { functional: source.constraint.functional.clone(), value: level(source) }
        };
        let constraints: Vec<Constraint> = active.iter().map(constraint).collect();
        let (values, supplies) =
            flow.solve_constrained(&vec![0.0; flow.systems().operators().laplacian().size()], &constraints)?;
        // Sources of the least initial distance always give heat; rounding must not drop one of them.
        let takes = |&(&index, supply): &(&usize, f64)| supply < 0.0 && sources[index].initial_distance() > least;
        let dropped: Vec<usize> = active.iter().zip(supplies).filter(takes).map(|(&index, _)| index).collect();
        if dropped.is_empty() {
            return Ok(SourceHeat { values, is_active });
        }
        for index in dropped {
            is_active[index] = false;
        }
    }
}

/// Heat of one source, whose level is arbitrary. None where all of it would be lost at once.
fn single_source(flow: &HeatFlow<impl Discretization>, source: &Constraint) -> Result<Option<Vec<f64>>> {
    let support = source.functional.iter().filter(|&&(vertex, _)| !flow.condition().is_cold(vertex));
    let supply: Functional = support.map(|&(vertex, weight)| (vertex, weight * SOURCE_HEAT)).collect();
    if supply.is_empty() { Ok(None) } else { flow.solve_sparse(&supply).map(Some) }
}

/// The same amount of heat put in at each source. On cold vertices it raises them by what their diagonal entry makes of it.
fn summed(flow: &HeatFlow<impl Discretization>, sources: &[PointSource]) -> Result<SourceHeat> {
    let laplacian = flow.systems().operators().laplacian();
    let mut supply = vec![0.0; laplacian.size()];
    for &(vertex, weight) in sources.iter().flat_map(|source| &source.constraint.functional) {
        supply[vertex as usize] += weight * SOURCE_HEAT;
    }
    let mut prescribed = vec![0.0; supply.len()];
    for vertex in (0..supply.len()).filter(|&vertex| flow.condition().is_cold(vertex as u32) && supply[vertex] > 0.0) {
        let diagonal = laplacian.stiffness[laplacian.column(vertex).start];
        prescribed[vertex] = supply[vertex] / (diagonal + flow.step().share(vertex));
    }
    let values = flow.solve_prescribed(&supply, &prescribed)?;
    Ok(SourceHeat { values, is_active: vec![true; sources.len()] })
}
