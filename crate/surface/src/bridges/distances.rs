//! How far apart components are.

use std::collections::HashMap;

use super::budget::{Budget, STEPS_OF_PLACE};
use super::hierarchy::{Hierarchy, Item};
use super::scene::Scene;
use super::tolerance::Tolerance;
use super::triangles::{self, Features};
use super::visit::{Visitor, visit};

/// The distances of components that are no farther apart than they may be, the lower number first; and whether that is all, or
/// there are too many.
pub fn distances(scene: &Scene, hierarchy: &Hierarchy, tolerance: &Tolerance) -> (HashMap<[u32; 2], f64>, bool) {
    let sets = hierarchy.common(|component| tolerance.set[component as usize]);
    let visited = |budget: &Budget| {
        let mut distances = Distances { scene, tolerance, least: HashMap::new(), steps: 0 };
        let are_all = visit(hierarchy, &sets, hierarchy.blocks(), tolerance, budget, &mut distances);
        (distances.least, are_all)
    };
    Budget::spend(scene.surface.face_count(), visited)
}

struct Distances<'a> {
    scene: &'a Scene<'a>,
    tolerance: &'a Tolerance,
    least: HashMap<[u32; 2], f64>,
    /// What was looked at and kept so far, in steps of a budget.
    steps: usize,
}

impl Visitor for Distances<'_> {
    fn bound(&self, group: &[Item], component: u32, _: f64) -> Option<f64> {
        let own = group[0].component;
        let tolerance = self.tolerance.between(own, component)?;
        let pair = [own.min(component), own.max(component)];
        Some(self.least.get(&pair).copied().unwrap_or(tolerance))
    }

    fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64) {
        let Some(bound) = self.bound(group, other.component, other.longest) else { return };
        let triangles = [group[own].corners, other.corners];
        let pair = [group[own].component.min(other.component), group[own].component.max(other.component)];
        let is_known = bound <= self.scene.rounding && self.least.contains_key(&pair);
        if is_known || squared > bound * bound {
            return;
        }
        self.steps += 1;
        let does_cross = triangles::crossing(&triangles).is_some();
        let near = || triangles::nearest(&triangles, [Features::ALL; 2], bound, 0.0).map(|pair| pair.distance);
        if let Some(distance) = if does_cross { Some(0.0) } else { near() } {
            let is_new = self.least.insert(pair, distance).is_none();
            self.steps += if is_new { STEPS_OF_PLACE } else { 0 };
        }
    }

    fn steps(&self) -> usize {
        self.steps
    }
}
