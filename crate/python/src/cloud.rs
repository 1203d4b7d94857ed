//! The class `PointCloud`: a mesh of points that have no triangles.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_cloud::{Cloud, Report};
use heatwalk_model::Model;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arrays::{Given, vectors};
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::{Mesh, Options, all_threads};

/// Points of a surface without triangles, joined to a mesh: all that `Mesh` answers, on these points.
///
/// `points`: (n, 3) floats, copied; they are the vertices, in their order. `normals`: (n, 3) floats of any length, where the surface faces; zeros where
/// that is not known. They tell apart the sides of what is as thin as points are apart. `bridges`, `links` and `threads` as of `Mesh`; the triangles are
/// the same, to the last bit, for any number of threads.
///
/// Points that fit nowhere, and those that are not finite, are on no triangle, at an infinite distance; `joined` tells how many.
///
/// Raises HeatwalkError for arrays of another shape or type, and for points that make no surface: less than three, or all on a line. Pickled, it is
/// its arrays.
#[pyclass(frozen, extends = Mesh, module = "heatwalk")]
pub struct PointCloud {
    normals: Vec<DVec3>,
    report: Report,
}

impl PointCloud {
    /// Joins the points of a file; none of a mesh.
    pub fn of_model(name: &str, model: &mut Model, threads: NonZeroUsize) -> Result<Option<Self>> {
        let normals = model.appearance.normals.iter().map(|normal| normal.as_dvec3()).collect();
        let report = heatwalk_cloud::join(name, model, threads)?;
        Ok(report.map(|report| Self { normals, report }))
    }

    /// With the mesh that its points are joined to.
    pub fn over(self, mesh: Mesh) -> PyClassInitializer<Self> {
        PyClassInitializer::from(mesh).add_subclass(self)
    }
}

#[pymethods]
impl PointCloud {
    #[new]
    #[pyo3(signature = (points, normals=None, *, bridges=None, links=0, threads=None))]
    fn new(
        py: Python<'_>,
        points: &Bound<'_, PyAny>,
        normals: Option<&Bound<'_, PyAny>>,
        bridges: Option<&Bound<'_, PyAny>>,
        links: usize,
        threads: Option<usize>,
    ) -> PyResult<PyClassInitializer<Self>> {
        let points = Given::new("points", points)?.points()?;
        let normals = normals.map_or(Ok(Vec::new()), |normals| Given::new("normals", normals)?.points())?;
        if !normals.is_empty() && normals.len() != points.len() {
            let sentence = format!("there are {} points and {} normals", points.len(), normals.len());
            return Err(Failure::new("bad-shape", sentence).into());
        }
        let options = Options::new(None, bridges, links, threads)?;
        let count = options.threads.unwrap_or_else(all_threads);
        let (mesh, cloud) = run(py, None, move |_| {
            let Cloud { soup, report } = Cloud::join_oriented("points", points, &normals, count)?;
            Ok((Mesh::build(soup, options)?, Self { normals, report }))
        })?;
        Ok(cloud.over(mesh))
    }

    /// What was made of the points: how many triangles, boundary loops (holes, and where the surface ends), and points on no triangle.
    #[getter]
    fn joined<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let Report { points, triangles, boundary_loops, unjoined_points } = self.report;
        let told = PyDict::new(py);
        told.set_item("points", points)?;
        told.set_item("triangles", triangles)?;
        told.set_item("boundary_loops", boundary_loops)?;
        told.set_item("unjoined_points", unjoined_points)?;
        Ok(told)
    }

    fn __repr__(&self) -> String {
        let Report { points, triangles, boundary_loops, unjoined_points } = self.report;
        format!(
            "<heatwalk.PointCloud: {points} points, {triangles} triangles, {boundary_loops} boundary loops, {unjoined_points} unjoined points>"
        )
    }

    fn __getnewargs_ex__<'py>(
        slf: &Bound<'py, Self>,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        let own = slf.get();
        let keywords = PyDict::new(py);
        let normals = (!own.normals.is_empty()).then(|| vectors(py, own.normals.iter().map(DVec3::to_array)));
        keywords.set_item("normals", normals)?;
        let Options { bridges, links, threads, .. } = slf.as_super().get().options();
        keywords.set_item("bridges", bridges.to_string())?;
        keywords.set_item("links", links)?;
        keywords.set_item("threads", threads.map(NonZeroUsize::get))?;
        Ok(((slf.getattr("vertices")?,).into_pyobject(py)?, keywords))
    }
}
