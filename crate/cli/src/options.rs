//! The options of the heat method, by their names on the command line.

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use heatwalk::{
    AUTOMATIC, Boundary, Choice, ExactRadius, LinearSolver, MemoryLimit, MultiSource, Operator, Parameters, TimeStep,
};

/// The options that every command with heat has.
#[derive(Args)]
pub struct Options {
    #[arg(long, value_parser = choice::<Operator>(), help = chosen::<Operator>("Triangles that carry the operators"))]
    pub operator: Option<Operator>,
    #[arg(long = "t", value_name = "M", allow_negative_numbers = true,
        help = with_default("Time step in squares of the mean edge length, or auto", AUTOMATIC))]
    pub time_step: Option<TimeStep>,
    #[arg(long, value_parser = choice::<Boundary>(), help = chosen::<Boundary>("What heat does at the boundary"))]
    pub boundary: Option<Boundary>,
    #[arg(long = "near", value_name = "R", allow_negative_numbers = true,
        help = with_default("Radius of exact distances around the sources in mean edge lengths, or auto", AUTOMATIC))]
    pub exact_radius: Option<ExactRadius>,
}

/// How linear systems are solved, where a command lets that be chosen.
#[derive(Args)]
pub struct Linear {
    #[arg(long, value_parser = choice::<LinearSolver>(), help = chosen::<LinearSolver>("How linear systems are solved"))]
    pub solver: Option<LinearSolver>,
}

impl Options {
    pub fn parameters(&self, solver: LinearSolver, sources: MultiSource) -> Parameters {
        Parameters {
            operator: self.operator.unwrap_or_default(),
            solver,
            time_step: self.time_step.unwrap_or_default(),
            boundary: self.boundary.unwrap_or_default(),
            sources,
            exact_radius: self.exact_radius.unwrap_or_default(),
            memory: MemoryLimit::Automatic,
        }
    }

    /// The first that is given.
    pub fn given(&self) -> Option<&'static str> {
        let operator = self.operator.map(|_| "--operator");
        let time_step = self.time_step.map(|_| "--t");
        let boundary = self.boundary.map(|_| "--boundary");
        operator.or(time_step).or(boundary).or(self.exact_radius.map(|_| "--near"))
    }
}

impl Linear {
    /// It, if it is given.
    pub fn given(&self) -> Option<&'static str> {
        self.solver.map(|_| "--solver")
    }
}

/// One of the choices, by its name.
pub fn choice<C: Choice>() -> impl TypedValueParser<Value = C> {
    let value = |choice: &C| PossibleValue::new(choice.name()).aliases(choice.former_names());
    PossibleValuesParser::new(C::ALL.iter().map(value)).try_map(|name| name.parse::<C>())
}

/// Help for a choice. The default is told here, because an option that is not given has to be seen as such.
pub fn chosen<C: Choice + Default>(help: &str) -> String {
    with_default(help, C::default().name())
}

fn with_default(help: &str, default: &str) -> String {
    format!("{help} [default: {default}]")
}
