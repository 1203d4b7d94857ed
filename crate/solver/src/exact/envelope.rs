//! Windows of one half-edge, each of which keeps what it reaches sooner than all others: their lower envelope.

use super::overlap::Overlap;
use super::window::Beam;
use crate::extremum::either;

/// Divides half-edges among windows. What it holds is kept for its memory.
#[derive(Debug, Default)]
pub(super) struct Envelope {
    /// Windows of two lists in order.
    joined: Vec<Beam>,
    /// Places in a list where two windows overlap.
    pairs: Vec<u32>,
    /// Whether there was no memory for a window.
    pub is_refused: bool,
}

impl Envelope {
    /// Divides a half-edge among the windows of a list, nearly in order along it.
    ///
    /// Which of them overlap the next one is as good as random, so that these are collected without a branch before anything is
    /// done about them. Windows only become shorter, and two are divided once, so that there is an end of it.
    pub fn resolve(&mut self, list: &mut Vec<Beam>) {
        let mut is_settled = false;
        while !is_settled {
            if !self.find_pairs(list) {
                return self.is_refused = true;
            }
            is_settled = true;
            let mut is_any_lost = false;
            for &pair in &self.pairs {
                let place = pair as usize;
                let [first, second, ..] = &mut list[place..] else { break };
                if second.begin < first.begin {
                    std::mem::swap(first, second);
                    is_settled = false;
                } else if !(first.is_wide() && first.overlaps(second)) {
                    // Lost or swapped just now: for the next round.
                } else if let Some((end, begin)) = settle(first, second) {
                    (first.end, second.begin) = (end, begin);
                    is_any_lost |= !(first.is_wide() & second.is_wide());
                } else {
                    if !divide(list, place) {
                        return self.is_refused = true;
                    }
                    // Places have moved.
                    is_any_lost = true;
                    break;
                }
            }
            if is_any_lost {
                // What is around the lost are neighbours now.
                list.retain(Beam::is_wide);
                is_settled = false;
            }
        }
    }

    /// Finds the windows of a list that overlap the next one, or begin after it. Returns whether there was room.
    fn find_pairs(&mut self, list: &[Beam]) -> bool {
        self.pairs.clear();
        if self.pairs.try_reserve(list.len()).is_err() {
            return false;
        }
        self.pairs.resize(list.len(), 0);
        let mut found = 0;
        for (place, pair) in list.windows(2).enumerate() {
            self.pairs[found] = place as u32;
            found += usize::from((pair[1].begin < pair[0].begin) | pair[0].overlaps(&pair[1]));
        }
        self.pairs.truncate(found);
        true
    }

    /// Divides a half-edge among the windows of a list and others, both nearly in order along it.
    pub fn join(&mut self, list: &mut Vec<Beam>, others: &[Beam]) {
        let (mut rest, mut others) = (list.as_slice(), others);
        if self.joined.try_reserve(rest.len() + others.len()).is_err() {
            return self.is_refused = true;
        }
        while let ([first, after_first @ ..], [other, after_other @ ..]) = (rest, others) {
            if other.begin < first.begin {
                self.push(other);
                others = after_other;
            } else {
                self.push(first);
                rest = after_first;
            }
        }
        rest.iter().chain(others).for_each(|window| self.push(window));
        std::mem::swap(&mut self.joined, list);
        self.joined.clear();
        self.resolve(list);
    }

    fn push(&mut self, window: &Beam) {
        match self.joined.last_mut() {
            Some(last) if last.continues_into(window) => last.end = window.end,
            _ => self.joined.push(*window),
        }
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

/// Divides a window of a list and the next one into as many parts as it takes. Returns whether there was room. A place
/// that no part needs is left with an empty window.
#[cold]
fn divide(list: &mut Vec<Beam>, place: usize) -> bool {
    let (first, second) = (list[place], list[place + 1]);
    let shares = Overlap::new(&second, &first).shares();
    if list.try_reserve(shares.as_slice().len()).is_err() {
        return false;
    }
    list[place].end = first.begin;
    list[place + 1].end = second.begin;
    for (number, &(is_second, begin, end)) in shares.as_slice().iter().enumerate() {
        let part = if is_second { second } else { first }.part(begin, end);
        if number < 2 {
            list[place + number] = part;
        } else {
            list.insert(place + number, part);
        }
    }
    true
}
