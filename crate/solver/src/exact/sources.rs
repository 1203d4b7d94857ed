//! Where windows begin: at sources, and at vertices that paths bend at.

use std::f64::consts::PI;
use std::sync::Arc;

use super::geometry::{Bend, ExactGeometry, Frame, Turn, after, before};
use super::origin::Origin;
use super::wavefront::Wavefront;
use super::window::{Window, length};
use heatwalk_surface::{Place, VertexId};

/// The shadow behind a bend is taken wider by this angle, radians: far above rounding, far below what costs time.
const SHADOW_MARGIN: f64 = 1e-9;

impl ExactGeometry {
    /// Whether shortest paths can bend at a vertex.
    pub(super) fn can_bend(&self, vertex: u32) -> bool {
        self.bends[vertex as usize] != Bend::Never
    }
}

impl Wavefront {
    /// Sends windows from all sources.
    pub(super) fn start(&mut self) {
        let geometry = Arc::clone(&self.geometry);
        for number in 0..self.sources.len() {
            let source = self.sources[number];
            let value = source.initial_distance();
            let faces = geometry.faces_at(&self.surface, source.place());
            let root = (self.surface.vertex_count() + number) as u32;
            for &(face, weights) in &faces {
                self.light_from_inside(face, weights, value, root);
            }
        }
    }

    /// Sends windows from a point of a face by all edges that it does not lie on, and straight lines to the corners.
    fn light_from_inside(&mut self, face: u32, weights: [f64; 3], value: f64, root: u32) {
        let geometry = Arc::clone(&self.geometry);
        let frame = &geometry.frames[face as usize];
        for k in 0..3 {
            let [x, depth] = frame.place(k, weights);
            self.offer(frame[k].vertex, value + length(x, depth), Origin::Straight { face, root });
            if depth > 0.0 {
                let all = Window::new(0.0, frame[k].length, [frame[k].length - x, depth], value, root);
                self.leave(face * 3 + k as u32, all);
            }
        }
        self.targets.see_straight(frame, face, weights, value, root);
    }

    /// Sends a window out of a face, cut by the values at the edge's ends.
    fn leave(&mut self, halfedge: u32, mut window: Window) {
        let geometry = Arc::clone(&self.geometry);
        let (frame, k) = geometry.frame_of(halfedge);
        let ends = [frame[after(k)].vertex, frame[k].vertex].map(|vertex| self.values[VertexId(vertex)]);
        if window.clip(frame[k].length, ends) {
            self.deliver(&geometry, halfedge, &[window]);
        }
    }

    /// Sends windows from a vertex that paths can bend at, into the shadow behind it.
    pub(super) fn bend_at(&mut self, vertex: u32) {
        let geometry = Arc::clone(&self.geometry);
        if self.is_source(vertex) {
            return;
        }
        let shadow_end = match geometry.bends[vertex as usize] {
            Bend::Never => return,
            Bend::Saddle(angle) => angle - PI + SHADOW_MARGIN,
            Bend::Reflex => f64::INFINITY,
            Bend::Anywhere => {
                let surface = Arc::clone(&self.surface);
                for (face, k) in surface.corners_of_vertex(VertexId(vertex)) {
                    self.light_from_corner(face.0, k, [0.0, f64::INFINITY]);
                }
                return;
            }
        };
        let Some((face, k, towards)) = self.arrival(vertex) else { return };
        let frame = &geometry.frames[face as usize];
        let start = Turn { face, corner: k, is_reversed: false };
        self.sweep(start, frame.angle(k) - towards, shadow_end);
        if shadow_end == f64::INFINITY {
            self.sweep(Turn { is_reversed: true, ..start }, towards, shadow_end);
        }
    }

    /// Whether a vertex is a source itself, which has sent windows everywhere.
    fn is_source(&self, vertex: u32) -> bool {
        match self.origins[vertex as usize] {
            Origin::Straight { root, .. } => (root as usize)
                .checked_sub(self.values.len())
                .is_some_and(|number| self.values[VertexId(vertex)] <= self.sources[number].initial_distance()),
            _ => false,
        }
    }

