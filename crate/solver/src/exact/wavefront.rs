//! The wavefront: windows that wait at edges, and their way across faces.

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, HalfedgeId, Place, Source, ToPoint, ToSource, VertexData, VertexId};

use crate::extremum::{larger, smaller};
use std::sync::Arc;

use super::crossing::Crossing;
use super::fans::{Fans, Leaving};
use super::geometry::{ExactGeometry, Frame, Side, after, before};
use super::lines::Lines;
use super::list::List;
use super::lists::{HAS_BUNDLES, Lists};
use super::origin::Origin;
use super::points::PointsInFaces;
use super::queue::Buckets;
use super::repeats::Repeats;
use super::targets::Targets;
use super::window::{self, Beam, MARGIN, length};
use crate::error::{Error, Result};
use crate::room;

/// Width of the queue's buckets, in mean edges. The number of windows hardly depends on it below two.
const BUCKET: f64 = 0.7;

/// Windows between two calls of a progress callback, some milliseconds of work.
pub(crate) const WORK_BETWEEN_CALLS: usize = 20_000;

/// Half-edges and vertices whose memory is fetched together.
const BATCH: usize = 16;

/// Exact distances that grow outward from their sources; stopped and continued at will, with the same result.
#[derive(Debug)]
pub struct Wavefront {
    pub(super) surface: Arc<Surface>,
    pub(super) geometry: Arc<ExactGeometry>,
    pub(super) sources: Vec<Source>,
    pub(super) targets: Targets,
    /// The ends of the portals.
    pub(super) ends: Targets,
    /// `#V`.
    pub(super) values: VertexData<f64>,
    /// `#V`.
    pub(super) origins: Vec<Origin>,
    /// Vertices with a finite value.
    pub(super) reached: Vec<VertexId>,
    /// Windows that wait to enter a face by each of its half-edges.
    pub(super) waiting: Lists,
    /// Where it starts from lines, too.
    pub(super) lines: Option<Box<dyn Lines<Self>>>,
    /// Half-edges, then vertices that paths can bend at, then ends of portals.
    pub(super) queue: Buckets,
    repeats: Repeats,
    fans: Fans,
    pub(super) propagated: usize,
    /// Whether there was no memory for something, which is lost.
    pub(super) is_refused: bool,
    /// Items of the queue that are processed now; kept for its memory.
    batch: Vec<u32>,
    /// Windows that cross now; kept for its memory.
    pub(super) crossing: Vec<Beam>,
    /// Those that leave by either half-edge; kept for its memory.
    leaving: [Vec<Beam>; 2],
}

impl Wavefront {
    /// Starts at sources on the geometry's surface.
    ///
    /// # Errors
    /// Those of [`ToSource::to_source`]; [`Error::OutOfMemory`].
    pub fn new<S: ToSource>(geometry: Arc<ExactGeometry>, sources: &[S]) -> Result<Self> {
        let sources = checked_sources(&geometry.surface, sources)?;
        require_one_cost(&geometry)?;
        Self::of_checked(geometry, sources, &[])
    }

    /// The same with `targets`: further points of the surface whose distance is wanted.
    ///
    /// # Errors
    /// Those of [`ToSource::to_source`] and [`ToPoint::to_point`]; [`Error::OutOfMemory`].
    pub fn with_targets<S: ToSource, T: ToPoint>(
        geometry: Arc<ExactGeometry>,
        sources: &[S],
        targets: &[T],
    ) -> Result<Self> {
        let sources = checked_sources(&geometry.surface, sources)?;
        require_one_cost(&geometry)?;
        let place = |target: &T| Ok(target.to_point(&geometry.surface)?.place());
        let targets = targets.iter().map(place).collect::<Result<Vec<Place>>>()?;
        Self::of_checked(geometry, sources, &targets)
    }

    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(crate) fn of_checked(geometry: Arc<ExactGeometry>, sources: Vec<Source>, targets: &[Place]) -> Result<Self> {
        let surface = Arc::clone(&geometry.surface);
        let (halfedges, vertices) = (3 * surface.face_count(), surface.vertex_count());
        let base = base(&sources);
        let portals = geometry.portals();
        let ends = Targets::new(portals.places(), Arc::clone(portals.in_faces()));
        let items = halfedges + vertices + portals.places().len();
        let bytes = (size_of::<f64>() + size_of::<Origin>()) * vertices + size_of::<u32>() * (halfedges + items);
        if !heatwalk_base::memory::has_room(&[bytes as u64]) {
            return Err(room::REFUSED);
        }
        let mut wavefront = Self {
            targets: targets_at(&geometry, targets),
            ends,
            sources,
            values: vec![f64::INFINITY; vertices].into(),
            origins: vec![Origin::None; vertices],
            reached: Vec::new(),
            waiting: Lists::new(halfedges),
            lines: None,
            queue: Buckets::new(items, base, BUCKET * geometry.mean_edge()),
            repeats: Repeats::new(halfedges),
            fans: Fans::default(),
            propagated: 0,
            is_refused: false,
            batch: Vec::new(),
            crossing: Vec::new(),
            leaving: Default::default(),
            surface,
            geometry,
        };
        wavefront.start();
        Ok(wavefront)
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
        self.restart_to(sources, &[]);
    }

