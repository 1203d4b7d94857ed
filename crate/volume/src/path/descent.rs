//! Down the gradient of distance, from tetrahedron to tetrahedron.

use glam::DVec3;

use crate::corner::Corner;
use crate::distance::VolumeDistance;
use crate::march::Medium;
use crate::mesh::locate::weights;
use crate::mesh::{NONE, Start, TetId, TetMesh};
use crate::point::TetPoint;

/// Weights of a place below this are on a face; far above rounding, and not seen.
const ON_FACE: f64 = 1e-9;

/// Where a descent ended.
pub(super) enum Descent {
    /// At a source.
    Arrived,
    /// After one step.
    Continues,
    /// Where nothing around is lower.
    Stuck,
}

/// Goes on from the last corner, by one step where distance has waves to go back along afterwards, else as far as it gets. Distance
/// falls at each step: where the gradient leads nowhere, on to the lowest vertex around.
pub(super) fn go_down(
    mesh: &TetMesh,
    medium: &Medium,
    distance: &VolumeDistance,
    corners: &mut Vec<Corner>,
) -> Descent {
    let slopes = Slopes { mesh, medium, distance };
    loop {
        let Some(&Corner { place, start, .. }) = corners.last() else { return Descent::Stuck };
        let value = slopes.value(place, start);
        if let Some((source, cost)) = slopes.source_beside(start, value) {
            corners.last_mut().expect("there is a last").cost = cost;
            if source != place {
                corners.push(Corner { place: source, start, cost });
            }
            return Descent::Arrived;
        }
        let step = slopes.step(place, start).filter(|step| step.value < value);
        let Some(step) = step.or_else(|| slopes.lowest(place, start, value)) else { return Descent::Stuck };
        corners.last_mut().expect("there is a last").cost = step.cost;
        corners.push(Corner { place: step.place, start: step.start, cost: step.cost });
        if distance.origins.is_some() {
            return Descent::Continues;
        }
    }
}

struct Slopes<'a> {
    mesh: &'a TetMesh,
    medium: &'a Medium,
    distance: &'a VolumeDistance,
}

/// A straight step within a tetrahedron.
struct Next {
    place: DVec3,
    start: Start,
    value: f64,
    cost: f64,
}

impl Slopes<'_> {
    /// The tetrahedra that a place touches.
    fn around(&self, start: Start) -> Vec<u32> {
        let open = |tetrahedron: &u32| self.medium.cost(*tetrahedron).is_finite();
        match start {
            Start::Inside(tetrahedron) => vec![tetrahedron],
            Start::Vertex(vertex) => self.mesh.around().row(vertex).iter().copied().filter(open).collect(),
            Start::Edge([a, b]) => {
                let has_edge = |tetrahedron: &u32| self.mesh.tetrahedra()[*tetrahedron as usize].contains(&b);
                self.mesh
                    .around()
                    .row(a)
                    .iter()
                    .copied()
                    .filter(|tetrahedron| open(tetrahedron) && has_edge(tetrahedron))
                    .collect()
            }
        }
    }

    fn value(&self, place: DVec3, start: Start) -> f64 {
        match start {
            Start::Vertex(vertex) => self.distance.values[vertex as usize],
            _ => self.around(start).first().map_or(f64::INFINITY, |&tetrahedron| self.value_in(place, tetrahedron)),
        }
    }

    fn value_in(&self, place: DVec3, tetrahedron: u32) -> f64 {
        let corners = self.mesh.tetrahedra()[tetrahedron as usize];
        let weights = weights(self.mesh.corners(TetId(tetrahedron)), place);
        corners.iter().zip(weights).map(|(&vertex, weight)| weight * self.distance.values[vertex as usize]).sum()
    }

    /// A source in one of the tetrahedra that a place touches, where no corner of it is nearer to another, and the cost there.
    fn source_beside(&self, start: Start, value: f64) -> Option<(DVec3, f64)> {
        let around = self.around(start);
        let sources = self.distance.sources.iter().filter(|source| match start {
            Start::Vertex(vertex) => {
                **source == TetPoint::Vertex(heatwalk::VertexId(vertex)) || !matches!(source, TetPoint::Vertex(_))
            }
            _ => true,
        });
        let mut found = sources.filter_map(|&source| {
            let is_beside = |&&tetrahedron: &&u32| match source {
                TetPoint::Vertex(vertex) => self.mesh.tetrahedra()[tetrahedron as usize].contains(&vertex.0),
                TetPoint::Inside { tetrahedron: own, .. } => own.0 == tetrahedron,
            };
            let tetrahedron = *around.iter().find(is_beside)?;
            let is_lower = source.interpolate(self.mesh, &self.distance.values) <= value
                || matches!(source, TetPoint::Inside { .. });
            is_lower.then(|| (source.position(self.mesh), self.medium.cost(tetrahedron)))
        });
        found.next()
    }

    /// The steepest step down the gradient.
    fn step(&self, place: DVec3, start: Start) -> Option<Next> {
        let mut steepest: Option<(f64, Next)> = None;
        for tetrahedron in self.around(start) {
            let gradient = self.distance.gradient_in(self.mesh, tetrahedron);
            let cost = self.medium.cost(tetrahedron);
            let slope = gradient.length() / cost;
            if slope > 0.0
                && steepest.as_ref().is_none_or(|(most, _)| slope > *most)
                && let Some(step) = self.through(place, tetrahedron, -gradient)
            {
                steepest = Some((slope, step));
            }
        }
        steepest.map(|(_, step)| step)
    }

    /// To the face where a direction leaves a tetrahedron, if it leads into it.
    fn through(&self, place: DVec3, tetrahedron: u32, direction: DVec3) -> Option<Next> {
        let corners = self.mesh.corners(TetId(tetrahedron));
        let here = weights(corners, place);
        let there = weights(corners, place + direction);
        let mut exit: Option<(f64, usize)> = None;
        for corner in 0..4 {
            let change = there[corner] - here[corner];
            if change < 0.0 {
                if here[corner] <= ON_FACE {
                    return None;
                }
                let share = here[corner] / -change;
                if exit.is_none_or(|(least, _)| share < least) {
                    exit = Some((share, corner));
                }
            }
        }
        let (share, corner) = exit?;
        let place = place + share * direction;
        let neighbor = self.medium.sight(self.mesh).neighbors[tetrahedron as usize][corner];
        let next = if neighbor == NONE { tetrahedron } else { neighbor };
        let value = self.value_in(place, tetrahedron);
        Some(Next { place, start: Start::Inside(next), value, cost: self.medium.cost(tetrahedron) })
    }

    /// To the vertex of the tetrahedra around from which the way is shortest.
    fn lowest(&self, place: DVec3, start: Start, value: f64) -> Option<Next> {
        let mut best: Option<(f64, Next)> = None;
        for tetrahedron in self.around(start) {
            let cost = self.medium.cost(tetrahedron);
            for vertex in self.mesh.tetrahedra()[tetrahedron as usize] {
                let there = self.mesh.positions()[vertex as usize];
                let lower = self.distance.values[vertex as usize];
                let total = lower + cost * place.distance(there);
                if lower < value && best.as_ref().is_none_or(|(least, _)| total < *least) {
                    best = Some((total, Next { place: there, start: Start::Vertex(vertex), value: lower, cost }));
                }
            }
        }
        best.map(|(_, step)| step)
    }
}
