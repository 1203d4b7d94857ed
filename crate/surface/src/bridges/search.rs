//! Where components pierce each other or come near.
//!
//! Each triangle looks for larger ones of other components, so that a pair of triangles is looked at once, and what is found is
//! as dense as the finer of the two. Of a component that does not pierce it, a small triangle keeps the nearest place alone;
//! what is farther away is not looked at. Large triangles tell all places that are nearly as near as the nearest one.

use std::collections::HashMap;

use super::bounds::Bounds;
use super::cells::{cell_of, list_of};
use super::hierarchy::{Below, Hierarchy, Item, LEAF, Node};
use super::scene::Scene;
use super::triangles::{self, Pair, Weights};
use crate::parallel;

/// Triangles with no side longer than this many spacings are small: one place tells where they are.
const SMALL: f64 = 2.0;

/// Places are taken twice as densely as portals are, so that what thinning leaves is about a spacing apart.
const DENSITY: f64 = 2.0;

/// A crossing that is shorter than this many spacings is one place.
const SHORT: f64 = 0.25;

/// A place of a small triangle that is nearer than another by less than this share of the spacing is none to look for, unless
/// it is pierced there.
const ENOUGH: f64 = 0.001;

/// Of places of large triangles that are in one cell, so many of which make a spacing, the nearest is enough.
const CELLS: f64 = 8.0;

/// Leaves that one thread searches at once: so few that all threads get their share of the contacts.
const LEAVES_OF_PART: usize = 64;

/// Which components may be joined. Lengths in units of the scene.
pub struct Tolerance {
    /// `#components`, the set of each: components of one set are not joined.
    pub set: Vec<u32>,
    /// `#sets`, how far apart each may be from any other.
    pub reach: Vec<f64>,
    /// The same of pairs of sets, the lower number first, where only these are joined; empty where all are.
    pub pairs: HashMap<[u32; 2], f64>,
    /// Places of a large triangle may be farther away than its nearest one by so much.
    pub slack: f64,
}

impl Tolerance {
    /// How far apart a component may be from any other.
    fn of(&self, component: u32) -> f64 {
        self.reach[self.set[component as usize] as usize]
    }

