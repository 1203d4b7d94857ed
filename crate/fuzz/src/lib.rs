//! What the fuzz targets share: files that are read within their budget, and shapes and documents made of a target's bytes.
//!
//! A target fails by a panic. So does a file that takes more memory than docs/reliability.md promises, a model that contradicts
//! itself, and a distance that no surface can have.

pub mod budget;
pub mod distances;
pub mod documents;
pub mod reading;
pub mod soups;
