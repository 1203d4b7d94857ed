//! The windows that wait at each half-edge: a list without overlaps, in order along the half-edge.

use super::envelope::Envelope;
use super::list::{self, Bundles, List};
use super::window::Beam;
use crate::room;

#[cfg(test)]
mod tests;

/// Lists with room for more windows give their memory back once they are empty.
const LONG: usize = 256;

/// Whether there are bundles. What they take would be a hundredth of what the page loads until its first picture, where surfaces of so
/// many triangles that it pays are seldom opened.
pub(super) const HAS_BUNDLES: bool = cfg!(not(target_arch = "wasm32"));

/// Set in the numbers of lists that have bundles.
const BUNDLED: u32 = 1 << 31;

/// So many windows of a half-edge, at least, become a bundle. Where paths bend, and windows soon end, fewer would not repay it.
const MANY: usize = 64;

/// A list of windows for each half-edge, in memory for those that have any.
#[derive(Debug)]
pub(super) struct Lists {
    /// `3 #F`, the number of the half-edge's list; 0 where no window waits.
    numbers: Vec<u32>,
    /// Number 0 is always empty.
    lists: Vec<Vec<Beam>>,
    /// Of the lists that have any.
    bundles: Vec<Bundles>,
    /// Numbers of lists that no half-edge has.
    free: Vec<u32>,
    envelope: Envelope,
    /// So many windows become a bundle: [`MANY`], fewer in tests.
    pub many: usize,
    /// Whether there was no memory for a list, whose windows are lost.
    is_refused: bool,
}

impl Lists {
    pub fn new(halfedges: usize) -> Self {
        Self {
            numbers: vec![0; halfedges],
            lists: vec![Vec::new()],
            bundles: Vec::new(),
            free: Vec::new(),
            envelope: Envelope::default(),
            many: MANY,
            is_refused: false,
        }
    }

    /// The number of half-edges.
    pub fn len(&self) -> usize {
        self.numbers.len()
    }

    /// What divides half-edges among windows.
    pub fn envelope(&mut self) -> &mut Envelope {
        &mut self.envelope
    }

    /// Whether there was no memory for windows, which are lost.
    pub fn is_refused(&self) -> bool {
        self.is_refused | self.envelope.is_refused
    }

    /// Forgets all windows.
    pub fn clear_all(&mut self) {
        (0..self.numbers.len() as u32).for_each(|halfedge| self.clear(halfedge));
        (self.is_refused, self.envelope.is_refused) = (false, false);
    }

    /// The windows that wait at a half-edge, without those in bundles.
    pub fn at(&self, halfedge: u32) -> &[Beam] {
        &self.lists[(self.numbers[halfedge as usize] & !BUNDLED) as usize]
    }

    /// Each of the windows that wait at a half-edge, in order.
    pub fn for_each_at(&self, halfedge: u32, tell: impl FnMut(Beam)) {
        let number = self.numbers[halfedge as usize];
        let bundles: &[_] = if is_bundled(number) { &self.bundles[(number & !BUNDLED) as usize] } else { &[] };
        list::for_each(self.at(halfedge), bundles, tell);
    }

    /// The windows that wait at a half-edge, to be changed where they stay in order; bundles are opened.
    pub fn at_mut(&mut self, halfedge: u32) -> &mut Vec<Beam> {
        let number = self.numbers[halfedge as usize];
        if is_bundled(number) {
            let mut list = List::default();
            list.bundles = self.take(halfedge, &mut list.windows);
            list.open();
            self.is_refused |= list.is_refused;
            if let Some(number) = self.occupy(halfedge) {
                self.lists[number] = list.windows;
            }
        }
        &mut self.lists[(self.numbers[halfedge as usize] & !BUNDLED) as usize]
    }

    /// Takes all windows of a half-edge out; `windows` is empty before, and its memory is kept for later.
    pub fn take(&mut self, halfedge: u32, windows: &mut Vec<Beam>) -> Bundles {
        let number = std::mem::take(&mut self.numbers[halfedge as usize]);
        if number == 0 {
            return Bundles::new();
        }
        std::mem::swap(&mut self.lists[(number & !BUNDLED) as usize], windows);
        self.release(number)
    }