    /// How far apart places of two components may be; `None` where these are not joined however near they are.
    #[inline]
    fn between(&self, a: u32, b: u32) -> Option<f64> {
        let [a, b] = [a, b].map(|component| self.set[component as usize]);
        if a == b {
            return None;
        }
        let tolerance = self.reach[a as usize].min(self.reach[b as usize]);
        if self.pairs.is_empty() {
            return Some(tolerance);
        }
        self.pairs.get(&[a.min(b), a.max(b)]).map(|most| tolerance.min(*most))
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
    pub fn new(items: [&Item; 2], weights: Weights, gap: f64) -> Self {
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
    // Parts are dealt out in turn: where components meet, there is more to do.
    let busy = parallel::ranges(scene.surface.face_count(), scene.threads).len();
    let leaves = if busy > 1 { LEAVES_OF_PART } else { usize::MAX / LEAF };
    let dealt = parallel::map(0..busy, |first| {
        let parts = hierarchy.parts(leaves).skip(first).step_by(busy);
        let mut search = Search::new(scene, tolerance);
        let found = parts.map(|groups| {
            visit(hierarchy, groups, tolerance, &mut search);
            std::mem::take(&mut search.found)
        });
        found.collect::<Vec<_>>()
    });
    let mut dealt: Vec<_> = dealt.into_iter().map(Vec::into_iter).collect();
    let mut found = Vec::new();
    // The first thread has as many parts as any.
    for _ in 0..dealt[0].len() {
        dealt.iter_mut().for_each(|parts| found.extend(parts.next().into_iter().flatten()));
    }
    found
}

/// The distances of components that are no farther apart than they may be, the lower number first.
pub fn distances(scene: &Scene, hierarchy: &Hierarchy, tolerance: &Tolerance) -> HashMap<[u32; 2], f64> {
    let mut distances = Distances { scene, tolerance, least: HashMap::new() };
    visit(hierarchy, hierarchy.groups(), tolerance, &mut distances);
    distances.least
}

/// What is done with pairs of triangles.
trait Visitor {
    /// How near a place of a component must be to be of use to any of a group of triangles; `None` where none is.
    fn bound(&self, group: &[Item], component: u32) -> Option<f64>;

    /// Looks at a triangle of a group and a larger one. `squared`: square of the distance of their boxes.
    fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64);

    /// All triangles near this group were met.
    fn leave(&mut self) {}
}

/// Shows the triangles of each of the groups those larger ones of other components that may be near enough, the nearest boxes
/// first.
fn visit<'a>(
    hierarchy: &Hierarchy,
    groups: impl Iterator<Item = &'a [Item]>,
    tolerance: &Tolerance,
    visitor: &mut impl Visitor,
) {
    let mut waiting = Vec::new();
    for group in groups {
        let mut bounds = [Bounds::EMPTY; LEAF];
        let (mut around, mut shortest) = (Bounds::EMPTY, f64::INFINITY);
        for (item, bounds) in group.iter().zip(&mut bounds) {
            *bounds = item.bounds();
            around = around.around(*bounds);
            shortest = shortest.min(item.longest);
        }
        let most = tolerance.of(group[0].component);
        let own = Some(group[0].component);
        waiting.push((0, 0.0));
        while let Some((node, squared)) = waiting.pop() {
            let component = hierarchy.node(node).component;
            let Some(bound) = component.map_or(Some(most), |other| visitor.bound(group, other)) else { continue };
            if squared > bound * bound {
                continue;
            }
            match hierarchy.below(node) {
                Below::Items(others) => {
                    for other in others.iter().filter(|other| other.longest >= shortest) {
                        let Some(bound) = visitor.bound(group, other.component) else { continue };
                        let other_bounds = other.bounds();
                        if other_bounds.squared_distance(around) > bound * bound {
                            continue;
                        }
                        for (own, item) in group.iter().enumerate() {
                            let is_larger = other.longest > item.longest
                                || (other.longest == item.longest && other.face > item.face);
                            if is_larger {
                                visitor.meet(group, own, other, bounds[own].squared_distance(other_bounds));
                            }
                        }
                    }
                }
                Below::Nodes(children) => {
                    let [first, second] = [hierarchy.node(children[0]), hierarchy.node(children[1])];
                    let squared = [first.bounds.squared_distance(around), second.bounds.squared_distance(around)];
                    let may_hold = |node: &Node, squared: f64| {
                        squared <= most * most && node.longest >= shortest && node.component != own
                    };
                    let may_hold = [may_hold(first, squared[0]), may_hold(second, squared[1])];
                    // What is nearest is looked at first, so last in.
                    let last = usize::from(squared[0] >= squared[1]);
                    for child in [1 - last, last] {
                        if may_hold[child] {
                            waiting.push((children[child], squared[child]));
                        }
                    }
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
    fn bound(&self, group: &[Item], component: u32) -> Option<f64> {
        let own = group[0].component;
        let tolerance = self.tolerance.between(own, component)?;
        let pair = [own.min(component), own.max(component)];
        Some(self.least.get(&pair).copied().unwrap_or(tolerance))
    }

    fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64) {
        let Some(bound) = self.bound(group, other.component) else { return };
        let triangles = [group[own].corners, other.corners];
        let pair = [group[own].component.min(other.component), group[own].component.max(other.component)];
        let is_known = bound <= self.scene.rounding && self.least.contains_key(&pair);
        if is_known || squared > bound * bound {
            return;
        }
        let does_cross = triangles::crossing(&triangles).is_some();
        let near = || triangles::nearest(&triangles, bound, 0.0).map(|pair| pair.distance);
        if let Some(distance) = if does_cross { Some(0.0) } else { near() } {
            self.least.insert(pair, distance);
        }
    }
}

/// No slot.
const NONE: u32 = u32::MAX;

/// What the triangles of a group know of a component.
struct Nearest {
    component: u32,
    /// How near places must be to be of use to each.
    bounds: [f64; LEAF],
    /// The number of the nearest one, where it is the only one to be told, or [`NONE`].
    places: [u32; LEAF],
}

struct Search<'a> {
    scene: &'a Scene<'a>,
    tolerance: &'a Tolerance,
    /// `#components`, the number of each among those that are reached, or [`NONE`].
    slots: Vec<u32>,
    /// The components that any triangle of the group has met.
    reached: Vec<Nearest>,
    /// Places that triangles of the group know.
    places: Vec<Candidate>,
    found: Vec<Candidate>,
    /// Where a place of large triangles of the group was found, and its number, in lists by [`list_of`].
    cells: [Vec<(Cell, usize)>; LISTS],
    /// `#F`, what [`Scene::is_rim`] says of a face once it was asked.
    rims: Vec<Option<[bool; 3]>>,
}

/// Lists of cells; a power of two.
const LISTS: usize = 64;

/// Places that do the same for distance: of one other component, near each other, on the same sides of both surfaces.
#[derive(Clone, Copy, PartialEq)]
struct Cell {
    place: [i64; 3],
    component: u32,
    /// Signs of the normals' coordinates.
    sides: [[bool; 3]; 2],
}

impl Visitor for Search<'_> {
    #[inline]
    fn bound(&self, group: &[Item], component: u32) -> Option<f64> {
        match self.slots[component as usize] {
            NONE => self.tolerance.between(group[0].component, component),
            slot => {
                let bounds = &self.reached[slot as usize].bounds[..group.len()];
                Some(bounds.iter().fold(0.0, |most, &bound| if bound > most { bound } else { most }))
            }
        }
    }

    fn leave(&mut self) {
        self.cells.iter_mut().for_each(Vec::clear);
        for Nearest { component, places, .. } in self.reached.drain(..) {
            self.slots[component as usize] = NONE;
            let places = places.into_iter().filter(|&place| place != NONE);
            self.found.extend(places.map(|place| self.places[place as usize]));
        }
        self.places.clear();
    }

    fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64) {
        let Some(bound) = self.bound_of(group, own, other.component) else { return };
        if squared > bound * bound {
            return;
        }
        let items = [&group[own], other];
        let pair = [items[0].corners, items[1].corners];
        let normals = [items[0].normal, items[1].normal];
        let apart = triangles::plane_distance(&pair, normals);
        if apart > bound || triangles::are_apart(&pair, normals, bound) {
            return;
        }
        let components = [items[0].component, items[1].component];
        let spacing = self.scene.spacing(components);
        let is_small = items[0].longest <= SMALL * spacing;
        let crossing = if apart > 0.0 { None } else { triangles::crossing(&pair) };
        if let Some(ends) = &crossing {
            let length = triangles::point(&pair[0], ends[0][0]).distance(triangles::point(&pair[0], ends[1][0]));
            if length > SHORT * spacing {
                let cuts = (length / spacing * DENSITY).ceil() as u32;
                for cut in 0..=cuts {
                    let weights = triangles::between(ends, f64::from(cut) / f64::from(cuts));
                    self.found.push(Candidate::new(items, weights, 0.0));
                }
                if is_small {
                    self.settle(group, own, other.component, None);
                }
            } else if is_small {
                self.settle(group, own, other.component, Some(Candidate::new(items, ends[0], 0.0)));
            } else {
                self.found.push(Candidate::new(items, ends[0], 0.0));
            }
        }
        if !is_small {
            let slack = self.tolerance.slack;
            let distance = match crossing {
                Some(_) => Some(0.0),
                None if bound > slack => triangles::nearest(&pair, bound - slack, 0.0).map(|pair| pair.distance),
                None => None,
            };
            let bound = distance.map_or(bound, |distance| bound.min(distance + slack));
            self.nearest(group, other.component).bounds[own] = bound;
            // Where steep triangles cross, all that is near is near the crossing.
            if crossing.is_none() || !triangles::are_steep(normals) {
                let is_rim = [self.is_rim(items[0].face), self.is_rim(items[1].face)];
                let sides = normals.map(|normal| normal.to_array().map(|along| along > 0.0));
                let mut take = |Pair { weights, distance }: Pair| {
                    let middle =
                        0.5 * (triangles::point(&pair[0], weights[0]) + triangles::point(&pair[1], weights[1]));
                    let place = cell_of(middle * (CELLS / spacing));
                    let cell = Cell { place, component: other.component, sides };
                    self.keep(cell, Candidate::new(items, weights, distance));
                };
                triangles::spread(&pair, is_rim, bound, spacing / DENSITY, &mut take);
            }
        } else if crossing.is_none() && bound > 0.0 {
            let enough = ENOUGH * spacing;
            if let Some(Pair { weights, distance }) = triangles::nearest(&pair, bound, apart + enough) {
                let bound = (distance - enough).max(0.0);
                self.nearest(group, other.component).bounds[own] = bound;
                self.put(group, own, other.component, Candidate::new(items, weights, distance));
            }
        }
    }
}

