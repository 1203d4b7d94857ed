//! Curves made on the surface: down a distance, straightened, refracted, straightest; and what closed ones enclose.

mod bezier;
mod chain;
pub mod descent;
pub mod enclosed;
mod funnel;
mod link;
pub mod refract;
mod ring;
mod search;
pub mod straighten;
pub mod straightest;
mod strip;

pub use bezier::{Bezier, bezier};
pub use descent::descend;
pub(crate) use descent::descend_corners;
pub use enclosed::{Enclosed, enclosed};
pub use refract::refract;
pub use search::{PathSearch, shortest};
pub use straighten::{closed_geodesic, straighten};
pub use straightest::{Straightest, straightest};
