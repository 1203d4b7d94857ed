//! Where windows begin: at sources, and at vertices that paths bend at.

use std::sync::Arc;

use heatwalk_base::sort;
use heatwalk_surface::VertexId;

use super::geometry::{Bend, ExactGeometry, Frame, Side, Turn, after, before};
use super::origin::Origin;
use super::portals::Portals;
use super::roots::Root;
use super::wavefront::Wavefront;
use super::window::{Beam, length};
use crate::extremum::{larger, smaller};
use crate::room;

#[cfg(test)]
mod tests;

/// The shadow behind a bend is taken wider by this angle, radians: far above rounding, far below what costs time.
const SHADOW_MARGIN: f64 = 1e-9;

/// And at least by the angle under which so many grains are seen from where the path to the vertex bent last.
const SHADOW_GRAINS: f64 = 100.0;

/// A corner that is no farther than so many times what rounding does from the opposite edge lights all of it: there, places on
/// the edge do not tell directions.
const NARROW: f64 = 1e5;

/// A point of a face that windows begin at.
#[derive(Debug, Clone, Copy)]
struct Light {
    face: u32,
    weights: [f64; 3],
    /// The distance there.
    value: f64,
    root: u32,
}

/// A border of the shadow behind a vertex.
#[derive(Debug, Clone, Copy)]
struct Border {
    /// The face that it lies in.
    turn: Turn,
    /// Its direction, of any length, from the edge that leaves the face's corner.
    direction: [f64; 2],
}

/// A direction at a corner, from the leaving edge, seen from the other edge against the sense of rotation; and back.
fn reflected(side: &Side, [x, y]: [f64; 2]) -> [f64; 2] {
    [side.cos * x + side.sin * y, side.sin * x - side.cos * y]
}

impl ExactGeometry {
    /// Walks around a vertex to half a turn, less a margin in radians, from a direction in the first face, seen from the edge that is
    /// met first there.
    fn half_turn(&self, start: Turn, [x, y]: [f64; 2], margin: f64) -> Option<Border> {
        let side_of = |turn: Turn| &self.frames[turn.face as usize][turn.corner];
        let (mut turn, mut side) = (start, side_of(start));
        // Less than half a turn from the edge met first, and a face's angle is less, so that one sign tells.
        let mut direction = [-x - margin * y, margin * x - y];
        loop {
            let [x, y] = direction;
            // Past a corner of nearly half a turn the border may come to lie before the next face by its margin.
            direction = [x * side.cos + y * side.sin, larger(y * side.cos - x * side.sin, 0.0)];
            turn = self.turn(turn).filter(|next| next.face != start.face)?;
            side = side_of(turn);
            let [x, y] = direction;
            if x * side.sin - y * side.cos > 0.0 {
                return Some(Border {
                    turn,
                    direction: if turn.is_reversed { reflected(side, direction) } else { direction },
                });
            }
        }
    }

    /// Whether shortest paths can bend at a vertex.
    pub(super) fn can_bend(&self, vertex: u32) -> bool {
        self.bends[vertex as usize] != Bend::Never
    }
}

impl Wavefront {
    /// Sends windows from all sources.
    pub(super) fn start(&mut self) {
        let geometry = Arc::clone(&self.geometry);
        let mut lights = Vec::new();
        for (number, source) in self.sources.iter().enumerate() {
            let root = (self.surface.vertex_count() + number) as u32;
            for (face, weights) in geometry.faces_at(&self.surface, source.place()) {
                let light = Light { face, weights, value: source.initial_distance(), root };
                self.is_refused |= !room::push(&mut lights, light);
            }
        }
        self.light_faces(lights);
        self.deliver_gathered(&geometry);
    }

    /// Lights faces from points of them, each face from all of its points together: of many sources in one place, windows of one after
    /// another would be divided among all before.
    fn light_faces(&mut self, mut lights: Vec<Light>) {
        sort::sort_by_key(&mut lights, |light| light.face);
        for of_face in lights.chunk_by(|a, b| a.face == b.face) {
            self.light_from_inside(of_face[0].face, of_face);
        }
    }