impl<'a> Search<'a> {
    fn new(scene: &'a Scene<'a>, tolerance: &'a Tolerance) -> Self {
        Self {
            scene,
            tolerance,
            slots: vec![NONE; scene.bounds.len()],
            reached: Vec::new(),
            places: Vec::new(),
            found: Vec::new(),
            cells: std::array::from_fn(|_| Vec::new()),
            rims: vec![None; scene.surface.face_count()],
        }
    }

    /// Whether the surface ends or bends at the sides of a face.
    #[inline]
    fn is_rim(&mut self, face: u32) -> [bool; 3] {
        *self.rims[face as usize].get_or_insert_with(|| self.scene.is_rim(face))
    }

    /// To a triangle of a group, no place of a component is nearer than this one, or than what was found otherwise.
    fn settle(&mut self, group: &[Item], own: usize, component: u32, place: Option<Candidate>) {
        let nearest = self.nearest(group, component);
        let (bound, number) = (nearest.bounds[own], nearest.places[own]);
        if bound > 0.0 || self.places.get(number as usize).is_some_and(|place| place.gap > 0.0) {
            let nearest = self.nearest(group, component);
            (nearest.bounds[own], nearest.places[own]) = (0.0, NONE);
            place.into_iter().for_each(|place| self.put(group, own, component, place));
        }
    }

