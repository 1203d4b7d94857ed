//! Isolines, strips and sheets as bytes of a file. All positions are in the field's unit, turned by nothing; `unit` is
//! that one, where it is known.

mod csv;
mod dxf;
mod glb;
mod obj;
mod occlusion;
mod pdf;
mod svg;
mod unit;
mod view;

pub use csv::csv;
pub use dxf::{dxf, sheet_dxf};
pub use glb::glb;
pub use obj::{obj, strips_obj};
pub use pdf::{pdf, sheet_pdf};
pub use svg::{sheet_svg, svg};
pub use unit::{column, with_ply_comment};
pub use view::View;
