//! The windows that wait at each half-edge: a list without overlaps, in order along the half-edge.

use super::envelope::Envelope;
use super::window::Beam;
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
    lists: Vec<Vec<Beam>>,
    /// Numbers of lists that no half-edge has.
    free: Vec<u32>,
    envelope: Envelope,
    /// Whether there was no memory for a list, whose windows are lost.
    is_refused: bool,
}

impl Lists {
    pub fn new(halfedges: usize) -> Self {
        Self {
            numbers: vec![0; halfedges],
            lists: vec![Vec::new()],
            free: Vec::new(),
            envelope: Envelope::default(),
            is_refused: false,
        }
    }

    /// The number of half-edges.
    pub fn len(&self) -> usize {
        self.numbers.len()
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

    /// The windows that wait at a half-edge.
    pub fn at(&self, halfedge: u32) -> &[Beam] {
        &self.lists[self.numbers[halfedge as usize] as usize]
    }

    /// Takes all windows of a half-edge out; `windows` is empty before, and its memory is kept for later.
    pub fn take(&mut self, halfedge: u32, windows: &mut Vec<Beam>) {
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
    /// reaches sooner. What `windows` holds then is of no meaning, but its memory.
    pub fn add(&mut self, halfedge: u32, windows: &mut Vec<Beam>) {
        let number = &mut self.numbers[halfedge as usize];
        if *number != 0 {
            return self.envelope.join(&mut self.lists[*number as usize], windows);
        }
        *number = match self.free.pop() {
            Some(number) => number,
            // Every list can become free.
            None if room::push(&mut self.lists, Vec::new()) && self.free.try_reserve(self.lists.len()).is_ok() => {
                self.lists.len() as u32 - 1
            }
            None => return self.is_refused = true,
        };
        let list = &mut self.lists[*number as usize];
        std::mem::swap(list, windows);
        self.envelope.resolve(list);
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let windows: usize = self.lists.iter().map(Vec::capacity).sum();
        size_of::<Beam>() * windows + size_of::<Vec<Beam>>() * self.lists.capacity() + 4 * self.numbers.len()
    }
}
