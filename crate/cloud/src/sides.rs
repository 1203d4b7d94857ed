//! Which triangles share sides, where no side has more than two.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use glam::DVec3;
use heatwalk_base::csr::NONE;
use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;

use crate::outward::Outward;
use crate::plane::Plane;

/// Triangles of the largest patch that is left out where it touches a larger one.
const FEW: usize = 8;

/// Turns triangles so that they agree with their neighbours where all can, and each component so that it faces along the normals that are
/// known, else so that it encloses a positive volume.
/// Returns the loops of sides that one triangle has, each by its points: where several begin at one point, the next one is the first
/// counterclockwise in its plane.
pub fn orient(triangles: &mut [[u32; 3]], positions: &[DVec3], planes: &[Plane], outward: &Outward) -> Vec<Vec<u32>> {
    let mut sides = Sides::new(triangles);
    sides.orient(triangles, positions, outward);
    sides.boundary_loops(triangles, |[before, at, after], next| {
        let [from, behind, to] = [before, after, next].map(|vertex| {
            let offset = positions[vertex as usize] - positions[at as usize];
            planes[at as usize].angle(offset)
        });
        // The triangle there is on the left of its side: clockwise of where that comes from.
        let inside = (from - behind).rem_euclid(TAU);
        let ahead = (to - from).rem_euclid(TAU);
        if inside <= PI { ahead } else { TAU - ahead }
    })
}

/// The triangles without patches of a few of them that touch larger ones at points alone.
pub fn without_flaps(triangles: &[[u32; 3]], points: usize) -> Vec<[u32; 3]> {
    let (patch, count) = Sides::new(triangles).patches();
    let mut sizes = vec![0_usize; count as usize];
    patch.iter().for_each(|&patch| sizes[patch as usize] += 1);
    let size = |triangle: usize| sizes[patch[triangle] as usize];
    let mut largest = vec![0; points];
    for (triangle, corners) in triangles.iter().enumerate() {
        for &vertex in corners {
            largest[vertex as usize] = largest[vertex as usize].max(size(triangle));
        }
    }
    let mut is_flap = vec![false; count as usize];
    for (triangle, corners) in triangles.iter().enumerate() {
        let touches_larger = corners.iter().any(|&vertex| largest[vertex as usize] > size(triangle));
        is_flap[patch[triangle] as usize] |= size(triangle) <= FEW && touches_larger;
    }
    let kept = triangles.iter().zip(&patch).filter(|&(_, &patch)| !is_flap[patch as usize]);
    kept.map(|(&triangle, _)| triangle).collect()
}

/// Of side `k` of triangle `t`, from its corner `k` to the next one, at `3 t + k` the same side of the other triangle there; number
/// [`NONE`] on the boundary.
struct Sides(Vec<u32>);

impl Sides {
    fn new(triangles: &[[u32; 3]]) -> Self {
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
        for (triangle, corners) in triangles.iter().enumerate() {
            for k in 0..3 {
                let [a, b] = [corners[k], corners[(k + 1) % 3]];
                sides.push(([a.min(b), a.max(b)], (3 * triangle + k) as u32));
            }
        }
        sides.sort_unstable();
        let mut others = vec![NONE; sides.len()];
        for pair in sides.chunk_by(|a, b| a.0 == b.0) {
            if let [(_, a), (_, b)] = *pair {
                others[a as usize] = b;
                others[b as usize] = a;
            }
        }
        Self(others)
    }

    fn other(&self, side: u32) -> Option<u32> {
        Some(self.0[side as usize]).filter(|&other| other != NONE)
    }

