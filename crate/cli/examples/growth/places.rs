//! Many sources in one place of a curved surface.

use std::sync::Arc;

use anyhow::Result;
use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{FaceId, Place, Soup, Surface};
use heatwalk_shapes as shapes;

use crate::{Operation, does};

/// Where so many sources are by the name of that, on which surface, and each by its number and how many there are.
pub type Family = (&'static str, fn() -> Soup, fn(usize, usize) -> Place);

pub const FAMILIES: [Family; 4] = [
    ("places on an edge of a sphere", sphere, on_edge),
    ("places on an edge of a terrain", terrain, on_edge),
    ("places across a face of a sphere", sphere, across_face),
    ("places across a face of a terrain", terrain, across_face),
];

/// Their face.
const FACE: FaceId = FaceId(100);

fn sphere() -> Soup {
    shapes::icosphere(3)
}

fn terrain() -> Soup {
    shapes::terrain(25)
}

fn on_edge(number: usize, count: usize) -> Place {
    Place::Edge { halfedge: FACE.halfedge(0), fraction: share(number, count) }
}

fn across_face(number: usize, count: usize) -> Place {
    let along = 0.7 * share(number, count);
    Place::Face { face: FACE, weights: [0.1 + along, 0.2, 0.7 - along] }
}

fn share(number: usize, count: usize) -> f64 {
    (number as f64 + 0.5) / count as f64
}

/// Exact distances from so many places.
pub fn exact(count: usize, (_, soup, place): Family) -> Result<Operation> {
    let geometry = Arc::new(ExactGeometry::new(Surface::build(&soup())?));
    let places: Vec<Place> = (0..count).map(|number| place(number, count)).collect();
    does(move || {
        let mut wavefront = Wavefront::new(geometry, &places)?;
        wavefront.advance(f64::INFINITY, usize::MAX)?;
        anyhow::Ok(wavefront.into_values())
    })
}
