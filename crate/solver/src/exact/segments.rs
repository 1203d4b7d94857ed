//! Segments of curves as sources: strips go out from them to both sides, windows from their ends.

use std::collections::BTreeMap;
use std::sync::Arc;

use heatwalk_surface::{Place, Source};

use super::geometry::{ExactGeometry, Frame, after, before};
use super::lines::Lines;
use super::origin::Origin;
use super::pool::Pool;
use super::strip::{Lost, Strip, merge, nearest_of};
use super::wavefront::{Wavefront, require_one_cost};
use super::window::length;
use crate::error::Result;
use crate::extremum::smaller;

/// A straight line in a face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Segment {
    pub face: u32,
    /// Barycentric weights of its ends.
    pub ends: [[f64; 3]; 2],
}

/// What lies on the left and on the right of a segment, as seen from outside.
pub(crate) const SIDES: u32 = 2;

/// Segments, and the strips that wait to enter a face by each of its half-edges.
#[derive(Debug)]
pub(super) struct Segments {
    all: Vec<Segment>,
    waiting: Pool<Strip>,
    /// Strips that cross now; kept for its memory.
    crossing: Vec<Strip>,
    /// Those that leave by either half-edge; kept for its memory.
    leaving: [Vec<Strip>; 2],
    /// Kept for their memory.
    merged: Vec<Strip>,
    lost: Lost,
}

impl Lines<Wavefront> for Segments {
    fn cross(&mut self, front: &mut Wavefront, geometry: &ExactGeometry, halfedge: u32) {
        if self.waiting.is_empty(halfedge) {
            return;
        }
        let mut strips = std::mem::take(&mut self.crossing);
        self.waiting.take(halfedge, &mut strips);
        let ((frame, k), grain) = (geometry.frame_of(halfedge), geometry.grain);
        let (sides, opposite) = (frame.seen_from(k), frame.opposite(k));
        let limits = [sides[0], sides[1]].map(|side| front.limit(side.vertex));
        strips.retain_mut(|strip| strip.clip(sides[0].length, limits, grain));
        if !strips.is_empty() && !front.waiting.at(halfedge).is_empty() {
            self.lost.settle(&mut strips, front.waiting.at_mut(halfedge));
        }
        front.propagated += strips.len();
        let mut leaving = std::mem::take(&mut self.leaving);
        if leaving.iter_mut().any(|way| way.try_reserve(strips.len()).is_err()) {
            return front.is_refused = true;
        }
        let has_points = front.targets.are_in(halfedge / 3) || front.ends.are_in(halfedge / 3);
        for strip in &strips {
            let seen = |place: [f64; 2]| {
                let (at, value) = strip.sees(place, grain)?;
                let [x, depth] = strip.foot(at);
                Some((value, Origin::Window { halfedge, root: strip.root, at, x, depth }))
            };
            if has_points {
                front.see_points(frame, halfedge, seen);
            }
            if let Some((value, origin)) = seen(opposite) {
                front.offer(sides[2].vertex, value, origin);
            }
            for (exit, way) in strip.exits(sides, opposite).into_iter().zip(&mut leaving) {
                way.extend(exit.filter(|exit| exit.is_wide(grain)));
            }
        }
        let first = halfedge - k as u32;
        for (out, way) in [before(k), after(k)].into_iter().zip(&mut leaving) {
            self.deliver(front, geometry, first + out as u32, way);
        }
        strips.clear();
        (self.crossing, self.leaving) = (strips, leaving);
    }

    fn face(&self, side: u32) -> u32 {
        self.all[(side / SIDES) as usize].face
    }

    fn foot(&self, frame: &Frame, k: usize, side: u32, place: [f64; 2]) -> [f64; 3] {
        let Segment { ends, .. } = self.all[(side / SIDES) as usize];
        let share = share(ends.map(|weights| frame.place(k, weights)), place).clamp(0.0, 1.0);
        std::array::from_fn(|corner| ends[0][corner] + share * (ends[1][corner] - ends[0][corner]))
    }
}

impl Wavefront {
    /// From segments of curves, with sources where these end.
    ///
    /// # Errors
    /// [`Error::NotExact`](crate::Error::NotExact) where faces have different costs; [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(crate) fn of_segments(
        geometry: Arc<ExactGeometry>,
        segments: Vec<Segment>,
        sources: Vec<Source>,
        targets: &[Place],
    ) -> Result<Self> {
        require_one_cost(&geometry)?;
        let mut wavefront = Self::of_checked(geometry, sources, targets)?;
        let segments = Segments::started(segments, &mut wavefront);
        wavefront.lines = Some(Box::new(segments));
        Ok(wavefront)
    }
}

