//! The front beyond the exact search: windows that wait at half-edges, vertices that wait to send some, and their way
//! across faces. Windows of a half-edge have distances in units of the cost of its face, so that a face is crossed in the
//! same way whatever it costs; values of vertices and the queues have distances themselves.

use std::sync::Arc;

use heatwalk_base::lanes::Lanes;
use heatwalk_surface::{Surface, VertexId};

use super::grow::{BATCH, Grow, PlaceInFace, Reached};
use super::labels::{Bar, Bars, Count, Labels};
use super::medium::{Medium, head_wave, refracted};
use super::queue::{Queue, sort_spent};
use crate::error::Result;
use crate::exact::{Beam, Crossing, ExactGeometry, Exits, Side, Wavefront, after, before, length};
use crate::extremum::{larger, smaller};

/// Width of the queue's buckets, in mean edges.
const BUCKET: f64 = 1.0;

/// So many faces in a row have to refuse a window that leaves by an edge of more.
const REFUSALS: usize = 16;

/// What windows carry.
pub(super) struct Front<C, M> {
    medium: M,
    reached: Reached,
    labels: Labels<C>,
    /// Half-edges where windows wait. What is pushed twice waits twice, and the second time finds nothing to do.
    crossing: Queue,
    /// Whether there was no memory for windows that cross, which are lost.
    is_refused: bool,
    /// Windows that cross now, each with its half-edge; kept for its memory.
    entering: Vec<(u32, Beam)>,
    /// What becomes of them, with room for [`BATCH`]; kept for its memory.
    passages: Vec<Passage>,
}

impl<C: Count, M: Medium> Front<C, M> {
    pub fn new(geometry: Arc<ExactGeometry>, medium: M, stretches: C) -> Result<Self> {
        let halfedges = 3 * geometry.surface().face_count();
        Ok(Self {
            labels: Labels::new(halfedges, stretches, geometry.mean_edge(), geometry.threads)?,
            crossing: Queue::new(&geometry, BUCKET),
            is_refused: false,
            entering: Vec::new(),
            passages: Vec::with_capacity(BATCH),
            reached: Reached::new(geometry, BUCKET),
            medium,
        })
    }

    /// Reads what a batch will need, so that the processor waits for all of it at once instead of for one after another:
    /// first the faces, then what these name.
    fn fetch(&self, geometry: &ExactGeometry, batch: &[u32]) {
        let mut sum = 0.0_f64;
        for &halfedge in batch {
            let (frame, _) = geometry.frame_of(halfedge);
            sum += frame[0].length + frame[2].length;
        }
        let mut labels = 0.0_f32;
        for &halfedge in batch {
            let (frame, k) = geometry.frame_of(halfedge);
            sum += self.reached.values[VertexId(frame[before(k)].vertex)];
            labels += self.labels.value_of(halfedge);
            for out in [after(k), before(k)] {
                labels += self.labels.value_of(frame[out].next_on_edge >> 2);
            }
        }
        std::hint::black_box((sum, labels));
    }

    fn distances(&self, vertices: [u32; 2]) -> [f64; 2] {
        vertices.map(|vertex| self.reached.values[VertexId(vertex)])
    }

    /// Takes the windows that wait at some half-edges, and are still of use, each with its half-edge.
    fn enter(&mut self, geometry: &ExactGeometry, batch: &[u32], entering: &mut Vec<(u32, Beam)>) {
        entering.clear();
        if entering.try_reserve(batch.len() * self.labels.stretches()).is_err() {
            self.is_refused = true;
            return;
        }
        for &halfedge in batch {
            let (frame, k) = geometry.frame_of(halfedge);
            let cost = self.medium.cost(halfedge / 3);
            let ends = self.distances([k, after(k)].map(|corner| frame[corner].vertex)).map(|value| value / cost);
            let bar = Bar { length: frame[k].length, ends };
            let first = entering.len();
            for stretch in 0..self.labels.stretches() {
                let Some(beam) = self.labels.take(halfedge, stretch, &bar) else { continue };
                // One that is kept for several stretches crosses once.
                if entering[first..].last() != Some(&(halfedge, beam)) {
                    entering.push((halfedge, beam));
                }
            }
        }
        self.reached.crossed += entering.len();
    }

