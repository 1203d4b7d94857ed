//! Points of the surface, beside its vertices, whose distance is wanted.

use super::geometry::{ExactGeometry, Frame};
use super::origin::Origin;
use super::window::{Beam, GRAZE, length};
use heatwalk_surface::Place;
use heatwalk_surface::surface::Surface;

/// A target in one of the faces that it lies on.
#[derive(Debug)]
struct TargetInFace {
    face: u32,
    weights: [f64; 3],
    target: usize,
}

/// Targets, their values, and where they lie.
#[derive(Debug)]
pub(super) struct Targets {
    pub values: Vec<f64>,
    pub origins: Vec<Origin>,
    pub locations: Vec<Place>,
    /// By face.
    places: Vec<TargetInFace>,
}

impl Targets {
    pub fn new(surface: &Surface, geometry: &ExactGeometry, locations: &[Place]) -> Self {
        let of_target = |(target, &location): (usize, &Place)| {
            let faces = geometry.faces_at(surface, location);
            faces.into_iter().map(move |(face, weights)| TargetInFace { face, weights, target })
        };
        let mut places: Vec<TargetInFace> = locations.iter().enumerate().flat_map(of_target).collect();
        places.sort_unstable_by_key(|place| (place.face, place.target));
        Self {
            values: vec![f64::INFINITY; locations.len()],
            origins: vec![Origin::None; locations.len()],
            locations: locations.to_vec(),
            places,
        }
    }

    /// Whether a face has targets.
    pub fn are_in(&self, face: u32) -> bool {
        !self.places.is_empty() && Self::in_face(&self.places, face).next().is_some()
    }

    fn in_face(places: &[TargetInFace], face: u32) -> impl Iterator<Item = &TargetInFace> {
        let first = places.partition_point(|place| place.face < face);
        places[first..].iter().take_while(move |place| place.face == face)
    }

    /// Offers the targets in a half-edge's face a window that crosses it.
    pub fn see(&mut self, frame: &Frame, halfedge: u32, window: &Beam) {
        for place in Self::in_face(&self.places, halfedge / 3) {
            let [x, y] = frame.place(halfedge as usize % 3, place.weights);
            let crosses = window.x + (x - window.x) * window.depth / (window.depth + y);
            let at = crosses.max(window.begin).min(window.end);
            if (crosses - at).abs() > GRAZE * length(x - window.x, y + window.depth) {
                continue;
            }
            let value = window.at(at) + length(x - at, y);
            if value < self.values[place.target] {
                self.values[place.target] = value;
                self.origins[place.target] =
                    Origin::Window { halfedge, root: window.root, at, x: window.x, depth: window.depth };
            }
        }
    }

    /// Offers the targets in a face straight lines from a root of value `value` there.
    pub fn see_straight(&mut self, frame: &Frame, face: u32, from: [f64; 3], value: f64, root: u32) {
        for place in Self::in_face(&self.places, face) {
            let [a, b] = [from, place.weights].map(|weights| frame.place(0, weights));
            let value = value + length(a[0] - b[0], a[1] - b[1]);
            if value < self.values[place.target] {
                self.values[place.target] = value;
                self.origins[place.target] = Origin::Straight { face, root };
            }
        }
    }
}