    /// The nearest place of a component to a triangle of a group.
    fn put(&mut self, group: &[Item], own: usize, component: u32, place: Candidate) {
        let next = self.places.len() as u32;
        let number = &mut self.nearest(group, component).places[own];
        if *number == NONE {
            *number = next;
            self.places.push(place);
        } else {
            let number = *number as usize;
            self.places[number] = place;
        }
    }

    /// How near a place of a component must be to be of use to a triangle of a group; `None` where none is.
    #[inline]
    fn bound_of(&self, group: &[Item], own: usize, component: u32) -> Option<f64> {
        match self.slots[component as usize] {
            NONE => self.tolerance.between(group[own].component, component),
            slot => Some(self.reached[slot as usize].bounds[own]),
        }
    }

    /// Keeps a place of large triangles, unless one of the same cell is as near.
    fn keep(&mut self, cell: Cell, place: Candidate) {
        let cells = &mut self.cells[list_of(cell.place, LISTS)];
        match cells.iter().find(|(other, _)| *other == cell) {
            Some(&(_, number)) if self.found[number].gap <= place.gap => {}
            Some(&(_, number)) => self.found[number] = place,
            None => {
                cells.push((cell, self.found.len()));
                self.found.push(place);
            }
        }
    }

    /// What the triangles of a group know of a component that they may be joined with.
    fn nearest(&mut self, group: &[Item], component: u32) -> &mut Nearest {
        let slot = &mut self.slots[component as usize];
        if *slot == NONE {
            *slot = self.reached.len() as u32;
            let bound = self.tolerance.between(group[0].component, component).unwrap_or(0.0);
            self.reached.push(Nearest { component, bounds: [bound; LEAF], places: [NONE; LEAF] });
        }
        &mut self.reached[*slot as usize]
    }
}
