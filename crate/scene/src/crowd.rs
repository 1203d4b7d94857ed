//! A crowd of walkers that go home down one distance: each along the steepest descent of the linear interpolation in its
//! face, as [`descend`](heatwalk::descend) does, but by one step at a time, so that the distance may change in between.
//!
//! Where it arrives a walker starts again elsewhere. So it does where nothing falls and no source is near (a minimum
//! that heat made), and where its component of the surface has lost its last source.

use std::sync::Arc;

use glam::DVec3;

use heatwalk::Costs;
use heatwalk::Distance;
use heatwalk::FaceId;
use heatwalk::Surface;
use heatwalk::{Error, Result};
use rand::SeedableRng;
use rand_xoshiro::SplitMix64;

use crate::flow::{Flow, Place};
use crate::footing::{Footing, turned};
use crate::transform::DrawTransform;

/// Faces that a walker enters in one step at most: more than any step of some edges goes through, and so few that a
/// crowd among slivers does not hold up a frame for long. The rest of such a step is lost.
const MOST_LEGS: usize = 256;

/// Steps after which walkers are put in order again. Between, they go a few faces further, which costs little order,
/// and ordering takes about as long as a step.
const ORDERED_FOR: usize = 16;

/// Numbers a walker in [`Crowd::poses`].
const POSE: usize = 10;

/// Someone on the way home.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walker {
    /// A face that it stands on.
    pub face: FaceId,
    /// Where in that face: barycentric weights, non-negative, of sum 1 but for rounding.
    pub weights: [f64; 3],
    /// The same place, in the file's unit.
    pub position: DVec3,
    /// Unit normal there, interpolated between the vertices' normals; the face's where those point below it.
    pub upright: DVec3,
    /// Unit vector at right angles to `upright`. It turns along the path over about a figure's height.
    pub heading: DVec3,
    /// Length walked since it started, in the file's unit.
    pub arc: f64,
}

/// Walkers on a surface.
#[derive(Debug, Clone)]
pub struct Crowd {
    surface: Arc<Surface>,
    footing: Footing,
    height: f64,
    count: usize,
    walkers: Vec<Walker>,
    /// The walkers by face, as they stood up to [`ORDERED_FOR`] steps ago. In this order they are moved, so that most of
    /// what a walker needs was just used by the one before: a step is mostly waiting for memory.
    order: Vec<u32>,
    /// Steps since.
    steps: usize,
    flow: Flow,
    /// `#F`, what a unit of length costs; none where that is 1 everywhere.
    costs: Option<Costs>,
    random: SplitMix64,
}

impl Crowd {
    /// A crowd of `count` walkers, `height` high in the file's unit. With the same `seed` they start at the same places.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a height that is not positive and finite.
    pub fn new(surface: impl Into<Arc<Surface>>, count: usize, height: f64, seed: u64) -> Result<Self> {
        if !(height > 0.0 && height.is_finite()) {
            let value = height.to_string();
            return Err(Error::BadParameter { name: "the height of walkers", value, range: "positive and finite" });
        }
        let surface = surface.into();
        let footing = Footing::new(&surface);
        let flow = Flow::new(&surface);
        Ok(Self {
            surface,
            footing,
            height,
            count,
            walkers: Vec::new(),
            order: Vec::new(),
            steps: 0,
            flow,
            costs: None,
            random: SplitMix64::seed_from_u64(seed),
        })
    }

    /// The walkers that are out; none before the first [`advance`](Self::advance).
    pub fn walkers(&self) -> &[Walker] {
        &self.walkers
    }

    /// Changes the number of walkers. The first ones go on; more come with the next [`advance`](Self::advance).
    pub fn set_count(&mut self, count: usize) {
        self.count = count;
        self.walkers.truncate(count);
    }

    /// How many walkers there are to be.
    pub fn count(&self) -> usize {
        self.count
    }

    /// How high they are, in the file's unit.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// Lets walkers go slower where a unit of length costs more, and faster where it costs less than 1; nowhere without costs.
    ///
    /// # Panics
    /// Where there is not one cost a face.
    pub fn set_costs(&mut self, costs: Option<&Costs>) {
        let is_suited = |costs: &Costs| costs.of_faces().len() == self.surface.face_count();
        assert!(costs.is_none_or(is_suited), "one cost a face");
        self.costs = costs.cloned();
    }

    /// Sends the walkers down a distance, from where they are.
    ///
    /// # Errors
    /// [`Error::NoSource`] for a distance without sources; [`Error::Surface`] with `ForeignSurface` for a distance of another
    /// surface.
    pub fn follow(&mut self, distance: &Distance) -> Result<()> {
        self.flow.follow(&self.surface, distance)
    }

