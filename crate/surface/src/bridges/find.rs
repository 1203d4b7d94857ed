//! Which components are joined.

use std::collections::HashMap;
use std::num::NonZeroUsize;

use heatwalk_base::parallel;
use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;

use super::cracks::across_cracks;
use super::distances::distances;
use super::hierarchy::Hierarchy;
use super::portals::portals;
use super::scene::Scene;
use super::search::{Candidate, search};
use super::tolerance::Tolerance;
use super::{BridgeRule, Bridges, Portal};
use crate::index::Bounds;
use crate::surface::Surface;

/// Components may be apart by this share of the diagonal of the scene; groups that are separate still, by the second one.
pub const OF_SCENE: [f64; 2] = [1e-3, 3e-3];

/// And by this share of the diagonal of the smaller one.
const OF_SMALLER: f64 = 0.05;

/// Where a distance is given, portals of a contact are wider than its narrowest place by this share of the diagonal of the
/// scene at most: of components that are far apart, hardly any place is of use.
const SLACK: f64 = 0.01;

/// No distance that is given counts for more than this share of the diagonal of the scene: time and memory grow with the
/// number of pairs of components within it.
const WIDEST: f64 = 0.05;

impl Bridges {
    /// Finds where components of a surface pierce each other, touch or come near, and the portals there.
    ///
    /// [`BridgeRule::Automatic`] joins components that pierce each other or are apart by no more than 0.1 % of the diagonal of
    /// the surface's bounding box and 5 % of that of the smaller component; then groups that are still separate, by no more
    /// than 0.3 % and 5 % of the smaller group. One larger tolerance would join what is meant to be apart.
    ///
    /// With [`BridgeRule::Within`], portals of a contact are wider than its narrowest one by no more than 1 % of the diagonal of
    /// the bounding box, and a distance of more than 5 % of that diagonal counts as 5 %: time and memory grow with the number
    /// of pairs of components within it.
    ///
    /// Portals of a contact are a mean edge of the finer component apart, but at most 0.75 % of the diagonal of the surface's
    /// bounding box. What rounding of the positions may have moved apart touches.
    ///
    /// Where boundary edges of one component run along each other, no farther apart than that and than 5 % of the longer one,
    /// portals lead across, too: such are cracks with vertices of one side inside edges of the other. Boundaries with the surface
    /// between them, as the lips of a groove, are none.
    ///
    /// Where parts meet far more often than those of an assembly do, not all contacts are looked at
    /// ([`is_complete`](Self::is_complete)): time and memory are in proportion to the faces.
    #[must_use]
    pub fn find(surface: &Surface, rule: BridgeRule) -> Self {
        Self::find_on_threads(surface, rule, parallel::ONE)
    }

    /// The same on so many threads. It makes no difference how many.
    ///
    /// # Panics
    /// Where there are no threads, as on wasm32, and more than one is asked for.
    #[must_use]
    pub fn find_on_threads(surface: &Surface, rule: BridgeRule, threads: NonZeroUsize) -> Self {
        let report = surface.report();
        if rule == BridgeRule::Off || (report.components < 2 && report.boundary_loops == 0) {
            return Self::new(surface, Vec::new());
        }
        let scene = Scene::new(surface, threads);
        let most = match rule {
            BridgeRule::Within(distance) => scene.in_scene_unit(distance.max(0.0)).min(WIDEST),
            _ => OF_SCENE[0],
        };
        let (mut found, mut is_complete) = across_cracks(&scene, most);
        if report.components > 1 {
            let (candidates, are_all) = between_components(&scene, rule, most);
            found.extend(contacts(&scene, &candidates));
            sort::sort_by_key(&mut found, |&(components, _)| components);
            is_complete &= are_all;
        }
        Self { is_complete, ..Self::new(surface, found) }
    }
}

