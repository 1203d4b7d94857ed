//! Agents that go down one distance, each with its radius and speed, and make way for each other and for obstacles: as people do who see
//! how soon they would meet.
//!
//! Each accelerates to its speed down the distance, and away from those that it would meet, by the force that Karamouzas, Skinner and Guy
//! measured in crowds (A universal power law governing pedestrian interactions, 2014, equation 4): that of an energy k / τ² e^(−τ / τ₀) of the
//! time τ to the meeting. What overlaps all the same is moved apart. Directions between agents are taken in the tangent plane, so
//! radii should be small against bends of the surface.

mod agent;
mod grid;
mod meeting;
mod slide;

use std::sync::Arc;

use glam::DVec3;
use heatwalk::{Costs, Distance, Error, FaceId, Result, Surface, SurfacePoint};

use crate::flow::{Flow, Place};
use crate::footing::{Footing, turned};
pub use agent::Agent;
use grid::{Grid, Lies};
use meeting::{Other, met};
use slide::slid;

/// Seconds in which an agent comes to its speed.
const REACTION: f64 = 0.4;
/// An agent accelerates by no more than so many times its speed in a second.
const AGILITY: f64 = 8.0;
/// Two touch that are so many times as far apart as their radii are long, and go on to do so up to the second of these.
const TOUCH: [f64; 2] = [1.25, 2.0];
/// How far agents look, in radii of the largest beside their own way.
const SIGHT: f64 = 4.0;
/// Steps after which agents are put in order of their faces again.
const ORDERED_FOR: usize = 16;

/// What agents make way for: a ball in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Obstacle {
    /// Its center, in the file's unit.
    pub position: DVec3,
    /// In the file's unit a second.
    pub velocity: DVec3,
    /// In the file's unit.
    pub radius: f64,
}

/// Agents on a surface.
#[derive(Debug, Clone)]
pub struct Agents {
    surface: Arc<Surface>,
    footing: Footing,
    flow: Flow,
    costs: Option<Costs>,
    agents: Vec<Agent>,
    obstacles: Vec<Obstacle>,
    /// The agents by face, as they stood up to [`ORDERED_FOR`] steps ago: most of what one needs was just used by the one before.
    order: Vec<u32>,
    steps: usize,
    seen: Grid<Seen>,
    in_the_way: Grid<Obstacle>,
    /// Of each agent, for the next step.
    moves: Vec<Move>,
}

/// What an agent is about to do.
#[derive(Debug, Clone, Copy, Default)]
struct Move {
    velocity: DVec3,
    /// Out of what it overlaps.
    apart: DVec3,
    /// Whether it touches one nearer to the source that has arrived.
    is_behind: bool,
}

/// What an agent sees of another.
#[derive(Debug, Clone, Copy)]
struct Seen {
    number: u32,
    has_arrived: bool,
    position: DVec3,
    velocity: DVec3,
    upright: DVec3,
    radius: f64,
    left: f64,
}

impl Lies for Seen {
    fn position(&self) -> DVec3 {
        self.position
    }
}

impl Lies for Obstacle {
    fn position(&self) -> DVec3 {
        self.position
    }
}

impl Agents {
    /// Without any yet.
    #[must_use]
    pub fn new(surface: impl Into<Arc<Surface>>) -> Self {
        let surface = surface.into();
        let (footing, flow) = (Footing::new(&surface), Flow::new(&surface));
        Self {
            surface,
            footing,
            flow,
            costs: None,
            agents: Vec::new(),
            obstacles: Vec::new(),
            order: Vec::new(),
            steps: 0,
            seen: Grid::new(),
            in_the_way: Grid::new(),
            moves: Vec::new(),
        }
    }

    /// All of them, in the order in which they were added.
    #[must_use]
    pub fn agents(&self) -> &[Agent] {
        &self.agents
    }

