//! The class `TetMesh`: distances inside of tetrahedra.

use std::path::PathBuf;
use std::sync::Arc;

use heatwalk::Progress;
use heatwalk_files::{TetPlace, read_tetrahedra};
use heatwalk_volume::{TetPoint, TetSoup, TetSource, VolumeDistance, VolumeOptions, VolumeSolver, boundary_distance};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arrays::{Given, rows, shaped, vectors};
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::named::named;
use crate::options::volume_options;
use crate::sources::{initial_distances, one, require_one_each, several};
use crate::turn::Turns;

/// A mesh of tetrahedra, and what answers questions inside of it.
///
/// `V`: (n, 3) floats, the vertices. `T`: (m, 4) integers, the tetrahedra, counted from 0, in either orientation. Both are copied. Answers are by these
/// vertices, in the unit of `V`. Tetrahedra without volume and duplicates are left out, as `report` tells. `costs`: (m,) floats from 0.001 to
/// 1000, what a unit of length costs in each, or inf for walls; distances are then least costs.
///
/// A place is a vertex, `(tetrahedron, (w0, w1, w2, w3))`, or three coordinates as floats inside of a tetrahedron.
///
/// Raises HeatwalkError for arrays of another shape or type, coordinates that are not finite, indices out of range, and where no tetrahedron is
/// left. Pickled, it is its arrays.
#[pyclass(frozen, module = "heatwalk")]
pub struct TetMesh {
    soup: TetSoup,
    mesh: Arc<heatwalk_volume::TetMesh>,
    costs: Option<Vec<f64>>,
    solver: Turns<VolumeSolver>,
}

impl TetMesh {
    fn build(soup: TetSoup, costs: Option<Vec<f64>>) -> Result<Self> {
        let mesh = Arc::new(heatwalk_volume::TetMesh::build(&soup)?);
        let solver = Turns::new(made(&soup, &mesh, costs.as_deref())?);
        Ok(Self { soup, mesh, costs, solver })
    }

    fn with_solver<R>(&self, work: impl FnOnce(&mut VolumeSolver) -> Result<R>) -> Result<R> {
        self.solver.with(|| made(&self.soup, &self.mesh, self.costs.as_deref()), work)
    }

    fn points(&self, places: &[TetPlace]) -> Result<Vec<TetPoint>> {
        places.iter().map(|place| Ok(place.on(&self.soup, &self.mesh)?)).collect()
    }

    fn values(&self, distance: &VolumeDistance) -> Vec<f64> {
        self.mesh.to_inputs(&distance.values, f64::INFINITY)
    }

    /// What the caller asked for.
    fn asked(
        &self,
        py: Python<'_>,
        sources: &Bound<'_, PyAny>,
        method: &str,
        initial: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<VolumeDistance> {
        let (sources, initial) = (several("source", sources)?, initial_distances(initial)?);
        let options = volume_options(method, options)?;
        run(py, progress, |progress| self.answer(&sources, initial.as_deref(), &options, progress))
    }

    fn answer(
        &self,
        places: &[TetPlace],
        initial: Option<&[f64]>,
        options: &VolumeOptions,
        progress: Progress<'_>,
    ) -> Result<VolumeDistance> {
        let points = self.points(places)?;
        if let Some(initial) = initial {
            require_one_each(points.len(), initial.len(), "initial distances")?;
        }
        let initial = |number: usize| initial.map_or(0.0, |initial| initial[number]);
        let source = |(number, point)| TetSource { point, initial_distance: initial(number) };
        let sources: Vec<TetSource> = points.into_iter().enumerate().map(source).collect();
        self.with_solver(|solver| {
            solver.prepare(options, progress)?;
            Ok(solver.distance(&sources, options)?)
        })
    }
}

/// The solver of a mesh with costs of the caller's tetrahedra.
fn made(soup: &TetSoup, mesh: &Arc<heatwalk_volume::TetMesh>, costs: Option<&[f64]>) -> Result<VolumeSolver> {
    let Some(costs) = costs else { return Ok(VolumeSolver::new(Arc::clone(mesh))) };
    let mut own = vec![1.0; mesh.tetrahedron_count()];
    for input in 0..soup.tetrahedra.len() {
        if let Some(tetrahedron) = mesh.tetrahedron_of_input(input) {
            own[tetrahedron.index()] = costs[input];
        }
    }
    Ok(VolumeSolver::with_costs(Arc::clone(mesh), &own)?)
}

#[pymethods]
impl TetMesh {
    #[new]
    #[pyo3(signature = (V, T, *, costs=None))]
    #[allow(non_snake_case, reason = "as everybody calls them")]
    fn new(
        py: Python<'_>,
        V: &Bound<'_, PyAny>,
        T: &Bound<'_, PyAny>,
        costs: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let positions = Given::new("V", V)?.points()?;
        let tetrahedra = Given::new("T", T)?.tetrahedra(positions.len())?;
        let costs = costs.map(|costs| Given::new("costs", costs)?.row(Some(tetrahedra.len()))?.floats()).transpose()?;
        run(py, None, move |_| Self::build(TetSoup { positions, tetrahedra }, costs))
    }

