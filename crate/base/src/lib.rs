//! What the crates of Heatwalk share and no user needs: numbered elements and rows of them, threads, groups, sums of a few numbers at
//! once, logarithms, room in memory. It changes with what uses it and promises nothing between versions.

pub mod csr;
pub mod element;
pub mod lanes;
pub mod logarithm;
pub mod memory;
#[cfg(feature = "packed")]
pub mod packed;
pub mod parallel;
pub mod sort;
pub mod union_find;
