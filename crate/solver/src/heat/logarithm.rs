//! The field of the logarithm of heat: −√(t + c) ∇log u, no longer than 1, and on a bumpy surface than somewhat less.
//!
//! Distance is the limit of −√t log u for short times (Varadhan, "On the behavior of the fundamental solution of the heat
//! equation with variable coefficients", 1967). Heat falls exponentially, so that its logarithm is what is nearly linear in a
//! triangle: it points along distance where the gradient of heat leans towards the warmest corner. Where heat arrives from
//! two sides it falls more slowly, as the mean of distance does in a triangle that the cut locus crosses.
//!
//! Shortest paths on a bumpy surface bend around its bumps, while heat, which takes all paths, goes on straight. A field so
//! straight would gain on distance with a length of 1.

use std::ops::Range;

use crate::extremum::{larger, smaller};
use crate::operator::elements::{BLOCK, Elements};

/// A slower fall than this is none of distance, and the field has this length there.
const LEAST_LENGTH: f64 = 0.4;

/// What the greatest length is less than 1 by, for each radian of the surface's bumpiness.
const LOSS_PER_RADIAN: f64 = 0.06;

/// So fast a fall is that of no wave. Triangles where there is no heat count as this, which leaves those around them a length of 1.
const MOST_LENGTH: f64 = 2.0;

/// The logarithm of heat on linear elements.
pub(super) struct Logarithm<'a> {
    elements: &'a Elements,
    /// `#V`; infinite or not a number where there is no heat.
    values: Vec<f64>,
    /// `#F`, square of the length of −√(t + c) ∇log u.
    squares: Vec<f32>,
    /// Square of the greatest length.
    limit: f64,
}

impl<'a> Logarithm<'a> {
    /// Of `heat` (`#V`) that has flowed for this time, in the unit of the lengths, squared, on a surface of this
    /// [bumpiness](crate::exact::ExactGeometry::bumpiness).
    pub(super) fn new(elements: &'a Elements, heat: &[f64], time: f64, bumpiness: f64) -> Self {
        let values: Vec<f64> = heat.iter().map(|heat| heat.ln()).collect();
        let root = time.sqrt();
        let mut squares = Vec::with_capacity(elements.faces.len());
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
            let block: [f32; BLOCK] = std::array::from_fn(|place| {
                let (share, circulation) = (root / areas[place], circulations[place]);
                let square = circulation * share * share + quartics[place] / (12.0 * circulation);
                larger(smaller(square, MOST_LENGTH * MOST_LENGTH), 0.0) as f32
            });
            squares.extend_from_slice(&block[..faces.len()]);
        }
        let limit = 1.0 - LOSS_PER_RADIAN * bumpiness;
        Self { elements, values, squares, limit: limit * limit }
    }

    /// Divergence of the field at corners 1 and 2 of a block of triangles, minus their sum being that at corner 0; not finite
    /// where there is no heat, or the logarithm has no gradient.
    pub(super) fn against_gradient(&self, block: Range<usize>) -> [[f64; 2]; BLOCK] {
        let elements = self.elements;
        let mut products = [[0.0; 2]; BLOCK];
        let [mut circulations, mut means] = [[1.0; BLOCK]; 2];
        for (place, triangle) in block.enumerate() {
            let shape = &elements.shapes[triangle];
            let circulation = shape.circulation(elements.faces[triangle].map(|vertex| self.values[vertex as usize]));
            let [x, y] = circulation;
            products[place] = shape.edge_products(circulation);
            circulations[place] = x * x + y * y;
            // Where kinds of triangles take turns, some err upwards and some downwards. By themselves, only the former would be cut off.
            let [a, b, c] = elements.neighbors[triangle].map(|other| self.squares[other as usize]);
            means[place] = 0.25 * f64::from(self.squares[triangle] + a + b + c);
        }
        let factors: [f64; BLOCK] = std::array::from_fn(|place| {
            let square = larger(smaller(means[place], self.limit), LEAST_LENGTH * LEAST_LENGTH);
            -0.5 * (square / circulations[place]).sqrt()
        });
        std::array::from_fn(|place| products[place].map(|product| factors[place] * product))
    }
}
