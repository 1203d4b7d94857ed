//! Links between groups that stay apart: the edges of a minimum spanning tree of the groups.
//!
//! The tree grows in rounds, in each of which every set of groups gets its nearest neighbor (Borůvka). The nearest triangles of
//! different sets are found with one hierarchy for all rounds, where boxes that hold a single set are passed over, as in March,
//! Ram & Gray, "Fast Euclidean minimum spanning tree: algorithm, analysis, and applications" (2010).

use std::collections::HashMap;

use heatwalk_base::parallel;
use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;

use super::budget::{Budget, STEPS_OF_PAIR};
use super::find::{OF_SCENE, contacts};
use super::hierarchy::{Hierarchy, Item};
use super::scene::Scene;
use super::search::{Candidate, search};
use super::tolerance::Tolerance;
use super::triangles::{self, Features};
use super::{Bridges, Portal};
use crate::index::{Below, Bounds};
use crate::surface::Surface;

#[cfg(test)]
mod tests;

/// Portals of a link are wider than its narrowest place by this share of the diagonal of the scene at most, as much as
/// components that touch may be apart. Nearer to each other than that they are of no use, however fine the components are.
const SLACK: f64 = OF_SCENE[0];

/// Where two groups of components that stay apart are nearest to each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// A component of each group, the two that are nearest, the lower number first.
    pub components: [u32; 2],
    /// Least distance of the groups in space, in the file's unit.
    pub gap: f64,
    /// Whether all was looked at that may be nearer, or else too much is near for any link to be known for the narrowest.
    pub is_complete: bool,
    /// The portals, by pairs of components of the two groups.
    pub(super) contacts: Vec<([u32; 2], Vec<Portal>)>,
}

impl Bridges {
    /// What would join the groups that these bridges leave apart, the narrowest gap first: one link less than there are groups.
    ///
    /// They are the edges of the minimum spanning tree of the groups, so the first `n` of them join the `n` nearest pairs, one
    /// after the other, without a pair that others have joined already (Kruskal's order); and the first one that leads out of a
    /// set of groups leads to the group that is nearest to that set. A link crosses only where its groups are nearest to each
    /// other: over its gap, and where they are farther apart by no more than 0.1 % of the diagonal of the surface's bounding box.
    ///
    /// Where that takes too long, since triangles of the groups are near each other by the thousand, gaps may be wider than the
    /// least ([`Link::is_complete`]): time and memory are in proportion to the faces.
    ///
    /// `surface`: the one that the bridges are of.
    #[must_use]
    pub fn links(&self, surface: &Surface) -> Vec<Link> {
        if self.group_count() < 2 {
            return Vec::new();
        }
        let mut scene = Scene::new(surface, parallel::ONE);
        scene.least_spacing = SLACK;
        let hierarchy = Hierarchy::new(&scene);
        let tree = |budget: &Budget| spanning_tree(&hierarchy, &self.groups, budget);
        let (mut places, mut is_complete) = Budget::spend(surface.face_count(), tree);
        if places.is_empty() {
            return Vec::new();
        }
        let pair = |components: [u32; 2]| {
            let [a, b] = components.map(|component| self.group(component));
            [a.min(b), a.max(b)]
        };
        let pairs = places.iter().map(|place| pair(place.components));
        let number: HashMap<[u32; 2], usize> = pairs.zip(0..).collect();
        let slack = SLACK + scene.rounding;
        let mut near =
            Tolerance { set: self.groups.clone(), reach: vec![0.0; self.group_count()], pairs: HashMap::new() };
        for place in &places {
            let groups = pair(place.components);
            near.pairs.insert(groups, place.gap + slack);
            for group in groups {
                near.reach[group as usize] = near.reach[group as usize].max(place.gap + slack);
            }
        }
        // The search looks for the nearest places no further than they matter; the tree knows them.
        let (around, are_all) = search(&scene, &hierarchy, &near);
        is_complete &= are_all;
        let link = |place: &Candidate| Link {
            components: place.components,
            gap: scene.in_file_unit(place.gap),
            is_complete,
            contacts: Vec::new(),
        };
        let mut links: Vec<Link> = places.iter().map(link).collect();
        places.extend(around);
        for contact in contacts(&scene, &places) {
            links[number[&pair(contact.0)]].contacts.push(contact);
        }
        links
    }

