//! Windows of one half-edge, each of which keeps what it reaches sooner than all others: their lower envelope.

use super::list::List;
use super::merge::{Merge, goes_on};
use super::overlap::Overlap;
use super::window::{Beam, SLIVER, THIN};
use crate::extremum::{either, larger, smaller};
use crate::room;

#[cfg(test)]
mod tests;

/// Lists of fewer windows are never crowded.
const CROWD: usize = 16;

/// So many times at most, neighbors in a list are divided: hardly an ordinary list needs more. A window that lies on many others comes
/// past one of them each time, so that the rest are merged.
const ROUNDS: usize = 24;

/// Divides half-edges among windows. What it holds is kept for its memory.
#[derive(Debug, Default)]
pub(super) struct Envelope {
    /// Windows of two lists in order.
    joined: Vec<Beam>,
    /// Places in a list where two windows overlap.
    pairs: Vec<u32>,
    /// Parts of windows that come into a list, each with the place that it comes after.
    parts: Vec<(u32, Beam)>,
    merge: Merge,
    /// Whether there was no memory for a window.
    pub is_refused: bool,
    /// Windows that have been looked at, as often as they were.
    #[cfg(test)]
    pub looked_at: usize,
}

impl Envelope {
    /// Divides a half-edge among the windows of a list, nearly in order along it.
    ///
    /// Which of them overlap the next one is as good as random, so that these are collected without a branch before anything is
    /// done about them.
    pub fn resolve(&mut self, list: &mut Vec<Beam>) {
        if is_crowded(list) {
            return self.merge(list, THIN);
        }
        for _ in 0..ROUNDS {
            if !self.find_pairs(list, SLIVER) {
                return self.is_refused = true;
            }
            let (mut is_settled, mut is_any_lost) = (true, false);
            for &pair in &self.pairs {
                let place = pair as usize;
                let [first, second, ..] = &mut list[place..] else { break };
                if second.begin < first.begin {
                    std::mem::swap(first, second);
                    is_settled = false;
                } else if !(first.is_wide() && first.overlaps(second, SLIVER)) {
                    // Lost or swapped just now: for the next round.
                } else if let Some((end, begin)) = settle(first, second) {
                    (first.end, second.begin) = (end, begin);
                    is_any_lost |= !(first.is_wide() & second.is_wide());
                } else {
                    self.is_refused |= !divide([first, second], pair + 1, &mut self.parts);
                    is_any_lost = true;
                }
            }
            if is_any_lost {
                self.is_refused |= !insert(list, &mut self.parts);
                // What is around the lost are neighbors now.
                list.retain(Beam::is_wide);
            }
            if is_settled && !is_any_lost {
                return;
            }
        }
        self.merge(list, SLIVER);
    }

    /// Divides a half-edge among the windows of a list, in any order along it, all at once.
    #[cold]
    fn merge(&mut self, list: &mut Vec<Beam>, sliver: f64) {
        self.is_refused |= !self.merge.merge(list, sliver);
        #[cfg(test)]
        {
            self.looked_at += std::mem::take(&mut self.merge.looked_at);
        }
    }

    /// The same for a list with bundles, which may open.
    pub fn resolve_list(&mut self, list: &mut List) {
        if !list.is_plain() && !self.settle_beside_bundles(list) {
            list.open();
        }
        if list.is_plain() {
            self.resolve(&mut list.windows);
        }
    }

    /// Divides what is between the windows beside and between the bundles of a list. Returns whether no more was to do.
    fn settle_beside_bundles(&mut self, list: &mut List) -> bool {
        loop {
            if !self.find_pairs(&list.windows, SLIVER) {
                self.is_refused = true;
                return true;
            }
            let mut is_any_lost = false;
            for &pair in &self.pairs {
                let place = pair as usize;
                if list.has_bundle_after(place) {
                    return false;
                }
                let [first, second, ..] = &mut list.windows[place..] else { break };
                if second.begin < first.begin {
                    return false;
                }
                if first.is_wide() && first.overlaps(second, SLIVER) {
                    let Some((end, begin)) = settle(first, second) else { return false };
                    (first.end, second.begin) = (end, begin);
                    is_any_lost |= !(first.is_wide() & second.is_wide());
                }
            }
            if !is_any_lost {
                return true;
            }
            list.retain(&Beam::is_wide);
        }
    }

    /// Finds the windows of a list that overlap the next one, or begin after it. Returns whether there was room.
    fn find_pairs(&mut self, list: &[Beam], sliver: f64) -> bool {
        self.pairs.clear();
        if self.pairs.try_reserve(list.len()).is_err() {
            return false;
        }
        self.pairs.resize(list.len(), 0);
        #[cfg(test)]
        {
            self.looked_at += list.len();
        }
        let mut found = 0;
        for (place, pair) in list.windows(2).enumerate() {
            self.pairs[found] = place as u32;
            found += usize::from((pair[1].begin < pair[0].begin) | pair[0].overlaps(&pair[1], sliver));
        }
        self.pairs.truncate(found);
        true
    }