    /// Lets windows cross the faces of their half-edges, at most [`BATCH`] of them: values for the opposite corners, windows
    /// for the half-edges across the two other edges.
    ///
    /// In steps, each for all of them and without a branch where chance decides, so that the processor works on several
    /// windows at once.
    fn cross(&mut self, geometry: &ExactGeometry, entering: &[(u32, Beam)]) {
        let mut passages = std::mem::take(&mut self.passages);
        passages.clear();
        passages.extend(entering.iter().map(|&(halfedge, beam)| Passage::new(geometry, halfedge, beam)));
        for (&(halfedge, beam), passage) in entering.iter().zip(&passages) {
            self.reached.offer(passage.corners[2], self.medium.cost(halfedge / 3) * passage.at_corner, beam.root);
            if geometry.portals().in_faces().are_in(halfedge / 3) {
                self.see(geometry, halfedge, &beam);
            }
        }
        let mut leaving = [0_u8; 2 * BATCH];
        let mut count = 0;
        for ((&(halfedge, _), passage), number) in entering.iter().zip(&mut passages).zip((0..).step_by(2)) {
            let cost = self.medium.cost(halfedge / 3);
            let [at_a, at_b, at_c] = passage.corners.map(|vertex| self.reached.values[VertexId(vertex)] / cost);
            passage.bars.ends = [Lanes::new([at_a, at_c]), Lanes::new([at_c, at_b])];
            let are_sooner = self.are_sooner(passage);
            for (number, is_sooner) in (number..).zip(are_sooner) {
                leaving[count] = number;
                count += usize::from(is_sooner);
            }
        }
        for &number in &leaving[..count] {
            let (passage, k) = (&passages[usize::from(number / 2)], usize::from(number % 2));
            let (from, to) = (passage.from[k], passage.to[k]);
            let (beam, bar) = (passage.exits.beam(k), passage.bars.bar(k));
            if to == NO_TWIN {
                self.leave_fan(geometry, from, &beam, &bar);
            } else {
                self.keep_behind((from, to), &beam, &bar);
            }
        }
        self.passages = passages;
    }

    /// Whether what leaves a face may be kept, as far as is easily told.
    #[inline(always)]
    fn are_sooner(&self, passage: &Passage) -> [bool; 2] {
        let is_open = passage.exits.is_open.to_array();
        if !(M::IS_UNIFORM & passage.is_inside()) {
            return is_open;
        }
        let are_sooner = self.labels.are_sooner(passage.to, &passage.exits, &passage.bars);
        std::array::from_fn(|k| is_open[k] & are_sooner[k])
    }

    /// Whether a neighbor of a vertex is farther than by the edge between: windows may have lost it, and nobody else tells it.
    fn shortens(&self, geometry: &ExactGeometry, surface: &Surface, vertex: VertexId) -> bool {
        let value = self.reached.values[vertex];
        surface.corners_of_vertex(vertex).any(|(face, k)| {
            let [from, out, last] = geometry.frame(face.0).seen_from(k);
            let [at_out, at_last] = [out.vertex, last.vertex].map(|other| self.reached.values[VertexId(other)]);
            value + from.length < at_out || value + last.length < at_last
        })
    }

