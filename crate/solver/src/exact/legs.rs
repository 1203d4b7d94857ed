//! The last legs of shortest paths: their straight part from a source, or from where they bend last, to a vertex, with the directions
//! in which it leaves and arrives.
//!
//! Unfolding keeps angles, so that a line that is followed back through the faces that it crosses tells the direction in which it left.
//! Lines from one root through the same faces unfold it to one place; what one of them has found each half-edge remembers for the next.

use heatwalk_sparse::c64;
use heatwalk_surface::{Element, Place, VertexId};

use super::geometry::{ExactGeometry, Frame, after};
use super::goal::Goal;
use super::origin::Origin;
use super::portals::Portals;
use super::ray::{Found, Ray};
use super::roots::Root;
use super::wavefront::Wavefront;
use crate::error::Result;
use crate::room;

/// Two lines at a half-edge come through the same faces where their root unfolds to one place within this share of its distance: rounding
/// of some thousand faces stays below. Had they passed a vertex on different sides, the root would come to lie apart by its curvature, times
/// the vertex's distance from the root.
const SAME_STRIP: f64 = 1e-12;

/// One of so many half-edges remembers: lines cross some dozens, and what they remember takes longer to fetch than a face to cross.
const REMEMBERS: u32 = 4;

/// A direction in a face, of any length, as a complex number: the half-edge `side` of the face has the direction 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Heading {
    pub side: u32,
    pub direction: c64,
}

/// The straight end of a shortest path.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leg {
    pub root: Root,
    /// Away from the root: at a vertex from the side that leaves it, at other places from the first side of the face.
    pub departure: Heading,
    /// Back to where the path comes from, likewise.
    pub arrival: Heading,
    /// Whether what is on the left at one end is on the right at the other, as on a Möbius strip.
    pub is_mirrored: bool,
}

/// What the plane does from one half-edge's frame to another's: it is mirrored, perhaps, and turned.
#[derive(Debug, Clone, Copy)]
struct Turned {
    by: c64,
    is_mirrored: bool,
}

impl Turned {
    const NOT: Self = Self { by: c64::new(1.0, 0.0), is_mirrored: false };

    #[inline(always)]
    fn apply(&self, direction: c64) -> c64 {
        self.by * if self.is_mirrored { direction.conj() } else { direction }
    }

    #[inline(always)]
    fn then(&self, next: &Self) -> Self {
        Self { by: next.apply(self.by), is_mirrored: self.is_mirrored != next.is_mirrored }
    }
}

/// A direction that is seen from half-edge `from` of a face, as half-edge `to` sees it.
#[inline(always)]
fn from_side(frame: &Frame, (from, to): (usize, usize), direction: c64) -> c64 {
    if to == from {
        direction
    } else if to == after(from) {
        -direction * c64::new(frame[to].cos, frame[to].sin)
    } else {
        -direction * c64::new(frame[from].cos, -frame[from].sin)
    }
}

/// How a root is seen through faces that have been followed back.
#[derive(Debug, Clone, Copy)]
struct Strip {
    root: u32,
    /// What [`Heading`]s at the root are measured from.
    side: u32,
    /// Where the root unfolds to.
    x: f64,
    depth: f64,
    /// From the half-edge to that side.
    turned: Turned,
}

const UNKNOWN: Strip = Strip { root: u32::MAX, side: 0, x: 0.0, depth: 0.0, turned: Turned::NOT };

/// Where a line back ends.
enum End {
    /// At its root.
    Root { side: u32, turned: Turned },
    /// At a vertex on it, in the face of a half-edge.
    Vertex { vertex: VertexId, halfedge: u32, turned: Turned },
}

/// What a step into a face finds, as [`Found`].
enum Entered {
    Arrived { side: u32, turned: Turned },
    Leaves(Step),
    Lost,
}

/// Where the line that is followed leaves a face.
#[derive(Debug, Clone, Copy)]
struct Step {
    ray: Ray,
    /// From the half-edge where the line began.
    turned: Turned,
}

