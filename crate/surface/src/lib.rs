//! Triangle surfaces: readers, welding, half-edges, points and paths.
//!
//! The way of the data: file bytes → [`Soup`] → [`Surface`] (welded, clean, oriented, with half-edges).

pub mod appearance;
pub mod bridges;
mod cracks;
pub mod csr;
pub mod edges;
pub mod element;
mod error;
pub mod halfedge;
pub mod index;
pub mod io;
pub mod lanes;
mod length_rule;
pub mod memory;
mod merge;
pub mod motion;
mod order;
#[cfg(feature = "packed")]
mod packed;
pub mod parallel;
pub mod path;
pub mod point;
pub mod scale;
mod sort;
pub mod soup;
pub mod surface;
mod touching;
pub mod triangle;
pub mod union_find;
pub mod unit;
mod warning;
mod weld;

pub use appearance::Appearance;
pub use bridges::{BridgeRule, Bridges, Contact, Link, Portal};
pub use cracks::WeldRule;
pub use element::{
    CutVertex, CutVertexData, Element, ElementData, FaceData, FaceId, HalfedgeId, InputTriangle, InputTriangleData,
    InputVertex, InputVertexData, VertexData, VertexId,
};
pub use error::{Error, Result};
pub use halfedge::HalfedgeMesh;
pub use motion::Motion;
pub use path::{Path, PathPoint};
pub use point::{Place, SNAP, Source, SurfacePoint, ToPoint, ToSource};
pub use soup::{Attribute, Camera, Light, LightKind, Projection, Soup};
pub use surface::{BuildReport, Surface, SurfaceId, Walls};
pub use unit::{LengthUnit, Unit, UnitRule};
pub use warning::{Warning, WarningCode, Warnings};
pub use weld::MOST_COORDINATE;
