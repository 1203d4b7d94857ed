//! What the wavefront needs of a surface: triangles laid in the plane, what lies across each edge, pseudo-sources.

use std::f64::consts::PI;
use std::num::NonZeroUsize;
use std::ops::Index;
use std::sync::Arc;

use bytemuck::Zeroable;
use heatwalk_base::parallel;
use heatwalk_surface::scale::scale;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Bridges, CutVertex, Element, FaceId, Place, VertexId, triangle};

use super::portals::Portals;
use super::window::TURN;
use crate::cost::Costs;
use crate::extremum::{larger, smaller};

#[cfg(test)]
mod tests;

/// How shortest paths can bend at a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Zeroable)]
#[repr(u8)]
pub(super) enum Bend {
    /// Not at all: the angles around it sum to less than a turn (on the boundary, half a turn).
    Never = 0,
    /// Inside the surface.
    Saddle,
    /// On the boundary, one fan of faces.
    Reflex,
    /// Edges of three faces, or several fans: any direction may follow any other.
    Anywhere,
}

/// One corner of a triangle in the plane and the half-edge that runs from there to the next: half a cache line.
#[derive(Debug, Clone, Copy, Zeroable)]
#[repr(align(32))]
pub(crate) struct Side {
    /// Length of the half-edge.
    pub length: f64,
    /// Cosine and sine of the angle at the corner.
    pub cos: f64,
    pub sin: f64,
    /// Point at the corner.
    pub vertex: u32,
    /// The next half-edge `h` on the edge, as `4 h`, + 1 where it runs against this one, + 2 where at most two half-edges
    /// share the edge. Those of an edge form a cycle; a boundary half-edge is its own successor.
    pub next_on_edge: u32,
}

impl Side {
    /// The half-edge that runs against this one, where it alone shares the edge.
    pub fn twin(&self) -> Option<u32> {
        (self.next_on_edge & 3 == 3).then_some(self.next_on_edge >> 2)
    }
}

/// A triangle in the plane. Its half-edge `k` runs from corner `k` to the next.
#[derive(Debug, Clone, Copy, Zeroable)]
pub(crate) struct Frame([Side; 3]);

impl Index<usize> for Frame {
    type Output = Side;

    fn index(&self, k: usize) -> &Side {
        &self.0[k]
    }
}

/// The corner after corner `k`.
pub(crate) fn after(k: usize) -> usize {
    // Without a branch: which corner comes is as good as random.
    (0b00_10_01 >> (2 * k)) & 0b11
}

/// The corner before corner `k`.
pub(crate) fn before(k: usize) -> usize {
    after(after(k))
}

impl Frame {
    fn new(surface: &Surface, face: FaceId) -> Self {
        let corners = surface.corners(face);
        let edges: [_; 3] = std::array::from_fn(|k| corners[after(k)] - corners[k]);
        let length = edges.map(triangle::length);
        let (edges, lengths) = if length.iter().all(|length| PLAIN_LENGTHS.contains(length)) {
            (edges, length)
        } else {
            let scale = scale(length.into_iter().fold(0.0, larger));
            (edges.map(|edge| edge * scale), length.map(|length| length * scale))
        };
        // Across the longest edge lies the angle whose edges give the area of a thin triangle to full precision.
        let longest =
            if lengths[0] >= lengths[1].max(lengths[2]) { 0 } else { 1 + usize::from(lengths[2] > lengths[1]) };
        let area = larger(
            edges[after(longest)].cross(edges[before(longest)]).length(),
            FLAT * lengths[longest] * lengths[longest],
        );
        let inverse = lengths.map(f64::recip);
        let inverses: [f64; 3] = std::array::from_fn(|k| inverse[k] * inverse[before(k)]);
        let cos: [f64; 3] = std::array::from_fn(|k| -edges[k].dot(edges[before(k)]) * inverses[k]);
        let sin = inverses.map(|inverse| area * inverse);
        let vertices = surface.faces()[face].map(|vertex| vertex.0);
        let next_on_edge = |k| {
            let halfedge = face.halfedge(k);
            let next = surface.edges().next_on_edge(halfedge);
            let ends = surface.faces()[next.triangle()];
            let is_against = (ends[next.corner()] < ends[after(next.corner())]) != (vertices[k] < vertices[after(k)]);
            4 * next.0 + 2 * u32::from(!surface.edges().is_branching(halfedge)) + u32::from(is_against)
        };
        Self(std::array::from_fn(|k| Side {
            length: length[k],
            cos: cos[k],
            sin: sin[k],
            vertex: vertices[k],
            next_on_edge: next_on_edge(k),
        }))
    }

    /// Points at the corners.
    pub fn vertices(&self) -> [u32; 3] {
        self.0.map(|side| side.vertex)
    }

