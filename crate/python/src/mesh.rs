//! The class `Mesh`: a surface in the caller's words, with its solver.

use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread::available_parallelism;

use heatwalk::exact::ExactGeometry;
use heatwalk::heat::VectorHeat;
use heatwalk::{
    BridgeRule, Costs, DistanceSolver, Element, FaceData, InputTriangle, NearestPlaces, Progress, Soup, Surface,
    UnitRule, VertexData, Walls, WeldRule,
};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::arrays::{Given, rows, vectors};
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::named::named;
use crate::options;
use crate::turn::Turns;

/// How a surface is made of triangles.
#[derive(Debug, Clone, Default)]
pub struct Options {
    weld: WeldRule,
    pub bridges: BridgeRule,
    pub links: usize,
    pub threads: Option<NonZeroUsize>,
    /// Of each triangle.
    costs: Option<Vec<f64>>,
    /// Triangles that nobody enters.
    walls: Vec<u64>,
}

impl Options {
    pub fn new(
        weld: Option<&Bound<'_, PyAny>>,
        bridges: Option<&Bound<'_, PyAny>>,
        links: usize,
        threads: Option<usize>,
    ) -> Result<Self> {
        let weld = weld.map(|rule| options::from("weld", rule)).transpose()?.unwrap_or_default();
        let bridges = bridges.map(|rule| options::from("bridges", rule)).transpose()?.unwrap_or_default();
        Ok(Self { weld, bridges, links, threads: checked_threads(threads)?, ..Self::default() })
    }
}

/// A number of threads, if one is given.
pub fn checked_threads(threads: Option<usize>) -> Result<Option<NonZeroUsize>> {
    let count = |threads| {
        let none = || Failure::new("bad-parameter", "the number of threads is 0; it must be 1 or more");
        NonZeroUsize::new(threads).ok_or_else(none)
    };
    threads.map(count).transpose()
}

/// A triangle mesh, and what answers questions on it.
///
/// `V`: (n, 3) floats, the vertices. `F`: (m, 3) integers, the triangles, counted from 0. Both are copied. Answers are by these
/// vertices and faces, in the unit of `V`.
///
/// Vertices of equal position become one; `weld` tells what else: "auto" (default) what cracks part that are too narrow to be seen,
/// "exact" nothing, or cracks up to this width. Triangles without area and duplicates are left out, and orientations are made to
/// agree, as `report` tells.
///
/// `bridges`: components that paths cross between: those that pierce, touch or nearly touch ("auto", default), none ("off"), or those no
/// farther apart than this; `links` so many more, nearest first.
///
/// `costs`: (m,) floats from 0.001 to 1000, what a unit of length costs in each face; distances are then least costs. `walls`: faces
/// that nobody enters. `inactive`: faces that are no part of the surface, though they count, as those of parts of a file that were not
/// chosen.
///
/// `threads` build the surface, all of the machine if not given; answers are the same, to the last bit, for any number.
///
/// Raises HeatwalkError for arrays of another shape or type, coordinates that are not finite, indices out of range, and where no
/// triangle is left. Pickled, it is its arrays and options.
#[pyclass(frozen, subclass, module = "heatwalk")]
pub struct Mesh {
    soup: Soup,
    options: Options,
    /// As walls part it.
    surface: Arc<Surface>,
    whole: Arc<Surface>,
    solver: Turns<DistanceSolver>,
    nearest: OnceLock<NearestPlaces>,
    diffusion: Mutex<Option<Arc<VectorHeat>>>,
}

impl Mesh {
    pub fn build(soup: Soup, options: Options) -> Result<Self> {
        let threads = options.threads.unwrap_or_else(all_threads);
        let whole = Arc::new(Surface::build_by(&soup, options.weld, threads)?);
        let solver = made(&soup, &whole, &options)?;
        let surface = Arc::clone(solver.surface());
        let (nearest, diffusion) = (OnceLock::new(), Mutex::default());
        Ok(Self { soup, options, surface, whole, solver: Turns::new(solver), nearest, diffusion })
    }

    /// As the caller gave it.
    pub fn soup(&self) -> &Soup {
        &self.soup
    }

    pub fn options(&self) -> &Options {
        &self.options
    }

    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// Works with the solver, one thread at a time, without Python's lock.
    pub fn with_solver<R>(&self, work: impl FnOnce(&mut DistanceSolver) -> Result<R>) -> Result<R> {
        self.solver.with(|| made(&self.soup, &self.whole, &self.options), work)
    }

    /// What exact distances need, which several threads may use at once.
    pub fn geometry(&self) -> Result<Arc<ExactGeometry>> {
        self.with_solver(|solver| Ok(Arc::clone(solver.exact_geometry())))
    }

