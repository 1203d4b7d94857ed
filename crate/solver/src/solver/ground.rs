//! What the surface is like: bridges, walls, costs and the pose in which it is measured.

use std::sync::Arc;

use heatwalk_surface::{BridgeRule, Bridges, Source, Surface, Walls};

use super::{Answer, DistanceSolver, Joined};
use crate::cost::Costs;
use crate::error::Result;
use crate::exact::ExactGeometry;
use crate::heat::HeatSolver;

impl DistanceSolver {
    /// The same with distances and paths that cross these bridges of the surface without walls.
    #[must_use]
    pub fn bridged(mut self, bridges: Bridges) -> Self {
        self.set_joined(bridges.into());
        self
    }

    /// The same where faces have costs: distances are the least costs of paths. Where faces have different ones,
    /// [`Method::Auto`](crate::Method::Auto) and [`Method::Propagation`](crate::Method::Propagation) refract windows, and there are no
    /// exact distances.
    ///
    /// # Panics
    /// Where there is not one cost a face.
    #[must_use]
    pub fn weighted(mut self, costs: Costs) -> Self {
        self.set_costs(Some(costs));
        self
    }

    /// Joins components where they meet, by a rule, and so many pairs of groups beyond that as are nearest. `pose` is the surface
    /// without walls in the pose in which they are to meet: [`Self::whole`], or that posed.
    ///
    /// # Errors
    /// [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` for any other surface.
    pub fn join(&mut self, pose: &Arc<Surface>, rule: BridgeRule, links: usize) -> Result<()> {
        pose.require_pose_of(&self.whole, "pose")?;
        let mut joined = self.joined.clone();
        joined.join(pose, rule, links, self.threads);
        self.set_joined(joined);
        Ok(())
    }

    fn set_joined(&mut self, joined: Joined) {
        let is_changed = joined.bridges().portals() != self.joined.bridges().portals();
        self.joined = joined;
        if is_changed {
            self.forget();
            let bridges = self.bridges();
            self.plain = self.plain.take().map(|plain| Arc::new(Arc::unwrap_or_clone(plain).bridged(&bridges)));
        }
    }

    /// What joins the components of the surface without walls.
    pub fn joined(&self) -> &Joined {
        &self.joined
    }

    /// The least number of links with which the sources of an answer reach more than they do; as many as there are now where they reach
    /// all that can be linked.
    pub fn links_to_reach_more(&mut self, answer: &Answer) -> usize {
        // Walls part vertices, but faces keep their numbers.
        let component = |source: &Source| {
            let face = source.place().faces(&self.surface)[0];
            self.whole.component(self.whole.faces()[face][0])
        };
        let components: Vec<u32> = answer.sources.iter().map(component).collect();
        self.joined.links_to_reach_more(&components)
    }

    /// Parts the surface at these walls, and at no others, in the pose of the whole one. [`Self::surface`] is another one then, on which no
    /// earlier answer holds, unless there were and are no walls. Costs stay: faces keep their numbers.
    ///
    /// # Errors
    /// As [`Surface::walled`]; then nothing is changed.
    pub fn set_walls(&mut self, walls: &Walls) -> Result<()> {
        let whole = &self.whole;
        let parted = if walls.is_empty() { Arc::clone(whole) } else { Arc::new(whole.walled(walls)?) };
        self.parted = Arc::clone(&parted);
        self.measure_on(parted);
        self.lay_costs();
        Ok(())
    }

    /// Changes what faces cost, `None` for 1 everywhere. What the faces of walls cost makes no difference. What is factored is factored again when it is needed.
    ///
    /// # Panics
    /// Where there is not one cost a face.
    pub fn set_costs(&mut self, costs: Option<Costs>) {
        if let Some(costs) = &costs {
            assert_eq!(costs.of_faces().len(), self.surface.face_count(), "one cost a face");
        }
        self.forget();
        self.given_costs = costs;
        self.lay_costs();
    }

    fn lay_costs(&mut self) {
        let costs = self.given_costs.as_ref().map(|costs| costs.beside_walls(&self.parted));
        self.costs = costs.filter(|costs| costs.constant() != Some(1.0));
    }

    /// What a unit of length costs, where that is not 1 everywhere. The faces of walls cost as little as the cheapest of the others.
    pub fn costs(&self) -> Option<&Costs> {
        self.costs.as_ref()
    }

    /// Measures distances on the surface in this pose from now on: [`Self::parted`], or that posed.
    ///
    /// # Errors
    /// [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` for any other surface.
    pub fn set_pose(&mut self, pose: &Arc<Surface>) -> Result<()> {
        pose.require_pose_of(&self.parted, "pose")?;
        if pose.id() != self.surface.id() {
            self.measure_on(Arc::clone(pose));
        }
        Ok(())
    }

    /// The surface without walls, as it came.
    pub fn whole(&self) -> &Arc<Surface> {
        &self.whole
    }

    /// The same as walls part it.
    pub fn parted(&self) -> &Arc<Surface> {
        &self.parted
    }

    fn measure_on(&mut self, surface: Arc<Surface>) {
        self.surface = surface;
        self.forget();
        self.plain = None;
    }

    /// Forgets what is of other costs or bridges, before either changes.
    fn forget(&mut self) {
        let geometry = self.geometry.take().filter(|_| self.costs.is_none());
        self.plain = self.plain.take().or(geometry);
        self.searches.clear();
    }

    /// The geometry with the present bridges and costs.
    pub(super) fn laid_out(&mut self) -> Arc<ExactGeometry> {
        let Some(costs) = self.costs.clone() else {
            self.unfolded();
            return self.plain.take().expect("it was made just now");
        };
        let is_weighted = |heat: &&HeatSolver| heat.factorization().costs().is_some() && self.is_present(heat);
        match self.heat.as_ref().filter(is_weighted) {
            Some(heat) if self.bridges().portals().is_empty() => Arc::clone(heat.exact_geometry()),
            _ => Arc::new(ExactGeometry::clone(self.unfolded()).weighted(&costs)),
        }
    }

    /// The geometry with the present bridges, without costs.
    pub(super) fn unfolded(&mut self) -> &Arc<ExactGeometry> {
        let plain = self.plain.take().unwrap_or_else(|| {
            let is_plain =
                |heat: &&HeatSolver| heat.factorization().costs().is_none() && heat.surface().id() == self.surface.id();
            let (bridges, heat) = (self.bridges(), self.heat.as_ref().filter(is_plain));
            match heat.map(HeatSolver::exact_geometry) {
                Some(geometry) if bridges.portals().is_empty() => Arc::clone(geometry),
                Some(geometry) => Arc::new(ExactGeometry::clone(geometry).bridged(&bridges)),
                None => Arc::new(ExactGeometry::on_threads(Arc::clone(&self.surface), self.threads).bridged(&bridges)),
            }
        });
        self.plain.insert(plain)
    }

    /// The bridges of the surface that is asked.
    fn bridges(&self) -> Bridges {
        let joined = self.joined.bridges();
        let is_whole = Arc::ptr_eq(&self.whole, &self.parted);
        let bridges = if is_whole { joined.clone() } else { joined.across_walls(&self.whole, &self.parted) };
        let is_found_here = self.joined.surface().is_none_or(|surface| surface.id() == self.whole.id());
        let is_measured_here = self.surface.id() == self.parted.id();
        if is_found_here && is_measured_here { bridges } else { bridges.carried(&self.surface) }
    }
}
