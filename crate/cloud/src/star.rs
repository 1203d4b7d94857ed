//! The triangles around a point in the Delaunay triangulation of its neighbours in the tangent plane: the corners of its Voronoi cell, which
//! is clipped by the bisectors to one neighbour after the other until none farther away can reach it (Lévy and Bonneel, "Variational
//! anisotropic surface meshing with Voronoi parallel linear enumeration", 2012).

use std::num::NonZeroUsize;

use glam::{DVec2, DVec3};

use crate::neighbours::{Near, Neighbours};
use crate::outward::Outward;
use crate::plane::{Plane, STEEPEST};

/// Neighbours that planes are made of, as in Sharp and Crane (2020).
const NEIGHBOURS: NonZeroUsize = NonZeroUsize::new(30).expect("not 0");
/// Neighbours that are asked for at most, where points lie unevenly and the nearest ones are all on one side.
const MOST_NEIGHBOURS: NonZeroUsize = NonZeroUsize::new(120).expect("not 0");
/// Weights of neighbours fall off over so many spacings, for the planes to choose from: few leave out what is on another sheet, many even
/// out noise.
const FALL_OFFS: [f64; 3] = [1.2, 0.8, 2.0];
/// No further plane is tried where triangles are all there and turn so little, all in all, as 1 less cosines.
const SMOOTH: f64 = 0.15;
/// What a missing triangle counts for, as an angle between two does by 1 less its cosine: less than a right angle, by which points at the
/// end of a sheet would be joined to another one.
const MISSING: f64 = 0.6;
/// What a radius of a spacing of the largest circle around a triangle counts for.
const WIDTH: f64 = 0.5;
/// Rounds in which the plane becomes that of the triangles found in it.
const ROUNDS: usize = 2;
/// Most radius of the circle around a triangle, in spacings: what is left open beyond is a hole.
const WIDEST: f64 = 3.0;
/// A corner of the cell, and the neighbour whose bisector is on the way to the next one; none on the border.
#[derive(Clone, Copy)]
struct Corner {
    at: DVec2,
    beside: Option<u32>,
}

/// Memory of the stars of one thread.
#[derive(Default)]
pub struct Stars {
    near: Vec<Near>,
    offsets: Vec<DVec3>,
    cell: Vec<Corner>,
    clipped: Vec<Corner>,
}

impl Stars {
    /// The plane at a point, and the triangles around it, each by its two other corners in their order around the normal: of several planes
    /// that in which the triangles are most like one sheet. None where all neighbours lie on a line.
    pub fn around(
        &mut self,
        neighbours: &Neighbours,
        positions: &[DVec3],
        outward: &Outward,
        point: u32,
    ) -> Option<(Plane, Vec<[u32; 2]>)> {
        let place = positions[point as usize];
        let mut count = NEIGHBOURS;
        loop {
            neighbours.nearest(place, count.saturating_add(1), &mut self.near);
            let is_all = count >= MOST_NEIGHBOURS || self.near.len() <= count.get();
            self.near.retain(|&(_, other)| other != point && outward.is_same_side(point, other));
            self.offsets.clear();
            self.offsets.extend(self.near.iter().map(|&(_, other)| positions[other as usize] - place));
            let mut best: Option<(f64, bool, Plane, Vec<[u32; 2]>)> = None;
            for fall_off in [None].into_iter().chain(FALL_OFFS.map(Some)) {
                let nearest = &self.offsets[..self.offsets.len().min(NEIGHBOURS.get())];
                let plane = match fall_off {
                    None => outward.normal(point).and_then(|normal| Plane::square_to(normal, nearest)),
                    Some(fall_off) => Plane::of(nearest, fall_off),
                };
                let Some(mut plane) = plane else { continue };
                let mut is_final = self.clip(&plane);
                for _ in 0..ROUNDS {
                    let Some(better) = self.refined(&plane, positions, place) else { break };
                    plane = better;
                    is_final = self.clip(&plane);
                }
                let ([turns, width], triangles) = self.triangles(&plane, positions, place);
                if best.as_ref().is_none_or(|best| turns + width < best.0) {
                    best = Some((turns + width, is_final, plane, triangles));
                }
                if is_final && turns < SMOOTH {
                    break;
                }
            }
            match best {
                Some((_, is_final, plane, triangles)) if is_final || is_all => return Some((plane, triangles)),
                None if is_all => return None,
                _ => count = MOST_NEIGHBOURS,
            }
        }
    }

