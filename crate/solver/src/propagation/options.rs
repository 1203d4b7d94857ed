//! The options of propagation.

use std::fmt;
use std::num::NonZeroU16;
use std::str::FromStr;

use crate::error::{Error, Result};

/// The word for all of a number of things.
pub const ALL: &str = "all";

/// Windows that propagation keeps of each half-edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Windows {
    /// So many; two at least where a tenth of the triangles has an angle of less than six degrees.
    AtMost(NonZeroU16),
    /// As many as there are, which makes it exact.
    All,
}

impl Default for Windows {
    fn default() -> Self {
        Self::AtMost(NonZeroU16::MIN)
    }
}

/// Windows of each half-edge that [`Method::Auto`](crate::Method::Auto) keeps at least where faces have different costs and no
/// exact search goes first: errors are a fifteenth of those of one, in three times the time.
pub const REFRACTED: Windows = Windows::AtMost(NonZeroU16::new(4).expect("not zero"));

/// A number, or [`ALL`].
impl FromStr for Windows {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        if text == ALL {
            return Ok(Self::All);
        }
        let count = text.parse().map(Self::AtMost);
        let (name, range) = ("the number of windows", "a whole number from 1 to 65535, or all");
        count.map_err(|_| Error::BadParameter { name, value: text.to_owned(), range })
    }
}

impl fmt::Display for Windows {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtMost(count) => count.fmt(formatter),
            Self::All => formatter.write_str(ALL),
        }
    }
}

/// How far around the sources propagation searches exactly, at first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ExactSearch {
    /// As far as costs a fraction of the whole.
    #[default]
    Automatic,
    /// As far as so many windows reach.
    AtMost(usize),
}

/// What carries distance on beyond the exact search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Carriers {
    /// Windows of half-edges: every value is the length of a path.
    #[default]
    Windows,
    /// Vertices alone, by fast marching: less than half of the time of one window, and about twice its errors, to both sides.
    Vertices,
}

/// The options of propagation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PropagationOptions {
    /// Windows kept of each half-edge: the more, the nearer to the exact distance, and the slower.
    pub windows: Windows,
    /// How far the exact search goes.
    pub exact: ExactSearch,
    /// What goes on from there.
    pub carriers: Carriers,
}
