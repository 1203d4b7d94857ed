//! The ways of a crowd, for files.

use glam::DVec3;
use heatwalk::{Error, Place, descend};
use heatwalk_bindings::{Message, Result};
use wasm_bindgen::prelude::*;

use super::Solver;

/// Curves, one after another.
#[derive(Default, Message)]
pub struct Tracks {
    /// `#points × 3`, of all curves, in the unit and the axes of the file.
    pub points: Vec<f64>,
    /// `#curves`, how many points each has.
    pub counts: Vec<u32>,
}

#[wasm_bindgen]
impl Solver {
    /// The way of each walker of the crowd down the last field, from where it is to its source, in the order of the crowd.
    pub fn crowd_tracks(&self) -> Result<Tracks> {
        let Some(crowd) = &self.crowd else { return Ok(Tracks::default()) };
        let distance = self.shown_distance()?;
        let mut tracks = Tracks::default();
        for walker in crowd.walkers() {
            let place = Place::Face { face: walker.face, weights: walker.weights };
            let points: Vec<DVec3> = match descend(&self.shown, &distance, place) {
                Ok(path) => path.points.iter().map(|point| point.position).collect(),
                // Sources may have gone since it set out: it stands where it is.
                Err(Error::Unreachable) => vec![walker.position],
                Err(error) => return Err(error.into()),
            };
            tracks.counts.push(points.len() as u32);
            tracks.points.extend(points.into_iter().flat_map(|point| point.to_array()));
        }
        Ok(tracks)
    }
}