    /// Lets the windows that wait at a half-edge be forgotten.
    pub fn clear(&mut self, halfedge: u32) {
        let number = std::mem::take(&mut self.numbers[halfedge as usize]);
        if number != 0 {
            self.lists[(number & !BUNDLED) as usize].clear();
            self.release(number);
        }
    }

    /// Lets a list be another half-edge's. Returns its bundles.
    fn release(&mut self, number: u32) -> Bundles {
        let (is_bundled, number) = (is_bundled(number), number & !BUNDLED);
        let list = &mut self.lists[number as usize];
        if list.capacity() > LONG {
            *list = Vec::new();
        }
        self.free.push(number);
        if is_bundled { std::mem::take(&mut self.bundles[number as usize]) } else { Bundles::new() }
    }

    /// Adds windows, nearly in order along the half-edge, to those that wait there; where some overlap, each keeps what it
    /// reaches sooner. What `windows` holds then is of no meaning, but its memory.
    pub fn add(&mut self, halfedge: u32, windows: &mut Vec<Beam>) {
        let number = self.numbers[halfedge as usize];
        if is_bundled(number) {
            return self.add_list(halfedge, List::new(std::mem::take(windows), Bundles::new()));
        }
        if number != 0 {
            return self.envelope.join(&mut self.lists[number as usize], windows);
        }
        if let Some(number) = self.occupy(halfedge) {
            let list = &mut self.lists[number];
            std::mem::swap(list, windows);
            self.envelope.resolve(list);
        }
    }

    /// The same for a list with bundles.
    #[inline(never)]
    pub fn add_list(&mut self, halfedge: u32, mut list: List) {
        let mut waiting = List::default();
        waiting.bundles = self.take(halfedge, &mut waiting.windows);
        if waiting.windows.is_empty() {
            self.envelope.resolve_list(&mut list);
        } else {
            self.envelope.join_lists(&mut waiting, list);
            list = waiting;
        }
        self.is_refused |= list.is_refused;
        let Some(number) = self.occupy(halfedge) else { return };
        self.lists[number] = list.windows;
        if list.bundles.is_empty() {
            return;
        }
        let more = (number + 1).saturating_sub(self.bundles.len());
        if self.bundles.try_reserve(more).is_err() {
            return self.is_refused = true;
        }
        self.bundles.extend(std::iter::repeat_with(Bundles::new).take(more));
        self.numbers[halfedge as usize] |= BUNDLED;
        self.bundles[number] = list.bundles;
    }

    /// Gives a half-edge a list of its own, and its number, where there is room.
    fn occupy(&mut self, halfedge: u32) -> Option<usize> {
        let number = match self.free.pop() {
            Some(number) => number,
            // Every list can become free.
            None if room::push(&mut self.lists, Vec::new()) && self.free.try_reserve(self.lists.len()).is_ok() => {
                self.lists.len() as u32 - 1
            }
            None => {
                self.is_refused = true;
                return None;
            }
        };
        self.numbers[halfedge as usize] = number;
        Some(number as usize)
    }

    /// Puts the windows of a half-edge of this length into a bundle, where there are many. Each face that bundles cross leaves a few more
    /// windows outside of them: at the square root of their number, these begin to cost more than to gather all anew. Returns whether it
    /// has done so.
    pub fn gather(&mut self, list: &mut List, length: f64) -> bool {
        let count = list.count();
        let is_worth = count >= self.many && list.windows.len().pow(2) >= count;
        if is_worth {
            list.open();
            self.envelope.resolve_list(list);
            list.gather(length);
        }
        is_worth
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let windows: usize = self.lists.iter().map(Vec::capacity).sum();
        let bundled: usize = self.bundles.iter().flatten().map(|(_, bundle)| bundle.bytes()).sum();
        size_of::<Beam>() * windows + bundled + size_of::<Vec<Beam>>() * self.lists.capacity() + 4 * self.numbers.len()
    }
}

fn is_bundled(number: u32) -> bool {
    HAS_BUNDLES && number & BUNDLED != 0
}
