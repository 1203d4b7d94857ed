//! Exact distance on the polyhedral surface, and exact shortest paths, by windows that grow outward.
//!
//! A window is the part of an edge that sees one source, or one vertex that paths bend at, along straight lines
//! through unfolded faces; windows cross faces in order of their distance (Mitchell, Mount, Papadimitriou, "The
//! discrete geodesic problem", 1987; Surazhsky et al., "Fast exact and approximate geodesics on meshes", 2005). What
//! cannot be part of a shortest path is cut: by the distances of the edge's ends (Xin & Wang, "Improving Chen and
//! Han's algorithm on the discrete geodesic problem", 2009) and by other windows of the same edge. All windows that
//! wait on one side of an edge cross its face together (after Qin et al., "Fast and exact discrete geodesic
//! computation based on triangle-oriented wavefront propagation", 2016), and are forgotten then, so that memory is
//! that of the front.
//!
//! Every value is at all times the length of a path; cutting needs a strictly shorter path. So the order of work
//! does not matter for the result, only for the time, and a queue of buckets will do.

mod bundle;
mod bundles;
mod crossing;
mod envelope;
mod fans;
mod geometry;
mod goal;
mod kept;
mod legs;
mod lines;
mod list;
mod lists;
mod merge;
mod origin;
mod overlap;
mod places;
mod points;
mod pool;
mod portals;
mod queue;
mod ray;
mod relax;
mod repeats;
mod roots;
#[cfg(test)]
mod samples;
mod segments;
mod sources;
mod strip;
mod targets;
mod trace;
mod wavefront;
mod window;

use std::sync::Arc;

pub(crate) use crossing::{Crossing, Exits};
pub use geometry::ExactGeometry;
pub(crate) use geometry::{Side, after, before};
pub(crate) use kept::{Keeping, Kept};
pub(crate) use legs::{Heading, Leg, Legs};
pub(crate) use places::End;
pub use places::PlaceDistances;
pub(crate) use portals::Portals;
pub(crate) use queue::Ring;
pub(crate) use roots::Root;
pub(crate) use segments::{SIDES, Segment};
pub use wavefront::Wavefront;
pub(crate) use wavefront::{WORK_BETWEEN_CALLS, checked_sources};
pub(crate) use window::{Beam, Window, length};

use heatwalk_sparse::{Progress, Stage, go_on, report};
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Path, ToPoint, ToSource, VertexData};

use crate::error::{Error, Result};

/// The exact distance of every vertex (`#V`, in the file's unit) to the sources: the least of initial distance plus length
/// of a path. Infinite where no source can be reached.
///
/// # Errors
/// [`Error::NoSource`]; those of [`ToSource::to_source`]; [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn exact_distance<S: ToSource>(
    surface: &Arc<Surface>,
    sources: &[S],
    progress: Progress<'_>,
) -> Result<VertexData<f64>> {
    if sources.is_empty() {
        return Err(Error::NoSource);
    }
    let sources = checked_sources(surface, sources)?;
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(surface)));
    let mut wavefront = Wavefront::of_checked(geometry, sources, &[])?;
    wavefront.grow(f64::INFINITY, progress)?;
    Ok(wavefront.into_values())
}

/// A shortest path to the source for which initial distance plus length is least.
///
/// # Errors
/// [`Error::NoSource`]; those of [`ToSource::to_source`] and [`ToPoint::to_point`];
/// [`Error::OutOfMemory`]; [`Error::Unreachable`].
pub fn shortest_path<S: ToSource>(geometry: &Arc<ExactGeometry>, from: impl ToPoint, sources: &[S]) -> Result<Path> {
    interruptible_path(geometry, from, sources, &mut go_on)
}

/// The same, whose search goes on as long as `progress` lets it.
///
/// # Errors
/// As [`shortest_path`]; [`Error::Cancelled`].
pub(crate) fn interruptible_path<S: ToSource>(
    geometry: &Arc<ExactGeometry>,
    from: impl ToPoint,
    sources: &[S],
    progress: Progress<'_>,
) -> Result<Path> {
    if sources.is_empty() {
        return Err(Error::NoSource);
    }
    search(geometry, sources, &[from], progress)?.path_from_target(0)
}

/// A wavefront that has passed all of its targets, so that no path to them can get shorter.
fn search<S: ToSource, T: ToPoint>(
    geometry: &Arc<ExactGeometry>,
    sources: &[S],
    targets: &[T],
    progress: Progress<'_>,
) -> Result<Wavefront> {
    let mut wavefront = Wavefront::with_targets(Arc::clone(geometry), sources, targets)?;
    while !wavefront.is_done() && wavefront.target_values().iter().any(|&value| wavefront.radius() <= value) {
        report(progress, Stage::Searching { radius: wavefront.radius() }, 0.0)?;
        wavefront.advance(f64::INFINITY, WORK_BETWEEN_CALLS)?;
    }
    Ok(wavefront)
}
