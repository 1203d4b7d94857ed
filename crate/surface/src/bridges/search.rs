//! Where components pierce each other or come near.
//!
//! Each triangle looks for larger ones of other components, so that a pair of triangles is looked at once, and what is found is
//! as dense as the finer of the two. Of a component that does not pierce it, a small triangle keeps the nearest place alone;
//! what is farther away is not looked at. Large triangles tell all places that are nearly as near as the nearest one.

use std::collections::HashMap;

use super::bounds::Bounds;
use super::hierarchy::{Below, Hierarchy, Item};
use super::scene::Scene;
use super::triangles::{self, Pair, Triangle, Weights};

/// Triangles with no side longer than this many spacings are small: one place tells where they are.
const SMALL: f64 = 2.0;

/// Places are taken twice as densely as portals are, so that what thinning leaves is about a spacing apart.
const DENSITY: f64 = 2.0;

/// A crossing that is shorter than this many spacings is one place.
const SHORT: f64 = 0.25;

/// Which components may be joined. Lengths in units of the scene.
pub struct Tolerance {
    /// `#components`, the set of each: components of one set are not joined.
    pub set: Vec<u32>,
    /// The diagonal of each set, and the share of it that two sets may be apart by.
    pub diagonals: Vec<f64>,
    pub share: f64,
    /// What no two sets may be apart by more than.
    pub most: f64,
    /// Places of a large triangle may be farther away than its nearest one by so much.
    pub slack: f64,
    /// The distances of pairs of components, the lower number first, where places are to be no farther apart than that and the
    /// slack; empty where distances do not matter.
    pub least: HashMap<[u32; 2], f64>,
    /// Added for rounding.
    pub rounding: f64,
}

impl Tolerance {
    /// How far apart a component may be from any other.
    fn of(&self, component: u32) -> f64 {
        let set = self.set[component as usize];
        self.most.min(self.share * self.diagonals[set as usize]) + self.rounding
    }

    /// How far apart places of two components may be; `None` where these are not joined however near they are.
    #[inline]
    fn between(&self, a: u32, b: u32) -> Option<f64> {
        if self.set[a as usize] == self.set[b as usize] {
            return None;
        }
        let tolerance = self.of(a).min(self.of(b));
        if self.least.is_empty() {
            return Some(tolerance);
        }
        self.least.get(&[a.min(b), a.max(b)]).map(|least| tolerance.min(least + self.slack))
    }
}

/// A place where two components pierce each other or are near.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    /// The lower number first.
    pub components: [u32; 2],
    /// A face of each, and a point of it.
    pub faces: [u32; 2],
    pub weights: Weights,
    /// Distance of the points in units of the scene.
    pub gap: f64,
}

impl Candidate {
    fn new(items: [&Item; 2], weights: Weights, gap: f64) -> Self {
        let (components, faces) = (items.map(|item| item.component), items.map(|item| item.face));
        let mut candidate = Self { components, faces, weights, gap };
        if components[0] > components[1] {
            candidate.components.swap(0, 1);
            candidate.faces.swap(0, 1);
            candidate.weights.swap(0, 1);
        }
        candidate
    }
}

/// All places where components are no farther apart than they may be. Of those that pierce each other, that they do.
pub fn search(scene: &Scene, hierarchy: &Hierarchy, tolerance: &Tolerance) -> Vec<Candidate> {
    let nearest_of = vec![None; scene.bounds.len()];
    let mut search = Search { scene, tolerance, nearest_of, reached: Vec::new(), found: Vec::new() };
    visit(scene, hierarchy, tolerance, &mut search);
    search.found
}

/// The distances of components that are no farther apart than they may be, the lower number first.
pub fn distances(scene: &Scene, hierarchy: &Hierarchy, tolerance: &Tolerance) -> HashMap<[u32; 2], f64> {
    let mut distances = Distances { scene, tolerance, least: HashMap::new() };
    visit(scene, hierarchy, tolerance, &mut distances);
    distances.least
}

/// What is done with pairs of triangles.
trait Visitor {
    /// How near a place of a component must be to be of use to a triangle; `None` where none is.
    fn bound(&self, item: &Item, component: u32) -> Option<f64>;

    /// Looks at two triangles, the smaller first, that with these corners and this box, which are no farther apart than the bound
    /// as far as boxes tell.
    fn meet(&mut self, items: [&Item; 2], corners: &Triangle, bounds: Bounds);

    /// All triangles near this one were met.
    fn leave(&mut self) {}
}

/// Shows each triangle those larger ones of other components that may be near enough, the nearest boxes first.
fn visit(scene: &Scene, hierarchy: &Hierarchy, tolerance: &Tolerance, visitor: &mut impl Visitor) {
    let mut waiting = Vec::new();
    for item in hierarchy.items() {
        let corners = scene.triangle(item.face);
        let bounds = Bounds::of_points(corners);
        let most = tolerance.of(item.component);
        waiting.push((0, 0.0));
        while let Some((node, squared)) = waiting.pop() {
            let component = hierarchy.node(node).component;
            let Some(bound) = component.map_or(Some(most), |other| visitor.bound(item, other)) else { continue };
            if squared > bound * bound {
                continue;
            }
            match hierarchy.below(node) {
                Below::Items(others) => {
                    for other in others {
                        if (other.longest, other.face) > (item.longest, item.face) {
                            visitor.meet([item, other], &corners, bounds);
                        }
                    }
                }
                Below::Nodes(children) => {
                    let far = |node: usize| (node, hierarchy.node(node).bounds.squared_distance(bounds));
                    let mut children = children.map(far);
                    // What is nearest is looked at first, so last in.
                    if children[0].1 < children[1].1 {
                        children.swap(0, 1);
                    }
                    let may_hold = |&(node, squared): &(usize, f64)| {
                        squared <= most * most && hierarchy.node(node).longest >= item.longest
                    };
                    waiting.extend(children.into_iter().filter(may_hold));
                }
            }
        }
        visitor.leave();
    }
}

