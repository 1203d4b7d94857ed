//! Where components pierce each other or come near.
//!
//! Each triangle looks for larger ones of other components, so that a pair of triangles is looked at once, and what is found is
//! as dense as the finer of the two. Of a component that does not pierce it, a small triangle keeps the nearest place alone;
//! what is farther away is not looked at. Large triangles tell all places that are near enough.
//!
//! Of the triangles that share a corner or a side, the largest one alone tells of it. What meets another of them meets that one,
//! too, and it is small only where they all are.

use heatwalk_base::parallel;

use super::budget::{Budget, STEPS_OF_PAIR, STEPS_OF_PLACE};
use super::cells::{cell_of, list_of};
use super::hierarchy::{Hierarchy, Item, LEAF};
use super::scene::{Scene, cuts};
use super::tolerance::Tolerance;
use super::triangles::{self, Features, Pair, Separation, Weights};
use super::visit::{Visitor, visit};

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

/// A large triangle has met all that matters of a component, but for what pierces it, where so many triangles of it in a row tell of
/// no place that is in another cell or nearer. Of slivers side by side hundreds may be near enough.
const TELLING_NOTHING: u8 = 8;

/// Blocks that one thread searches at once: so few that all threads get their share of the contacts.
const BLOCKS_OF_PART: usize = 4;

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

/// All places where components are no farther apart than they may be, of those that pierce each other, that they do; and whether
/// these are all. Where they are too many, each triangle tells of one place of each component, as long as it is not too much.
pub fn search(scene: &Scene, hierarchy: &Hierarchy, tolerance: &Tolerance) -> (Vec<Candidate>, bool) {
    Budget::spend(scene.surface.face_count(), |budget| search_within(scene, hierarchy, tolerance, budget))
}

fn search_within(
    scene: &Scene,
    hierarchy: &Hierarchy,
    tolerance: &Tolerance,
    budget: &Budget,
) -> (Vec<Candidate>, bool) {
    // Parts are dealt out in turn: where components meet, there is more to do.
    let busy = parallel::ranges(scene.surface.face_count(), scene.threads).len();
    let sets = hierarchy.common(|component| tolerance.set[component as usize]);
    let dealt = parallel::map(0..busy, |first| {
        let parts = hierarchy.parts(BLOCKS_OF_PART).skip(first).step_by(busy);
        let mut search = Search::new(scene, tolerance, matches!(budget, Budget::Each));
        let mut are_all = true;
        let found = parts.map(|blocks| {
            are_all &= visit(hierarchy, &sets, blocks, tolerance, budget, &mut search);
            std::mem::take(&mut search.found).chunks
        });
        (found.collect::<Vec<_>>(), are_all)
    });
    let are_all = dealt.iter().all(|&(_, are_all)| are_all);
    // What is done again is not put together.
    if !are_all && matches!(budget, Budget::Whole(_)) {
        return (Vec::new(), false);
    }
    let dealt = dealt.into_iter().map(|(parts, _)| parts);
    let mut dealt: Vec<_> = dealt.map(Vec::into_iter).collect();
    let count = dealt.iter().flat_map(|parts| parts.as_slice()).flatten().map(Vec::len).sum();
    let mut found = Vec::with_capacity(count);
    // The first thread has as many parts as any.
    for _ in 0..dealt[0].len() {
        dealt.iter_mut().for_each(|parts| found.extend(parts.next().into_iter().flatten().flatten()));
    }
    (found, are_all)
}

/// No slot.
const NONE: u32 = u32::MAX;

/// What the triangles of a group know of a component.
struct Nearest {
    component: u32,
    /// Length of the longest side of each.
    longest: [f64; LEAF],
    /// How near places must be to be of use to each.
    bounds: [f64; LEAF],
    /// The number of the nearest one, where it is the only one to be told, or [`NONE`].
    places: [u32; LEAF],
    /// How many triangles in a row told a large one nothing.
    nothing: [u8; LEAF],
}

impl Nearest {
    fn new(component: u32, bound: f64, group: &[Item]) -> Self {
        let [longest, bounds] = [[0.0; LEAF]; 2];
        let mut nearest = Self { component, longest, bounds, places: [NONE; LEAF], nothing: [0; LEAF] };
        for (own, item) in group.iter().enumerate() {
            (nearest.longest[own], nearest.bounds[own]) = (item.longest, bound);
        }
        nearest
    }