    /// Offers the ends of portals in a half-edge's face the path through a window that enters there.
    #[cold]
    fn see(&mut self, geometry: &ExactGeometry, halfedge: u32, beam: &Beam) {
        let (frame, k) = geometry.frame_of(halfedge);
        let cost = self.medium.cost(halfedge / 3);
        for point in geometry.portals().in_faces().in_face(halfedge / 3) {
            let [x, y] = frame.place(k, point.weights);
            let crosses = beam.x + (x - beam.x) * beam.depth / (beam.depth + y);
            let at = smaller(larger(crosses, beam.begin), beam.end);
            self.reached.offer_end(point.point as u32, cost * (beam.at(at) + length(x - at, y)), beam.root);
        }
    }

    /// Offers the ends of portals in a face straight lines from a place there.
    #[cold]
    fn see_straight(&mut self, geometry: &ExactGeometry, (face, from): (u32, [f64; 3]), value: f64, source: u32) {
        let frame = geometry.frame(face);
        let cost = self.medium.cost(face);
        for point in geometry.portals().in_faces().in_face(face) {
            let [a, b] = [from, point.weights].map(|weights| frame.place(0, weights));
            self.reached.offer_end(point.point as u32, value + cost * length(a[0] - b[0], a[1] - b[1]), source);
        }
    }

    /// Sends a face the waves of paths that run from one of its corners along the edges there, where these have cheaper
    /// ground on their other side. The distance of the corner is in units of the face's cost.
    fn send_along(&mut self, geometry: &ExactGeometry, (face, k): (u32, usize), (distance, source): (f64, u32)) {
        let frame = geometry.frame(face);
        let cost = self.medium.cost(face);
        for (side, is_against) in [(k, false), (before(k), true)] {
            let halfedge = 3 * face + side as u32;
            let cheapest = geometry.across(halfedge).map(|(other, _)| self.medium.cost(other / 3)).reduce(smaller);
            let Some(share) = cheapest.map(|cheapest| cheapest / cost).filter(|&share| share < 1.0) else { continue };
            let length = frame[side].length;
            let wave = head_wave(length, distance, share, source);
            let wave = if is_against { wave.mirrored(length) } else { wave };
            let ends = self.distances([side, after(side)].map(|k| frame[k].vertex)).map(|value| value / cost);
            self.keep(halfedge, &wave, &Bar { length, ends });
        }
    }

    /// Brings a window that leaves a face by one of its sides to the half-edges across. It and the distances of the side's
    /// ends are as a half-edge in the opposite direction sees them.
    #[inline(always)]
    fn leave(&mut self, geometry: &ExactGeometry, halfedge: u32, side: &Side, beam: &Beam, ends: [f64; 2]) {
        let length = side.length;
        if let Some(twin) = side.twin() {
            self.keep_behind((halfedge, twin), beam, &Bar { length, ends });
        } else {
            self.leave_fan(geometry, halfedge, beam, &Bar { length, ends });
        }
    }

    /// The same for an edge that is not between two faces of one orientation.
    ///
    /// What comes to an edge is kept behind it on all faces but its own, so that they know of much the same. Where costs are one, and so
    /// many faces have not kept a window, the others are not asked.
    #[cold]
    fn leave_fan(&mut self, geometry: &ExactGeometry, halfedge: u32, beam: &Beam, bar: &Bar) {
        let mut refusals = 0;
        for (target, is_mirrored) in geometry.across(halfedge) {
            let is_kept = if is_mirrored {
                let [begin, end] = bar.ends;
                let bar = Bar { ends: [end, begin], ..*bar };
                self.keep_behind((halfedge, target), &beam.mirrored(bar.length), &bar)
            } else {
                self.keep_behind((halfedge, target), beam, bar)
            };
            refusals = if is_kept { 0 } else { refusals + 1 };
            if M::IS_UNIFORM && refusals == REFUSALS {
                return;
            }
        }
    }

