//! The wavefront: windows that wait at edges, and their way across faces.

use crate::extremum::{larger, smaller};
use std::sync::Arc;

use super::crossing::Crossing;
use super::geometry::{ExactGeometry, after, before};
use super::origin::Origin;
use super::queue::Buckets;
use super::targets::Targets;
use super::window::{Beam, GRAZE, Window, length};
use crate::error::Result;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, Place, Source, ToPoint, ToSource, VertexData, VertexId};

/// Width of the queue's buckets, in mean edges. The number of windows hardly depends on it below two.
const BUCKET: f64 = 1.0;

/// Exact distances that grow outward from their sources; stopped and continued at will, with the same result.
#[derive(Debug)]
pub struct Wavefront {
    pub(super) surface: Arc<Surface>,
    pub(super) geometry: Arc<ExactGeometry>,
    pub(super) sources: Vec<Source>,
    pub(super) targets: Targets,
    /// `#V`.
    pub(super) values: VertexData<f64>,
    /// `#V`.
    pub(super) origins: Vec<Origin>,
    /// Vertices with a finite value.
    reached: Vec<VertexId>,
    /// All windows; those not in use form a list from `free`. Number 0 is none.
    pub(super) windows: Vec<Window>,
    pub(super) free: u32,
    /// `3 #F`, first window that waits to enter the face by each half-edge, in order along it; 0 where there is none.
    pub(super) heads: Vec<u32>,
    /// Half-edges, then vertices that paths can bend at.
    pub(super) queue: Buckets,
    propagated: usize,
    /// Windows that cross now; kept for its memory.
    crossing: Vec<Crossing>,
    /// Those that leave by one half-edge; kept for its memory.
    leaving: Vec<Window>,
}

impl Wavefront {
    /// Starts at sources on the geometry's surface.
    ///
    /// # Errors
    /// Those of [`ToSource::to_source`].
    pub fn new<S: ToSource>(geometry: Arc<ExactGeometry>, sources: &[S]) -> Result<Self> {
        let sources = checked_sources(&geometry.surface, sources)?;
        Ok(Self::of_checked(geometry, sources, &[]))
    }

    /// The same with `targets`: further points of the surface whose distance is wanted.
    ///
    /// # Errors
    /// Those of [`ToSource::to_source`] and [`ToPoint::to_point`].
    pub fn with_targets<S: ToSource, T: ToPoint>(
        geometry: Arc<ExactGeometry>,
        sources: &[S],
        targets: &[T],
    ) -> Result<Self> {
        let sources = checked_sources(&geometry.surface, sources)?;
        let place = |target: &T| Ok(target.to_point(&geometry.surface)?.place());
        let targets = targets.iter().map(place).collect::<Result<Vec<Place>>>()?;
        Ok(Self::of_checked(geometry, sources, &targets))
    }

    pub(crate) fn of_checked(geometry: Arc<ExactGeometry>, sources: Vec<Source>, targets: &[Place]) -> Self {
        let surface = Arc::clone(&geometry.surface);
        let (halfedges, vertices) = (3 * surface.face_count(), surface.vertex_count());
        let base = base(&sources);
        let none = Window::new(0.0, 0.0, [0.0; 2], 0.0, 0);
        let mut wavefront = Self {
            targets: Targets::new(&surface, &geometry, targets),
            sources,
            values: vec![f64::INFINITY; vertices].into(),
            origins: vec![Origin::None; vertices],
            reached: Vec::new(),
            windows: vec![none],
            free: 0,
            heads: vec![0; halfedges],
            queue: Buckets::new(halfedges + vertices, base, BUCKET * surface.mean_edge()),
            propagated: 0,
            crossing: Vec::new(),
            leaving: Vec::new(),
            surface,
            geometry,
        };
        wavefront.start();
        wavefront
    }

