//! The front beyond the exact search: windows that wait at half-edges, vertices that wait to send some, and their way
//! across faces.

use std::sync::Arc;

use super::labels::{Bar, Labels};
use crate::error::Result;
use crate::exact::{Beam, Buckets, Crossing, ExactGeometry, Wavefront, after, length};
use crate::extremum::{larger, smaller};
use heatwalk_surface::{Surface, VertexData, VertexId};

/// Width of the queue's buckets, in mean edges.
const BUCKET: f64 = 1.0;

/// How much sooner a window must come than the one that it replaces, in mean edges.
const MARGIN: f64 = 1e-6;

/// Items of the queue that are processed together.
const BATCH: usize = 16;

/// Number of the source of a vertex that has not been reached.
pub(super) const NOWHERE: u32 = u32::MAX;

/// What grows outward by a few windows of each half-edge.
#[derive(Debug)]
pub(super) struct Front {
    surface: Arc<Surface>,
    geometry: Arc<ExactGeometry>,
    /// `#V`, lengths of paths from the sources.
    pub values: VertexData<f64>,
    /// `#V`, number of the source that each value comes from.
    pub nearest: VertexData<u32>,
    labels: Labels,
    /// Half-edges, then vertices.
    queue: Buckets,
    /// Windows that have crossed a face.
    pub crossed: usize,
    /// Items that are processed now; kept for its memory.
    batch: Vec<u32>,
    /// Windows that cross now; kept for its memory.
    crossing: Vec<Crossing>,
}

