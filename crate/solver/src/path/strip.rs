//! Strips of faces, each sharing an edge with the next, and their unfolding into the plane.

use glam::{DVec2, DVec3};
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Place, VertexId, triangle};

/// Into the next face of a strip.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step {
    /// Vertices at the ends of the edge that is crossed, ascending.
    pub edge: [VertexId; 2],
    /// The face beyond it.
    pub face: FaceId,
}

impl Step {
    pub fn new(a: VertexId, b: VertexId, face: FaceId) -> Self {
        Self { edge: [a.min(b), a.max(b)], face }
    }
}

/// Faces in a row. No face and no edge is the same as the one before it.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    pub first: FaceId,
    pub steps: Vec<Step>,
}

impl Strip {
    pub fn new(first: FaceId) -> Self {
        Self { first, steps: Vec::new() }
    }

    /// The face before a step; after the last of them, the last face.
    pub fn face_before(&self, step: usize) -> FaceId {
        if step == 0 { self.first } else { self.steps[step - 1].face }
    }

    pub fn last(&self) -> FaceId {
        self.face_before(self.steps.len())
    }

    /// Goes on into a face that shares the edge with the last one. Over an edge and straight back over it is to stay,
    /// or, where it has more than two faces, to cross once.
    pub fn push(&mut self, step: Step) {
        if self.steps.last().is_some_and(|last| last.edge == step.edge) {
            self.steps.pop();
        }
        if self.last() != step.face {
            self.steps.push(step);
        }
    }

    pub fn extend(&mut self, steps: impl IntoIterator<Item = Step>) {
        for step in steps {
            self.push(step);
        }
    }

    /// Leaves out the faces at both ends that a path between these points can do without.
    pub fn trim(&mut self, surface: &Surface, from: Place, to: Place) {
        let lies_on =
            |location: Place, step: &Step| location.support(surface).all(|(vertex, _)| step.edge.contains(&vertex));
        while self.steps.last().is_some_and(|step| lies_on(to, step)) {
            self.steps.pop();
        }
        let needless = self.steps.iter().take_while(|step| lies_on(from, step)).count();
        if needless > 0 {
            self.first = self.steps[needless - 1].face;
            self.steps.drain(..needless);
        }
    }

    /// The faces between two edges, `start` to `end` the steps that lead over those in between.
    pub fn part(&self, start: usize, end: usize) -> Self {
        Self { first: self.face_before(start), steps: self.steps[start..end].to_vec() }
    }
}

/// An edge of a strip in the plane, seen from the face before it.
#[derive(Debug, Clone, Copy)]
pub(super) struct StripEdge {
    /// Vertices at the left and the right.
    pub ends: [VertexId; 2],
    /// Where these lie.
    pub at: [DVec2; 2],
}

/// Lays a trimmed strip of two faces or more into the plane, `from` in the origin, the mean edge as unit, so that
/// products neither under- nor overflow. Returns its edges and where `to` is.
///
/// The direction of each edge is handed on as a unit vector of its own: taken from rounded positions it would be lost
/// behind a short edge.
pub(super) fn unfold(surface: &Surface, strip: &Strip, from: Place, to: Place) -> (Vec<StripEdge>, DVec2) {
    let mut edges = Vec::with_capacity(strip.steps.len());
    let mut ends = strip.steps[0].edge;
    let apex = place(surface, ends, from.position(surface));
    let mut at = apex.map(|apex| DVec2::new(-apex.x, apex.y));
    let mut along = DVec2::X;
    for (k, step) in strip.steps.iter().enumerate() {
        edges.push(StripEdge { ends, at });
        let Some(next) = strip.steps.get(k + 1) else { break };
        let apex_vertex = third(surface.faces()[step.face], ends);
        let [apex, direction] =
            beyond(surface, ends, at, along, surface.position(apex_vertex), next.edge.contains(&ends[0]));
        along = direction;
        // The next edge keeps the left end or the right one.
        let side = usize::from(next.edge.contains(&ends[0]));
        ends[side] = apex_vertex;
        at[side] = apex;
    }
    let [end, _] = beyond(surface, ends, at, along, to.position(surface), true);
    (edges, end)
}

/// The corner that is neither of these two.
pub(super) fn third(corners: [VertexId; 3], ends: [VertexId; 2]) -> VertexId {
    corners.into_iter().find(|corner| !ends.contains(corner)).expect("three different corners")
}

/// A point in the plane of an edge, from each of its ends: along it, and away from it.
fn place(surface: &Surface, ends: [VertexId; 2], apex: DVec3) -> [DVec2; 2] {
    let [left, right] = ends.map(|vertex| surface.position(vertex));
    let along = triangle::unit(right - left);
    let [a, b] = [apex - left, apex - right].map(|offset| offset / surface.mean_edge());
    let nearer = if a.length_squared() < b.length_squared() { a } else { b };
    let away = along.cross(nearer).length();
    [a, b].map(|offset| DVec2::new(along.dot(offset), away))
}

/// The point beyond an edge in the plane, and the direction from left to right of the edge that joins it to the
/// edge's left end (`keeps_left`) or right end.
fn beyond(
    surface: &Surface,
    ends: [VertexId; 2],
    at: [DVec2; 2],
    along: DVec2,
    apex: DVec3,
    keeps_left: bool,
) -> [DVec2; 2] {
    let from_ends = place(surface, ends, apex).map(|offset| along.rotate(offset));
    let nearer = usize::from(from_ends[1].length_squared() < from_ends[0].length_squared());
    let direction = if keeps_left { from_ends[0] } else { -from_ends[1] };
    [at[nearer] + from_ends[nearer], direction.normalize_or_zero()]
}
