//! Geodesic distance and shortest paths on triangle meshes: by the heat method (Crane, Weischedel, Wardetzky 2013), exactly,
//! and by a few windows of each half-edge.
//!
//! The way of the data: file bytes → [`Soup`] → [`Surface`] (welded, clean, oriented, with half-edges) → [`DistanceSolver`]
//! (all that a [`Method`] needs, made when it is first asked for) → [`Distance`] → [`Path`]s down it:
//!
//! ```
//! use heatwalk::{DistanceOptions, DistanceSolver, Method, PathKind, Surface, VertexId, go_on};
//! use heatwalk_shapes::icosphere;
//!
//! # fn main() -> heatwalk::Result<()> {
//! let mut solver = DistanceSolver::new(Surface::build(&icosphere(3))?);
//! let options = DistanceOptions::default();
//! let answer = solver.distance(&[VertexId(0)], &options, &mut go_on)?;
//! assert_eq!(answer.method, Method::Exact, "on so small a mesh");
//! assert!((answer.distance.max() - std::f64::consts::PI).abs() < 0.01, "half a great circle of the unit sphere");
//!
//! let path = solver.path(&answer, VertexId(7), PathKind::Exact)?;
//! println!("{} units in {} segments", path.length(), path.points.len() - 1);
//! # Ok(())
//! # }
//! ```
//!
//! # Which method
//!
//! - [`Method::Auto`], the default: exact while that takes a second or so, beyond by a few windows of each half-edge, with
//!   errors of some hundredths of a per cent. Nothing is factored.
//! - [`Method::Heat`] for many sources on one mesh (factored once, then a solve is a fraction of a search), for smooth
//!   distances, and where a [`Boundary`] condition is wanted.
//! - [`Method::Exact`] and [`Method::Propagation`] where the one or the other is wanted whatever it takes.
//!
//! From [`Curve`]s distance is always exact: [`curve_distance`], and with a sign [`signed_curve_distance`].
//!
//! Where the ground is not the same everywhere, [`DistanceSolver::set_costs`] takes [`Costs`] of faces, and
//! [`DistanceSolver::set_walls`] puts up [`Walls`]. [`DistanceSolver::path`] and [`DistanceSolver::refine`] ask more of an [`Answer`].
//!
//! The methods by themselves are [`HeatSolver`], [`exact`] and [`propagation`]. The heat method is made of
//! [`Operators`](operator::Operators) (edge lengths only) → [`Factorization`] (what is factored, by [`FactorOptions`]) →
//! [`Query`] (what is asked); [`HeatSolver`] holds a factorization with the options of its queries.
//!
//! The oldest Rust that it compiles with is 1.95; a newer one is asked for in a new minor version only.
//!
//! # Where more would plug in
//!
//! [`HeatFlow`](heat::HeatFlow) and [`Poisson`](heat::Poisson) take any right side and any constraints, and
//! [`Operators`](operator::Operators) have gradient and divergence of any field, so that related methods are compositions;
//! `tests/composition.rs` has one of each. *Transport* of vectors by heat between the tangent planes of [`Frames`](operator::Frames) is a
//! step of diffusion by the [`ConnectionLaplacian`](operator::ConnectionLaplacian), a complex matrix of the same pattern, as
//! [`VectorHeat`](heat::VectorHeat) lets the normals of curves flow. An *anisotropic* metric is its edge lengths
//! ([`Operators::from_lengths`](operator::Operators::from_lengths)); exact distances and paths still measure positions, so
//! such a distance has no exact region. Systems, flow and Poisson see matrices only: any
//! [`Discretization`](operator::Discretization) will do. The whole method, [`HeatMethod`](heat::HeatMethod), takes any
//! [`HeatDiscretization`](heat::HeatDiscretization), as that of tetrahedra in the crate `heatwalk-volume` is.

pub mod accuracy;
mod bridged;
mod cells;
mod choice;
mod cost;
mod curve;
mod dijkstra;
mod directions;
mod distance;
mod error;
pub mod exact;
mod extremum;
mod footprint;
pub mod gradient;
pub mod heat;
mod loops;
mod mean;
pub mod operator;
mod options;
pub mod path;
pub mod propagation;
mod refinement;
mod relief;
mod room;
mod sampling;
pub mod solver;

/// What positions and directions are made of, in the version that is used here.
pub use glam;
/// Linear algebra, which knows no surface.
pub use heatwalk_sparse as sparse;
/// The surface and all that it is made of.
pub use heatwalk_surface as surface;

pub use accuracy::RelativeError;
pub use cells::{CellMap, CellSearch, Cells, cell_map, cells};
pub use choice::{Choice, UnknownChoice};
pub use cost::{Costs, tobler};
pub use curve::{Curve, Line, SignedDistance, curve_distance, curve_search, signed_curve_distance};
pub use dijkstra::{edge_path, edge_polyline};
pub use directions::{LogMap, LogMapSearch, log_map, propagated_log_map, transport};
pub use distance::{Distance, PortalCrossing};
pub use error::{Error, Result};
pub use footprint::{footprint, require_room};
pub use heat::{Factorization, HeatSolver, Query, Refinement};
pub use heatwalk_sparse::{Progress, Stage, go_on};
pub use heatwalk_surface::{
    BridgeRule, Bridges, BuildReport, CutVertex, Element, FaceData, FaceId, HalfedgeId, HalfedgeMesh, InputPlace,
    InputTriangle, InputVertex, LengthUnit, Link, NearestPlaces, Path, PathPoint, Place, Portal, SNAP, Soup, Source,
    Surface, SurfaceId, SurfacePoint, ToPoint, ToSource, Unit, UnitRule, VertexData, VertexId, Walls, Warning,
    WarningCode, WeldRule,
};
pub use loops::{geodesic_loop, handle_loops};
pub use mean::{Mean, mean, relaxed};
pub use options::{
    AUTOMATIC, Boundary, DEFAULT_WINDOWS, EdgeKind, ExactRadius, FaceField, FactorOptions, LinearSolver, MemoryLimit,
    Method, MultiSource, Operator, Parameters, PathKind, Sign, TRIANGLE_BYTES, TimeStep, Up, VertexField, WINDOWS,
};
pub use path::{
    Bezier, Enclosed, PathSearch, Straightest, bezier, closed_geodesic, descend, enclosed, refract, straighten,
    straightest,
};
pub use propagation::{Carriers, ExactSearch, Propagation, PropagationOptions, Windows};
pub use refinement::PropagationRefinement;
pub use relief::Relief;
pub use sampling::{SampleCount, Samples, farthest_samples};
pub use solver::{Answer, DistanceOptions, DistanceSolver, Joined, ParcelDistance, Solution, row_source};

#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
