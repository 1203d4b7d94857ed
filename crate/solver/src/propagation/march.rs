//! The front beyond the exact search, carried by vertices alone: fast marching (Kimmel & Sethian, "Computing geodesic paths
//! on manifolds", 1998) with the circular waves of Novotni & Klein ("Computing geodesic distances on triangular meshes",
//! 2002).
//!
//! Two vertices of a face tell where the wave would come from if it came from one point through a plane; the third has the
//! distance from there, if the straight line crosses the edge between the two, or else one along an edge.

use std::sync::Arc;

use super::ends::Ends;
use super::grow::{BATCH, Grow, NOWHERE, fetch_around, lights, nearest_start};
use super::queue::{Queue, sort_spent};
use crate::cost::Costs;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront, after, before, length};
use crate::extremum::{larger, smaller};
use crate::room::{REFUSED, refilled};
use heatwalk_surface::{FaceId, Source, Surface, VertexData, VertexId};

/// Width of the queue's buckets, in mean edges.
const BUCKET: f64 = 0.5;

pub(super) struct March {
    surface: Arc<Surface>,
    geometry: Arc<ExactGeometry>,
    /// Of the faces, where they are not all 1.
    costs: Option<Costs>,
    /// `#V`, as its other lists empty before the first start.
    values: VertexData<f64>,
    /// `#V`, number of the source that each value comes from.
    nearest: VertexData<u32>,
    /// `#V`, whether a vertex has still to be gone on from.
    waits: Vec<bool>,
    /// Vertices that wait, and after them ends of portals. What is pushed twice waits twice, and the second time finds nothing
    /// to do.
    sending: Queue,
    ends: Ends,
    /// What is nearer than this is known from the exact search.
    exact_below: f64,
    crossed: usize,
    /// Items that are processed now; kept for its memory.
    batch: Vec<u32>,
}

impl March {
    pub fn new(geometry: Arc<ExactGeometry>) -> Self {
        Self {
            surface: Arc::clone(geometry.surface()),
            costs: geometry.costs().cloned(),
            values: VertexData::default(),
            nearest: VertexData::default(),
            waits: Vec::new(),
            sending: Queue::new(BUCKET * geometry.mean_edge()),
            ends: Ends::default(),
            exact_below: 0.0,
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
        (self.exact_below, self.crossed) = (0.0, 0);
        Ok(())
    }

    #[inline(always)]
    fn cost(&self, face: u32) -> f64 {
        self.costs.as_ref().map_or(1.0, |costs| costs.of(FaceId(face)))
    }

    fn send_from(&mut self, vertex: VertexId) {
        self.waits[vertex.0 as usize] = true;
        self.sending.push(vertex.0, self.values[vertex]);
    }

    /// Offers a vertex a shorter distance. Waves may seem shorter than they are, but not than what the exact search left.
    #[inline(always)]
    fn offer(&mut self, vertex: u32, value: f64, source: u32) {
        let (vertex, value) = (VertexId(vertex), larger(value, self.exact_below));
        if value < self.values[vertex] {
            self.values[vertex] = value;
            self.nearest[vertex] = source;
            self.send_from(vertex);
        }
    }

    fn offer_end(&mut self, end: u32, value: f64, source: u32) {
        let value = larger(value, self.exact_below);
        if self.ends.offer(end, value, source) {
            self.sending.push(self.waits.len() as u32 + end, value);
        }
    }

    /// Goes on from a vertex across the faces around it. `settled`: distances below this seldom fall any more.
    fn cross_around(&mut self, geometry: &ExactGeometry, surface: &Surface, vertex: u32, settled: f64) {
        if !std::mem::take(&mut self.waits[vertex as usize]) {
            return;
        }
        let (value, source) = (self.values[VertexId(vertex)], self.nearest[VertexId(vertex)]);
        for (face, k) in surface.corners_of_vertex(VertexId(vertex)) {
            let [from, out, last] = geometry.frame(face.0).seen_from(k);
            let cost = self.cost(face.0);
            let [at_out, at_last] = [out, last].map(|side| self.values[VertexId(side.vertex)]);
            self.offer(out.vertex, value + cost * from.length, source);
            // Where another face lies there, it has offered that, unless it costs more.
            if self.costs.is_some() || last.twin().is_none() {
                self.offer(last.vertex, value + cost * last.length, source);
            }
            // The last of two vertices goes on for both.
            let through = match (at_out < smaller(at_last, settled), at_last < smaller(at_out, settled)) {
                (true, _) => Some(k),
                (_, true) => Some(before(k)),
                _ => None,
            };
            if let Some(halfedge) = through {
                self.cross(geometry, face.0, halfedge);
            }
            if geometry.portals().in_faces().are_in(face.0) {
                self.see(geometry, face.0);
            }
            self.crossed += 1;
        }
    }

    /// Offers the corner opposite a half-edge the distance through it.
    #[inline(always)]
    fn cross(&mut self, geometry: &ExactGeometry, face: u32, k: usize) {
        let frame = geometry.frame(face);
        let value = self.through(geometry, (face, k), frame.opposite(k));
        let [a, b] = [k, after(k)].map(|k| VertexId(frame[k].vertex));
        let nearer = if self.values[a] < self.values[b] { a } else { b };
        self.offer(frame[before(k)].vertex, value, self.nearest[nearer]);
    }

    /// The distance at a place in a face, by a straight line through one of its half-edges, on which the place is seen as by
    /// [`Frame::opposite`](crate::exact::Frame::opposite); infinite where there is none.
    fn through(&self, geometry: &ExactGeometry, (face, k): (u32, usize), [x, y]: [f64; 2]) -> f64 {
        let frame = geometry.frame(face);
        let (base, cost) = (frame[k].length, self.cost(face));
        // In lengths of the half-edge, which begins at 0 and has the source of the wave below it.
        let per_length = base.recip();
        let [at_a, at_b] = [k, after(k)].map(|k| self.values[VertexId(frame[k].vertex)] * (per_length / cost));
        let [x, y] = [x * per_length, y * per_length];
        let along = 0.5 + 0.5 * (at_a - at_b) * (at_a + at_b);
        let depth = larger(at_a * at_a - along * along, 0.0).sqrt();
        let crosses = along + (x - along) * depth / (depth + y);
        if (0.0..=1.0).contains(&crosses) { base * cost * length(x - along, y + depth) } else { f64::INFINITY }
    }

    /// Offers the ends of portals in a face what its corners know.
    #[cold]
    fn see(&mut self, geometry: &ExactGeometry, face: u32) {
        let (frame, cost) = (geometry.frame(face), self.cost(face));
        for point in geometry.portals().in_faces().in_face(face) {
            for k in 0..3 {
                let corner = VertexId(frame[k].vertex);
                let place @ [x, y] = frame.place(k, point.weights);
                let straight = self.values[corner] + cost * length(x, y);
                let value = smaller(straight, self.through(geometry, (face, k), place));
                self.offer_end(point.point as u32, value, self.nearest[corner]);
            }
        }
    }

    /// Goes on from a place in a face, given by barycentric weights, to its corners and to ends of portals there.
    fn light(&mut self, geometry: &ExactGeometry, (face, weights): (u32, [f64; 3]), value: f64, source: u32) {
        let (frame, cost) = (geometry.frame(face), self.cost(face));
        for k in 0..3 {
            let [x, y] = frame.place(k, weights);
            self.offer(frame[k].vertex, value + cost * length(x, y), source);
        }
        for point in geometry.portals().in_faces().in_face(face) {
            let [a, b] = [weights, point.weights].map(|weights| frame.place(0, weights));
            self.offer_end(point.point as u32, value + cost * length(a[0] - b[0], a[1] - b[1]), source);
        }
    }

    /// Lets what has reached an end of a portal go on at the other one.
    fn emerge(&mut self, geometry: &ExactGeometry, surface: &Surface, end: u32) {
        let Some((other, value, source)) = self.ends.pass(geometry.portals(), end) else { return };
        for at in geometry.faces_at(surface, geometry.portals().places()[other as usize]) {
            self.light(geometry, at, value, source);
        }
    }
}

impl Grow for March {
    fn start(&mut self, exact: &Wavefront) -> Result<()> {
        self.clear(exact.base())?;
        self.exact_below = exact.radius();
        for (end, value) in self.ends.start(exact) {
            self.sending.push(self.waits.len() as u32 + end, value);
        }
        for &vertex in exact.reached() {
            self.values[vertex] = exact.values()[vertex];
            self.nearest[vertex] = exact.source_of(vertex.0);
            if self.values[vertex] >= exact.radius() {
                self.send_from(vertex);
            }
        }
        // Behind the edges where windows wait, not all that they would reach is known.
        for halfedge in exact.lit() {
            let (frame, k) = self.geometry.frame_of(halfedge);
            let ends = [k, after(k)].map(|k| VertexId(frame[k].vertex));
            for end in ends.into_iter().filter(|&end| exact.values()[end] < f64::INFINITY) {
                self.send_from(end);
            }
        }
        Ok(())
    }

