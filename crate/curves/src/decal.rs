//! Decals: an image laid on a surface by the log map around a place (Schmidt, Grimm, Wyvill, "Interactive decal compositing with
//! discrete exponential maps", 2006), here an exact one.

use std::collections::VecDeque;

use glam::DVec2;
use heatwalk_surface::triangle;

use crate::clip::{WHOLE, below, fan};
use crate::field::Field;

/// Where an edge is so many times as long in the image as on the surface, the map is torn there: its ends are reached around
/// different sides of something.
const TORN: f64 = 4.0;

/// Below this share of a triangle's area on the surface, an area in the image is rounding.
const FLAT: f64 = 1e-9;

/// A part of a triangle that an image covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// The triangle of the surface.
    pub triangle: u32,
    /// The weights of its corners at those of the part, in its orientation.
    pub corners: [[f64; 3]; 3],
    /// Where these are in the image: from 0 to 1 to the right, and from 0 to 1 down.
    pub image: [DVec2; 3],
}

/// What an image covers that reaches `half` to the right and upward of the middle of a log map. `coordinates`: that of each vertex, not
/// numbers where it is not known; u is to the right. It goes on from the triangle `start`, in which the middle is, as far as the map
/// neither folds nor is torn.
///
/// # Panics
/// Where there is not one pair of coordinates a vertex.
pub fn decal(surface: &Field, coordinates: &[DVec2], start: u32, half: DVec2) -> Vec<Patch> {
    assert_eq!(coordinates.len(), surface.positions().len(), "one pair a vertex");
    let triangles = surface.triangles();
    let mut is_seen = vec![false; triangles.len()];
    let mut patches = Vec::new();
    let mut open = VecDeque::from([start as usize]);
    while let Some(index) = open.pop_front() {
        if std::mem::replace(&mut is_seen[index], true) {
            continue;
        }
        let image = triangles[index].map(|vertex| coordinates[vertex as usize]);
        if !is_laid(surface, index, image) {
            continue;
        }
        let parts = within(image.map(|place| place / half));
        if parts.is_empty() {
            continue;
        }
        let place = |weights: [f64; 3]| (0..3).map(|k| weights[k] * image[k] / half).sum::<DVec2>();
        patches.extend(fan(&parts).map(|corners| Patch {
            triangle: index as u32,
            corners,
            image: corners.map(place).map(|place| DVec2::new(1.0 + place.x, 1.0 - place.y) / 2.0),
        }));
        open.extend((0..3).filter_map(|k| surface.twin(3 * index + k)).map(|halfedge| halfedge / 3));
    }
    patches
}

/// Whether the map neither folds a triangle nor tears it.
fn is_laid(surface: &Field, index: usize, [a, b, c]: [DVec2; 3]) -> bool {
    let corners = surface.corners(index);
    let [p, q, r] = corners;
    let is_torn = |image: DVec2, side| image.is_nan() || image.length() > TORN * triangle::length(side);
    let area = triangle::length(triangle::area_vector(corners));
    !is_torn(b - a, q - p)
        && !is_torn(c - b, r - q)
        && !is_torn(a - c, p - r)
        && (b - a).perp_dot(c - a) >= -FLAT * area
}

/// The part of a triangle within the square from −1 to 1, as weights of its corners.
fn within(places: [DVec2; 3]) -> Vec<[f64; 3]> {
    let sides = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y];
    sides.into_iter().fold(WHOLE.to_vec(), |part, side| below(&part, places.map(|place| side.dot(place) - 1.0)))
}