struct Distances<'a> {
    scene: &'a Scene<'a>,
    tolerance: &'a Tolerance,
    least: HashMap<[u32; 2], f64>,
}

impl Visitor for Distances<'_> {
    fn bound(&self, item: &Item, component: u32) -> Option<f64> {
        let tolerance = self.tolerance.between(item.component, component)?;
        let pair = [item.component.min(component), item.component.max(component)];
        Some(self.least.get(&pair).copied().unwrap_or(tolerance))
    }

    fn meet(&mut self, [item, other]: [&Item; 2], corners: &Triangle, bounds: Bounds) {
        let Some(bound) = self.bound(item, other.component) else { return };
        let triangles = [*corners, self.scene.triangle(other.face)];
        let pair = [item.component.min(other.component), item.component.max(other.component)];
        let is_known = bound <= self.scene.rounding && self.least.contains_key(&pair);
        if is_known || bounds.squared_distance(Bounds::of_points(triangles[1])) > bound * bound {
            return;
        }
        let does_cross = triangles::crossing(&triangles).is_some();
        let distance = if does_cross { 0.0 } else { triangles::nearest(&triangles).distance };
        if distance <= bound {
            self.least.insert(pair, distance);
        }
    }
}

struct Search<'a> {
    scene: &'a Scene<'a>,
    tolerance: &'a Tolerance,
    /// `#components`, how near to a triangle places of each must be to be of use, once one was found, and this place if it is
    /// the only one to be told.
    nearest_of: Vec<Option<(f64, Option<Candidate>)>>,
    /// Those that have one.
    reached: Vec<u32>,
    found: Vec<Candidate>,
}

impl Visitor for Search<'_> {
    #[inline]
    fn bound(&self, item: &Item, component: u32) -> Option<f64> {
        let tolerance = self.tolerance.between(item.component, component)?;
        Some(self.nearest_of[component as usize].map_or(tolerance, |(bound, _)| bound))
    }

    fn leave(&mut self) {
        for component in self.reached.drain(..) {
            let nearest = self.nearest_of[component as usize].take();
            self.found.extend(nearest.and_then(|(_, place)| place));
        }
    }

    fn meet(&mut self, items: [&Item; 2], corners: &Triangle, bounds: Bounds) {
        let [item, other] = items;
        let Some(bound) = self.bound(item, other.component) else { return };
        let pair = [*corners, self.scene.triangle(other.face)];
        if bounds.squared_distance(Bounds::of_points(pair[1])) > bound * bound
            || triangles::plane_distance(&pair) > bound
        {
            return;
        }
        let spacing = self.scene.spacing([item.component, other.component]);
        let is_small = item.longest <= SMALL * spacing;
        let crossing = triangles::crossing(&pair);
        if let Some(ends) = &crossing {
            let length = triangles::point(&pair[0], ends[0][0]).distance(triangles::point(&pair[0], ends[1][0]));
            if length > SHORT * spacing {
                let cuts = (length / spacing * DENSITY).ceil() as u32;
                for cut in 0..=cuts {
                    let weights = triangles::between(ends, f64::from(cut) / f64::from(cuts));
                    self.found.push(Candidate::new(items, weights, 0.0));
                }
                if is_small {
                    self.keep(other.component, 0.0, None);
                }
            } else if is_small {
                self.keep(other.component, 0.0, Some(Candidate::new(items, ends[0], 0.0)));
            } else {
                self.found.push(Candidate::new(items, ends[0], 0.0));
            }
        }
        if !is_small {
            let slack = self.tolerance.slack;
            let distance = if crossing.is_some() || bound <= slack { 0.0 } else { triangles::nearest(&pair).distance };
            let bound = bound.min(distance + slack);
            self.keep(other.component, bound, None);
            // Where steep triangles cross, all that is near is near the crossing.
            if crossing.is_none() || !triangles::are_steep(&pair) {
                let found = &mut self.found;
                let mut take = |Pair { weights, distance }| found.push(Candidate::new(items, weights, distance));
                let is_rim = items.map(|item| self.scene.is_rim(item.face));
                triangles::spread(&pair, is_rim, bound, spacing / DENSITY, &mut take);
            }
        } else if crossing.is_none() && bound > self.scene.rounding {
            let Pair { weights, distance } = triangles::nearest(&pair);
            if distance <= bound {
                self.keep(other.component, distance, Some(Candidate::new(items, weights, distance)));
            }
        }
    }
}

impl Search<'_> {
    /// Keeps the nearest place of a component, of equally near ones the first, and that places must be as near as `bound`.
    fn keep(&mut self, component: u32, bound: f64, place: Option<Candidate>) {
        let nearest = &mut self.nearest_of[component as usize];
        if nearest.is_none() {
            self.reached.push(component);
        }
        if nearest.is_none_or(|(before, _)| bound < before) {
            *nearest = Some((bound, place));
        }
    }
}
