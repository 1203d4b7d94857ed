//! Geodesic distance and shortest paths on triangle meshes by the heat method (Crane, Weischedel, Wardetzky 2013).

pub mod error;
pub mod io;
pub mod shapes;
pub mod soup;
