//! What the heat method asks of elements beside their matrices.

use std::sync::Arc;

use glam::DVec3;

use crate::heat::bounds::Bounds;
use crate::heat::field::{Field, RightSide};
use crate::heat::region::ExactRegion;
use crate::operator::Discretization;

/// Linear elements of some kind with the mesh that they are on. Everything that costs time is made with the elements; what is asked here
/// is there, but for [`unit_field`](Self::unit_field) and [`along_logarithm`](Self::along_logarithm), which every distance takes one of.
pub trait HeatDiscretization: Discretization {
    /// `#V`, where vertices are.
    fn positions(&self) -> &[DVec3];

    /// `#V`, whether a vertex is on the boundary.
    fn boundary(&self) -> Vec<bool>;

    /// `#V`, another order of the vertices, by which to look for an elimination order: see
    /// [`Permutation::fill_reducing_by`](heatwalk_sparse::Permutation::fill_reducing_by). None where their own will do.
    fn numbering(&self) -> Option<Vec<u32>> {
        None
    }

    /// Mean length of the edges.
    fn mean_edge(&self) -> f64;

    /// What no distance is above, in the unit of the lengths, or nearly so.
    fn extent(&self) -> f64;

    /// m in t = m h² that suits a field, h being the mean edge, where the time is chosen.
    fn time_factor(&self, field: Field) -> f64;

    /// Whether distance can follow the field of the logarithm of heat here.
    fn has_logarithm(&self) -> bool;

    /// `#V`, the mass that heat has for that field; none where it is the lumped one.
    fn logarithm_mass(&self) -> Option<&Arc<[f64]>> {
        None
    }

    /// Right side of the Poisson equation whose solution is the distance: of the gradient of exact distance in elements whose corners
    /// are all in the region, elsewhere of the [unit field](Field::Unit) of `heat` (`#V`), zero where that is constant.
    fn unit_field(&self, heat: &[f64], region: &ExactRegion<'_>) -> RightSide;

    /// Distances (`#V`) along the field of the logarithm of `heat` (`#V`) that has flowed for this time, in the unit of the lengths,
    /// squared. Those below infinity in `known` (`#V`) stay; infinite where heat tells nothing.
    fn along_logarithm(&self, heat: &[f64], time: f64, known: Vec<f64>) -> Vec<f64>;

    /// What distances by a field are made to keep, where they are.
    fn bounds(&self, field: Field) -> Option<&Bounds>;
}