    /// The height on the longest side.
    fn height(&self) -> f64 {
        self.0.iter().map(|side| side.length * side.sin).fold(f64::INFINITY, smaller)
    }

    /// The corner at a point, if there is one.
    pub fn corner(&self, vertex: u32) -> Option<usize> {
        self.0.iter().position(|side| side.vertex == vertex)
    }

    /// The sides as half-edge `k` sees them: itself, the next and the one before.
    pub fn seen_from(&self, k: usize) -> [&Side; 3] {
        [&self.0[k], &self.0[after(k)], &self.0[before(k)]]
    }

    /// Corner opposite half-edge `k`, where that half-edge lies on the x axis from the origin and the triangle above it.
    pub fn opposite(&self, k: usize) -> [f64; 2] {
        let [base, _, left] = self.seen_from(k);
        [left.length * base.cos, left.length * base.sin]
    }

    /// A vertex by its barycentric weights, laid out as in [`Frame::opposite`].
    pub fn place(&self, k: usize, weights: [f64; 3]) -> [f64; 2] {
        let [x, y] = self.opposite(k);
        let (along, up) = (weights[after(k)], weights[before(k)]);
        [along * self[k].length + up * x, up * y]
    }
}

/// Lengths whose fourth powers, as in the square of an area, neither under- nor overflow, however thin the triangle.
const PLAIN_LENGTHS: std::ops::Range<f64> = 1e-60..1e60;

/// Triangles are taken for no flatter than that, height by longest edge, less than rounding moves a corner: a ray has one way
/// through any triangle then.
const FLAT: f64 = 1e-17;

/// A sum of angles between 0 and π, kept as a direction and the half turns passed on the way, so that adding one needs
/// no inverse tangent.
#[derive(Debug, Clone, Copy)]
struct AngleSum {
    cos: f64,
    sin: f64,
    half_turns: u32,
}

impl Default for AngleSum {
    fn default() -> Self {
        Self { cos: 1.0, sin: 0.0, half_turns: 0 }
    }
}

impl AngleSum {
    fn add(&mut self, cos: f64, sin: f64) {
        // Odd half turns are where the sine is negative.
        [self.cos, self.sin] = [self.cos * cos - self.sin * sin, self.cos * sin + self.sin * cos];
        self.half_turns += u32::from((self.sin < 0.0) != (self.half_turns % 2 == 1));
    }

    fn radians(&self) -> f64 {
        let cos = if self.half_turns.is_multiple_of(2) { self.cos } else { -self.cos };
        f64::from(self.half_turns) * PI + self.sin.abs().atan2(cos)
    }

    /// Whether the sum is more than so many half turns, by more than `TURN`.
    fn exceeds(&self, half_turns: u32) -> bool {
        self.half_turns >= half_turns && self.radians() > f64::from(half_turns) * PI + TURN
    }
}

/// Places on an edge are measured from one of its ends, so that each face that is crossed may move a place by some roundings
/// of its longest edge, however near the source is. As a share of that, after some dozens of faces.
const GRAIN: f64 = 1e-14;

/// A triangle with an angle whose sine is less is thin, and so is a surface on which as large a share of them is.
const THIN_SINE: f64 = 0.1;
const THIN_SHARE: f64 = 0.1;

/// Triangles so many times as long as high, in the mean of lengths and heights, are slivers.
const SLIVER: f64 = 64.0;

/// Radians of an angle defect beyond which it makes no difference how sharp a vertex is: shortest paths pass it by.
const SHARPEST: f64 = 0.5;

/// What a [`Wavefront`](super::Wavefront) needs of a surface, made once and shared by all wavefronts on it.
#[derive(Debug, Clone)]
pub struct ExactGeometry {
    pub(super) surface: Arc<Surface>,
    /// Threads that made it. As many are the first to touch the memory of searches on it.
    pub(crate) threads: NonZeroUsize,
    /// `#F`.
    pub(super) frames: Vec<Frame>,
    /// `#V`.
    pub(super) bends: Vec<Bend>,
    portals: Portals,
    /// Mean length of the edges, times its cost.
    mean_edge: f64,
    /// What rounding may do to a place that is unfolded along the longest edge.
    pub(super) grain: f64,
    /// Whether many triangles are thin.
    is_thin: bool,
    /// Whether most of the surface is slivers.
    is_of_slivers: bool,
    /// Where they are not the same everywhere.
    costs: Option<Costs>,
}

impl ExactGeometry {
    /// Lays out the triangles and finds the pseudo-sources of a surface, on the caller's thread alone.
    pub fn new(surface: impl Into<Arc<Surface>>) -> Self {
        Self::on_threads(surface, parallel::ONE)
    }