/// Where components meet; and whether that is all. `most`: how far apart they may be where a distance is given, as a share of the
/// diagonal of the scene.
fn between_components(scene: &Scene, rule: BridgeRule, most: f64) -> (Vec<Candidate>, bool) {
    let hierarchy = Hierarchy::new(scene);
    let alone = (0..scene.bounds.len() as u32).collect();
    match rule {
        BridgeRule::Within(_) => {
            let mut within = tolerance(scene, alone, f64::INFINITY, most);
            let mut is_complete = true;
            if most > SLACK {
                // Each component is a set of its own.
                let least;
                (least, is_complete) = distances(scene, &hierarchy, &within);
                let slack = SLACK + scene.rounding;
                within.pairs = least.into_iter().map(|(pair, least)| (pair, least + slack)).collect();
            }
            // Where no component is near another, there is nothing to look for.
            if most > SLACK && within.pairs.is_empty() {
                return (Vec::new(), is_complete);
            }
            let (candidates, are_all) = search(scene, &hierarchy, &within);
            (candidates, is_complete && are_all)
        }
        _ => {
            let [near, farther] = OF_SCENE;
            let first = tolerance(scene, alone, OF_SMALLER, near);
            let (mut candidates, mut is_complete) = search(scene, &hierarchy, &first);
            let groups = groups(first.set, &candidates);
            if groups.iter().any(|&group| group != 0) {
                let second = tolerance(scene, groups, OF_SMALLER, farther);
                let (more, are_all) = search(scene, &hierarchy, &second);
                candidates.extend(more);
                is_complete &= are_all;
            }
            (candidates, is_complete)
        }
    }
}

/// Contacts between components, with the portals that are kept of their places.
pub fn contacts(scene: &Scene, found: &[Candidate]) -> Vec<([u32; 2], Vec<Portal>)> {
    // Gaps that differ by rounding alone are equal.
    let gap = |candidate: &Candidate| if candidate.gap <= scene.rounding { 0.0 } else { candidate.gap };
    let runs = || found.chunk_by(|a, b| a.components == b.components);
    let mut pairs: Vec<[u32; 2]> = runs().map(|run| run[0].components).collect();
    sort::sort(&mut pairs);
    pairs.dedup();
    // By contact, gap and place. Of numbers above 0, and of 0, the bits are in the order of the numbers.
    let mut order: Vec<u128> = Vec::with_capacity(found.len());
    for run in runs() {
        let contact = pairs.partition_point(|&pair| pair < run[0].components) as u128;
        for candidate in run {
            order.push(contact << 96 | u128::from(gap(candidate).to_bits()) << 32 | order.len() as u128);
        }
    }
    sort::sort(&mut order);
    let contacts = order.chunk_by(|a, b| a >> 96 == b >> 96);
    let own = |keys: &[u128]| keys.iter().map(|&key| &found[key as u32 as usize]).collect::<Vec<_>>();
    contacts.map(own).map(|own| (own[0].components, portals(scene, &own))).collect()
}

/// How far apart sets of components may be, given as shares of the diagonals of the smaller one and of the scene.
fn tolerance(scene: &Scene, set: Vec<u32>, share: f64, most: f64) -> Tolerance {
    let mut bounds = vec![Bounds::EMPTY; set.len()];
    for (&set, &own) in set.iter().zip(&scene.bounds) {
        bounds[set as usize] = bounds[set as usize].around(own);
    }
    let rounding = scene.rounding;
    let reach = bounds.into_iter().map(|bounds| most.min(share * bounds.size().length()) + rounding).collect();
    Tolerance { set, reach, pairs: HashMap::new() }
}

/// The sets that become one by what was found, each named by its least one.
fn groups(sets: Vec<u32>, found: &[Candidate]) -> Vec<u32> {
    let joined = UnionFind::new(sets.len());
    for run in found.chunk_by(|a, b| a.components == b.components) {
        joined.join(run[0].components[0], run[0].components[1]);
    }
    sets.into_iter().map(|set| joined.least(set)).collect()
}