    /// The same with targets.
    pub(crate) fn restart_to(&mut self, sources: Vec<Source>, targets: &[Place]) {
        self.targets = targets_at(&self.geometry, targets);
        self.ends.clear();
        self.lines = None;
        if self.is_refused() {
            // What has been touched is not known.
            self.values.as_mut_slice().fill(f64::INFINITY);
            self.origins.fill(Origin::None);
            self.waiting.clear_all();
            self.is_refused = false;
        }
        for vertex in self.reached.drain(..) {
            self.values[vertex] = f64::INFINITY;
            self.origins[vertex.index()] = Origin::None;
        }
        let waiting = &mut self.waiting;
        self.queue.clear(base(&sources), |item| {
            // A half-edge where windows wait is in the queue.
            if (item as usize) < waiting.len() {
                waiting.clear(item);
            }
        });
        self.repeats.clear();
        self.fans.clear();
        self.propagated = 0;
        self.sources = sources;
        self.start();
    }

    /// Grows until every value below `radius` is final, or about `work` windows have crossed a face. Returns whether
    /// the radius was reached.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`]; then values are still lengths of paths, but none is final, and it does not grow until it is
    /// [restarted](Self::restart).
    pub fn advance(&mut self, radius: f64, work: usize) -> Result<bool> {
        let enough = self.propagated.saturating_add(work);
        let [halfedges, vertices] = [self.waiting.len(), self.values.len()].map(|count| count as u32);
        let geometry = Arc::clone(&self.geometry);
        let mut batch = std::mem::take(&mut self.batch);
        while self.propagated < enough && !self.is_refused() {
            if self.queue.is_between_buckets() {
                self.deliver_gathered(&geometry);
            }
            self.queue.pop_some(radius, BATCH, &mut batch);
            if batch.is_empty() {
                if self.relax(radius) {
                    continue;
                }
                break;
            }
            self.fetch(&geometry, &batch);
            for &item in &batch {
                match item.checked_sub(halfedges) {
                    None => {
                        if self.lines.is_some() {
                            self.cross_strips(&geometry, item);
                        }
                        self.cross(&geometry, item);
                    }
                    Some(other) => match other.checked_sub(vertices) {
                        None => self.bend_at(other),
                        Some(end) => self.emerge(&geometry, end),
                    },
                }
            }
        }
        self.deliver_gathered(&geometry);
        self.batch = batch;
        if self.is_refused() { Err(room::REFUSED) } else { Ok(self.radius() >= radius) }
    }

    /// Grows until every value below `radius` is final; with infinity, until all are.
    ///
    /// # Errors
    /// As [`Self::advance`]; [`Error::Cancelled`].
    pub fn grow(&mut self, radius: f64, progress: Progress<'_>) -> Result<()> {
        while !self.advance(radius, WORK_BETWEEN_CALLS)? {
            report(progress, Stage::Searching { radius: self.radius() }, 0.0)?;
        }
        Ok(())
    }

    fn is_refused(&self) -> bool {
        self.is_refused | self.waiting.is_refused() | self.queue.is_refused()
    }

