//! What goes on from an exact search.

use std::fmt;
use std::sync::Arc;

use heatwalk_surface::{FaceId, Source, Surface, VertexData, VertexId};

use super::ends::{Ends, NOWHERE};
use super::queue::Queue;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::extremum::smaller;
use crate::room::{REFUSED, refilled};

/// Items of a queue that are processed together.
pub(super) const BATCH: usize = 32;

/// What is known of vertices and of the ends of portals, and which of them have still to be gone on from.
pub(super) struct Reached {
    surface: Arc<Surface>,
    geometry: Arc<ExactGeometry>,
    /// `#V`, as its other lists empty before the first start.
    pub values: VertexData<f64>,
    /// `#V`, number of the source that each value comes from.
    pub nearest: VertexData<u32>,
    /// Vertices that wait, and after them ends of portals. What is pushed twice waits twice, and the second time finds nothing
    /// to do.
    pub sending: Queue,
    ends: Ends,
    /// `#V`, whether a vertex has still to be gone on from.
    waits: Vec<bool>,
    /// How often faces were crossed.
    pub crossed: usize,
    /// Items that are processed now; kept for its memory.
    pub batch: Vec<u32>,
}

impl Reached {
    /// Nothing yet. The queue's buckets have a width in mean edges.
    pub fn new(geometry: Arc<ExactGeometry>, bucket: f64) -> Self {
        Self {
            surface: Arc::clone(geometry.surface()),
            values: VertexData::default(),
            nearest: VertexData::default(),
            sending: Queue::new(&geometry, bucket),
            ends: Ends::default(),
            waits: Vec::new(),
            crossed: 0,
            batch: Vec::new(),
            geometry,
        }
    }

    /// Forgets all that was found from earlier sources, to begin from so many at the least distance.
    fn clear(&mut self, least: f64) -> Result<()> {
        let vertices = self.surface.vertex_count();
        self.values = refilled(std::mem::take(&mut self.values).into_vec(), vertices, f64::INFINITY)?.into();
        self.nearest = refilled(std::mem::take(&mut self.nearest).into_vec(), vertices, NOWHERE)?.into();
        self.waits = refilled(std::mem::take(&mut self.waits), vertices, false)?;
        self.sending.clear(least, vertices);
        self.crossed = 0;
        Ok(())
    }

    pub fn send_from(&mut self, vertex: u32) {
        self.waits[vertex as usize] = true;
        self.sending.push(vertex, self.values[VertexId(vertex)]);
    }

    /// Offers a vertex a shorter path.
    #[inline]
    pub fn offer(&mut self, vertex: u32, value: f64, source: u32) {
        if value < self.values[VertexId(vertex)] {
            self.values[VertexId(vertex)] = value;
            self.nearest[VertexId(vertex)] = source;
            self.send_from(vertex);
        }
    }

    /// Offers an end of a portal a shorter path.
    pub fn offer_end(&mut self, end: u32, value: f64, source: u32) {
        if self.ends.offer(end, value, source) {
            self.sending.push(self.waits.len() as u32 + end, value);
        }
    }
}

/// A place in a face, by barycentric weights.
pub(super) type PlaceInFace = (u32, [f64; 3]);

/// What grows outward from sources, however that is carried.
pub(super) trait Grow: Send + Sync {
    /// What it has reached.
    fn reached(&self) -> &Reached;

    /// The same.
    fn reached_mut(&mut self) -> &mut Reached;

    /// Forgets what carried it from earlier sources, to begin at the least distance.
    fn clear(&mut self, surface: &Surface, least: f64);

    /// Goes on from where an exact search has come to, whose values are reached.
    fn go_on(&mut self, geometry: &ExactGeometry, surface: &Surface, exact: &Wavefront);

    /// Goes on from a place in a face.
    fn light(&mut self, geometry: &ExactGeometry, at: PlaceInFace, value: f64, source: u32);

    /// Goes on from a vertex. Distances below `settled` seldom fall any more.
    fn send(&mut self, geometry: &ExactGeometry, surface: &Surface, vertex: u32, settled: f64);

    /// Goes on from some of what waits below `radius`.
    fn grow(&mut self, geometry: &ExactGeometry, surface: &Surface, radius: f64);

    /// All that waits is at least this far.
    fn floor(&self) -> f64;

    /// Whether there was no memory for something, which is lost.
    fn is_refused(&self) -> bool;

    /// Forgets all that was found from earlier sources, to begin at the least distance.
    fn begin(&mut self, least: f64) -> Result<(Arc<ExactGeometry>, Arc<Surface>)> {
        let reached = self.reached_mut();
        reached.clear(least)?;
        let (geometry, surface) = (Arc::clone(&reached.geometry), Arc::clone(&reached.surface));
        self.clear(&surface, least);
        Ok((geometry, surface))
    }