    /// Keeps a window that leaves a face by its half-edge `from`, seen in units of that face's cost, at the half-edge `to` of
    /// the face behind. Returns whether it is kept.
    #[inline(always)]
    fn keep_behind(&mut self, (from, to): (u32, u32), beam: &Beam, bar: &Bar) -> bool {
        let [before, behind] = [from, to].map(|halfedge| self.medium.cost(halfedge / 3));
        if before == behind {
            self.keep(to, beam, bar)
        } else {
            let ratio = before / behind;
            let bar = Bar { ends: bar.ends.map(|value| value * ratio), ..*bar };
            refracted(beam, ratio).is_some_and(|beam| self.keep(to, &beam, &bar))
        }
    }

    #[inline(always)]
    fn keep(&mut self, halfedge: u32, beam: &Beam, bar: &Bar) -> bool {
        let kept = self.labels.offer(halfedge, beam, bar);
        if let Some(nearest) = kept {
            self.crossing.push(halfedge, nearest * self.medium.cost(halfedge / 3));
        }
        kept.is_some()
    }
}

impl<C: Count, M: Medium> Grow for Front<C, M> {
    fn reached(&self) -> &Reached {
        &self.reached
    }

    fn reached_mut(&mut self) -> &mut Reached {
        &mut self.reached
    }

    fn clear(&mut self, surface: &Surface, least: f64) {
        self.labels.clear();
        self.crossing.clear(least, 3 * surface.face_count());
        self.is_refused = false;
    }

    fn go_on(&mut self, geometry: &ExactGeometry, surface: &Surface, exact: &Wavefront) {
        for &vertex in exact.reached() {
            if self.reached.values[vertex] >= exact.radius() || self.shortens(geometry, surface, vertex) {
                self.reached.send_from(vertex.0);
            }
        }
        exact.for_each_waiting(&mut |halfedge, beam| {
            let (frame, k) = geometry.frame_of(halfedge);
            let corners = [k, after(k)].map(|corner| frame[corner].vertex);
            corners.into_iter().for_each(|vertex| self.reached.send_from(vertex));
            self.keep(halfedge, &beam, &Bar { length: frame[k].length, ends: self.distances(corners) });
        });
    }

    /// Sends windows out of the face, and straight lines to its corners.
    fn light(&mut self, geometry: &ExactGeometry, (face, weights): PlaceInFace, value: f64, source: u32) {
        let frame = geometry.frame(face);
        let cost = self.medium.cost(face);
        for k in 0..3 {
            let [x, depth] = frame.place(k, weights);
            self.reached.offer(frame[k].vertex, value + cost * length(x, depth), source);
            if depth > 0.0 {
                let side = &frame[k];
                let ends = self.distances([frame[after(k)].vertex, side.vertex]).map(|value| value / cost);
                let (x, offset) = (side.length - x, value / cost);
                let beam = Beam { begin: 0.0, end: side.length, x, depth, offset, root: source };
                self.leave(geometry, 3 * face + k as u32, side, &beam, ends);
            }
        }
        self.see_straight(geometry, (face, weights), value, source);
    }

    /// Sends windows from a vertex across all faces around it, and straight lines along its edges.
    ///
    /// Every vertex does, whether paths can bend there or not: where a window is missing, because a half-edge keeps but a
    /// few, the vertices on its rim take its place.
    fn send(&mut self, geometry: &ExactGeometry, surface: &Surface, vertex: u32, _settled: f64) {
        let (value, source) = (self.reached.values[VertexId(vertex)], self.reached.nearest[VertexId(vertex)]);
        for (face, k) in surface.corners_of_vertex(VertexId(vertex)) {
            if geometry.portals().in_faces().are_in(face.0) {
                let mut weights = [0.0; 3];
                weights[k] = 1.0;
                self.see_straight(geometry, (face.0, weights), value, source);
            }
            let [from, out, last] = geometry.frame(face.0).seen_from(k);
            let cost = self.medium.cost(face.0);
            self.reached.offer(out.vertex, value + cost * from.length, source);
            // Where another face lies there, it has offered that, unless it costs more.
            if !M::IS_UNIFORM || last.twin().is_none() {
                self.reached.offer(last.vertex, value + cost * last.length, source);
            }
            if !M::IS_UNIFORM {
                self.send_along(geometry, (face.0, k), (value / cost, source));
            }
            let ends = self.distances([last.vertex, out.vertex]).map(|value| value / cost);
            let value = value / cost;
            // Whatever lies behind the edge, its ends are nearer.
            if value + larger(from.length, last.length) >= smaller(ends[0], ends[1]) + out.length {
                continue;
            }
            let (x, depth) = (last.length * last.cos, from.length * out.sin);
            let beam = Beam { begin: 0.0, end: out.length, x, depth, offset: value, root: source };
            self.leave(geometry, 3 * face.0 + after(k) as u32, out, &beam, ends);
        }
    }

