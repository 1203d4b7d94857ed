//! Paths of locally least cost: what straightening is where faces have costs.
//!
//! Between two vertices that it passes through, a path crosses a row of edges. Its cost is a convex function of the places
//! where it crosses them, each of which moves on its edge, so that Newton's method with a barrier finds the least; at edges between two
//! costs that is Snell's law. Where a place comes to the end of its edge, the path passes through a vertex, and it is tried
//! what it costs to lead it around on either side.

mod row;

use std::collections::VecDeque;

use crate::cost::Costs;
use crate::error::Result;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Path, PathPoint, Place};
use row::{Crossing, Row};

/// Share of its cost that leading a path around a vertex must save: more than what the minimization leaves.
const GAIN: f64 = 1e-9;

/// Vertices tried per point of the path given, at most. Each time that one is left, the path gets cheaper, so that this bounds
/// time and never harms the result.
const LONGEST_WORK: usize = 50;

/// Changes a path of this surface to one of locally least cost with the same ends, never dearer than it was. Where it crosses
/// portals, it still does.
///
/// # Errors
/// [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` for a path on another surface.
///
/// # Panics
/// Where there is not one cost a face.
pub fn refract(surface: &Surface, costs: &Costs, path: &Path) -> Result<Path> {
    surface.require_own(path.surface(), "path")?;
    assert_eq!(costs.of_faces().len(), surface.face_count(), "one cost a face");
    let pieces = path.points.chunk_by(|a, b| b.location.lies_on(surface, a.face));
    let refracted = pieces.map(|piece| {
        let before = Path::new(surface, piece.to_vec());
        let after = Chain::new(surface, costs, piece).map(|mut chain| {
            chain.improve(LONGEST_WORK * piece.len());
            Path::new(surface, chain.points())
        });
        match after {
            Some(after) if costs.of_path(surface, &after) <= costs.of_path(surface, &before) => after.points,
            _ => before.points,
        }
    });
    Ok(Path::new(surface, refracted.flatten().collect()))
}

/// A path as its ends and the vertices that it passes through, with a row of edges between each and the next.
struct Chain<'a> {
    surface: &'a Surface,
    costs: &'a Costs,
    /// The ends and the vertices between; those that the path has left are `None`.
    nodes: Vec<Option<Node>>,
}

struct Node {
    place: Place,
    before: usize,
    /// To the node after; `None` at the last.
    row: Option<(Row, usize)>,
}

impl<'a> Chain<'a> {
    /// `None` for a path of one point.
    fn new(surface: &'a Surface, costs: &'a Costs, points: &[PathPoint]) -> Option<Self> {
        let (first, rest) = points.split_first()?;
        if rest.is_empty() {
            return None;
        }
        let mut chain = Self { surface, costs, nodes: Vec::new() };
        let mut last = chain.add(first.location.reduced(surface), 0);
        let (mut crossings, mut faces) = (Vec::new(), vec![first.face]);
        for (index, point) in rest.iter().enumerate() {
            let place = point.location.reduced(surface);
            match place {
                Place::Edge { halfedge, fraction } if index + 1 < rest.len() => {
                    crossings.push(Crossing { ends: surface.ends(halfedge), share: fraction });
                    faces.push(point.face);
                }
                Place::Face { .. } if index + 1 < rest.len() => {}
                _ => {
                    let row = Row { crossings: std::mem::take(&mut crossings), faces: std::mem::take(&mut faces) };
                    let next = chain.add(place, last);
                    chain.join(last, row, next);
                    last = next;
                    faces.push(point.face);
                }
            }
        }
        Some(chain)
    }

    fn add(&mut self, place: Place, before: usize) -> usize {
        self.nodes.push(Some(Node { place, before, row: None }));
        self.nodes.len() - 1
    }

    fn node(&self, index: usize) -> &Node {
        self.nodes[index].as_ref().expect("a node of the path")
    }

