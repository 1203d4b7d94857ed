//! Whether there is room, asked before it is taken: what fails in the middle of a build ends the whole program.

use std::hint::black_box;

use crate::error::{Error, Result};

/// Whether blocks of these sizes in bytes can be had, all at once, beside what is in use. Where memory grows by request
/// only (wasm32) nothing else tells: freed memory stays with the program and can be used again.
pub fn has_room(blocks: &[u64]) -> bool {
    let reserve = |&bytes: &u64| {
        let mut block: Vec<u8> = Vec::new();
        block.try_reserve_exact(usize::try_from(bytes).ok()?).ok()?;
        // Memory that nobody looks at the compiler would not ask for.
        Some(black_box(block))
    };
    blocks.iter().map(reserve).collect::<Option<Vec<_>>>().is_some()
}

/// Refuses a stage that takes so many bytes where there is no room for them.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn require(bytes: u64, stage: &'static str) -> Result<()> {
    if has_room(&[bytes]) { Ok(()) } else { Err(Error::OutOfMemory { stage }) }
}