    /// The greatest bound of those with no side longer than this.
    #[inline]
    fn most(&self, longest: f64) -> f64 {
        let larger = |a: f64, b: f64| if a > b { a } else { b };
        let of = |own: usize| if self.longest[own] <= longest { self.bounds[own] } else { 0.0 };
        larger(larger(of(0), of(1)), larger(of(2), of(3)))
    }
}

struct Search<'a> {
    scene: &'a Scene<'a>,
    tolerance: &'a Tolerance,
    /// Whether one place tells where any triangle is, as if all were small.
    are_small: bool,
    /// `#components`, the number of each among those that are reached, or [`NONE`].
    slots: Vec<u32>,
    /// The components that any triangle of the group has met.
    reached: Vec<Nearest>,
    /// Places that triangles of the group know.
    places: Vec<Candidate>,
    found: Found,
    /// What was looked at and kept so far, in steps of a budget.
    steps: usize,
    /// Where a place of large triangles of the group was found, and its number, in lists by [`list_of`].
    cells: [Vec<(Cell, usize)>; LISTS],
    /// `#F`, what [`Scene::features`] says of a face once it was asked.
    features: Vec<Option<Features>>,
}

/// Places that were found, in order. They are kept in chunks: one list of all would be copied, and take three times their memory, as it
/// grows.
#[derive(Default)]
struct Found {
    /// Each full but the last one.
    chunks: Vec<Vec<Candidate>>,
}

/// Places of a chunk: as many as one copies in no time.
const CHUNK: usize = 1 << 14;

impl Found {
    fn len(&self) -> usize {
        self.chunks.last().map_or(0, |last| CHUNK * (self.chunks.len() - 1) + last.len())
    }

    fn push(&mut self, place: Candidate) {
        match self.chunks.last_mut().filter(|last| last.len() < CHUNK) {
            Some(last) => last.push(place),
            None => self.chunks.push(vec![place]),
        }
    }

    fn get_mut(&mut self, number: usize) -> &mut Candidate {
        &mut self.chunks[number / CHUNK][number % CHUNK]
    }
}

/// Lists of cells; a power of two.
const LISTS: usize = 64;

/// Cells of a list that are compared with a new one, the last first: with those of the same two triangles, and not with all where
/// a triangle meets a thousand others.
const COMPARED: usize = 64;

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
    fn bound(&self, group: &[Item], component: u32, longest: f64) -> Option<f64> {
        match self.slots[component as usize] {
            NONE => self.tolerance.between(group[0].component, component),
            slot => Some(self.reached[slot as usize].most(longest)),
        }
    }

    fn leave(&mut self) {
        self.cells.iter_mut().for_each(Vec::clear);
        for Nearest { component, places, .. } in self.reached.drain(..) {
            self.slots[component as usize] = NONE;
            let places = places.into_iter().filter(|&place| place != NONE);
            places.for_each(|place| self.found.push(self.places[place as usize]));
        }
        self.places.clear();
    }

    #[inline]
    fn steps(&self) -> usize {
        self.steps
    }

    #[inline]
    fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64) {
        let item = &group[own];
        if let Some(bound) = self.bound_of(group, own, other.component)
            && squared <= bound * bound
        {
            self.steps += 1;
            let separation = triangles::separation([&item.corners, &other.corners], [item.normal, other.normal], bound);
            if let Some(separation) = separation {
                self.look(group, own, other, bound, separation);
            }
        }
    }
}

