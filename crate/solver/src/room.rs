//! Windows, and lists of them, are kept where there is room: memory that is refused is an error, not the program's end.

use crate::error::{Error, Result};

/// [`Error::OutOfMemory`] for windows.
pub(crate) const REFUSED: Error = Error::OutOfMemory { stage: "keeping windows" };

/// Appends an item where there is room. Returns whether there was.
#[inline(always)]
#[must_use]
pub(crate) fn push<T>(list: &mut Vec<T>, item: T) -> bool {
    let has_room = list.len() < list.capacity() || grow(list);
    if has_room {
        list.push(item);
    }
    has_room
}

#[cold]
fn grow<T>(list: &mut Vec<T>) -> bool {
    list.try_reserve(1).is_ok()
}

/// So many copies of a value, in memory that is there already where that suffices.
///
/// # Errors
/// [`REFUSED`].
pub(crate) fn refilled<T: Copy>(mut memory: Vec<T>, count: usize, value: T) -> Result<Vec<T>> {
    memory.clear();
    memory.try_reserve_exact(count).map_err(|_| REFUSED)?;
    memory.resize(count, value);
    Ok(memory)
}
