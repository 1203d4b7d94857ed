//! The place of a surface that is nearest to a point in space.

use std::ops::Range;

use glam::DVec3;
use heatwalk_base::parallel;

use crate::bridges::nearest_on_triangle;
use crate::element::{Element, FaceId};
use crate::index::{Bounds, Tree, along_curve};
use crate::point::Place;
use crate::scale::scale;
use crate::surface::Surface;
use crate::triangle::{area_vector, length};

/// Triangles a leaf.
const LEAF: usize = 4;

/// Finds the places of a surface that are nearest to points in space.
#[derive(Debug, Clone)]
pub struct NearestPlaces {
    /// All faces, neighbours near each other.
    faces: Vec<FaceId>,
    tree: Tree<2, LEAF>,
    /// Of what is in the nodes, times the scale.
    bounds: Vec<Bounds>,
    /// By which all is measured, so that products of three lengths are numbers.
    scale: f64,
}

impl NearestPlaces {
    /// Of a surface, in n log n.
    #[must_use]
    pub fn new(surface: &Surface) -> Self {
        let middle = |face: usize| {
            let [a, b, c] = surface.corners(FaceId::from_index(face));
            (a + b + c) / 3.0
        };
        let order = along_curve(surface.face_count(), middle, parallel::ONE);
        let faces: Vec<FaceId> = order.into_iter().map(FaceId).collect();
        let tree = Tree::new(faces.len());
        let scale = scale(surface.bounding_radius());
        let of_leaf = |leaf: Range<usize>| {
            Bounds::of_points(faces[leaf].iter().flat_map(|&face| scaled(surface.corners(face), scale)))
        };
        let bounds = tree.values(of_leaf, Bounds::around);
        Self { faces, tree, bounds, scale }
    }

    /// The place of their surface that is nearest to a point, and how far that is, in the file's unit; a vertex or on an edge
    /// where it is at one. None for a point that is not finite, or so far away that the square of its distance is not.
    #[must_use]
    pub fn nearest(&self, surface: &Surface, point: DVec3) -> Option<(Place, f64)> {
        let mut best = None;
        let [point] = scaled([point], self.scale);
        let at = Bounds::at(point);
        self.tree.nearest(
            f64::INFINITY,
            |node| self.bounds[node].squared_distance(at),
            |leaf, bound| {
                self.faces[leaf].iter().fold(bound, |bound, &face| {
                    let corners = scaled(surface.corners(face), self.scale);
                    let weights = nearest_on_triangle(point, &corners, area_vector(corners));
                    let nearest: DVec3 = corners.iter().zip(weights).map(|(&corner, weight)| corner * weight).sum();
                    let squared = nearest.distance_squared(point);
                    if squared < bound {
                        best = Some((Place::Face { face, weights }, nearest));
                        return squared;
                    }
                    bound
                })
            },
        );
        best.map(|(place, nearest)| (place.snapped(surface), length(nearest - point) / self.scale))
    }
}

fn scaled<const N: usize>(points: [DVec3; N], scale: f64) -> [DVec3; N] {
    points.map(|point| point * scale)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_xoshiro::SplitMix64;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;
    use crate::element::VertexId;
    use crate::soup::Soup;

    #[test]
    fn the_nearest_place_is_that_of_all_triangles() {
        let mut random = SplitMix64::seed_from_u64(4);
        let mut point = || DVec3::from_array(random.random());
        let positions: Vec<DVec3> = (0..120).map(|_| point()).collect();
        let triangles = (0..40).map(|triangle| [3 * triangle, 3 * triangle + 1, 3 * triangle + 2]).collect();
        let surface = Surface::build(&Soup::single("triangles", positions, triangles)).unwrap();
        let places = NearestPlaces::new(&surface);
        for _ in 0..200 {
            let from = point() * 2.0;
            let (place, distance) = places.nearest(&surface, from).unwrap();
            let each = surface.faces().ids().map(|face| {
                let corners = surface.corners(face);
                let [a, b, c] = nearest_on_triangle(from, &corners, area_vector(corners));
                (corners[0] * a + corners[1] * b + corners[2] * c).distance(from)
            });
            // The sum of three weights misses 1 by rounding.
            assert!((each.fold(f64::INFINITY, f64::min) - distance).abs() < 1e-14);
            assert!((place.position(&surface).distance(from) - distance).abs() < 1e-9);
        }
        for factor in [1e-120, 1e120] {
            let positions = [DVec3::ZERO, DVec3::X, DVec3::Y].map(|corner| corner * factor).to_vec();
            let surface = Surface::build(&Soup::single("triangle", positions, vec![[0, 1, 2]])).unwrap();
            let found = NearestPlaces::new(&surface).nearest(&surface, DVec3::new(0.25, 0.25, 2.0) * factor);
            let (Place::Face { weights, .. }, distance) = found.unwrap() else { panic!("inside of the triangle") };
            assert!((weights[0] - 0.5).abs() < 1e-14 && (distance / factor - 2.0).abs() < 1e-14);
        }
        let vertex = VertexId(7);
        assert_eq!(places.nearest(&surface, surface.position(vertex)), Some((Place::Vertex(vertex), 0.0)));
        assert_eq!(places.nearest(&surface, DVec3::NAN), None);
    }
}
