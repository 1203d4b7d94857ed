//! Distances of vertices.

use std::num::NonZeroUsize;
use std::sync::{Mutex, PoisonError};

use heatwalk::{Choice, DistanceOptions, InputPlace, SurfacePoint, VertexId, row_source, surface, surface::memory};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Given, shaped};
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::{Mesh, all_threads, checked_threads};
use crate::named::named;
use crate::options::distance_options;
use crate::sources::{Wanted, initial_distances, several};

/// Bytes of a matrix that are refused, as a mistake, whatever the machine has: more than any has.
const MOST_BYTES: usize = isize::MAX as usize;

#[pymethods]
impl Mesh {
    /// The distance of each vertex from the nearest source.
    ///
    /// `sources`: a vertex, `(face, (w0, w1, w2))`, three coordinates as floats, or several of these in a list; or an array, of vertices (k,) or of
    /// coordinates (k, 3). `initial`: (k,) floats, distances that sources start from. Coordinates are taken at the nearest place of the surface,
    /// with a warning where that is farther away than a mean edge; `snap` tells how far.
    ///
    /// `method`: "auto" (exact while that takes about a second, beyond by few windows), "exact", "propagation" or "heat".
    /// Options of all but heat: `max_distance`; of auto and propagation: `windows` of each half-edge, a number or "all"; of heat:
    /// `operator` ("delaunay", "plain", "relocate"), `time_step` (m in t = m h², or "auto"), `boundary` ("neumann", "dirichlet", "average"),
    /// `solver` ("cholesky", "cg"), `multi_source` ("exact", "summed") and `exact_radius` (in mean edges, or "auto").
    ///
    /// `progress(fraction, stage)` is called every 50 ms or so; where it returns False the work ends.
    ///
    /// Returns (n,) floats, in the unit of the mesh; inf where nothing is reached, and for vertices that no face uses.
    ///
    /// Raises HeatwalkError for places that do not exist and options that do not apply, and KeyboardInterrupt at once.
    #[pyo3(signature = (sources, method="auto", *, initial=None, progress=None, **options))]
    fn distance<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        method: &str,
        initial: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let answer = self.answer(py, sources, method, initial, progress, options)?;
        Ok(PyArray1::from_vec(py, answer.values))
    }

    /// As `distance`, with how it was found.
    ///
    /// Returns `Answer`: the distances, the method that found them, below which distance they are exact, and how many windows
    /// crossed a face.
    #[pyo3(signature = (sources, method="auto", *, initial=None, progress=None, **options))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        method: &str,
        initial: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let Found { values, method, exact_below, windows } =
            self.answer(py, sources, method, initial, progress, options)?;
        named(py, "Answer", (PyArray1::from_vec(py, values), method, exact_below, windows))
    }

    /// Distances from each source by itself.
    ///
    /// `sources` and the options are those of `distance`; without sources, they are all vertices. `targets`: (l,) integers, the vertices
    /// that distances are wanted of; all if not given. Rows are found by `threads`, all of the machine if not given, and are the same, to
    /// the last bit, for any number. `dtype`: "float64" or "float32", which takes half of the memory; nothing else is kept of a row.
    ///
    /// Returns (k, l) floats, in the unit of the mesh; inf where nothing is reached.
    ///
    /// Raises HeatwalkError as `distance`, and where the matrix does not fit into memory.
    #[pyo3(signature = (sources=None, targets=None, method="auto", *, threads=None, dtype=None, progress=None, **options))]
    #[allow(clippy::too_many_arguments, reason = "keywords of Python")]
    fn matrix<'py>(
        &self,
        py: Python<'py>,
        sources: Option<&Bound<'_, PyAny>>,
        targets: Option<&Bound<'_, PyAny>>,
        method: &str,
        threads: Option<usize>,
        dtype: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let count = self.soup().positions.len();
        let sources = match sources {
            None => (0..count).map(|vertex| Wanted::On(InputPlace::Vertex(vertex))).collect(),
            Some(sources) => several("source", sources)?,
        };
        let targets = match targets {
            None => (0..count as u64).collect(),
            Some(targets) => Given::new("targets", targets)?.row(None)?.indices()?,
        };
        let question = Question {
            sources,
            targets: self.columns(&targets)?,
            options: distance_options(method, options)?,
            threads: checked_threads(threads)?.unwrap_or_else(all_threads),
        };
        Ok(match kind(py, dtype)? {
            Kind::Double => self.rows::<f64>(py, &question, progress, |value| value)?.into_any(),
            Kind::Single => self.rows::<f32>(py, &question, progress, |value| value as f32)?.into_any(),
        })
    }
}

/// A distance in the caller's order, and how it was found.
struct Found {
    values: Vec<f64>,
    method: &'static str,
    exact_below: f64,
    windows: usize,
}

