//! Any windows of one half-edge divided among each other at once, however many lie on each other: lists of windows that do not
//! overlap are merged in pairs, the results of that in pairs again.
//!
//! Distances of two windows are equal at two places at most, so that of n windows hardly more than n parts are left, some each at most
//! (Davenport & Schinzel, "A combinatorial problem connected with differential equations", 1965), and all of it takes n log n.

use super::overlap::Overlap;
use super::window::Beam;
use crate::room;

#[cfg(test)]
mod tests;

/// Merges lists. What it holds is kept for its memory.
#[derive(Debug, Default)]
pub(super) struct Merge {
    /// Windows of merged lists, one list after the other.
    merged: Vec<Beam>,
    /// Where the lists end that are still to be merged.
    ends: Vec<usize>,
    /// Windows that have been looked at.
    #[cfg(test)]
    pub looked_at: usize,
}

impl Merge {
    /// Leaves of the windows of a list, in any order, what each reaches sooner than all others, in order along the half-edge. They may
    /// overlap by what is seen under an angle of a `sliver`. Returns whether there was room.
    #[cold]
    pub fn merge(&mut self, list: &mut Vec<Beam>, sliver: f64) -> bool {
        let Self { merged, ends, .. } = self;
        ends.clear();
        let breaks = (1..list.len()).filter(|&place| {
            let [first, second] = [&list[place - 1], &list[place]];
            second.begin < first.begin || first.overlaps(second, sliver)
        });
        let is_kept = breaks.chain([list.len()]).all(|end| room::push(ends, end));
        if !is_kept {
            return false;
        }
        while ends.len() > 1 {
            #[cfg(test)]
            {
                self.looked_at += list.len();
            }
            merged.clear();
            let mut from = 0;
            for pair in 0..ends.len().div_ceil(2) {
                let [middle, end] = [2 * pair, 2 * pair + 1].map(|number| ends[number.min(ends.len() - 1)]);
                if !merge_two(merged, [&list[from..middle], &list[middle..end]], sliver) {
                    return false;
                }
                ends[pair] = merged.len();
                from = end;
            }
            ends.truncate(ends.len().div_ceil(2));
            std::mem::swap(merged, list);
        }
        true
    }
}

/// Adds what is left of the windows of two lists to a third. Returns whether there was room.
fn merge_two(merged: &mut Vec<Beam>, lists: [&[Beam]; 2], sliver: f64) -> bool {
    let before = merged.len();
    let mut rest = lists.map(|list| list.iter().copied());
    let mut heads = rest.each_mut().map(Iterator::next);
    let mut has_room = true;
    while let [Some(first), Some(second)] = heads {
        let sooner = usize::from(second.begin < first.begin);
        let [begins, follows] = if sooner == 0 { [first, second] } else { [second, first] };
        if !begins.overlaps(&follows, sliver) {
            has_room &= add(merged, before, begins);
            heads[sooner] = rest[sooner].next();
            continue;
        }
        let overlap = Overlap::new(&second, &first);
        let (shares, end) = (overlap.shares(), overlap.end.0);
        let mut tail = None;
        for &(is_second, from, to) in shares.as_slice() {
            tail.into_iter().for_each(|part| has_room &= add(merged, before, part));
            tail = Some(if is_second { second } else { first }.part(from, to));
        }
        // What is beyond the overlap may lie on more of the other list.
        heads = [first, second].map(|window| tail.filter(|_| window.end > end));
        if heads == [None; 2] {
            tail.into_iter().for_each(|part| has_room &= add(merged, before, part));
        }
        for (head, rest) in heads.iter_mut().zip(&mut rest).filter(|(head, _)| head.is_none()) {
            *head = rest.next();
        }
    }
    for (head, rest) in heads.into_iter().zip(rest) {
        head.into_iter().chain(rest).for_each(|window| has_room &= add(merged, before, window));
    }
    has_room
}

/// Adds a window to a list that begins at a place, if it is worth following. Returns whether there was room.
fn add(merged: &mut Vec<Beam>, first: usize, window: Beam) -> bool {
    !window.is_wide() || goes_on(&mut merged[first..], &window) || room::push(merged, window)
}

/// Whether a window goes on where the last one of a list ends, which it then becomes a part of.
#[inline(always)]
pub(super) fn goes_on(list: &mut [Beam], window: &Beam) -> bool {
    let last = list.last_mut().filter(|last| last.continues_into(window));
    last.is_some_and(|last| {
        last.end = window.end;
        true
    })
}