    /// Reads what a batch will need, so that the processor waits for all of it at once instead of for one after another.
    fn fetch(&self, geometry: &ExactGeometry, batch: &[u32]) {
        let mut sum = 0.0;
        for &halfedge in batch.iter().filter(|&&item| (item as usize) < self.waiting.len()) {
            let (frame, k) = geometry.frame_of(halfedge);
            sum += self.waiting.at(halfedge).first().map_or(0.0, |window| window.begin);
            sum += self.values[VertexId(frame[before(k)].vertex)];
            for out in [after(k), before(k)] {
                let across = frame[out].next_on_edge >> 2;
                sum += f64::from(u8::from(self.queue.holds(across)));
                sum += self.waiting.at(across).first().map_or(0.0, |window| window.begin);
            }
        }
        std::hint::black_box(sum);
    }

    /// The surface that it grows on.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// The unfolded triangles that it crosses.
    pub(crate) fn geometry(&self) -> &Arc<ExactGeometry> {
        &self.geometry
    }

    /// Every value below this is final; infinity when all is done.
    pub fn radius(&self) -> f64 {
        if self.is_refused() { f64::NEG_INFINITY } else { self.queue.floor() }
    }

    /// Whether every value is final.
    pub fn is_done(&self) -> bool {
        self.radius() == f64::INFINITY
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

    /// Distances at the ends of the portals; infinite where none has been found.
    pub(crate) fn end_values(&self) -> &[f64] {
        &self.ends.values
    }

    /// The distance at an end of a portal that the shortest path reaches through it.
    pub(crate) fn entered(&self, end: u32) -> Option<f64> {
        let Targets { values, origins, .. } = &self.ends;
        (origins[end as usize] == Origin::Portal).then(|| values[end as usize])
    }

    /// Windows are cut where they are farther than by way of a vertex at this distance: its own, and what rounding may add.
    pub(super) fn limit(&self, vertex: u32) -> f64 {
        let value = self.values[VertexId(vertex)];
        value + (MARGIN * value.abs() + self.geometry.grain)
    }

    /// The half-edges where windows wait.
    pub(crate) fn lit(&self) -> impl Iterator<Item = u32> + '_ {
        self.queue.waiting().filter(|&item| (item as usize) < self.waiting.len())
    }

    /// Each of the windows that wait, with its half-edge; their roots are the numbers of the sources that they come from.
    pub(crate) fn for_each_waiting(&self, tell: &mut dyn FnMut(u32, Beam)) {
        for halfedge in self.lit() {
            let from_source = |beam: Beam| Beam { root: self.source_of(beam.root), ..beam };
            self.waiting.for_each_at(halfedge, |beam| tell(halfedge, from_source(beam)));
        }
    }

    /// The values, without what else is held.
    pub fn into_values(self) -> VertexData<f64> {
        self.values
    }

    /// Lengths of paths to the targets; infinite where none has been found.
    pub fn target_values(&self) -> &[f64] {
        &self.targets.values
    }

    /// Windows that have crossed a face, those of a bundle once for all the faces that it crosses: as many as take time.
    pub fn windows(&self) -> usize {
        self.propagated
    }

    /// Bytes held for what is still to be done.
    pub fn pending_bytes(&self) -> usize {
        self.waiting.bytes() + self.queue.bytes()
    }

    /// Offers a vertex a shorter path.
    pub(super) fn offer(&mut self, vertex: u32, value: f64, origin: Origin) {
        let before = self.values[VertexId(vertex)];
        if value < before {
            if before == f64::INFINITY {
                self.is_refused |= !room::push(&mut self.reached, VertexId(vertex));
            }
            self.values[VertexId(vertex)] = value;
            self.origins[vertex as usize] = origin;
            if self.geometry.can_bend(vertex) {
                self.queue.push(self.waiting.len() as u32 + vertex, value);
            }
        }
    }

    /// Lets what lines send to a half-edge enter its face.
    #[cold]
    fn cross_strips(&mut self, geometry: &ExactGeometry, halfedge: u32) {
        if let Some(mut lines) = self.lines.take() {
            lines.cross(self, geometry, halfedge);
            self.lines = Some(lines);
        }
    }