/// What a matrix is asked for.
struct Question {
    sources: Vec<Wanted>,
    /// None for vertices that no face uses.
    targets: Vec<Option<VertexId>>,
    options: DistanceOptions,
    threads: NonZeroUsize,
}

enum Kind {
    Double,
    Single,
}

fn kind(py: Python<'_>, dtype: Option<&Bound<'_, PyAny>>) -> PyResult<Kind> {
    let Some(dtype) = dtype else { return Ok(Kind::Double) };
    let name = py.import("numpy")?.call_method1("dtype", (dtype,))?.getattr("name")?.to_string();
    match name.as_str() {
        "float64" => Ok(Kind::Double),
        "float32" => Ok(Kind::Single),
        _ => {
            Err(Failure::new("bad-dtype", format!("there is no matrix of {name}; choose one of float64, float32"))
                .into())
        }
    }
}

impl Mesh {
    fn answer(
        &self,
        py: Python<'_>,
        sources: &Bound<'_, PyAny>,
        method: &str,
        initial: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Found> {
        let sources = several("source", sources)?;
        let initial = initial_distances(initial)?;
        let options = distance_options(method, options)?;
        run(py, progress, |progress| {
            let sources = self.sources(&sources, initial.as_deref())?;
            self.with_solver(|solver| {
                let answer = solver.distance(&sources, &options, progress)?;
                Ok(Found {
                    values: solver.of_inputs(&answer),
                    method: answer.method.name(),
                    exact_below: answer.distance.exact_below,
                    windows: answer.windows,
                })
            })
        })
    }

    /// The surface's vertices of some of the caller's.
    fn columns(&self, targets: &[u64]) -> Result<Vec<Option<VertexId>>> {
        let vertices = self.surface().vertices_of_inputs();
        let column = |&target: &u64| {
            let index = usize::try_from(target).unwrap_or(usize::MAX);
            let missing = surface::Error::NoSuchVertex { vertex: index, vertices: vertices.len() };
            Ok(*vertices.as_slice().get(index).ok_or(missing)?)
        };
        targets.iter().map(column).collect()
    }

    fn rows<'py, T>(
        &self,
        py: Python<'py>,
        question: &Question,
        progress: Option<Py<PyAny>>,
        number: impl Fn(f64) -> T + Sync,
    ) -> PyResult<Bound<'py, PyArray2<T>>>
    where
        T: numpy::Element + Copy + Default + Send,
    {
        let Question { sources, targets, options, threads } = question;
        let shape = [sources.len(), targets.len()];
        let numbers = run(py, progress, |progress| {
            let mut numbers = room::<T>(shape)?;
            if numbers.is_empty() {
                return Ok(numbers);
            }
            let points = sources.iter().map(|&source| self.reachable(source)).collect::<Result<Vec<_>>>()?;
            let lines: Vec<_> = numbers.chunks_mut(targets.len()).map(Mutex::new).collect();
            self.with_solver(|solver| {
                let tell = |row: usize, values: &[f64]| {
                    let mut line = lines[row].lock().unwrap_or_else(PoisonError::into_inner);
                    for (entry, &value) in line.iter_mut().zip(values) {
                        *entry = number(value);
                    }
                };
                Ok(solver.map_rows(&points, targets, (options, *threads), tell, progress)?)
            })?;
            Ok(numbers)
        })?;
        Ok(shaped(py, numbers, shape))
    }

    /// The place on the surface; none for a vertex that no face uses.
    fn reachable(&self, source: Wanted) -> Result<Option<SurfacePoint>> {
        match source {
            Wanted::On(place) => Ok(row_source(place, self.soup(), self.surface())?),
            Wanted::Near(_) => self.point(source).map(Some),
        }
    }
}

/// Room for a matrix.
fn room<T: Copy + Default>([rows, columns]: [usize; 2]) -> Result<Vec<T>> {
    let count = rows.checked_mul(columns).filter(|&count| count <= MOST_BYTES / size_of::<T>());
    let has_room = |&count: &usize| {
        let needed = count as u64 * size_of::<T>() as u64;
        memory::require(needed, "making the matrix").is_ok() && Vec::<T>::new().try_reserve_exact(count).is_ok()
    };
    let Some(count) = count.filter(has_room) else {
        let bytes = rows as f64 * columns as f64 * size_of::<T>() as f64;
        let sentence = format!(
            "a matrix of {rows} × {columns} numbers takes {:.1} GiB, more than there is; ask for fewer sources at once, or dtype=\"float32\"",
            bytes / f64::from(1 << 30)
        );
        return Err(Failure::new("out-of-memory", sentence));
    };
    // Zeros are taken from the system as they are, without a touch.
    Ok(vec![T::default(); count])
}
