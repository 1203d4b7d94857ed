//! Paths down the distance to the nearest source: face by face, along edges where gradients oppose, through vertices.
//!
//! Where faces have costs, the steepest direction is that in which the distance falls most for what it costs. The distance must
//! fall at every step. Where no direction falls (a cut locus, a badly shaped triangle) the path
//! takes edges to the nearest lower vertex, so that it always arrives. Where the shortest path crosses a portal to another
//! component, so does this one.

use std::collections::HashMap;

use glam::DVec3;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Path, PathPoint, Place, ToPoint, VertexData, VertexId, triangle};

use crate::cost::Costs;
use crate::dijkstra;
use crate::distance::Distance;
use crate::error::{Error, Result};

/// Follows the distance from `from` down to a source.
///
/// # Errors
/// [`Error::Unreachable`] where the distance is infinite; [`Error::Surface`] as
/// [`Surface::point`]; [`Error::Surface`] with `ForeignSurface` for a distance of another surface.
pub fn descend(surface: &Surface, distance: &Distance, from: impl ToPoint) -> Result<Path> {
    descend_by(surface, distance, from, |descent| descent.steepest().or_else(|| descent.lowest_corner()))
}

/// The same from corner to corner, to that by way of which the distance is least. Over portals it may lose its way.
///
/// # Errors
/// As [`descend`]; [`Error::Unreachable`] where it has lost its way.
pub(crate) fn descend_corners(surface: &Surface, distance: &Distance, from: impl ToPoint) -> Result<Path> {
    descend_by(surface, distance, from, |descent| descent.cheapest_corner())
}

fn descend_by(
    surface: &Surface,
    distance: &Distance,
    from: impl ToPoint,
    step: impl Fn(&Descent<'_>) -> Option<(Place, FaceId)>,
) -> Result<Path> {
    surface.require_own(distance.surface(), "distance")?;
    let start = surface.point(from)?.place().snapped(surface);
    if start.interpolate(surface, &distance.values).is_infinite() {
        return Err(Error::Unreachable);
    }
    let mut descent = Descent::new(surface, distance, start);
    // Each crossing is lower than the last. A path that still has not arrived after visiting every face this often is
    // among rounding errors, and edges take it the rest of the way.
    let mut crossings_left = 4 * surface.face_count();
    while !descent.has_arrived() {
        let next = if crossings_left > 0 { step(&descent) } else { None };
        match next {
            Some((location, face)) => descent.go(location, face),
            None => descent.escape(crossings_left > 0)?,
        }
        crossings_left = crossings_left.saturating_sub(1);
    }
    Ok(Path::new(surface, descent.points))
}

/// A source, or a place where paths leave for another component.
#[derive(Debug, Clone, Copy)]
struct Goal {
    place: Place,
    /// The distance there.
    distance: f64,
    /// Where paths go on; `None` for a source.
    leads_to: Option<Place>,
}

struct Descent<'a> {
    surface: &'a Surface,
    values: &'a VertexData<f64>,
    costs: Option<&'a Costs>,
    /// Goals on each face from which they are seen along a straight line.
    goals_of_face: HashMap<FaceId, Vec<Goal>>,
    /// The distance at the last portal that was crossed. Those that are farther lead back, though they may be in sight: where faces have
    /// costs, the distance of a place between vertices is above what it costs to go on from there.
    crossed: f64,
    location: Place,
    points: Vec<PathPoint>,
}

impl<'a> Descent<'a> {
    fn new(surface: &'a Surface, distance: &'a Distance, location: Place) -> Self {
        let sources = distance.sources.iter().map(|&place| Goal { place, distance: 0.0, leads_to: None });
        let crossings = distance.crossings.iter().map(|crossing| Goal {
            place: crossing.from,
            distance: crossing.distance,
            leads_to: Some(crossing.to),
        });
        let mut goals_of_face: HashMap<FaceId, Vec<Goal>> = HashMap::new();
        for goal in sources.chain(crossings) {
            let place = goal.place.snapped(surface);
            for face in place.faces(surface) {
                goals_of_face.entry(face).or_default().push(Goal { place, ..goal });
            }
        }
        let face = location.faces(surface).first().copied().unwrap_or(FaceId(0));
        let points = vec![PathPoint { position: location.position(surface), location, face }];
        let (values, costs) = (&distance.values, distance.costs());
        Self { surface, values, costs, goals_of_face, crossed: f64::INFINITY, location, points }
    }

    fn value(&self) -> f64 {
        self.location.interpolate(self.surface, self.values)
    }