    /// Adds one, with a radius in the file's unit and a speed in that a second; gives its number.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a radius that is not positive and finite, and a speed that is negative or not finite.
    pub fn add(&mut self, point: &SurfacePoint, radius: f64, speed: f64) -> Result<usize> {
        let bad = |name, value: f64, range| Error::BadParameter { name, value: value.to_string(), range };
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(bad("the radius of an agent", radius, "positive and finite"));
        }
        if !(speed >= 0.0 && speed.is_finite()) {
            return Err(bad("the speed of an agent", speed, "0 or more, and finite"));
        }
        let (face, weights) = self.on_face(point);
        let (position, upright) = self.footing.stand(&self.surface, Place { face, weights });
        let ahead = self.ahead(Place { face, weights });
        let heading = turned(DVec3::ZERO, ahead, upright, 1.0);
        let (velocity, left, has_arrived) = (DVec3::ZERO, f64::INFINITY, false);
        self.agents.push(Agent {
            face,
            weights,
            position,
            velocity,
            upright,
            heading,
            radius,
            speed,
            left,
            has_arrived,
        });
        Ok(self.agents.len() - 1)
    }

    /// Puts an agent elsewhere, where it stands still.
    ///
    /// # Panics
    /// For a number that none has.
    pub fn put(&mut self, number: usize, point: &SurfacePoint) {
        let (face, weights) = self.on_face(point);
        let (position, upright) = self.footing.stand(&self.surface, Place { face, weights });
        let agent = &mut self.agents[number];
        let heading = turned(agent.heading, agent.heading, upright, 1.0);
        let (velocity, left, has_arrived) = (DVec3::ZERO, f64::INFINITY, false);
        *agent = Agent { face, weights, position, velocity, upright, heading, left, has_arrived, ..*agent };
    }

    /// Takes all agents away that are not wanted; those behind move up.
    pub fn retain(&mut self, mut is_wanted: impl FnMut(usize) -> bool) {
        let mut number = 0..;
        self.agents.retain(|_| number.next().is_some_and(&mut is_wanted));
    }

    /// Has agents instead of its own that [`agents`](Self::agents) has told of others on the same surface.
    ///
    /// # Errors
    /// [`Error::Surface`] with `ForeignSurface` where one stands on a face that the surface does not have.
    pub fn restore(&mut self, agents: Vec<Agent>) -> Result<()> {
        if agents.iter().any(|agent| agent.face.0 as usize >= self.surface.face_count()) {
            return Err(heatwalk::surface::Error::ForeignSurface { thing: "agent" }.into());
        }
        self.agents = agents;
        Ok(())
    }

    /// Sends them down a distance, from where they are, slower where a unit of length costs more.
    ///
    /// # Errors
    /// [`Error::NoSource`] for a distance without sources; [`Error::Surface`] with `ForeignSurface` for a distance of another surface.
    pub fn follow(&mut self, distance: &Distance, costs: Option<&Costs>) -> Result<()> {
        self.flow.follow(&self.surface, distance)?;
        self.costs = costs.cloned();
        for agent in &mut self.agents {
            agent.has_arrived = false;
        }
        Ok(())
    }

    /// What they make way for from now on, beside each other.
    pub fn set_obstacles(&mut self, obstacles: Vec<Obstacle>) {
        self.obstacles = obstacles;
    }

    /// Moves all of them by so many seconds.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a time that is negative or not finite.
    pub fn update(&mut self, seconds: f64) -> Result<()> {
        if !(seconds >= 0.0 && seconds.is_finite()) {
            let value = seconds.to_string();
            return Err(Error::BadParameter { name: "the time of a step", value, range: "0 or more, and finite" });
        }
        if self.steps.is_multiple_of(ORDERED_FOR) || self.order.len() != self.agents.len() {
            self.order = (0..self.agents.len() as u32).collect();
            self.order.sort_by_cached_key(|&agent| self.agents[agent as usize].face);
            self.steps = 0;
        }
        self.steps += 1;
        let largest = self.agents.iter().map(|agent| agent.radius).fold(0.0, f64::max);
        let seen = |(number, agent): (usize, &Agent)| {
            let Agent { has_arrived, position, velocity, upright, radius, left, .. } = *agent;
            Seen { number: number as u32, has_arrived, position, velocity, upright, radius, left }
        };
        let agents: Vec<Seen> = self.agents.iter().enumerate().map(seen).collect();
        self.seen.sort(&agents, SIGHT * largest);
        let widest = self.obstacles.iter().map(|obstacle| obstacle.radius).fold(0.0, f64::max);
        self.in_the_way.sort(&self.obstacles, SIGHT * largest + widest);
        self.moves.resize(self.agents.len(), Move::default());
        // Those in a cube together, who see the same.
        for k in 0..self.agents.len() {
            let number = self.seen.things()[k].number as usize;
            self.moves[number] = self.decided(number, seconds);
        }
        for k in 0..self.order.len() {
            let number = self.order[k] as usize;
            self.agents[number] = self.moved(self.agents[number], self.moves[number], seconds);
        }
        Ok(())
    }

    /// What an agent does with all others as they are.
    fn decided(&self, number: usize, seconds: f64) -> Move {
        let agent = &self.agents[number];
        let wanted = if agent.has_arrived { DVec3::ZERO } else { self.wanted(agent) };
        let mut force = (wanted - agent.velocity) / REACTION;
        let (mut apart, mut is_behind) = (DVec3::ZERO, false);
        let touch = TOUCH[usize::from(agent.has_arrived)];
        let mut meet = |other: &Other| {
            let (pushed, moved) = met(agent, number, other);
            force += pushed;
            apart += moved;
        };
        self.seen.for_each_near(agent.position, |other| {
            let Seen { position, velocity, radius, .. } = *other;
            // Those on the other side of a sheet are near in space alone.
            if other.number as usize != number && other.upright.dot(agent.upright) > 0.0 {
                is_behind |= other.has_arrived
                    && other.left < agent.left
                    && position.distance(agent.position) < touch * (radius + agent.radius);
                meet(&Other { position, velocity, radius, share: 0.5 });
            }
        });
        self.in_the_way.for_each_near(agent.position, |&Obstacle { position, velocity, radius }| {
            meet(&Other { position, velocity, radius, share: 1.0 });
        });
        let force = force.clamp_length_max(AGILITY * agent.speed);
        let velocity = (agent.velocity + force * seconds).clamp_length_max(agent.speed);
        Move { velocity, apart: apart.clamp_length_max(agent.radius), is_behind }
    }

    /// The velocity that an agent would have by itself.
    fn wanted(&self, agent: &Agent) -> DVec3 {
        let ahead = self.ahead(Place { face: agent.face, weights: agent.weights });
        let cost = self.costs.as_ref().map_or(1.0, |costs| costs.of(agent.face));
        ahead.normalize_or_zero() * (agent.speed / cost)
    }

    /// Along the way down, of any length; zero where there is none.
    fn ahead(&self, place: Place) -> DVec3 {
        let leg = if self.flow.is_empty() { None } else { self.flow.leg(&self.surface, place) };
        leg.map_or(DVec3::ZERO, |leg| leg.vector(&self.surface))
    }

    fn moved(&self, agent: Agent, Move { velocity, apart, is_behind }: Move, seconds: f64) -> Agent {
        let surface: &Surface = &self.surface;
        let mut place = Place { face: agent.face, weights: agent.weights };
        let mut step = velocity * seconds;
        let mut has_arrived = is_behind;
        let leg = if self.flow.is_empty() { None } else { self.flow.leg(surface, place) };
        if let Some(leg) = leg {
            has_arrived |= leg.is_last && leg.length <= agent.radius;
            // From the face that the way down begins in, where it leads over a portal from behind that.
            place = leg.from;
            if leg.leads_on() && leg.length <= step.length() {
                place = leg.end();
                step *= 1.0 - leg.length / step.length();
            }
        }
        let place = slid(surface, place, step + apart);
        let (position, upright) = self.footing.stand(surface, place);
        let along = |vector: DVec3| vector - upright * upright.dot(vector);
        let velocity = along(velocity).normalize_or_zero() * velocity.length();
        let share = -(-velocity.length() * seconds / (2.0 * agent.radius)).exp_m1();
        let heading = turned(agent.heading, velocity, upright, share);
        let left = if self.flow.is_empty() { f64::INFINITY } else { self.flow.value(surface, place) };
        let Place { face, weights } = place;
        Agent { face, weights, position, velocity, upright, heading, left, has_arrived, ..agent }
    }

    fn on_face(&self, point: &SurfacePoint) -> (FaceId, [f64; 3]) {
        let place = point.place();
        let face = place.faces(&self.surface)[0];
        (face, place.weights_in(&self.surface, face))
    }
}
