//! Curves made on the surface: down a distance, straightened, straightest.

pub mod descent;
mod funnel;
mod link;
mod search;
pub mod straighten;
pub mod straightest;
mod strip;

pub use descent::descend;
pub use search::PathSearch;
pub use straighten::straighten;
pub use straightest::{Straightest, straightest};