    /// Starts anew at other sources, without targets, in the memory held: clears only what has been touched.
    ///
    /// # Errors
    /// Those of [`ToSource::to_source`]; then nothing has changed.
    pub fn restart<S: ToSource>(&mut self, sources: &[S]) -> Result<()> {
        let sources = checked_sources(&self.surface, sources)?;
        self.restart_checked(sources);
        Ok(())
    }

    pub(crate) fn restart_checked(&mut self, sources: Vec<Source>) {
        self.targets = Targets::new(&self.surface, &self.geometry, &[]);
        for vertex in self.reached.drain(..) {
            self.values[vertex] = f64::INFINITY;
            self.origins[vertex.index()] = Origin::None;
        }
        self.windows.truncate(1);
        self.free = 0;
        let heads = &mut self.heads;
        self.queue.clear(base(&sources), |item| {
            // A half-edge where windows wait is in the queue.
            if let Some(head) = heads.get_mut(item as usize) {
                *head = 0;
            }
        });
        self.propagated = 0;
        self.sources = sources;
        self.start();
    }

    /// Grows until every value below `radius` is final, or about `work` windows have crossed a face. Returns whether
    /// the radius was reached.
    pub fn advance(&mut self, radius: f64, work: usize) -> bool {
        let enough = self.propagated.saturating_add(work);
        let halfedges = self.heads.len() as u32;
        let geometry = Arc::clone(&self.geometry);
        while self.propagated < enough {
            match self.queue.pop(radius) {
                None => return true,
                Some(item) if item < halfedges => self.cross(&geometry, item),
                Some(item) => self.bend_at(item - halfedges),
            }
        }
        self.radius() >= radius
    }

    /// The surface that it grows on.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// Every value below this is final; infinity when all is done.
    pub fn radius(&self) -> f64 {
        self.queue.floor()
    }

    /// Whether every value is final.
    pub fn is_done(&self) -> bool {
        self.queue.floor() == f64::INFINITY
    }

    /// `#V`, lengths of paths from the sources, in the file's unit; infinite where none has been found.
    pub fn values(&self) -> &VertexData<f64> {
        &self.values
    }

    /// The vertices with a finite value.
    pub(crate) fn reached(&self) -> &[VertexId] {
        &self.reached
    }

    /// Where it started.
    pub(crate) fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// The least distance that any value can have.
    pub(crate) fn base(&self) -> f64 {
        base(&self.sources)
    }

    /// The number of the source that a root's distance comes from.
    pub(crate) fn source_of(&self, mut root: u32) -> u32 {
        loop {
            if let Some(number) = (root as usize).checked_sub(self.values.len()) {
                return number as u32;
            }
            root = match self.origins[root as usize] {
                Origin::None => return u32::MAX,
                Origin::Straight { root, .. } | Origin::Window { root, .. } => root,
            };
        }
    }

