//! How far distances are from exact ones.

/// Error relative to the exact distance, over all vertices where that is positive and finite; no unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeError {
    /// Mean of |value − exact| / exact; 0 where there is no such vertex.
    pub mean: f64,
    /// Its maximum.
    pub max: f64,
}

impl RelativeError {
    /// Of values against exact ones, both `#V`.
    pub fn between<'a>(values: impl IntoIterator<Item = &'a f64>, exact: impl IntoIterator<Item = &'a f64>) -> Self {
        let (mut sum, mut max, mut count) = (0.0, 0.0_f64, 0_u32);
        for (&value, &exact) in values.into_iter().zip(exact).filter(|&(_, &exact)| exact > 0.0 && exact.is_finite()) {
            let error = (value - exact).abs() / exact;
            sum += error;
            max = max.max(error);
            count += 1;
        }
        Self { mean: sum / f64::from(count.max(1)), max }
    }
}
