//! Exact distance at places in faces, and exact paths from them, from exact distances of all vertices.
//!
//! Straight lines go out from the place through unfolded faces until they meet a vertex, a source or an end of a portal, whose
//! distance is known: the shortest path goes straight to the first that it meets. No distance changes faster than place does, so
//! that the ends of each edge tell how near it can be to a source: what cannot be on a shortest path is not followed, and few faces
//! around that path are crossed.

mod lines;

use std::sync::Arc;

use heatwalk_sparse::go_on;
use heatwalk_surface::{PathPoint, Place, Source, ToPoint, ToSource, VertexData};

pub(crate) use lines::End;

use super::geometry::ExactGeometry;
use super::points::PointsInFaces;
use super::{Wavefront, checked_sources, search};
use crate::error::{Error, Result};
use lines::{Known, Lines};

/// A place may take as many windows as the surface has faces, or so many: usual ones take some hundreds to some ten thousand. Where
/// many faces of an edge lie on each other there is no end of lines of one length, which a search from the sources tells apart.
const MOST_WINDOWS: usize = 1 << 16;

/// Places that are asked for together may take so many times as many windows as one: what is left then takes one search from the
/// sources for all of it, which takes about as long.
const TOGETHER: usize = 64;

/// A straight line on a path is longer than the distances of its ends say by no more than this share: their rounding.
const STRAIGHT: f64 = 1e-9;

/// Exact distances from sources, of places.
#[derive(Debug)]
pub struct PlaceDistances<'a> {
    known: Known<'a>,
}

impl<'a> PlaceDistances<'a> {
    /// `values`: the exact distance of each vertex from the sources, `#V`, as a [`Wavefront`](super::Wavefront) on this geometry
    /// gives it.
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::NotExact`] where faces have different costs; those of [`ToSource::to_source`].
    ///
    /// # Panics
    /// Where there is not one value a vertex.
    pub fn new<S: ToSource>(
        geometry: &'a Arc<ExactGeometry>,
        values: &'a VertexData<f64>,
        sources: &[S],
    ) -> Result<Self> {
        assert_eq!(values.len(), geometry.surface.vertex_count(), "one value a vertex");
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        if geometry.costs().is_some() {
            return Err(Error::NotExact);
        }
        let sources = checked_sources(&geometry.surface, sources)?;
        let places: Vec<Place> = sources.iter().map(Source::place).collect();
        let in_faces = PointsInFaces::new(&places, |place| geometry.faces_at(&geometry.surface, place));
        Ok(Self { known: Known { geometry, values, sources, sources_in_faces: in_faces } })
    }

    /// The distance at a place, in the file's unit, times the cost where all faces have one; infinite where no source reaches it.
    ///
    /// # Errors
    /// Those of [`ToPoint::to_point`]; [`Error::OutOfMemory`].
    pub fn at(&self, place: impl ToPoint) -> Result<f64> {
        let place = place.to_point(&self.known.geometry.surface)?.place();
        if let Place::Vertex(vertex) = place {
            return Ok(self.known.values[vertex]);
        }
        match self.lines(place) {
            Some(lines) => Ok(lines.least),
            None => Ok(self.search(&[place])?.target_values()[0]),
        }
    }

    /// The distances at places, `#P`, each as by [`Self::at`] but for rounding. However many there are, it takes no longer than some
    /// searches from the sources.
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn at_all(&self, places: &[impl ToPoint]) -> Result<Vec<f64>> {
        let of_surface = places.iter().map(|place| Ok(place.to_point(&self.known.geometry.surface)?.place()));
        self.within(&of_surface.collect::<Result<Vec<Place>>>()?, TOGETHER * self.most_windows())
    }

    /// The same where lines take no more windows than `most`.
    fn within(&self, places: &[Place], most: usize) -> Result<Vec<f64>> {
        let (mut values, _) = self.by_lines(places, most);
        let left: Vec<usize> = (0..places.len()).filter(|&number| values[number].is_none()).collect();
        if !left.is_empty() {
            let targets: Vec<Place> = left.iter().map(|&number| places[number]).collect();
            for (&number, &value) in left.iter().zip(self.search(&targets)?.target_values()) {
                values[number] = Some(value);
            }
        }
        Ok(values.into_iter().flatten().collect())
    }

    /// The distances at places whose lines take no more windows than one place may, and all together no more than `most`; and how many
    /// these were.
    fn by_lines(&self, places: &[Place], most: usize) -> (Vec<Option<f64>>, usize) {
        let mut taken = 0;
        let values = places.iter().map(|&place| {
            if let Place::Vertex(vertex) = place {
                return Some(self.known.values[vertex]);
            }
            let (lines, windows) = Lines::followed(&self.known, place, self.most_windows().min(most - taken));
            taken += windows;
            lines.map(|lines| lines.least)
        });
        (values.collect(), taken)
    }

