//! Paths and walks.

use heatwalk::{
    DistanceSolver, Path, PathKind, Progress, Stage, Straightest, Surface, SurfacePoint, bezier, closed_geodesic,
    geodesic_loop, handle_loops, straighten, straightest,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::arrays::vector;
use crate::directions::direction;
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::Mesh;
use crate::named::named;
use crate::options::distance_options;
use crate::sources::{one, several};

#[pymethods]
impl Mesh {
    /// The path from a place to another.
    ///
    /// `start`, `end`: as sources of `distance`, whose options these are. `kind`: "straight" (default) is locally shortest, and the
    /// shortest where distances are exact, as by "auto" on most meshes; "descent" goes down the distances as they are; "exact" is a
    /// shortest path whatever the method.
    ///
    /// Returns `Path`: points from `start` to `end`, with the face of each and weights there, and its length.
    ///
    /// Raises HeatwalkError as `distance`, and where no path leads to `end`.
    #[pyo3(signature = (start, end, method="auto", kind="straight", *, progress=None, **options))]
    #[allow(clippy::too_many_arguments, reason = "keywords of Python")]
    fn path<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'_, PyAny>,
        end: &Bound<'_, PyAny>,
        method: &str,
        kind: &str,
        progress: Option<Py<PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (start, end) = (one("start", start)?, one("end", end)?);
        let options = distance_options(method, options)?;
        let kind: PathKind = kind.parse().map_err(Failure::from)?;
        let (path, cost) = run(py, progress, |progress| {
            let (start, end) = (self.point(start)?, self.point(end)?);
            self.with_solver(|solver| {
                let path = if kind == PathKind::Exact {
                    shortest(solver, [start, end], progress)?
                } else {
                    let answer = solver.distance(&[end], &options, progress)?;
                    solver.path(&answer, start, kind)?
                };
                let cost = solver.cost_of(&path);
                Ok((path, cost))
            })
        })?;
        self.told_as_path(py, &path, cost)
    }

    /// A locally shortest path beside the one that goes through places in turn, which shortens that without leaving the way around what the
    /// surface has between.
    ///
    /// `places`: two or more, as sources of `distance`; only the first and the last are still on the path.
    ///
    /// Returns `Path`.
    ///
    /// Raises HeatwalkError for places that no path joins.
    #[pyo3(signature = (places, *, progress=None))]
    fn path_through<'py>(
        &self,
        py: Python<'py>,
        places: &Bound<'_, PyAny>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let places = several("place", places)?;
        let (path, cost) = run(py, progress, |progress| {
            let points = self.points(&places)?;
            if points.len() < 2 {
                return Err(Failure::new("bad-parameter", "a path goes through two places at least"));
            }
            self.with_solver(|solver| {
                let mut through = Vec::new();
                for ends in points.windows(2) {
                    through.extend(shortest(solver, [ends[0], ends[1]], progress)?.points);
                }
                let surface = solver.surface();
                let path = straighten(surface, &Path::new(surface, through))?;
                Ok((path.clone(), solver.cost_of(&path)))
            })
        })?;
        self.told_as_path(py, &path, cost)
    }

    /// The Bézier curve of control places, by exact shortest paths: it begins at the first and ends at the last.
    ///
    /// `places`: as sources of `distance`.
    ///
    /// Returns `Path`.
    ///
    /// Raises HeatwalkError for places that no path joins.
    #[pyo3(signature = (places, *, progress=None))]
    fn bezier<'py>(
        &self,
        py: Python<'py>,
        places: &Bound<'_, PyAny>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let places = several("place", places)?;
        let curve = run(py, progress, |progress| Ok(bezier(&self.geometry()?, &self.points(&places)?, progress)?))?;
        self.told_as_path(py, &curve.path, curve.path.length())
    }

    /// The closed curve through places in turn, by shortest paths from each to the next and from the last to the first.
    ///
    /// `places`: as sources of `distance`. Through one or two it is the shortest curve found that does not shrink to a point, around a
    /// handle or a hole.
    ///
    /// Returns `Path`, whose last point is its first.
    ///
    /// Raises HeatwalkError for places that no path joins, and for one or two where all loops shrink to points.
    #[pyo3(signature = (places, *, progress=None))]
    fn r#loop<'py>(
        &self,
        py: Python<'py>,
        places: &Bound<'_, PyAny>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.told_loop(py, places, false, progress)
    }

    /// A closed geodesic: what the `loop` through places tightens to once it may leave them.
    ///
    /// `places`: as for `loop`.
    ///
    /// Returns `Path`, whose last point is its first.
    ///
    /// Raises HeatwalkError as `loop`, and where the loop shrinks to a point.
    #[pyo3(signature = (places, *, progress=None))]
    fn closed_geodesic<'py>(
        &self,
        py: Python<'py>,
        places: &Bound<'_, PyAny>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.told_loop(py, places, true, progress)
    }

    /// Closed geodesics around the handles and through them, two of each, the shortest first.
    ///
    /// Returns a list of `Path`, empty where there are no handles.
    #[pyo3(signature = (*, progress=None))]
    fn handle_loops<'py>(&self, py: Python<'py>, progress: Option<Py<PyAny>>) -> PyResult<Bound<'py, PyList>> {
        let loops = run(py, progress, |progress| Ok(handle_loops(self.surface(), progress)?))?;
        let told = loops.iter().map(|path| self.told_as_path(py, path, path.length()));
        PyList::new(py, told.collect::<PyResult<Vec<_>>>()?)
    }

    /// Walks as straight as the surface lets one.
    ///
    /// `start`: a place as a source of `distance`. `direction`: three floats, of any length, whose part along the surface counts: along
    /// `face` where that is given, else along the face at the place that agrees with it best. `length`: how far, 0 or more.
    ///
    /// Returns `Walk`: as `Path`, with the direction at its end, and whether the surface ended before.
    ///
    /// Raises HeatwalkError for a place that does not exist, and a direction that is square to the surface.
    #[pyo3(signature = (start, direction, length, *, face=None))]
    fn walk<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'_, PyAny>,
        direction: &Bound<'_, PyAny>,
        length: f64,
        face: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (start, direction) = (one("start", start)?, self::direction("direction", direction)?);
        let walk = run(py, None, |_| {
            let surface: &Surface = self.surface();
            let face = face.map(|face| surface.require_face(self.soup(), face)).transpose()?;
            Ok(straightest(surface, self.point(start)?, face, direction, length)?)
        })?;
        let Straightest { path, direction, is_at_boundary } = walk;
        let (points, (faces, weights)) = self.told_path(py, &path);
        let direction = vector(py, direction);
        named(py, "Walk", (points, faces, weights, path.length(), direction, is_at_boundary))
    }
}

