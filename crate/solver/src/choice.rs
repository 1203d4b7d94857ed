//! Closed sets of choices, each with the name that the command line, a scene's link and the panel use.

use std::fmt::{Debug, Display};
use std::str::FromStr;

use thiserror::Error;

/// One of a closed set, by name.
pub trait Choice: Copy + Eq + Debug + Display + FromStr<Err = UnknownChoice> + Send + Sync + 'static {
    /// What is chosen, for messages.
    const WHAT: &'static str;
    /// Every choice, in the order in which they are offered.
    const ALL: &'static [Self];

    /// Its name.
    fn name(self) -> &'static str;

    /// Former names, which are still read.
    fn former_names(self) -> &'static [&'static str];
}

/// A name that is none of a [`Choice`]'s.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no {what} '{given}'; choose one of {}", .names.join(", "))]
pub struct UnknownChoice {
    /// What was to be chosen.
    pub what: &'static str,
    /// The name given.
    pub given: String,
    /// The names that there are.
    pub names: Vec<&'static str>,
}

/// The choice of this name.
///
/// # Errors
/// [`UnknownChoice`], with the names that there are.
pub(crate) fn by_name<C: Choice>(given: &str) -> Result<C, UnknownChoice> {
    let is_called = |choice: &&C| choice.name() == given || choice.former_names().contains(&given);
    C::ALL.iter().find(is_called).copied().ok_or_else(|| UnknownChoice {
        what: C::WHAT,
        given: given.to_owned(),
        names: C::ALL.iter().map(|choice| choice.name()).collect(),
    })
}

/// Makes an enum of variants without data a [`Choice`]: `choice!(Type, "what": Variant = "name" | "former name", ...)`.
/// A variant left out does not compile.
macro_rules! choice {
    ($type:ident, $what:literal: $($variant:ident = $name:literal $(| $former:literal)*),+ $(,)?) => {
        impl $crate::choice::Choice for $type {
            const WHAT: &'static str = $what;
            const ALL: &'static [Self] = &[$(Self::$variant),+];

            fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name),+
                }
            }

            fn former_names(self) -> &'static [&'static str] {
                match self {
                    $(Self::$variant => &[$($former),*]),+
                }
            }
        }

        impl ::std::str::FromStr for $type {
            type Err = $crate::choice::UnknownChoice;

            fn from_str(name: &str) -> ::std::result::Result<Self, Self::Err> {
                $crate::choice::by_name(name)
            }
        }

        impl ::std::fmt::Display for $type {
            fn fmt(&self, formatter: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                formatter.write_str($crate::choice::Choice::name(*self))
            }
        }
    };
}

pub(crate) use choice;
