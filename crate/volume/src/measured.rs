//! A mesh as all is computed in it: in a unit where products of lengths are numbers, and at cost 1 where all costs are one.

use std::borrow::Cow;
use std::sync::Arc;

use crate::distance::VolumeDistance;
use crate::error::Result;
use crate::march::Medium;
use crate::mesh::{TetId, TetMesh};
use crate::path::{self, VolumePath};
use crate::point::{TetPoint, TetSource};

/// A mesh with its medium.
#[derive(Debug, Clone)]
pub(crate) struct Measured {
    pub(crate) mesh: Arc<TetMesh>,
    pub(crate) medium: Arc<Medium>,
    /// The unit of length here, in the file's.
    unit: f64,
    /// What cost 1 stands for here.
    cost: f64,
}

impl Measured {
    /// Of a mesh where each unit of length costs `costs` (`#T`), or 1.
    ///
    /// # Errors
    /// As [`Medium::new`]; without costs there is nothing to refuse.
    pub(crate) fn new(mesh: &Arc<TetMesh>, costs: Option<&[f64]>) -> Result<Self> {
        let (mesh, unit) = mesh.in_unit();
        let mut medium = Medium::new(&mesh, costs)?;
        let mut cost = 1.0;
        if let Some(costs) = costs
            && medium.is_uniform()
        {
            cost = medium.least_cost();
            let of_one: Vec<f64> = costs.iter().map(|&own| if own.is_finite() { 1.0 } else { own }).collect();
            medium = Medium::new(&mesh, Some(&of_one))?;
        }
        Ok(Self { mesh, medium: medium.into(), unit, cost })
    }

    /// What distances here are multiplied by.
    fn factor(&self) -> f64 {
        self.unit * self.cost
    }

    /// A distance or a cost here.
    pub(crate) fn scaled(&self, distance: f64) -> f64 {
        distance / self.factor()
    }

    /// A source here.
    pub(crate) fn source(&self, source: TetSource) -> TetSource {
        TetSource { initial_distance: self.scaled(source.initial_distance), ..source }
    }

    /// What was found here, in the file's unit and costs.
    pub(crate) fn outside(&self, distance: VolumeDistance) -> VolumeDistance {
        distance.times(self.factor())
    }

    /// What was found, here.
    pub(crate) fn inside<'a>(&self, distance: Cow<'a, VolumeDistance>) -> Cow<'a, VolumeDistance> {
        if self.factor() == 1.0 { distance } else { Cow::Owned(distance.into_owned().times(self.factor().recip())) }
    }

    /// What a unit of length costs in a tetrahedron.
    pub(crate) fn cost(&self, tetrahedron: TetId) -> f64 {
        self.cost * self.medium.cost(tetrahedron.0)
    }

    /// A shortest path down a distance that is [inside](Self::inside), in the file's unit and costs.
    ///
    /// # Errors
    /// As [`path::find`].
    pub(crate) fn path(&self, distance: &VolumeDistance, from: TetPoint) -> Result<VolumePath> {
        let mut path = path::find(&self.mesh, &self.medium, distance, from)?;
        path.length *= self.unit;
        path.cost *= self.factor();
        path.costs.iter_mut().for_each(|cost| *cost *= self.cost);
        path.points.iter_mut().for_each(|point| *point *= self.unit);
        Ok(path)
    }
}
