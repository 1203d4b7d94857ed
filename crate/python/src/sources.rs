//! Places on a mesh as Python gives them.

use glam::DVec3;
use heatwalk::{InputPlace, Source, Surface, SurfacePoint};
use heatwalk_files::TetPlace;
use numpy::PyUntypedArray;
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyInt};

use crate::arrays::Given;
use crate::errors::{Failure, Result};
use crate::mesh::Mesh;

/// What a place may be.
pub trait Placed: Sized {
    /// How it is given.
    const KNOWN: &'static str;
    /// Corners of an element.
    const CORNERS: usize;

    fn vertex(vertex: usize) -> Self;
    /// In a face or a tetrahedron, by the first [`Self::CORNERS`] weights.
    fn within(element: usize, weights: [f64; 4]) -> Self;
    fn near(point: DVec3) -> Self;
}

/// A place that may not be there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wanted {
    /// By vertices and faces.
    On(InputPlace),
    /// The place that is nearest to a point in space.
    Near(DVec3),
}

impl Placed for Wanted {
    const KNOWN: &'static str = "a vertex, (face, (w0, w1, w2)) or three coordinates as floats";
    const CORNERS: usize = 3;

    fn vertex(vertex: usize) -> Self {
        Self::On(InputPlace::Vertex(vertex))
    }

    fn within(triangle: usize, [a, b, c, _]: [f64; 4]) -> Self {
        Self::On(InputPlace::Triangle { triangle, weights: [a, b, c] })
    }

    fn near(point: DVec3) -> Self {
        Self::Near(point)
    }
}

impl Placed for TetPlace {
    const KNOWN: &'static str = "a vertex, (tetrahedron, (w0, w1, w2, w3)) or three coordinates as floats";
    const CORNERS: usize = 4;

    fn vertex(vertex: usize) -> Self {
        Self::Vertex(vertex)
    }

    fn within(tetrahedron: usize, weights: [f64; 4]) -> Self {
        Self::Inside { tetrahedron, weights }
    }

    fn near(point: DVec3) -> Self {
        Self::At(point)
    }
}

/// One place: `name` in messages.
pub fn one<P: Placed>(name: &str, value: &Bound<'_, PyAny>) -> Result<P> {
    match place(name, value)? {
        Some(place) => Ok(place),
        None => Err(bad::<P>(name, value)),
    }
}

/// One place, or several in a list or an array: `name` of one in messages.
pub fn several<P: Placed>(name: &str, value: &Bound<'_, PyAny>) -> Result<Vec<P>> {
    if value.cast::<PyUntypedArray>().is_ok() {
        let array = Given::new("the array of places", value)?;
        return match array.dimensions() {
            1 if array.is_whole() => Ok(array.indices()?.into_iter().map(vertex).collect()),
            1 if array.is_float() => Ok(vec![one(name, value)?]),
            0 => Ok(vec![one(name, value)?]),
            _ if array.is_float() => Ok(array.points()?.into_iter().map(P::near).collect()),
            _ => Err(Failure::new(
                "bad-dtype",
                format!("the array of {name}s has neither integers of the shape (n,) nor floats of the shape (n, 3)"),
            )),
        };
    }
    if let Some(place) = place(name, value)? {
        return Ok(vec![place]);
    }
    let Ok(items) = value.try_iter() else { return Err(bad::<P>(name, value)) };
    items.enumerate().map(|(number, item)| one(&format!("{name} {number}"), &item?)).collect()
}

/// A place, if it is one.
pub fn place<P: Placed>(name: &str, value: &Bound<'_, PyAny>) -> Result<Option<P>> {
    if let Some(vertex) = index(name, value)? {
        return Ok(Some(P::vertex(vertex)));
    }
    match value.len() {
        Ok(2) => {
            let (element, weights) = (value.get_item(0)?, value.get_item(1)?);
            let is_pair = weights.len().is_ok_and(|count| count == P::CORNERS) && !is_sequence(&element);
            let Some((weights, _)) = is_pair.then(|| numbers(&weights, P::CORNERS)).flatten() else { return Ok(None) };
            let Some(element) = index(name, &element)? else { return Ok(None) };
            Ok(Some(P::within(element, weights)))
        }
        Ok(3) => match numbers(value, 3) {
            Some(([x, y, z, _], true)) => Ok(Some(P::near(DVec3::new(x, y, z)))),
            _ => Ok(None),
        },
        _ => Ok(None),
    }
}