    /// Straight lines from a place, unless they are too many.
    fn lines(&self, place: Place) -> Option<Lines<'_>> {
        Lines::followed(&self.known, place, self.most_windows()).0
    }

    /// A search from the sources that has passed these places.
    fn search(&self, places: &[Place]) -> Result<Wavefront> {
        search(self.known.geometry, &self.known.sources, places, &mut go_on)
    }

    /// Windows that the lines from one place may take.
    fn most_windows(&self) -> usize {
        MOST_WINDOWS.max(self.known.geometry.frames.len())
    }

    /// What a straight line from a place leads to on its shortest path; none where no source reaches it.
    pub(crate) fn end(&self, place: impl ToPoint) -> Result<Option<End>> {
        let place = place.to_point(&self.known.geometry.surface)?.place();
        if let Place::Vertex(vertex) = place {
            return Ok(Some(End::Vertex(vertex)));
        }
        match self.lines(place) {
            Some(lines) => Ok(lines.found.map(|found| found.end)),
            None => Ok(self.search(&[place])?.source_of_target(0).map(End::Source)),
        }
    }

    /// The surface in the faces of which distances are known, and the sources.
    pub(crate) fn asked(&self) -> (&'a Arc<ExactGeometry>, &[Source]) {
        (self.known.geometry, &self.known.sources)
    }

    /// Points on the edges that the shortest path crosses, wherever it crosses them, and at the vertices that it turns at, and how long
    /// it may be up to rounding; none where there is no path, and where rounding hides which way it goes.
    pub(crate) fn crossed(&self, from: Place) -> Option<(Vec<PathPoint>, f64)> {
        let mut points = Vec::new();
        let (mut place, mut value, mut whole) = (from, f64::INFINITY, f64::INFINITY);
        let source = loop {
            if let Place::Vertex(vertex) = place {
                // Values fall strictly, so that each vertex is passed once.
                if self.known.values[vertex] >= value {
                    return None;
                }
                value = self.known.values[vertex];
                let is_here = |source: &&Source| source.place() == place && source.initial_distance() <= value;
                if let Some(source) = self.known.sources.iter().find(is_here) {
                    if points.is_empty() {
                        let face = self.known.geometry.faces_at(&self.known.geometry.surface, place).first()?.0;
                        points.push(self.known.point(place, face));
                    }
                    break source;
                }
            }
            let lines = self.lines(place)?;
            let found = lines.found.as_ref()?;
            if points.is_empty() {
                whole = lines.least;
            }
            if lines.least > value * (1.0 + STRAIGHT) + self.known.geometry.grain {
                return None;
            }
            lines.trace(found, &mut points);
            match found.end {
                End::Source(source) => break &self.known.sources[source as usize],
                End::Vertex(vertex) => place = Place::Vertex(vertex),
            }
        };
        // From the source itself.
        points.dedup_by(|next, last| next.location == last.location);
        let face = points.first()?.face;
        let [a, b, _] = self.known.geometry.surface.corners(face);
        let cost = self.known.geometry.frame(face.0)[0].length / a.distance(b);
        let length = whole * (1.0 + STRAIGHT) + self.known.geometry.grain - source.initial_distance();
        Some((points, length / cost))
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use glam::DVec3;
    use heatwalk_surface::{Element as _, FaceId, Soup, Surface, VertexId};

    use super::*;

    /// Faces around a vertex, whose rim goes up and down so that paths bend at some of its corners.
    fn wavy(count: u32) -> Arc<ExactGeometry> {
        let on_rim = |corner: u32| {
            let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(count);
            DVec3::new(angle.cos(), 0.4 * (5.0 * angle).sin(), angle.sin())
        };
        let positions = std::iter::once(DVec3::ZERO).chain((0..count).map(on_rim)).collect();
        let corners = (0..count).map(|corner| [0, 1 + (corner + 1) % count, 1 + corner]).collect();
        let surface = Surface::build(&Soup::single("wavy", positions, corners)).expect("a surface");
        Arc::new(ExactGeometry::new(surface))
    }

    /// Calls with the distances from a vertex, and places in all faces.
    fn with_places(count: u32, check: impl Fn(&PlaceDistances<'_>, &[Place])) {
        let geometry = wavy(count);
        let source = VertexId(1);
        let mut front = Wavefront::new(Arc::clone(&geometry), &[source]).expect("a front");
        front.grow(f64::INFINITY, &mut go_on).expect("distances");
        let distances = PlaceDistances::new(&geometry, front.values(), &[source]).expect("distances");
        let in_face = |index: usize| [[0.2, 0.3, 0.5], [0.9, 0.05, 0.05]].map(|weights| (index, weights));
        let place = |(index, weights)| Place::Face { face: FaceId::from_index(index), weights };
        let places: Vec<Place> = (0..count as usize).flat_map(in_face).map(place).collect();
        check(&distances, &places);
    }

    #[test]
    fn lines_from_many_places_take_no_more_windows_than_they_may() {
        with_places(60, |distances, places| {
            let (all, enough) = distances.by_lines(places, usize::MAX);
            assert!(all.iter().all(Option::is_some));
            for most in [0, 1, enough / 3, enough, 2 * enough] {
                let (values, taken) = distances.by_lines(places, most);
                assert!(taken <= most, "{taken} of {most}");
                assert!((0..places.len()).all(|number| values[number].is_none_or(|value| Some(value) == all[number])));
                assert_eq!(values.contains(&None), most < enough, "{most} of {enough}");
            }
        });
    }

    #[test]
    fn one_search_finds_what_lines_from_each_place_do() {
        with_places(60, |distances, places| {
            let alone: Vec<f64> = places.iter().map(|&place| distances.at(place).expect("a distance")).collect();
            for most in [0, 500, usize::MAX] {
                let together = distances.within(places, most).expect("distances");
                for (alone, together) in alone.iter().zip(together) {
                    assert!((alone - together).abs() <= 1e-12 * alone, "{alone} alone, {together} of at most {most}");
                }
            }
        });
    }
}
