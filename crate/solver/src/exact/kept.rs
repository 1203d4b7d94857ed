//! Windows that are kept where they enter chosen faces: by them, the distance at any place there, and the source that it is from.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use heatwalk_surface::{FaceId, Source, VertexId};

use super::geometry::{ExactGeometry, Frame};
use super::lines::Lines;
use super::points::PointsInFaces;
use super::wavefront::Wavefront;
use super::window::{Beam, length};
use crate::error::Result;

type OfHalfedges = HashMap<u32, Vec<Beam>>;

/// Keeps what enters faces.
#[derive(Debug)]
struct Keeper {
    /// `#F`.
    is_chosen: Arc<[bool]>,
    kept: Arc<Mutex<OfHalfedges>>,
}

impl Lines<Wavefront> for Keeper {
    fn cross(&mut self, front: &mut Wavefront, _: &ExactGeometry, halfedge: u32) {
        if self.is_chosen[halfedge as usize / 3] {
            let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
            let windows = kept.entry(halfedge).or_default();
            front.waiting.for_each_at(halfedge, |window| windows.push(window));
        }
    }

    fn face(&self, _: u32) -> u32 {
        unreachable!("there are no lines, which alone have sides")
    }

    fn foot(&self, _: &Frame, _: usize, _: u32, _: [f64; 2]) -> [f64; 3] {
        unreachable!("there are no lines, which alone have sides")
    }
}

/// A search that keeps what enters chosen faces.
#[derive(Debug)]
pub(crate) struct Keeping {
    front: Wavefront,
    is_chosen: Arc<[bool]>,
    kept: Arc<Mutex<OfHalfedges>>,
}

impl Keeping {
    /// Searches anew from the sources of a search. `is_chosen`: `#F`.
    pub fn again(mut front: Wavefront, is_chosen: Vec<bool>) -> Self {
        front.restart_checked(front.sources().to_vec());
        let (is_chosen, kept) = (Arc::<[bool]>::from(is_chosen), Arc::default());
        front.lines = Some(Box::new(Keeper { is_chosen: Arc::clone(&is_chosen), kept: Arc::clone(&kept) }));
        Self { front, is_chosen, kept }
    }

    /// As [`Wavefront::advance`].
    pub fn advance(&mut self, work: usize) -> Result<bool> {
        self.front.advance(f64::INFINITY, work)
    }

    /// As [`Wavefront::radius`].
    pub fn radius(&self) -> f64 {
        self.front.radius()
    }

    /// What was kept by the end.
    pub fn finished(self) -> Kept {
        let Self { front, is_chosen, kept } = self;
        let mut windows = std::mem::take(&mut *kept.lock().unwrap_or_else(PoisonError::into_inner));
        for list in windows.values_mut() {
            list.retain(|window| front.is_current(window));
            list.iter_mut().for_each(|window| window.root = front.source_of(window.root));
        }
        let portals = front.geometry.portals();
        let places: Vec<_> =
            front.sources().iter().map(Source::place).chain(portals.places().iter().copied()).collect();
        let points = PointsInFaces::new(&places, |place| front.geometry.faces_at(&front.surface, place));
        let of_sources = (0..).zip(front.sources()).map(|(number, source)| (source.initial_distance(), number));
        let of_ends = (0..).zip(front.end_values()).map(|(end, &value)| (value, front.source_of_end(end)));
        let starts = of_sources.chain(of_ends).collect();
        Kept { geometry: front.geometry, sources: front.sources, is_chosen, windows, points, starts }
    }
}

/// Windows in chosen faces, whose roots are the numbers of the sources that they come from.
#[derive(Debug)]
pub(crate) struct Kept {
    geometry: Arc<ExactGeometry>,
    sources: Vec<Source>,
    is_chosen: Arc<[bool]>,
    windows: OfHalfedges,
    /// Sources and ends of portals, and the distance and the source of each.
    points: PointsInFaces,
    starts: Vec<(f64, u32)>,
}

impl Kept {
    pub fn geometry(&self) -> &Arc<ExactGeometry> {
        &self.geometry
    }

    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// Whether a face was chosen.
    pub fn has(&self, face: FaceId) -> bool {
        self.is_chosen[face.0 as usize]
    }

    /// The source nearest to a place in a chosen face, where any reaches it. `of_vertex`: the distance of a vertex, and its source.
    pub fn nearest(
        &self,
        face: FaceId,
        weights: [f64; 3],
        of_vertex: impl Fn(VertexId) -> (f64, Option<u32>),
    ) -> Option<u32> {
        let frame = self.geometry.frame(face.0);
        let (mut least, mut nearest) = (f64::INFINITY, None);
        let mut offer = |value: f64, source: Option<u32>| {
            if value < least {
                (least, nearest) = (value, source);
            }
        };
        for k in 0..3 {
            // The corner is at the origin.
            let place = frame.place(k, weights);
            let (value, source) = of_vertex(VertexId(frame[k].vertex));
            offer(value + length(place[0], place[1]), source);
            for window in self.windows.get(&(3 * face.0 + k as u32)).into_iter().flatten() {
                if let Some((_, value)) = window.sees(place, self.geometry.grain) {
                    offer(value, Some(window.root));
                }
            }
        }
        let place = frame.place(0, weights);
        for point in self.points.in_face(face.0) {
            let (value, source) = self.starts[point.point];
            let [x, y] = frame.place(0, point.weights);
            offer(value + length(place[0] - x, place[1] - y), Some(source));
        }
        nearest
    }
}