/// Windows between two looks for Ctrl-C: some milliseconds.
const WORK: usize = 20_000;

/// A shortest path between two places.
fn shortest(solver: &mut DistanceSolver, [start, end]: [SurfacePoint; 2], progress: Progress<'_>) -> Result<Path> {
    let mut search = None;
    loop {
        if let Some(path) = solver.search_path(&mut search, start, &[end.into()], WORK)? {
            return Ok(path);
        }
        if progress(Stage::Searching { radius: 0.0 }, 0.0).is_break() {
            return Err(heatwalk::Error::Cancelled.into());
        }
    }
}

impl Mesh {
    /// The closed curve through places, or a closed geodesic that it tightens to.
    fn told_loop<'py>(
        &self,
        py: Python<'py>,
        places: &Bound<'_, PyAny>,
        is_free: bool,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let places = several("place", places)?;
        let path = run(py, progress, |progress| {
            let held = geodesic_loop(&self.geometry()?, &self.points(&places)?, progress)?;
            Ok(if is_free { closed_geodesic(self.surface(), &held)? } else { held })
        })?;
        self.told_as_path(py, &path, path.length())
    }

    fn told_as_path<'py>(&self, py: Python<'py>, path: &Path, cost: f64) -> PyResult<Bound<'py, PyAny>> {
        let (points, (faces, weights)) = self.told_path(py, path);
        named(py, "Path", (points, faces, weights, path.length(), cost))
    }
}
