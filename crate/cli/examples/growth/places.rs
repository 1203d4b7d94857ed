//! Many sources in one place of a curved surface, and many places.

use std::sync::Arc;

use anyhow::{Context, Error, Result};
use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{DistanceOptions, DistanceSolver, Element, FaceId, Method, Place, Soup, Surface, VertexId, go_on};
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

/// Surfaces by their names on which exact distances of vertices take little time.
pub const QUICK: [&str; 4] = ["terrain", "ladder", "hub", "wavy hub"];

/// Exact distances from a vertex, of as many places as there are faces.
pub fn in_faces(soup: &Soup) -> Result<Operation> {
    let mut solver = DistanceSolver::new(Surface::build(soup)?);
    let source = Place::Vertex(VertexId(1));
    let answer = solver.distance(&[source], &DistanceOptions::by(Method::Exact), &mut go_on)?;
    let faces = (0..solver.surface().face_count()).map(FaceId::from_index);
    let places: Vec<Place> = faces.map(|face| Place::Face { face, weights: [0.3, 0.3, 0.4] }).collect();
    does(move || solver.place_distances(&answer)?.context("all is exact")?.at_all(&places).map_err(Error::from))
}
