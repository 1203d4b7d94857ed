//! From heat to the right side of the Poisson equation: the unit field against the gradient of heat, and the gradient
//! of exact distance where that is known.

use crate::operator::elements::Elements;

/// Integrated divergence, `#P`, of the field X that should be the gradient of distance: the gradient of `near` in
/// triangles whose three corners have a finite value there, elsewhere −∇u / |∇u| of `heat`, zero where heat is
/// constant. Signed so that `L φ` equals it for ∇φ = X. `mixed` is told each triangle of which some corners have a
/// finite `near`, with whether all have.
pub(crate) fn divergence(
    elements: &Elements,
    heat: &[f64],
    near: &[f64],
    mut mixed: impl FnMut([u32; 3], bool),
) -> Vec<f64> {
    let mut divergence = vec![0.0; heat.len()];
    for (&face, shape) in elements.faces.iter().zip(&elements.shapes) {
        let [a, b, c] = face.map(|point| point as usize);
        let known = [near[a], near[b], near[c]];
        let count = known.iter().filter(|value| value.is_finite()).count();
        if count > 0 {
            mixed(face, count == 3);
        }
        let [at_b, at_c] = if count == 3 {
            let [cotan_a, cotan_b, cotan_c] = shape.cotans();
            let [ab, ac, bc] = [known[1] - known[0], known[2] - known[0], known[2] - known[1]];
            [0.5 * (cotan_c * ab - cotan_a * bc), 0.5 * (cotan_b * ac + cotan_a * bc)]
        } else {
            let values = [heat[a], heat[b], heat[c]];
            // Heat falls by hundreds of orders of magnitude over the surface; only ratios within the face matter.
            let scale = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            if scale == 0.0 {
                continue;
            }
            let circulation = shape.circulation(values.map(|value| value / scale));
            let [x, y] = circulation;
            let length = x.hypot(y);
            if length == 0.0 {
                continue;
            }
            shape.edge_products(circulation).map(|product| -0.5 * product / length)
        };
        let share = elements.share;
        divergence[a] -= share * (at_b + at_c);
        divergence[b] += share * at_b;
        divergence[c] += share * at_c;
    }
    divergence
}
