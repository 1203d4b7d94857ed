//! Distance from its gradient: the Poisson equation, with the distance known at some places of each piece.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::error::Result;
use crate::heat::HeatSolver;
use crate::heat::near::Near;
use crate::options::MultiSource;
use heatwalk_sparse::{Functional, SchurColumn, SchurComplement, System, evaluate};
use heatwalk_surface::Source;
use heatwalk_surface::union_find::UnionFind;

/// Added to every entry of the Gram matrix of constraints whose amounts sum to 0, which it does not change: a
/// constraint at the pinned point alone has a response of 0 and would not be seen.
const GRAM_SHIFT: f64 = 1.0;

/// A place where the solution is known: a weighted mean of points with its value.
pub(super) struct Known {
    functional: Functional,
    value: f64,
    component: u32,
}

impl HeatSolver {
    /// What is known of the distance: on the rim of each patch of the near field the mean of the exact distances, and
    /// the starting values of sources that no patch contains. `mixed` are the triangles of which some corners are
    /// near, with whether all are.
    pub(super) fn known(&self, near: &Near<'_>, mixed: &[([u32; 3], bool)], sources: &[Source]) -> Vec<Known> {
        let mut patches = UnionFind::new(self.surface.vertex_count());
        let mut rim: Vec<(u32, f64)> = Vec::new();
        for &(face, whole) in mixed {
            if whole {
                patches.join(face[0], face[1]);
                patches.join(face[1], face[2]);
            } else {
                rim.extend(face.into_iter().filter_map(|point| Some((point, near.at(point)?))));
            }
        }
        // A patch that covers its whole piece has no rim, and nothing there is left to be known.
        rim.sort_unstable_by_key(|&(point, _)| point);
        rim.dedup_by_key(|&mut (point, _)| point);
        let mut rims: BTreeMap<u32, Vec<(u32, f64)>> = BTreeMap::new();
        for (point, value) in rim {
            rims.entry(patches.least(point)).or_default().push((point, value));
        }
        let component = |point: u32| self.surface.components().as_slice()[point as usize];
        let mut known: Vec<Known> = rims
            .into_values()
            .map(|rim| {
                let weight = 1.0 / rim.len() as f64;
                Known {
                    component: component(rim[0].0),
                    functional: rim.iter().map(|&(point, _)| (point, weight)).collect(),
                    value: rim.iter().map(|&(_, value)| weight * value).sum(),
                }
            })
            .collect();
        for source in sources {
            let support = source.place().support(&self.surface);
            let functional: Functional = support.map(|(vertex, weight)| (vertex.0, weight)).collect();
            if !functional.iter().all(|&(point, _)| near.at(point).is_some()) {
                known.push(Known {
                    component: component(functional[0].0),
                    functional,
                    value: source.initial_distance(),
                });
            }
        }
        known
    }

    /// The solution of `L φ = right` (`#P`, sums to 0 on each piece) with what is known of it.
    pub(super) fn poisson(&self, right: Vec<f64>, near: &Near<'_>, known: &[Known]) -> Result<Vec<f64>> {
        let is_exact = self.parameters.sources == MultiSource::Exact;
        if is_exact && self.is_cheaper_to_factor(&self.poisson, known.len()) {
            let fixed = self.fixed_by(near, known);
            let mut is_fixed = vec![false; self.surface.vertex_count()];
            for &point in fixed.values.keys() {
                is_fixed[point as usize] = true;
            }
            let matrix = self.laplacian.combine(0.0, |point| is_fixed[point]);
            let system = self.solve.system(matrix, "Poisson")?;
            let wanted = self.wanted(known, &fixed);
            let responses = system.schur_columns(&functionals(&wanted))?;
            return self.joined(&system, right, &fixed, &wanted, &responses);
        }
        let fixed = self.pins();
        let wanted = self.wanted(known, &fixed);
        if is_exact && wanted.values().any(|wanted| wanted.len() > 1) {
            let functionals = functionals(&wanted);
            let responses = {
                let mut kept = self.poisson_responses.lock().expect("no holder of the lock panics");
                kept.columns(&self.poisson, &functionals, self.most_kept(&self.poisson))?
            };
            return self.joined(&self.poisson, right, &fixed, &wanted, &responses);
        }
        let mut values = self.poisson.solve(&self.freed(right, &fixed))?;
        let mut constants = vec![0.0; self.pinned.len()];
        for (&component, wanted) in &wanted {
            let missing = wanted.iter().map(|wanted| wanted.value - evaluate(&wanted.functional, &values));
            constants[component as usize] = missing.sum::<f64>() / wanted.len() as f64;
        }
        self.complete(&mut values, &fixed, &constants);
        Ok(values)
    }

