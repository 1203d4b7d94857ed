//! A surface that moves: in which pose it is shown, and in which distances are measured.

use std::sync::Arc;

use heatwalk::{Distance, Path};
use heatwalk_bindings::{DrawPath, Result};
use wasm_bindgen::prelude::*;

use super::Solver;
use crate::motion::moment;
use crate::results::{DrawPose, draw_path};

impl Solver {
    /// The last field on the surface as it is shown.
    pub(super) fn shown_distance(&self) -> Result<Distance> {
        Ok(self.solved()?.distance().carried(self.solver.surface(), &self.shown)?)
    }

    /// A path as it is shown, and from now on in every pose.
    pub(super) fn shown_path(&mut self, path: Path) -> Result<DrawPath> {
        let shown = path.carried(self.solver.surface(), &self.shown)?;
        let drawn = self.drawn_path(&path, &shown);
        self.path = Some(path);
        Ok(drawn)
    }

    fn drawn_path(&self, path: &Path, shown: &Path) -> DrawPath {
        draw_path(self.solver.surface(), path, shown, self.solver.costs(), &self.drawn.transform)
    }
}

#[wasm_bindgen]
impl Solver {
    /// Shows the surface as it is so many seconds after the beginning of an animation, or without one in its file; none where it
    /// does not move. Distances are `measured` in that pose from now on, and the last field is forgotten; or in that of the file.
    pub fn pose(&mut self, clip: Option<u32>, seconds: f64, measured: bool) -> Result<Option<DrawPose>> {
        let of_file = Arc::clone(self.solver.parted());
        let Some(posing) = &mut self.posing else { return Ok(None) };
        posing.take(moment(clip, seconds))?;
        let posed = posing.draw(&self.drawn.transform).into();
        self.shown = match clip {
            None => Arc::clone(&of_file),
            Some(_) => Arc::new(of_file.posed(posing.positions(&of_file))),
        };
        let metric = if measured { Arc::clone(&self.shown) } else { of_file };
        if metric.id() != self.solver.surface().id() {
            self.solver.set_pose(&metric)?;
            self.forget();
        }
        if let Some(crowd) = &mut self.crowd {
            crowd.carry(Arc::clone(&self.shown))?;
        }
        self.lead_crowd()?;
        Ok(Some(posed))
    }

    /// The path that was traced last, as it is shown; none where distances are measured in another pose by now.
    pub fn posed_path(&self) -> Option<DrawPath> {
        let path = self.path.as_ref()?;
        let shown = path.carried(self.solver.surface(), &self.shown).ok()?;
        Some(self.drawn_path(path, &shown))
    }
}
