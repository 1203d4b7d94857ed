//! Curves made on the surface: down a distance, straightened, straightest.

pub mod descent;
mod funnel;
mod link;
pub mod straighten;
pub mod straightest;
mod strip;

pub use descent::descend;
pub use straighten::straighten;
pub use straightest::{Straightest, straightest};
