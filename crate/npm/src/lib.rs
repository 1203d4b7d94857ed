//! The wasm module of the npm package `heatwalk`: converts arrays, calls the solver, throws failures. No algorithm lives here, and what
//! callers see is the TypeScript in `package/`, which checks the types of what they give.

#![cfg(target_arch = "wasm32")]

mod agents;
mod curves;
mod directions;
mod distance;
mod given;
mod mesh;
mod options;
mod paths;
mod places;
mod samples;
mod vectors;
