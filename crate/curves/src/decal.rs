//! Decals: an image laid on a surface by the log map around a place (Schmidt, Grimm, Wyvill, "Interactive decal compositing with
//! discrete exponential maps", 2006), here an exact one.

use std::collections::VecDeque;

use glam::DVec2;
use heatwalk_surface::triangle;

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

/// A corner of a part: weights, and the place in the image from −1 to 1 to the right and upward.
#[derive(Clone, Copy)]
struct Corner {
    weights: [f64; 3],
    place: DVec2,
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
        patches.extend(parts.into_iter().map(|corners| Patch {
            triangle: index as u32,
            corners: corners.map(|corner| corner.weights),
            image: corners.map(|Corner { place, .. }| DVec2::new(1.0 + place.x, 1.0 - place.y) / 2.0),
        }));
        open.extend((0..3).filter_map(|k| surface.twin(3 * index + k)).map(|halfedge| halfedge / 3));
    }
    patches
}

/// Whether the map neither folds a triangle nor tears it.
fn is_laid(surface: &Field, index: usize, [a, b, c]: [DVec2; 3]) -> bool {
    let corners = surface.corners(index);
    let [p, q, r] = corners;
    let is_torn = |image: DVec2, side| !(image.length() <= TORN * triangle::length(side));
    let area = triangle::length(triangle::area_vector(corners));
    !is_torn(b - a, q - p)
        && !is_torn(c - b, r - q)
        && !is_torn(a - c, p - r)
        && (b - a).perp_dot(c - a) >= -FLAT * area
}

/// The part of a triangle within the square from −1 to 1, as triangles (Sutherland and Hodgman, "Reentrant polygon clipping", 1974).
fn within(places: [DVec2; 3]) -> Vec<[Corner; 3]> {
    let corner = |k: usize| Corner { weights: std::array::from_fn(|i| f64::from(u8::from(i == k))), place: places[k] };
    let mut polygon = vec![corner(0), corner(1), corner(2)];
    for side in [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y] {
        let beyond = |corner: &Corner| side.dot(corner.place) - 1.0;
        if polygon.iter().all(|corner| beyond(corner) <= 0.0) {
            continue;
        }
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        for (index, &to) in polygon.iter().enumerate() {
            let from = polygon[(index + polygon.len() - 1) % polygon.len()];
            let (before, after) = (beyond(&from), beyond(&to));
            if (before > 0.0) != (after > 0.0) {
                let share = before / (before - after);
                let weights = std::array::from_fn(|k| from.weights[k] + share * (to.weights[k] - from.weights[k]));
                kept.push(Corner { weights, place: from.place.lerp(to.place, share) });
            }
            if after <= 0.0 {
                kept.push(to);
            }
        }
        polygon = kept;
        if polygon.len() < 3 {
            return Vec::new();
        }
    }
    (1..polygon.len() - 1).map(|k| [polygon[0], polygon[k], polygon[k + 1]]).collect()
}
