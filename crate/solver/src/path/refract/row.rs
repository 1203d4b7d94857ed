//! Rows of edges that a path crosses one after the other, and where it does so at the least cost.

use glam::DVec3;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, HalfedgeId, Place, VertexId};

use crate::cost::Costs;

/// Length below which a segment counts as none, in mean edges, so that its direction has a derivative: far below what is seen,
/// far above rounding.
const NO_LENGTH: f64 = 1e-8;

/// Share of an edge within which a crossing is at its end: the last barrier keeps it no farther away where it had better go
/// beyond.
const AT_END: f64 = 1e-6;

/// Share of its edge that a crossing begins from the ends, at least.
const FROM_END: f64 = 0.05;

/// Where the crossing of an edge begins that the path is led over.
const MIDDLE: f64 = 0.5;

/// The barrier against the ends of edges, in mean edges, at first, what it falls by, and at last, when it adds less than twice
/// itself a crossing to the cost (Boyd and Vandenberghe, "Convex Optimization", 2004, section 11.2).
const FIRST_BARRIER: f64 = 1e-2;
const BARRIER_FALLS: f64 = 0.03;
const LAST_BARRIER: f64 = 1e-11;

/// Share of the way to the nearest end of an edge that a step may go.
const TO_END: f64 = 0.95;

/// Steps of Newton's method for each barrier, at most. Half a dozen do on most rows.
const STEPS: usize = 50;

/// Halvings of a step that does not save anything, before that barrier is done with.
const HALVINGS: usize = 30;

/// Where a path crosses an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing {
    pub ends: [VertexId; 2],
    /// Of the way from the first end to the second.
    pub share: f64,
}

impl Crossing {
    /// The vertex that it is at, if any.
    fn vertex(&self) -> Option<VertexId> {
        match self.share {
            share if share <= 0.0 => Some(self.ends[0]),
            share if share >= 1.0 => Some(self.ends[1]),
            _ => None,
        }
    }
}

/// Crossings in order, and the faces before, between and after them.
#[derive(Debug, Clone)]
pub(super) struct Row {
    pub crossings: Vec<Crossing>,
    pub faces: Vec<FaceId>,
}

/// A row laid out for the minimization.
struct Laid {
    /// Where each crossing's edge begins, and the way to its end, in mean edges.
    edges: Vec<(DVec3, DVec3)>,
    ends: [DVec3; 2],
    /// Of each segment.
    costs: Vec<f64>,
}

impl Laid {
    fn segment(&self, shares: &[f64], index: usize) -> DVec3 {
        let at = |crossing: usize| {
            let (start, along) = self.edges[crossing];
            start + along * shares[crossing]
        };
        let from = if index == 0 { self.ends[0] } else { at(index - 1) };
        let to = if index == self.edges.len() { self.ends[1] } else { at(index) };
        to - from
    }

    fn cost(&self, shares: &[f64]) -> f64 {
        let segments = self.costs.iter().enumerate();
        segments.map(|(index, cost)| cost * smoothed(self.segment(shares, index))).sum()
    }

    /// The cost with a barrier against the ends of the edges.
    fn barred_cost(&self, shares: &[f64], barrier: f64) -> f64 {
        self.cost(shares) - barrier * shares.iter().map(|share| (share * (1.0 - share)).ln()).sum::<f64>()
    }

    /// Newton's step from these shares for the cost with a barrier, and by how much it would fall along it at first. The matrix
    /// of second derivatives is tridiagonal: each crossing has its two neighbors.
    fn newton(&self, shares: &[f64], barrier: f64) -> (Vec<f64>, f64) {
        let barred = |share: f64| barrier * (1.0 / (1.0 - share) - 1.0 / share);
        let bent = |share: f64| barrier * ((1.0 - share).powi(-2) + share.powi(-2));
        let mut gradient: Vec<f64> = shares.iter().map(|&share| barred(share)).collect();
        let mut diagonal: Vec<f64> = shares.iter().map(|&share| bent(share)).collect();
        let mut beside = vec![0.0; shares.len()];
        for (index, &cost) in self.costs.iter().enumerate() {
            let segment = self.segment(shares, index);
            let length = smoothed(segment);
            let unit = segment / length;
            let curvature = |a: DVec3, b: DVec3| cost / length * (a.dot(b) - unit.dot(a) * unit.dot(b));
            let before = index.checked_sub(1).map(|before| (before, self.edges[before].1));
            let after = self.edges.get(index).map(|&(_, along)| (index, along));
            if let Some((crossing, along)) = before {
                gradient[crossing] -= cost * unit.dot(along);
                diagonal[crossing] += curvature(along, along);
            }
            if let Some((crossing, along)) = after {
                gradient[crossing] += cost * unit.dot(along);
                diagonal[crossing] += curvature(along, along);
            }
            if let (Some((crossing, a)), Some((_, b))) = (before, after) {
                beside[crossing] = -curvature(a, b);
            }
        }
        // Forward elimination and back substitution.
        let mut step: Vec<f64> = gradient.iter().map(|slope| -slope).collect();
        for crossing in 1..step.len() {
            let factor = beside[crossing - 1] / diagonal[crossing - 1];
            diagonal[crossing] -= factor * beside[crossing - 1];
            step[crossing] -= factor * step[crossing - 1];
        }
        for crossing in (0..step.len()).rev() {
            let after = step.get(crossing + 1).copied().unwrap_or(0.0);
            step[crossing] = (step[crossing] - beside[crossing] * after) / diagonal[crossing];
        }
        let falls = -gradient.iter().zip(&step).map(|(slope, step)| slope * step).sum::<f64>();
        (step, falls)
    }

