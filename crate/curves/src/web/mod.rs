//! The interface to JavaScript.

mod cells;
mod decals;
mod directions;
mod distances;
mod files;
mod isolines;
mod offsets;
mod paths;
mod surface;
