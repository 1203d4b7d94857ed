//! The tests of the crate's public interface, in one program: each would be linked with all of it.

mod agents;
#[path = "../../solver/tests/common/mod.rs"]
mod common;
mod crowd;
mod drawing;
mod overlay;
