//! Geodesic distance and shortest paths on triangle meshes by the heat method (Crane, Weischedel, Wardetzky 2013).
//!
//! The way of the data: file bytes → [`Soup`] → [`Surface`] (welded, clean, oriented, with half-edges) →
//! [`HeatSolver`] (factored once) → [`Distance`] from any sources → [`Path`]s down it.
//!
//! ```
//! use std::ops::ControlFlow;
//! use heatwalk::{HeatSolver, Parameters, Surface, SurfacePoint, descend, shapes};
//!
//! # fn main() -> heatwalk::Result<()> {
//! let surface = Surface::build(&shapes::icosphere(3))?;
//! let solver = HeatSolver::new(surface, Parameters::default(), &mut |stage, done| {
//!     println!("{stage}, {:.0} %", 100.0 * done);
//!     ControlFlow::Continue(())
//! })?;
//! let distance = solver.distance(&[SurfacePoint::Vertex(0)])?;
//! assert!((distance.max() - std::f64::consts::PI).abs() < 0.1, "half a great circle of the unit sphere");
//!
//! let path = descend(solver.surface(), &distance, SurfacePoint::Vertex(7))?;
//! println!("{} units in {} pieces", path.length(), path.points.len() - 1);
//! # Ok(())
//! # }
//! ```

pub mod accuracy;
pub mod crowd;
mod csr;
mod dijkstra;
pub mod drawing;
mod edges;
pub mod error;
pub mod exact;
mod extremum;
pub mod gradient;
pub mod halfedge;
pub mod heat;
pub mod io;
mod linear;
mod memory;
pub mod operator;
pub mod overlay;
pub mod path;
mod random;
pub mod shapes;
pub mod soup;
pub mod sources;
pub mod surface;
mod touching;
mod triangle;
mod union_find;
mod weld;

pub use accuracy::RelativeError;
pub use crowd::{Crowd, Walker};
pub use dijkstra::{edge_path, edge_polyline};
pub use drawing::{DrawMesh, draw_mesh};
pub use error::{Error, Result};
pub use halfedge::{Face, FaceData, Halfedge, HalfedgeMesh, Vertex, VertexData};
pub use heat::{
    Boundary, Distance, HeatSolver, LinearSolver, MemoryLimit, MultiSource, NearField, Parameters, Progress,
    Refinement, Stage, TimeStep,
};
pub use operator::Operator;
pub use path::{Path, PathPoint, Straightest, descend, straighten, straightest};
pub use soup::Soup;
pub use sources::{Source, SurfacePoint};
pub use surface::{BuildReport, Surface};
