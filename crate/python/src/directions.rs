//! Log maps, transport and what is diffused.

use glam::DVec3;
use heatwalk::operator::TangentPlane;
use heatwalk::{Element, Method, VertexId, Windows, log_map, propagated_log_map, transport};
use numpy::{Complex64, PyArray1, PyArray2};
use pyo3::prelude::*;

use crate::arrays::{Given, rows, vectors};
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::Mesh;
use crate::named::named;
use crate::options::method_of;
use crate::sources::{one, require_one_each, several};

/// Rows, columns and values.
type Entries<'py> = (Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<Complex64>>);

/// A vector in space.
pub fn direction(name: &'static str, value: &Bound<'_, PyAny>) -> Result<DVec3> {
    Ok(DVec3::from_slice(&Given::new(name, value)?.row(Some(3))?.floats()?))
}

#[pymethods]
impl Mesh {
    /// The log map: in which direction shortest paths leave a source, and how long they are.
    ///
    /// `source`: a place as a source of `distance`. `direction`: three floats, of any length, whose part along the surface is u; if not
    /// given, the x axis, or the y axis where the surface faces along x. v is to its left, seen from outside. `method`: "exact" (default)
    /// along exact paths; "propagation" by propagated distances; "heat", which is smooth where several paths are as short.
    ///
    /// Returns `LogMap`: (n, 2) coordinates as long as the distance, NaN where nothing is reached, distances and the axes in space.
    ///
    /// Raises HeatwalkError for a place that does not exist or has no tangent plane, and a direction that is square to the surface; by heat,
    /// where components are joined by bridges.
    #[pyo3(signature = (source, direction=None, method="exact", *, progress=None))]
    fn log_map<'py>(
        &self,
        py: Python<'py>,
        source: &Bound<'_, PyAny>,
        direction: Option<&Bound<'_, PyAny>>,
        method: &str,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let source = one("source", source)?;
        let direction = direction.map(|given| self::direction("direction", given)).transpose()?;
        let methods = [Method::Exact, Method::Propagation, Method::Heat];
        let method = method_of(method, &methods, "log maps are not made")?;
        let map = run(py, progress, |progress| {
            let source = self.point(source)?;
            Ok(match method {
                Method::Heat => self.diffusion(progress)?.log_map(source, direction, progress)?,
                Method::Propagation => {
                    propagated_log_map(&self.geometry()?, source, direction, Windows::default(), progress)?
                }
                Method::Exact | Method::Auto => log_map(&self.geometry()?, source, direction, progress)?,
            })
        })?;
        let coordinates = self.to_inputs(&map.coordinates, glam::DVec2::NAN);
        let distances = PyArray1::from_vec(py, self.to_inputs(&map.distances, f64::INFINITY));
        let axes = vectors(py, map.axes.map(|axis| axis.to_array()).into_iter());
        named(py, "LogMap", (rows(py, coordinates.into_iter().map(|place| place.to_array())), distances, axes))
    }

    /// Carries tangent vectors to all vertices, parallel along the surface.
    ///
    /// `sources`: places as for `distance`. `vectors`: (k, 3) floats, a vector at each, of which the part along the surface counts; (3,)
    /// for one source. `method`: "exact" (default) along a shortest path from the nearest source, "heat" goes over from one to another.
    ///
    /// Returns (n, 3) floats, each in the plane of the normal of its vertex; NaN where there is none.
    ///
    /// Raises HeatwalkError for a vector that is zero or square to the surface; by heat, where components are joined by bridges.
    #[pyo3(signature = (sources, vectors, method="exact", *, progress=None))]
    fn transport<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        vectors: &Bound<'_, PyAny>,
        method: &str,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let sources = several("source", sources)?;
        let given = Given::new("vectors", vectors)?;
        let given = if given.dimensions() == 1 { vec![direction("vectors", vectors)?] } else { given.points()? };
        let method = method_of(method, &[Method::Exact, Method::Heat], "vectors are not carried")?;
        require_one_each(sources.len(), given.len(), "vectors")?;
        let carried = run(py, progress, |progress| {
            let placed: Vec<_> = self.points(&sources)?.into_iter().zip(given).collect();
            Ok(if method == Method::Heat {
                self.diffusion(progress)?.transport(&placed, progress)?
            } else {
                transport(&self.geometry()?, &placed, progress)?
            })
        })?;
        let carried = self.to_inputs(&carried, DVec3::NAN);
        Ok(self::vectors(py, carried.into_iter().map(|vector| vector.to_array())))
    }

    /// Carries numbers from places to all vertices by heat: each vertex has that of the nearest place, and between two they go over
    /// into each other.
    ///
    /// `sources`: places as for `distance`. `values`: (k,) floats, one each.
    ///
    /// Returns (n,) floats; NaN where nothing is reached.
    ///
    /// Raises HeatwalkError for places that do not exist, and where components are joined by bridges.
    #[pyo3(signature = (sources, values, *, progress=None))]
    fn extend<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        values: &Bound<'_, PyAny>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let sources = several("source", sources)?;
        let values = Given::new("values", values)?.row(Some(sources.len()))?.floats()?;
        let extended = run(py, progress, |progress| {
            let placed: Vec<_> = self.points(&sources)?.into_iter().zip(values).collect();
            Ok(self.diffusion(progress)?.extend(&placed, progress)?)
        })?;
        Ok(PyArray1::from_vec(py, self.to_inputs(&extended, f64::NAN)))
    }

    /// The tangent planes of vertices.
    ///
    /// Returns `TangentFrames`: unit vectors x and y in each plane, and its normal, (n, 3) each; NaN for vertices that no face uses.
    ///
    /// Raises HeatwalkError where components are joined by bridges.
    #[pyo3(signature = (*, progress=None))]
    fn tangent_frames<'py>(&self, py: Python<'py>, progress: Option<Py<PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        let [x, y, normal] = run(py, progress, |progress| {
            let diffusion = self.diffusion(progress)?;
            let axis = |of: fn(&TangentPlane) -> DVec3| {
                self.to_inputs(&diffusion.tangent_planes().iter().map(of).collect(), DVec3::NAN)
            };
            Ok([
                axis(|plane| plane.reference),
                axis(|plane| plane.normal.cross(plane.reference)),
                axis(|plane| plane.normal),
            ])
        })?;
        let told = |axis: Vec<DVec3>| vectors(py, axis.into_iter().map(|axis| axis.to_array()));
        named(py, "TangentFrames", (told(x), told(y), told(normal)))
    }

    /// The connection Laplacian of tangent vectors, which are complex numbers in `tangent_frames`, on the intrinsic Delaunay triangulation:
    /// Hermitian and positive semidefinite.
    ///
    /// Returns its entries: (k,) rows, columns and complex numbers, of the n × n matrix; of vertices that are one, the first has them.
    ///
    /// Raises HeatwalkError where components are joined by bridges, and where a vertex has triangles in several fans.
    #[pyo3(signature = (*, progress=None))]
    fn connection_laplacian<'py>(&self, py: Python<'py>, progress: Option<Py<PyAny>>) -> PyResult<Entries<'py>> {
        let entries = run(py, progress, |progress| {
            let stiffness = self.diffusion(progress)?.connection_laplacian().stiffness;
            let (pattern, count) = (stiffness.pattern(), self.surface().vertex_count());
            if pattern.size() != count {
                let sentence = "vertices have triangles in several fans, and so several tangent planes; take a vertex for each fan";
                return Err(Failure::new("no-tangent-plane", sentence));
            }
            let number =
                |vertex: usize| self.surface().inputs_of_vertex(VertexId::from_index(vertex))[0].index() as i64;
            let mut entries = Vec::with_capacity(2 * pattern.nonzeros());
            for column in 0..count {
                for entry in pattern.column(column) {
                    let (row, value) = (pattern.rows()[entry] as usize, stiffness.values()[entry]);
                    entries.push((number(row), number(column), value));
                    if row != column {
                        entries.push((number(column), number(row), value.conj()));
                    }
                }
            }
            Ok(entries)
        })?;
        let rows = PyArray1::from_iter(py, entries.iter().map(|entry| entry.0));
        let columns = PyArray1::from_iter(py, entries.iter().map(|entry| entry.1));
        Ok((rows, columns, PyArray1::from_iter(py, entries.iter().map(|entry| Complex64::new(entry.2.re, entry.2.im)))))
    }
}
