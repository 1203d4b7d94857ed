//! A stage that takes much memory is refused before it takes it.

use heatwalk_base::memory::has_room;

use crate::error::{Error, Result};

/// Refuses a stage that takes so many bytes where there is no room for them.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn require(bytes: u64, stage: &'static str) -> Result<()> {
    if has_room(&[bytes]) { Ok(()) } else { Err(Error::OutOfMemory { stage }) }
}
