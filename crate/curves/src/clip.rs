//! Parts of triangles (Sutherland and Hodgman, "Reentrant polygon clipping", 1974).

/// Weights of the corners of a triangle at its corners.
pub const WHOLE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The part of a convex polygon in a triangle, whose corners are weights of the triangle's, where a function that is linear there is at most 0;
/// `values` are those at the triangle's corners. Less than three corners are none.
pub fn below(polygon: &[[f64; 3]], values: [f64; 3]) -> Vec<[f64; 3]> {
    let at = |weights: &[f64; 3]| (0..3).map(|k| weights[k] * values[k]).sum::<f64>();
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (index, to) in polygon.iter().enumerate() {
        let from = &polygon[(index + polygon.len() - 1) % polygon.len()];
        let (before, after) = (at(from), at(to));
        if (before > 0.0) != (after > 0.0) {
            let share = before / (before - after);
            kept.push(std::array::from_fn(|k| from[k] + share * (to[k] - from[k])));
        }
        if after <= 0.0 {
            kept.push(*to);
        }
    }
    if kept.len() < 3 { Vec::new() } else { kept }
}

/// A convex polygon as triangles.
pub fn fan<T: Copy>(polygon: &[T]) -> impl Iterator<Item = [T; 3]> + '_ {
    (1..polygon.len().saturating_sub(1)).map(|k| [polygon[0], polygon[k], polygon[k + 1]])
}