    /// Sends windows from points of a face by all edges that they do not lie on, and straight lines to the corners.
    fn light_from_inside(&mut self, face: u32, lights: &[Light]) {
        let geometry = Arc::clone(&self.geometry);
        let frame = &geometry.frames[face as usize];
        for k in 0..3 {
            let mut windows = Vec::new();
            for &Light { weights, value, root, .. } in lights {
                let [x, depth] = frame.place(k, weights);
                self.offer(frame[k].vertex, value + length(x, depth), Origin::Straight { face, root });
                if depth > 0.0 {
                    let (x, offset) = (frame[k].length - x, value);
                    let all = Beam { begin: 0.0, end: frame[k].length, x, depth, offset, root };
                    self.is_refused |= !room::push(&mut windows, all);
                }
            }
            if !windows.is_empty() {
                self.leave(face * 3 + k as u32, windows);
            }
        }
        for light in lights {
            self.see_straight(frame, face, light.weights, (light.value, light.root));
        }
    }

    /// Offers the targets and the ends of portals in a face straight lines from a root there.
    pub(super) fn see_straight(&mut self, frame: &Frame, face: u32, weights: [f64; 3], root: (f64, u32)) {
        self.targets.see_straight(frame, (face, weights), root, |_, _| ());
        let (queue, first) = (&mut self.queue, (self.waiting.len() + self.values.len()) as u32);
        self.ends.see_straight(frame, (face, weights), root, |end, value| queue.push(first + end, value));
    }

    /// Lets what has reached an end of a portal start anew at the other one, unless that is nearer by itself.
    pub(super) fn emerge(&mut self, geometry: &ExactGeometry, end: u32) {
        let portals = geometry.portals();
        let other = Portals::across(end);
        let value = self.ends.values[end as usize] + portals.gap(end);
        if value >= self.ends.values[other as usize] {
            return;
        }
        self.ends.values[other as usize] = value;
        self.ends.origins[other as usize] = Origin::Portal;
        let root = self.root_of_end(other);
        let faces = geometry.faces_at(&self.surface, portals.places()[other as usize]);
        self.light_faces(faces.into_iter().map(|(face, weights)| Light { face, weights, value, root }).collect());
    }

    /// Sends windows out of a face, cut by the values at the edge's ends.
    fn leave(&mut self, halfedge: u32, windows: impl IntoIterator<Item = Beam>) {
        let geometry = Arc::clone(&self.geometry);
        let (frame, k) = geometry.frame_of(halfedge);
        let ends = [frame[after(k)].vertex, frame[k].vertex].map(|vertex| self.limit(vertex));
        let mut leaving = Vec::new();
        for mut window in windows {
            if window.is_wide() && window.clip(frame[k].length, ends) {
                self.is_refused |= !room::push(&mut leaving, window);
            }
        }
        self.deliver(&geometry, halfedge, &mut leaving);
    }

    /// Sends windows from a vertex that paths can bend at, into the shadow behind it.
    pub(super) fn bend_at(&mut self, vertex: u32) {
        if self.is_source(vertex) {
            return;
        }
        let geometry = Arc::clone(&self.geometry);
        let borders = |wavefront: &Self| {
            let (start, towards) = wavefront.arrival(vertex)?;
            let margin = larger(SHADOW_MARGIN, SHADOW_GRAINS * geometry.grain / wavefront.last_leg(vertex));
            let back = Turn { is_reversed: true, ..start };
            let side = &geometry.frames[start.face as usize][start.corner];
            Some([
                geometry.half_turn(start, towards, margin),
                geometry.half_turn(back, reflected(side, towards), margin),
            ])
        };
        match geometry.bends[vertex as usize] {
            Bend::Never => {}
            _ if self.comes_from_nowhere(vertex) => self.light_all_around(vertex),
            Bend::Saddle => {
                if let Some([Some(begin), Some(end)]) = borders(self) {
                    self.light(&geometry, begin, Some(end));
                }
            }
            Bend::Reflex => {
                let borders = borders(self).into_iter().flatten().flatten();
                borders.for_each(|border| self.light(&geometry, border, None));
            }
            Bend::Anywhere => self.light_all_around(vertex),
        }
    }

    /// Whether rounding leaves nothing of the direction that the shortest path to a vertex comes from: it is too short from where it
    /// bent last, or goes through the opposite edge of a face that is too narrow.
    fn comes_from_nowhere(&self, vertex: u32) -> bool {
        let narrow = NARROW * self.geometry.grain;
        let is_through_narrow_face = || match self.origins[vertex as usize] {
            Origin::Window { halfedge, .. } => {
                let (frame, k) = self.geometry.frame_of(halfedge);
                frame.opposite(k)[1] <= narrow
            }
            _ => false,
        };
        self.last_leg(vertex) <= narrow || is_through_narrow_face()
    }

