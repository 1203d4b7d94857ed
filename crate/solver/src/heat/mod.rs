//! Geodesic distance by the heat method: `(M + tL) u = δ`, `X = −∇u / |∇u|`, `L φ = div X`. Where the time is chosen, X is
//! the unit field of log u, and distance follows it from vertex to vertex, without the Poisson equation.
//!
//! The heat matrix is divided by t, so that no number here depends on the file's unit.
//!
//! [`Systems`] (how matrices of one pattern are solved) → [`HeatFlow`] and [`Poisson`] (any right side, any constraints) →
//! [`HeatMethod`] (all that is factored of any [`HeatDiscretization`]) → [`Factorization`] (that of a surface) → [`Query`] (what is asked)
//! → [`Distance`](crate::Distance). [`HeatSolver`] keeps a factorization and the options of its queries together.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), algorithm 1; section 3.2.2 for the boundary.

mod answer;
mod bounds;
mod constraint;
mod convergence;
mod discretization;
mod factorization;
mod field;
mod flow;
mod log_map;
mod method;
mod order;
mod point_source;
mod poisson;
mod query;
mod region;
mod solver;
mod source_heat;
mod systems;
mod time;
mod triangles;
mod vectors;

pub use answer::Refinement;
pub use bounds::Bounds;
pub use constraint::Constraint;
pub use convergence::{Convergence, Residuals};
pub use discretization::HeatDiscretization;
pub use factorization::Factorization;
pub use field::{Field, RightSide};
pub use flow::{Condition, HeatFlow};
pub use method::HeatMethod;
pub use order::WarmestFirst;
pub use point_source::PointSource;
pub use poisson::Poisson;
pub use query::Query;
pub use region::{ExactRegion, grow};
pub use solver::HeatSolver;
pub use source_heat::SourceHeat;
pub use systems::Systems;
pub use time::long_edge_factor;
pub use vectors::VectorHeat;