    /// Divides a half-edge among the windows of a list and others, both nearly in order along it.
    pub fn join(&mut self, list: &mut Vec<Beam>, others: &[Beam]) {
        let (mut rest, mut others) = (list.as_slice(), others);
        #[cfg(test)]
        {
            self.looked_at += rest.len() + others.len();
        }
        if self.joined.try_reserve(rest.len() + others.len()).is_err() {
            return self.is_refused = true;
        }
        while let ([first, after_first @ ..], [other, after_other @ ..]) = (rest, others) {
            if other.begin < first.begin {
                push(&mut self.joined, other);
                others = after_other;
            } else {
                push(&mut self.joined, first);
                rest = after_first;
            }
        }
        rest.iter().chain(others).for_each(|window| push(&mut self.joined, window));
        std::mem::swap(&mut self.joined, list);
        self.joined.clear();
        self.resolve(list);
    }

    /// The same for lists with bundles, which may open.
    pub fn join_lists(&mut self, list: &mut List, mut others: List) {
        if list.is_entangled_with(&others) || others.is_entangled_with(list) {
            list.open();
            others.open();
        }
        let mut bundles =
            [&mut *list, &mut others].map(|list| std::mem::take(&mut list.bundles).into_iter().peekable());
        let mut joined = List::new(std::mem::take(&mut self.joined), Vec::new());
        let mut places = [0, 0];
        loop {
            let (k, window) = match [list.windows.get(places[0]), others.windows.get(places[1])] {
                [Some(first), Some(other)] if other.begin < first.begin => (1, other),
                [Some(first), _] => (0, first),
                [None, Some(other)] => (1, other),
                [None, None] => break,
            };
            if !goes_on(&mut joined.windows, window) {
                joined.push(*window);
            }
            if let Some((_, bundle)) = bundles[k].next_if(|&(after, _)| after as usize == places[k]) {
                joined.push_bundle(bundle);
            }
            places[k] += 1;
        }
        joined.is_refused |= list.is_refused | others.is_refused;
        self.joined = std::mem::replace(list, joined).windows;
        self.joined.clear();
        self.resolve_list(list);
    }
}

/// Whether most windows of a list lie on the next one, all of them so narrow that both would stay as they are: where the same light
/// comes by many ways around thin triangles, there would be more of them at each edge.
fn is_crowded(list: &[Beam]) -> bool {
    let covers = |pair: &&[Beam]| {
        let [first, second] = [&pair[0], &pair[1]];
        let width = smaller(first.end - first.begin, second.end - second.begin);
        smaller(first.end, second.end) - larger(first.begin, second.begin) > 0.5 * width
    };
    list.len() > CROWD && 2 * list.windows(2).filter(covers).count() > list.len()
}

fn push(list: &mut Vec<Beam>, window: &Beam) {
    if !goes_on(list, window) {
        list.push(*window);
    }
}

/// Where the first of two windows that overlap is to end, and where the second one is to begin, if that is all.
#[inline(always)]
fn settle(first: &Beam, second: &Beam) -> Option<(f64, f64)> {
    let overlap = Overlap::new(second, first);
    let (begins, ends) = (overlap.begin.1 < 0.0, overlap.end.1 < 0.0);
    if (begins & !ends) | (ends & (second.end < first.end)) || overlap.turn().is_some() {
        return None;
    }
    let meeting = overlap.change();
    let end = either(begins, second.begin, either(ends, meeting, first.end));
    let begin = either(begins, second.begin, either(ends, meeting, overlap.end.0));
    Some((end, begin))
}

/// Divides a window and the next one into as many parts as it takes. The third and further ones come after a place. Returns whether
/// there was room. A place that no part needs is left with an empty window.
#[cold]
fn divide(pair: [&mut Beam; 2], after: u32, parts: &mut Vec<(u32, Beam)>) -> bool {
    let [first, second] = [*pair[0], *pair[1]];
    let shares = Overlap::new(&second, &first).shares();
    let part = |&(is_second, begin, end): &(bool, f64, f64)| if is_second { second } else { first }.part(begin, end);
    let mut all = shares.as_slice().iter().map(part);
    for window in pair {
        *window = all.next().unwrap_or(window.part(window.begin, window.begin));
    }
    all.all(|part| room::push(parts, (after, part)))
}

/// Lets parts come into a list, each after its place, in order. Returns whether there was room.
fn insert(list: &mut Vec<Beam>, parts: &mut Vec<(u32, Beam)>) -> bool {
    if list.try_reserve(parts.len()).is_err() {
        parts.clear();
        return false;
    }
    let (mut from, mut to) = (list.len(), list.len() + parts.len());
    list.extend(parts.iter().map(|&(_, part)| part));
    while let Some((after, part)) = parts.pop() {
        let next = after as usize + 1;
        to -= from - next + 1;
        list.copy_within(next..from, to + 1);
        list[to] = part;
        from = next;
    }
    true
}