    /// Lowers the cost with a barrier to its least.
    fn descend(&self, shares: &mut Vec<f64>, barrier: f64) {
        let mut cost = self.barred_cost(shares, barrier);
        for _ in 0..STEPS {
            let (step, falls) = self.newton(shares, barrier);
            let room = |(&share, &step): (&f64, &f64)| if step < 0.0 { -share / step } else { (1.0 - share) / step };
            let mut length = shares.iter().zip(&step).map(room).fold(1.0, |least, room| (TO_END * room).min(least));
            let better = (0..HALVINGS).find_map(|_| {
                let moved: Vec<f64> = shares.iter().zip(&step).map(|(share, step)| share + length * step).collect();
                length *= 0.5;
                Some((self.barred_cost(&moved, barrier), moved)).filter(|&(found, _)| found < cost)
            });
            let Some((found, moved)) = better else { break };
            (*shares, cost) = (moved, found);
            if falls <= barrier {
                break;
            }
        }
    }
}

fn smoothed(segment: DVec3) -> f64 {
    (segment.length_squared() + NO_LENGTH * NO_LENGTH).sqrt()
}

impl Row {
    /// Moves the crossings to where the way between two points costs least. Returns what it costs then.
    pub fn minimize(&mut self, surface: &Surface, costs: &Costs, ends: [DVec3; 2]) -> f64 {
        let laid = self.laid(surface, costs, ends);
        let inside = |crossing: &Crossing| crossing.share.clamp(FROM_END, 1.0 - FROM_END);
        let mut shares: Vec<f64> = self.crossings.iter().map(inside).collect();
        let mut barrier = FIRST_BARRIER;
        while barrier >= LAST_BARRIER && !shares.is_empty() {
            laid.descend(&mut shares, barrier);
            barrier *= BARRIER_FALLS;
        }
        for (crossing, share) in self.crossings.iter_mut().zip(&mut shares) {
            *share = match *share {
                share if share < AT_END => 0.0,
                share if share > 1.0 - AT_END => 1.0,
                share => share,
            };
            crossing.share = *share;
        }
        laid.cost(&shares) * surface.mean_edge()
    }

    /// What the way between two points costs.
    pub fn cost(&self, surface: &Surface, costs: &Costs, ends: [DVec3; 2]) -> f64 {
        let shares: Vec<f64> = self.crossings.iter().map(|crossing| crossing.share).collect();
        self.laid(surface, costs, ends).cost(&shares) * surface.mean_edge()
    }

    fn laid(&self, surface: &Surface, costs: &Costs, ends: [DVec3; 2]) -> Laid {
        let scale = surface.mean_edge().recip();
        let place = |position: DVec3| (position - ends[0]) * scale;
        let edge = |crossing: &Crossing| {
            let [start, end] = crossing.ends.map(|vertex| place(surface.position(vertex)));
            (start, end - start)
        };
        Laid {
            edges: self.crossings.iter().map(edge).collect(),
            ends: ends.map(place),
            costs: self.faces.iter().map(|&face| costs.of(face)).collect(),
        }
    }

