//! The values whose isolines are wanted.

use heatwalk_base::sort;

use crate::error::{Error, MOST_LEVELS, Result};

/// Distances that differ by no more than this share of the largest one are the same: along different ways around a mesh, rounding
/// makes about a tenth of it.
pub(crate) const SAME_DISTANCE: f64 = 1e-12;

/// Finite values, ascending, each once; one at least.
#[derive(Debug, Clone, PartialEq)]
pub struct Levels(Vec<f64>);

impl Levels {
    /// These values, in any order.
    ///
    /// # Errors
    /// [`Error::NoLevel`] for none, or one that is not finite; [`Error::TooManyLevels`].
    pub fn at(values: &[f64]) -> Result<Self> {
        if let Some(bad) = values.iter().find(|value| !value.is_finite()) {
            return Err(Error::NoLevel { reason: format!("{bad} is not a distance; give finite numbers") });
        }
        if values.len() > MOST_LEVELS {
            return Err(Error::TooManyLevels { levels: values.len() as f64 });
        }
        let mut values = values.to_vec();
        sort::sort_by(&mut values, f64::total_cmp);
        // Equality of numbers, so that −0 is 0.
        values.dedup_by(|a, b| a == b);
        if values.is_empty() {
            return Err(Error::NoLevel { reason: "no value is given".to_owned() });
        }
        Ok(Self(values))
    }

    /// The multiples of a spacing between 0 and the largest distance, both excluded; so is a multiple that is the largest distance
    /// up to rounding.
    ///
    /// # Errors
    /// [`Error::NoLevel`] for a spacing that is not positive or not below the largest distance; [`Error::TooManyLevels`].
    pub fn spaced(spacing: f64, largest: f64) -> Result<Self> {
        let below = largest * (1.0 - SAME_DISTANCE);
        let reason = if !(spacing.is_finite() && spacing > 0.0) {
            format!("a spacing is a positive number, not {spacing}")
        } else if spacing >= below {
            format!("the spacing {spacing} is not below the largest distance, {largest}; choose a smaller one")
        } else {
            let levels = (below / spacing).ceil() - 1.0;
            if levels > MOST_LEVELS as f64 {
                return Err(Error::TooManyLevels { levels });
            }
            let multiples = (1..=levels as u32).map(|index| f64::from(index) * spacing);
            return Self::at(&multiples.filter(|&value| value < below).collect::<Vec<_>>());
        };
        Err(Error::NoLevel { reason })
    }

    /// So many values that part 0 to the largest distance into equal shares.
    ///
    /// # Errors
    /// [`Error::NoLevel`] for a count of 0, or where the largest distance is not positive; [`Error::TooManyLevels`].
    pub fn counted(count: usize, largest: f64) -> Result<Self> {
        if count == 0 {
            return Err(Error::NoLevel { reason: "ask for one at least".to_owned() });
        }
        if !(largest.is_finite() && largest > 0.0) {
            return Err(Error::NoLevel { reason: format!("the largest distance is {largest}") });
        }
        if count > MOST_LEVELS {
            return Err(Error::TooManyLevels { levels: count as f64 });
        }
        let shares = (count + 1) as f64;
        Self::at(&(1..=count).map(|index| largest * (index as f64 / shares)).collect::<Vec<_>>())
    }

    /// The values, ascending.
    pub fn values(&self) -> &[f64] {
        &self.0
    }
}
