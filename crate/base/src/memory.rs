//! Whether there is room, asked before it is taken: what fails in the middle of a build ends the whole program.

use std::hint::black_box;

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