impl Front {
    /// One that is nowhere yet, with so many stretches of each half-edge.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn new(geometry: Arc<ExactGeometry>, stretches: usize) -> Result<Self> {
        let surface = Arc::clone(geometry.surface());
        let (halfedges, vertices) = (3 * surface.face_count(), surface.vertex_count());
        Ok(Self {
            values: vec![f64::INFINITY; vertices].into(),
            nearest: vec![NOWHERE; vertices].into(),
            labels: Labels::new(halfedges, stretches, MARGIN * surface.mean_edge())?,
            queue: Buckets::new(halfedges + vertices, 0.0, BUCKET * surface.mean_edge()),
            crossed: 0,
            batch: Vec::new(),
            crossing: Vec::new(),
            surface,
            geometry,
        })
    }

    /// Goes on, alone, from where an exact search has come to.
    pub fn start(&mut self, exact: &Wavefront) {
        self.values.as_mut_slice().fill(f64::INFINITY);
        self.nearest.as_mut_slice().fill(NOWHERE);
        self.labels.clear();
        self.queue.clear(exact.base(), |_| ());
        self.crossed = 0;
        for &vertex in exact.reached() {
            let value = exact.values()[vertex];
            self.values[vertex] = value;
            self.nearest[vertex] = exact.source_of(vertex.0);
            if value >= exact.radius() {
                self.send_from(vertex.0);
            }
        }
        let geometry = Arc::clone(&self.geometry);
        for (halfedge, beam) in exact.waiting() {
            let (frame, k) = geometry.frame_of(halfedge);
            let corners = [k, after(k)].map(|corner| frame.vertices[corner]);
            corners.into_iter().for_each(|vertex| self.send_from(vertex));
            self.keep(halfedge, &beam, &Bar { length: frame.length[k], ends: self.distances(corners), opposite: None });
        }
    }

    /// Grows until every value below `radius` is final, or about `work` windows have crossed a face.
    pub fn advance(&mut self, radius: f64, work: usize) {
        let enough = self.crossed.saturating_add(work);
        let halfedges = self.geometry.halfedge_count();
        let (geometry, surface) = (Arc::clone(&self.geometry), Arc::clone(&self.surface));
        let mut batch = std::mem::take(&mut self.batch);
        while self.crossed < enough {
            self.queue.pop_some(radius, BATCH, &mut batch);
            if batch.is_empty() {
                break;
            }
            self.fetch(&batch);
            for &item in &batch {
                if item < halfedges {
                    self.cross(&geometry, item);
                } else {
                    self.emit(&geometry, &surface, item - halfedges);
                }
            }
        }
        self.batch = batch;
    }

    /// Reads what a batch will need, so that the processor waits for all of it at once instead of for one after another.
    fn fetch(&self, batch: &[u32]) {
        let mut sum = 0.0;
        let mut targets = [0; 2 * BATCH];
        let mut count = 0;
        for &item in batch.iter().filter(|&&item| item < self.geometry.halfedge_count()) {
            let (frame, k) = self.geometry.frame_of(item);
            sum += self.labels.value_of(item);
            for out in [after(k), after(after(k))] {
                targets[count] = frame.next_on_edge[out] >> 2;
                count += 1;
            }
        }
        for &target in &targets[..count] {
            sum += self.labels.value_of(target);
        }
        std::hint::black_box(sum);
    }

    /// Every value below this is final; infinity when all is done.
    pub fn radius(&self) -> f64 {
        self.queue.floor()
    }

    fn distances(&self, vertices: [u32; 2]) -> [f64; 2] {
        vertices.map(|vertex| self.values[VertexId(vertex)])
    }

    fn send_from(&mut self, vertex: u32) {
        self.queue.push(self.geometry.halfedge_count() + vertex, self.values[VertexId(vertex)]);
    }

    /// Offers a vertex a shorter path.
    fn offer(&mut self, vertex: u32, value: f64, source: u32) {
        if value < self.values[VertexId(vertex)] {
            self.values[VertexId(vertex)] = value;
            self.nearest[VertexId(vertex)] = source;
            self.send_from(vertex);
        }
    }

    /// Lets the windows that wait at a half-edge enter its face: values for the opposite corner, windows for the half-edges
    /// across its two other edges.
    fn cross(&mut self, geometry: &ExactGeometry, halfedge: u32) {
        let (frame, k) = geometry.frame_of(halfedge);
        let [l, r] = [after(after(k)), after(k)];
        let [a, b, c] = [k, r, l].map(|corner| frame.vertices[corner]);
        let opposite = frame.opposite(k);
        let bar = Bar { length: frame.length[k], ends: self.distances([a, b]), opposite: None };
        let mut crossing = std::mem::take(&mut self.crossing);
        crossing.clear();
        self.labels.take(halfedge, &bar, |beam| crossing.push(Crossing::new(beam, opposite)));
        self.crossed += crossing.len();
        for Crossing { beam, splits, distance } in &crossing {
            let at = smaller(larger(*splits, beam.begin), beam.end);
            let is_straight = at == *splits;
            let value =
                if is_straight { beam.offset + distance } else { beam.at(at) + length(opposite[0] - at, opposite[1]) };
            self.offer(c, value, beam.root);
        }
        for (out, corners) in [(l, [a, c]), (r, [c, b])] {
            let ends = self.distances(corners);
            for crossing in &crossing {
                let part = if out == l { crossing.to_left(frame, k) } else { crossing.to_right(frame, k) };
                if let Some(beam) = part {
                    self.leave(geometry, halfedge / 3, out, beam, ends);
                }
            }
        }
        self.crossing = crossing;
    }

    /// Sends windows from a vertex across all faces around it, and straight lines along its edges.
    ///
    /// Every vertex does, whether paths can bend there or not: where a window is missing, because a half-edge keeps but a
    /// few, the vertices on its rim take its place.
    fn emit(&mut self, geometry: &ExactGeometry, surface: &Surface, vertex: u32) {
        let (value, source) = (self.values[VertexId(vertex)], self.nearest[VertexId(vertex)]);
        for (face, k) in surface.corners_of_vertex(VertexId(vertex)) {
            let frame = geometry.frame(face.0);
            let (out, last) = (after(k), after(after(k)));
            let [b, c] = [frame.vertices[out], frame.vertices[last]];
            self.offer(b, value + frame.length[k], source);
            self.offer(c, value + frame.length[last], source);
            let ends = self.distances([c, b]);
            // Whatever lies behind the edge, its ends are nearer.
            if value >= smaller(ends[0], ends[1]) + 0.5 * frame.length[out] {
                continue;
            }
            let (x, depth) = (frame.length[last] * frame.cos[last], frame.length[k] * frame.sin[out]);
            let beam = Beam { begin: 0.0, end: frame.length[out], x, depth, offset: value, root: source };
            self.leave(geometry, face.0, out, beam, ends);
        }
    }

    /// Brings a window that leaves a face by half-edge `k` of its frame to those across the edge. It and the distances of
    /// the edge's ends are as a half-edge in the opposite direction sees them.
    fn leave(&mut self, geometry: &ExactGeometry, face: u32, k: usize, beam: Beam, ends: [f64; 2]) {
        let halfedge = 3 * face + k as u32;
        let frame = geometry.frame(face);
        let length = frame.length[k];
        if let Some(opposite) = frame.twin(k) {
            self.keep(opposite, &beam, &Bar { length, ends, opposite: Some(halfedge) });
            return;
        }
        for (target, is_mirrored) in geometry.across(halfedge) {
            if is_mirrored {
                let bar = Bar { length, ends: [ends[1], ends[0]], opposite: None };
                self.keep(target, &beam.mirrored(length), &bar);
            } else {
                self.keep(target, &beam, &Bar { length, ends, opposite: None });
            }
        }
    }

    fn keep(&mut self, halfedge: u32, beam: &Beam, bar: &Bar) {
        if let Some(nearest) = self.labels.offer(halfedge, beam, bar) {
            self.queue.push(halfedge, nearest);
        }
    }
}
