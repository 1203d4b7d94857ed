//! From heat to the right side of the Poisson equation: the unit field against the gradient of heat, −∇u / |∇u|, zero where heat is
//! constant (Crane and others 2013, algorithm 1), and the gradient of exact distance where that is known.

use std::ops::Range;

use heatwalk_surface::scale::scale;

use crate::extremum::larger;
use crate::heat::field::RightSide;
use crate::heat::region::ExactRegion;
use crate::operator::elements::{BLOCK, Element, Elements};

/// Of the field X that should be the gradient of distance: the gradient of exact distance in triangles whose three corners are in the
/// exact region, elsewhere the unit field of `heat`.
pub(super) fn right_side(elements: &Elements, heat: &[f64], region: &ExactRegion<'_>) -> RightSide {
    let mut divergence = vec![0.0; heat.len()];
    let mut touched = Vec::new();
    // A triangle where all heat is less than at every vertex of the region has none of them: no need to look.
    let least_inside = region.values().map(|(vertex, _)| heat[vertex as usize].abs()).fold(f64::INFINITY, f64::min);
    let mut around = Vec::new();
    let count = elements.faces.len();
    for first in (0..count).step_by(BLOCK) {
        let block = first..count.min(first + BLOCK);
        let parts = against_gradient(elements, heat, block.clone());
        for (triangle, part) in block.zip(parts) {
            let heat = elements.faces[triangle].map(|vertex| heat[vertex as usize].abs());
            if larger(larger(heat[0], heat[1]), heat[2]) < least_inside {
                elements.add_divergence(triangle, part, &mut divergence);
            } else {
                around.push((triangle, part));
            }
        }
    }
    for (triangle, part) in around {
        let corners = elements.faces[triangle];
        let exact = corners.map(|vertex| region.value(vertex));
        if exact.iter().any(Option::is_some) {
            touched.push((corners, exact.iter().all(Option::is_some)));
        }
        let part = match exact {
            [Some(a), Some(b), Some(c)] => along_distance(&elements.shapes[triangle], [a, b, c]),
            _ => part,
        };
        elements.add_divergence(triangle, part, &mut divergence);
    }
    RightSide { divergence, rims: region.rims(touched) }
}

/// Divergence at corners 1 and 2 of the unit field against the gradient of heat in a block of triangles; that at corner 0 is minus
/// their sum.
fn against_gradient(elements: &Elements, heat: &[f64], block: Range<usize>) -> [[f64; 2]; BLOCK] {
    let mut products = [[0.0; 2]; BLOCK];
    let mut squares = [1.0; BLOCK];
    for (place, triangle) in block.enumerate() {
        let shape = &elements.shapes[triangle];
        let heat = elements.faces[triangle].map(|vertex| heat[vertex as usize]);
        let scale = scale(larger(larger(heat[0].abs(), heat[1].abs()), heat[2].abs()));
        let circulation = shape.circulation(heat.map(|value| scale * value));
        let [x, y] = circulation;
        products[place] = shape.edge_products(circulation);
        // Where heat is constant the products are 0 whatever divides them.
        squares[place] = x * x + y * y + f64::MIN_POSITIVE;
    }
    let factors = squares.map(|square| -0.5 / square.sqrt());
    std::array::from_fn(|place| products[place].map(|product| factors[place] * product))
}

/// Divergence at corners 1 and 2 of the gradient of distance; that at corner 0 is minus their sum.
fn along_distance(shape: &Element, [a, b, c]: [f64; 3]) -> [f64; 2] {
    let [cotan_a, cotan_b, cotan_c] = shape.cotans();
    let [ab, ac, bc] = [b - a, c - a, c - b];
    [0.5 * (cotan_c * ab - cotan_a * bc), 0.5 * (cotan_b * ac + cotan_a * bc)]
}
