//! What was read otherwise than it stands in the file.

use std::fmt;

/// Something that a reader left out, or took otherwise than it is written. The surface can be used; whoever made the file should know.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Warning {
    /// The kind.
    pub code: WarningCode,
    /// Of how many things; 1 at least.
    pub count: usize,
    /// Where the first of them is: a line, a byte offset or the name of an element.
    pub place: String,
}

/// Kinds of warnings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum WarningCode {
    /// Points and lines were left out.
    LinesLeftOut,
    /// Curves and surfaces of free form were left out.
    CurvesLeftOut,
    /// Cells that fill space were left out of a surface.
    VolumesLeftOut,
    /// Statements that the format does not have were left out.
    UnknownStatements,
    /// A backslash at the end of a line does not join the next one to it, which begins a statement of its own.
    UnjoinedLines,
    /// Facets end without being ended.
    UnendedFacets,
    /// The end of the file is missing, but all that it holds is whole.
    NoEnd,
    /// There is more behind the end than there should be.
    Trailing,
    /// Of curved cells the corners were taken.
    Straightened,
    /// Polygons cross themselves, so that no triangles have their outline.
    CrossedPolygons,
}

impl WarningCode {
    /// In kebab case. It stays the same between versions; what is said in words may not.
    pub fn name(self) -> &'static str {
        match self {
            Self::LinesLeftOut => "lines-left-out",
            Self::CurvesLeftOut => "curves-left-out",
            Self::VolumesLeftOut => "volumes-left-out",
            Self::UnknownStatements => "unknown-statements",
            Self::UnjoinedLines => "unjoined-lines",
            Self::UnendedFacets => "unended-facets",
            Self::NoEnd => "no-end",
            Self::Trailing => "trailing",
            Self::Straightened => "straightened",
            Self::CrossedPolygons => "crossed-polygons",
        }
    }
}

impl Warning {
    /// Of one thing.
    pub fn one(code: WarningCode, place: impl Into<String>) -> Self {
        Self { code, count: 1, place: place.into() }
    }

    /// What was done, in words without a full stop.
    pub fn what(&self) -> String {
        let count = self.count;
        let counted = |one: &str, many: &str| if count == 1 { format!("1 {one}") } else { format!("{count} {many}") };
        match self.code {
            WarningCode::LinesLeftOut => counted("point or line was left out", "points or lines were left out"),
            WarningCode::CurvesLeftOut => counted(
                "statement of a curve or a surface of free form was left out; save the model as polygons",
                "statements of curves or surfaces of free form were left out; save the model as polygons",
            ),
            WarningCode::VolumesLeftOut => {
                counted("cell that fills space was left out", "cells that fill space were left out")
            }
            WarningCode::UnknownStatements => {
                counted("statement is not known and was left out", "statements are not known and were left out")
            }
            WarningCode::UnjoinedLines => counted(
                "backslash ends a line; the next one begins a statement of its own and was not joined to it",
                "backslashes end lines; the next one begins a statement of its own and was not joined to it",
            ),
            WarningCode::UnendedFacets => counted("facet has no endfacet", "facets have no endfacet"),
            WarningCode::NoEnd => "the end of the file is missing; it may be cut short".to_owned(),
            WarningCode::Trailing => "there is more behind the end; it was left out".to_owned(),
            WarningCode::Straightened => {
                counted("curved cell became flat between its corners", "curved cells became flat between their corners")
            }
            WarningCode::CrossedPolygons => counted(
                "polygon crosses itself; its triangles are a guess",
                "polygons cross themselves; their triangles are a guess",
            ),
        }
    }
}

/// The place and what was done there.
impl fmt::Display for Warning {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}", self.place, self.what())
    }
}

/// Warnings while a file is read: one a kind.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Warnings(Vec<Warning>);

impl Warnings {
    /// One more of a kind. `place`: where it is, asked for of the first.
    pub fn add(&mut self, code: WarningCode, place: impl FnOnce() -> String) {
        self.add_many(code, 1, place);
    }

    /// So many more of a kind.
    pub fn add_many(&mut self, code: WarningCode, count: usize, place: impl FnOnce() -> String) {
        match self.0.iter_mut().find(|warning| warning.code == code) {
            Some(warning) => warning.count += count,
            None if count > 0 => self.0.push(Warning { code, count, place: place() }),
            None => {}
        }
    }

    /// All of them, in the order of the first of each kind.
    pub fn into_vec(self) -> Vec<Warning> {
        self.0
    }
}
