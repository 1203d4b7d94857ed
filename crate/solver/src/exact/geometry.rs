//! What the wavefront needs of a surface: triangles laid in the plane, what lies across each edge, pseudo-sources.

use std::f64::consts::{PI, TAU};

use super::window::GRAZE;
use crate::halfedge::Face;
use crate::sources::SurfacePoint;
use crate::surface::Surface;
use crate::triangle;

/// How shortest paths can bend at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Bend {
    /// Not at all: the angles around it sum to less than a turn (on the boundary, half a turn).
    Never,
    /// Inside the surface, with this angle sum, radians.
    Saddle(f64),
    /// On the boundary, one fan of faces.
    Reflex,
    /// Edges of three faces, or several fans: any direction may follow any other.
    Anywhere,
}

/// A triangle in the plane. Slot `k` is its edge from corner `k` to the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// Length of each slot.
    pub length: [f64; 3],
    /// Cosine of the angle at each corner.
    pub cos: [f64; 3],
    /// Sine of the angle at each corner.
    pub sin: [f64; 3],
    /// Points at the corners.
    pub points: [u32; 3],
    /// The next slot around each edge, as `4 slot`, + 1 where that slot runs from the lower point to the higher, + 2
    /// where the edge has no other slot. The slots of an edge form a cycle; a boundary slot is its own successor.
    pub beside: [u32; 3],
}

/// The corner after corner `k`.
pub(super) fn after(k: usize) -> usize {
    if k == 2 { 0 } else { k + 1 }
}

impl Frame {
    /// Corner opposite slot `k`, where that slot lies on the x axis from the origin and the triangle above it.
    pub fn opposite(&self, k: usize) -> [f64; 2] {
        let length = self.length[after(after(k))];
        [length * self.cos[k], length * self.sin[k]]
    }

    /// A point by its barycentric weights, laid out as in [`Frame::opposite`].
    pub fn place(&self, k: usize, weights: [f64; 3]) -> [f64; 2] {
        let [x, y] = self.opposite(k);
        let (along, up) = (weights[after(k)], weights[after(after(k))]);
        [along * self.length[k] + up * x, up * y]
    }

    /// Whether slot `k` runs from the lower point to the higher.
    pub fn ascends(&self, k: usize) -> bool {
        self.points[k] < self.points[after(k)]
    }

    /// Angle at corner `k`, radians.
    pub fn angle(&self, k: usize) -> f64 {
        self.sin[k].atan2(self.cos[k])
    }
}

/// What a [`Wavefront`](super::Wavefront) needs of a surface, made once and shared by all wavefronts on it.
#[derive(Debug, Clone)]
pub struct ExactGeometry {
    /// `#F`.
    pub(super) frames: Vec<Frame>,
    /// `#P`.
    pub(super) bends: Vec<Bend>,
}

impl ExactGeometry {
    /// Lays out the triangles and finds the pseudo-sources of a surface.
    pub fn new(surface: &Surface) -> Self {
        let faces = surface.faces.as_slice();
        let frame = |face: usize| {
            let corners = surface.corners(Face(face as u32));
            let edges: [_; 3] = std::array::from_fn(|k| corners[after(k)] - corners[k]);
            let units = edges.map(triangle::unit);
            let before = |k: usize| after(after(k));
            Frame {
                length: edges.map(triangle::length),
                cos: std::array::from_fn(|k| -units[k].dot(units[before(k)])),
                sin: std::array::from_fn(|k| triangle::length(units[k].cross(units[before(k)]))),
                points: faces[face],
                beside: [0; 3],
            }
        };
        let mut geometry =
            Self { frames: (0..faces.len()).map(frame).collect(), bends: vec![Bend::Never; surface.point_count()] };
        let is_branching = geometry.link(surface);
        for point in 0..surface.point_count() as u32 {
            geometry.bends[point as usize] =
                if is_branching[point as usize] { Bend::Anywhere } else { geometry.bend(surface, point) };
        }
        geometry
    }

    /// Links the slots of each edge in a cycle; returns which points have an edge of three faces or more.
    fn link(&mut self, surface: &Surface) -> Vec<bool> {
        let mut is_branching = vec![false; surface.point_count()];
        // Slots between the point and higher ones, as (other point, slot) in one sortable word.
        let mut around: Vec<u64> = Vec::new();
        for point in 0..surface.point_count() as u32 {
            around.clear();
            for (face, k) in surface.corners_of_point(point) {
                let corners = self.frames[face.0 as usize].points;
                let before = after(after(k));
                for (other, slot) in [(corners[after(k)], k), (corners[before], before)] {
                    if other > point {
                        around.push(u64::from(other) << 32 | u64::from(face.0 * 3 + slot as u32));
                    }
                }
            }
            around.sort_unstable();
            for edge in around.chunk_by(|a, b| a >> 32 == b >> 32) {
                for (index, &entry) in edge.iter().enumerate() {
                    let next = edge[(index + 1) % edge.len()] as u32;
                    let ascends = self.frames[next as usize / 3].ascends(next as usize % 3);
                    let slot = entry as u32 as usize;
                    self.frames[slot / 3].beside[slot % 3] =
                        4 * next + 2 * u32::from(edge.len() <= 2) + u32::from(ascends);
                }
                if edge.len() > 2 {
                    is_branching[point as usize] = true;
                    is_branching[(edge[0] >> 32) as usize] = true;
                }
            }
        }
        is_branching
    }