    /// Appends a straight segment through `face`.
    fn go(&mut self, location: Place, face: FaceId) {
        if let Some(last) = self.points.last_mut() {
            last.face = face;
        }
        let position = location.position(self.surface);
        self.points.push(PathPoint { position, location, face });
        self.location = location;
    }

    /// Goes straight to goals while any is in sight. Whether the last was a source.
    fn has_arrived(&mut self) -> bool {
        while let Some((length, goal, face)) = self.nearest_goal() {
            if length > 0.0 {
                self.go(goal.place, face);
            }
            let Some(place) = goal.leads_to else { return true };
            self.crossed = goal.distance;
            // Rounding shall not keep the path here.
            for face in goal.place.faces(self.surface) {
                let goals = self.goals_of_face.get_mut(&face);
                goals.into_iter().for_each(|goals| goals.retain(|other| other.leads_to != Some(place)));
            }
            let face = place.faces(self.surface).first().copied().unwrap_or(face);
            self.points.push(PathPoint { position: place.position(self.surface), location: place, face });
            self.location = place;
        }
        false
    }

    /// The goal in sight that is nearest to its source by way of a straight line, what the line costs, and a face that it is in.
    fn nearest_goal(&self) -> Option<(f64, Goal, FaceId)> {
        let here = self.location.position(self.surface);
        let mut nearest: Option<(f64, Goal, FaceId)> = None;
        for face in self.location.faces(self.surface) {
            for &goal in self.goals_of(face) {
                let length = self.cost(face) * triangle::length(goal.place.position(self.surface) - here);
                if nearest.is_none_or(|(best, other, _)| length + goal.distance < best + other.distance) {
                    nearest = Some((length, goal, face));
                }
            }
        }
        nearest
    }

    /// Those of a face that do not lead back.
    fn goals_of(&self, face: FaceId) -> impl Iterator<Item = &Goal> {
        let goals = self.goals_of_face.get(&face).into_iter().flatten();
        goals.filter(|goal| goal.leads_to.is_none() || goal.distance <= self.crossed)
    }

    /// The next crossing along the steepest direction, where it is lower than here.
    fn steepest(&self) -> Option<(Place, FaceId)> {
        let mut best: Option<(f64, Place, FaceId)> = None;
        let mut offer = |slope: f64, location, face| {
            if slope > 0.0 && best.is_none_or(|(steepest, ..)| slope > steepest) {
                best = Some((slope, location, face));
            }
        };
        let (here, value) = (self.location.position(self.surface), self.value());
        for face in self.location.faces(self.surface) {
            if let Some((slope, location)) = self.cross(face) {
                offer(slope / self.cost(face), location, face);
            }
            if !matches!(self.location, Place::Face { .. }) {
                for vertex in self.surface.faces()[face] {
                    // Along an edge: to its ends from inside, to the neighbours from a vertex.
                    if self.is_on_edge_to(vertex) {
                        let length = self.cost(face) * triangle::length(self.surface.position(vertex) - here);
                        offer((value - self.values[vertex]) / length, Place::Vertex(vertex), face);
                    }
                }
            }
        }
        let (_, location, face) = best?;
        (location.interpolate(self.surface, self.values) < value).then_some((location, face))
    }

    /// What a unit of length costs in a face.
    fn cost(&self, face: FaceId) -> f64 {
        self.costs.map_or(1.0, |costs| costs.of(face))
    }

    fn is_on_edge_to(&self, vertex: VertexId) -> bool {
        match self.location {
            Place::Vertex(here) => here != vertex,
            Place::Edge { halfedge, .. } => self.surface.ends(halfedge).contains(&vertex),
            Place::Face { .. } => false,
        }
    }

    /// Where the line of steepest descent leaves a face, and its slope; `None` where it does not enter the face.
    fn cross(&self, face: FaceId) -> Option<(f64, Place)> {
        let corners = self.surface.corners(face);
        let weights = self.location.weights_in(self.surface, face);
        let descent = DescentDirection::new(corners, self.surface.faces()[face].map(|vertex| self.values[vertex]));
        let enters = |k: usize| weights[k] > 0.0 || descent.rates[k] >= 0.0;
        if !(0..3).all(enters) {
            return None;
        }
        let (exit, step) = leaves(weights, descent.rates)?;
        let mut after: [f64; 3] = std::array::from_fn(|k| (weights[k] + step * descent.rates[k]).max(0.0));
        after[exit] = 0.0;
        let sum: f64 = after.iter().sum();
        let slope = descent.slope();
        if !(sum > 0.0 && sum.is_finite() && slope.is_finite()) {
            return None;
        }
        let weights = after.map(|weight| weight / sum);
        Some((slope, Place::Face { face, weights }.snapped(self.surface)))
    }