    fn grow(&mut self, geometry: &ExactGeometry, surface: &Surface, radius: f64) {
        if sort_spent([&mut self.crossing, &mut self.reached.sending]) {
            self.labels.hurry();
        }
        // Vertices wait for the windows of their bucket, which may bring them shorter paths.
        let mut batch = std::mem::take(&mut self.reached.batch);
        self.crossing.pop_some(smaller(radius, self.reached.sending.ceiling()), BATCH, &mut batch);
        self.fetch(geometry, &batch);
        let mut entering = std::mem::take(&mut self.entering);
        self.enter(geometry, &batch, &mut entering);
        for windows in entering.chunks(BATCH) {
            self.cross(geometry, windows);
        }
        let are_none = batch.is_empty();
        (self.reached.batch, self.entering) = (batch, entering);
        if are_none {
            self.send_some(geometry, surface, smaller(radius, self.crossing.ceiling()));
        }
    }

    fn floor(&self) -> f64 {
        smaller(self.crossing.floor(), self.reached.sending.floor())
    }

    fn is_refused(&self) -> bool {
        self.is_refused | self.labels.is_refused() | self.crossing.is_refused() | self.reached.sending.is_refused()
    }
}

/// In place of a half-edge, where an edge is not between two faces of one orientation.
const NO_TWIN: u32 = u32::MAX;

/// A window that crosses a face, and what leaves by the edges at the begin and at the end of its half-edge.
#[derive(Debug, Clone, Copy)]
struct Passage {
    /// Where the half-edge begins and ends, and the opposite corner.
    corners: [u32; 3],
    /// The distance of that corner, in units of the face's cost.
    at_corner: f64,
    exits: Exits,
    /// The half-edges by which they leave.
    from: [u32; 2],
    /// Those that run against these, or [`NO_TWIN`].
    to: [u32; 2],
    /// The edges with the distances of their ends, as half-edges against `from` see them.
    bars: Bars,
}

impl Passage {
    /// All but the distances of the edges' ends.
    #[inline(always)]
    fn new(geometry: &ExactGeometry, halfedge: u32, beam: Beam) -> Self {
        let (frame, k) = geometry.frame_of(halfedge);
        let (sides, opposite) = (frame.seen_from(k), frame.opposite(k));
        let crossing = Crossing::new(beam, opposite);
        let at = smaller(larger(crossing.splits(), beam.begin), beam.end);
        let first = halfedge - k as u32;
        let ways = [sides[2], sides[1]];
        Self {
            corners: sides.map(|side| side.vertex),
            at_corner: beam.at(at) + length(opposite[0] - at, opposite[1]),
            exits: crossing.exits(sides),
            from: [before(k), after(k)].map(|k| first + k as u32),
            to: ways.map(|side| side.twin().unwrap_or(NO_TWIN)),
            bars: Bars { length: Lanes::new(ways.map(|side| side.length)), ends: [Lanes::both(0.0); 2] },
        }
    }

    /// Whether both edges are between two faces of one orientation.
    #[inline(always)]
    fn is_inside(&self) -> bool {
        !self.to.contains(&NO_TWIN)
    }
}