    /// How paths bend at a point whose edges have at most two faces.
    fn bend(&self, surface: &Surface, point: u32) -> Bend {
        let angles = surface.corners_of_point(point).map(|(face, k)| self.frames[face.0 as usize].angle(k));
        let (faces, angle) = angles.fold((0, 0.0), |(count, sum), angle| (count + 1, sum + angle));
        let Some((face, k)) = surface.corners_of_point(point).next() else { return Bend::Never };
        let start = Turn { face: face.0, corner: k, is_reversed: false };
        let mut fan = 1;
        let mut turn = start;
        let is_open = loop {
            match self.turn(turn) {
                None => break true,
                Some(next) if next.face == start.face => break false,
                Some(next) => turn = next,
            }
            fan += 1;
        };
        if is_open {
            let mut turn = Turn { is_reversed: true, ..start };
            while let Some(next) = self.turn(turn) {
                turn = next;
                fan += 1;
            }
        }
        match (fan == faces, is_open) {
            (false, _) => Bend::Anywhere,
            (true, false) if angle > TAU + GRAZE => Bend::Saddle(angle),
            (true, true) if angle > PI + GRAZE => Bend::Reflex,
            (true, _) => Bend::Never,
        }
    }

    /// The next face around a point; `None` past the boundary. Only where edges have at most two faces.
    pub(super) fn turn(&self, turn: Turn) -> Option<Turn> {
        let frame = &self.frames[turn.face as usize];
        let k = if turn.is_reversed { turn.corner } else { after(after(turn.corner)) };
        let next = frame.beside[k] >> 2;
        if next == turn.face * 3 + k as u32 {
            return None;
        }
        let (face, k) = (next / 3, next as usize % 3);
        let point = frame.points[turn.corner];
        // Counter-clockwise, one enters a face by the slot that leaves the point.
        let leaves = self.frames[face as usize].points[k] == point;
        Some(Turn { face, corner: if leaves { k } else { after(k) }, is_reversed: !leaves })
    }

    /// Slot number `slot`'s frame and its place there.
    pub(super) fn frame_of_slot(&self, slot: u32) -> (&Frame, usize) {
        (&self.frames[slot as usize / 3], slot as usize % 3)
    }

    /// The slots on the other faces of a slot's edge, each with whether it runs in the same direction.
    pub(super) fn across(&self, slot: u32) -> impl Iterator<Item = (u32, bool)> + '_ {
        let (frame, k) = self.frame_of_slot(slot);
        let ascends = frame.ascends(k);
        let other = move |packed: u32| Some(packed).filter(|&packed| packed >> 2 != slot);
        std::iter::successors(other(frame.beside[k]), move |&packed| {
            // Most edges are done now, without a look at the face across.
            if packed & 2 != 0 {
                return None;
            }
            let (frame, k) = self.frame_of_slot(packed >> 2);
            other(frame.beside[k])
        })
        .map(move |packed| (packed >> 2, (packed & 1 == 1) == ascends))
    }

    /// The faces that a surface point lies on, with its weights in each.
    pub(super) fn faces_at(&self, surface: &Surface, location: SurfacePoint) -> Vec<(u32, [f64; 3])> {
        let support: Vec<(u32, f64)> = location.support(surface).filter(|&(_, weight)| weight > ON_EDGE).collect();
        let &[(first, _), ref rest @ ..] = support.as_slice() else { return Vec::new() };
        surface
            .corners_of_point(first)
            .map(|(face, _)| face.0)
            .filter(|&face| rest.iter().all(|(point, _)| self.frames[face as usize].points.contains(point)))
            .filter(|&face| {
                support.len() < 3 || !matches!(location, SurfacePoint::Face { face: own, .. } if own.0 != face)
            })
            .map(|face| {
                let weight = |corner: u32| support.iter().find(|(point, _)| *point == corner).map_or(0.0, |s| s.1);
                (face, self.frames[face as usize].points.map(weight))
            })
            .collect()
    }
}

/// A surface point whose barycentric weight is at most this lies on the edge, or at the corner, opposite: it moves by
/// this share of an edge, far below the error allowed, and a face alone would not light what is behind the edge.
const ON_EDGE: f64 = 1e-13;

/// A face around a point, on a walk around it: counter-clockwise as the face sees it, or reversed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn {
    pub face: u32,
    pub corner: usize,
    pub is_reversed: bool,
}