    /// How far a vertex is from where the shortest path to it bent last.
    fn last_leg(&self, vertex: u32) -> f64 {
        match self.origins[vertex as usize] {
            Origin::Straight { root, .. } | Origin::Window { root, .. } => {
                self.values[VertexId(vertex)] - self.value_of_root(root)
            }
            Origin::None | Origin::Portal => f64::INFINITY,
        }
    }

    /// Sends windows from a vertex into all faces around it.
    pub(super) fn light_all_around(&mut self, vertex: u32) {
        let surface = Arc::clone(&self.surface);
        for (face, k) in surface.corners_of_vertex(VertexId(vertex)) {
            self.light_from_corner(face.0, k, [None, None]);
        }
    }

    /// Whether a vertex is a source itself, or the end of a portal, which have sent windows everywhere.
    fn is_source(&self, vertex: u32) -> bool {
        match self.origins[vertex as usize] {
            Origin::Straight { root, .. } if !matches!(self.root(root), Root::Vertex(_)) => {
                self.values[VertexId(vertex)] <= self.value_of_root(root)
            }
            _ => false,
        }
    }

    /// The face by which the shortest path reaches a vertex, as the start of a walk around it, and the direction that the
    /// path comes from, of any length, from the edge that leaves the corner there.
    fn arrival(&self, vertex: u32) -> Option<(Turn, [f64; 2])> {
        let at_corner = |face: u32| {
            let frame = &self.geometry.frames[face as usize];
            Some((frame, Turn { face, corner: frame.corner(vertex)?, is_reversed: false }))
        };
        match self.origins[vertex as usize] {
            Origin::None | Origin::Portal => None,
            Origin::Straight { face, root } => {
                let (frame, start) = at_corner(face)?;
                let weights = self.weights_of_goal(self.goal(root), 3 * face + start.corner as u32, [0.0; 2])?;
                Some((start, frame.place(start.corner, weights)))
            }
            Origin::Window { halfedge, at, .. } => {
                let (frame, start) = at_corner(halfedge / 3)?;
                let [x, y] = frame.opposite(after(start.corner));
                Some((start, [x * (x - at) + y * y, y * at]))
            }
        }
    }

    /// Lights the faces around a vertex from one border of its shadow to the other, or to the boundary.
    fn light(&mut self, geometry: &ExactGeometry, begin: Border, end: Option<Border>) {
        let (mut turn, mut first) = (begin.turn, Some(begin.direction));
        loop {
            let last = end.filter(|end| end.turn.face == turn.face).map(|end| end.direction);
            let range = if turn.is_reversed { [last, first] } else { [first, last] };
            self.light_from_corner(turn.face, turn.corner, range);
            first = None;
            match geometry.turn(turn) {
                Some(next) if last.is_none() && next.face != begin.turn.face => turn = next,
                _ => return,
            }
        }
    }

    /// Sends a window from a corner of a face by the opposite edge, between two directions from the corner's leaving edge
    /// (without them, between both edges there), and straight lines along its edges.
    fn light_from_corner(&mut self, face: u32, k: usize, [from, to]: [Option<[f64; 2]>; 2]) {
        let geometry = Arc::clone(&self.geometry);
        let frame: &Frame = &geometry.frames[face as usize];
        let root = frame[k].vertex;
        let value = self.values[VertexId(root)];
        let (out, last) = (after(k), before(k));
        self.offer(frame[out].vertex, value + frame[k].length, Origin::Straight { face, root });
        self.offer(frame[last].vertex, value + frame[last].length, Origin::Straight { face, root });
        let mut weights = [0.0; 3];
        weights[k] = 1.0;
        self.see_straight(frame, face, weights, (value, root));

        let along = frame[out].length;
        // By the law of sines, measured from the edge's end, as the half-edge across runs.
        let meets =
            |[cos, sin]: [f64; 2]| along - frame[k].length * (sin / (frame[out].cos * sin + frame[out].sin * cos));
        let (x, depth) = (frame[last].length * frame[last].cos, frame[k].length * frame[out].sin);
        let has_borders = depth > NARROW * geometry.grain;
        let begin = to.filter(|_| has_borders).map_or(0.0, |to| larger(meets(to), 0.0));
        let end = from.filter(|_| has_borders).map_or(along, |from| smaller(meets(from), along));
        self.leave(face * 3 + out as u32, [Beam { begin, end, x, depth, offset: value, root }]);
    }
}