    /// The face by which the shortest path reaches a vertex, the corner there, and the angle between the edge that
    /// leaves that corner and the path.
    fn arrival(&self, vertex: u32) -> Option<(u32, usize, f64)> {
        let corner = |face: u32| {
            let frame = &self.geometry.frames[face as usize];
            frame.vertices().iter().position(|&corner| corner == vertex).map(|k| (frame, k))
        };
        match self.origins[vertex as usize] {
            Origin::None => None,
            Origin::Straight { face, root } => {
                let (frame, k) = corner(face)?;
                let weights = self.weights_of_root(root, face)?;
                let [x, y] = frame.place(k, weights);
                Some((face, k, y.atan2(x)))
            }
            Origin::Window { halfedge, at, .. } => {
                let (frame, k) = corner(halfedge / 3)?;
                let [x, y] = frame.opposite(after(k));
                // Seen from the corner, between the edge to the half-edge's begin and the ray.
                let towards = (y * at).atan2(x * (x - at) + y * y);
                Some((halfedge / 3, k, towards))
            }
        }
    }

    /// Barycentric weights in a face of a vertex or source that windows start from.
    pub(super) fn weights_of_root(&self, root: u32, face: u32) -> Option<[f64; 3]> {
        let location = match (root as usize).checked_sub(self.values.len()) {
            Some(number) => self.sources[number].place(),
            None => Place::Vertex(VertexId(root)),
        };
        let faces = self.geometry.faces_at(&self.surface, location);
        faces.into_iter().find(|&(found, _)| found == face).map(|(_, weights)| weights)
    }

    /// Walks around a vertex from a face, at `angle` from the path's direction when it leaves it, and lights the
    /// faces between half a turn and `shadow_end`.
    fn sweep(&mut self, start: Turn, angle: f64, shadow_end: f64) {
        let geometry = Arc::clone(&self.geometry);
        let (mut turn, mut angle) = (start, angle);
        let shadow_begin = PI - SHADOW_MARGIN;
        while angle < shadow_end {
            match geometry.turn(turn) {
                Some(next) if next.face != start.face => turn = next,
                _ => break,
            }
            let width = geometry.frames[turn.face as usize].angle(turn.corner);
            let [begin, end] = [shadow_begin - angle, shadow_end - angle];
            angle += width;
            if begin < width {
                // Along the edge that is met first, angles grow from the corner's leaving edge, unless reversed.
                let range = if turn.is_reversed { [width - end, width - begin] } else { [begin, end] };
                self.light_from_corner(turn.face, turn.corner, range);
            }
        }
    }

    /// Sends a window from a corner of a face by the opposite edge, between two angles from the corner's leaving
    /// edge, and straight lines along its edges.
    fn light_from_corner(&mut self, face: u32, k: usize, [from, to]: [f64; 2]) {
        let geometry = Arc::clone(&self.geometry);
        let frame: &Frame = &geometry.frames[face as usize];
        let root = frame[k].vertex;
        let value = self.values[VertexId(root)];
        let (out, last) = (after(k), before(k));
        self.offer(frame[out].vertex, value + frame[k].length, Origin::Straight { face, root });
        self.offer(frame[last].vertex, value + frame[last].length, Origin::Straight { face, root });
        let mut weights = [0.0; 3];
        weights[k] = 1.0;
        self.targets.see_straight(frame, face, weights, value, root);

        let along = frame[out].length;
        // By the law of sines, measured from the edge's end, as the half-edge across runs.
        let meets = |angle: f64| {
            along - frame[k].length * angle.sin() / (frame[out].cos * angle.sin() + frame[out].sin * angle.cos())
        };
        let width = frame.angle(k);
        let begin = if to >= width { 0.0 } else { meets(to).max(0.0) };
        let end = if from <= 0.0 { along } else { meets(from).min(along) };
        let place = [frame[last].length * frame[last].cos, frame[k].length * frame[out].sin];
        let window = Window::new(begin, end, place, value, root);
        self.leave(face * 3 + out as u32, window);
    }
}