    /// These bridges, and links between their groups.
    ///
    /// `surface`: the one that all are of.
    #[must_use]
    pub fn linked(&self, surface: &Surface, links: &[Link]) -> Self {
        let portals = |first: u32, count: u32| self.portals[first as usize..][..count as usize].to_vec();
        let own = self.contacts.iter().map(|contact| (contact.components, portals(contact.first, contact.count)));
        let contacts = own.chain(links.iter().flat_map(|link| link.contacts.iter().cloned())).collect();
        let is_complete = self.is_complete && links.iter().all(|link| link.is_complete);
        Self { is_complete, ..Self::new(surface, contacts) }
    }
}

/// Between which places groups are joined to one with the least gaps, the narrowest first; and whether these are the least.
fn spanning_tree(hierarchy: &Hierarchy, group_of_component: &[u32], budget: &Budget) -> (Vec<Candidate>, bool) {
    let sets = UnionFind::new(group_of_component.len());
    let mut tree: Vec<Candidate> = Vec::new();
    let mut are_least = true;
    loop {
        let set: Vec<u32> = group_of_component.iter().map(|&group| sets.least(group)).collect();
        let before = tree.len();
        let (nearest, are_nearest) = nearest_places(hierarchy, &set, budget);
        are_least &= are_nearest;
        for place in nearest.into_iter().flatten() {
            let [a, b] = place.components.map(|component| group_of_component[component as usize]);
            if sets.least(a) != sets.least(b) {
                sets.join(a, b);
                tree.push(place);
            }
        }
        if tree.len() == before {
            sort::sort_by(&mut tree, |a, b| a.gap.total_cmp(&b.gap).then(a.components.cmp(&b.components)));
            return (tree, are_least);
        }
    }
}

/// By number of a set: where it is nearest to any other; and whether the budget was enough to know. Each set has a place even
/// where it was not: what is nearest by boxes is looked at first. `set`: `#components`, that of each.
fn nearest_places(hierarchy: &Hierarchy, set: &[u32], budget: &Budget) -> (Vec<Option<Candidate>>, bool) {
    let mut nearest: Vec<Option<Candidate>> = vec![None; set.len()];
    let set_of_node = hierarchy.common(|component| set[component as usize]);
    let (mut waiting, mut are_nearest) = (Vec::new(), true);
    for group in hierarchy.groups() {
        let own = set[group[0].component as usize];
        let around = group.iter().map(|item| item.bounds).fold(Bounds::EMPTY, Bounds::around);
        waiting.push((0, 0.0));
        let (most, mut steps) = (budget.of_group(), 0);
        while let Some((node, squared)) = waiting.pop() {
            steps += 1;
            if steps > most {
                waiting.clear();
                continue;
            }
            let least = nearest[own as usize].map_or(f64::INFINITY, |place| place.gap);
            if squared >= least * least || set_of_node[node] == Some(own) {
                continue;
            }
            match hierarchy.below(node) {
                Below::Items(leaf) => {
                    let others = hierarchy.items(leaf);
                    for (item, other) in group.iter().flat_map(|item| others.iter().map(move |other| (item, other))) {
                        let of_other = set[other.component as usize];
                        if of_other == own {
                            continue;
                        }
                        let least = nearest[own as usize].map_or(f64::INFINITY, |place| place.gap);
                        let squared = item.bounds.squared_distance(other.bounds);
                        if squared >= least * least {
                            continue;
                        }
                        steps += STEPS_OF_PAIR;
                        let Some(place) = nearer(item, other, squared, least) else { continue };
                        for set in [own, of_other] {
                            let known = &mut nearest[set as usize];
                            if known.is_none_or(|known| place.gap < known.gap) {
                                *known = Some(place);
                            }
                        }
                    }
                }
                Below::Nodes(children) => {
                    let first = waiting.len();
                    waiting.extend(children.zip(hierarchy.boxes(node).squared_distances(around)));
                    // What is nearest is looked at first, so last in.
                    sort::sort_by(&mut waiting[first..], |a, b| b.1.total_cmp(&a.1));
                }
            }
        }
        are_nearest &= budget.take(steps);
    }
    (nearest, are_nearest)
}

/// Where two triangles are nearest to each other, if that is nearer than `least`. `squared`: square of the distance
/// of their boxes.
fn nearer(item: &Item, other: &Item, squared: f64, least: f64) -> Option<Candidate> {
    let pair = [item.corners, other.corners];
    triangles::separation([&item.corners, &other.corners], [item.normal, other.normal], least)?;
    if squared == 0.0
        && let Some([weights, _]) = triangles::crossing(&pair)
    {
        return Some(Candidate::new([item, other], weights, 0.0));
    }
    let nearest =
        triangles::nearest(&pair, [Features::ALL; 2], least, 0.0).filter(|nearest| nearest.distance < least)?;
    Some(Candidate::new([item, other], nearest.weights, nearest.distance))
}