    /// Leads a row from one node to another.
    fn join(&mut self, from: usize, row: Row, to: usize) {
        self.nodes[from].as_mut().expect("a node of the path").row = Some((row, to));
        self.nodes[to].as_mut().expect("a node of the path").before = from;
    }

    /// Makes all rows cheapest, then leads the path around vertices while that saves anything.
    fn improve(&mut self, most: usize) {
        let mut waiting: VecDeque<usize> = VecDeque::new();
        let mut at = 0;
        while let Some((row, to)) = &self.node(at).row {
            let (row, to) = (row.clone(), *to);
            let (row, _) = self.cheapest(row, [self.node(at).place, self.node(to).place]);
            waiting.extend(self.replace(at, row, to));
            waiting.push_back(to);
            at = to;
        }
        for _ in 0..most {
            let Some(node) = waiting.pop_front() else { break };
            if self.nodes[node].is_some() {
                waiting.extend(self.lead_around(node));
            }
        }
    }

    /// The row with its crossings where it costs least between two places, and what it costs.
    fn cheapest(&self, mut row: Row, ends: [Place; 2]) -> (Row, f64) {
        let cost = row.minimize(self.surface, self.costs, ends.map(|place| place.position(self.surface)));
        (row, cost)
    }

    /// Puts a row between two nodes, with nodes where it passes through vertices. Returns these.
    fn replace(&mut self, from: usize, row: Row, to: usize) -> Vec<usize> {
        let ends = [self.node(from).place, self.node(to).place];
        let mut new = Vec::new();
        let mut at = from;
        let (rows, vertices) = row.split_at_vertices(self.surface, self.costs, ends);
        for (row, vertex) in rows.into_iter().zip(vertices.into_iter().map(Some).chain([None])) {
            let next = match vertex {
                Some(vertex) => {
                    let node = self.add(Place::Vertex(vertex), at);
                    new.push(node);
                    node
                }
                None => to,
            };
            self.join(at, row, next);
            at = next;
        }
        new
    }

    /// Tries whether the path is cheaper on either side of a vertex than through it. Returns the nodes to try next.
    fn lead_around(&mut self, index: usize) -> Vec<usize> {
        let Node { place: Place::Vertex(vertex), before, row: Some((second, after)) } = self.node(index) else {
            return Vec::new();
        };
        let (vertex, before, after) = (*vertex, *before, *after);
        let Some((first, _)) = &self.node(before).row else { return Vec::new() };
        if before == index {
            return Vec::new();
        }
        let ends = [self.node(before).place, self.node(after).place];
        let middle = Place::Vertex(vertex);
        let through = [(first, [ends[0], middle]), (second, [middle, ends[1]])]
            .map(|(row, ends)| row.cost(self.surface, self.costs, ends.map(|place| place.position(self.surface))))
            .iter()
            .sum::<f64>();
        let around = first.ways_around(self.surface, (ends[0], vertex, ends[1]), second);
        let found = around.into_iter().map(|row| self.cheapest(row, ends)).min_by(|a, b| a.1.total_cmp(&b.1));
        match found {
            Some((row, cost)) if cost < through * (1.0 - GAIN) => {
                self.nodes[index] = None;
                let mut next = self.replace(before, row, after);
                next.extend([before, after]);
                next
            }
            _ => Vec::new(),
        }
    }

    /// The points of the path, with all crossings of edges.
    fn points(&self) -> Vec<PathPoint> {
        let mut points: Vec<PathPoint> = Vec::new();
        let mut add = |place: Place, face: FaceId| {
            points.push(PathPoint { position: place.position(self.surface), location: place, face });
        };
        let (mut at, mut last_face) = (0, FaceId(0));
        while let Some((row, to)) = &self.node(at).row {
            add(self.node(at).place, row.faces[0]);
            for (crossing, &face) in row.crossings.iter().zip(&row.faces[1..]) {
                add(Place::on_edge(self.surface, face, crossing.ends, crossing.share), face);
            }
            last_face = row.faces[row.faces.len() - 1];
            at = *to;
        }
        add(self.node(at).place, last_face);
        points
    }
}
