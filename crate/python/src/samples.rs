//! Samples, cells and means.

use heatwalk::{
    Element, FaceId, Mean, Place, SampleCount, Surface, SurfacePoint, VertexId, cells, exact::exact_distance,
    farthest_samples, mean, relaxed,
};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arrays::{Given, vector, vectors};
use crate::errors::Failure;
use crate::interrupt::run;
use crate::mesh::Mesh;
use crate::named::named;
use crate::sources::{initial_distances, one, several};

#[pymethods]
impl Mesh {
    /// What is nearest to each of several sources, by exact distance.
    ///
    /// `sources`, `initial`: as for `distance`.
    ///
    /// Returns `Cells`: of each vertex the number of the nearest source (-1 where none is reached), and its distance.
    #[pyo3(signature = (sources, *, initial=None, progress=None))]
    fn cells<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        initial: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let sources = several("source", sources)?;
        let initial = initial_distances(initial)?;
        let found = run(py, progress, |progress| {
            let sources = self.sources(&sources, initial.as_deref())?;
            Ok(cells(&self.geometry()?, &sources, progress)?)
        })?;
        let nearest = self.to_inputs(&found.nearest, None);
        let nearest = PyArray1::from_iter(py, nearest.into_iter().map(|source| source.map_or(-1, i64::from)));
        let distances = PyArray1::from_vec(py, self.to_inputs(&found.distances, f64::INFINITY));
        named(py, "Cells", (nearest, distances))
    }

    /// Samples spread over the surface: each is the vertex that is farthest from those before.
    ///
    /// `count` of them, or as many as leave no vertex farther than `radius` from one; no two are nearer to each other. The first is
    /// `start`, a vertex; if not given, the first one. `relax`: rounds in which samples move to the middles of what is nearest to each.
    ///
    /// Returns `Samples`: their faces, weights and points, their vertices (None with `relax`), and how far the farthest vertex is
    /// from one.
    ///
    /// Raises HeatwalkError unless one of `count` and `radius` is given, and positive.
    #[pyo3(signature = (count=None, *, radius=None, relax=0, start=None, progress=None))]
    fn sample<'py>(
        &self,
        py: Python<'py>,
        count: Option<usize>,
        radius: Option<f64>,
        relax: usize,
        start: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let count = match (count, radius) {
            (Some(count), None) => SampleCount::Exactly(count),
            (None, Some(radius)) => SampleCount::Within(radius),
            _ => return Err(Failure::new("bad-parameter", "give one of count and radius").into()),
        };
        let start = start.map(|start| one("start", start)).transpose()?;
        let surface: &Surface = self.surface();
        let (places, vertices, radius) = run(py, progress, |progress| {
            let first = match start {
                None => surface.first_vertex(),
                Some(start) => self
                    .point(start)?
                    .place()
                    .vertex(surface)
                    .ok_or_else(|| Failure::new("bad-parameter", "the start of samples is no vertex; give one"))?,
            };
            let geometry = self.geometry()?;
            let samples = farthest_samples(&geometry, first, count, progress)?;
            if relax == 0 {
                let places = samples.vertices.iter().map(|&vertex| Place::Vertex(vertex)).collect();
                let radius = samples.covering_radius();
                return Ok((places, Some(samples.vertices), radius));
            }
            let relaxed = relaxed(&geometry, &samples.vertices, relax, progress)?;
            let distances = exact_distance(self.surface(), &relaxed, progress)?;
            let places: Vec<Place> = relaxed.iter().map(SurfacePoint::place).collect();
            Ok((places, None, distances.iter().copied().fold(0.0, f64::max)))
        })?;
        let on_faces = places.iter().map(|&place| (place, place.faces(surface)[0]));
        let (faces, weights) = self.told(py, on_faces.collect::<Vec<(Place, FaceId)>>().into_iter());
        let points = vectors(py, places.iter().map(|place| place.position(surface).to_array()));
        let number = |&vertex: &VertexId| surface.inputs_of_vertex(vertex)[0].index() as i64;
        let vertices = vertices.map(|vertices| PyArray1::from_iter(py, vertices.iter().map(number)));
        named(py, "Samples", (faces, weights, points, vertices, radius))
    }

    /// Where squared distances from weighted places sum to least.
    ///
    /// `sources`: places as for `distance`. `weights`: (k,) positive floats; 1 if not given.
    ///
    /// Returns `Mean`: the place, where that is, and the mean squared distance there.
    ///
    /// Raises HeatwalkError for places that no path joins.
    #[pyo3(signature = (sources, weights=None, *, progress=None))]
    fn mean<'py>(
        &self,
        py: Python<'py>,
        sources: &Bound<'_, PyAny>,
        weights: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let sources = several("source", sources)?;
        let weights = match weights {
            None => vec![1.0; sources.len()],
            Some(weights) => Given::new("weights", weights)?.row(Some(sources.len()))?.floats()?,
        };
        let Mean { place, variance } = run(py, progress, |progress| {
            let weighted: Vec<(SurfacePoint, f64)> = self.points(&sources)?.into_iter().zip(weights).collect();
            Ok(mean(&self.geometry()?, &weighted, progress)?)
        })?;
        let point = vector(py, place.position(self.surface()));
        named(py, "Mean", (self.told_place(py, place)?, point, variance))
    }
}
