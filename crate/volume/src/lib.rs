//! Distance and paths inside of tetrahedral meshes.
//!
//! The way of the data: a [`TetSoup`], which is what a file holds or what fills a closed surface → [`TetMesh`] (checked, oriented,
//! with neighbors) → [`VolumeSolver`] → [`VolumeDistance`] → [`VolumePath`]s down it:
//!
//! ```
//! use heatwalk::VertexId;
//! use heatwalk_volume::{TetMesh, TetPoint, VolumeOptions, VolumeSolver, shapes};
//!
//! # fn main() -> heatwalk_volume::Result<()> {
//! let mesh = TetMesh::build(&shapes::bent_tube(0.35, 4.5, 4, 0.0))?;
//! let mut solver = VolumeSolver::new(mesh);
//! let distance = solver.distance(&[VertexId(0)], &VolumeOptions::default())?;
//! let far = VertexId(solver.mesh().vertex_count() as u32 - 1);
//! let path = solver.path(&distance, TetPoint::Vertex(far))?;
//! assert!((path.length - distance.values[far.0 as usize]).abs() < 0.01 * path.length);
//! # Ok(())
//! # }
//! ```
//!
//! Positions inside are those of flat space, so that shortest paths are straight but where they bend around the boundary. The
//! [march](VolumeMethod::March) makes use of that: nothing is factored, and where straight lines lead to the source its distances are
//! exact. The [heat method](VolumeMethod::Heat) is there for smooth distances, for boundary conditions, and for many sources on one
//! mesh.

mod boxes;
mod corner;
pub mod crowd;
mod depth;
mod dijkstra;
mod distance;
mod error;
pub mod fill;
mod heat;
pub mod io;
mod lists;
pub mod march;
mod measured;
pub mod mesh;
pub mod path;
mod point;
pub mod section;
pub mod shapes;
mod solver;
mod soup;

pub use crowd::VolumeCrowd;
pub use depth::boundary_distance;
pub use dijkstra::edge_polyline;
pub use distance::{VolumeDistance, VolumeMethod};
pub use error::{Error, Result};
pub use mesh::{MeshReport, TetId, TetMesh};
pub use path::VolumePath;
pub use point::{TetPoint, TetSource};
pub use solver::{VolumeOptions, VolumeSolver};
pub use soup::TetSoup;
