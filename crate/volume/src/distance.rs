//! The answer of every method.

use std::fmt;
use std::str::FromStr;

use glam::DVec3;
use heatwalk::VertexId;

use crate::error::{Error, Result};
use crate::heat::gradient_in;
use crate::march::Origins;
use crate::mesh::{MeshId, TetId, TetMesh};
use crate::point::TetPoint;

/// How distances are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum VolumeMethod {
    /// By waves from vertex to vertex: nothing is factored, and where straight lines lead to the source it is exact.
    #[default]
    March,
    /// By the flow of heat: smooth, with options.
    Heat,
}

impl VolumeMethod {
    /// The name on a command line or in a link.
    pub fn name(self) -> &'static str {
        match self {
            Self::March => "march",
            Self::Heat => "heat",
        }
    }
}

impl fmt::Display for VolumeMethod {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

impl FromStr for VolumeMethod {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        [Self::March, Self::Heat].into_iter().find(|method| method.name() == name).ok_or_else(|| {
            let (name, value, range) = ("the method", name.to_owned(), "march or heat");
            heatwalk::Error::BadParameter { name, value, range }.into()
        })
    }
}

/// Distance from a set of sources.
#[derive(Debug, Clone)]
pub struct VolumeDistance {
    pub(crate) mesh: MeshId,
    /// `#V`, in the file's unit times cost, non-negative, never NaN; infinity where no source can be reached from. At a source that is
    /// a vertex and nearest to itself it is exactly its initial distance.
    pub values: Vec<f64>,
    /// What found it.
    pub method: VolumeMethod,
    /// The sources, checked.
    pub sources: Vec<TetPoint>,
    /// Values below this were found by the march; infinity when all were. Those above are by heat or, where the march would have taken
    /// more than some 500 steps a tetrahedron, ways along edges.
    pub exact_below: f64,
    /// The distances that the sources start from.
    pub(crate) initial_distances: Vec<f64>,
    pub(crate) heat: Option<Vec<f64>>,
    pub(crate) origins: Option<Origins>,
}

impl VolumeDistance {
    /// The mesh that it was solved on.
    pub fn mesh(&self) -> MeshId {
        self.mesh
    }

    /// The largest finite distance.
    pub fn max(&self) -> f64 {
        self.values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max)
    }

    /// Number of vertices from which no source can be reached.
    pub fn unreachable(&self) -> usize {
        self.values.iter().filter(|value| value.is_infinite()).count()
    }

    /// `#V`, heat after time t, to an arbitrary scale near 10²⁹⁰; none where distance was found by other means.
    pub fn heat(&self) -> Option<&[f64]> {
        self.heat.as_deref()
    }

    /// Whether a straight line inside of the mesh leads from a vertex to its source, so that its distance is exact up to rounding. Known
    /// of the march alone.
    pub fn is_straight(&self, vertex: VertexId) -> bool {
        self.origins.as_ref().is_some_and(|origins| origins.is_straight(vertex))
    }

    /// `#T`, unit vectors along the gradient of heat in each tetrahedron, towards the sources; zero where there is none.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`]; [`Error::Heat`] with `NoHeat` where distance was found by other means.
    pub fn heat_directions(&self, mesh: &TetMesh) -> Result<Vec<DVec3>> {
        self.require(mesh)?;
        let heat = self.heat.as_deref().ok_or(heatwalk::Error::NoHeat)?;
        let direction = |(tetrahedron, corners): (u32, &[u32; 4])| {
            gradient_in(mesh.scaled_corners(TetId(tetrahedron)), corners.map(|corner| heat[corner as usize]))
                .normalize_or_zero()
        };
        Ok((0..).zip(mesh.tetrahedra()).map(direction).collect())
    }

    /// The distance at a place, interpolated linearly in its tetrahedron; [`VolumeSolver::at`](crate::VolumeSolver::at) measures it.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`]; as [`TetPoint::checked`].
    pub fn at(&self, mesh: &TetMesh, point: TetPoint) -> Result<f64> {
        self.require(mesh)?;
        Ok(point.checked(mesh)?.interpolate(mesh, &self.values))
    }

    /// `#T`, the gradient of the distance in each tetrahedron, away from the sources; zero where a corner is at infinity.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`].
    pub fn gradient(&self, mesh: &TetMesh) -> Result<Vec<DVec3>> {
        self.require(mesh)?;
        Ok((0..mesh.tetrahedron_count() as u32).map(|tetrahedron| self.gradient_in(mesh, tetrahedron)).collect())
    }

    pub(crate) fn gradient_in(&self, mesh: &TetMesh, tetrahedron: u32) -> DVec3 {
        let values = mesh.tetrahedra()[tetrahedron as usize].map(|vertex| self.values[vertex as usize]);
        let is_finite = values.iter().all(|value| value.is_finite());
        if !is_finite {
            return DVec3::ZERO;
        }
        mesh.scaled(gradient_in(mesh.scaled_corners(TetId(tetrahedron)), values))
    }

    /// The same where all lengths are so many times as large. Waves stay as they are.
    pub(crate) fn times(mut self, factor: f64) -> Self {
        self.values.iter_mut().for_each(|value| *value *= factor);
        self.exact_below *= factor;
        self.initial_distances.iter_mut().for_each(|distance| *distance *= factor);
        self
    }

    pub(crate) fn require(&self, mesh: &TetMesh) -> Result<()> {
        if self.mesh == mesh.id() { Ok(()) } else { Err(Error::ForeignMesh { what: "distance" }) }
    }
}
