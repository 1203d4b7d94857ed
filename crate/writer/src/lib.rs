//! Curves on surfaces in the page's worker: converts arguments, calls, turns errors into sentences. No algorithm lives here.
//!
//! Isolines, distance from curves, cells, paths and images, and files of all these and of distances.

#![cfg(target_arch = "wasm32")]

mod cells;
mod decals;
mod directions;
mod distances;
mod files;
mod isolines;
mod offsets;
mod paths;
mod surface;
