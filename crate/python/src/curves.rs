//! Distance from curves, and isolines.

use std::sync::Arc;

use heatwalk::exact::ExactGeometry;
use heatwalk::{Curve, InputVertex, Progress, Sign, Surface, SurfacePoint, curve_distance, signed_curve_distance};
use heatwalk_curves::{Field, Isoline, Isolines, Levels};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::arrays::{Given, vectors};
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::Mesh;
use crate::named::named;
use crate::sources::{Wanted, place, several};

/// What stands for all boundaries of a surface.
const BOUNDARY: &str = "boundary";

/// Where a curve leads.
enum Course {
    Boundary,
    Through { places: Vec<Wanted>, is_closed: bool },
}

/// One curve or several. Those that end where they begin are closed, and all where they are to be.
fn courses(value: &Bound<'_, PyAny>, closed: bool) -> Result<Vec<Course>> {
    if value.extract::<&str>().is_ok_and(|word| word == BOUNDARY) {
        return Ok(vec![Course::Boundary]);
    }
    let items = value.try_iter().and_then(|items| items.collect::<PyResult<Vec<_>>>());
    let items = items.map_err(|_| {
        Failure::new("bad-curve", "the curves are no list; give lists of places, or \"boundary\" for all boundaries")
    })?;
    let mut are_places = !items.is_empty();
    for item in &items {
        are_places &= place::<Wanted>("place", item)?.is_some();
    }
    let course = |number: usize, curve: &Bound<'_, PyAny>| {
        let mut places = several(&format!("place of curve {number}:"), curve)?;
        let is_round = places.len() > 2 && places.first() == places.last();
        if is_round {
            places.pop();
        }
        Ok(Course::Through { places, is_closed: closed || is_round })
    };
    if are_places {
        return Ok(vec![course(0, value)?]);
    }
    items.iter().enumerate().map(|(number, curve)| course(number, curve)).collect()
}

impl Mesh {
    fn curves(&self, geometry: &Arc<ExactGeometry>, courses: &[Course], progress: Progress<'_>) -> Result<Vec<Curve>> {
        let curve = |course: &Course| match course {
            Course::Boundary => Curve::boundary(geometry.surface())
                .ok_or_else(|| Failure::new("no-boundary", "the surface has no boundary; give places for the curve")),
            Course::Through { places, is_closed } => {
                let points: Vec<SurfacePoint> = self.points(places)?;
                Ok(Curve::through(geometry, &points, *is_closed, progress)?)
            }
        };
        courses.iter().map(curve).collect()
    }
}

#[pymethods]
impl Mesh {
    /// The exact distance of each vertex from the nearest point of curves.
    ///
    /// `curves`: a list of places as for `distance`, or of such lists; a curve runs along shortest paths from place to place, and back to
    /// the first where it is `closed` or ends where it begins. "boundary" is all boundaries.
    ///
    /// Returns (n,) floats, in the unit of the mesh; inf where nothing is reached.
    ///
    /// Raises HeatwalkError for places that do not exist, or that no path joins.
    #[pyo3(signature = (curves, *, closed=false, progress=None))]
    fn curve_distance<'py>(
        &self,
        py: Python<'py>,
        curves: &Bound<'_, PyAny>,
        closed: bool,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let courses = courses(curves, closed)?;
        let values = run(py, progress, |progress| {
            let geometry = self.geometry()?;
            let curves = self.curves(&geometry, &courses, progress)?;
            Ok(curve_distance(&geometry, &curves, progress)?)
        })?;
        Ok(PyArray1::from_vec(py, self.to_inputs(&values, f64::INFINITY)))
    }

    /// As `curve_distance`, negative on the left of curves, and so inside of those that run counterclockwise, seen from outside.
    ///
    /// `sign`: that of the "nearest" point, or by "heat", which closes gaps; "auto" (default) is nearest where all curves are closed
    /// and do not meet.
    #[pyo3(signature = (curves, *, closed=false, sign="auto", progress=None))]
    fn signed_distance<'py>(
        &self,
        py: Python<'py>,
        curves: &Bound<'_, PyAny>,
        closed: bool,
        sign: &str,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let courses = courses(curves, closed)?;
        let sign: Sign = sign.parse().map_err(Failure::from)?;
        let signed = run(py, progress, |progress| {
            let geometry = self.geometry()?;
            let curves = self.curves(&geometry, &courses, progress)?;
            Ok(signed_curve_distance(&geometry, &curves, sign, progress)?)
        })?;
        Ok(PyArray1::from_vec(py, self.to_inputs(&signed.values, f64::INFINITY)))
    }

    /// Isolines of values at vertices, linear on each face.
    ///
    /// `values`: (n,) floats, inf where there is none. `levels`: floats, the values wanted; or `count` of them that part the largest into equal
    /// shares; or the multiples of `spacing`.
    ///
    /// Returns a list of `Isoline`, ascending: its value, curves, length, and the area of what is below it. Larger values are on the
    /// left of curves, seen from outside.
    ///
    /// Raises HeatwalkError where values are NaN, and unless one of `levels`, `count` and `spacing` is given.
    #[pyo3(signature = (values, levels=None, *, count=None, spacing=None))]
    fn isolines<'py>(
        &self,
        py: Python<'py>,
        values: &Bound<'_, PyAny>,
        levels: Option<&Bound<'_, PyAny>>,
        count: Option<usize>,
        spacing: Option<f64>,
    ) -> PyResult<Bound<'py, PyList>> {
        let values = Given::new("values", values)?.row(Some(self.soup().positions.len()))?.floats()?;
        let levels = levels.map(|levels| Given::new("levels", levels)?.row(None)?.floats()).transpose()?;
        let found = run(py, None, |_| {
            let surface: &Surface = self.surface();
            let first = |vertex| {
                let InputVertex(input) = surface.inputs_of_vertex(vertex)[0];
                values[input as usize]
            };
            let field = Field::new(
                surface.positions().iter().copied().collect(),
                surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect(),
                surface.vertices().map(first).collect(),
            )?;
            let levels = match (levels, count, spacing) {
                (Some(levels), None, None) => Levels::at(&levels)?,
                (None, Some(count), None) => Levels::counted(count, field.largest())?,
                (None, None, Some(spacing)) => Levels::spaced(spacing, field.largest())?,
                _ => return Err(Failure::new("no-level", "give one of levels, count and spacing")),
            };
            Ok(Isolines::trace(&field, &levels).isolines)
        })?;
        let isolines = found.iter().map(|isoline| self.told_isoline(py, isoline)).collect::<PyResult<Vec<_>>>()?;
        PyList::new(py, isolines)
    }
}

impl Mesh {
    fn told_isoline<'py>(&self, py: Python<'py>, isoline: &Isoline) -> PyResult<Bound<'py, PyAny>> {
        let curve = |curve: &heatwalk_curves::Curve| {
            let points = vectors(py, curve.points.iter().map(|point| point.to_array()));
            let face = |&face: &u32| i64::from(self.surface().triangle_of_face(heatwalk::FaceId(face)).0);
            let faces = PyArray1::from_iter(py, curve.triangles.iter().map(face));
            named(py, "Curve", (points, faces, curve.is_closed, curve.length))
        };
        let curves = isoline.curves.iter().map(curve).collect::<PyResult<Vec<_>>>()?;
        named(py, "Isoline", (isoline.value, PyList::new(py, curves)?, isoline.length, isoline.enclosed_area))
    }
}
