//! Portals, as searches cross them: what reaches one end starts anew at the other, farther by the gap.

use std::sync::Arc;

use heatwalk_surface::{Bridges, Place};

use super::points::PointsInFaces;
use crate::distance::PortalCrossing;

/// The ends of all portals: those of portal `i` are ends `2 i` and `2 i + 1`.
#[derive(Debug, Clone, Default)]
pub(crate) struct Portals {
    places: Vec<Place>,
    gaps: Vec<f64>,
    in_faces: Arc<PointsInFaces>,
}

impl Portals {
    /// Of bridges between components. `faces_at` tells the faces that a place lies on, with its weights in each.
    pub fn new(bridges: &Bridges, faces_at: impl Fn(Place) -> Vec<(u32, [f64; 3])>) -> Self {
        let places: Vec<Place> = bridges.portals().iter().flat_map(|portal| portal.ends).collect();
        let in_faces = PointsInFaces::new(&places, faces_at);
        let gaps = bridges.portals().iter().map(|portal| portal.gap).collect();
        Self { places, gaps, in_faces: Arc::new(in_faces) }
    }

    /// The same with gaps so many times as large.
    pub fn scaled(mut self, factor: f64) -> Self {
        self.gaps.iter_mut().for_each(|gap| *gap *= factor);
        self
    }

    /// Where the ends are.
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// The ends by face.
    pub fn in_faces(&self) -> &Arc<PointsInFaces> {
        &self.in_faces
    }

    /// What crossing from an end costs.
    pub fn gap(&self, end: u32) -> f64 {
        self.gaps[end as usize / 2]
    }

    /// The portals that are crossed, where `entered` tells the distance at each end that is reached through its portal.
    pub fn crossings(&self, entered: impl Fn(u32) -> Option<f64>) -> Vec<PortalCrossing> {
        let place = |end: u32| self.places[end as usize];
        let crossing = |end| {
            let distance = entered(end)?;
            Some(PortalCrossing { from: place(end), to: place(Self::across(end)), distance })
        };
        (0..self.places.len() as u32).filter_map(crossing).collect()
    }

    /// The other end of an end's portal.
    pub fn across(end: u32) -> u32 {
        end ^ 1
    }
}
