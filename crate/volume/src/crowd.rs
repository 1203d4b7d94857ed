//! A crowd of walkers inside of a mesh, each along its shortest path to the nearest source.
//!
//! A path is found where a walker needs one: where it starts, and where it stands when the distance changes. That takes longer than
//! a step, so a few are found in each step, and the other walkers wait for theirs where they are.

use std::borrow::Cow;
use std::sync::Arc;

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use crate::distance::VolumeDistance;
use crate::error::{Error, Result};
use crate::measured::Measured;
use crate::mesh::{TetId, TetMesh, six_volumes};
use crate::path::VolumePath;
use crate::point::TetPoint;
use crate::solver::VolumeSolver;

/// Paths that are found in one step, at most: a frame has time for some.
const PATHS_A_STEP: usize = 8;

/// Up and heading are taken to be parallel where the sine of the angle between them is below this: what is left of up would be
/// mostly rounding of a path's points.
const PARALLEL: f64 = 1e-6;

/// Legs that are shorter than this share of their path have no direction: where a path bends just beside its start, that is rounding.
const SHORT: f64 = 1e-9;

/// Where a walker is, and how it stands there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumePose {
    /// In the file's unit.
    pub position: DVec3,
    /// Unit vector at right angles to `heading`, as near to the axis asked for as can be.
    pub up: DVec3,
    /// Unit vector along the path.
    pub heading: DVec3,
    /// Length walked since it started, in the file's unit.
    pub arc: f64,
}

/// Someone on the way to a source.
#[derive(Debug, Clone)]
struct Walker {
    position: DVec3,
    heading: DVec3,
    arc: f64,
    /// None while it waits for one.
    path: Option<Walk>,
}

/// A path in the course of being walked.
#[derive(Debug, Clone)]
struct Walk {
    path: VolumePath,
    /// The point of the path that comes next.
    next: usize,
}

/// What there is to follow.
#[derive(Debug, Clone)]
struct Goal {
    measured: Measured,
    /// As it is measured there.
    distance: VolumeDistance,
    /// `#T`, volume of the tetrahedra up to and with each that a source can be reached from; made when someone starts.
    volumes: Option<Vec<f64>>,
}

/// Walkers inside of a mesh. Where one arrives it starts again elsewhere.
///
/// ```
/// use std::sync::Arc;
/// use glam::DVec3;
/// use heatwalk::VertexId;
/// use heatwalk_volume::{TetMesh, VolumeCrowd, VolumeOptions, VolumeSolver, shapes};
///
/// # fn main() -> heatwalk_volume::Result<()> {
/// let mut solver = VolumeSolver::new(TetMesh::build(&shapes::cube(4, 0.2))?);
/// let mut crowd = VolumeCrowd::new(Arc::clone(solver.mesh()), 3, 7);
/// let distance = solver.distance(&[VertexId(0)], &VolumeOptions::default())?;
/// crowd.follow(&solver, distance)?;
/// crowd.advance(0.1)?;
/// for pose in crowd.poses(DVec3::Y) {
///     assert!(pose.heading.dot(pose.up).abs() < 1e-12 && pose.arc <= 0.1 + 1e-12);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct VolumeCrowd {
    mesh: Arc<TetMesh>,
    count: usize,
    walkers: Vec<Walker>,
    goal: Option<Goal>,
    /// The walker that is first asked whether it needs a path, so that each has its turn.
    turn: usize,
    random: SplitMix64,
}

impl VolumeCrowd {
    /// A crowd of `count` walkers. With the same `seed` they start at the same places.
    pub fn new(mesh: impl Into<Arc<TetMesh>>, count: usize, seed: u64) -> Self {
        Self {
            mesh: mesh.into(),
            count,
            walkers: Vec::new(),
            goal: None,
            turn: 0,
            random: SplitMix64::seed_from_u64(seed),
        }
    }

    /// Changes the number of walkers. The first ones go on; more come with the next [`advance`](Self::advance).
    pub fn set_count(&mut self, count: usize) {
        self.count = count;
        self.walkers.truncate(count);
    }

    /// How many walkers there are to be. Fewer are out before the first [`advance`](Self::advance), and where no tetrahedron has a path
    /// to a source from everywhere in it.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Sends the walkers down a distance of this solver, from where they are.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`] for a solver or a distance of another mesh.
    pub fn follow(&mut self, solver: &VolumeSolver, distance: VolumeDistance) -> Result<()> {
        if solver.mesh().id() != self.mesh.id() {
            return Err(Error::ForeignMesh { what: "solver" });
        }
        distance.require(&self.mesh)?;
        let measured = solver.measured().clone();
        self.goal =
            Some(Goal { distance: measured.inside(Cow::Owned(distance)).into_owned(), measured, volumes: None });
        self.walkers.iter_mut().for_each(|walker| walker.path = None);
        Ok(())
    }

