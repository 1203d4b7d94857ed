//! Ground of different difficulty, and walls.

use std::sync::Arc;

use heatwalk::Relief;
use heatwalk_bindings::Result;
use heatwalk_scene::Crowd;
use wasm_bindgen::prelude::*;

use super::{CROWD_SEED, Solver};
use crate::drawn::Drawn;
use crate::ground::Ground;

impl Solver {
    /// Parts the surface at the walls of another ground, in all poses.
    fn part(&mut self, ground: &Ground) -> Result<()> {
        let is_posed = self.shown.id() != self.solver.parted().id();
        let is_measured_there = self.shown.id() == self.solver.surface().id();
        self.solver.set_walls(&ground.walls)?;
        let parted = Arc::clone(self.solver.parted());
        let posing = self.posing.as_ref().filter(|_| is_posed).map(|posing| posing.positions(&parted));
        self.shown = posing.map_or_else(|| Arc::clone(&parted), |positions| Arc::new(parted.posed(positions)));
        if is_measured_there {
            self.solver.set_pose(&self.shown)?;
        }
        (self.drawn, self.in_walls) = if ground.walls.is_empty() {
            (Arc::clone(&ground.drawn), 0)
        } else {
            (Arc::new(Drawn::by_corner(&ground.drawn, &parted)), Ground::vertices_in_walls(&parted))
        };
        self.path = None;
        if let Some(crowd) = &self.crowd {
            let (count, height) = (crowd.count(), crowd.height());
            self.crowd = Some(Crowd::new(Arc::clone(&self.shown), count, height, CROWD_SEED)?);
        }
        Ok(())
    }
}

#[wasm_bindgen]
impl Solver {
    /// Changes the ground: drawn triangles that are painted anew, each with its cost, infinite for a wall; all walls along edges,
    /// each as how many vertices of the input it goes through and these; whether slopes cost what Tobler's hiking function says;
    /// and what it costs at the highest place, as a multiple of the lowest one. Forgets the field.
    pub fn set_ground(
        &mut self,
        triangles: &[u32],
        costs: &[f64],
        lines: &[u32],
        slope: bool,
        highest: f64,
    ) -> Result<()> {
        let mut ground = self.ground.clone();
        ground.paint(triangles, costs, lines, Relief { slope, highest })?;
        let costs = ground.costs()?;
        if ground.walls != self.ground.walls {
            self.part(&ground)?;
        }
        self.solver.set_costs(costs);
        self.ground = ground;
        self.forget();
        if let Some(crowd) = &mut self.crowd {
            crowd.set_costs(self.solver.costs());
        }
        Ok(())
    }

    /// `#F × 3`, the drawn triangles beside each drawn one, across the edges from its corners to the next; itself at the
    /// boundary.
    pub fn neighbors(&self) -> Vec<u32> {
        self.ground.neighbors()
    }

    /// The shortest line along edges from one vertex of the input to another, both included.
    pub fn line(&self, from: u32, to: u32) -> Result<Vec<u32>> {
        self.ground.line(from, to)
    }
}
