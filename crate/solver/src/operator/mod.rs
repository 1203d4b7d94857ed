//! The discrete operators of a surface and the triangles that they are built on.

pub(crate) mod elements;
pub mod intrinsic;
pub mod laplacian;
mod relocate;

use elements::Elements;
use heatwalk_surface::surface::Surface;
use intrinsic::IntrinsicTriangulation;

/// Which triangles carry the cotan weights.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Operator {
    /// The intrinsic Delaunay triangulation of the same points, on the tufted cover where the surface is no oriented
    /// manifold: no weight is negative, whatever the shape of the triangles.
    #[default]
    Delaunay,
    /// The triangles of the file.
    Plain,
    /// The triangles of the file after the study's repair, which moves points of bad ones.
    Relocate,
}

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