    /// Lets every walker that has a path walk on by `step`, in the file's unit where that costs 1: shorter where a unit of length costs
    /// more. Those who arrive on the way start again, and those who are missing start, spread by volume over the tetrahedra with a path
    /// to a source. Those who wait for a path stay where they are; a few get theirs in each step. Without a distance to
    /// [`follow`](Self::follow) nobody is out.
    ///
    /// # Errors
    /// [`Error::Heat`] with `BadParameter` for a step that is negative or not finite.
    pub fn advance(&mut self, step: f64) -> Result<()> {
        if !(step >= 0.0 && step.is_finite()) {
            let (name, value, range) = ("the step", step.to_string(), "0 or more, and finite");
            return Err(heatwalk::Error::BadParameter { name, value, range }.into());
        }
        let Self { mesh, count, walkers, goal: Some(goal), turn, random } = self else { return Ok(()) };
        let missing = (walkers.len()..*count).map_while(|_| goal.start(mesh, random));
        walkers.extend(missing);
        let mut found = 0;
        let out = walkers.len();
        let first = *turn;
        for number in (0..out).map(|k| (first + k) % out) {
            if found == PATHS_A_STEP {
                break;
            }
            *turn = (number + 1) % out;
            if walkers[number].path.is_none() {
                found += 1;
                match goal.path(mesh, walkers[number].position) {
                    Some(path) => walkers[number].take(path),
                    None => goal.restart(mesh, &mut walkers[number], random),
                }
            }
        }
        for walker in walkers.iter_mut() {
            if !walker.walk(step) {
                goal.restart(mesh, walker, random);
            }
        }
        Ok(())
    }

    /// How each walker that is out stands, where this direction (of any length) is up.
    pub fn poses(&self, up: DVec3) -> impl ExactSizeIterator<Item = VolumePose> + '_ {
        let axis = up.normalize_or(DVec3::Y);
        self.walkers.iter().map(move |&Walker { position, heading, arc, .. }| {
            let upright = axis.reject_from_normalized(heading);
            let up = if upright.length() > PARALLEL {
                // Once more, for what is left of up may be little.
                upright.normalize().reject_from_normalized(heading).normalize()
            } else {
                heading.any_orthonormal_vector()
            };
            VolumePose { position, up, heading, arc }
        })
    }
}

impl Goal {
    /// The path from a place; none where that is outside or reaches no source.
    fn path(&self, mesh: &TetMesh, place: DVec3) -> Option<VolumePath> {
        let from = mesh.locate(place)?;
        self.measured.path(&self.distance, from).ok()
    }

    /// Someone at a random place, by volume, who faces where distance falls; none where no tetrahedron has a path from everywhere.
    fn start(&mut self, mesh: &TetMesh, random: &mut SplitMix64) -> Option<Walker> {
        let volumes = self.volumes.get_or_insert_with(|| reached_volumes(&self.measured, &self.distance));
        let total = volumes.last().copied().filter(|&total| total > 0.0)?;
        let wanted = random.random::<f64>() * total;
        // The product may round to the total; the tetrahedron that completes it has a volume, the last one need not count.
        let tetrahedron = volumes.partition_point(|&volume| volume <= wanted && volume < total) as u32;
        // Spacings of random numbers are spread evenly over a simplex.
        let mut cuts: [f64; 3] = random.random();
        cuts.sort_unstable_by(f64::total_cmp);
        let weights = [cuts[0], cuts[1] - cuts[0], cuts[2] - cuts[1], 1.0 - cuts[2]];
        let position = TetPoint::Inside { tetrahedron: TetId(tetrahedron), weights }.position(mesh);
        let heading = (-self.distance.gradient_in(&self.measured.mesh, tetrahedron)).normalize_or(DVec3::X);
        Some(Walker { position, heading, arc: 0.0, path: None })
    }

    /// The same walker elsewhere, where there is such a place.
    fn restart(&mut self, mesh: &TetMesh, walker: &mut Walker, random: &mut SplitMix64) {
        if let Some(other) = self.start(mesh, random) {
            *walker = other;
        }
    }
}

/// As [`Goal::volumes`].
fn reached_volumes(Measured { mesh, medium, .. }: &Measured, distance: &VolumeDistance) -> Vec<f64> {
    let mut sum = 0.0;
    let up_to = |(tetrahedron, corners): (usize, &[u32; 4])| {
        let is_reached = corners.iter().all(|&vertex| distance.values[vertex as usize].is_finite());
        if is_reached && medium.cost(tetrahedron as u32).is_finite() {
            sum += six_volumes(mesh.corners(TetId(tetrahedron as u32))) / 6.0;
        }
        sum
    };
    mesh.tetrahedra().iter().enumerate().map(up_to).collect()
}

impl Walker {
    /// Sets out along a path.
    fn take(&mut self, path: VolumePath) {
        self.path = Some(Walk { path, next: 1 });
        self.face_next();
    }

    fn face_next(&mut self) {
        let Some(Walk { path, next }) = &self.path else { return };
        let mut ahead = path.points[*next..].iter().map(|&point| point - self.position);
        let leg = ahead.find(|leg| leg.length() > SHORT * path.length);
        self.heading = leg.and_then(DVec3::try_normalize).unwrap_or(self.heading);
    }

    /// Goes on by a step, if it has a path. Returns whether its path goes on.
    fn walk(&mut self, step: f64) -> bool {
        let Some(walk) = &mut self.path else { return true };
        let mut left = step;
        while let Some(&next) = walk.path.points.get(walk.next) {
            let cost = walk.path.costs[walk.next - 1];
            let length = self.position.distance(next);
            if left < cost * length {
                let walked = left / cost;
                self.position += (next - self.position) * (walked / length);
                self.arc += walked;
                self.face_next();
                return true;
            }
            left -= cost * length;
            self.position = next;
            self.arc += length;
            walk.next += 1;
        }
        false
    }
}
