//! Cells: to each source belongs what is nearer to it than to any other, by exact distances (geodesic Voronoi cells; Mount,
//! "Voronoi diagrams on the surface of a polyhedron", 1985). Every window has a root, and with it a source.

use std::sync::Arc;

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::{ToPoint, ToSource, VertexData};

use crate::error::{Error, Result};
use crate::exact::{End, ExactGeometry, PlaceDistances, WORK_BETWEEN_CALLS, Wavefront};

/// Which source is nearest to each vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// `#V`, the exact distance of each vertex from the sources, in the file's unit; infinite where none is reached.
    pub distances: VertexData<f64>,
    /// `#V`, the number of the source that this is the distance from, in the order given; of several, one of them. `None` where none
    /// is reached.
    pub nearest: VertexData<Option<u32>>,
}

/// Finds the nearest source of each vertex, in the time of one exact field.
///
/// # Errors
/// [`Error::NoSource`]; [`Error::NotExact`] where faces have different costs; those of [`ToSource::to_source`];
/// [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn cells<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S], progress: Progress<'_>) -> Result<Cells> {
    if sources.is_empty() {
        return Err(Error::NoSource);
    }
    let mut front = Wavefront::new(Arc::clone(geometry), sources)?;
    while !front.advance(f64::INFINITY, WORK_BETWEEN_CALLS)? {
        report(progress, Stage::Searching { radius: front.radius() }, 0.0)?;
    }
    let nearest = front.surface().vertices().map(|vertex| front.source_of_vertex(vertex)).collect();
    Ok(Cells { distances: front.into_values(), nearest })
}

impl Cells {
    /// The number of the source that is nearest to a place; `None` where none is reached. `distances`: of [these](Self::distances),
    /// from the sources that the cells are of.
    ///
    /// # Errors
    /// Those of [`ToPoint::to_point`]; [`Error::OutOfMemory`].
    pub fn at(&self, distances: &PlaceDistances<'_>, place: impl ToPoint) -> Result<Option<u32>> {
        Ok(distances.end(place)?.and_then(|end| match end {
            End::Vertex(vertex) => self.nearest[vertex],
            End::Source(source) => Some(source),
        }))
    }
}
