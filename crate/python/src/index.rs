//! The class `Index`: distances of pairs without a search.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::PathBuf;

use anyhow::Context;
use heatwalk_index::DistanceIndex;
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arrays::Given;
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::{Mesh, all_threads, checked_threads};
use crate::named::named;

/// What answers the distance of any two vertices of a mesh at once, in about a microsecond.
///
/// Made of a `Mesh`, which takes some hundred searches and hundreds to a thousand numbers of 32 bits a vertex; `save` and `load` keep it. A mesh with costs
/// or bridges has none. `threads` as of `Mesh.matrix`; `progress` as of `Mesh.distance`.
///
/// Raises HeatwalkError for a mesh that it cannot be made of, and where memory is short.
#[pyclass(frozen, module = "heatwalk")]
pub struct Index {
    index: DistanceIndex,
}

#[pymethods]
impl Index {
    #[new]
    #[pyo3(signature = (mesh, *, threads=None, progress=None))]
    fn new(py: Python<'_>, mesh: &Mesh, threads: Option<usize>, progress: Option<Py<PyAny>>) -> PyResult<Self> {
        let threads = checked_threads(threads)?.unwrap_or_else(all_threads);
        run(py, progress, |progress| {
            require_plain(mesh)?;
            Ok(Self { index: DistanceIndex::build(mesh.surface(), threads, progress)? })
        })
    }

    /// Reads an index that `save`, or `heatwalk index` of the program, has written of this mesh.
    ///
    /// Raises OSError where the file cannot be read, HeatwalkError where it is damaged or of another mesh.
    #[staticmethod]
    #[pyo3(signature = (path, mesh))]
    fn load(py: Python<'_>, path: PathBuf, mesh: &Mesh) -> PyResult<Self> {
        run(py, None, move |_| {
            require_plain(mesh)?;
            let bytes = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
            let index = DistanceIndex::from_bytes(&bytes)?;
            index.require(mesh.surface())?;
            Ok(Self { index })
        })
    }

    /// Writes it to a file.
    ///
    /// Raises OSError where that cannot be written.
    #[pyo3(signature = (path))]
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        run(py, None, move |_| {
            let write = || {
                let mut file = BufWriter::new(File::create(&path)?);
                self.index.write(&mut file)?;
                file.flush()
            };
            Ok(write().with_context(|| format!("cannot write {}", path.display()))?)
        })
    }

    /// Distances of vertices: `starts` and `ends` (k,) integers, a pair each.
    ///
    /// Returns `Bounds`: (k,) lengths of paths, mostly longer than the shortest by less than a thousandth, and what distances are no less than.
    ///
    /// Raises HeatwalkError for vertices that do not exist.
    fn distance<'py>(
        &self,
        py: Python<'py>,
        starts: &Bound<'_, PyAny>,
        ends: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let starts = Given::new("starts", starts)?.row(None)?.indices()?;
        let ends = Given::new("ends", ends)?.row(Some(starts.len()))?.indices()?;
        let vertex = |index: u64| usize::try_from(index).unwrap_or(usize::MAX);
        let bounds = run(py, None, |_| {
            let pairs = starts.iter().zip(&ends);
            Ok(pairs
                .map(|(&a, &b)| self.index.distance(vertex(a), vertex(b)))
                .collect::<heatwalk_index::Result<Vec<_>>>()?)
        })?;
        let upper = PyArray1::from_iter(py, bounds.iter().map(|bounds| bounds.upper));
        let lower = PyArray1::from_iter(py, bounds.iter().map(|bounds| bounds.lower));
        named(py, "Bounds", (upper, lower))
    }

    /// How many distances it holds, of four bytes each.
    #[getter]
    fn labels(&self) -> usize {
        self.index.label_count()
    }

    fn __repr__(&self) -> String {
        format!("<heatwalk.Index: {} vertices, {} labels>", self.index.vertex_count(), self.index.label_count())
    }
}

/// Refuses what an index does not know of.
fn require_plain(mesh: &Mesh) -> Result<()> {
    let (has_costs, has_bridges) =
        mesh.with_solver(|solver| Ok((solver.costs().is_some(), !solver.joined().bridges().portals().is_empty())))?;
    match (has_costs, has_bridges) {
        (true, _) => Err(Failure::new("bad-parameter", "an index is of lengths; make the mesh without costs")),
        (_, true) => {
            Err(Failure::new("bad-parameter", "an index knows no bridges; make the mesh with bridges=\"off\""))
        }
        _ => Ok(()),
    }
}