    /// Lets the windows that wait at a half-edge enter its face: values for the opposite corner and for targets in the
    /// face, windows for the half-edges across its two other edges.
    fn cross(&mut self, geometry: &ExactGeometry, halfedge: u32) {
        let (frame, k) = geometry.frame_of(halfedge);
        let sides = frame.seen_from(k);
        let [a, b, _] = sides.map(|side| side.vertex);
        let remembers = self.repeats.remembers(halfedge);

        let mut windows = std::mem::take(&mut self.crossing);
        let bundles = self.waiting.take(halfedge, &mut windows);
        if HAS_BUNDLES && (windows.len() >= self.waiting.many || !bundles.is_empty()) {
            let mut list = List::new(windows, bundles);
            if !remembers {
                return self.cross_in_bundles(geometry, halfedge, list);
            }
            list.open();
            self.is_refused |= list.is_refused;
            windows = list.windows;
        }
        windows.retain(|window| self.is_current(window));
        window::clip(&mut windows, sides[0].length, [a, b].map(|vertex| self.limit(vertex)));
        if remembers {
            self.repeats.leave_nearer(halfedge, &mut windows, self.waiting.envelope(), geometry.grain);
        }
        self.propagated += windows.len();
        if self.targets.are_in(halfedge / 3) || self.ends.are_in(halfedge / 3) {
            self.see(frame, halfedge, &windows);
        }

        let [mut to_left, mut to_right] = std::mem::take(&mut self.leaving);
        if to_left.try_reserve(windows.len()).is_err() || to_right.try_reserve(windows.len()).is_err() {
            self.is_refused = true;
            return;
        }
        let grain = geometry.grain;
        for window in &windows {
            let wider;
            let window = if window.depth > grain {
                window
            } else {
                wider = window.wider(grain, sides[0].length);
                &wider
            };
            let [left, right] = self.pass(halfedge, sides, window, grain);
            if let Some(beam) = left {
                to_left.push(beam);
            }
            if let Some(beam) = right {
                to_right.push(beam);
            }
        }
        windows.clear();
        self.crossing = windows;
        let first = halfedge - k as u32;
        self.deliver(geometry, first + before(k) as u32, &mut to_left);
        self.deliver(geometry, first + after(k) as u32, &mut to_right);
        self.leaving = [to_left, to_right];
    }

    /// Lets a window cross a face: a value for the opposite corner, and what leaves by the edges at the half-edge's begin and end.
    #[inline(always)]
    pub(super) fn pass(&mut self, halfedge: u32, sides: [&Side; 3], window: &Beam, grain: f64) -> [Option<Beam>; 2] {
        let [base, _, left] = sides;
        let opposite = [left.length * base.cos, left.length * base.sin];
        let crossing = Crossing::new(*window, opposite);
        if crossing.sees_corner(grain) {
            self.reach(halfedge, left.vertex, opposite, &crossing);
        }
        [crossing.to_left(sides), crossing.to_right(sides)].map(|beam| beam.filter(Beam::is_wide))
    }

    /// Whether a window starts from the distance that its root has now.
    #[inline(always)]
    pub(super) fn is_current(&self, window: &Beam) -> bool {
        let at_root = self.values.get(VertexId(window.root)).copied();
        window.is_current(at_root.unwrap_or_else(|| self.value_of_root(window.root)), self.geometry.grain)
    }

    /// Offers the targets and the ends of portals in a half-edge's face what they are `seen` by there, as it is laid out by the half-edge.
    pub(super) fn see_points(
        &mut self,
        frame: &Frame,
        halfedge: u32,
        seen: impl Fn([f64; 2]) -> Option<(f64, Origin)>,
    ) {
        let (queue, first) = (&mut self.queue, (self.waiting.len() + self.values.len()) as u32);
        self.targets.see_by(frame, halfedge, &seen, |_, _| ());
        self.ends.see_by(frame, halfedge, &seen, |end, value| queue.push(first + end, value));
    }

    /// Offers the targets and the ends of portals in a half-edge's face the windows that enter there.
    #[cold]
    pub(super) fn see(&mut self, frame: &Frame, halfedge: u32, windows: &[Beam]) {
        let (queue, first) = (&mut self.queue, (self.waiting.len() + self.values.len()) as u32);
        for window in windows.iter().map(|window| (window, self.geometry.grain)) {
            self.targets.see(frame, halfedge, window, |_, _| ());
            self.ends.see(frame, halfedge, window, |end, value| queue.push(first + end, value));
        }
    }