    /// The same on so many threads. It makes no difference how many.
    ///
    /// # Panics
    /// Where there are no threads, as on wasm32, and more than one is asked for.
    pub fn on_threads(surface: impl Into<Arc<Surface>>, threads: NonZeroUsize) -> Self {
        let surface = surface.into();
        let mesh = surface.mesh();
        let frame = |face| Frame::new(&surface, FaceId::from_index(face));
        let frames = parallel::collect(surface.face_count(), threads, frame);
        let mut is_cut = vec![false; surface.vertex_count()];
        for copy in mesh.vertices().skip(surface.vertex_count()) {
            is_cut[surface.vertex_of_cut(copy).index()] = true;
        }
        let heights: f64 = frames.iter().map(Frame::height).sum();
        let thin = frames.iter().filter(|frame| frame.0.iter().any(|side| side.sin < THIN_SINE)).count();
        let mut geometry = Self {
            mean_edge: surface.mean_edge(),
            surface: Arc::clone(&surface),
            threads,
            grain: GRAIN * frames.iter().flat_map(|frame| frame.0.iter()).map(|side| side.length).fold(0.0, larger),
            is_thin: thin as f64 > THIN_SHARE * frames.len() as f64,
            is_of_slivers: SLIVER * heights < surface.mean_edge() * frames.len() as f64,
            frames,
            bends: Vec::new(),
            portals: Portals::default(),
            costs: None,
        };
        let bend = |number| {
            let vertex = VertexId::from_index(number);
            let angle = geometry.angle_around(vertex);
            if is_cut[number] || mesh.is_boundary_vertex(CutVertex::from_index(number)) {
                geometry.bend(&surface, vertex, &angle)
            } else if angle.exceeds(2) {
                Bend::Saddle
            } else {
                Bend::Never
            }
        };
        geometry.bends = parallel::collect(surface.vertex_count(), threads, bend);
        geometry
    }

    /// The same with paths that cross these bridges between components.
    #[must_use]
    pub fn bridged(mut self, bridges: &Bridges) -> Self {
        self.portals = Portals::new(bridges, |place| self.faces_at(&self.surface, place));
        self
    }

    /// The same where faces have costs, of a geometry without any. One cost everywhere makes all lengths as many times as
    /// large; with different ones, only [propagation](crate::propagation) finds distances.
    ///
    /// # Panics
    /// Where there is not one cost a face.
    #[must_use]
    pub fn weighted(mut self, costs: &Costs) -> Self {
        assert_eq!(costs.of_faces().len(), self.frames.len(), "one cost a face");
        self.mean_edge *= costs.mean();
        let Some(cost) = costs.constant() else { return Self { costs: Some(costs.clone()), ..self } };
        for side in self.frames.iter_mut().flat_map(|frame| &mut frame.0) {
            side.length *= cost;
        }
        Self { portals: self.portals.scaled(cost), grain: self.grain * cost, ..self }
    }

    /// Mean length of the edges, times the mean cost.
    pub(crate) fn mean_edge(&self) -> f64 {
        self.mean_edge
    }

    /// Whether a tenth of the triangles is thin, as on fillets of CAD models: one window of a half-edge tells little of its ends there.
    pub(crate) fn is_thin(&self) -> bool {
        self.is_thin
    }

    /// Whether triangles are so thin that an edge is as long as a row of many.
    pub(crate) fn is_of_slivers(&self) -> bool {
        self.is_of_slivers
    }

    /// What a unit of length costs, where that is not the same everywhere.
    pub fn costs(&self) -> Option<&Costs> {
        self.costs.as_ref()
    }

    /// The portals that paths cross.
    pub(crate) fn portals(&self) -> &Portals {
        &self.portals
    }

