//! The windows that wait at one half-edge, many of them in bundles.

use super::bundle::Bundle;
use super::window::{self, Beam};
use crate::extremum::smaller;
use crate::room;

#[cfg(test)]
mod tests;

/// Bundles of fewer windows are not worth it.
const FEW: usize = 4;

/// Bundles in order, each with the place of the window that it comes after.
pub(super) type Bundles = Vec<(u32, Bundle)>;

/// Windows in order along a half-edge. Between two of them there may be a bundle, never before the first or after the last.
#[derive(Debug, Default)]
pub(super) struct List {
    pub windows: Vec<Beam>,
    pub bundles: Bundles,
    /// Whether there was no memory for a window, which is lost.
    pub is_refused: bool,
}

impl List {
    pub fn new(windows: Vec<Beam>, bundles: Bundles) -> Self {
        Self { windows, bundles, is_refused: false }
    }

    /// Whether there is no bundle.
    pub fn is_plain(&self) -> bool {
        self.bundles.is_empty()
    }

    /// How many windows there are, those in bundles too.
    pub fn count(&self) -> usize {
        self.windows.len() + self.bundles.iter().map(|(_, bundle)| bundle.len()).sum::<usize>()
    }

    /// Adds a window at the end.
    #[inline(always)]
    pub fn push(&mut self, window: Beam) {
        self.is_refused |= !room::push(&mut self.windows, window);
    }

    /// Adds a bundle at the end. Another window is to follow, or [`List::close`].
    #[inline(never)]
    pub fn push_bundle(&mut self, mut bundle: Bundle) {
        if bundle.len() < FEW {
            return bundle.for_each(|window| self.push(window));
        }
        if self.windows.is_empty() || self.ends_with_bundle() {
            bundle.next().into_iter().for_each(|window| self.push(window));
        }
        let after = self.windows.len().saturating_sub(1) as u32;
        self.is_refused |= !room::push(&mut self.bundles, (after, bundle));
    }

    /// Sees to it that a window comes last.
    #[inline(never)]
    pub fn close(&mut self) {
        if self.ends_with_bundle() {
            let last = self.bundles.last_mut().and_then(|(_, bundle)| bundle.next_back());
            last.into_iter().for_each(|window| self.push(window));
        }
    }

    fn ends_with_bundle(&self) -> bool {
        self.bundles.last().is_some_and(|&(after, _)| after as usize + 1 == self.windows.len())
    }

    /// Whether a bundle comes after the window at a place.
    pub fn has_bundle_after(&self, place: usize) -> bool {
        self.bundles.iter().any(|&(after, _)| after as usize == place)
    }

    /// Whether windows of another list come among those of a bundle.
    pub fn is_entangled_with(&self, others: &Self) -> bool {
        self.bundles.iter().any(|&(after, _)| {
            let [from, to] = [0, 1].map(|k| self.windows[after as usize + k].begin);
            let first = others.windows.partition_point(|window| window.begin < from);
            others.windows.get(first).is_some_and(|window| window.begin <= to)
        })
    }

    /// Opens all bundles.
    #[inline(never)]
    pub fn open(&mut self) {
        if self.is_plain() {
            return;
        }
        let mut windows = Vec::new();
        if windows.try_reserve_exact(self.count()).is_ok() {
            for_each(&self.windows, &self.bundles, |window| windows.push(window));
            self.windows = windows;
        } else {
            self.is_refused = true;
        }
        self.bundles.clear();
    }

    /// Puts all windows but the first and the last into a bundle, where there is none. The half-edge has this length.
    pub fn gather(&mut self, length: f64) {
        let [_, inner @ .., last] = self.windows.as_slice() else { return };
        if inner.len() < FEW {
            return;
        }
        let (mut gathered, last) = (Vec::new(), *last);
        if gathered.try_reserve_exact(inner.len()).is_err() {
            return self.is_refused = true;
        }
        gathered.extend_from_slice(inner);
        self.windows.truncate(1);
        self.push_bundle(Bundle::new(gathered, length));
        self.push(last);
    }

    /// Takes windows out that are not to be kept. Beside a bundle, one of its windows takes the place.
    #[inline(never)]
    pub fn retain(&mut self, is_kept: &dyn Fn(&Beam) -> bool) {
        if self.windows.iter().all(is_kept) {
            return;
        }
        let windows = std::mem::take(&mut self.windows);
        let mut bundles = std::mem::take(&mut self.bundles).into_iter().peekable();
        for (place, window) in windows.into_iter().enumerate() {
            let is_kept = is_kept(&window);
            if is_kept {
                self.push(window);
            } else {
                self.close();
            }
            if let Some((_, mut bundle)) = bundles.next_if(|&(after, _)| after as usize == place) {
                if !is_kept {
                    bundle.next().into_iter().for_each(|window| self.push(window));
                }
                self.push_bundle(bundle);
            }
        }
        self.close();
    }

    /// [Clips](Beam::clip) the windows. Where they touch, distance changes no faster than place from one to the next, so that
    /// only the outermost can be too far.
    #[inline(never)]
    pub fn clip(&mut self, length: f64, values: [f64; 2]) {
        let mut lost = 0;
        while lost < self.windows.len() && !self.windows[lost].clip(length, values) {
            lost += usize::from(!self.replace(lost, lost, Bundle::next));
        }
        while let Some(window) = self.windows[lost..].last_mut()
            && !window.clip(length, values)
        {
            let last = self.windows.len() - 1;
            if last == 0 || !self.replace(last, last - 1, Bundle::next_back) {
                self.windows.pop();
            }
        }
        self.windows.drain(..lost);
        self.bundles.retain(|(_, bundle)| bundle.len() > 0);
        self.bundles.iter_mut().for_each(|(after, _)| *after -= lost as u32);
    }

    /// Puts a window of the bundle after a place in place of another window, if there is any.
    fn replace(&mut self, place: usize, after: usize, take: fn(&mut Bundle) -> Option<Beam>) -> bool {
        let bundle = self.bundles.iter_mut().find(|(found, _)| *found as usize == after);
        let window = bundle.and_then(|(_, bundle)| take(bundle));
        window.inspect(|&window| self.windows[place] = window).is_some()
    }

    /// No window is nearer anywhere; none where there are no windows.
    pub fn nearest(&self) -> Option<f64> {
        let [Some(first), Some(last)] = [self.windows.first(), self.windows.last()] else { return None };
        let ends = [first.begin, last.end];
        let bundled = self.bundles.iter().map(|(_, bundle)| bundle.least(ends)).reduce(smaller);
        [window::nearest(&self.windows), bundled].into_iter().flatten().reduce(smaller)
    }
}

/// Each of some windows and of the bundles between them, in order.
pub(super) fn for_each(windows: &[Beam], bundles: &[(u32, Bundle)], mut tell: impl FnMut(Beam)) {
    let mut from = 0;
    for (after, bundle) in bundles {
        let to = *after as usize + 1;
        windows[from..to].iter().copied().chain(bundle.clone()).for_each(&mut tell);
        from = to;
    }
    windows[from..].iter().copied().for_each(tell);
}
