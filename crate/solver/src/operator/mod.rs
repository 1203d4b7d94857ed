//! The discrete operators of a surface and the triangles that they are built on.

pub(crate) mod elements;
pub mod intrinsic;
pub mod laplacian;
mod relocate;

use crate::options::Operator;
use elements::Elements;
use heatwalk_surface::surface::Surface;
use intrinsic::IntrinsicTriangulation;

impl Operator {
    /// The triangles, over the surface's points.
    pub(crate) fn elements(self, surface: &Surface) -> Elements {
        match self {
            Self::Delaunay => IntrinsicTriangulation::delaunay(surface).elements(),
            Self::Plain => Elements::of_surface(surface),
            Self::Relocate => Elements::of_surface(&surface.with_positions(relocate::relocated(surface).0)),
        }
    }
}