    /// Read the tetrahedra of a Gmsh, Medit, VTK or TetGen file; hexahedra, prisms and pyramids are cut into such.
    ///
    /// Raises OSError where the file cannot be read, HeatwalkError where it holds no tetrahedra.
    #[staticmethod]
    #[pyo3(signature = (path))]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        run(py, None, move |_| {
            let none = || {
                Failure::new(
                    "no-tetrahedra",
                    format!("{}: there are no tetrahedra in it; heatwalk.read reads surfaces", path.display()),
                )
            };
            Self::build(read_tetrahedra(&path)?.ok_or_else(none)?.soup, None)
        })
    }

    /// (n, 3) floats, a copy of the vertices.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        vectors(py, self.soup.positions.iter().map(|position| position.to_array()))
    }

    /// (m, 4) integers, a copy of the tetrahedra.
    #[getter]
    fn tetrahedra<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i64>> {
        rows(py, self.soup.tetrahedra.iter().map(|corners| corners.map(i64::from)))
    }

    /// (b, 3) integers, the triangles around the tetrahedra, by the vertices, oriented outward: `Mesh(tets.vertices, tets.boundary_faces)`
    /// is the surface.
    #[getter]
    fn boundary_faces<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i64>> {
        let boundary = self.mesh.boundary();
        let vertex = |corner: u32| self.mesh.input_of_vertex(boundary.vertices[corner as usize]) as i64;
        rows(py, boundary.soup.triangles.iter().map(|corners| corners.map(vertex)))
    }

    /// What was found and done when the mesh was made: how many tetrahedra were left out or turned, how many components there are, ...
    #[getter]
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (report, told) = (self.mesh.report(), PyDict::new(py));
        for (name, count) in [
            ("vertices", report.vertices),
            ("tetrahedra", report.tetrahedra),
            ("components", report.components),
            ("unreferenced_vertices", report.unreferenced_vertices),
            ("flat_tetrahedra", report.flat_tetrahedra),
            ("duplicate_tetrahedra", report.duplicate_tetrahedra),
            ("inverted_tetrahedra", report.inverted_tetrahedra),
            ("boundary_faces", report.boundary_faces),
        ] {
            told.set_item(name, count)?;
        }
        Ok(told)
    }

    /// The volume of all tetrahedra.
    #[getter]
    fn volume(&self) -> f64 {
        self.mesh.report().volume
    }

    /// The mean length of the edges.
    #[getter]
    fn mean_edge(&self) -> f64 {
        self.mesh.mean_edge()
    }

    /// The distance of each vertex from the nearest source, inside of the mesh.
    ///
    /// `sources`: a place, or several in a list; or an array, of vertices (k,) or of coordinates (k, 3). `initial`: (k,) floats, distances that sources
    /// start from. `method`: "march" (exact where straight lines lead to the source) or "heat". Options of march: `max_distance`; of heat: `time_step`,
    /// `boundary`, `solver`, `multi_source` and `exact_radius`, as of `Mesh.distance`. `progress` as there, while heat is factored.
    ///
    /// Returns (n,) floats, in the unit of the mesh; inf where nothing is reached, and for vertices that no tetrahedron uses.
    ///
    /// Raises HeatwalkError for places that do not exist and options that do not apply.
    #[pyo3(signature = (sources, method="march", *, initial=None, progress=None, **options))]
    fn distance<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        method: &str,
        initial: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let answer = self.asked(py, sources, method, initial, progress, options)?;
        Ok(PyArray1::from_vec(py, self.values(&answer)))
    }

    /// As `distance`, with how it was found.
    ///
    /// Returns `Answer`; no windows cross inside of tetrahedra.
    #[pyo3(signature = (sources, method="march", *, initial=None, progress=None, **options))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        method: &str,
        initial: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let answer = self.asked(py, sources, method, initial, progress, options)?;
        let values = PyArray1::from_vec(py, self.values(&answer));
        named(py, "Answer", (values, answer.method.name(), answer.exact_below, 0))
    }

    /// Distances from each source by itself, a row each; of all vertices. `sources` and the options are those of `distance`.
    ///
    /// Returns (k, n) floats, in the unit of the mesh; inf where nothing is reached.
    #[pyo3(signature = (sources, method="march", *, progress=None, **options))]
    fn matrix<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        method: &str,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let sources: Vec<TetPlace> = several("source", sources)?;
        let options = volume_options(method, options)?;
        let numbers = run(py, progress, |progress| {
            let mut numbers = Vec::new();
            for (number, source) in sources.iter().enumerate() {
                let share = number as f64 / sources.len() as f64;
                if progress(heatwalk::Stage::Answering, share).is_break() {
                    return Err(heatwalk::Error::Cancelled.into());
                }
                numbers.extend(self.values(&self.answer(&[*source], None, &options, progress)?));
            }
            Ok(numbers)
        })?;
        Ok(shaped(py, numbers, [sources.len(), self.soup.positions.len()]))
    }

    /// A shortest path inside of the mesh. `method` and the options are those of `distance`.
    ///
    /// Returns `TetPath`.
    ///
    /// Raises HeatwalkError where there is none.
    #[pyo3(signature = (start, end, method="march", *, progress=None, **options))]
    fn path<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'_, PyAny>,
        end: &Bound<'_, PyAny>,
        method: &str,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (start, end): (TetPlace, TetPlace) = (one("start", start)?, one("end", end)?);
        let options = volume_options(method, options)?;
        let path = run(py, progress, |progress| {
            let from = start.on(&self.soup, &self.mesh)?;
            let distance = self.answer(&[end], None, &options, progress)?;
            self.with_solver(|solver| Ok(solver.path(&distance, from)?))
        })?;
        let points = rows(py, path.points.iter().map(|point| point.to_array()));
        named(py, "TetPath", (points, path.length, path.cost))
    }

    /// How far each vertex is from the boundary, on straight lines.
    ///
    /// Returns (n,) floats; inf for vertices that no tetrahedron uses.
    fn boundary_distance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let values = run(py, None, |_| Ok(self.mesh.to_inputs(&boundary_distance(&self.mesh)?, f64::INFINITY)))?;
        Ok(PyArray1::from_vec(py, values))
    }

    fn __repr__(&self) -> String {
        let report = self.mesh.report();
        format!(
            "<heatwalk.TetMesh: {} vertices, {} tetrahedra, {} components>",
            self.soup.positions.len(),
            self.soup.tetrahedra.len(),
            report.components
        )
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        let keywords = PyDict::new(py);
        keywords.set_item("costs", self.costs.as_ref().map(|costs| PyArray1::from_slice(py, costs)))?;
        Ok(((self.vertices(py), self.tetrahedra(py)).into_pyobject(py)?, keywords))
    }

    /// Meshes do not change.
    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }
}