/// Finds legs.
pub(crate) struct Legs<'a> {
    front: &'a Wavefront,
    /// What was last found of each half-edge that [remembers](REMEMBERS).
    strips: Vec<Strip>,
    /// Those of these half-edges that the line has passed; kept for its memory.
    steps: Vec<Step>,
    /// Half-edges to enter faces by that are still to try, each with the step before and so many that are remembered; kept for its memory.
    open: Vec<(Step, (u32, bool), usize)>,
}

impl Wavefront {
    /// Tells the leg of each vertex that has a distance, and of each end of a portal (`#V` + its number); first those of the places where
    /// others [begin](Self::start_of_leg). Those that are not below a distance are left out; the others must be final.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(crate) fn for_each_leg(&self, below: f64, mut tell: impl FnMut(usize, &Leg)) -> Result<()> {
        let mut legs = Legs::new(self)?;
        let mut is_told = vec![false; self.values.len() + self.ends.values.len()];
        let mut open = Vec::new();
        for stop in (0..is_told.len()).filter(|&stop| self.stop(stop).1 < below) {
            open.push(stop);
            while let Some(&stop) = open.last() {
                let leg = if is_told[stop] { None } else { legs.of(stop) };
                match leg.and_then(|leg| self.start_of_leg(&leg)) {
                    // Distances fall from one to the next.
                    Some(start) if !is_told[start] => open.push(start),
                    _ => {
                        leg.iter().for_each(|leg| tell(stop, leg));
                        is_told[stop] = true;
                        open.pop();
                    }
                }
            }
        }
        Ok(())
    }

    /// The vertex, or the end of a portal (`#V` + its number), where a leg begins or its portal does; none at a source.
    pub(crate) fn start_of_leg(&self, leg: &Leg) -> Option<usize> {
        self.stop_of_root(leg.root)
    }

    /// The vertex, or the end of a portal (`#V` + its number), that a root is or is reached from; none at a source.
    pub(crate) fn stop_of_root(&self, root: Root) -> Option<usize> {
        match root {
            Root::Source(_) | Root::Side(_) => None,
            Root::Vertex(vertex) => Some(vertex.index()),
            Root::End(end) => Some(self.values.len() + Portals::across(end) as usize),
        }
    }

    /// What the distance of a vertex, of the end of a portal (`#V` + its number), or of a target (after these) starts from.
    pub(crate) fn root_of_stop(&self, stop: usize) -> Option<Root> {
        match self.stop(stop).2 {
            Origin::None | Origin::Portal => None,
            Origin::Straight { root, .. } | Origin::Window { root, .. } => Some(self.root(root)),
        }
    }

    /// Where that is, its distance, and where this comes from.
    fn stop(&self, stop: usize) -> (Place, f64, Origin) {
        let Some(other) = stop.checked_sub(self.values.len()) else {
            return (Place::Vertex(VertexId::from_index(stop)), self.values.as_slice()[stop], self.origins[stop]);
        };
        let (points, number) = match other.checked_sub(self.ends.values.len()) {
            None => (&self.ends, other),
            Some(target) => (&self.targets, target),
        };
        (self.geometry.settled(points.locations[number]), points.values[number], points.origins[number])
    }
}

impl Heading {
    /// At a [settled](super::ExactGeometry::settled) place of a face, straight to another one there.
    pub(crate) fn towards(geometry: &ExactGeometry, face: u32, [from, to]: [Place; 2]) -> Option<Self> {
        let frame = geometry.frame(face);
        let [from_weights, to] = [geometry.weights_at(from, face)?, geometry.weights_at(to, face)?];
        let [from_x, from_y] = frame.place(0, from_weights);
        let [to_x, to_y] = frame.place(0, to);
        let side = match from {
            Place::Vertex(vertex) => frame.corner(vertex.0).unwrap_or(0),
            _ => 0,
        };
        let direction = from_side(frame, (0, side), c64::new(to_x - from_x, to_y - from_y));
        Some(Self { side: 3 * face + side as u32, direction })
    }
}