    /// The triangles of the cell, and how far they are from one sheet: the sum of 1 less the cosine between each and the next one, with
    /// a constant for each that is missing, and what the widest counts for.
    fn triangles(&self, plane: &Plane, positions: &[DVec3], place: DVec3) -> ([f64; 2], Vec<[u32; 2]>) {
        let widest = (WIDEST * plane.spacing).powi(2);
        let normal = |triangle: [u32; 2]| {
            let [a, b] = triangle.map(|other| positions[other as usize] - place);
            a.cross(b).normalize_or_zero()
        };
        let corners = self.cell.iter().zip(self.cell.iter().cycle().skip(1));
        let triangle = |(before, corner): (&Corner, &Corner)| {
            let triangle = [before.beside?, corner.beside?];
            let is_narrow = corner.at.length_squared() <= widest;
            let is_flat = normal(triangle).dot(plane.normal) >= STEEPEST;
            (is_narrow && is_flat).then_some((triangle, corner.at.length()))
        };
        let found: Vec<Option<([u32; 2], f64)>> = corners.map(triangle).collect();
        let pairs = found.iter().zip(found.iter().cycle().skip(1));
        let turns = pairs.map(|pair| match pair {
            (Some(one), Some(next)) => 1.0 - normal(one.0).dot(normal(next.0)),
            _ => MISSING,
        });
        let widest = found.iter().flatten().fold(0.0, |widest: f64, triangle| widest.max(triangle.1));
        let width = WIDTH * widest / plane.spacing;
        ([turns.sum(), width], found.into_iter().flatten().map(|triangle| triangle.0).collect())
    }

    /// The plane square to the mean normal of the triangles around the point.
    fn refined(&self, plane: &Plane, positions: &[DVec3], place: DVec3) -> Option<Plane> {
        let sides = self.cell.iter().zip(self.cell.iter().cycle().skip(1));
        let areas = sides.filter_map(|(before, corner)| {
            let [a, b] = [before.beside?, corner.beside?].map(|other| positions[other as usize] - place);
            Some(a.cross(b))
        });
        areas.sum::<DVec3>().try_normalize().map(|normal| Plane { normal, ..*plane })
    }

    /// Clips the cell. Returns whether no farther neighbour could change it.
    fn clip(&mut self, plane: &Plane) -> bool {
        let far = 2.0 * WIDEST * plane.spacing;
        let border = [(-far, -far), (far, -far), (far, far), (-far, far)];
        self.cell.clear();
        self.cell.extend(border.map(|(x, y)| Corner { at: DVec2::new(x, y), beside: None }));
        let laid = plane.lay();
        for (&(squared, other), &offset) in self.near.iter().zip(&self.offsets) {
            let reach = self.cell.iter().map(|corner| corner.at.length_squared()).fold(0.0, f64::max);
            // Twice the cell's radius.
            if squared > 4.0 * reach {
                return true;
            }
            let Some(at) = laid(offset) else { continue };
            let beyond = |corner: &Corner| corner.at.dot(at) - 0.5 * squared;
            self.clipped.clear();
            for (index, corner) in self.cell.iter().enumerate() {
                let next = &self.cell[(index + 1) % self.cell.len()];
                let [here, there] = [corner, next].map(beyond);
                let crossing = || corner.at + (next.at - corner.at) * (here / (here - there));
                match (here <= 0.0, there <= 0.0) {
                    (true, true) => self.clipped.push(*corner),
                    (true, false) => {
                        self.clipped.push(*corner);
                        self.clipped.push(Corner { at: crossing(), beside: Some(other) });
                    }
                    (false, true) => self.clipped.push(Corner { at: crossing(), beside: corner.beside }),
                    (false, false) => {}
                }
            }
            std::mem::swap(&mut self.cell, &mut self.clipped);
        }
        let reach = self.cell.iter().map(|corner| corner.at.length_squared()).fold(0.0, f64::max);
        self.near.last().is_some_and(|last| last.0 >= 4.0 * reach)
    }
}
