//! Labels of vertices, and distances between parcels.

use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use heatwalk::{ParcelDistance, VertexId};
use heatwalk_model::io;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Given, shaped};
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::{Mesh, all_threads, checked_threads};
use crate::named::named;
use crate::options::distance_options;

/// Read the labels of vertices from a GIFTI file (`.label.gii`) or an annotation of FreeSurfer (`.annot`).
///
/// Returns `Labels`.
///
/// Raises OSError where the file cannot be read, HeatwalkError where it holds no labels.
#[pyfunction]
pub fn read_labels(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyAny>> {
    let labels = run(py, None, move |_| {
        let bytes = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        Ok(io::read_labels(&bytes).with_context(|| path.display().to_string())?)
    })?;
    let number = |label: &Option<u32>| label.map_or(-1, i64::from);
    let of_parcel = |label: &Option<u32>| label.filter(|&label| labels.is_parcel(label as usize));
    let numbers = PyArray1::from_iter(py, labels.of_vertices.iter().map(number));
    let parcels = PyArray1::from_iter(py, labels.of_vertices.iter().map(|label| number(&of_parcel(label))));
    named(py, "Labels", (labels.names, numbers, parcels))
}

#[pymethods]
impl Mesh {
    /// Distances between parcels of the vertices.
    ///
    /// `parcels`: (n,) integers, the parcel of each vertex, counted from 0; negative for none. `between`: "mean" over all pairs of a vertex of the
    /// one and a vertex of the other, of a parcel and itself with each vertex and itself, too; or the "minimum" over them. `method`, the
    /// options, `threads` and `progress` are those of `matrix`. The mean takes an answer from each vertex of all parcels, the minimum one from each
    /// parcel.
    ///
    /// Returns (p, p) floats, in the unit of the mesh; inf where nothing is reached, and for parcels without a vertex.
    ///
    /// Raises HeatwalkError for another shape or type, and options that do not apply.
    #[pyo3(signature = (parcels, between="mean", method="auto", *, threads=None, progress=None, **options))]
    #[allow(clippy::too_many_arguments, reason = "keywords of Python")]
    fn parcel_matrix<'py>(
        &self,
        py: Python<'py>,
        parcels: &Bound<'_, PyAny>,
        between: &str,
        method: &str,
        threads: Option<usize>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let vertices = self.surface().vertices_of_inputs().as_slice();
        let parcels = Given::new("parcels", parcels)?.row(Some(vertices.len()))?.whole()?;
        let between = match between {
            "mean" => ParcelDistance::Mean,
            "minimum" => ParcelDistance::Minimum,
            other => {
                let sentence = format!("there is no distance {other:?} of parcels; choose one of mean, minimum");
                return Err(Failure::new("unknown-choice", sentence).into());
            }
        };
        let options = distance_options(method, options)?;
        let threads = checked_threads(threads)?.unwrap_or_else(all_threads);
        let sets = sets(&parcels, vertices)?;
        let count = sets.len();
        let distances = run(py, progress, |progress| {
            self.with_solver(|solver| Ok(solver.parcel_distances(&sets, between, (&options, threads), progress)?))
        })?;
        Ok(shaped(py, distances, [count, count]))
    }
}

/// The vertices of each parcel, but those that no triangle uses.
fn sets(parcels: &[i64], vertices: &[Option<VertexId>]) -> Result<Vec<Vec<VertexId>>> {
    let largest = parcels.iter().copied().max().unwrap_or(-1);
    if largest >= vertices.len() as i64 {
        let sentence = format!("there is a parcel {largest} of {} vertices; count parcels from 0", vertices.len());
        return Err(Failure::new("bad-parameter", sentence));
    }
    let mut sets = vec![Vec::new(); usize::try_from(largest + 1).unwrap_or_default()];
    for (&parcel, vertex) in parcels.iter().zip(vertices) {
        if let Ok(parcel) = usize::try_from(parcel) {
            sets[parcel].extend(*vertex);
        }
    }
    Ok(sets)
}