    /// Offers the corner opposite a half-edge the path through a window that enters there and sees it.
    #[inline(always)]
    fn reach(&mut self, halfedge: u32, corner: u32, opposite: [f64; 2], crossing: &Crossing) {
        let window = &crossing.beam;
        let at = smaller(larger(crossing.splits(), window.begin), window.end);
        let value = window.at(at) + length(opposite[0] - at, opposite[1]);
        if value < self.values[VertexId(corner)] {
            let origin = Origin::Window { halfedge, root: window.root, at, x: window.x, depth: window.depth };
            self.offer(corner, value, origin);
        }
    }

    /// Brings windows that leave a face by a half-edge, in order along that edge against the half-edge's direction, to the
    /// half-edges on the other faces of the edge. None is left in `windows`.
    pub(super) fn deliver(&mut self, geometry: &ExactGeometry, halfedge: u32, windows: &mut Vec<Beam>) {
        let Some(nearest) = window::nearest(windows) else { return };
        let (frame, k) = geometry.frame_of(halfedge);
        if let Some(twin) = frame[k].twin() {
            self.waiting.add(twin, windows);
            self.queue.push(twin, nearest);
        } else {
            self.deliver_to_fan(geometry, halfedge, windows, nearest);
        }
        windows.clear();
    }

    /// The same for an edge that is not between two faces of one orientation. Windows may be gathered.
    #[cold]
    fn deliver_to_fan(&mut self, geometry: &ExactGeometry, halfedge: u32, windows: &mut Vec<Beam>, nearest: f64) {
        let edges = self.surface.edges();
        if edges.is_branching(HalfedgeId(halfedge)) && self.fans.gathers(edges, halfedge) {
            self.is_refused |= !self.fans.gather(nearest, halfedge, windows);
        } else {
            self.deliver_to_all(geometry, halfedge, windows, nearest);
        }
    }

    /// Delivers what has been gathered at edges of many faces.
    pub(super) fn deliver_gathered(&mut self, geometry: &ExactGeometry) {
        if !self.fans.are_gathered() {
            return;
        }
        for mut leaving in self.fans.take() {
            self.fans.leave_nearer(geometry, &mut leaving, self.waiting.envelope());
            let Leaving { halfedge, windows, .. } = leaving;
            if let Some(nearest) = window::nearest(&windows) {
                self.deliver_to_all(geometry, halfedge, &windows, nearest);
            }
        }
    }

    /// Brings windows to each of the half-edges on the other faces of an edge.
    fn deliver_to_all(&mut self, geometry: &ExactGeometry, halfedge: u32, windows: &[Beam], nearest: f64) {
        let (frame, k) = geometry.frame_of(halfedge);
        for (target, is_mirrored) in geometry.across(halfedge) {
            let mut copy = Vec::new();
            if copy.try_reserve_exact(windows.len()).is_err() {
                self.is_refused = true;
                return;
            }
            if is_mirrored {
                copy.extend(windows.iter().rev().map(|window| window.mirrored(frame[k].length)));
            } else {
                copy.extend_from_slice(windows);
            }
            self.waiting.add(target, &mut copy);
            self.queue.push(target, nearest);
        }
    }
}

fn targets_at(geometry: &ExactGeometry, places: &[Place]) -> Targets {
    let in_faces = PointsInFaces::new(places, |place| geometry.faces_at(geometry.surface(), place));
    Targets::new(places, Arc::new(in_faces))
}

/// Where the queue begins.
fn base(sources: &[Source]) -> f64 {
    sources.iter().map(Source::initial_distance).fold(f64::MAX, f64::min)
}

/// Refuses exact distances where no search finds them.
pub(super) fn require_one_cost(geometry: &ExactGeometry) -> Result<()> {
    if geometry.costs().is_some() { Err(Error::NotExact) } else { Ok(()) }
}

/// Sources of one surface.
///
/// # Errors
/// Those of [`ToSource::to_source`].
pub(crate) fn checked_sources<S: ToSource>(surface: &Surface, sources: &[S]) -> Result<Vec<Source>> {
    sources.iter().map(|source| Ok(source.to_source(surface)?)).collect()
}