    /// The parts between the vertices that the crossings lie at, and these. A part that runs along an edge is in the cheapest
    /// face there.
    pub fn split_at_vertices(self, surface: &Surface, costs: &Costs, ends: [Place; 2]) -> (Vec<Self>, Vec<VertexId>) {
        let (mut rows, mut vertices): (Vec<Self>, Vec<VertexId>) = (Vec::new(), Vec::new());
        let mut part = Self { crossings: Vec::new(), faces: vec![self.faces[0]] };
        let mut last = vertex_of(ends[0]);
        for (crossing, &face) in self.crossings.iter().zip(&self.faces[1..]) {
            match crossing.vertex() {
                // Around a vertex that the path is at already.
                Some(vertex) if last == Some(vertex) && part.crossings.is_empty() => part.faces[0] = face,
                Some(vertex) => {
                    let row = std::mem::replace(&mut part, Self { crossings: Vec::new(), faces: vec![face] });
                    rows.push(row);
                    vertices.push(vertex);
                    last = Some(vertex);
                }
                None => {
                    part.crossings.push(*crossing);
                    part.faces.push(face);
                }
            }
        }
        // The last vertex may be the end itself.
        if part.crossings.is_empty() && last.is_some() && last == vertex_of(ends[1]) && !vertices.is_empty() {
            vertices.pop();
        } else {
            rows.push(part);
        }
        let stops: Vec<Option<VertexId>> = [vertex_of(ends[0])]
            .into_iter()
            .chain(vertices.iter().copied().map(Some))
            .chain([vertex_of(ends[1])])
            .collect();
        for (row, stops) in rows.iter_mut().zip(stops.windows(2)) {
            if let (true, [Some(a), Some(b)]) = (row.crossings.is_empty(), [stops[0], stops[1]]) {
                let beside = surface.halfedge_between(a, b).into_iter().flat_map(|edge| surface.faces_of_edge(edge));
                let cheapest = beside.min_by(|&a, &b| costs.of(a).total_cmp(&costs.of(b)));
                row.faces[0] = cheapest.unwrap_or(row.faces[0]);
            }
        }
        (rows, vertices)
    }

    /// This row and one that goes on from its last vertex, joined by the edges around that vertex, on each side; from the place
    /// where this row begins to that where the other one ends.
    pub fn ways_around(
        &self,
        surface: &Surface,
        (from, vertex, to): (Place, VertexId, Place),
        next: &Self,
    ) -> Vec<Self> {
        let starts =
            beside(surface, self.faces[self.faces.len() - 1], self.crossings.is_empty().then_some(from), vertex);
        let goals = beside(surface, next.faces[0], next.crossings.is_empty().then_some(to), vertex);
        let mut ways = Vec::new();
        for &start in &starts {
            for is_first in [true, false] {
                let Some((edges, faces)) = fan(surface, vertex, start, &goals, is_first) else { continue };
                let around = edges.into_iter().map(|other| Crossing { ends: [vertex, other], share: MIDDLE });
                let mut row = self.clone();
                let last = row.faces.len() - 1;
                row.faces[last] = start;
                row.crossings.extend(around);
                row.faces.extend(&faces[1..]);
                row.crossings.extend(&next.crossings);
                row.faces.extend(&next.faces[1..]);
                ways.push(row);
            }
        }
        ways
    }
}

/// The faces at a vertex from which a segment comes that lies in `face`: where it runs along an edge from `end`, all there.
fn beside(surface: &Surface, face: FaceId, end: Option<Place>, vertex: VertexId) -> Vec<FaceId> {
    let is_shared = |&face: &FaceId| end.is_some_and(|end| end.lies_on(surface, face));
    let around = surface.corners_of_vertex(vertex).map(|(face, _)| face);
    let shared: Vec<FaceId> = around.filter(is_shared).collect();
    if shared.is_empty() { vec![face] } else { shared }
}

/// The faces around a vertex from one to the first of others, and the far ends of the edges between them, where the first edge
/// is the one that leaves the vertex in the first face, or the one that comes to it. `None` where the boundary or an edge
/// of several faces is in the way.
fn fan(
    surface: &Surface,
    vertex: VertexId,
    start: FaceId,
    goals: &[FaceId],
    is_first: bool,
) -> Option<(Vec<VertexId>, Vec<FaceId>)> {
    let corner = |face: FaceId| surface.faces()[face].iter().position(|&at| at == vertex);
    let (mut faces, mut edges) = (vec![start], Vec::new());
    let k = corner(start)?;
    let mut side = start.halfedge(if is_first { k } else { (k + 2) % 3 });
    while !goals.contains(faces.last()?) {
        let across: HalfedgeId = surface.edges().mate(side)?;
        let face = across.triangle();
        if face == start {
            return None;
        }
        let ends = surface.ends(side);
        edges.push(if ends[0] == vertex { ends[1] } else { ends[0] });
        faces.push(face);
        let k = corner(face)?;
        let sides = [face.halfedge(k), face.halfedge((k + 2) % 3)];
        side = if sides[0] == across { sides[1] } else { sides[0] };
    }
    Some((edges, faces))
}

/// The vertex that a place is, or `None`.
fn vertex_of(place: Place) -> Option<VertexId> {
    match place {
        Place::Vertex(vertex) => Some(vertex),
        _ => None,
    }
}
