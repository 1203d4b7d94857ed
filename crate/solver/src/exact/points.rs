//! Points of the surface, beside its vertices, that searches come upon.

use heatwalk_base::sort;
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
    /// A bit for each face up to the last one that has any.
    occupied: Vec<u64>,
}

impl PointsInFaces {
    /// `faces_at` tells the faces that a place lies on, with its weights in each.
    pub fn new(places: &[Place], faces_at: impl Fn(Place) -> Vec<(u32, [f64; 3])>) -> Self {
        let of_point = |(point, &place): (usize, &Place)| {
            faces_at(place).into_iter().map(move |(face, weights)| PointInFace { face, weights, point })
        };
        let mut entries: Vec<PointInFace> = places.iter().enumerate().flat_map(of_point).collect();
        sort::sort_by_key(&mut entries, |entry| (entry.face, entry.point));
        let faces = entries.last().map_or(0, |last| last.face as usize + 1);
        let mut occupied = vec![0; faces.div_ceil(64)];
        for entry in &entries {
            occupied[entry.face as usize / 64] |= 1 << (entry.face % 64);
        }
        Self { entries, occupied }
    }

    /// Whether a face has any.
    #[inline(always)]
    pub fn are_in(&self, face: u32) -> bool {
        self.occupied.get(face as usize / 64).is_some_and(|bits| bits >> (face % 64) & 1 == 1)
    }

    /// Those of a face.
    pub fn in_face(&self, face: u32) -> impl Iterator<Item = &PointInFace> {
        let own = if self.are_in(face) { &self.entries[..] } else { &[] };
        let first = own.partition_point(|entry| entry.face < face);
        own[first..].iter().take_while(move |entry| entry.face == face)
    }
}