    /// Takes the walkers along to the same surface in another pose, where each stays at its place. They wait there for a
    /// distance to [`follow`](Self::follow).
    ///
    /// # Errors
    /// [`Error::Surface`] with `ForeignSurface` for a surface that is not this one in another pose.
    pub fn carry(&mut self, to: impl Into<Arc<Surface>>) -> Result<()> {
        let to = to.into();
        to.require_pose_of(&self.surface, "crowd")?;
        let from = std::mem::replace(&mut self.surface, to);
        self.footing = Footing::new(&self.surface);
        self.flow = Flow::new(&self.surface);
        for walker in &mut self.walkers {
            let (position, upright) =
                self.footing.stand(&self.surface, Place { face: walker.face, weights: walker.weights });
            let ahead = carried(walker.heading, from.corners(walker.face), self.surface.corners(walker.face));
            let heading = turned(DVec3::ZERO, ahead, upright, 1.0);
            *walker = Walker { position, upright, heading, ..*walker };
        }
        Ok(())
    }

    /// Moves every walker by `step`, in the file's unit where that costs 1, along the surface down the distance. Those who arrive on the way
    /// start again, and those who are missing start, spread by area over the components with a source; they stand there
    /// until the next call. Without a distance to [`follow`](Self::follow) nobody is out.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a step that is negative or not finite.
    pub fn advance(&mut self, step: f64) -> Result<()> {
        if !(step >= 0.0 && step.is_finite()) {
            return Err(Error::BadParameter { name: "step", value: step.to_string(), range: "0 or more, and finite" });
        }
        if self.flow.is_empty() {
            return Ok(());
        }
        if self.steps.is_multiple_of(ORDERED_FOR) || self.order.len() != self.walkers.len() {
            self.order = (0..self.walkers.len() as u32).collect();
            self.order.sort_by_cached_key(|&walker| self.walkers[walker as usize].face);
            self.steps = 0;
        }
        self.steps += 1;
        let turn = -(-step / self.height).exp_m1();
        let costs = self.costs.as_ref();
        let ground = Ground { surface: &self.surface, flow: &self.flow, footing: &self.footing, costs, turn };
        for &walker in &self.order {
            let walker = &mut self.walkers[walker as usize];
            *walker = ground.walked(walker, step).unwrap_or_else(|| ground.start(&mut self.random));
        }
        let missing = self.count - self.walkers.len();
        self.walkers.extend((0..missing).map(|_| ground.start(&mut self.random)));
        Ok(())
    }

    /// `#walkers × 10`, each walker's position, upright, heading (three numbers each) and arc, as they are drawn.
    pub fn poses(&self, transform: &DrawTransform) -> Vec<f32> {
        let mut poses = Vec::with_capacity(POSE * self.walkers.len());
        for walker in &self.walkers {
            let [upright, heading] =
                [walker.upright, walker.heading].map(|vector| transform.direction(vector).as_vec3());
            for vector in [transform.place(walker.position), upright, heading] {
                poses.extend(vector.to_array());
            }
            poses.push(transform.length(walker.arc));
        }
        poses
    }
}

/// What walkers walk on in one step.
struct Ground<'a> {
    surface: &'a Surface,
    flow: &'a Flow,
    footing: &'a Footing,
    costs: Option<&'a Costs>,
    /// Share of a turn that a step makes.
    turn: f64,
}

impl Ground<'_> {
    /// A walker after a step; `None` where its path ends before.
    fn walked(&self, walker: &Walker, step: f64) -> Option<Walker> {
        let mut place = Place { face: walker.face, weights: walker.weights };
        // What is left to be spent, and the length walked for the rest.
        let mut left = step;
        let mut walked = 0.0;
        for _ in 0..MOST_LEGS {
            let leg = self.flow.leg(self.surface, place)?;
            let cost = self.costs.map_or(1.0, |costs| costs.of(leg.from.face));
            if left < cost * leg.length {
                place = leg.at(left / (cost * leg.length));
                walked += left / cost;
                break;
            }
            if leg.is_last {
                return None;
            }
            place = leg.end();
            left -= cost * leg.length;
            walked += leg.length;
        }
        let (position, upright) = self.footing.stand(self.surface, place);
        let heading = turned(walker.heading, position - walker.position, upright, self.turn);
        let Place { face, weights } = place;
        Some(Walker { face, weights, position, upright, heading, arc: walker.arc + walked })
    }

    /// A walker at a random place, facing where it will go.
    fn start(&self, random: &mut SplitMix64) -> Walker {
        let (face, weights) = self.flow.homes.random_place(random);
        let place = Place { face, weights };
        let (position, upright) = self.footing.stand(self.surface, place);
        let ahead = self.flow.leg(self.surface, place).map_or(DVec3::ZERO, |leg| leg.vector(self.surface));
        let heading = turned(DVec3::ZERO, ahead, upright, 1.0);
        Walker { face, weights, position, upright, heading, arc: 0.0 }
    }
}

/// A vector along a triangle after the affine map that takes its corners to others.
fn carried(vector: DVec3, from: [DVec3; 3], [p, q, r]: [DVec3; 3]) -> DVec3 {
    let [b, c] = [from[1] - from[0], from[2] - from[0]];
    let normal = b.cross(c);
    let scale = normal.length_squared().recip();
    let [along_b, along_c] = [vector.cross(c).dot(normal), b.cross(vector).dot(normal)];
    (scale * along_b) * (q - p) + (scale * along_c) * (r - p)
}
