//! Agents on a mesh.

use glam::{DMat4, DVec3};
use heatwalk::FaceId;
use heatwalk_bindings::{Failure, Message, Result, reporter};
use heatwalk_scene::{Agent, Obstacle};
use js_sys::{Function, Object};
use wasm_bindgen::prelude::*;

use crate::distance::without;
use crate::mesh::Mesh;
use crate::options::distance_options;
use crate::vectors::require_one_each;

/// Numbers of an obstacle: its center, its velocity, its radius.
const PER_OBSTACLE: usize = 7;
/// Numbers of the state of an agent.
const PER_STATE: usize = 20;

/// Agents that go down one distance and make way for each other.
#[wasm_bindgen]
pub struct Agents(heatwalk_scene::Agents);

/// Where agents are, in the order in which they were added.
#[derive(Message)]
pub struct AgentPoses {
    /// Three coordinates of each.
    pub positions: Vec<f32>,
    /// Quaternions x, y, z, w: from a model that stands along y and looks along −z.
    pub orientations: Vec<f32>,
    /// Both as a matrix of 16 numbers, column after column.
    pub matrices: Vec<f32>,
    /// Three of each, in the unit of positions a second.
    pub velocities: Vec<f32>,
    /// The numbers of those that touch a source, or one that has arrived and is nearer to it.
    pub arrived: Vec<u32>,
}

#[wasm_bindgen]
impl Mesh {
    /// Without any yet.
    pub fn agents(&self) -> Agents {
        Agents(heatwalk_scene::Agents::new(self.surface().clone()))
    }

    /// Adds agents at places, each with a radius and a speed.
    pub fn add_agents(&self, agents: &mut Agents, places: &[f64], radii: &[f64], speeds: &[f64]) -> Result<()> {
        let points = self.points(places)?;
        require_one_each(points.len(), radii.len(), "radii")?;
        require_one_each(points.len(), speeds.len(), "speeds")?;
        for (k, point) in points.iter().enumerate() {
            agents.0.add(point, radii[k], speeds[k])?;
        }
        Ok(())
    }

    /// Puts agents elsewhere.
    pub fn put_agents(&self, agents: &mut Agents, numbers: &[u32], places: &[f64]) -> Result<()> {
        let points = self.points(places)?;
        require_one_each(points.len(), numbers.len(), "numbers of agents")?;
        for (&number, point) in numbers.iter().zip(&points) {
            agents.require(number)?;
            agents.0.put(number as usize, point);
        }
        Ok(())
    }

    /// Sends agents to the nearest source.
    pub fn lead_agents(
        &self,
        agents: &mut Agents,
        sources: &[f64],
        options: &Object,
        progress: &Function,
    ) -> Result<()> {
        let (sources, options) = (self.sources(sources, options)?, distance_options(&without(options, "initial"))?);
        self.with_solver(|solver| {
            let answer = solver.distance(&sources, &options, &mut reporter(progress))?;
            Ok(agents.0.follow(&answer.distance, solver.costs())?)
        })
    }
}

#[wasm_bindgen]
impl Agents {
    /// Takes agents away; those behind move up.
    pub fn remove(&mut self, numbers: &[u32]) -> Result<()> {
        numbers.iter().try_for_each(|&number| self.require(number))?;
        let mut gone = vec![false; self.0.agents().len()];
        for &number in numbers {
            gone[number as usize] = true;
        }
        self.0.retain(|number| !gone[number]);
        Ok(())
    }

    /// What they make way for: of each obstacle three coordinates, three of its velocity, and its radius.
    pub fn set_obstacles(&mut self, numbers: &[f64]) -> Result<()> {
        let is_bad = |&[.., radius]: &[f64; PER_OBSTACLE]| radius < 0.0;
        if numbers.iter().any(|number| !number.is_finite()) || numbers.as_chunks().0.iter().any(is_bad) {
            return Err(Failure::of("not-finite", "an obstacle has a number that is not finite, or a negative radius"));
        }
        let obstacle = |&[x, y, z, u, v, w, radius]: &[f64; PER_OBSTACLE]| Obstacle {
            position: DVec3::new(x, y, z),
            velocity: DVec3::new(u, v, w),
            radius,
        };
        self.0.set_obstacles(numbers.as_chunks().0.iter().map(obstacle).collect());
        Ok(())
    }

    /// Moves them by so many seconds; tells where they are then.
    pub fn update(&mut self, seconds: f64) -> Result<AgentPoses> {
        self.0.update(seconds)?;
        let agents = self.0.agents();
        let room = |each: usize| Vec::with_capacity(each * agents.len());
        let (mut positions, mut orientations, mut matrices, mut velocities) = (room(3), room(4), room(16), room(3));
        let mut arrived = Vec::new();
        for (number, agent) in (0..).zip(agents) {
            let turn = agent.orientation();
            positions.extend_from_slice(&agent.position.as_vec3().to_array());
            orientations.extend_from_slice(&turn.as_quat().to_array());
            let matrix = DMat4::from_rotation_translation(turn, agent.position);
            matrices.extend_from_slice(&matrix.as_mat4().to_cols_array());
            velocities.extend_from_slice(&agent.velocity.as_vec3().to_array());
            if agent.has_arrived {
                arrived.push(number);
            }
        }
        Ok(AgentPoses { positions, orientations, matrices, velocities, arrived })
    }
}

#[wasm_bindgen]
impl Agents {
    /// All that is of them, for [`Self::restore`].
    pub fn state(&self) -> Vec<f64> {
        self.0.agents().iter().flat_map(written).collect()
    }

    /// Has the agents of a state, which was taken on the same surface, instead of its own.
    pub fn restore(&mut self, state: &[f64]) -> Result<()> {
        Ok(self.0.restore(state.as_chunks().0.iter().map(read).collect())?)
    }
}

fn written(agent: &Agent) -> [f64; PER_STATE] {
    let Agent { face, weights: [a, b, c], position, velocity, upright, heading, radius, speed, left, has_arrived } =
        *agent;
    let [[x, y, z], [u, v, w], [i, j, k], [l, m, n]] = [position, velocity, upright, heading].map(<[f64; 3]>::from);
    let has_arrived = f64::from(u8::from(has_arrived));
    [f64::from(face.0), a, b, c, x, y, z, u, v, w, i, j, k, l, m, n, radius, speed, left, has_arrived]
}

fn read(state: &[f64; PER_STATE]) -> Agent {
    let [face, a, b, c, x, y, z, u, v, w, i, j, k, l, m, n, radius, speed, left, has_arrived] = *state;
    Agent {
        face: FaceId(face as u32),
        weights: [a, b, c],
        position: DVec3::new(x, y, z),
        velocity: DVec3::new(u, v, w),
        upright: DVec3::new(i, j, k),
        heading: DVec3::new(l, m, n),
        radius,
        speed,
        left,
        has_arrived: has_arrived != 0.0,
    }
}

impl Agents {
    fn require(&self, number: u32) -> Result<()> {
        let count = self.0.agents().len();
        if (number as usize) < count {
            return Ok(());
        }
        let sentence = format!("there is no agent {number}; there are {count}, counted from 0");
        Err(Failure::of("no-such-agent", &sentence))
    }
}
