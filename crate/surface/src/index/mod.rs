//! One index for all that is looked for in space: a complete tree over things in an order in which neighbours are near each other,
//! as that [along a Morton curve](along_curve) (Lauterbach and others, "Fast BVH construction on GPUs", 2009), or one
//! [for the tree](Tree::arranged) where most things may lie in one cell of the curve.
//!
//! What is below a node follows from its number, so a [`Tree`] keeps nothing but counts. What is known of each node, its
//! [box](Bounds) or a sum over its things, is a list with a [value a node](Tree::values) that the owner of the things keeps.
//!
//! | question | asked by |
//! |---|---|
//! | what is met by a box, by a segment; which boxes have a place; which pairs are near each other | [`Tree::leaves`], which goes on below a node whose box is not too far away |
//! | the nearest to a place, the first along a ray | [`Tree::nearest`], by the distance of a node's box, or where a ray enters it |
//! | the `k` nearest | the same, where the bound is the distance of the last of the best `k` |

mod bounds;
mod curve;
mod tree;

pub use bounds::Bounds;
pub use curve::along_curve;
pub use tree::{Below, Tree};
