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

/// Of the weights of all edges, at most this share may be negative for the field of the logarithm: obtuse tetrahedra let heat through
/// against its fall, and their edges do not tell how it falls.
const NEGATIVE_SHARE: f64 = 0.13;

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
        let mut nodes = nodes(laplacian, heat, time);
        for (vertex, (node, &reflects)) in nodes.iter_mut().zip(&self.reflects).enumerate() {
            node.exact = region.value(vertex as u32).unwrap_or(f64::INFINITY);
            if reflects {
                node.value -= REFLECTED;
            }
        }
        let mut divergence = vec![0.0; nodes.len()];
        let mut inside = Vec::new();
        let mut is_on_rim = vec![false; nodes.len()];
        for (vertex, own) in nodes.iter().enumerate() {
            let mut sum = 0.0;
            for (row, weight) in edges(laplacian, vertex) {
                let other = &nodes[row];
                let mut difference = 0.5 * (own.rate + other.rate) * (other.value - own.value);
                if other.exact < f64::INFINITY {
                    if own.exact < f64::INFINITY {
                        inside.push([vertex as u32, row as u32]);
                        difference = own.exact - other.exact;
                    } else {
                        is_on_rim[row] = true;
                    }
                } else if own.exact < f64::INFINITY {
                    is_on_rim[vertex] = true;
                }
                let flux = weight * difference;
                sum += flux;
                divergence[row] -= flux;
            }
            divergence[vertex] += sum;
        }
        let on_rim = (0..).zip(is_on_rim).filter(|&(_, is_on_rim)| is_on_rim).map(|(vertex, _)| ([vertex; 2], false));
        let touched = inside.into_iter().map(|edge| (edge, true)).chain(on_rim);
        let rims = Constraint::of_rims(nodes.len(), touched, |vertex| region.value(vertex));
        Right { divergence, rims }
    }
}

/// Whether nearly all edges have positive weights, so that heat falls along them.
pub(super) fn is_monotone(laplacian: &Laplacian) -> bool {
    let (mut negative, mut whole) = (0.0, 0.0);
    for (_, weight) in (0..laplacian.size()).flat_map(|vertex| edges(laplacian, vertex)) {
        negative += (-weight).max(0.0);
        whole += weight.abs();
    }
    negative <= NEGATIVE_SHARE * whole
}

/// What the field is made of at a vertex.
#[derive(Clone, Copy)]
struct Node {
    /// The logarithm of heat.
    value: f64,
    /// How much distance a unit of the logarithm is, so that the field around is as long as it should be.
    rate: f64,
    /// Exact distance; infinite where that is not known.
    exact: f64,
}

/// Of vertices where no distance is known.
fn nodes(laplacian: &Laplacian, heat: &[f64], time: f64) -> Vec<Node> {
    // Of Δ² and Δ⁴, with Δ the difference along an edge, the sums over the edges of each vertex times their weights. Stiffness of obtuse
    // tetrahedra may let heat fall below 0, where its size still is that of the heat around.
    let value = |heat: &f64| heat.abs().max(f64::MIN_POSITIVE).ln();
    let mut sums: Vec<(f64, [f64; 2])> = heat.iter().map(|heat| (value(heat), [0.0; 2])).collect();
    for vertex in 0..sums.len() {
        let (value, mut own) = sums[vertex];
        for (row, weight) in edges(laplacian, vertex) {
            let (other, sums) = &mut sums[row];
            let square = (*other - value) * (*other - value);
            let [squares, quartics] = [weight * square, weight * square * square];
            own = [own[0] + squares, own[1] + quartics];
            *sums = [sums[0] + squares, sums[1] + quartics];
        }
        sums[vertex].1 = own;
    }
    let least = 1.0 / (MOST_RATE * MOST_RATE * time);
    let rate = |[squares, quartics]: [f64; 2], mass: f64| {
        if squares < least * mass {
            return time.sqrt();
        }
        // The sum of squares is 2 M k² for e^(−k·x). It solves `(M / t + L) u = 0` on alike tetrahedra where
        // M / t = Σ w (cosh Δ − 1): k² is less than 1 / t by a 24th of the sum of fourth powers over M, which c makes up for.
        let square = time * squares / mass + quartics / (12.0 * squares);
        (square.clamp(LEAST_LENGTH * LEAST_LENGTH, 1.0) * mass / squares).sqrt()
    };
    let node = |(&(value, sums), &mass): (&(f64, [f64; 2]), &f64)| Node {
        value,
        rate: rate(sums, 2.0 * mass),
        exact: f64::INFINITY,
    };
    sums.iter().zip(&laplacian.mass).map(node).collect()
}

/// The other ends of the edges whose lower end is a vertex, and their weights w, l cot θ / 6.
#[inline]
fn edges(laplacian: &Laplacian, vertex: usize) -> impl Iterator<Item = (usize, f64)> {
    // The diagonal comes first.
    let entries = laplacian.column(vertex);
    let entries = entries.start + 1..entries.end;
    let weights = &laplacian.stiffness.values()[entries.clone()];
    laplacian.rows()[entries].iter().zip(weights).map(|(&row, &value)| (row as usize, -value))
}
