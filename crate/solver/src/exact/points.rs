//! Points of the surface, beside its vertices, that searches come upon.

use heatwalk_surface::Place;

/// A point in one of the faces that it lies on.
#[derive(Debug, Clone)]
pub(crate) struct PointInFace {
    face: u32,
    /// Barycentric.
    pub weights: [f64; 3],
    /// Its number.
    pub point: usize,
}

/// Numbered points by the faces that they lie on.
#[derive(Debug, Clone, Default)]
pub(crate) struct PointsInFaces {
    /// In order of the faces.
    entries: Vec<PointInFace>,
}

impl PointsInFaces {
    /// `faces_at` tells the faces that a place lies on, with its weights in each.
    pub fn new(places: &[Place], faces_at: impl Fn(Place) -> Vec<(u32, [f64; 3])>) -> Self {
        let of_point = |(point, &place): (usize, &Place)| {
            faces_at(place).into_iter().map(move |(face, weights)| PointInFace { face, weights, point })
        };
        let mut entries: Vec<PointInFace> = places.iter().enumerate().flat_map(of_point).collect();
        entries.sort_unstable_by_key(|entry| (entry.face, entry.point));
        Self { entries }
    }

    /// Whether a face has any.
    #[inline(never)]
    pub fn are_in(&self, face: u32) -> bool {
        self.in_face(face).next().is_some()
    }

    /// Those of a face.
    pub fn in_face(&self, face: u32) -> impl Iterator<Item = &PointInFace> {
        let first = self.entries.partition_point(|entry| entry.face < face);
        self.entries[first..].iter().take_while(move |entry| entry.face == face)
    }
}
