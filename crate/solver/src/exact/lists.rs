//! The windows that wait at each half-edge: a list without overlaps, in order along the half-edge.

use super::overlap::Overlap;
use super::window::Window;
use crate::extremum::smaller;
use crate::room;

#[cfg(test)]
mod tests;

/// Lists with room for more windows give their memory back once they are empty.
const LONG: usize = 256;

/// A list of windows for each half-edge, in memory for those that have any.
#[derive(Debug)]
pub(super) struct Lists {
    /// `3 #F`, the number of the half-edge's list; 0 where no window waits.
    numbers: Vec<u32>,
    /// Number 0 is always empty.
    lists: Vec<Vec<Window>>,
    /// Numbers of lists that no half-edge has.
    free: Vec<u32>,
    merge: Merge,
}

impl Lists {
    pub fn new(halfedges: usize) -> Self {
        Self { numbers: vec![0; halfedges], lists: vec![Vec::new()], free: Vec::new(), merge: Merge::default() }
    }

    /// The number of half-edges.
    pub fn len(&self) -> usize {
        self.numbers.len()
    }

    /// Whether there was no memory for windows, which are lost.
    pub fn is_refused(&self) -> bool {
        self.merge.is_refused
    }

    /// Forgets all windows.
    pub fn clear_all(&mut self) {
        (0..self.numbers.len() as u32).for_each(|halfedge| self.clear(halfedge));
        self.merge.is_refused = false;
    }

    /// The windows that wait at a half-edge.
    pub fn at(&self, halfedge: u32) -> &[Window] {
        &self.lists[self.numbers[halfedge as usize] as usize]
    }

    /// Takes all windows of a half-edge out; `windows` is empty before, and its memory is kept for later.
    pub fn take(&mut self, halfedge: u32, windows: &mut Vec<Window>) {
        let number = std::mem::take(&mut self.numbers[halfedge as usize]);
        if number != 0 {
            std::mem::swap(&mut self.lists[number as usize], windows);
            self.release(number);
        }
    }

    /// Lets the windows that wait at a half-edge be forgotten.
    pub fn clear(&mut self, halfedge: u32) {
        let number = std::mem::take(&mut self.numbers[halfedge as usize]);
        if number != 0 {
            self.lists[number as usize].clear();
            self.release(number);
        }
    }

    fn release(&mut self, number: u32) {
        let list = &mut self.lists[number as usize];
        if list.capacity() > LONG {
            *list = Vec::new();
        }
        self.free.push(number);
    }

    /// Adds windows, nearly in order along the half-edge, to those that wait there; where some overlap, each keeps what it
    /// reaches sooner.
    pub fn add(&mut self, halfedge: u32, windows: &[Window]) {
        let number = &mut self.numbers[halfedge as usize];
        if *number == 0 {
            *number = match self.free.pop() {
                Some(number) => number,
                // Every list can become free.
                None if room::push(&mut self.lists, Vec::new()) && self.free.try_reserve(self.lists.len()).is_ok() => {
                    self.lists.len() as u32 - 1
                }
                None => return self.merge.is_refused = true,
            };
        }
        self.merge.add(&mut self.lists[*number as usize], windows);
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let windows: usize = self.lists.iter().map(Vec::capacity).sum();
        size_of::<Window>() * windows + size_of::<Vec<Window>>() * self.lists.capacity() + 4 * self.numbers.len()
    }
}

/// Merges windows into a list. What it holds is kept for its memory.
#[derive(Debug, Default)]
struct Merge {
    waiting: Vec<Window>,
    /// Windows of the list that begin after the next to be added, the first of them last.
    later: Vec<Window>,
    /// Whether there was no memory for a window.
    is_refused: bool,
}

impl Merge {
    fn add(&mut self, list: &mut Vec<Window>, windows: &[Window]) {
        let mut waiting = std::mem::take(&mut self.waiting);
        std::mem::swap(list, &mut waiting);
        let mut rest = waiting.iter();
        for window in windows {
            if !(rest.as_slice().is_empty() && self.later.is_empty()) {
                self.append_before(window.begin, list, &mut rest);
            }
            self.append(list, window);
        }
        self.append_before(f64::INFINITY, list, &mut rest);
        waiting.clear();
        self.waiting = waiting;
    }

    /// Appends what begins before `limit`.
    fn append_before(&mut self, limit: f64, list: &mut Vec<Window>, waiting: &mut std::slice::Iter<Window>) {
        loop {
            let later = self.later.last().map_or(limit, |window| window.begin);
            match waiting.as_slice().first() {
                Some(window) if window.begin < smaller(later, limit) => {
                    waiting.next();
                    self.append(list, window);
                }
                _ if later < limit => {
                    let window = self.later.pop();
                    window.iter().for_each(|window| self.append(list, window));
                }
                _ => return,
            }
        }
    }

    /// Appends a window; those of the list that begin after it wait until what comes next begins after them.
    #[inline]
    fn append(&mut self, list: &mut Vec<Window>, window: &Window) {
        while list.last().is_some_and(|last| last.begin > window.begin) {
            self.put_off(list);
        }
        match list.last_mut() {
            Some(last) if last.continues_into(window) => (last.end, last.at_end) = (window.end, window.at_end),
            Some(last) if last.end > window.begin => self.is_refused |= !divide(list, window),
            _ => self.is_refused |= !room::push(list, *window),
        }
    }

    #[cold]
    fn put_off(&mut self, list: &mut Vec<Window>) {
        if let Some(last) = list.pop() {
            let place = self.later.partition_point(|later| later.begin > last.begin);
            if self.later.try_reserve(1).is_ok() {
                self.later.insert(place, last);
            } else {
                self.is_refused = true;
            }
        }
    }
}

/// Appends a window that overlaps the last one of a list and does not begin before it. Returns whether there was room.
fn divide(list: &mut Vec<Window>, window: &Window) -> bool {
    let Some(last) = list.last_mut() else { return true };
    let overlap = Overlap::new(window, last);
    let reaches_past = window.end >= last.end;
    let mut rest = *window;
    // Mostly one ends where the other begins.
    match (overlap.begin.1 < 0.0, overlap.end.1 < 0.0) {
        (false, false) if overlap.turn().is_none() => {
            if !reaches_past {
                return true;
            }
            (rest.begin, rest.at_begin) = (last.end, last.at_end + overlap.end.1);
        }
        (true, true) if reaches_past && overlap.turn().is_none() => {
            (last.end, last.at_end) = (window.begin, window.at_begin - overlap.begin.1);
        }
        (false, true) if reaches_past => {
            let meeting = overlap.change();
            (last.end, last.at_end) = (meeting.place, meeting.second);
            (rest.begin, rest.at_begin) = (meeting.place, meeting.first);
        }
        _ => {
            let (shares, last) = (overlap.shares(), *last);
            let part = |&(is_new, begin, end)| if is_new { window } else { &last }.part(begin, end);
            list.pop();
            if list.try_reserve(shares.as_slice().len()).is_err() {
                return false;
            }
            list.extend(shares.as_slice().iter().map(part).filter(Window::is_wide));
            return true;
        }
    }
    list.pop_if(|last| !last.is_wide());
    !rest.is_wide() || room::push(list, rest)
}
