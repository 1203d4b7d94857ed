//! How much is looked at and kept: as much as surfaces of so many triangles need whose parts meet here and there, and no more
//! where all parts meet all others.

use std::sync::atomic::{AtomicUsize, Ordering};

/// Steps that a search may take: so many, and so many a triangle. Boxes that are stacked face to face by the thousand, of 12
/// triangles each, take 2,100 a triangle, assemblies of finer parts 10 to 1,100.
const STEPS: usize = 1 << 23;
const STEPS_OF_TRIANGLE: usize = 2048;

/// Steps that a few neighbouring triangles may take where all together are too many.
const STEPS_OF_GROUP: usize = 512;

/// Two triangles whose nearest points are looked for count as so many steps, each of which is a box that is looked into, two
/// triangles whose boxes are near, or a point that is tried: as long as it takes.
pub const STEPS_OF_PAIR: usize = 8;

/// A place that is kept counts as so many: as long as it takes, and so few that they fit into memory.
pub const STEPS_OF_PLACE: usize = 16;

/// What remains of the steps of a search, on any number of threads.
pub enum Budget {
    /// For all groups of triangles together.
    Whole(AtomicUsize),
    /// For each group the same.
    Each,
}

impl Budget {
    /// For the search through so many triangles.
    pub fn new(triangles: usize) -> Self {
        Self::Whole(AtomicUsize::new(STEPS_OF_TRIANGLE.saturating_mul(triangles).saturating_add(STEPS)))
    }

    /// What a search through so many triangles finds, and whether it finds all: where that would be too much, it is done again
    /// with as little for each group as for any other.
    pub fn spend<T>(triangles: usize, search: impl Fn(&Self) -> (T, bool)) -> (T, bool) {
        let whole = search(&Self::new(triangles));
        if whole.1 {
            return whole;
        }
        drop(whole);
        (search(&Self::Each).0, false)
    }

    /// What a group may take.
    pub fn of_group(&self) -> usize {
        match self {
            Self::Whole(left) => left.load(Ordering::Relaxed),
            Self::Each => STEPS_OF_GROUP,
        }
    }

    /// A group took so many steps. Returns whether it had them. Whether all groups had is the same in whatever order they come.
    pub fn take(&self, steps: usize) -> bool {
        match self {
            Self::Whole(left) => {
                let before =
                    left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| Some(left.saturating_sub(steps)));
                before.is_ok_and(|left| steps <= left)
            }
            Self::Each => steps <= STEPS_OF_GROUP,
        }
    }
}
