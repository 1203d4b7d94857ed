//! The time that suits triangles.

use crate::operator::Operators;

/// Root-mean-square deviation of a triangle's sides from their mean up to which triangles are even, and from which on
/// they are not.
const EVENNESS: [f64; 2] = [0.07, 0.15];

/// m of even triangles up to so many mean edges of extent. Beyond, it grows with the power of 2/3: what heat errs by for
/// following the edges falls as 1/m, what it errs by for rounding the distance off grows as √t, and so their sum falls
/// with the size of the edges.
const EVEN: (f64, f64) = (0.36, 80.0);

/// m of others, where so short a time would follow the edges, on surfaces of at least so many mean edges in width. On
/// narrower ones, where rounding costs more, it falls with the fifth root.
const UNEVEN: (f64, f64) = (1.02, 100.0);

/// m grows with the grading up to this. Beyond, it would round off too much where triangles are small.
const MOST_GRADING: f64 = 2.0;

/// Width in mean edges for each unit of grading that m may grow with, for the same reason.
const WIDTH_PER_GRADING: f64 = 60.0;

/// m by how even the triangles are, in themselves and from place to place, and by the surface's extent and width. Measured
/// on 46 meshes from four sources each.
pub(super) fn suited_factor(operators: &Operators, extent: f64) -> f64 {
    let [even, uneven] = EVENNESS;
    let unevenness = ((operators.deviation() - even) / (uneven - even)).clamp(0.0, 1.0);
    let mean_edge = operators.mean_edge();
    let (length, width) = (extent / mean_edge, operators.area() / (extent * mean_edge));
    let for_even = EVEN.0 * (length / EVEN.1).max(1.0).powf(2.0 / 3.0);
    let for_uneven = UNEVEN.0 * (width / UNEVEN.1).min(1.0).powf(0.2);
    // t is to suit the triangles that heat crosses: those where most of the surface is.
    let most_grading = (width / WIDTH_PER_GRADING).clamp(1.0, MOST_GRADING);
    operators.grading().clamp(1.0, most_grading) * (for_even + unevenness * (for_uneven - for_even).max(0.0))
}