impl<'a> Search<'a> {
    /// Looks at a triangle of a group and a larger one, whose places must be so near to be of use.
    fn look(&mut self, group: &[Item], own: usize, other: &Item, bound: f64, separation: Separation) {
        self.steps += STEPS_OF_PAIR;
        let items = [&group[own], other];
        let pair = [items[0].corners, items[1].corners];
        let normals = [items[0].normal, items[1].normal];
        let Separation { least, is_by_plane } = separation;
        let components = [items[0].component, items[1].component];
        let spacing = self.scene.spacing(components);
        let is_small = self.are_small || items[0].longest <= SMALL * spacing;
        let crossing = if is_by_plane { None } else { triangles::crossing(&pair) };
        if let Some(ends) = &crossing {
            let length = triangles::point(&pair[0], ends[0][0]).distance(triangles::point(&pair[0], ends[1][0]));
            if length > SHORT * spacing && !self.are_small {
                let cuts = cuts(length * DENSITY, spacing);
                for cut in 0..=cuts {
                    let weights = triangles::between(ends, f64::from(cut) / f64::from(cuts));
                    self.tell(Candidate::new(items, weights, 0.0));
                }
                if is_small {
                    self.settle(group, own, other.component, None);
                }
            } else if is_small {
                self.settle(group, own, other.component, Some(Candidate::new(items, ends[0], 0.0)));
            } else {
                self.tell(Candidate::new(items, ends[0], 0.0));
            }
        }
        if !is_small {
            // Where steep triangles cross, all that is near is near the crossing.
            if crossing.is_none() || !triangles::are_steep(normals) {
                let features = items.map(|item| self.features(item.face));
                let sides = normals.map(|normal| normal.to_array().map(|along| along > 0.0));
                let mut is_telling = false;
                let mut take = |Pair { weights, distance }: Pair| {
                    let middle =
                        0.5 * (triangles::point(&pair[0], weights[0]) + triangles::point(&pair[1], weights[1]));
                    let place = cell_of(middle * (CELLS / spacing));
                    let cell = Cell { place, component: other.component, sides };
                    is_telling |= self.keep(cell, Candidate::new(items, weights, distance));
                };
                let tried = triangles::spread(&pair, features, bound, spacing / DENSITY, &mut take);
                self.steps += tried;
                self.count(group, own, other.component, is_telling);
            }
        } else if crossing.is_none() && bound > 0.0 {
            let enough = ENOUGH * spacing;
            // Larger triangles that share a corner or a side with the other one are met, too.
            let features = [Features::ALL, self.features(other.face)];
            // Middles are no nearer to each other than the triangles.
            let within = bound.min(triangles::offset(&pair) + self.scene.rounding);
            if let Some(Pair { weights, distance }) = triangles::nearest(&pair, features, within, least + enough) {
                let bound = (distance - enough).max(0.0);
                self.put(group, own, other.component, bound, Candidate::new(items, weights, distance));
            }
        }
    }

    fn new(scene: &'a Scene<'a>, tolerance: &'a Tolerance, are_small: bool) -> Self {
        Self {
            scene,
            tolerance,
            are_small,
            slots: vec![NONE; scene.bounds.len()],
            reached: Vec::new(),
            places: Vec::new(),
            found: Found::default(),
            steps: 0,
            cells: std::array::from_fn(|_| Vec::new()),
            features: vec![None; scene.surface.face_count()],
        }
    }

    /// What a face tells of.
    #[inline]
    fn features(&mut self, face: u32) -> Features {
        *self.features[face as usize].get_or_insert_with(|| self.scene.features(face))
    }

    /// Notes whether a triangle of a component told a large one of a group anything.
    // Inlined, it would make the page's module larger.
    #[inline(never)]
    fn count(&mut self, group: &[Item], own: usize, component: u32, is_telling: bool) {
        if is_telling && self.slots[component as usize] == NONE {
            return;
        }
        let nearest = self.nearest(group, component);
        let nothing = &mut nearest.nothing[own];
        *nothing = if is_telling { 0 } else { nothing.saturating_add(1) };
        if *nothing == TELLING_NOTHING {
            nearest.bounds[own] = 0.0;
        }
    }

    /// To a triangle of a group, no place of a component is nearer than this one, or than what was found otherwise.
    fn settle(&mut self, group: &[Item], own: usize, component: u32, place: Option<Candidate>) {
        let nearest = self.nearest(group, component);
        let (bound, number) = (nearest.bounds[own], nearest.places[own]);
        if bound > 0.0 || self.places.get(number as usize).is_some_and(|place| place.gap > 0.0) {
            match place {
                Some(place) => self.put(group, own, component, 0.0, place),
                None => {
                    let nearest = self.nearest(group, component);
                    (nearest.bounds[own], nearest.places[own]) = (0.0, NONE);
                }
            }
        }
    }