impl Segments {
    /// Starts from all segments.
    pub fn started(all: Vec<Segment>, front: &mut Wavefront) -> Self {
        let mut segments = Self {
            all,
            waiting: Pool::new(front.waiting.len()),
            crossing: Vec::new(),
            leaving: Default::default(),
            merged: Vec::new(),
            lost: Lost::default(),
        };
        let geometry = Arc::clone(&front.geometry);
        let mut leaving: BTreeMap<u32, Vec<Strip>> = BTreeMap::new();
        for (number, segment) in segments.all.iter().enumerate() {
            let left = front.root_of_side(number as u32 * SIDES);
            let (frame, first) = (geometry.frame(segment.face), segment.face * 3);
            for (k, side) in [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)] {
                let strip = segment.strip(frame, k, side).filter(|strip| strip.is_wide(geometry.grain));
                let rooted = strip.map(|strip| Strip { root: left + side, ..strip });
                leaving.entry(first + k as u32).or_default().extend(rooted);
            }
            let seen = segment.seen(frame, left);
            front.see_points(frame, first, &seen);
            for k in 0..3 {
                let corner = frame.place(0, std::array::from_fn(|corner| f64::from(u8::from(corner == k))));
                if let Some((value, origin)) = seen(corner) {
                    front.offer(frame[k].vertex, value, origin);
                }
            }
        }
        for (halfedge, strips) in leaving {
            segments.deliver(front, &geometry, halfedge, &mut nearest_of(&strips));
        }
        segments
    }

    /// Brings strips that leave a face by a half-edge to the half-edges on the other faces of its edge. None is left.
    fn deliver(&mut self, front: &mut Wavefront, geometry: &ExactGeometry, halfedge: u32, strips: &mut Vec<Strip>) {
        let Some(nearest) = strips.iter().map(Strip::nearest).reduce(smaller) else { return };
        let (frame, k) = geometry.frame_of(halfedge);
        if let Some(twin) = frame[k].twin() {
            self.add(twin, strips);
            front.queue.push(twin, nearest);
        } else {
            for (target, is_mirrored) in geometry.across(halfedge) {
                let turned = strips.iter().rev().map(|strip| strip.mirrored(frame[k].length));
                let mut own = if is_mirrored { turned.collect() } else { strips.clone() };
                self.add(target, &mut own);
                front.queue.push(target, nearest);
            }
        }
        strips.clear();
    }

    /// Adds strips to those that wait at a half-edge. What is left of them is of no meaning.
    fn add(&mut self, halfedge: u32, strips: &mut Vec<Strip>) {
        let waiting = self.waiting.at(halfedge);
        if waiting.is_empty() {
            std::mem::swap(waiting, strips);
        } else {
            merge([waiting, strips], &mut self.merged);
            std::mem::swap(waiting, &mut self.merged);
        }
    }
}

impl Segment {
    /// The strip that its left (0) or right side sends by half-edge `k` of its face, as the half-edge across sees it.
    fn strip(&self, frame: &Frame, k: usize, side: u32) -> Option<Strip> {
        let [p, q] = self.ends.map(|weights| frame.place(k, weights));
        let along = length(q[0] - p[0], q[1] - p[1]);
        let [x, y] = [(q[0] - p[0]) / along, (q[1] - p[1]) / along];
        let [x, y] = if side == 0 { [-y, x] } else { [y, -x] };
        let meets = [p, q].map(|[at, up]| at - x * up / y);
        let length = frame[k].length;
        let (begin, end) = (meets[0].min(meets[1]).max(0.0), meets[0].max(meets[1]).min(length));
        let base = (length - p[0]) * x - p[1] * y;
        (y < 0.0).then_some(Strip { begin: length - end, end: length - begin, base, along: -x, up: -y, root: side })
    }

    /// What a place of its face, laid out by the first half-edge, has to the nearest place of the segment, if that is not an end: those are
    /// sources. `left` is the root of the left side.
    fn seen(&self, frame: &Frame, left: u32) -> impl Fn([f64; 2]) -> Option<(f64, Origin)> + use<> {
        let face = self.face;
        let [p, q] = self.ends.map(|weights| frame.place(0, weights));
        let [along, up] = [q[0] - p[0], q[1] - p[1]];
        move |place| {
            let share = share([p, q], place);
            let aside = along * (place[1] - p[1]) - up * (place[0] - p[0]);
            let root = left + u32::from(aside < 0.0);
            let value = aside.abs() / length(along, up);
            (share > 0.0 && share < 1.0).then_some((value, Origin::Straight { face, root }))
        }
    }
}

/// How far along a line from one place to another the place is that is nearest to a third, as a share of the line.
fn share([p, q]: [[f64; 2]; 2], [x, y]: [f64; 2]) -> f64 {
    let [along, up] = [q[0] - p[0], q[1] - p[1]];
    ((x - p[0]) * along + (y - p[1]) * up) / (along * along + up * up)
}
