//! Half-edges where so many windows wait that most of them cross the face in bundles.

use super::bundle::Motion;
use super::geometry::{ExactGeometry, Side, after, before};
use super::list::List;
use super::wavefront::Wavefront;
use super::window::Beam;

#[cfg(test)]
mod tests;

/// Most bundles that cross a face add no more windows.
const ROOM: usize = 4;

impl Wavefront {
    /// Lets windows of which there are many, or that are in bundles, enter the face of a half-edge where they have waited.
    #[inline(never)]
    pub(super) fn cross_in_bundles(&mut self, geometry: &ExactGeometry, halfedge: u32, mut list: List) {
        let (frame, k) = geometry.frame_of(halfedge);
        let sides = frame.seen_from(k);
        let [base, right, left] = sides;
        list.retain(&|window| self.is_current(window));
        list.clip(base.length, [base, right].map(|side| self.limit(side.vertex)));
        if self.targets.are_in(halfedge / 3) || self.ends.are_in(halfedge / 3) {
            list.open();
            self.see(frame, halfedge, &list.windows);
        }
        if self.waiting.gather(&mut list, base.length) {
            self.propagated += list.count();
        }
        self.propagated += list.windows.len();

        let mut leaving = [List::default(), List::default()];
        for way in &mut leaving {
            self.is_refused |= way.windows.try_reserve(list.windows.len() + ROOM).is_err();
        }
        let opposite = frame.opposite(k);
        let mut bundles = list.bundles.into_iter().peekable();
        for (place, window) in list.windows.iter().enumerate() {
            self.pass_alone(halfedge, sides, window, &mut leaving);
            if let Some((_, bundle)) = bundles.next_if(|&(after, _)| after as usize == place) {
                let [to_left, middle, to_right] = bundle.split(opposite);
                leaving[0].push_bundle(to_left.across(&Motion::to_left(sides), left.length));
                self.propagated += middle.len();
                for window in middle {
                    self.pass_alone(halfedge, sides, &window, &mut leaving);
                }
                leaving[1].push_bundle(to_right.across(&Motion::to_right(sides), right.length));
            }
        }
        list.windows.clear();
        self.is_refused |= list.is_refused;
        self.crossing = list.windows;
        let first = halfedge - k as u32;
        for (out, mut list) in [before(k), after(k)].into_iter().zip(leaving) {
            list.close();
            self.deliver_list(geometry, first + out as u32, list);
        }
    }

    /// Lets a window cross a face and adds what leaves to these lists.
    fn pass_alone(&mut self, halfedge: u32, sides: [&Side; 3], window: &Beam, leaving: &mut [List; 2]) {
        for (beam, way) in self.pass(halfedge, sides, window, self.geometry.grain).into_iter().zip(leaving) {
            beam.into_iter().for_each(|beam| way.push(beam));
        }
    }

    /// [Delivers](Self::deliver) windows that may be in bundles.
    fn deliver_list(&mut self, geometry: &ExactGeometry, halfedge: u32, mut list: List) {
        let (frame, k) = geometry.frame_of(halfedge);
        let twin = frame[k].twin().filter(|_| !list.is_plain());
        if let (Some(twin), Some(nearest)) = (twin, list.nearest()) {
            self.waiting.add_list(twin, list);
            self.queue.push(twin, nearest);
        } else {
            list.open();
            self.is_refused |= list.is_refused;
            self.deliver(geometry, halfedge, &mut list.windows);
        }
    }
}
