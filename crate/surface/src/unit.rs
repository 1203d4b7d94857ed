//! Units of length. A unit only labels lengths: none is ever converted into another.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

use crate::error::Error;

/// Files that are so many units across, from one to the other, hold millimeters if nothing else is known.
const MILLIMETERS: [f64; 2] = [10.0, 10_000.0];

/// A unit of length.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Unit {
    /// 10⁻⁶ m.
    Micrometer,
    /// 10⁻³ m.
    #[default]
    Millimeter,
    /// 10⁻² m.
    Centimeter,
    /// 0.0254 m.
    Inch,
    /// 0.3048 m.
    Foot,
    /// As in glTF.
    Meter,
    /// 10³ m.
    Kilometer,
}

impl Unit {
    /// All of them, by size.
    pub const ALL: [Self; 7] =
        [Self::Micrometer, Self::Millimeter, Self::Centimeter, Self::Inch, Self::Foot, Self::Meter, Self::Kilometer];

    /// What is written after numbers.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Micrometer => "µm",
            Self::Millimeter => "mm",
            Self::Centimeter => "cm",
            Self::Inch => "in",
            Self::Foot => "ft",
            Self::Meter => "m",
            Self::Kilometer => "km",
        }
    }

    /// What the lengths of a file are probably in, by nothing but its size: millimeters where the diagonal of its bounding box
    /// is from 10 to 10,000 of its units, since programs for engineering and for printing write these and most of their models
    /// are from a centimeter to ten meters across; otherwise meters, as scans of small things and terrains have.
    #[must_use]
    pub fn assumed(diagonal: f64) -> Self {
        let [least, most] = MILLIMETERS;
        if (least..=most).contains(&diagonal) { Self::Millimeter } else { Self::Meter }
    }
}

/// Which unit the lengths of a file have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum UnitRule {
    /// The one that the file states, or else the one that its size suggests.
    #[default]
    Automatic,
    /// This one, or none, whatever the file states.
    Is(Option<Unit>),
}

impl Display for UnitRule {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Automatic => "auto",
            Self::Is(None) => "none",
            Self::Is(Some(unit)) => unit.symbol(),
        })
    }
}

impl FromStr for UnitRule {
    type Err = Error;

    /// `auto`, `none` or a symbol; `um` stands for `µm`.
    fn from_str(text: &str) -> Result<Self, Error> {
        let unit = Unit::ALL.into_iter().find(|unit| unit.symbol() == text);
        match (text, unit) {
            ("auto", _) => Ok(Self::Automatic),
            ("none", _) => Ok(Self::Is(None)),
            ("um", _) => Ok(Self::Is(Some(Unit::Micrometer))),
            (_, Some(unit)) => Ok(Self::Is(Some(unit))),
            _ => Err(Error::BadParameter {
                name: "the unit",
                value: text.to_owned(),
                range: "auto, none, um, mm, cm, in, ft, m or km",
            }),
        }
    }
}

/// The unit of the lengths of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LengthUnit {
    /// `None` where nothing says one.
    pub unit: Option<Unit>,
    /// Whether only the size of the mesh suggests it.
    pub is_assumed: bool,
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn rules_are_read_as_they_are_written() {
        let units = Unit::ALL.map(|unit| UnitRule::Is(Some(unit)));
        for rule in units.into_iter().chain([UnitRule::Automatic, UnitRule::Is(None)]) {
            assert_eq!(rule.to_string().parse(), Ok(rule));
        }
        assert_eq!("um".parse(), Ok(UnitRule::Is(Some(Unit::Micrometer))));
        for text in ["", "MM", "meter", "1"] {
            assert!(text.parse::<UnitRule>().is_err(), "{text}");
        }
    }
}
