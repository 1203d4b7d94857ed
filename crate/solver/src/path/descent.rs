//! Paths down the distance to the nearest source: face by face, along edges where gradients oppose, through vertices.
//!
//! The distance must fall at every step. Where no direction falls (a cut locus, a badly shaped triangle) the path
//! takes edges to the nearest lower point, so that it always arrives.

use std::collections::HashMap;

use glam::DVec3;

use crate::dijkstra;
use crate::error::{Error, Result};
use crate::heat::Distance;
use heatwalk_surface::halfedge::Face;
use heatwalk_surface::point::SurfacePoint;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::triangle;
use heatwalk_surface::{Path, PathPoint};

/// Follows the distance from `from` down to a source.
///
/// # Errors
/// [`Error::Unreachable`] where the distance is infinite; [`Error::BadVertex`] and [`Error::BadPoint`] as
/// [`SurfacePoint::validated`].
pub fn descend(surface: &Surface, distance: &Distance, from: SurfacePoint) -> Result<Path> {
    let start = from.validated(surface)?.snapped(surface);
    if start.interpolate(surface, &distance.values).is_infinite() {
        return Err(Error::Unreachable);
    }
    let mut descent = Descent::new(surface, distance, start);
    // Each crossing is lower than the last. A path that still has not arrived after visiting every face this often is
    // among rounding errors, and edges take it the rest of the way.
    let mut crossings_left = 4 * surface.face_count();
    while !descent.arrive() {
        let next = if crossings_left > 0 { descent.steepest().or_else(|| descent.lowest_corner()) } else { None };
        match next {
            Some((location, face)) => descent.go(location, face),
            None => descent.escape(crossings_left > 0),
        }
        crossings_left = crossings_left.saturating_sub(1);
    }
    Ok(Path::new(surface, descent.points))
}

struct Descent<'a> {
    surface: &'a Surface,
    values: &'a [f64],
    /// Sources on each face from which they are seen along a straight line.
    sources_of_face: HashMap<Face, Vec<SurfacePoint>>,
    location: SurfacePoint,
    points: Vec<PathPoint>,
}

impl<'a> Descent<'a> {
    fn new(surface: &'a Surface, distance: &'a Distance, location: SurfacePoint) -> Self {
        let mut sources_of_face: HashMap<Face, Vec<SurfacePoint>> = HashMap::new();
        for &source in &distance.sources {
            let source = source.snapped(surface);
            for face in source.faces(surface) {
                sources_of_face.entry(face).or_default().push(source);
            }
        }
        let face = location.faces(surface).first().copied().unwrap_or(Face(0));
        let points = vec![PathPoint { position: location.position(surface), location, face }];
        Self { surface, values: &distance.values, sources_of_face, location, points }
    }

    fn value(&self) -> f64 {
        self.location.interpolate(self.surface, self.values)
    }

    /// Appends a straight piece through `face`.
    fn go(&mut self, location: SurfacePoint, face: Face) {
        if let Some(last) = self.points.last_mut() {
            last.face = face;
        }
        let position = location.position(self.surface);
        self.points.push(PathPoint { position, location, face });
        self.location = location;
    }

    /// Ends the path straight at the nearest source where one is in sight.
    fn arrive(&mut self) -> bool {
        let here = self.location.position(self.surface);
        let mut nearest: Option<(f64, SurfacePoint, Face)> = None;
        for face in self.location.faces(self.surface) {
            for &source in self.sources_of_face.get(&face).into_iter().flatten() {
                let distance = triangle::length(source.position(self.surface) - here);
                if nearest.is_none_or(|(best, ..)| distance < best) {
                    nearest = Some((distance, source, face));
                }
            }
        }
        let Some((distance, source, face)) = nearest else { return false };
        if distance > 0.0 {
            self.go(source, face);
        }
        true
    }