    /// The surface that it was made of.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    fn angle_around(&self, vertex: VertexId) -> AngleSum {
        let mut angle = AngleSum::default();
        for (face, k) in self.surface.corners_of_vertex(vertex) {
            let side = &self.frame(face.0)[k];
            angle.add(side.cos, side.sin);
        }
        angle
    }

    /// Root-mean-square of the angle defects, in radians, none counting for more than [`SHARPEST`]. Vertices count for these areas
    /// (`#V`), and those on boundaries and junctions not at all.
    pub(crate) fn bumpiness(&self, areas: &[f64]) -> f64 {
        // Face by face, in the order in which they lie in memory.
        let mut angles = vec![AngleSum::default(); self.surface.vertex_count()];
        for (corners, frame) in self.surface.faces().iter().zip(&self.frames) {
            for (vertex, side) in corners.iter().zip(&frame.0) {
                angles[vertex.index()].add(side.cos, side.sin);
            }
        }
        let (mut whole, mut sum) = (0.0, 0.0);
        for ((vertex, &area), angle) in self.surface.vertices().zip(areas).zip(&angles) {
            let is_inside = matches!(self.bends[vertex.index()], Bend::Never | Bend::Saddle);
            if is_inside && !self.surface.boundary_vertices()[vertex] {
                whole += area;
                let defect = smaller((angle.radians() - 2.0 * PI).abs(), SHARPEST);
                sum += area * defect * defect;
            }
        }
        if whole > 0.0 { (sum / whole).sqrt() } else { 0.0 }
    }

    /// How paths bend at a vertex where edges may have one face, or several.
    fn bend(&self, surface: &Surface, vertex: VertexId, angle: &AngleSum) -> Bend {
        let halfedges = |(face, k): (FaceId, usize)| [k, before(k)].map(|k| face.halfedge(k));
        if surface.corners_of_vertex(vertex).flat_map(halfedges).any(|halfedge| surface.edges().is_branching(halfedge))
        {
            return Bend::Anywhere;
        }
        let faces = surface.corners_of_vertex(vertex).count();
        let Some((face, k)) = surface.corners_of_vertex(vertex).next() else { return Bend::Never };
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
            (true, false) if angle.exceeds(2) => Bend::Saddle,
            (true, true) if angle.exceeds(1) => Bend::Reflex,
            (true, _) => Bend::Never,
        }
    }

    /// The next face around a vertex; `None` past the boundary. Only where edges have at most two faces.
    pub(super) fn turn(&self, turn: Turn) -> Option<Turn> {
        let frame = &self.frames[turn.face as usize];
        let k = if turn.is_reversed { turn.corner } else { before(turn.corner) };
        let next = frame[k].next_on_edge >> 2;
        if next == turn.face * 3 + k as u32 {
            return None;
        }
        let (face, k) = (next / 3, next as usize % 3);
        let vertex = frame[turn.corner].vertex;
        // Counter-clockwise, one enters a face by the half-edge that leaves the vertex.
        let leaves = self.frames[face as usize][k].vertex == vertex;
        Some(Turn { face, corner: if leaves { k } else { after(k) }, is_reversed: !leaves })
    }

    /// A face's frame.
    pub(crate) fn frame(&self, face: u32) -> &Frame {
        &self.frames[face as usize]
    }

    /// Half-edge number `half-edge`'s frame and its place there.
    pub(crate) fn frame_of(&self, halfedge: u32) -> (&Frame, usize) {
        (&self.frames[halfedge as usize / 3], halfedge as usize % 3)
    }

    /// The half-edges on the other faces of a half-edge's edge, each with whether it runs in the same direction.
    pub(crate) fn across(&self, halfedge: u32) -> impl Iterator<Item = (u32, bool)> + '_ {
        let other = move |packed: u32| Some(packed).filter(|&packed| packed >> 2 != halfedge);
        let next = |halfedge: u32| {
            let (frame, k) = self.frame_of(halfedge);
            frame[k].next_on_edge
        };
        // Most edges are done after one, without a look at the face across. The last bit tells the direction so far.
        let after = move |&packed: &u32| (packed & 2 == 0).then(|| next(packed >> 2) ^ (packed & 1)).and_then(other);
        std::iter::successors(other(next(halfedge)), after).map(|packed| (packed >> 2, packed & 1 == 0))
    }

    /// A place that is on an edge, or at a vertex, as such.
    pub(crate) fn settled(&self, place: Place) -> Place {
        place.snapped_within(&self.surface, ON_EDGE)
    }

    /// The faces that a surface point lies on, with its weights in each.
    pub(crate) fn faces_at(&self, surface: &Surface, location: Place) -> Vec<(u32, [f64; 3])> {
        let place = location.snapped_within(surface, ON_EDGE);
        place.faces(surface).into_iter().map(|face| (face.0, place.weights_in(surface, face))).collect()
    }

    /// The weights of a [settled](Self::settled) place in one of the faces that it lies on.
    #[inline]
    pub(super) fn weights_at(&self, place: Place, face: u32) -> Option<[f64; 3]> {
        match place {
            // The frames of faces that lines cross are at hand.
            Place::Vertex(vertex) => {
                let corner = self.frame(face).corner(vertex.0)?;
                Some(std::array::from_fn(|k| f64::from(u8::from(k == corner))))
            }
            Place::Face { face: own, weights } => (own.0 == face).then_some(weights),
            Place::Edge { .. } => {
                place.lies_on(&self.surface, FaceId(face)).then(|| place.weights_in(&self.surface, FaceId(face)))
            }
        }
    }
}

/// A surface point whose barycentric weight is at most this lies on the edge, or at the corner, opposite: it moves by
/// this share of an edge, far below the error allowed, and a face alone would not light what is behind the edge.
const ON_EDGE: f64 = 1e-13;

/// A face around a vertex, on a walk around it: counter-clockwise as the face sees it, or reversed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn {
    pub face: u32,
    pub corner: usize,
    pub is_reversed: bool,
}
