//! The interface to JavaScript.

mod cells;
mod distances;
mod files;
mod isolines;