impl<'a> Legs<'a> {
    /// Of a search that is done.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn new(front: &'a Wavefront) -> Result<Self> {
        let (mut strips, count) = (Vec::new(), (3 * front.surface.face_count()).div_ceil(REMEMBERS as usize));
        strips.try_reserve_exact(count).map_err(|_| room::REFUSED)?;
        strips.resize(count, UNKNOWN);
        Ok(Self { front, strips, steps: Vec::new(), open: Vec::new() })
    }

    /// That of a vertex, the end of a portal or a target, by [its number](Wavefront::root_of_stop); none where it has no distance.
    pub fn of(&mut self, stop: usize) -> Option<Leg> {
        let front = self.front;
        let (place, value, origin) = front.stop(stop);
        match origin {
            Origin::None | Origin::Portal => None,
            Origin::Straight { face, root } => self.straight(place, face, root),
            Origin::Window { halfedge, root, at, x, depth } => {
                let ray = Ray { halfedge, at, x, depth };
                self.through((place, value), root, ray).or_else(|| self.by_corner(place, value))
            }
        }
    }

    /// Within one face.
    fn straight(&self, place: Place, face: u32, root: u32) -> Option<Leg> {
        let front = self.front;
        let frame = front.geometry.frame(face);
        let from = front.goal(root);
        let [to_x, to_y] = frame.place(0, front.geometry.weights_at(place, face)?);
        let [from_x, from_y] = frame.place(0, front.weights_of_goal(from, 3 * face, [to_x, to_y])?);
        let direction = c64::new(to_x - from_x, to_y - from_y);
        let heading = |place: Goal, direction: c64| {
            let side = self.side_at(place, face);
            Heading { side: 3 * face + side as u32, direction: from_side(frame, (0, side), direction) }
        };
        Some(Leg {
            root: front.root(root),
            departure: heading(from, direction),
            arrival: heading(Goal::Place(place), -direction),
            is_mirrored: false,
        })
    }

    /// Through a window's half-edge into the face where the place is; none where rounding has lost the line.
    fn through(&mut self, (place, value): (Place, f64), root: u32, ray: Ray) -> Option<Leg> {
        let front = self.front;
        let (frame, k) = front.geometry.frame_of(ray.halfedge);
        let face = ray.halfedge / 3;
        let [x, y] = frame.place(k, front.geometry.weights_at(place, face)?);
        let direction = c64::new(x - ray.x, y + ray.depth);
        let side = self.side_at(Goal::Place(place), face);
        let arrival = Heading { side: 3 * face + side as u32, direction: from_side(frame, (k, side), -direction) };
        let (root, side, turned) = match self.follow(ray, root, value)? {
            End::Root { side, turned } => (front.root(root), side, turned),
            End::Vertex { vertex, halfedge, turned } => {
                let (frame, k) = front.geometry.frame_of(halfedge);
                let side = if frame[k].vertex == vertex.0 { k } else { after(k) };
                let turn = Turned { by: from_side(frame, (k, side), c64::new(1.0, 0.0)), is_mirrored: false };
                (Root::Vertex(vertex), halfedge - k as u32 + side as u32, turned.then(&turn))
            }
        };
        let departure = Heading { side, direction: turned.apply(direction) };
        Some(Leg { root, departure, arrival, is_mirrored: turned.is_mirrored })
    }

    /// From the corner of a face here by which the distance is least: where rounding has lost the line, it passes that by about as little.
    fn by_corner(&self, place: Place, value: f64) -> Option<Leg> {
        let front = self.front;
        let (face, corner) = front.nearer_corner(place, value)?;
        self.straight(place, face, corner)
    }

    /// The corner of a face that a settled place is at, or the first.
    fn side_at(&self, place: Goal, face: u32) -> usize {
        match place {
            Goal::Place(Place::Vertex(vertex)) => self.front.geometry.frame(face).corner(vertex.0).unwrap_or(0),
            _ => 0,
        }
    }

    /// Follows a line to its root, or to a vertex on it that is nearer than `value`; none where it is lost.
    fn follow(&mut self, first: Ray, root: u32, value: f64) -> Option<End> {
        let front = self.front;
        let source = front.goal(root);
        let near = first.near(front.geometry.grain);
        self.steps.clear();
        self.open.clear();
        let mut here = Step { ray: first, turned: Turned::NOT };
        let mut steps_left = 8 * front.geometry.frames.len() + 64;
        loop {
            if let Some(vertex) = front.passes(value, root, &here.ray) {
                let (vertex, halfedge) = (VertexId(vertex), here.ray.halfedge);
                return Some(End::Vertex { vertex, halfedge, turned: here.turned });
            }
            if here.ray.halfedge.is_multiple_of(REMEMBERS) {
                if let Some(&Strip { side, turned, .. }) = self.known(root, &here.ray) {
                    return Some(self.arrived(root, side, here.turned.then(&turned)));
                }
                self.steps.push(here);
            }
            steps_left = steps_left.checked_sub(1)?;
            let (frame, k) = front.geometry.frame_of(here.ray.halfedge);
            let mut entered = match frame[k].twin() {
                Some(twin) => self.enter(here, (twin, false), (source, near)),
                None => {
                    let across = front.geometry.across(here.ray.halfedge);
                    self.open.extend(across.map(|across| (here, across, self.steps.len())));
                    Entered::Lost
                }
            };
            while matches!(entered, Entered::Lost) {
                let (from, across, count) = self.open.pop()?;
                self.steps.truncate(count);
                entered = self.enter(from, across, (source, near));
            }
            match entered {
                Entered::Leaves(step) => here = step,
                Entered::Arrived { side, turned } => return Some(self.arrived(root, side, turned)),
                Entered::Lost => return None,
            }
        }
    }

    /// Takes a line across an edge, as [`Wavefront::step`].
    #[inline(always)]
    fn enter(&self, from: Step, (halfedge, is_mirrored): (u32, bool), goal: (Goal, f64)) -> Entered {
        match self.front.step(from.ray, (halfedge, is_mirrored), goal) {
            Found::Lost => Entered::Lost,
            Found::Leaves(ray, by) => {
                let by = if is_mirrored { -by } else { by };
                Entered::Leaves(Step { ray, turned: from.turned.then(&Turned { by, is_mirrored }) })
            }
            Found::Arrived(_) => {
                let (frame, k) = self.front.geometry.frame_of(halfedge);
                let side = self.side_at(goal.0, halfedge / 3);
                // The half-edge across runs the other way, unless the face is mirrored.
                let along = c64::new(if is_mirrored { 1.0 } else { -1.0 }, 0.0);
                let turned = from.turned.then(&Turned { by: from_side(frame, (k, side), along), is_mirrored });
                Entered::Arrived { side: halfedge - k as u32 + side as u32, turned }
            }
        }
    }

    /// What is known of the faces that a line comes through.
    fn known(&self, root: u32, ray: &Ray) -> Option<&Strip> {
        let strip = &self.strips[(ray.halfedge / REMEMBERS) as usize];
        let close = SAME_STRIP * ((ray.x - ray.at).abs() + ray.depth);
        let is_same = strip.root == root && (strip.x - ray.x).abs() + (strip.depth - ray.depth).abs() <= close;
        is_same.then_some(strip)
    }

    /// Lets half-edges remember the line that has been followed to its root: to a side there, turned so since it began.
    fn arrived(&mut self, root: u32, side: u32, turned: Turned) -> End {
        for Step { ray, turned: here } in &self.steps {
            // Undone, what turned the plane until here leaves what turns it from here.
            let by =
                if here.is_mirrored == turned.is_mirrored { here.by.conj() * turned.by } else { here.by * turned.by };
            let turned = Turned { by, is_mirrored: here.is_mirrored != turned.is_mirrored };
            self.strips[(ray.halfedge / REMEMBERS) as usize] = Strip { root, side, x: ray.x, depth: ray.depth, turned };
        }
        End::Root { side, turned }
    }
}
