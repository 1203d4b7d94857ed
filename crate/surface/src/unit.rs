//! Units of length. A unit only labels lengths: none is ever converted into another.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

use crate::error::Error;
use crate::soup::Soup;
use crate::triangle;

/// Files that are so many units across, from one to the other, hold millimeters if nothing else is known.
const MILLIMETERS: [f64; 2] = [10.0, 10_000.0];

/// A unit of length.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
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

impl LengthUnit {
    /// Of all that a file holds, by a rule.
    #[must_use]
    pub fn of_file(soup: &Soup, rule: UnitRule) -> Self {
        match (rule, soup.unit) {
            (UnitRule::Is(unit), _) => Self { unit, is_assumed: false },
            (UnitRule::Automatic, Some(unit)) => Self { unit: Some(unit), is_assumed: false },
            (UnitRule::Automatic, None) => {
                let corners =
                    soup.triangles.as_flattened().iter().filter_map(|&vertex| soup.positions.get(vertex as usize));
                let mut points = corners.copied().filter(|position| position.is_finite());
                let Some(first) = points.next() else { return Self::default() };
                let (low, high) = points.fold((first, first), |(low, high), point| (low.min(point), high.max(point)));
                // Halves, so that what is as large as numbers can be does not overflow.
                let half_diagonal = triangle::length(0.5 * high - 0.5 * low);
                Self { unit: Some(Unit::assumed(2.0 * half_diagonal)), is_assumed: true }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    /// A triangle whose bounding box has this diagonal, and a vertex far away that it does not use.
    fn of_size(diagonal: f64) -> Soup {
        let positions = vec![DVec3::ZERO, DVec3::X * 0.6 * diagonal, DVec3::Y * 0.8 * diagonal, DVec3::splat(1e9)];
        Soup::single("triangle", positions, vec![[0, 1, 2]])
    }

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

    #[test]
    fn the_size_suggests_a_unit_where_nothing_says_one() {
        let assumed = |unit| LengthUnit { unit: Some(unit), is_assumed: true };
        let sizes = [(0.2, Unit::Meter), (9.9, Unit::Meter), (10.1, Unit::Millimeter), (250.0, Unit::Millimeter)];
        for (diagonal, unit) in sizes.into_iter().chain([(9_999.0, Unit::Millimeter), (10_001.0, Unit::Meter)]) {
            assert_eq!(LengthUnit::of_file(&of_size(diagonal), UnitRule::Automatic), assumed(unit), "{diagonal}");
        }
        assert_eq!(LengthUnit::of_file(&of_size(f64::MAX), UnitRule::Automatic), assumed(Unit::Meter));
        assert_eq!(LengthUnit::of_file(&Soup::default(), UnitRule::Automatic), LengthUnit::default());
    }

    #[test]
    fn what_is_known_is_not_assumed() {
        let known = |unit| LengthUnit { unit, is_assumed: false };
        let stated = Soup { unit: Some(Unit::Inch), ..of_size(100.0) };
        assert_eq!(LengthUnit::of_file(&stated, UnitRule::Automatic), known(Some(Unit::Inch)));
        for unit in [Some(Unit::Kilometer), None] {
            assert_eq!(LengthUnit::of_file(&stated, UnitRule::Is(unit)), known(unit));
            assert_eq!(LengthUnit::of_file(&of_size(100.0), UnitRule::Is(unit)), known(unit));
        }
    }
}
