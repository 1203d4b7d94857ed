//! Distance from curves.

use std::collections::HashMap;
use std::sync::Arc;

use heatwalk_sparse::Progress;
use heatwalk_surface::{Place, Source, ToPoint, VertexData};

use super::sides::Joint;
use super::{Curve, Line};
use crate::distance::key;
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Segment, Wavefront};

/// The exact distance of each vertex (`#V`, in the file's unit) from the nearest point of any of the curves; infinite where none is reached.
///
/// # Errors
/// As [`curve_search`]; [`Error::Cancelled`].
pub fn curve_distance(
    geometry: &Arc<ExactGeometry>,
    curves: &[Curve],
    progress: Progress<'_>,
) -> Result<VertexData<f64>> {
    let mut front = curve_search(geometry, curves, &[] as &[Place])?;
    front.grow(f64::INFINITY, progress)?;
    Ok(front.into_values())
}

/// The search for distances from curves, which can be interrupted and asked for paths, with `targets` beside the vertices.
///
/// # Errors
/// [`Error::NoSource`] without a curve; [`Error::NotExact`] where faces have different costs; [`Error::Surface`] with `ForeignSurface`
/// for curves of another surface; those of [`ToPoint::to_point`]; [`Error::OutOfMemory`].
pub fn curve_search<T: ToPoint>(geometry: &Arc<ExactGeometry>, curves: &[Curve], targets: &[T]) -> Result<Wavefront> {
    let surface = geometry.surface();
    let place = |target: &T| Ok(target.to_point(surface)?.place());
    let targets = targets.iter().map(place).collect::<Result<Vec<Place>>>()?;
    let Ends { sources, segments, .. } = Ends::of(geometry, curves)?;
    Wavefront::of_segments(Arc::clone(geometry), segments, sources, &targets)
}

/// The lines of curves, and where they end.
pub(super) struct Ends {
    pub segments: Vec<Segment>,
    /// One for each place where lines begin or end.
    sources: Vec<Source>,
    /// What lines begin and end at each of these.
    pub joints: Vec<Joint>,
}

impl Ends {
    pub fn of(geometry: &ExactGeometry, curves: &[Curve]) -> Result<Self> {
        let surface = geometry.surface();
        let mut ends = Self { segments: Vec::new(), sources: Vec::new(), joints: Vec::new() };
        let mut numbers = HashMap::new();
        for curve in curves {
            surface.require_own(curve.surface, "curve")?;
            for &Line { face, ends: places } in &curve.lines {
                let places = places.map(|place| geometry.settled(place));
                ends.segments.push(Segment { face: face.0, ends: places.map(|place| place.weights_in(surface, face)) });
                for (k, place) in places.into_iter().enumerate() {
                    let number = *numbers.entry(key(place)).or_insert(ends.sources.len());
                    if number == ends.sources.len() {
                        ends.sources.push(surface.source(place, 0.0)?);
                        ends.joints.push(Joint { place, rays: Vec::new() });
                    }
                    ends.joints[number].rays.push((face.0, places[1 - k], k == 0));
                }
            }
        }
        if ends.segments.is_empty() { Err(Error::NoSource) } else { Ok(ends) }
    }
}