    /// Starts, alone, from where an exact search has come to.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    fn start(&mut self, exact: &Wavefront) -> Result<()> {
        let (geometry, surface) = self.begin(exact.base())?;
        let reached = self.reached_mut();
        for (end, value) in reached.ends.start(exact) {
            reached.sending.push(reached.waits.len() as u32 + end, value);
        }
        for &vertex in exact.reached() {
            reached.values[vertex] = exact.values()[vertex];
            reached.nearest[vertex] = exact.source_of(vertex.0);
        }
        self.go_on(&geometry, &surface, exact);
        Ok(())
    }

    /// Starts, alone, from sources.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    fn start_at(&mut self, sources: &[Source]) -> Result<()> {
        let least = sources.iter().map(|source| source.initial_distance()).fold(f64::INFINITY, smaller);
        let (geometry, surface) = self.begin(least)?;
        self.reached_mut().ends.clear(geometry.portals().places().len());
        for (number, source) in (0..).zip(sources) {
            for at in geometry.faces_at(&surface, source.place()) {
                self.light(&geometry, at, source.initial_distance(), number);
            }
        }
        Ok(())
    }

    /// Grows until every value below `radius` is final (by vertices alone, or seldom falls), or faces were crossed about `work` times.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory); then it does not grow until it starts anew.
    fn advance(&mut self, radius: f64, work: usize) -> Result<()> {
        let reached = self.reached();
        let enough = reached.crossed.saturating_add(work);
        let (geometry, surface) = (Arc::clone(&reached.geometry), Arc::clone(&reached.surface));
        while self.reached().crossed < enough && self.radius() < radius && !self.is_refused() {
            self.grow(&geometry, &surface, radius);
        }
        if self.is_refused() { Err(REFUSED) } else { Ok(()) }
    }

    /// Goes on from some of the vertices and ends of portals that wait below `limit`: at the other ends of these.
    #[inline]
    fn send_some(&mut self, geometry: &ExactGeometry, surface: &Surface, limit: f64) {
        let reached = self.reached_mut();
        let mut batch = std::mem::take(&mut reached.batch);
        reached.sending.pop_some(limit, BATCH, &mut batch);
        let settled = reached.sending.ceiling();
        let sends = |item: &u32| reached.waits.get(*item as usize).is_some_and(|&waits| waits);
        fetch_around(geometry, surface, batch.iter().copied().filter(sends));
        let vertices = reached.waits.len() as u32;
        for &item in &batch {
            let reached = self.reached_mut();
            if item < vertices {
                if std::mem::take(&mut reached.waits[item as usize]) {
                    self.send(geometry, surface, item, settled);
                }
            } else if let Some((other, value, source)) = reached.ends.pass(geometry.portals(), item - vertices) {
                for at in geometry.faces_at(surface, geometry.portals().places()[other as usize]) {
                    self.light(geometry, at, value, source);
                }
            }
        }
        self.reached_mut().batch = batch;
    }

    /// Every value below this is final, as in [`advance`](Self::advance); infinity when all is done.
    fn radius(&self) -> f64 {
        if self.is_refused() { f64::NEG_INFINITY } else { self.floor() }
    }

    /// The distance at an end of a portal that paths reach through it.
    fn entered(&self, end: u32) -> Option<f64> {
        self.reached().ends.entered(end)
    }
}

/// Not its windows, which are millions, and whose formatting would be part of every program that links a front.
impl fmt::Debug for dyn Grow {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let mut front = formatter.debug_struct("Front");
        front.field("radius", &self.radius()).field("crossed", &self.reached().crossed).finish_non_exhaustive()
    }
}

/// Reads what the faces around some vertices have, so that the processor waits for all of it at once instead of for one
/// after another.
pub(super) fn fetch_around(geometry: &ExactGeometry, surface: &Surface, vertices: impl Iterator<Item = u32> + Clone) {
    let first_faces = vertices.clone().filter_map(|vertex| surface.corners_of_vertex(VertexId(vertex)).next());
    std::hint::black_box(first_faces.fold(0, |sum, (face, _)| sum ^ face.0));
    let faces = vertices.flat_map(|vertex| surface.corners_of_vertex(VertexId(vertex)));
    let lengths = |face: FaceId| [0, 2].map(|k| geometry.frame(face.0)[k].length).iter().sum::<f64>();
    std::hint::black_box(faces.map(|(face, _)| lengths(face)).sum::<f64>());
}