    /// The windows that wait, each with its half-edge; their roots are the numbers of the sources that they come from.
    pub(crate) fn waiting(&self) -> impl Iterator<Item = (u32, Beam)> + '_ {
        let halfedges = self.queue.waiting().filter(|&item| (item as usize) < self.heads.len());
        halfedges.flat_map(move |halfedge| {
            let listed = |number: u32| Some(number).filter(|&number| number != 0);
            let list = std::iter::successors(listed(self.heads[halfedge as usize]), move |&number| {
                listed(self.windows[number as usize].next)
            });
            list.map(move |number| {
                let beam = self.windows[number as usize].beam();
                (halfedge, Beam { root: self.source_of(beam.root), ..beam })
            })
        })
    }

    /// The values, without what else is held.
    pub fn into_values(self) -> VertexData<f64> {
        self.values
    }

    /// Lengths of paths to the targets; infinite where none has been found.
    pub fn target_values(&self) -> &[f64] {
        &self.targets.values
    }

    /// Windows that have crossed a face.
    pub fn windows(&self) -> usize {
        self.propagated
    }

    /// Bytes held for what is still to be done.
    pub fn pending_bytes(&self) -> usize {
        size_of::<Window>() * self.windows.capacity() + 4 * self.heads.len() + self.queue.bytes()
    }

    /// Offers a vertex a shorter path.
    pub(super) fn offer(&mut self, vertex: u32, value: f64, origin: Origin) {
        let before = self.values[VertexId(vertex)];
        if value < before {
            if before == f64::INFINITY {
                self.reached.push(VertexId(vertex));
            }
            self.values[VertexId(vertex)] = value;
            self.origins[vertex as usize] = origin;
            if self.geometry.can_bend(vertex) {
                self.queue.push(self.heads.len() as u32 + vertex, value);
            }
        }
    }

    /// Lets the windows that wait at a half-edge enter its face: values for the opposite corner and for targets in the
    /// face, windows for the half-edges across its two other edges.
    fn cross(&mut self, geometry: &ExactGeometry, halfedge: u32) {
        let (frame, k) = geometry.frame_of(halfedge);
        let [l, r] = [before(k), after(k)];
        let sides = frame.seen_from(k);
        let [a, b, c] = sides.map(|side| side.vertex);
        let opposite = frame.opposite(k);

        let mut crossing = std::mem::take(&mut self.crossing);
        crossing.clear();
        let ends = [self.values[VertexId(a)], self.values[VertexId(b)]];
        let mut next = std::mem::take(&mut self.heads[halfedge as usize]);
        while next != 0 {
            let number = next;
            let mut window = self.windows[number as usize];
            next = window.next;
            self.release(number);
            let is_current = self.values.get(VertexId(window.root)).is_none_or(|&value| value >= window.offset);
            if !(is_current && window.clip(frame[k].length, ends)) {
                continue;
            }
            let entering = Crossing::new(window.beam(), opposite);
            let (splits, distance) = (entering.splits, entering.distance);
            crossing.push(entering);
            let at = smaller(larger(splits, window.begin), window.end);
            if (splits - at).abs() > GRAZE * distance {
                continue;
            }
            let is_straight = at == splits;
            let bent = length(at - window.x, window.depth) + length(opposite[0] - at, opposite[1]);
            let value = window.offset + if is_straight { distance } else { bent };
            if value < self.values[VertexId(c)] {
                let origin = Origin::Window { halfedge, root: window.root, at, x: window.x, depth: window.depth };
                self.offer(c, value, origin);
            }
        }
        self.propagated += crossing.len();
        if self.targets.are_in(halfedge / 3) {
            for crossing in &crossing {
                self.targets.see(frame, halfedge, &crossing.beam);
            }
        }

        let mut leaving = std::mem::take(&mut self.leaving);
        for (out, corners) in [(l, [a, c]), (r, [c, b])] {
            if frame[out].next_on_edge >> 2 == halfedge - k as u32 + out as u32 {
                continue;
            }
            let ends = corners.map(|vertex| self.values[VertexId(vertex)]);
            leaving.clear();
            for crossing in &crossing {
                let part = if out == l { crossing.to_left(sides) } else { crossing.to_right(sides) };
                let Some(mut part) = part.map(Window::from) else { continue };
                if part.clip(frame[out].length, ends) {
                    leaving.push(part);
                }
            }
            self.deliver(geometry, halfedge - k as u32 + out as u32, &leaving);
        }
        self.leaving = leaving;
        self.crossing = crossing;
    }
}

/// Where the queue begins.
fn base(sources: &[Source]) -> f64 {
    sources.iter().map(Source::initial_distance).fold(f64::MAX, f64::min)
}

/// Sources of one surface.
///
/// # Errors
/// Those of [`ToSource::to_source`].
pub(super) fn checked_sources<S: ToSource>(surface: &Surface, sources: &[S]) -> Result<Vec<Source>> {
    sources.iter().map(|source| Ok(source.to_source(surface)?)).collect()
}