/// The distances that sources start from, if such are given.
pub fn initial_distances(value: Option<&Bound<'_, PyAny>>) -> Result<Option<Vec<f64>>> {
    value.map(|value| Given::new("initial", value)?.row(None)?.floats()).transpose()
}

/// Refuses anything but one `what` for each source.
pub fn require_one_each(sources: usize, given: usize, what: &str) -> Result<()> {
    if sources == given {
        return Ok(());
    }
    Err(Failure::new("bad-shape", format!("there are {sources} sources and {given} {what}")))
}

fn vertex<P: Placed>(index: u64) -> P {
    P::vertex(usize::try_from(index).unwrap_or(usize::MAX))
}

fn is_sequence(value: &Bound<'_, PyAny>) -> bool {
    value.len().is_ok()
}

/// A whole number, if it is one.
fn index(name: &str, value: &Bound<'_, PyAny>) -> Result<Option<usize>> {
    if value.is_instance_of::<PyBool>() {
        return Ok(None);
    }
    match value.extract::<i64>() {
        Ok(index) => {
            let sentence = || format!("the {name} is {index}; vertices and faces count from 0");
            usize::try_from(index).map(Some).map_err(|_| Failure::new("negative-index", sentence()))
        }
        Err(_) if value.is_instance_of::<PyInt>() => {
            Err(Failure::new("no-such-vertex", format!("the {name} is {value}, more than any mesh has")))
        }
        Err(_) => Ok(None),
    }
}

/// So many numbers, before zeros, and whether any of them is floating.
fn numbers(value: &Bound<'_, PyAny>, count: usize) -> Option<([f64; 4], bool)> {
    let (mut numbers, mut is_float) = ([0.0; 4], false);
    for (k, number) in numbers.iter_mut().enumerate().take(count) {
        let item = value.get_item(k).ok()?;
        if item.is_instance_of::<PyBool>() || is_sequence(&item) {
            return None;
        }
        is_float |= item.is_instance_of::<PyFloat>() || item.extract::<i64>().is_err();
        *number = item.extract().ok()?;
    }
    Some((numbers, is_float))
}

fn bad<P: Placed>(name: &str, value: &Bound<'_, PyAny>) -> Failure {
    let given = value.repr().map_or_else(|_| "something else".to_owned(), |text| text.to_string());
    let given: String = given.chars().take(60).collect();
    Failure::new("bad-place", format!("the {name} is {given}; give {}", P::KNOWN))
}

impl Mesh {
    /// The points of the surface at places. What is farther from the surface than its mean edge is warned of.
    pub fn points(&self, wanted: &[Wanted]) -> Result<Vec<SurfacePoint>> {
        wanted.iter().enumerate().map(|(number, &place)| self.point_of(place, number)).collect()
    }

    /// The point of the surface at a place.
    pub fn point(&self, wanted: Wanted) -> Result<SurfacePoint> {
        self.point_of(wanted, 0)
    }

    /// Sources, with distances that they start from where such are given.
    pub fn sources(&self, wanted: &[Wanted], initial: Option<&[f64]>) -> Result<Vec<Source>> {
        let points = self.points(wanted)?;
        let surface: &Surface = self.surface();
        let Some(initial) = initial else { return Ok(points.into_iter().map(Source::from).collect()) };
        require_one_each(points.len(), initial.len(), "initial distances")?;
        points.into_iter().zip(initial).map(|(point, &initial)| Ok(surface.source(point, initial)?)).collect()
    }

    fn point_of(&self, wanted: Wanted, number: usize) -> Result<SurfacePoint> {
        let point = match wanted {
            Wanted::On(place) => return Ok(place.on(self.soup(), self.surface())?),
            Wanted::Near(point) => point,
        };
        let Some((place, distance)) = self.nearest_places().nearest(self.surface(), point) else {
            let coordinates = point.to_array();
            return Err(Failure::new("not-finite", format!("the coordinates {coordinates:?} are not finite")));
        };
        if distance > self.surface().mean_edge() {
            let text = format!("place {number} is {distance} away from the surface; its nearest point is taken");
            let text = std::ffi::CString::new(text).unwrap_or_default();
            Python::attach(|py| PyErr::warn(py, &py.get_type::<PyUserWarning>(), &text, 1))?;
        }
        Ok(self.surface().point(place)?)
    }
}
