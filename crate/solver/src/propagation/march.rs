//! The front beyond the exact search, carried by vertices alone: fast marching (Kimmel & Sethian, "Computing geodesic paths
//! on manifolds", 1998) with the circular waves of Novotni & Klein ("Computing geodesic distances on triangular meshes",
//! 2002).
//!
//! Two vertices of a face tell where the wave would come from if it came from one point through a plane; the third has the
//! distance from there, if the straight line crosses the edge between the two, or else one along an edge.

use std::sync::Arc;

use heatwalk_surface::{FaceId, Surface, VertexId};

use super::grow::{Grow, PlaceInFace, Reached};
use super::queue::sort_spent;
use crate::cost::Costs;
use crate::exact::{ExactGeometry, Wavefront, after, before, length};
use crate::extremum::{larger, smaller};

/// Width of the queue's buckets, in mean edges.
const BUCKET: f64 = 0.5;

pub(super) struct March {
    reached: Reached,
    /// Of the faces, where they are not all 1.
    costs: Option<Costs>,
    /// What is nearer than this is known from the exact search.
    exact_below: f64,
}

impl March {
    pub fn new(geometry: Arc<ExactGeometry>) -> Self {
        let costs = geometry.costs().cloned();
        Self { reached: Reached::new(geometry, BUCKET), costs, exact_below: 0.0 }
    }

    #[inline(always)]
    fn cost(&self, face: u32) -> f64 {
        self.costs.as_ref().map_or(1.0, |costs| costs.of(FaceId(face)))
    }

    /// Offers a vertex a shorter distance. Waves may seem shorter than they are, but not than what the exact search left.
    #[inline(always)]
    fn offer(&mut self, vertex: u32, value: f64, source: u32) {
        self.reached.offer(vertex, larger(value, self.exact_below), source);
    }

    fn offer_end(&mut self, end: u32, value: f64, source: u32) {
        self.reached.offer_end(end, larger(value, self.exact_below), source);
    }

    /// Offers the corner opposite a half-edge the distance through it.
    #[inline(always)]
    fn cross(&mut self, geometry: &ExactGeometry, face: u32, k: usize) {
        let frame = geometry.frame(face);
        let value = self.through(geometry, (face, k), frame.opposite(k));
        let [a, b] = [k, after(k)].map(|k| VertexId(frame[k].vertex));
        let nearer = if self.reached.values[a] < self.reached.values[b] { a } else { b };
        self.offer(frame[before(k)].vertex, value, self.reached.nearest[nearer]);
    }

    /// The distance at a place in a face, by a straight line through one of its half-edges, on which the place is seen as by
    /// [`Frame::opposite`](crate::exact::Frame::opposite); infinite where there is none.
    fn through(&self, geometry: &ExactGeometry, (face, k): (u32, usize), [x, y]: [f64; 2]) -> f64 {
        let frame = geometry.frame(face);
        let (base, cost) = (frame[k].length, self.cost(face));
        // In lengths of the half-edge, which begins at 0 and has the source of the wave below it.
        let per_length = base.recip();
        let [at_a, at_b] = [k, after(k)].map(|k| self.reached.values[VertexId(frame[k].vertex)] * (per_length / cost));
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
                let straight = self.reached.values[corner] + cost * length(x, y);
                let value = smaller(straight, self.through(geometry, (face, k), place));
                self.offer_end(point.point as u32, value, self.reached.nearest[corner]);
            }
        }
    }
}

impl Grow for March {
    fn reached(&self) -> &Reached {
        &self.reached
    }

    fn reached_mut(&mut self) -> &mut Reached {
        &mut self.reached
    }

    fn clear(&mut self, _surface: &Surface, _least: f64) {
        self.exact_below = 0.0;
    }

    fn go_on(&mut self, geometry: &ExactGeometry, _surface: &Surface, exact: &Wavefront) {
        self.exact_below = exact.radius();
        for &vertex in exact.reached() {
            if self.reached.values[vertex] >= exact.radius() {
                self.reached.send_from(vertex.0);
            }
        }
        // Behind the edges where windows wait, not all that they would reach is known.
        for halfedge in exact.lit() {
            let (frame, k) = geometry.frame_of(halfedge);
            let ends = [k, after(k)].map(|k| frame[k].vertex);
            for end in ends.into_iter().filter(|&end| exact.values()[VertexId(end)] < f64::INFINITY) {
                self.reached.send_from(end);
            }
        }
    }

    /// To its corners and to ends of portals there.
    fn light(&mut self, geometry: &ExactGeometry, (face, weights): PlaceInFace, value: f64, source: u32) {
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

    /// Across the faces around it.
    fn send(&mut self, geometry: &ExactGeometry, surface: &Surface, vertex: u32, settled: f64) {
        let (value, source) = (self.reached.values[VertexId(vertex)], self.reached.nearest[VertexId(vertex)]);
        for (face, k) in surface.corners_of_vertex(VertexId(vertex)) {
            let [from, out, last] = geometry.frame(face.0).seen_from(k);
            let cost = self.cost(face.0);
            let [at_out, at_last] = [out, last].map(|side| self.reached.values[VertexId(side.vertex)]);
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
            self.reached.crossed += 1;
        }
    }

    fn grow(&mut self, geometry: &ExactGeometry, surface: &Surface, radius: f64) {
        sort_spent([&mut self.reached.sending]);
        self.send_some(geometry, surface, radius);
    }

    fn floor(&self) -> f64 {
        self.reached.sending.floor()
    }

    fn is_refused(&self) -> bool {
        self.reached.sending.is_refused()
    }
}
