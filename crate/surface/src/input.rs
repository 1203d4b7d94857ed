//! Places in the words of the input: its vertices and triangles, with the corners of these in its order.

use crate::element::{Element, FaceId, InputTriangle, InputVertex};
use crate::error::{Error, Result};
use crate::point::{Place, SurfacePoint};
use crate::soup::Soup;
use crate::surface::Surface;

/// A place on the triangles of a [`Soup`], as a caller gives it: it may not be there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InputPlace {
    /// A vertex, counted from 0.
    Vertex(usize),
    /// A point of a triangle.
    Triangle {
        /// Counted from 0.
        triangle: usize,
        /// Barycentric weights of its corners, in the order of the soup, non-negative, of sum 1.
        weights: [f64; 3],
    },
}

impl InputPlace {
    /// Fails early, before a surface is built, for a vertex or a triangle that does not exist.
    ///
    /// # Errors
    /// [`Error::NoSuchVertex`], [`Error::NoSuchTriangle`].
    pub fn check(self, soup: &Soup) -> Result<()> {
        let (vertices, triangles) = (soup.positions.len(), soup.triangles.len());
        match self {
            Self::Vertex(vertex) if vertex >= vertices => Err(Error::NoSuchVertex { vertex, vertices }),
            Self::Triangle { triangle, .. } if triangle >= triangles => {
                Err(Error::NoSuchTriangle { triangle, triangles })
            }
            Self::Vertex(_) | Self::Triangle { .. } => Ok(()),
        }
    }

    /// The point of the surface of a soup.
    ///
    /// # Errors
    /// As [`Self::check`]; [`Error::UnreferencedVertex`], [`Error::InactiveTriangle`], [`Error::DroppedTriangle`];
    /// [`Error::BadWeights`], with the number of the triangle.
    pub fn on(self, soup: &Soup, surface: &Surface) -> Result<SurfacePoint> {
        self.check(soup)?;
        let (triangle, weights) = match self {
            Self::Vertex(vertex) => return surface.point(InputVertex::from_index(vertex)),
            Self::Triangle { triangle, weights } => (triangle, weights),
        };
        let face = surface.require_face(soup, triangle)?;
        // The face may have been flipped.
        let corners = soup.triangles[triangle];
        let weight_of = |input: InputVertex| {
            let k = corners.iter().position(|&corner| corner == input.0);
            weights[k.unwrap_or(2)]
        };
        let place = Place::Face { face, weights: surface.inputs_of_face(face).map(weight_of) };
        surface.point(place).map_err(|error| match error {
            // In the words of the input.
            Error::BadWeights { .. } => Error::BadWeights { face: triangle, weights },
            error => error,
        })
    }

    /// A place of the surface of a soup that is on this face: a vertex where it is one.
    #[must_use]
    pub fn of(place: Place, face: FaceId, soup: &Soup, surface: &Surface) -> Self {
        match place {
            Place::Vertex(vertex) => Self::Vertex(surface.inputs_of_vertex(vertex)[0].index()),
            Place::Edge { .. } | Place::Face { .. } => {
                let (triangle, weights) = Self::within(place, face, soup, surface);
                Self::Triangle { triangle, weights }
            }
        }
    }

    /// The triangle of the input that a face was, and the weights there of a place on it.
    #[must_use]
    pub fn within(place: Place, face: FaceId, soup: &Soup, surface: &Surface) -> (usize, [f64; 3]) {
        let triangle = surface.triangle_of_face(face).index();
        let (inputs, weights) = (surface.inputs_of_face(face), place.weights_in(surface, face));
        let weight_of = |corner: u32| {
            let k = inputs.iter().position(|input| input.0 == corner);
            // Without the sign of a zero.
            k.map_or(0.0, |k| weights[k]) + 0.0
        };
        (triangle, soup.triangles[triangle].map(weight_of))
    }
}

impl Surface {
    /// The face that a triangle of its soup became, where there has to be one.
    ///
    /// # Errors
    /// [`Error::NoSuchTriangle`], [`Error::InactiveTriangle`], [`Error::DroppedTriangle`].
    pub fn require_face(&self, soup: &Soup, triangle: usize) -> Result<FaceId> {
        let triangles = soup.triangles.len();
        if triangle >= triangles {
            return Err(Error::NoSuchTriangle { triangle, triangles });
        }
        self.face_of_triangle(InputTriangle::from_index(triangle)).ok_or_else(|| {
            let is_active = soup.ranges().iter().any(|range| range.contains(&triangle));
            if is_active { Error::DroppedTriangle { triangle } } else { Error::InactiveTriangle { triangle } }
        })
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn places_keep_the_order_of_corners_of_the_input_where_triangles_are_flipped() {
        let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y];
        // Both turn the same way along their edge, so one of them is flipped; the last has no area.
        let soup = Soup::single("square", positions, vec![[0, 1, 2], [1, 2, 3], [0, 1, 1]]);
        let surface = Surface::build(&soup).unwrap();
        assert_eq!(surface.report().flipped_faces, 1);
        for triangle in 0..2 {
            let given = InputPlace::Triangle { triangle, weights: [0.5, 0.25, 0.25] };
            let place = given.on(&soup, &surface).unwrap().place();
            let corners = soup.triangles[triangle].map(|corner| soup.positions[corner as usize]);
            assert_eq!(place.position(&surface), corners[0] * 0.5 + (corners[1] + corners[2]) * 0.25);
            assert_eq!(InputPlace::of(place, place.faces(&surface)[0], &soup, &surface), given);
        }
        let refused = |triangle| InputPlace::Triangle { triangle, weights: [1.0, 0.0, 0.0] }.on(&soup, &surface);
        assert_eq!(refused(2), Err(Error::DroppedTriangle { triangle: 2 }));
        assert_eq!(refused(3), Err(Error::NoSuchTriangle { triangle: 3, triangles: 3 }));
    }
}
