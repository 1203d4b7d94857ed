//! The dials of the heat method, by their names on the command line.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use heatwalk::{Boundary, LinearSolver, MemoryLimit, MultiSource, NearField, Operator, Parameters, TimeStep};

type Named<T, const N: usize> = [(&'static str, T); N];

const OPERATORS: Named<Operator, 3> =
    [("delaunay", Operator::Delaunay), ("plain", Operator::Plain), ("relocate", Operator::Relocate)];

const BOUNDARIES: Named<Boundary, 3> =
    [("neumann", Boundary::Neumann), ("dirichlet", Boundary::Dirichlet), ("average", Boundary::Average)];

pub const LINEAR_SOLVERS: Named<LinearSolver, 2> =
    [("cholesky", LinearSolver::Cholesky), ("cg", LinearSolver::ConjugateGradients)];

pub const MULTI_SOURCES: Named<MultiSource, 2> =
    [("exact", MultiSource::Exact), ("superposed", MultiSource::Superposed)];

/// The dials that every command with heat has.
#[derive(Args)]
pub struct Dials {
    /// Triangles that carry the operators
    #[arg(long, default_value = "delaunay", value_parser = one_of(&OPERATORS))]
    pub operator: Operator,
    /// Time step in squares of the mean edge length, or auto
    #[arg(long = "t", value_name = "M", default_value = "auto", value_parser = time_step, allow_negative_numbers = true)]
    pub time_step: TimeStep,
    /// What heat does at the boundary
    #[arg(long, default_value = "neumann", value_parser = one_of(&BOUNDARIES))]
    pub boundary: Boundary,
    /// Radius of exact distances around the sources in mean edge lengths, or auto
    #[arg(long = "near", value_name = "R", default_value = "auto", value_parser = near_field, allow_negative_numbers = true)]
    pub near_field: NearField,
}

impl Dials {
    pub fn parameters(&self, solver: LinearSolver, sources: MultiSource) -> Parameters {
        let Self { operator, time_step, boundary, near_field } = *self;
        Parameters { operator, solver, time_step, boundary, sources, near_field, memory: MemoryLimit::Automatic }
    }
}

/// One of the values, by its name.
pub fn one_of<T: Copy + Send + Sync + 'static>(
    values: &'static [(&'static str, T)],
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(values.iter().map(|&(name, _)| name)).try_map(move |name| {
        let value = values.iter().find(|&&(known, _)| known == name);
        value.map(|&(_, value)| value).ok_or("not one of the names")
    })
}

fn time_step(text: &str) -> Result<TimeStep, String> {
    match text.parse::<f64>() {
        _ if text == "auto" => Ok(TimeStep::Automatic),
        Ok(factor) if factor.is_finite() && factor > 0.0 => Ok(TimeStep::Factor(factor)),
        _ => Err("it must be a positive number, or auto".to_owned()),
    }
}

fn near_field(text: &str) -> Result<NearField, String> {
    match text.parse::<f64>() {
        _ if text == "auto" => Ok(NearField::Automatic),
        Ok(edges) if edges >= 0.0 => Ok(NearField::Edges(edges)),
        _ => Err("it must be a number of mean edge lengths, 0 or more, or auto".to_owned()),
    }
}