    /// The nearest place of a component to a triangle of a group, and how near others must be.
    fn put(&mut self, group: &[Item], own: usize, component: u32, bound: f64, place: Candidate) {
        let next = self.places.len() as u32;
        let nearest = self.nearest(group, component);
        nearest.bounds[own] = bound;
        let number = &mut nearest.places[own];
        if *number == NONE {
            *number = next;
            self.steps += STEPS_OF_PLACE;
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

    /// Tells of a place.
    fn tell(&mut self, place: Candidate) {
        self.steps += STEPS_OF_PLACE;
        self.found.push(place);
    }

    /// Keeps a place of large triangles, unless one of the same cell is as near. Returns whether it was kept.
    fn keep(&mut self, cell: Cell, place: Candidate) -> bool {
        self.steps += 1;
        let cells = &mut self.cells[list_of(cell.place, LISTS)];
        match cells.iter().rev().take(COMPARED).find(|(other, _)| *other == cell) {
            Some(&(_, number)) => {
                let known = self.found.get_mut(number);
                let is_nearer = place.gap < known.gap;
                if is_nearer {
                    *known = place;
                }
                is_nearer
            }
            None => {
                cells.push((cell, self.found.len()));
                self.tell(place);
                true
            }
        }
    }

    /// What the triangles of a group know of a component that they may be joined with.
    fn nearest(&mut self, group: &[Item], component: u32) -> &mut Nearest {
        let slot = &mut self.slots[component as usize];
        if *slot == NONE {
            *slot = self.reached.len() as u32;
            let bound = self.tolerance.between(group[0].component, component).unwrap_or(0.0);
            self.reached.push(Nearest::new(component, bound, group));
        }
        &mut self.reached[*slot as usize]
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use std::collections::HashMap;

    use glam::DVec3;

    use super::super::tests::{Shape, assembled};
    use super::*;

    /// A strip of length 1 from a height on, cut across into slivers.
    fn slivers(columns: u32, low: f64) -> Shape {
        let at = |column: u32| f64::from(column) / f64::from(columns);
        let positions = (0..=columns).flat_map(|column| [low, low + 1.0].map(|y| DVec3::new(at(column), y, 0.0)));
        let triangles = (0..columns).flat_map(|column| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| 2 * column + k);
            [[a, c, b], [b, c, d]]
        });
        (positions.collect(), triangles.collect())
    }

    #[test]
    fn of_slivers_beside_slivers_each_looks_at_few_and_places_are_all_along() {
        let steps_of_triangle = [500, 4000].map(|columns| {
            let surface = assembled(&[slivers(columns, 0.0), slivers(2 * columns, 1.0 + 1e-7)]);
            let scene = Scene::new(&surface, parallel::ONE);
            let hierarchy = Hierarchy::new(&scene);
            let tolerance = Tolerance { set: vec![0, 1], reach: vec![0.003; 2], pairs: HashMap::new() };
            let sets = hierarchy.common(|component| tolerance.set[component as usize]);
            let mut search = Search::new(&scene, &tolerance, false);
            let budget = Budget::new(surface.face_count());
            assert!(visit(&hierarchy, &sets, hierarchy.blocks(), &tolerance, &budget, &mut search));
            let place =
                |candidate: &Candidate| triangles::point(&scene.triangle(candidate.faces[0]), candidate.weights[0]);
            let found = search.found.chunks.iter().flatten().filter(|candidate| candidate.gap < 1e-6);
            let mut along: Vec<f64> = found.map(|candidate| place(candidate).x).collect();
            along.sort_unstable_by(f64::total_cmp);
            let ends = [along[0], along[along.len() - 1]];
            let widest = along.windows(2).map(|places| places[1] - places[0]).fold(0.0, f64::max);
            // A cell, of the scene's unit: the diagonal.
            let cell = scene.spacing([0, 1]) / CELLS;
            assert!(
                widest < 2.0 * cell && (ends[1] - ends[0] - 5.0_f64.sqrt().recip()).abs() < 4.0 * cell,
                "{widest} {ends:?}"
            );
            search.steps / surface.face_count()
        });
        assert!(steps_of_triangle[1] < 2 * steps_of_triangle[0], "{steps_of_triangle:?}");
    }
}
