//! The crowd as the page has it.

use std::sync::Arc;

use heatwalk::{Result, Surface};
use heatwalk_scene::Crowd;

/// Height of a walker in bounding radii of the surface: seen from afar, and small enough for thousands.
const HEIGHT: f64 = 0.03;
/// The same walkers start at the same places whenever a mesh is opened.
const SEED: u64 = 1;

/// A new crowd of `count` walkers.
pub fn crowd(surface: &Arc<Surface>, count: u32) -> Result<Crowd> {
    Crowd::new(Arc::clone(surface), count as usize, HEIGHT * surface.bounding_radius(), SEED)
}
