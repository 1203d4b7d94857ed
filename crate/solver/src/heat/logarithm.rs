//! The field of the logarithm of heat: −√(t + c) ∇log u, no longer than 1, and on a bumpy surface than somewhat less.
//!
//! Distance is the limit of −√t log u for short times (Varadhan, "On the behavior of the fundamental solution of the heat
//! equation with variable coefficients", 1967). Heat falls exponentially, so that its logarithm is what is nearly linear in a
//! triangle: it points along distance where the gradient of heat leans towards the warmest corner. Where heat arrives from
//! two sides it falls more slowly, as the mean of distance does in a triangle that the cut locus crosses.
//!
//! It also falls more slowly where a front draws together, as on the far side of a ball, and distance does not. But it does so over
//! a wide region, while the valley that the cut locus lies in is a few √t wide. So only what is lower than its surroundings counts.
//!
//! Shortest paths on a bumpy surface bend around its bumps, while heat, which takes all paths, goes on straight. A field so
//! straight would gain on distance with a length of 1.

use std::ops::Range;

use crate::extremum::{larger, smaller};
use crate::heat::closing::closed;
use crate::operator::Operators;
use crate::operator::elements::{BLOCK, Elements};

/// A slower fall than this is none of distance, and the field has this length there.
const LEAST_LENGTH: f64 = 0.4;

/// What the greatest length is less than 1 by, for each radian of the surface's bumpiness.
const LOSS_PER_RADIAN: f64 = 0.07;

/// So fast a fall in a triangle is that of no wave. Triangles where there is no heat count as this, which leaves those around them a
/// length of 1.
const MOST_LENGTH: f64 = 1.14;

/// Half the width of the widest valley that the cut locus may lie in, in edges.
const VALLEY: usize = 3;

/// The logarithm of heat on linear elements.
pub(super) struct Logarithm<'a> {
    elements: &'a Elements,
    /// `#V`; infinite or not a number where there is no heat.
    values: Vec<f64>,
    /// `#V`, square of the field's length around each vertex.
    squares: Vec<f32>,
}

impl<'a> Logarithm<'a> {
    /// Of `heat` (`#V`) that has flowed for this time, in the unit of the lengths, squared, on a surface of this
    /// [bumpiness](crate::exact::ExactGeometry::bumpiness).
    pub(super) fn new(operators: &'a Operators, heat: &[f64], time: f64, bumpiness: f64) -> Self {
        let elements = &operators.elements;
        let values: Vec<f64> = heat.iter().map(|heat| heat.ln()).collect();
        let limit = 1.0 - LOSS_PER_RADIAN * bumpiness;
        let [least, limit] = [LEAST_LENGTH, limit].map(|length| (length * length) as f32);
        // Lengths in single triangles are above and below that of the wave. Cut one by one, only those above would change.
        let sums = sums_around(elements, &values, time);
        let unit = square_unit(elements);
        let mean = |(&sum, &mass): (&f32, &f64)| {
            let mean = sum / (mass / unit) as f32;
            if mean < limit { mean } else { limit }
        };
        let mut squares: Vec<f32> = sums.iter().zip(&operators.laplacian().mass).map(mean).collect();
        let surroundings = closed(operators.adjacent(), &squares, limit, VALLEY);
        for (square, surroundings) in squares.iter_mut().zip(surroundings) {
            *square = (limit - (surroundings - *square)).max(least);
        }
        Self { elements, values, squares }
    }

    /// Divergence of the field at corners 1 and 2 of a block of triangles, minus their sum being that at corner 0; not finite
    /// where there is no heat, or the logarithm has no gradient.
    pub(super) fn against_gradient(&self, block: Range<usize>) -> [[f64; 2]; BLOCK] {
        let elements = self.elements;
        let mut products = [[0.0; 2]; BLOCK];
        let [mut circulations, mut means] = [[1.0; BLOCK]; 2];
        for (place, triangle) in block.enumerate() {
            let (face, shape) = (elements.faces[triangle], &elements.shapes[triangle]);
            let circulation = shape.circulation(face.map(|vertex| self.values[vertex as usize]));
            let [x, y] = circulation;
            products[place] = shape.edge_products(circulation);
            circulations[place] = x * x + y * y;
            let [a, b, c] = face.map(|vertex| self.squares[vertex as usize]);
            means[place] = f64::from(a + b + c) / 3.0;
        }
        let factors: [f64; BLOCK] = std::array::from_fn(|place| -0.5 * (means[place] / circulations[place]).sqrt());
        std::array::from_fn(|place| products[place].map(|product| factors[place] * product))
    }
}

/// Areas are divided by it, so that they are in the range of single precision on a surface of any size.
fn square_unit(elements: &Elements) -> f64 {
    elements.mean_edge * elements.mean_edge
}

/// `#V`, the square of the length of −√(t + c) ∇log u in the triangles around each vertex, times a third of their areas.
fn sums_around(elements: &Elements, values: &[f64], time: f64) -> Vec<f32> {
    let (root, sixth) = (time.sqrt(), 1.0 / (6.0 * square_unit(elements)));
    let mut sums = vec![0.0_f32; values.len()];
    let mut first = 0;
    for (faces, shapes) in elements.faces.chunks(BLOCK).zip(elements.shapes.chunks(BLOCK)) {
        let [mut circulations, mut quartics, mut areas] = [[1.0; BLOCK]; 3];
        for (place, (face, shape)) in faces.iter().zip(shapes).enumerate() {
            let values = face.map(|vertex| values[vertex as usize]);
            let [x, y] = shape.circulation(values);
            circulations[place] = x * x + y * y;
            quartics[place] = shape.quartic(values);
            areas[place] = shape.twice_area();
        }
        // A wave e^(−k·x) on triangles of one shape solves `(M / t + L) u = 0` where A / t = Σ cot (cosh Δ − 1), with Δ the
        // differences of its logarithm along the sides: k² is less than 1 / t by Σ cot Δ⁴ / 24 A, which c makes up for.
        let squares: [f64; BLOCK] = std::array::from_fn(|place| {
            let (share, circulation) = (root / areas[place], circulations[place]);
            let square = circulation * share * share + quartics[place] / (12.0 * circulation);
            larger(smaller(square, MOST_LENGTH * MOST_LENGTH), 0.0)
        });
        for (place, face) in faces.iter().enumerate() {
            let part = (sixth * elements.share(first + place) * areas[place] * squares[place]) as f32;
            for &vertex in face {
                sums[vertex as usize] += part;
            }
        }
        first += faces.len();
    }
    sums
}
