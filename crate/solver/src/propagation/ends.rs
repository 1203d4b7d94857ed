//! The ends of portals, which a front leaves a component by and enters another by.

use crate::exact::{Portals, Wavefront};

/// Number of the source of what has not been reached.
pub(super) const NOWHERE: u32 = u32::MAX;

/// What is known of the ends of all portals.
#[derive(Debug, Default)]
pub(super) struct Ends(Vec<End>);

#[derive(Debug, Clone, Copy)]
struct End {
    value: f64,
    /// Number of the source that it comes from.
    source: u32,
    /// Whether it was reached through the portal.
    is_entered: bool,
}

/// Share of a distance that rounding may take from it on the way to a vertex and back.
const ROUNDING: f64 = 1e-12;

const UNREACHED: End = End { value: f64::INFINITY, source: NOWHERE, is_entered: false };

impl Ends {
    /// So many that nothing has reached.
    pub fn clear(&mut self, count: usize) {
        self.0.clear();
        self.0.resize(count, UNREACHED);
    }

    /// As an exact search has left them. Gives those that are still to be passed, with their distances.
    pub fn start(&mut self, exact: &Wavefront) -> impl Iterator<Item = (u32, f64)> {
        let known =
            |(end, &value)| End { value, source: exact.source_of_end(end), is_entered: exact.entered(end).is_some() };
        self.0 = (0..).zip(exact.end_values()).map(known).collect();
        let is_ahead = |&(_, value): &(u32, f64)| value < f64::INFINITY && value >= exact.radius();
        (0..).zip(exact.end_values().iter().copied()).filter(is_ahead)
    }

    /// Offers an end a shorter path; whether it is one. What has entered by a portal and comes back to it is none, though rounding may say
    /// so.
    pub fn offer(&mut self, end: u32, value: f64, source: u32) -> bool {
        let known = &mut self.0[end as usize];
        let is_shorter = value < if known.is_entered { known.value * (1.0 - ROUNDING) } else { known.value };
        if is_shorter {
            *known = End { value, source, is_entered: false };
        }
        is_shorter
    }

    /// Lets what has reached an end pass its portal: the other end, its distance and its source, unless that is nearer by itself.
    pub fn pass(&mut self, portals: &Portals, end: u32) -> Option<(u32, f64, u32)> {
        let End { value, source, .. } = self.0[end as usize];
        let (value, other) = (value + portals.gap(end), Portals::across(end));
        if value >= self.0[other as usize].value {
            return None;
        }
        self.0[other as usize] = End { value, source, is_entered: true };
        Some((other, value, source))
    }

    /// The distance at an end that paths reach through its portal.
    pub fn entered(&self, end: u32) -> Option<f64> {
        Some(self.0[end as usize]).filter(|end| end.is_entered).map(|end| end.value)
    }
}
