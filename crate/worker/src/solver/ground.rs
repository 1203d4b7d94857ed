//! Ground of different difficulty, and walls.

use std::sync::Arc;

use heatwalk::exact::ExactGeometry;
use heatwalk::{HeatSolver, Surface};
use heatwalk_bindings::Result;
use heatwalk_scene::Crowd;
use wasm_bindgen::prelude::*;

use super::{CROWD_SEED, Solver};
use crate::drawn::Drawn;
use crate::ground::{Ground, Relief};

impl Solver {
    /// The surface in the pose of the file, as walls part it.
    pub(super) fn of_file(&self) -> Arc<Surface> {
        Arc::clone(&self.parted)
    }

    /// A geometry with the bridges and the costs that hold; the same without costs is kept where these differ.
    pub(super) fn lay_out(&mut self, plain: ExactGeometry) {
        let surface = Arc::clone(plain.surface());
        let bridges = self.joined.bridges();
        let here = if self.ground.walls.is_empty() {
            bridges.carried(&surface)
        } else {
            bridges.across_walls(&self.ground.surface, &self.parted).carried(&surface)
        };
        let plain = plain.bridged(&here);
        (self.geometry, self.unweighted) = match &self.ground.costs {
            None => (Arc::new(plain), None),
            Some(costs) => (Arc::new(plain.clone().weighted(costs)), Some(Arc::new(plain))),
        };
        (self.propagation, self.solved, self.search) = (None, None, None);
    }

    /// That of the present surface without costs.
    pub(super) fn plain_geometry(&self) -> ExactGeometry {
        ExactGeometry::clone(self.unweighted.as_ref().unwrap_or(&self.geometry))
    }

    /// Parts the surface at the walls of another ground, in all poses.
    fn part(&mut self, ground: &Ground) -> Result<ExactGeometry> {
        let parted = if ground.walls.is_empty() {
            Arc::clone(&ground.surface)
        } else {
            Arc::new(ground.surface.walled(&ground.walls)?)
        };
        let is_posed = self.shown.id() != self.parted.id();
        let is_measured_there = is_posed && self.geometry.surface().id() == self.shown.id();
        self.drawn = if ground.walls.is_empty() {
            Arc::clone(&ground.drawn)
        } else {
            Arc::new(Drawn::by_corner(&ground.drawn, &parted))
        };
        let posing = self.posing.as_ref().filter(|_| is_posed).map(|posing| posing.positions(&parted));
        self.shown = posing.map_or_else(|| Arc::clone(&parted), |positions| Arc::new(parted.posed(positions)));
        self.in_walls = if ground.walls.is_empty() { 0 } else { Ground::vertices_in_walls(&parted) };
        self.parted = parted;
        self.path = None;
        if let Some(crowd) = &self.crowd {
            let (count, height) = (crowd.count(), crowd.height());
            self.crowd = Some(Crowd::new(Arc::clone(&self.shown), count, height, CROWD_SEED)?);
        }
        let metric = if is_measured_there { &self.shown } else { &self.parted };
        Ok(ExactGeometry::new(Arc::clone(metric)))
    }

    /// Factors for the ground as it is, where that has changed since.
    pub(super) fn factor_anew(&mut self) -> Result<()> {
        if !std::mem::take(&mut self.is_stale) {
            return Ok(());
        }
        let Some(parameters) = self.heat.as_ref().map(HeatSolver::parameters) else { return Ok(()) };
        let made = self.factored_for(self.geometry.surface(), parameters);
        self.is_stale = made.is_err();
        self.heat = Some(made?);
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
        let plain = if ground.walls == self.ground.walls { self.plain_geometry() } else { self.part(&ground)? };
        self.ground = ground;
        self.is_stale = true;
        self.lay_out(plain);
        if let Some(crowd) = &mut self.crowd {
            crowd.set_costs(self.ground.costs.as_ref());
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
