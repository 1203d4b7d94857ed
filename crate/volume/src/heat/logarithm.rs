//! The field of the logarithm of heat, −√(t + c) ∇log u, no longer than 1, as what it adds along each edge.
//!
//! Distance is the limit of −√t log u for short times (Varadhan, "On the behavior of the fundamental solution of the heat
//! equation with variable coefficients", 1967). Heat falls exponentially, so that its logarithm is what is nearly linear in a
//! tetrahedron: it points along distance where the gradient of heat leans towards the warmest corner. A difference along an edge is
//! all that stiffness takes of a field, so that no tetrahedron is looked at, and costs are those of stiffness and mass.

use heatwalk::heat::Constraint;
use heatwalk::operator::laplacian::Laplacian;

use crate::heat::region::{Region, Right};

/// A slower fall than this is none of distance, and the field has this length there.
const LEAST_LENGTH: f64 = 0.7;

/// At no vertex is a unit of the logarithm more than so many √t of distance.
const MOST_RATE: f64 = 3.0;

/// Where heat meets a boundary that lets none through head-on it is twice that of the wave alone, and its logarithm greater by log 2.
/// Along the boundary it is not; half of that is taken off.
const REFLECTED: f64 = 0.35;

/// Where the logarithm of heat is too great.
#[derive(Debug)]
pub(super) struct Logarithm {
    /// `#V`, whether heat is thrown back there.
    reflects: Vec<bool>,
}

impl Logarithm {
    pub(super) fn new(reflects: Vec<bool>) -> Self {
        Self { reflects }
    }

    /// Of `heat` (`#V`) that has flowed for this time, in the unit of the lengths, squared. Between vertices of the region, differences
    /// are those of exact distance.
    pub(super) fn right(&self, laplacian: &Laplacian, heat: &[f64], time: f64, region: &Region) -> Right {
        // Stiffness of obtuse tetrahedra may let heat fall below 0, where its size still is that of the heat around.
        let mut values: Vec<f64> = heat.iter().map(|heat| heat.abs().max(f64::MIN_POSITIVE).ln()).collect();
        let rates = rates(laplacian, &values, time);
        for (value, _) in values.iter_mut().zip(&self.reflects).filter(|&(_, &reflects)| reflects) {
            *value -= REFLECTED;
        }
        let mut divergence = vec![0.0; values.len()];
        let mut touched = Vec::new();
        for vertex in 0..values.len() {
            let (own, rate, exact) = (values[vertex], rates[vertex], region.value(vertex as u32));
            let mut sum = 0.0;
            for (row, weight) in edges(laplacian, vertex) {
                let exact = [exact, region.value(row as u32)];
                if exact != [None; 2] {
                    touched.push(([vertex as u32, row as u32], exact[0].is_some() && exact[1].is_some()));
                }
                let difference = match exact {
                    [Some(own), Some(other)] => own - other,
                    _ => 0.5 * (rate + rates[row]) * (values[row] - own),
                };
                sum += weight * difference;
                divergence[row] -= weight * difference;
            }
            divergence[vertex] += sum;
        }
        let rims = Constraint::of_rims(values.len(), touched, |vertex| region.value(vertex));
        Right { divergence, rims }
    }
}

/// How much distance a unit of the logarithm is around each vertex, so that there the field is as long as it should be.
fn rates(laplacian: &Laplacian, values: &[f64], time: f64) -> Vec<f64> {
    // Σ l cot Δ² / 6 and Σ l cot Δ⁴ / 6 over the edges of each vertex, with Δ the difference along an edge.
    let mut sums = vec![[0.0; 2]; values.len()];
    for vertex in 0..values.len() {
        let mut own = [0.0; 2];
        for (row, weight) in edges(laplacian, vertex) {
            let square = (values[row] - values[vertex]).powi(2);
            let part = [weight * square, weight * square * square];
            for (power, part) in part.into_iter().enumerate() {
                own[power] += part;
                sums[row][power] += part;
            }
        }
        for (sum, own) in sums[vertex].iter_mut().zip(own) {
            *sum += own;
        }
    }
    let least = 1.0 / (MOST_RATE * MOST_RATE * time);
    let rate = |(&[squares, quartics], &mass): (&[f64; 2], &f64)| {
        let mass = 2.0 * mass;
        if squares < least * mass {
            return time.sqrt();
        }
        // The sum of squares is 2 M k² for e^(−k·x). It solves `(M / t + L) u = 0` on alike tetrahedra where
        // M / t = Σ l cot (cosh Δ − 1) / 6: k² is less than 1 / t by a 24th of the sum of fourth powers over M, which c makes up for.
        let length_squared =
            (time * squares / mass + quartics / (12.0 * squares)).clamp(LEAST_LENGTH * LEAST_LENGTH, 1.0);
        (length_squared * mass / squares).sqrt()
    };
    sums.iter().zip(&laplacian.mass).map(rate).collect()
}

/// The other ends of the edges whose lower end is a vertex, and their weights l cot θ / 6.
#[inline]
fn edges(laplacian: &Laplacian, vertex: usize) -> impl Iterator<Item = (usize, f64)> {
    // The diagonal comes first.
    let entries = laplacian.column(vertex);
    let entries = entries.start + 1..entries.end;
    let weights = &laplacian.stiffness.values()[entries.clone()];
    laplacian.rows()[entries].iter().zip(weights).map(|(&row, &value)| (row as usize, -value))
}