    /// The next crossing along the steepest direction, where it is lower than here.
    fn steepest(&self) -> Option<(SurfacePoint, Face)> {
        let mut best: Option<(f64, SurfacePoint, Face)> = None;
        let mut offer = |slope: f64, location, face| {
            if slope > 0.0 && best.is_none_or(|(steepest, ..)| slope > steepest) {
                best = Some((slope, location, face));
            }
        };
        let (here, value) = (self.location.position(self.surface), self.value());
        for face in self.location.faces(self.surface) {
            if let Some((slope, location)) = self.cross(face) {
                offer(slope, location, face);
            }
            if !matches!(self.location, SurfacePoint::Face { .. }) {
                for point in self.surface.faces[face] {
                    // Along an edge: to its ends from inside, to the neighbours from a vertex.
                    if self.is_on_edge_to(point) {
                        let length = triangle::length(self.surface.position(point) - here);
                        offer((value - self.values[point as usize]) / length, SurfacePoint::Vertex(point), face);
                    }
                }
            }
        }
        let (_, location, face) = best?;
        (location.interpolate(self.surface, self.values) < value).then_some((location, face))
    }

    fn is_on_edge_to(&self, point: u32) -> bool {
        match self.location {
            SurfacePoint::Vertex(here) => here != point,
            SurfacePoint::Edge { halfedge, .. } => self.surface.ends(halfedge).contains(&point),
            SurfacePoint::Face { .. } => false,
        }
    }

    /// Where the line of steepest descent leaves a face, and its slope; `None` where it does not enter the face.
    fn cross(&self, face: Face) -> Option<(f64, SurfacePoint)> {
        let corners = self.surface.corners(face);
        let weights = self.location.weights_in(self.surface, face);
        let fall = Fall::new(corners, self.surface.faces[face].map(|point| self.values[point as usize]));
        let enters = |k: usize| weights[k] > 0.0 || fall.rates[k] >= 0.0;
        if !(0..3).all(enters) {
            return None;
        }
        let (exit, step) = leaves(weights, fall.rates)?;
        let mut after: [f64; 3] = std::array::from_fn(|k| (weights[k] + step * fall.rates[k]).max(0.0));
        after[exit] = 0.0;
        let sum: f64 = after.iter().sum();
        let slope = fall.slope();
        if !(sum > 0.0 && sum.is_finite() && slope.is_finite()) {
            return None;
        }
        let weights = after.map(|weight| weight / sum);
        Some((slope, SurfacePoint::Face { face, weights }.snapped(self.surface)))
    }

    /// The lowest point of the faces around, where it is lower than here.
    fn lowest_corner(&self) -> Option<(SurfacePoint, Face)> {
        let faces = self.location.faces(self.surface);
        let corners = faces.iter().flat_map(|&face| self.surface.faces[face].map(|point| (point, face)));
        let (point, face) = corners.min_by(|a, b| self.values[a.0 as usize].total_cmp(&self.values[b.0 as usize]))?;
        (self.values[point as usize] < self.value()).then_some((SurfacePoint::Vertex(point), face))
    }

    /// Follows edges to the nearest point that is lower than here, or that sees a source: any piece with a finite
    /// distance has one. With `to_lower` false, only the latter will do.
    fn escape(&mut self, to_lower: bool) {
        let value = self.value();
        let start = self.location.nearest_point(self.surface);
        let goal = |point: u32| {
            to_lower && self.values[point as usize] < value
                || self.surface.corners_of_point(point).any(|(face, _)| self.sources_of_face.contains_key(&face))
        };
        let way = dijkstra::way_to(self.surface, start, goal)
            .expect("a finite distance means a source on the same connected piece");
        for point in way {
            let shared = self
                .location
                .faces(self.surface)
                .into_iter()
                .find(|&face| self.surface.faces[face].contains(&point))
                .expect("consecutive points of a way along edges share a face");
            if self.location != SurfacePoint::Vertex(point) {
                self.go(SurfacePoint::Vertex(point), shared);
            }
        }
    }
}

/// The steepest descent of a linear function on a triangle.
pub struct Fall {
    /// Rates at which the barycentric weights change on the way down, to a common scale.
    pub rates: [f64; 3],
    /// Length of the gradient times twice the area.
    rise: f64,
    twice_area: f64,
}

impl Fall {
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

/// The side, by the corner opposite, where a way with these rates leaves a triangle, and the multiple of the rates to
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
