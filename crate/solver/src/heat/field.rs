//! From heat to the right side of the Poisson equation: the unit field against the gradient of heat, and the gradient
//! of exact distance where that is known.

use crate::extremum::larger;
use crate::heat::near::Near;
use crate::operator::elements::{Element, Elements};

/// Stored bits of a float's mantissa, below those of its exponent.
const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS - 1;

/// The sum of the stored exponents of a power of two and its inverse.
const TWICE_BIAS: u64 = 2 * (f64::MAX_EXP as u64 - 1);

/// Integrated divergence, `#P`, of the field X that should be the gradient of distance: the gradient of `near` in
/// triangles whose three corners are known there, elsewhere −∇u / |∇u| of `heat`, zero where heat is constant. Signed
/// so that `L φ` equals it for ∇φ = X. `mixed` is told each triangle of which some corners are near, with whether all
/// are.
pub(super) fn divergence(
    elements: &Elements,
    heat: &[f64],
    near: &Near<'_>,
    mut mixed: impl FnMut([u32; 3], bool),
) -> Vec<f64> {
    let mut divergence = vec![0.0; heat.len()];
    let mut add = |index: usize, [at_b, at_c]: [f64; 2]| {
        let ([a, b, c], share) = (elements.faces[index], elements.share(index));
        divergence[a as usize] -= share * (at_b + at_c);
        divergence[b as usize] += share * at_b;
        divergence[c as usize] += share * at_c;
    };
    // A triangle where all heat is less than at every near point has none of them: no need to look.
    let least_near = near.points().map(|(point, _)| heat[point as usize].abs()).fold(f64::INFINITY, f64::min);
    let mut around = Vec::new();
    for (index, (&face, shape)) in elements.faces.iter().zip(&elements.shapes).enumerate() {
        let [a, b, c] = face;
        let values = [heat[a as usize], heat[b as usize], heat[c as usize]];
        let largest = larger(larger(values[0].abs(), values[1].abs()), values[2].abs());
        if largest < least_near {
            add(index, against_gradient(shape, values, largest));
        } else {
            around.push((index, largest));
        }
    }
    for (index, largest) in around {
        let (face, shape) = (elements.faces[index], &elements.shapes[index]);
        let known = face.map(|point| near.at(point));
        if known.iter().any(Option::is_some) {
            mixed(face, known.iter().all(Option::is_some));
        }
        add(
            index,
            match known {
                [Some(a), Some(b), Some(c)] => along_distance(shape, [a, b, c]),
                _ => against_gradient(shape, face.map(|point| heat[point as usize]), largest),
            },
        );
    }
    divergence
}

/// Divergence at corners 1 and 2 of the unit field against the gradient of heat, whose absolute values are at most
/// `largest`; that at corner 0 is minus their sum.
fn against_gradient(shape: &Element, heat: [f64; 3], largest: f64) -> [f64; 2] {
    // Heat falls by hundreds of orders of magnitude over the surface; only ratios within the face matter. A power of
    // two takes no division.
    let exponent = largest.to_bits() >> MANTISSA_BITS;
    let scale = f64::from_bits(TWICE_BIAS.saturating_sub(exponent) << MANTISSA_BITS);
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
