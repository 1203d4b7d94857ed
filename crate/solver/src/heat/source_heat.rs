//! Heat of the sources of a distance.

use crate::error::Result;
use crate::heat::constraint::Constraint;
use crate::heat::flow::HeatFlow;
use crate::operator::Operators;
use crate::options::MultiSource;
use heatwalk_sparse::Functional;
use heatwalk_surface::{Source, Surface};

/// Heat at a source. Near the largest float, so that heat falls through 1,375 e-folds, not 708, before it reaches the
/// smallest normal float.
const SOURCE_HEAT: f64 = 1e290;

/// Heat of sources, and which of them it comes from.
pub(super) struct SourceHeat {
    /// `#V`, to an arbitrary scale near 10²⁹⁰.
    pub(super) values: Vec<f64>,
    /// Per source whether it is the nearest one to any vertex: those that are not would have to take heat out.
    pub(super) is_active: Vec<bool>,
}

impl SourceHeat {
    /// The mean of the heat by each flow; there is at least one.
    pub(super) fn new<'a>(
        surface: &Surface,
        operators: &Operators,
        flows: impl Iterator<Item = &'a HeatFlow>,
        sources: &[Source],
        multi_source: MultiSource,
    ) -> Result<Self> {
        let mut answers = flows.map(|flow| match multi_source {
            MultiSource::Exact => exact(surface, flow, sources),
            MultiSource::Summed => summed(surface, operators, flow, sources),
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
fn exact(surface: &Surface, flow: &HeatFlow, sources: &[Source]) -> Result<SourceHeat> {
    let least = sources.iter().map(|source| source.initial_distance()).fold(f64::INFINITY, f64::min);
    let level = |source: &Source| ((least - source.initial_distance()) / flow.time().sqrt() + SOURCE_HEAT.ln()).exp();
    let mut is_active = vec![true; sources.len()];
    loop {
        let active: Vec<usize> = (0..sources.len()).filter(|&index| is_active[index]).collect();
        if let [single] = active[..]
            && let Some(values) = single_source(surface, flow, &sources[single])?
        {
            return Ok(SourceHeat { values, is_active });
        }
        let constraint = |&index: &usize| {
            let source = &sources[index];
            Constraint::new(source.place().support(surface), level(source))
        };
        let constraints: Vec<Constraint> = active.iter().map(constraint).collect();
        let (values, supplies) = flow.solve_constrained(&vec![0.0; surface.vertex_count()], &constraints)?;
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
fn single_source(surface: &Surface, flow: &HeatFlow, source: &Source) -> Result<Option<Vec<f64>>> {
    let support = source.place().support(surface).filter(|&(vertex, _)| !flow.condition().is_cold(vertex.0));
    let supply: Functional = support.map(|(vertex, weight)| (vertex.0, weight * SOURCE_HEAT)).collect();
    if supply.is_empty() { Ok(None) } else { flow.solve_sparse(&supply).map(Some) }
}

/// The same amount of heat put in at each source. On cold vertices it raises them by what their diagonal entry makes of it.
fn summed(surface: &Surface, operators: &Operators, flow: &HeatFlow, sources: &[Source]) -> Result<SourceHeat> {
    let mut supply = vec![0.0; surface.vertex_count()];
    for (vertex, weight) in sources.iter().flat_map(|source| source.place().support(surface)) {
        supply[vertex.0 as usize] += weight * SOURCE_HEAT;
    }
    let laplacian = operators.laplacian();
    let mut prescribed = vec![0.0; supply.len()];
    for vertex in (0..supply.len()).filter(|&vertex| flow.condition().is_cold(vertex as u32) && supply[vertex] > 0.0) {
        let diagonal = laplacian.stiffness[laplacian.column(vertex).start];
        prescribed[vertex] = supply[vertex] / (diagonal + laplacian.mass[vertex] / flow.time());
    }
    let values = flow.solve_prescribed(&supply, &prescribed)?;
    Ok(SourceHeat { values, is_active: vec![true; sources.len()] })
}
