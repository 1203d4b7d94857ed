//! Heat after time t.

use crate::error::Result;
use crate::heat::{Condition, Heat, HeatSolver, Solve};
use crate::options::MultiSource;
use heatwalk_sparse::{Functional, SchurComplement, System};
use heatwalk_surface::{Element, Source, VertexId};

/// Heat at a source. Near the largest float, so that heat falls through 1,375 e-folds, not 708, before it reaches the
/// smallest normal float.
pub(super) const SOURCE_HEAT: f64 = 1e290;

impl HeatSolver {
    /// Heat `u` (`#P`) under the boundary condition, to an arbitrary scale near 10²⁹⁰, and per source whether it is
    /// the nearest one to any point: those that are not would have to take heat out.
    pub(super) fn heat(&self, sources: &[Source]) -> Result<(Vec<f64>, Vec<bool>)> {
        let mut answers = self.needed_heats().map(|heat| self.heat_of(heat, sources));
        let (mut heat, mut is_active) = answers.next().expect("some heat system is always there")?;
        for answer in answers {
            let (other, is_active_there) = answer?;
            for (heat, other) in heat.iter_mut().zip(&other) {
                *heat = 0.5 * (*heat + other);
            }
            for (active, there) in is_active.iter_mut().zip(is_active_there) {
                *active |= there;
            }
        }
        Ok((heat, is_active))
    }

    fn heat_of(&self, heat: &Heat, sources: &[Source]) -> Result<(Vec<f64>, Vec<bool>)> {
        let mut is_active = vec![true; sources.len()];
        if self.parameters.sources == MultiSource::Summed {
            return Ok((self.summed(heat, sources)?, is_active));
        }
        let least = sources.iter().map(|source| source.initial_distance()).fold(f64::INFINITY, f64::min);
        let level = |source: &Source| ((least - source.initial_distance()) / heat.time.sqrt() + SOURCE_HEAT.ln()).exp();
        loop {
            let active: Vec<usize> = (0..sources.len()).filter(|&index| is_active[index]).collect();
            let levels: Vec<(Source, f64)> =
                active.iter().map(|&index| (sources[index], level(&sources[index]))).collect();
            let (values, supplies) = self.prescribed(heat, &levels)?;
            // Sources of the least starting value always give heat; rounding must not drop one of them.
            let takes = |&(&index, supply): &(&usize, f64)| supply < 0.0 && sources[index].initial_distance() > least;
            let dropped: Vec<usize> = active.iter().zip(supplies).filter(takes).map(|(&index, _)| index).collect();
            if dropped.is_empty() {
                return Ok((values, is_active));
            }
            for index in dropped {
                is_active[index] = false;
            }
        }
    }

