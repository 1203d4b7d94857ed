//! Approximate geodesic distance on the graphics card, for a source that moves while a hand holds it.
//!
//! [`Layout`] is made once for a surface, on the processor; [`DistanceField`] holds it on a device, and fills a buffer with
//! distances from sources as often as it is asked. Device and queue are the caller's, so that what it draws with reads that buffer
//! where it is. Distances are lengths of paths, so never too short but for rounding, and unlike exact ones they are not the same bit for bit from
//! one time to the next.
//!
//! Of each half-edge at most two windows are kept, as by `heatwalk::propagation`: Xin and Wang, "Improving Chen and Han's
//! algorithm on the discrete geodesic problem" (2009), says which windows lead to no shortest path. A workgroup takes a patch of
//! faces and lets windows cross them in its own memory until none waits, and what leaves the patch goes to its neighbors in the next round.
//! All runs within the default limits of WebGPU.

mod error;
mod field;
mod layout;
mod patches;
mod pipelines;
mod readback;
mod records;
mod seeds;

pub use error::{Error, Result};
pub use field::{DistanceField, Progress};
pub use layout::Layout;
pub use patches::PatchSize;
