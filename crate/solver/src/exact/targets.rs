//! Points of the surface, beside its vertices, whose distance is wanted.

use std::sync::Arc;

use heatwalk_surface::Place;

use super::geometry::Frame;
use super::origin::Origin;
use super::points::PointsInFaces;
use super::window::{Beam, length};

/// Targets, their values, and where they lie.
#[derive(Debug)]
pub(super) struct Targets {
    pub values: Vec<f64>,
    pub origins: Vec<Origin>,
    pub locations: Vec<Place>,
    in_faces: Arc<PointsInFaces>,
}

impl Targets {
    /// `in_faces`: the faces of these places.
    pub fn new(locations: &[Place], in_faces: Arc<PointsInFaces>) -> Self {
        Self {
            values: vec![f64::INFINITY; locations.len()],
            origins: vec![Origin::None; locations.len()],
            locations: locations.to_vec(),
            in_faces,
        }
    }

    /// Forgets all values.
    pub fn clear(&mut self) {
        self.values.fill(f64::INFINITY);
        self.origins.fill(Origin::None);
    }

    /// Whether a face has targets.
    #[inline(always)]
    pub fn are_in(&self, face: u32) -> bool {
        self.in_faces.are_in(face)
    }

    /// Offers the targets in a half-edge's face a window that crosses it, whose rays may miss them by `grain`. `nearer` is told those that it brings nearer, with
    /// their values.
    pub fn see(&mut self, frame: &Frame, halfedge: u32, (window, grain): (&Beam, f64), nearer: impl FnMut(u32, f64)) {
        let seen = |place: [f64; 2]| {
            let (at, value) = window.sees(place, grain)?;
            Some((value, Origin::Window { halfedge, root: window.root, at, x: window.x, depth: window.depth }))
        };
        self.see_by(frame, halfedge, seen, nearer);
    }

    /// Offers the targets in a half-edge's face what they are `seen` by there, as it is laid out by the half-edge; `nearer` as for
    /// [`Self::see`].
    pub fn see_by(
        &mut self,
        frame: &Frame,
        halfedge: u32,
        seen: impl Fn([f64; 2]) -> Option<(f64, Origin)>,
        mut nearer: impl FnMut(u32, f64),
    ) {
        for place in Arc::clone(&self.in_faces).in_face(halfedge / 3) {
            if let Some((value, origin)) = seen(frame.place(halfedge as usize % 3, place.weights)) {
                self.offer(place.point, value, origin, &mut nearer);
            }
        }
    }

    /// Offers the targets in a face straight lines from a root of value `value` there; `nearer` as for [`Self::see`].
    pub fn see_straight(
        &mut self,
        frame: &Frame,
        (face, from): (u32, [f64; 3]),
        (value, root): (f64, u32),
        mut nearer: impl FnMut(u32, f64),
    ) {
        for place in Arc::clone(&self.in_faces).in_face(face) {
            let [a, b] = [from, place.weights].map(|weights| frame.place(0, weights));
            let value = value + length(a[0] - b[0], a[1] - b[1]);
            self.offer(place.point, value, Origin::Straight { face, root }, &mut nearer);
        }
    }

    fn offer(&mut self, target: usize, value: f64, origin: Origin, nearer: &mut impl FnMut(u32, f64)) {
        if value < self.values[target] {
            self.values[target] = value;
            self.origins[target] = origin;
            nearer(target as u32, value);
        }
    }
}
