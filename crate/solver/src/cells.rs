//! Cells: to each source belongs what is nearer to it than to any other, by exact distances (geodesic Voronoi cells; Mount,
//! "Voronoi diagrams on the surface of a polyhedron", 1985). Every window has a root, and with it a source.

use std::sync::Arc;

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::{FaceId, Place, ToSource, VertexData};

use crate::error::{Error, Result};
use crate::exact::{End, ExactGeometry, Keeping, Kept, PlaceDistances, WORK_BETWEEN_CALLS, Wavefront};

/// Which source is nearest to each vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// `#V`, the exact distance of each vertex from the sources, in the file's unit; infinite where none is reached.
    pub distances: VertexData<f64>,
    /// `#V`, the number of the source that this is the distance from, in the order given; of several, one of them. `None` where none
    /// is reached.
    pub nearest: VertexData<Option<u32>>,
}

/// Finds the nearest source of each vertex, in the time of one exact field.
///
/// # Errors
/// [`Error::NoSource`]; [`Error::NotExact`] where faces have different costs; those of [`ToSource::to_source`];
/// [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn cells<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S], progress: Progress<'_>) -> Result<Cells> {
    let mut front = started(geometry, sources)?;
    front.grow(f64::INFINITY, progress)?;
    Ok(Cells::of(&front))
}

fn started<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S]) -> Result<Wavefront> {
    if sources.is_empty() {
        return Err(Error::NoSource);
    }
    Wavefront::new(Arc::clone(geometry), sources)
}

impl Cells {
    fn of(front: &Wavefront) -> Self {
        let nearest = front.surface().vertices().map(|vertex| front.source_of_vertex(vertex)).collect();
        Self { distances: front.values().clone(), nearest }
    }

    /// `#F`, whether corners are in different cells, or a source begins one there.
    fn meet(&self, front: &Wavefront) -> Vec<bool> {
        let surface = front.surface();
        let is_mixed = |&[a, b, c]: &[_; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| self.nearest[vertex]);
            a != b || b != c
        };
        let mut do_meet: Vec<bool> = surface.faces().iter().map(is_mixed).collect();
        for face in front.sources().iter().flat_map(|source| source.place().faces(surface)) {
            do_meet[face.0 as usize] = true;
        }
        do_meet
    }
}

/// A search for the cells of vertices and places, which can be interrupted. It takes the time of two exact fields, since the second one
/// keeps what tells places apart in the faces where the first one has found that cells meet.
#[derive(Debug)]
pub struct CellSearch {
    phase: Phase,
}

#[derive(Debug)]
enum Phase {
    Vertices(Box<Wavefront>),
    Places(Cells, Box<Keeping>),
}

impl CellSearch {
    /// Starts at sources.
    ///
    /// # Errors
    /// As [`cells`].
    pub fn new<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S]) -> Result<Self> {
        Ok(Self { phase: Phase::Vertices(Box::new(started(geometry, sources)?)) })
    }

    /// Goes on until about `work` more windows have crossed a face. The cells, once all are found; else the search.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn advance(self, work: usize) -> Result<std::result::Result<CellMap, Self>> {
        let phase = match self.phase {
            Phase::Vertices(mut front) => {
                if front.advance(f64::INFINITY, work)? {
                    let cells = Cells::of(&front);
                    let do_meet = cells.meet(&front);
                    Phase::Places(cells, Box::new(Keeping::again(*front, do_meet)))
                } else {
                    Phase::Vertices(front)
                }
            }
            Phase::Places(cells, mut keeping) => {
                if keeping.advance(work)? {
                    return Ok(Ok(CellMap { cells, kept: keeping.finished() }));
                }
                Phase::Places(cells, keeping)
            }
        };
        Ok(Err(Self { phase }))
    }

    fn radius(&self) -> f64 {
        match &self.phase {
            Phase::Vertices(front) => front.radius(),
            Phase::Places(_, keeping) => keeping.radius(),
        }
    }
}

/// Finds the nearest source of each vertex and of places, in the time of two exact fields.
///
/// # Errors
/// As [`cells`].
pub fn cell_map<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S], progress: Progress<'_>) -> Result<CellMap> {
    let mut search = CellSearch::new(geometry, sources)?;
    loop {
        match search.advance(WORK_BETWEEN_CALLS)? {
            Ok(map) => return Ok(map),
            Err(rest) => search = rest,
        }
        report(progress, Stage::Searching { radius: search.radius() }, 0.0)?;
    }
}

/// Which source is nearest to any place.
#[derive(Debug)]
pub struct CellMap {
    /// Those of vertices.
    pub cells: Cells,
    kept: Kept,
}

impl CellMap {
    /// The number of the source that is nearest to a place in a face; `None` where none is reached. It takes microseconds where the corners
    /// are in different cells or a source lies there, and some hundred windows elsewhere.
    ///
    /// # Errors
    /// Those of [`ToPoint::to_point`](heatwalk_surface::ToPoint::to_point); [`Error::OutOfMemory`].
    pub fn at(&self, face: FaceId, weights: [f64; 3]) -> Result<Option<u32>> {
        let place = Place::Face { face, weights };
        let surface = self.kept.geometry().surface();
        surface.point(place)?;
        let Cells { distances, nearest } = &self.cells;
        if self.kept.has(face) {
            return Ok(self.kept.nearest(face, weights, |vertex| (distances[vertex], nearest[vertex])));
        }
        let distances = PlaceDistances::new(self.kept.geometry(), distances, self.kept.sources())?;
        Ok(distances.end(place)?.and_then(|end| match end {
            End::Vertex(vertex) => nearest[vertex],
            End::Source(source) => Some(source),
        }))
    }
}
