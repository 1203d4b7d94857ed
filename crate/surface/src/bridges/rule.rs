//! Which components are joined, and how that is written.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

use crate::error::Error;

/// Which components are joined.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum BridgeRule {
    /// None.
    Off,
    /// Those that pierce each other, touch, or are so near that they look as if they did.
    #[default]
    Automatic,
    /// Those that pierce each other, or are no farther apart than this, in the file's unit; 0 or more. More than 5 % of the
    /// diagonal of the surface's bounding box counts as 5 %.
    Within(f64),
}

impl Display for BridgeRule {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Off => formatter.write_str("off"),
            Self::Automatic => formatter.write_str("auto"),
            Self::Within(distance) => distance.fmt(formatter),
        }
    }
}

impl FromStr for BridgeRule {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        match text {
            "off" => Ok(Self::Off),
            "auto" => Ok(Self::Automatic),
            _ => {
                let distance = text.parse().ok().filter(|distance: &f64| distance.is_finite() && *distance >= 0.0);
                distance.map(Self::Within).ok_or_else(|| Error::BadParameter {
                    name: "the distance to bridge",
                    value: text.to_owned(),
                    range: "auto, off, or 0 or more",
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
        for rule in [BridgeRule::Off, BridgeRule::Automatic, BridgeRule::Within(0.0), BridgeRule::Within(0.25)] {
            assert_eq!(rule.to_string().parse(), Ok(rule));
        }
        for text in ["", "-1", "NaN", "inf", "near"] {
            assert!(text.parse::<BridgeRule>().is_err(), "{text}");
        }
    }
}
