//! Which cracks are closed, and how that is written.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

use crate::error::Error;

/// Which vertices become one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum WeldRule {
    /// Those of equal position.
    Exact,
    /// And those on both sides of cracks that are too narrow to be seen: 10⁻⁴ of the diagonal of the bounding box.
    #[default]
    Automatic,
    /// And those on both sides of cracks no wider than this, in the file's unit; 0 or more.
    Within(f64),
}

impl Display for WeldRule {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Exact => formatter.write_str("exact"),
            Self::Automatic => formatter.write_str("auto"),
            Self::Within(width) => width.fmt(formatter),
        }
    }
}

impl FromStr for WeldRule {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        match text {
            "exact" => Ok(Self::Exact),
            "auto" => Ok(Self::Automatic),
            _ => {
                let width = text.parse().ok().filter(|width: &f64| width.is_finite() && *width >= 0.0);
                width.map(Self::Within).ok_or_else(|| Error::BadParameter {
                    name: "the width of cracks to weld",
                    value: text.to_owned(),
                    range: "auto, exact, or 0 or more",
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn rules_are_read_as_they_are_written() {
        for rule in [WeldRule::Exact, WeldRule::Automatic, WeldRule::Within(0.0), WeldRule::Within(1e-5)] {
            assert_eq!(rule.to_string().parse(), Ok(rule));
        }
        for text in ["", "-1", "NaN", "inf", "off"] {
            assert!(text.parse::<WeldRule>().is_err(), "{text}");
        }
    }
}