    /// Heat that is at these levels at the sources, and the supply that each needs for it.
    fn prescribed(&self, heat: &Heat, levels: &[(Source, f64)]) -> Result<(Vec<f64>, Vec<f64>)> {
        let surface = &*self.surface;
        if let [(source, _)] = levels {
            // The level of a single source is arbitrary.
            let supply: Vec<(u32, f64)> = source
                .place()
                .support(surface)
                .filter(|&(vertex, _)| !self.is_held(heat, vertex.index()))
                .map(|(vertex, weight)| (vertex.0, weight * SOURCE_HEAT))
                .collect();
            if !supply.is_empty() {
                return Ok((heat.system.solve_sparse(&supply)?, vec![SOURCE_HEAT]));
            }
        }
        let vertices: Vec<VertexId> = levels.iter().filter_map(|(source, _)| source.place().vertex(surface)).collect();
        let mut is_fixed: Vec<bool> = (0..surface.vertex_count()).map(|point| self.is_held(heat, point)).collect();
        let constrained;
        let is_constrained = vertices.len() > 1 && self.is_cheaper_to_factor(&heat.system, vertices.len());
        let system = if is_constrained {
            for &vertex in &vertices {
                is_fixed[vertex.index()] = true;
            }
            let values = self.laplacian.combine(1.0 / heat.time, |point| is_fixed[point]);
            constrained = self.solve.system(values, "heat")?;
            &constrained
        } else {
            &heat.system
        };

        // Sources on fixed points are prescribed there; the others are constraints.
        let mut prescribed = vec![0.0; surface.vertex_count()];
        let mut constraints: Vec<(usize, Functional)> = Vec::new();
        for (index, &(source, level)) in levels.iter().enumerate() {
            let support = || source.place().support(surface).map(|(vertex, weight)| (vertex.0, weight));
            let free: Functional = support().filter(|&(point, _)| !is_fixed[point as usize]).collect();
            if free.is_empty() {
                for (point, _) in support() {
                    prescribed[point as usize] = level.max(prescribed[point as usize]);
                }
            } else {
                constraints.push((index, free));
            }
        }
        let mut supplies = vec![0.0; levels.len()];
        let any_prescribed = constraints.len() < levels.len();
        let mut right = vec![0.0; prescribed.len()];
        if any_prescribed {
            right = self.laplacian.apply(1.0 / heat.time, &prescribed);
            for (value, &is_fixed) in right.iter_mut().zip(&is_fixed) {
                *value = if is_fixed { 0.0 } else { -*value };
            }
        }
        let mut values = match constraints.as_slice() {
            [] => system.solve(&right)?,
            _ => {
                let functionals: Vec<Functional> = constraints.iter().map(|(_, free)| free.clone()).collect();
                let responses = if is_constrained {
                    system.schur_columns(&functionals)?
                } else {
                    let mut kept = heat.responses.lock().expect("no holder of the lock panics");
                    kept.columns(system, &functionals, self.most_kept(system))?
                };
                let mut begun = system.partial_solve(&right)?;
                let missing: Vec<f64> = constraints
                    .iter()
                    .zip(&responses)
                    .map(|(&(index, _), response)| {
                        let (source, level) = levels[index];
                        let support = source.place().support(surface);
                        let known: f64 = support.map(|(vertex, weight)| prescribed[vertex.index()] * weight).sum();
                        level - known - begun.evaluate(response)
                    })
                    .collect();
                let amounts = SchurComplement::new(&responses, 0.0).solve(&missing);
                for ((&(index, _), response), &amount) in constraints.iter().zip(&responses).zip(&amounts) {
                    begun.add(amount, response);
                    supplies[index] = amount;
                }
                begun.finish()
            }
        };
        if any_prescribed {
            for (value, level) in values.iter_mut().zip(&prescribed) {
                *value += level;
            }
            let supply = self.laplacian.apply(1.0 / heat.time, &values);
            for (index, (source, _)) in levels.iter().enumerate() {
                if let Some(vertex) = source.place().vertex(surface).filter(|&vertex| is_fixed[vertex.index()]) {
                    supplies[index] = supply[vertex.index()];
                }
            }
        }
        Ok((values, supplies))
    }

    /// The same amount of heat put in at each source. On points held at 0 it raises them by what their diagonal
    /// entry makes of it.
    fn summed(&self, heat: &Heat, sources: &[Source]) -> Result<Vec<f64>> {
        let mut supply = vec![0.0; self.surface.vertex_count()];
        for (vertex, weight) in sources.iter().flat_map(|source| source.place().support(&self.surface)) {
            supply[vertex.index()] += weight * SOURCE_HEAT;
        }
        let mut prescribed = vec![0.0; supply.len()];
        for point in (0..supply.len()).filter(|&point| self.is_held(heat, point) && supply[point] > 0.0) {
            let diagonal = self.laplacian.stiffness[self.laplacian.column(point).start];
            prescribed[point] = supply[point] / (diagonal + self.laplacian.mass[point] / heat.time);
        }
        let outflow = self.laplacian.apply(1.0 / heat.time, &prescribed);
        for (point, supply) in supply.iter_mut().enumerate() {
            *supply = if self.is_held(heat, point) { 0.0 } else { *supply - outflow[point] };
        }
        let mut values = heat.system.solve(&supply)?;
        for (value, level) in values.iter_mut().zip(&prescribed) {
            *value += level;
        }
        Ok(values)
    }

    /// Whether a point is held at 0.
    fn is_held(&self, heat: &Heat, point: usize) -> bool {
        heat.condition == Condition::Held && self.held[point]
    }

    /// Whether so many constraints cost more than factoring the matrix with their points held.
    pub(super) fn is_cheaper_to_factor(&self, system: &System, constraints: usize) -> bool {
        match (&self.solve, system) {
            (Solve::Factored(symbolic), System::Cholesky(_)) => {
                symbolic.constraint_work(constraints) > symbolic.factor_work()
            }
            // Each constraint is a solve of its own; holding points takes new grids, which is a fraction of one. A single
            // value is reached by adding a constant or by scaling.
            _ => constraints > 1,
        }
    }

    /// Numbers that kept responses may take: as many as the factor itself.
    pub(super) fn most_kept(&self, system: &System) -> usize {
        system.factor_nonzeros().max(self.surface.vertex_count())
    }
}