    pub fn nearest_places(&self) -> &NearestPlaces {
        self.nearest.get_or_init(|| NearestPlaces::new(&self.surface))
    }

    /// What diffuses vectors, factored at the first call.
    pub fn diffusion(&self, progress: Progress<'_>) -> Result<Arc<VectorHeat>> {
        let has_portals = self.with_solver(|solver| Ok(!solver.joined().bridges().portals().is_empty()))?;
        if has_portals {
            let sentence = "heat carries nothing across bridges; make the mesh with bridges=\"off\"";
            return Err(Failure::new("bad-parameter", sentence));
        }
        let kept = || self.diffusion.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(diffusion) = &*kept() {
            return Ok(Arc::clone(diffusion));
        }
        let diffusion = Arc::new(VectorHeat::new(&self.surface, progress)?);
        *kept() = Some(Arc::clone(&diffusion));
        Ok(diffusion)
    }

    /// Numbers of vertices in the order of the caller's.
    pub fn to_inputs<T: Copy>(&self, values: &VertexData<T>, absent: T) -> Vec<T> {
        let value = |vertex: &Option<_>| vertex.map_or(absent, |vertex| values[vertex]);
        self.surface.vertices_of_inputs().iter().map(value).collect()
    }
}

pub fn all_threads() -> NonZeroUsize {
    available_parallelism().unwrap_or(NonZeroUsize::MIN)
}

/// The solver of a surface with walls, costs and bridges.
fn made(soup: &Soup, whole: &Arc<Surface>, options: &Options) -> Result<DistanceSolver> {
    let threads = options.threads.unwrap_or_else(all_threads);
    let mut solver = DistanceSolver::on_threads(Arc::clone(whole), threads);
    if !options.walls.is_empty() {
        let face = |&triangle: &u64| whole.require_face(soup, usize::try_from(triangle).unwrap_or(usize::MAX));
        let faces = options.walls.iter().map(face).collect::<heatwalk::surface::Result<_>>()?;
        solver.set_walls(&Walls { faces, edges: Vec::new() })?;
    }
    if let Some(costs) = &options.costs {
        let mut of_faces: FaceData<f64> = vec![1.0; whole.face_count()].into();
        for (triangle, &cost) in costs.iter().enumerate() {
            if let Some(face) = whole.face_of_triangle(InputTriangle::from_index(triangle)) {
                of_faces[face] = cost;
            }
        }
        solver.set_costs(Some(Costs::new(whole, of_faces)?));
    }
    solver.join(whole, options.bridges, options.links)?;
    Ok(solver)
}

