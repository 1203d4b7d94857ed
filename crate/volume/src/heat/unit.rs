//! The unit field against the gradient of heat, one vector a tetrahedron (Crane and others 2013, algorithm 1).

use glam::DVec3;
use heatwalk::heat::{ExactRegion, RightSide};
use heatwalk::surface::scale::scale;

use crate::heat::elements::Element;
use crate::march::Medium;
use crate::mesh::{TetId, TetMesh};

/// Tetrahedra whose lengths are divided by together: one by one, each would wait for the root and the division before.
const BLOCK: usize = 16;

/// Of the field that should be the gradient of distance: that of exact distance in tetrahedra whose corners are all in the region,
/// elsewhere of length w against the gradient of heat, as the metric w² g has it, and zero where heat is constant.
pub(super) fn right_side(mesh: &TetMesh, medium: &Medium, heat: &[f64], region: &ExactRegion<'_>) -> RightSide {
    let mut divergence = vec![0.0; mesh.vertex_count()];
    let mut touched = Vec::new();
    for (block, tetrahedra) in mesh.tetrahedra().chunks(BLOCK).enumerate() {
        let mut shapes = [Element::default(); BLOCK];
        let mut vectors = [DVec3::ZERO; BLOCK];
        // Squared lengths that divide them.
        let mut squares = [1.0; BLOCK];
        for (place, corners) in tetrahedra.iter().enumerate() {
            let tetrahedron = (block * BLOCK + place) as u32;
            let cost = medium.cost(tetrahedron);
            if cost.is_infinite() {
                continue;
            }
            let shape = Element::of(mesh.corners(TetId(tetrahedron)));
            shapes[place] = shape;
            let exact = corners.map(|vertex| region.value(vertex));
            if exact.iter().any(Option::is_some) {
                touched.push((*corners, exact.iter().all(Option::is_some)));
            }
            // The stiffness of w² g is w times that of g.
            if let [Some(a), Some(b), Some(c), Some(d)] = exact {
                vectors[place] = cost * shape.gradient([a, b, c, d]);
                continue;
            }
            let heat = corners.map(|vertex| heat[vertex as usize]);
            let sum: f64 = heat.iter().map(|value| value.abs()).sum();
            let scale = scale(sum);
            let gradient = shape.gradient(heat.map(|value| scale * value));
            vectors[place] = -cost * cost * gradient;
            // Where heat is constant the vector is 0 whatever divides it.
            squares[place] = gradient.length_squared() + f64::MIN_POSITIVE;
        }
        let factors = squares.map(|square| 1.0 / square.sqrt());
        for (((corners, shape), vector), factor) in tetrahedra.iter().zip(&shapes).zip(vectors).zip(factors) {
            for (&vertex, part) in corners.iter().zip(shape.divergence(factor * vector)) {
                divergence[vertex as usize] += part;
            }
        }
    }
    RightSide { divergence, rims: region.rims(touched) }
}