    fn start_at(&mut self, sources: &[Source]) -> Result<()> {
        self.clear(nearest_start(sources))?;
        let (geometry, surface) = (Arc::clone(&self.geometry), Arc::clone(&self.surface));
        self.ends.clear(geometry.portals().places().len());
        for (at, value, source) in lights(&geometry, &surface, sources) {
            self.light(&geometry, at, value, source);
        }
        Ok(())
    }

    fn advance(&mut self, radius: f64, work: usize) -> Result<()> {
        let enough = self.crossed.saturating_add(work);
        let (geometry, surface) = (Arc::clone(&self.geometry), Arc::clone(&self.surface));
        let vertices = self.waits.len() as u32;
        let mut batch = std::mem::take(&mut self.batch);
        while self.crossed < enough && self.radius() < radius && !self.sending.is_refused() {
            sort_spent([&mut self.sending]);
            self.sending.pop_some(radius, BATCH, &mut batch);
            let settled = self.sending.ceiling();
            fetch_around(&geometry, &surface, batch.iter().copied().filter(|&item| item < vertices));
            for &item in &batch {
                match item.checked_sub(vertices) {
                    None => self.cross_around(&geometry, &surface, item, settled),
                    Some(end) => self.emerge(&geometry, &surface, end),
                }
            }
        }
        self.batch = batch;
        if self.sending.is_refused() { Err(REFUSED) } else { Ok(()) }
    }

    fn radius(&self) -> f64 {
        if self.sending.is_refused() { f64::NEG_INFINITY } else { self.sending.floor() }
    }

    fn values(&self) -> &VertexData<f64> {
        &self.values
    }

    fn nearest(&self, vertex: VertexId) -> u32 {
        self.nearest[vertex]
    }

    fn entered(&self, end: u32) -> Option<f64> {
        self.ends.entered(end)
    }

    fn crossed(&self) -> usize {
        self.crossed
    }
}
