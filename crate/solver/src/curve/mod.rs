//! Curves on a surface, and distance from them: exact distance from all of their points, not from their vertices alone (Bommes & Kobbelt,
//! "Accurate computation of geodesic distance fields for polygonal curves on triangle meshes", 2007), with the side that they are seen
//! from as its sign.

mod distance;
mod sides;
mod signed;

use std::sync::Arc;

pub use distance::{curve_distance, curve_search};
pub use signed::{SignedDistance, signed_curve_distance};

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::{FaceId, Place, Surface, SurfaceId, SurfacePoint, ToPoint};

use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, interruptible_path};

/// A straight line in a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The triangle.
    pub face: FaceId,
    /// Where it begins and ends, on the face: two places.
    pub ends: [Place; 2],
}

/// A polyline on a surface, open or closed, which has a left and a right side in its direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    surface: SurfaceId,
    lines: Vec<Line>,
}

impl Curve {
    /// Straight from each place to the next in a triangle that both are on; where it `is_closed`, from the last to the first too.
    ///
    /// # Errors
    /// [`Error::BadParameter`] where a place is in no triangle with the one before, which [`Self::through`] would join, and for
    /// less than two different places; those of [`ToPoint::to_point`].
    pub fn new<P: ToPoint>(surface: &Surface, places: &[P], is_closed: bool) -> Result<Self> {
        Self::joined(surface, places, is_closed, |[from, to], place| {
            let bad = |value| Error::BadParameter {
                name: "the curve",
                value,
                range: "through places each of which is in one triangle with the one before",
            };
            Err(bad(format!("at {:?}, then at {:?}, place {place} of it", from.place(), to.place())))
        })
    }

    /// Along a shortest path from each place to the next; where it `is_closed`, from the last to the first too. Where paths cross bridges it
    /// has gaps there.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for less than two different places; [`Error::Unreachable`] for places that no path joins; those of
    /// [`ToPoint::to_point`]; [`Error::NotExact`] where faces have different costs; [`Error::OutOfMemory`]; [`Error::Cancelled`].
    pub fn through<P: ToPoint>(
        geometry: &Arc<ExactGeometry>,
        places: &[P],
        is_closed: bool,
        progress: Progress<'_>,
    ) -> Result<Self> {
        Self::joined(geometry.surface(), places, is_closed, |[from, to], place| {
            report(progress, Stage::Searching { radius: 0.0 }, place as f64 / places.len() as f64)?;
            let path = interruptible_path(geometry, from, &[to], progress)?;
            Ok(path.points.iter().map(|point| point.location).collect())
        })
    }

    /// All boundaries, with the surface on the right; none where there is no boundary.
    pub fn boundary(surface: &Surface) -> Option<Self> {
        let is_boundary =
            |&(face, k): &(FaceId, usize)| surface.edges().next_on_edge(face.halfedge(k)) == face.halfedge(k);
        let sides = surface.faces().ids().flat_map(|face| [0, 1, 2].map(|k| (face, k)));
        let line = |(face, k): (FaceId, usize)| {
            let [start, end] = surface.ends(face.halfedge(k)).map(Place::Vertex);
            Line { face, ends: [end, start] }
        };
        let lines: Vec<Line> = sides.filter(is_boundary).map(line).collect();
        (!lines.is_empty()).then(|| Self { surface: surface.id(), lines })
    }

    /// Where two places are in no triangle, `between` tells places from the one to the other; it is told the number of the latter.
    fn joined<P: ToPoint>(
        surface: &Surface,
        places: &[P],
        is_closed: bool,
        mut between: impl FnMut([SurfacePoint; 2], usize) -> Result<Vec<Place>>,
    ) -> Result<Self> {
        let points = places.iter().map(|place| Ok(place.to_point(surface)?)).collect::<Result<Vec<SurfacePoint>>>()?;
        let back = points.first().filter(|_| is_closed);
        let mut lines = Vec::new();
        for (place, (from, to)) in points.iter().zip(points.iter().skip(1).chain(back)).enumerate() {
            let ends = [from.place(), to.place()];
            match Line::within(surface, ends) {
                Some(line) => lines.push(line),
                None => {
                    let path = between([*from, *to], (place + 1) % points.len())?;
                    lines.extend(path.windows(2).filter_map(|ends| Line::within(surface, [ends[0], ends[1]])));
                }
            }
        }
        lines.retain(|line| line.length(surface) > 0.0);
        if lines.is_empty() {
            let value = format!("given by {} place{}", places.len(), if places.len() == 1 { "" } else { "s" });
            return Err(Error::BadParameter {
                name: "the curve",
                value,
                range: "given by two different places or more",
            });
        }
        Ok(Self { surface: surface.id(), lines })
    }

    /// What it is made of, in its direction.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// In the file's unit.
    ///
    /// # Errors
    /// [`Error::Surface`] with `ForeignSurface` for another surface than its own.
    pub fn length(&self, surface: &Surface) -> Result<f64> {
        surface.require_own(self.surface, "curve")?;
        Ok(self.lines.iter().map(|line| line.length(surface)).sum())
    }
}

impl Line {
    /// Between places on one face; none where there is none.
    fn within(surface: &Surface, ends: [Place; 2]) -> Option<Self> {
        let reduced = ends.map(|place| place.reduced(surface));
        let face = reduced[0].faces(surface).into_iter().find(|&face| reduced[1].lies_on(surface, face))?;
        Some(Self { face, ends })
    }

    /// The place at this share, 0 to 1, of the way from its begin to its end.
    pub fn at(&self, surface: &Surface, share: f64) -> Place {
        let [start, end] = self.ends.map(|place| place.weights_in(surface, self.face));
        let weights = std::array::from_fn(|k| start[k] + share * (end[k] - start[k]));
        Place::Face { face: self.face, weights }
    }

    /// In the file's unit.
    pub fn length(&self, surface: &Surface) -> f64 {
        let [start, end] = self.ends.map(|place| place.position(surface));
        start.distance(end)
    }
}
