//! The portals of a contact: few of the places that were found, but everywhere.

use glam::DVec3;

use super::Portal;
use super::cells::{cell_of, list_of};
use super::scene::Scene;
use super::search::Candidate;
use super::triangles;
use crate::element::FaceId;
use crate::point::Place;

/// Faces whose normals have less than this cosine look away from each other: the two sides of a plate. However near they are,
/// a portal on one of them leads to nowhere on the other.
const OPPOSITE: f64 = -0.5;

/// Portals that are nearer to each other than this share of the spacing are the same.
const SAME: f64 = 0.05;

/// A contact has so many portals, where there are places for them.
const LEAST: usize = 3;

/// What tells two candidates of a contact apart.
#[derive(Clone, Copy)]
struct Spot {
    point: DVec3,
    /// Of the faces of both components.
    normals: [DVec3; 2],
    gap: f64,
}

impl Spot {
    fn new(scene: &Scene, candidate: &Candidate) -> Self {
        let corners = candidate.faces.map(|face| scene.triangle(face));
        let [first, second] = [0, 1].map(|of| triangles::point(&corners[of], candidate.weights[of]));
        let normals = candidate.faces.map(|face| scene.normal(face));
        Self { point: 0.5 * (first + second), normals, gap: candidate.gap }
    }

    /// Whether a portal at the one does what one at the other would.
    fn stands_for(&self, other: &Self, spacing: f64) -> bool {
        let is_same_side = |of: usize| self.normals[of].dot(other.normals[of]) > OPPOSITE;
        self.point.distance_squared(other.point) < spacing * spacing && is_same_side(0) && is_same_side(1)
    }
}

/// The portals of one contact. The candidates come in order of their gaps.
pub fn portals(scene: &Scene, candidates: &[&Candidate]) -> Vec<Portal> {
    let spots: Vec<Spot> = candidates.iter().map(|candidate| Spot::new(scene, candidate)).collect();
    let spacing = scene.spacing(candidates[0].components);
    thinned(&spots, spacing).into_iter().map(|index| portal(scene, candidates[index])).collect()
}

/// A portal at a candidate.
fn portal(scene: &Scene, candidate: &Candidate) -> Portal {
    let end = |of: usize| {
        let weights = candidate.weights[of].map(|weight| weight.max(0.0));
        let sum: f64 = weights.iter().sum();
        let weights = weights.map(|weight| weight / sum);
        Place::Face { face: FaceId(candidate.faces[of]), weights }.snapped(scene.surface)
    };
    let ends = [end(0), end(1)];
    let gap = scene.in_file_unit(scene.point(ends[0]).distance(scene.point(ends[1])));
    Portal { ends, gap }
}

/// The numbers of the spots that are kept: the first one, the ends of the places that are as near as it, and whatever none of
/// those kept before stands for, in order; more where these are too few. The spots come in order of their gaps.
fn thinned(spots: &[Spot], spacing: f64) -> Vec<usize> {
    let nearest = spots.partition_point(|spot| spot.gap <= spots[0].gap + SAME * spacing);
    let mut kept = vec![0];
    if let Some(end) = farthest(&spots[..nearest], &[0], SAME * spacing) {
        kept.push(end);
        // The farthest from one end is the other; the first one may be it.
        kept.extend(farthest(&spots[..nearest], &[end], SAME * spacing).filter(|&other| other != 0));
    }
    let mut grid = Grid::new(spots, spacing);
    for &index in &kept {
        grid.insert(index);
    }
    for index in 0..spots.len() {
        if !grid.has_one_for(index) {
            grid.insert(index);
            kept.push(index);
        }
    }
    while kept.len() < LEAST {
        let Some(more) = farthest(spots, &kept, SAME * spacing) else { break };
        kept.push(more);
    }
    kept
}

/// The number of the spot that is farthest from those kept, if it is farther than this; of equally far ones the first.
fn farthest(spots: &[Spot], kept: &[usize], least: f64) -> Option<usize> {
    let squared = |spot: &Spot| {
        let to_kept = kept.iter().map(|&other| spot.point.distance_squared(spots[other].point));
        to_kept.fold(f64::INFINITY, f64::min)
    };
    let farther = |a: (usize, f64), b: (usize, f64)| if b.1 > a.1 { b } else { a };
    let (index, squared) = spots.iter().map(squared).enumerate().reduce(farther)?;
    (squared > least * least).then_some(index)
}

/// No spot.
const NONE: u32 = u32::MAX;

/// Kept spots by cells twice as large as the spacing, in lists that cells share: what is within the spacing of a spot is in its
/// cell or in those beyond the sides, edges and corner that it is nearest to.
struct Grid<'a> {
    spots: &'a [Spot],
    spacing: f64,
    /// The last spot of each list; a power of two of them.
    last: Vec<u32>,
    /// `#spots`, the one before each in its list.
    before: Vec<u32>,
}

impl<'a> Grid<'a> {
    fn new(spots: &'a [Spot], spacing: f64) -> Self {
        let last = vec![NONE; spots.len().next_power_of_two()];
        Self { spots, spacing, last, before: vec![NONE; spots.len()] }
    }

    /// Where a spot is, in cells.
    fn place(&self, index: usize) -> DVec3 {
        self.spots[index].point / (2.0 * self.spacing)
    }

    fn list(&self, cell: [i64; 3]) -> usize {
        list_of(cell, self.last.len())
    }

    fn insert(&mut self, index: usize) {
        let list = self.list(cell_of(self.place(index)));
        self.before[index] = std::mem::replace(&mut self.last[list], index as u32);
    }

    fn has_one_for(&self, index: usize) -> bool {
        let place = self.place(index);
        let cell = cell_of(place);
        let beyond = [0, 1, 2].map(|axis| if place[axis] - (cell[axis] as f64) < 0.5 { -1 } else { 1 });
        let kept = |&index: &u32| index != NONE;
        let mut around = (0..8).map(|which| [0, 1, 2].map(|axis| cell[axis] + (which >> axis & 1) * beyond[axis]));
        around.any(|cell| {
            let last = Some(self.last[self.list(cell)]).filter(kept);
            let mut others = std::iter::successors(last, |&other| Some(self.before[other as usize]).filter(kept));
            others.any(|other| self.spots[other as usize].stands_for(&self.spots[index], self.spacing))
        })
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use rand::{RngExt, SeedableRng};
    use rand_xoshiro::SplitMix64;

    use super::*;

    #[test]
    fn spots_that_no_kept_one_stands_for_are_kept_and_no_others() {
        const SPACING: f64 = 0.07;
        let mut random = SplitMix64::seed_from_u64(5);
        let mut random = || random.random_range(-0.5..0.5);
        let spots: Vec<Spot> = (0..3000)
            .map(|number| {
                let normals = [DVec3::Z, if random() > 0.0 { DVec3::Z } else { -DVec3::Z }];
                Spot { point: DVec3::new(random(), random(), 0.3 * random()), normals, gap: f64::from(number) }
            })
            .collect();
        let stands_for_one =
            |kept: &[usize], spot: &Spot| kept.iter().any(|&other| spots[other].stands_for(spot, SPACING));
        let mut expected = Vec::new();
        for (index, spot) in spots.iter().enumerate() {
            if !stands_for_one(&expected, spot) {
                expected.push(index);
            }
        }
        assert!(expected.len() > 300, "{}", expected.len());
        assert_eq!(thinned(&spots, SPACING), expected);
    }
}