#[pymethods]
impl Mesh {
    #[new]
    #[pyo3(signature = (V, F, *, weld=None, bridges=None, links=0, threads=None, costs=None, walls=None, inactive=None))]
    #[allow(non_snake_case, reason = "as everybody calls them")]
    #[allow(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        py: Python<'_>,
        V: &Bound<'_, PyAny>,
        F: &Bound<'_, PyAny>,
        weld: Option<&Bound<'_, PyAny>>,
        bridges: Option<&Bound<'_, PyAny>>,
        links: usize,
        threads: Option<usize>,
        costs: Option<&Bound<'_, PyAny>>,
        walls: Option<&Bound<'_, PyAny>>,
        inactive: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let positions = Given::new("V", V)?.points()?;
        let triangles = Given::new("F", F)?.triangles(positions.len())?;
        let mut options = Options::new(weld, bridges, links, threads)?;
        options.costs =
            costs.map(|costs| Given::new("costs", costs)?.row(Some(triangles.len()))?.floats()).transpose()?;
        options.walls = walls.map_or(Ok(Vec::new()), |walls| Given::new("walls", walls)?.row(None)?.indices())?;
        let inactive = inactive.map_or(Ok(Vec::new()), |faces| Given::new("inactive", faces)?.row(None)?.indices())?;
        if let Some(&face) = inactive.iter().find(|&&face| face >= triangles.len() as u64) {
            let (triangle, triangles) = (usize::try_from(face).unwrap_or(usize::MAX), triangles.len());
            return Err(Failure::from(heatwalk::surface::Error::NoSuchTriangle { triangle, triangles }).into());
        }
        let soup = Soup { inactive: ranges(inactive), ..Soup::single("mesh", positions, triangles) };
        run(py, None, move |_| Self::build(soup, options))
    }

    /// (n, 3) floats, a copy of the vertices.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        vectors(py, self.soup.positions.iter().map(|position| position.to_array()))
    }

    /// (m, 3) integers, a copy of the faces.
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i64>> {
        rows(py, self.soup.triangles.iter().map(|corners| corners.map(i64::from)))
    }

    /// What was found and done when the surface was made of the triangles: how many vertices were welded, faces left out or flipped, how many
    /// components and boundary loops there are, ...
    #[getter]
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (report, told) = (self.whole.report(), PyDict::new(py));
        for (name, count) in [
            ("vertices", report.vertices),
            ("faces", report.faces),
            ("welded_vertices", report.welded_vertices),
            ("crack_vertices", report.crack_vertices),
            ("unreferenced_vertices", report.unreferenced_vertices),
            ("degenerate_faces", report.degenerate_faces),
            ("duplicate_faces", report.duplicate_faces),
            ("flipped_faces", report.flipped_faces),
            ("non_manifold_edges", report.non_manifold_edges),
            ("components", report.components),
            ("boundary_loops", report.boundary_loops),
        ] {
            told.set_item(name, count)?;
        }
        told.set_item("euler_characteristic", report.euler_characteristic)?;
        Ok(told)
    }

    /// The mean length of the edges.
    #[getter]
    fn mean_edge(&self) -> f64 {
        self.whole.mean_edge()
    }

    /// The unit of lengths, as the file says it: "mm", "m", ...; None where nothing says one.
    #[getter]
    fn unit(&self) -> Option<&'static str> {
        let unit = self.soup.unit.map(|unit| UnitRule::Is(Some(unit)));
        unit.and_then(|rule| self.soup.length_unit(rule).unit).map(|unit| unit.symbol())
    }

    /// What was left out of the file, or read otherwise than it is written: a sentence each.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.soup.warnings.iter().map(ToString::to_string).collect()
    }

    /// The places of the surface that are nearest to points in space: `points` (k, 3) floats.
    ///
    /// Returns `Snapped`, which tells how far each is.
    fn snap<'py>(&self, py: Python<'py>, points: &Bound<'_, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let wanted = Given::new("points", points)?.points()?;
        let found = run(py, None, |_| {
            let places = self.nearest_places();
            let nearest = |&point| {
                let bad = || Failure::new("not-finite", format!("the point {point} is not finite"));
                places.nearest(&self.surface, point).ok_or_else(bad)
            };
            wanted.iter().map(nearest).collect::<Result<Vec<_>>>()
        })?;
        let places = found.iter().map(|&(place, _)| place);
        let (faces, weights) = self.told(py, places.clone().map(|place| (place, place.faces(&self.surface)[0])));
        let points = vectors(py, places.map(|place| place.position(&self.surface).to_array()));
        let distances = PyArray1::from_iter(py, found.iter().map(|&(_, distance)| distance));
        named(py, "Snapped", (faces, weights, points, distances))
    }

    fn __repr__(&self) -> String {
        let counted = |count: usize, one: &str, many: &str| format!("{count} {}", if count == 1 { one } else { many });
        let report = self.whole.report();
        let told = [
            counted(self.soup.positions.len(), "vertex", "vertices"),
            counted(self.soup.triangles.len(), "face", "faces"),
            counted(report.components, "component", "components"),
            counted(report.boundary_loops, "boundary loop", "boundary loops"),
        ];
        format!("<heatwalk.Mesh: {}>", told.join(", "))
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        let Options { weld, bridges, links, threads, costs, walls } = &self.options;
        let keywords = PyDict::new(py);
        keywords.set_item("weld", weld.to_string())?;
        keywords.set_item("bridges", bridges.to_string())?;
        keywords.set_item("links", links)?;
        keywords.set_item("threads", threads.map(NonZeroUsize::get))?;
        keywords.set_item("costs", costs.as_ref().map(|costs| PyArray1::from_slice(py, costs)))?;
        keywords.set_item("walls", (!walls.is_empty()).then(|| PyArray1::from_slice(py, walls)))?;
        let inactive: Vec<u64> = self.soup.inactive.iter().cloned().flatten().map(|face| face as u64).collect();
        keywords.set_item("inactive", (!inactive.is_empty()).then(|| PyArray1::from_vec(py, inactive)))?;
        Ok(((self.vertices(py), self.faces(py)).into_pyobject(py)?, keywords))
    }

    /// Meshes do not change.
    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }
}

/// Indices of triangles as ranges, ascending.
fn ranges(mut triangles: Vec<u64>) -> Vec<Range<usize>> {
    triangles.sort_unstable();
    triangles.dedup();
    let range = |run: &[u64]| run[0] as usize..run[run.len() - 1] as usize + 1;
    triangles.chunk_by(|a, b| a + 1 == *b).map(range).collect()
}