    /// The solution that has every wanted value, by one solve and the amounts that the constraints need.
    fn joined(
        &self,
        system: &System,
        right: Vec<f64>,
        fixed: &Fixed,
        wanted: &BTreeMap<u32, Vec<Wanted>>,
        responses: &[Arc<SchurColumn>],
    ) -> Result<Vec<f64>> {
        let mut begun = system.partial_solve(&self.freed(right, fixed))?;
        let mut constants = vec![0.0; self.pinned.len()];
        let mut responses = responses;
        for (&component, wanted) in wanted {
            let (own, others) = responses.split_at(wanted.len());
            responses = others;
            let floats = fixed.floats[component as usize];
            let missing: Vec<f64> =
                wanted.iter().zip(own).map(|(wanted, response)| wanted.value - begun.evaluate(response)).collect();
            let gram = SchurComplement::new(own, if floats { GRAM_SHIFT } else { 0.0 });
            let mut amounts = gram.solve(&missing);
            if floats {
                // The constant is free, so the amounts sum to 0.
                let ones = gram.solve(&vec![1.0; own.len()]);
                let constant = amounts.iter().sum::<f64>() / ones.iter().sum::<f64>();
                for (amount, one) in amounts.iter_mut().zip(&ones) {
                    *amount -= constant * one;
                }
                constants[component as usize] = constant;
            }
            for (&amount, response) in amounts.iter().zip(own) {
                begun.add(amount, response);
            }
        }
        let mut values = begun.finish();
        self.complete(&mut values, fixed, &constants);
        Ok(values)
    }

    /// One point held at 0 on each piece.
    fn pins(&self) -> Fixed {
        let values = self.pinned.iter().map(|&point| (point, 0.0)).collect();
        Fixed { values, floats: vec![true; self.pinned.len()] }
    }

    /// The near field and sources at vertices held, and the pin of each piece that has none of these.
    fn fixed_by(&self, near: &Near<'_>, known: &[Known]) -> Fixed {
        let mut values: BTreeMap<u32, f64> = near.points().collect();
        for known in known {
            if let [(point, _)] = known.functional[..] {
                let value = values.entry(point).or_insert(known.value);
                *value = value.min(known.value);
            }
        }
        let mut floats = vec![true; self.pinned.len()];
        for &point in values.keys() {
            floats[self.surface.components().as_slice()[point as usize] as usize] = false;
        }
        let floating = self.pinned.iter().zip(&floats).filter(|&(_, &floats)| floats);
        values.extend(floating.map(|(&point, _)| (point, 0.0)));
        Fixed { values, floats }
    }

    /// What is wanted of the free points, by component. A piece that floats needs even what is known of its pin alone.
    fn wanted(&self, known: &[Known], fixed: &Fixed) -> BTreeMap<u32, Vec<Wanted>> {
        let mut wanted: BTreeMap<u32, Vec<Wanted>> = BTreeMap::new();
        for Known { functional, value, component } in known {
            let given = |point: u32| fixed.values.get(&point).copied();
            let free: Functional = functional.iter().copied().filter(|&(point, _)| given(point).is_none()).collect();
            if fixed.floats[*component as usize] || !free.is_empty() {
                let given: f64 = functional.iter().filter_map(|&(point, weight)| Some(weight * given(point)?)).sum();
                wanted.entry(*component).or_default().push(Wanted { functional: free, value: value - given });
            }
        }
        wanted
    }

    /// The right side of the free points when the fixed ones have their values.
    fn freed(&self, mut right: Vec<f64>, fixed: &Fixed) -> Vec<f64> {
        if fixed.values.values().any(|&value| value != 0.0) {
            let mut prescribed = vec![0.0; right.len()];
            for (&point, &value) in &fixed.values {
                prescribed[point as usize] = value;
            }
            for (right, outflow) in right.iter_mut().zip(self.laplacian.apply(0.0, &prescribed)) {
                *right -= outflow;
            }
        }
        for &point in fixed.values.keys() {
            right[point as usize] = 0.0;
        }
        right
    }

    /// Adds the fixed values and the constants of pieces that float.
    fn complete(&self, values: &mut [f64], fixed: &Fixed, constants: &[f64]) {
        for (value, &component) in values.iter_mut().zip(self.surface.components()) {
            *value += constants[component as usize];
        }
        for (&point, &value) in &fixed.values {
            values[point as usize] += value;
        }
    }
}

/// Values at which points are held while the others are solved for.
struct Fixed {
    /// By point.
    values: BTreeMap<u32, f64>,
    /// Per component whether it is held at its pin only, so that a constant is still free.
    floats: Vec<bool>,
}

/// What the solution of a system shall have: a weighted sum of free points with its value.
struct Wanted {
    functional: Functional,
    value: f64,
}

fn functionals(wanted: &BTreeMap<u32, Vec<Wanted>>) -> Vec<Functional> {
    wanted.values().flatten().map(|wanted| wanted.functional.clone()).collect()
}