    /// The lowest vertex of the faces around, where it is lower than here.
    fn lowest_corner(&self) -> Option<(Place, FaceId)> {
        let faces = self.location.faces(self.surface);
        let corners = faces.iter().flat_map(|&face| self.surface.faces()[face].map(|vertex| (vertex, face)));
        let (vertex, face) = corners.min_by(|a, b| self.values[a.0].total_cmp(&self.values[b.0]))?;
        (self.values[vertex] < self.value()).then_some((Place::Vertex(vertex), face))
    }

    /// The vertex of the faces around by way of which the distance is least, of those that are lower than here.
    fn cheapest_corner(&self) -> Option<(Place, FaceId)> {
        let (here, value) = (self.location.position(self.surface), self.value());
        let faces = self.location.faces(self.surface);
        let corners = faces.iter().flat_map(|&face| self.surface.faces()[face].map(|vertex| (vertex, face)));
        let by_way = |&(vertex, face): &(VertexId, FaceId)| {
            self.values[vertex] + self.cost(face) * triangle::length(self.surface.position(vertex) - here)
        };
        let (vertex, face) = corners
            .filter(|&(vertex, _)| self.values[vertex] < value)
            .min_by(|one, other| by_way(one).total_cmp(&by_way(other)))?;
        Some((Place::Vertex(vertex), face))
    }

    /// Follows edges to the nearest vertex that is lower than here, or that sees a goal. With `to_lower` false, only the latter will do.
    ///
    /// # Errors
    /// [`Error::Unreachable`] where there is none: any component with a finite distance had one, but a path that does not go where its
    /// distance comes from may have gone by all of its portals and have come back.
    fn escape(&mut self, to_lower: bool) -> Result<()> {
        let value = self.value();
        let start = self.location.nearest_vertex(self.surface);
        let goal = |vertex: VertexId| {
            to_lower && self.values[vertex] < value
                || self.surface.corners_of_vertex(vertex).any(|(face, _)| self.goals_of(face).next().is_some())
        };
        let path = dijkstra::nearest_goal(self.surface, start, goal).ok_or(Error::Unreachable)?;
        for vertex in path {
            let shared = self
                .location
                .faces(self.surface)
                .into_iter()
                .find(|&face| self.surface.faces()[face].contains(&vertex))
                .expect("consecutive vertices of a path along edges share a face");
            if self.location != Place::Vertex(vertex) {
                self.go(Place::Vertex(vertex), shared);
            }
        }
        Ok(())
    }
}

/// The descent direction of a linear function on a triangle.
pub struct DescentDirection {
    /// Rates at which the barycentric weights change on the way down, to a common scale.
    pub rates: [f64; 3],
    /// Length of the gradient times twice the area.
    rise: f64,
    twice_area: f64,
}

impl DescentDirection {
    /// Of the function with these corner values.
    pub fn new(corners: [DVec3; 3], [a, b, c]: [f64; 3]) -> Self {
        let edges = triangle::edges(corners);
        // n × this is the gradient times twice the area, and its products with the edges are the rates uphill.
        let turned = edges[1] * (b - a) + edges[2] * (c - a);
        let twice_area = triangle::length(triangle::area_vector(corners));
        Self { rates: edges.map(|edge| -turned.dot(edge)), rise: triangle::length(turned), twice_area }
    }

    /// Length of the gradient; not finite on a triangle without an area.
    pub fn slope(&self) -> f64 {
        self.rise / self.twice_area
    }

    /// `rates` for each length walked; zero where the function has no finite gradient.
    pub fn rates_by_length(&self) -> [f64; 3] {
        let rates = self.rates.map(|rate| rate / self.rise / self.twice_area);
        if rates.iter().all(|rate| rate.is_finite()) { rates } else { [0.0; 3] }
    }
}

/// The side, by the corner opposite, where a line with these rates leaves a triangle, and the multiple of the rates to
/// there; `None` where all rates are zero.
pub fn leaves(weights: [f64; 3], rates: [f64; 3]) -> Option<(usize, f64)> {
    let mut first: Option<(usize, f64)> = None;
    for k in (0..3).filter(|&k| rates[k] < 0.0) {
        let step = weights[k] / -rates[k];
        if first.is_none_or(|(_, least)| step < least) {
            first = Some((k, step));
        }
    }
    first
}