    fn orient(&mut self, triangles: &mut [[u32; 3]], positions: &[DVec3], outward: &Outward) {
        let mut is_seen = vec![false; triangles.len()];
        let mut component = Vec::new();
        for start in 0..triangles.len() {
            if std::mem::replace(&mut is_seen[start], true) {
                continue;
            }
            component.clear();
            component.push(start as u32);
            let mut next = 0;
            while let Some(&triangle) = component.get(next) {
                next += 1;
                for side in 3 * triangle..3 * triangle + 3 {
                    let Some(other) = self.other(side) else { continue };
                    let neighbour = other / 3;
                    if std::mem::replace(&mut is_seen[neighbour as usize], true) {
                        continue;
                    }
                    if start_of(triangles, side) == start_of(triangles, other) {
                        self.flip(triangles, neighbour);
                    }
                    component.push(neighbour);
                }
            }
            let center = positions[triangles[start][0] as usize];
            let volume = |triangle: &u32| {
                let [a, b, c] = triangles[*triangle as usize].map(|vertex| positions[vertex as usize] - center);
                a.dot(b.cross(c))
            };
            let along: f64 =
                component.iter().map(|&triangle| outward.along(triangles[triangle as usize], positions)).sum();
            let outside = if along == 0.0 { component.iter().map(volume).sum() } else { along };
            if outside < 0.0 {
                component.iter().for_each(|&triangle| self.flip(triangles, triangle));
            }
        }
    }

    /// Swaps the last two corners of a triangle, and so its first side and its last.
    fn flip(&mut self, triangles: &mut [[u32; 3]], triangle: u32) {
        triangles[triangle as usize].swap(1, 2);
        let [first, last] = [3 * triangle, 3 * triangle + 2];
        self.0.swap(first as usize, last as usize);
        for side in [first, last] {
            if let Some(other) = self.other(side) {
                self.0[other as usize] = side;
            }
        }
    }

    /// `turn`: from the side of a triangle whose points are given, at its second one, how far it is to another side that begins there.
    fn boundary_loops(&self, triangles: &[[u32; 3]], turn: impl Fn([u32; 3], u32) -> f64) -> Vec<Vec<u32>> {
        let is_open = |&side: &u32| self.other(side).is_none();
        let mut open: Vec<(u32, u32)> =
            (0..self.0.len() as u32).filter(is_open).map(|side| (start_of(triangles, side), side)).collect();
        sort::sort(&mut open);
        let mut is_seen = vec![false; open.len()];
        let mut loops = Vec::new();
        // Of the points of a walk.
        let mut place_of: HashMap<u32, usize> = HashMap::new();
        for begin in 0..open.len() {
            // A walk comes back to where it began, since at each point as many open sides begin as end; but where triangles cannot agree in
            // orientation, and its rest is no loop.
            place_of.clear();
            let (mut next_open, mut walk) = (Some(begin).filter(|&begin| !is_seen[begin]), Vec::new());
            while let Some(at) = next_open {
                is_seen[at] = true;
                let (start, side) = open[at];
                place_of.insert(start, walk.len());
                walk.push(start);
                let end = start_of(triangles, next(side));
                if let Some(&closed) = place_of.get(&end) {
                    let around = walk.split_off(closed);
                    for vertex in &around {
                        place_of.remove(vertex);
                    }
                    loops.push(around);
                }
                let corners = [start, end, start_of(triangles, next(next(side)))];
                let first = open.partition_point(|&(vertex, _)| vertex < end);
                let count = open[first..].iter().take_while(|&&(vertex, _)| vertex == end).count();
                let to = |at: usize| turn(corners, start_of(triangles, next(open[at].1)));
                let choices = (first..first + count).filter(|&at| !is_seen[at]);
                next_open = choices.min_by(|&a, &b| to(a).total_cmp(&to(b)));
            }
        }
        loops
    }

    /// The number of the patch that each triangle is in: those that sides join, counted from 0.
    fn patches(&self) -> (Vec<u32>, u32) {
        let patches = UnionFind::new(self.0.len() / 3);
        for side in 0..self.0.len() as u32 {
            if let Some(other) = self.other(side) {
                patches.join(side / 3, other / 3);
            }
        }
        patches.sets()
    }
}

/// The next side of the same triangle.
fn next(side: u32) -> u32 {
    if side % 3 == 2 { side - 2 } else { side + 1 }
}

fn start_of(triangles: &[[u32; 3]], side: u32) -> u32 {
    triangles[side as usize / 3][side as usize % 3]
}
