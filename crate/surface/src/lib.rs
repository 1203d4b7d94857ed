//! Triangle surfaces: welding, half-edges, contacts, points and paths.
//!
//! The way of the data: [`Soup`] → [`Surface`] (welded, clean, oriented, with half-edges). Files of soups are read by
//! `heatwalk-model`.

pub mod bridges;
mod cracks;
pub mod edges;
pub mod element;
mod error;
pub mod halfedge;
pub mod index;
mod input;
mod length_rule;
pub mod memory;
mod merge;
mod nearest;
mod order;
pub mod path;
pub mod point;
pub mod scale;
pub mod soup;
pub mod surface;
mod terrain;
mod touching;
pub mod triangle;
pub mod unit;
mod warning;
mod weld;

pub use bridges::{BridgeRule, Bridges, Contact, Link, Portal};
pub use cracks::WeldRule;
pub use element::{
    CutVertex, CutVertexData, Element, ElementData, FaceData, FaceId, HalfedgeId, InputTriangle, InputTriangleData,
    InputVertex, InputVertexData, VertexData, VertexId,
};
pub use error::{Error, Result};
pub use halfedge::HalfedgeMesh;
pub use input::InputPlace;
pub use nearest::NearestPlaces;
pub use path::{Path, PathPoint};
pub use point::{Place, SNAP, Source, SurfacePoint, ToPoint, ToSource};
pub use soup::{Attribute, Part, Selection, Soup};
pub use surface::{BuildReport, Surface, SurfaceId, Walls};
pub use unit::{LengthUnit, Unit, UnitRule};
pub use warning::{Warning, WarningCode, Warnings};
pub use weld::MOST_COORDINATE;
