//! The interface to JavaScript.

mod cells;
mod decals;
mod distances;
mod files;
mod isolines;
mod loops;
mod offsets;
mod surface;
