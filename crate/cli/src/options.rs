//! The options of the heat method, by their names on the command line.

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use heatwalk::{
    AUTOMATIC, Boundary, Choice, ExactRadius, LinearSolver, MemoryLimit, MultiSource, Operator, Parameters, TimeStep,
};

/// The options that every command with heat has.
#[derive(Args)]
pub struct Options {
    /// Triangles that carry the operators
    #[arg(long, default_value_t, value_parser = choice::<Operator>())]
    pub operator: Operator,
    /// Time step in squares of the mean edge length, or auto
    #[arg(long = "t", value_name = "M", default_value = AUTOMATIC, allow_negative_numbers = true)]
    pub time_step: TimeStep,
    /// What heat does at the boundary
    #[arg(long, default_value_t, value_parser = choice::<Boundary>())]
    pub boundary: Boundary,
    /// Radius of exact distances around the sources in mean edge lengths, or auto
    #[arg(long = "near", value_name = "R", default_value = AUTOMATIC, allow_negative_numbers = true)]
    pub exact_radius: ExactRadius,
}

impl Options {
    pub fn parameters(&self, solver: LinearSolver, sources: MultiSource) -> Parameters {
        let Self { operator, time_step, boundary, exact_radius } = *self;
        Parameters { operator, solver, time_step, boundary, sources, exact_radius, memory: MemoryLimit::Automatic }
    }
}

/// One of the choices, by its name.
pub fn choice<C: Choice>() -> impl TypedValueParser<Value = C> {
    let value = |choice: &C| PossibleValue::new(choice.name()).aliases(choice.former_names());
    PossibleValuesParser::new(C::ALL.iter().map(value)).try_map(|name| name.parse::<C>())
}
