//! The windows that wait at each half-edge: a list without overlaps, in order along the half-edge.

use super::geometry::ExactGeometry;
use super::overlap::Overlap;
use super::wavefront::Wavefront;
use super::window::Window;
use crate::extremum::smaller;

/// Where in the list of a half-edge the next window is looked for.
struct Cursor {
    halfedge: u32,
    /// The last window that ends before `begin`, 0 for none.
    before: u32,
    begin: f64,
}

impl Wavefront {
    /// Brings windows that leave a face by a half-edge, in order along that edge against the half-edge's direction, to the
    /// half-edges on the other faces of the edge.
    pub(super) fn deliver(&mut self, geometry: &ExactGeometry, halfedge: u32, leaving: &[Window]) {
        let (frame, k) = geometry.frame_of(halfedge);
        for (target, is_mirrored) in geometry.across(halfedge) {
            let mut cursor = Cursor { halfedge: target, before: 0, begin: f64::NEG_INFINITY };
            if is_mirrored {
                for window in leaving.iter().rev() {
                    self.insert(window.mirrored(frame[k].length), &mut cursor);
                }
            } else {
                for &window in leaving {
                    self.insert(window, &mut cursor);
                }
            }
        }
    }

    /// Puts a window into the list of a half-edge; where it overlaps others, each keeps what it reaches sooner.
    fn insert(&mut self, mut window: Window, cursor: &mut Cursor) {
        if window.begin < cursor.begin {
            cursor.before = 0;
        }
        cursor.begin = window.begin;
        let mut before = cursor.before;
        let mut current = self.following(cursor.halfedge, before);
        while current != 0 && self.windows[current as usize].end <= window.begin {
            before = current;
            current = self.windows[current as usize].next;
        }
        cursor.before = before;
        if let Some(nearest) = self.join(before, current, &window) {
            self.queue.push(cursor.halfedge, nearest);
            return;
        }
        let mut nearest = f64::INFINITY;
        loop {
            if current == 0 || self.windows[current as usize].begin >= window.end {
                if window.is_wide() {
                    nearest = smaller(nearest, window.nearest());
                    self.link(cursor.halfedge, before, current, window);
                }
                break;
            }
            let other = self.windows[current as usize];
            let overlap = Overlap::new(&window, &other);
            let (begins_ahead, ends_ahead) = (overlap.begin.1 < 0.0, overlap.end.1 < 0.0);
            // Two neighbours meet in one point: by far the most frequent case.
            if other.begin <= window.begin && other.end < window.end && !begins_ahead && ends_ahead {
                let change = overlap.change();
                window = window.part(change, window.end);
                let kept = other.part(other.begin, change);
                self.windows[current as usize] = kept;
                if kept.is_wide() {
                    before = current;
                } else {
                    self.relink(cursor.halfedge, before, other.next);
                    self.release(current);
                }
                current = other.next;
                continue;
            }
            if window.begin < other.begin && window.end <= other.end && begins_ahead && !ends_ahead {
                let change = overlap.change();
                self.windows[current as usize] = other.part(change, other.end);
                window = window.part(window.begin, change);
                continue;
            }
            let shares = overlap.shares();
            if let [(false, ..)] = shares.as_slice() {
                break;
            }
            self.release(current);
            current = other.next;
            self.relink(cursor.halfedge, before, current);
            let mut rest = None;
            for (index, &(is_new, begin, end)) in shares.as_slice().iter().enumerate() {
                let share = if is_new { &window } else { &other }.part(begin, end);
                if is_new && index + 1 == shares.as_slice().len() && end > other.end {
                    rest = Some(share);
                } else if share.is_wide() {
                    if is_new {
                        nearest = smaller(nearest, share.nearest());
                    }
                    before = self.link(cursor.halfedge, before, current, share);
                }
            }
            match rest {
                Some(share) => window = share,
                None => break,
            }
        }
        if nearest < f64::INFINITY {
            self.queue.push(cursor.halfedge, nearest);
        }
    }

    /// Where a window only continues one of its neighbours in the list, past a vertex around which the surface is flat,
    /// makes them one; returns its least distance.
    fn join(&mut self, before: u32, current: u32, window: &Window) -> Option<f64> {
        // The two may overlap by rounding, and then the neighbour counts as the one that follows.
        let neighbours = [before, current].into_iter().filter(|&number| number != 0);
        for number in neighbours {
            let other = self.windows[number as usize];
            let after = other.next;
            if other.continues_into(window) {
                if after != 0 && self.windows[after as usize].begin < window.end {
                    return None;
                }
                self.windows[number as usize] = Window { next: after, ..other.part(other.begin, window.end) };
            } else if window.continues_into(&other) {
                self.windows[number as usize] = other.part(window.begin, other.end);
            } else {
                continue;
            }
            return Some(self.windows[number as usize].nearest());
        }
        None
    }

    fn following(&self, halfedge: u32, before: u32) -> u32 {
        if before == 0 { self.heads[halfedge as usize] } else { self.windows[before as usize].next }
    }

    fn relink(&mut self, halfedge: u32, before: u32, next: u32) {
        if before == 0 {
            self.heads[halfedge as usize] = next;
        } else {
            self.windows[before as usize].next = next;
        }
    }

    /// Puts a window between two of a list; returns its number.
    fn link(&mut self, halfedge: u32, before: u32, next: u32, window: Window) -> u32 {
        let window = Window { next, ..window };
        let number = if self.free == 0 {
            self.windows.push(window);
            self.windows.len() as u32 - 1
        } else {
            let number = self.free;
            self.free = std::mem::replace(&mut self.windows[number as usize], window).next;
            number
        };
        self.relink(halfedge, before, number);
        number
    }

    pub(super) fn release(&mut self, number: u32) {
        self.windows[number as usize].next = self.free;
        self.free = number;
    }
}
