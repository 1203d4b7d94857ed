//! The tests of the crate's public interface, in one program: each would be linked with all of it.

mod threads;
