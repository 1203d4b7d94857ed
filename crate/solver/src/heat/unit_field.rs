//! From heat to the right side of the Poisson equation: the unit field against the gradient of heat, and the gradient
//! of exact distance where that is known.

use crate::extremum::larger;
use crate::heat::exact_region::{ExactRegion, Touched};
use crate::heat::scale::scale;
use crate::operator::elements::{Element, Elements};

/// Integrated divergence, `#V`, of the field X that should be the gradient of distance: the gradient of exact distance in
/// triangles whose three corners are in the exact region, elsewhere −∇u / |∇u| of `heat`, zero where heat is constant.
/// Signed so that `L φ` equals it for ∇φ = X. With it the triangles that the region touches.
pub(super) fn divergence(elements: &Elements, heat: &[f64], region: &ExactRegion<'_>) -> (Vec<f64>, Vec<Touched>) {
    let mut divergence = vec![0.0; heat.len()];
    let mut touched = Vec::new();
    // A triangle where all heat is less than at every vertex of the region has none of them: no need to look.
    let least_inside = region.values().map(|(vertex, _)| heat[vertex as usize].abs()).fold(f64::INFINITY, f64::min);
    let mut around = Vec::new();
    for (index, (&face, shape)) in elements.faces.iter().zip(&elements.shapes).enumerate() {
        let [a, b, c] = face;
        let values = [heat[a as usize], heat[b as usize], heat[c as usize]];
        let largest = larger(larger(values[0].abs(), values[1].abs()), values[2].abs());
        if largest < least_inside {
            elements.add_divergence(index, against_gradient(shape, values, largest), &mut divergence);
        } else {
            around.push((index, largest));
        }
    }
    for (index, largest) in around {
        let (corners, shape) = (elements.faces[index], &elements.shapes[index]);
        let exact = corners.map(|vertex| region.value(vertex));
        if exact.iter().any(Option::is_some) {
            touched.push(Touched { corners, is_inside: exact.iter().all(Option::is_some) });
        }
        let part = match exact {
            [Some(a), Some(b), Some(c)] => along_distance(shape, [a, b, c]),
            _ => against_gradient(shape, corners.map(|vertex| heat[vertex as usize]), largest),
        };
        elements.add_divergence(index, part, &mut divergence);
    }
    (divergence, touched)
}

/// Divergence at corners 1 and 2 of the unit field against the gradient of heat, whose absolute values are at most
/// `largest`; that at corner 0 is minus their sum.
fn against_gradient(shape: &Element, heat: [f64; 3], largest: f64) -> [f64; 2] {
    let scale = scale(largest);
    let [a, b, c] = heat;
    let circulation = shape.circulation([a * scale, b * scale, c * scale]);
    let [x, y] = circulation;
    let length = (x * x + y * y).sqrt();
    let factor = if length > 0.0 { -0.5 / length } else { 0.0 };
    let [at_b, at_c] = shape.edge_products(circulation);
    [factor * at_b, factor * at_c]
}

/// Divergence at corners 1 and 2 of the gradient of distance; that at corner 0 is minus their sum.
fn along_distance(shape: &Element, [a, b, c]: [f64; 3]) -> [f64; 2] {
    let [cotan_a, cotan_b, cotan_c] = shape.cotans();
    let [ab, ac, bc] = [b - a, c - a, c - b];
    [0.5 * (cotan_c * ab - cotan_a * bc), 0.5 * (cotan_b * ac + cotan_a * bc)]
}
