//! Geodesic distance by the heat method: `(M + tL) u = δ`, `X = −∇u / |∇u|`, `L φ = div X`. Where the time is chosen, X is
//! the unit field of log u, and distance follows it from vertex to vertex, without the Poisson equation.
//!
//! The heat matrix is divided by t, so that no number here depends on the file's unit.
//!
//! [`Systems`] (how matrices of one pattern are solved) → [`HeatFlow`] and [`Poisson`] (any right side, any constraints) →
//! [`Factorization`] of a surface (all that is factored) → [`Query`] (all that is not) → [`Distance`](crate::Distance). [`HeatSolver`] keeps a
//! factorization and the options of its queries together.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), algorithm 1; section 3.2.2 for the boundary.

mod answer;
mod bounds;
mod constraint;
mod convergence;
mod exact_region;
mod factorization;
mod field;
mod flow;
mod logarithm;
mod pair;
mod poisson;
mod query;
mod solver;
mod source_heat;
mod systems;
mod time;
mod upwind;

pub use answer::Refinement;
pub use constraint::Constraint;
pub use convergence::{Convergence, Residuals};
pub use factorization::Factorization;
pub use flow::{Condition, HeatFlow};
pub use pair::factor_pair;
pub use poisson::Poisson;
pub use query::Query;
pub use solver::HeatSolver;
pub use source_heat::SourceHeat;
pub use systems::Systems;
