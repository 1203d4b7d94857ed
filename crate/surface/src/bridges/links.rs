//! Links between groups that stay apart: the edges of a minimum spanning tree of the groups.
//!
//! The tree grows in rounds, in each of which every set of groups gets its nearest neighbor (Borůvka). The nearest triangles of
//! different sets are found with one hierarchy for all rounds, where boxes that hold a single set are passed over, as in March,
//! Ram & Gray, "Fast Euclidean minimum spanning tree: algorithm, analysis, and applications" (2010).

use std::collections::HashMap;

use super::bounds::Bounds;
use super::find::{OF_SCENE, contacts};
use super::hierarchy::{Below, Hierarchy, Item};
use super::scene::Scene;
use super::search::{Candidate, search};
use super::tolerance::Tolerance;
use super::triangles::{self, Features};
use super::{Bridges, Portal};
use crate::parallel;
use crate::surface::Surface;
use crate::union_find::UnionFind;

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
    /// `surface`: the one that the bridges are of.
    #[must_use]
    pub fn links(&self, surface: &Surface) -> Vec<Link> {
        if self.group_count() < 2 {
            return Vec::new();
        }
        let mut scene = Scene::new(surface, parallel::ONE);
        scene.least_spacing = SLACK;
        let hierarchy = Hierarchy::new(&scene);
        let mut places = spanning_tree(&hierarchy, &self.groups);
        if places.is_empty() {
            return Vec::new();
        }
        let pair = |components: [u32; 2]| {
            let [a, b] = components.map(|component| self.group(component));
            [a.min(b), a.max(b)]
        };
        let pairs = places.iter().map(|place| pair(place.components));
        let number: HashMap<[u32; 2], usize> = pairs.zip(0..).collect();
        let link = |place: &Candidate| Link {
            components: place.components,
            gap: scene.in_file_unit(place.gap),
            contacts: Vec::new(),
        };
        let mut links: Vec<Link> = places.iter().map(link).collect();

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
        places.extend(search(&scene, &hierarchy, &near).0);
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
        Self { is_complete: self.is_complete, ..Self::new(surface, contacts) }
    }
}

/// Between which places groups are joined to one with the least gaps, the narrowest first.
fn spanning_tree(hierarchy: &Hierarchy, group_of_component: &[u32]) -> Vec<Candidate> {
    let sets = UnionFind::new(group_of_component.len());
    let mut tree: Vec<Candidate> = Vec::new();
    loop {
        let set: Vec<u32> = group_of_component.iter().map(|&group| sets.least(group)).collect();
        let before = tree.len();
        for place in nearest_places(hierarchy, &set).into_iter().flatten() {
            let [a, b] = place.components.map(|component| group_of_component[component as usize]);
            if sets.least(a) != sets.least(b) {
                sets.join(a, b);
                tree.push(place);
            }
        }
        if tree.len() == before {
            tree.sort_by(|a, b| a.gap.total_cmp(&b.gap).then(a.components.cmp(&b.components)));
            return tree;
        }
    }
}

/// By number of a set: where it is nearest to any other. `set`: `#components`, that of each.
fn nearest_places(hierarchy: &Hierarchy, set: &[u32]) -> Vec<Option<Candidate>> {
    let mut nearest: Vec<Option<Candidate>> = vec![None; set.len()];
    let set_of_node = hierarchy.common(|component| set[component as usize]);
    let mut waiting = Vec::new();
    for group in hierarchy.groups() {
        let own = set[group[0].component as usize];
        let around = group.iter().map(|item| item.bounds).fold(Bounds::EMPTY, Bounds::around);
        waiting.push((0, 0.0));
        while let Some((node, squared)) = waiting.pop() {
            let least = nearest[own as usize].map_or(f64::INFINITY, |place| place.gap);
            if squared >= least * least || set_of_node[node] == Some(own) {
                continue;
            }
            match hierarchy.below(node) {
                Below::Items(others) => {
                    for (item, other) in group.iter().flat_map(|item| others.iter().map(move |other| (item, other))) {
                        let of_other = set[other.component as usize];
                        if of_other == own {
                            continue;
                        }
                        let least = nearest[own as usize].map_or(f64::INFINITY, |place| place.gap);
                        let Some(place) = nearer(item, other, least) else { continue };
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
                    waiting[first..].sort_unstable_by(|a, b| b.1.total_cmp(&a.1));
                }
            }
        }
    }
    nearest
}

/// Where two triangles are nearest to each other, if that is nearer than `least`.
fn nearer(item: &Item, other: &Item, least: f64) -> Option<Candidate> {
    let squared = item.bounds.squared_distance(other.bounds);
    if squared >= least * least {
        return None;
    }
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
