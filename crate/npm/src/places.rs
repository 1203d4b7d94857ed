//! Places as JavaScript gives them, and in its words.

use glam::DVec3;
use heatwalk::surface::PathPoint;
use heatwalk::{FaceId, InputPlace, Path, Place, Source, SurfacePoint};
use heatwalk_bindings::{Failure, Message, Result};
use js_sys::Object;
use wasm_bindgen::prelude::*;

use crate::given::{numbers, property};
use crate::mesh::Mesh;
use crate::vectors::{coordinates, points, require_one_each};

/// Numbers of a place: its kind and four more.
const PER_PLACE: usize = 5;

/// Places on faces, with their points.
#[derive(Message)]
pub struct Places {
    /// Of each its face.
    pub faces: Vec<u32>,
    /// Three of each: of the corners of its face, of sum 1.
    pub weights: Vec<f64>,
    /// Three coordinates of each.
    pub points: Vec<f64>,
}

/// Places that are nearest to points in space.
#[derive(Message)]
pub struct Snapped {
    /// Of each its face.
    pub faces: Vec<u32>,
    /// Three of each: of the corners of its face, of sum 1.
    pub weights: Vec<f64>,
    /// Three coordinates of each.
    pub points: Vec<f64>,
    /// How far each is from its point.
    pub distances: Vec<f64>,
}

#[wasm_bindgen]
impl Mesh {
    /// The places that are nearest to points in space, three coordinates each, and how far they are.
    pub fn snap(&self, wanted: &[f64]) -> Result<Snapped> {
        let found = points(wanted).map(|point| self.nearest_to(point)).collect::<Result<Vec<_>>>()?;
        let Places { faces, weights, points } = self.told_places(found.iter().map(|&(place, _)| place));
        Ok(Snapped { faces, weights, points, distances: found.iter().map(|&(_, distance)| distance).collect() })
    }
}

impl Mesh {
    /// The points of the surface at places: five numbers each, 0 and a vertex; 1, a face and three weights; or 2 and the coordinates of a
    /// point in space, whose nearest place it is.
    pub(crate) fn points(&self, places: &[f64]) -> Result<Vec<SurfacePoint>> {
        let place = |&[kind, first, a, b, c]: &[f64; PER_PLACE]| {
            let place = match kind as u8 {
                0 => InputPlace::Vertex(first as usize),
                1 => InputPlace::Triangle { triangle: first as usize, weights: [a, b, c] },
                _ => {
                    return self
                        .nearest_to(DVec3::new(first, a, b))
                        .and_then(|(place, _)| Ok(self.surface().point(place)?));
                }
            };
            Ok(place.on(self.soup(), self.surface())?)
        };
        places.as_chunks().0.iter().map(place).collect()
    }

    /// The only one of places.
    pub(crate) fn point(&self, place: &[f64]) -> Result<SurfacePoint> {
        let point = self.points(place)?.into_iter().next();
        point.ok_or_else(|| Failure::of("bad-place", "no place is given"))
    }

    /// Sources, with the distances `initial` that they start from where options have such.
    pub(crate) fn sources(&self, places: &[f64], options: &Object) -> Result<Vec<Source>> {
        let points = self.points(places)?;
        let Some(initial) = property(options, "initial") else {
            return Ok(points.into_iter().map(Source::from).collect());
        };
        let initial = numbers(&initial);
        require_one_each(points.len(), initial.len(), "initial distances")?;
        points.into_iter().zip(initial).map(|(point, initial)| Ok(self.surface().source(point, initial)?)).collect()
    }

    /// Places on faces in the words of the caller.
    pub(crate) fn told(&self, places: impl Iterator<Item = (Place, FaceId)>) -> Places {
        let mut told = Places { faces: Vec::new(), weights: Vec::new(), points: Vec::new() };
        for (place, face) in places {
            let (triangle, weights) = InputPlace::within(place, face, self.soup(), self.surface());
            told.faces.push(triangle as u32);
            told.weights.extend(weights);
            told.points.extend(place.position(self.surface()).to_array());
        }
        told
    }

    /// As [`Self::told`], each on some face.
    pub(crate) fn told_places(&self, places: impl Iterator<Item = Place>) -> Places {
        self.told(places.map(|place| (place, place.faces(self.surface())[0])))
    }

    /// The points of a path in the words of the caller.
    pub(crate) fn told_path(&self, path: &Path) -> Places {
        let points = coordinates(path.points.iter().map(|point| point.position));
        let on = |point: &PathPoint| (point.location, point.face);
        Places { points, ..self.told(path.points.iter().map(on)) }
    }
}
