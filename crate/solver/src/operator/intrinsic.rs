//! Intrinsic triangulations: triangles given by edge lengths and glued along edges, flipped until they are Delaunay.
//!
//! Fisher, Springborn, Schröder, Bobenko, "An algorithm for the construction of intrinsic Delaunay triangulations"
//! (2006); Sharp and Crane, "A Laplacian for nonmanifold triangle meshes" (2020), sections 3.1 (mollification) and 3.3.

use crate::csr::NONE;
use crate::operator::elements::{Element, Elements};
use crate::surface::Surface;
use crate::triangle;

/// Share of the mean edge by which every triangle must miss being flat after mollification (Sharp and Crane, 4.5).
const MOLLIFICATION: f64 = 1e-5;

/// An edge is flipped where the sum of the cotangents beside it is below minus this. Rounding of the sum after
/// mollification is far below; without the margin four points on a circle could be flipped back and forth.
const FLIP_TOLERANCE: f64 = 1e-9;

/// Triangles of given edge lengths, glued. Slot `3 f + k` is the side of face `f` from corner `k` to the next.
#[derive(Debug, Clone)]
pub struct IntrinsicTriangulation {
    /// `#F × 3` points, counter-clockwise. A face may have a point twice.
    faces: Vec<[u32; 3]>,
    /// `3 #F`, length of each side, in the file's unit.
    lengths: Vec<f64>,
    /// `3 #F`, the slot glued to each; [`NONE`] on the boundary.
    twins: Vec<u32>,
    /// How often the surface is covered: 1, or 2 by the tufted cover.
    sheets: u32,
    flips: usize,
}

impl IntrinsicTriangulation {
    /// The Delaunay triangulation of a surface. It has a single sheet where the surface is an oriented manifold and
    /// no boundary edge lies opposite an obtuse angle; otherwise it lives on the tufted cover, where every edge has two
    /// sides and can be flipped, so that no cotan weight is negative in either case.
    pub fn delaunay(surface: &Surface) -> Self {
        if surface.is_oriented_manifold {
            let mut single = Self::single_sheet(surface);
            single.mollify(surface.mean_edge);
            single.flip_to_delaunay();
            if single.has_sharp_boundary() {
                return single;
            }
        }
        let mut double = Self::tufted(surface);
        double.mollify(surface.mean_edge);
        double.flip_to_delaunay();
        double
    }

    /// The faces as they are; cuts are boundary.
    fn single_sheet(surface: &Surface) -> Self {
        let slots = surface.face_count() as u32 * 3;
        let twins = (0..slots).map(|slot| surface.mesh.twin(crate::halfedge::Halfedge(slot)).0);
        let twins = twins.map(|twin| if twin < slots { twin } else { NONE }).collect();
        Self { faces: surface.faces.as_slice().to_vec(), lengths: side_lengths(surface), twins, sheets: 1, flips: 0 }
    }

    /// The tufted cover: each face twice, the copy reversed, glued in pairs around every edge.
    fn tufted(surface: &Surface) -> Self {
        let count = surface.face_count();
        let mut faces = surface.faces.as_slice().to_vec();
        faces.extend(surface.faces.iter().map(|&[a, b, c]| [a, c, b]));
        let mut lengths = side_lengths(surface);
        lengths.reserve(3 * count);
        for face in 0..count {
            let [ab, bc, ca] = [0, 1, 2].map(|k| lengths[3 * face + k]);
            lengths.extend([ca, bc, ab]);
        }
        // The side of the reversed copy along the same edge.
        let reversed = |slot: u32| 3 * (count as u32 + slot / 3) + 2 - slot % 3;
        let mut twins = vec![NONE; 6 * count];
        let mut ring = Vec::new();
        surface.for_each_edge(|low, sides| {
            ring.clear();
            ring.extend_from_slice(sides);
            sort_around(surface, &mut ring);
            let sides = &ring;
            for (index, &side) in sides.iter().enumerate() {
                let next = sides[(index + 1) % sides.len()];
                let upward = |slot: u32| {
                    if surface.faces.as_slice()[slot as usize / 3][slot as usize % 3] == low {
                        slot
                    } else {
                        reversed(slot)
                    }
                };
                let downward = |slot: u32| if upward(slot) == slot { reversed(slot) } else { slot };
                let (a, b) = (upward(side), downward(next));
                twins[a as usize] = b;
                twins[b as usize] = a;
            }
        });
        Self { faces, lengths, twins, sheets: 2, flips: 0 }
    }

    /// Adds one length to every side, the least that leaves no triangle flatter than `MOLLIFICATION`.
    fn mollify(&mut self, mean_edge: f64) {
        let margin = MOLLIFICATION * mean_edge;
        let shortfall = |&[a, b, c]: &[f64; 3]| {
            let longest = a.max(b).max(c);
            let others = a + b + c - longest;
            longest - others + margin
        };
        let addition = self.lengths.as_chunks().0.iter().map(shortfall).fold(0.0, f64::max);
        if addition > 0.0 {
            for length in &mut self.lengths {
                *length += addition;
            }
        }
    }

    fn flip_to_delaunay(&mut self) {
        let slots = self.faces.len() as u32 * 3;
        let mut is_queued: Vec<bool> = (0..slots).map(|slot| slot < self.twins[slot as usize]).collect();
        let mut queue: Vec<u32> = (0..slots).rev().filter(|&slot| is_queued[slot as usize]).collect();
        while let Some(slot) = queue.pop() {
            is_queued[slot as usize] = false;
            let twin = self.twins[slot as usize];
            if twin == NONE || twin / 3 == slot / 3 {
                continue;
            }
            let cotans = self.cotan_opposite(slot) + self.cotan_opposite(twin);
            if cotans >= -FLIP_TOLERANCE {
                continue;
            }
            self.flip(slot);
            self.flips += 1;
            for side in [next(slot), previous(slot), next(twin), previous(twin)] {
                let low = side.min(self.twins[side as usize]);
                if !std::mem::replace(&mut is_queued[low as usize], true) {
                    queue.push(low);
                }
            }
        }
    }

    /// Cotangent of the angle opposite a side, from the three lengths.
    fn cotan_opposite(&self, slot: u32) -> f64 {
        let [a, b, c] = [slot, next(slot), previous(slot)].map(|side| self.lengths[side as usize]);
        (b * b + c * c - a * a) / (4.0 * triangle::area_of_lengths([a, b, c]))
    }

    /// Replaces a side by the other diagonal of the two triangles beside it.
    fn flip(&mut self, slot: u32) {
        let twin = self.twins[slot as usize];
        // Triangles (a, b, c) and (b, a, d) become (c, d, b) and (d, c, a).
        let [bc, ca] = [next(slot), previous(slot)];
        let [ad, db] = [next(twin), previous(twin)];
        let length = |side: u32| self.lengths[side as usize];
        let base = length(slot);
        let place = |from_a: f64, from_b: f64| {
            let x = (from_a * from_a - from_b * from_b + base * base) / (2.0 * base);
            (x, 2.0 * triangle::area_of_lengths([base, from_a, from_b]) / base)
        };
        let (c, d) = (place(length(ca), length(bc)), place(length(ad), length(db)));
        let diagonal = (c.0 - d.0).hypot(c.1 + d.1);
        let origin = |side: u32| self.faces[side as usize / 3][side as usize % 3];
        let corners = [origin(slot), origin(twin), origin(ca), origin(db)];
        let outside = [db, bc, ca, ad].map(|side| (self.lengths[side as usize], self.twins[side as usize], side));
        let [a, b, c, d] = corners;
        // Slot becomes c → d with d → b and b → c; twin becomes d → c with c → a and a → d.
        let places = [(slot, c, diagonal), (next(slot), d, outside[0].0), (previous(slot), b, outside[1].0)];
        let others = [(twin, d, diagonal), (next(twin), c, outside[2].0), (previous(twin), a, outside[3].0)];
        for (side, point, length) in places.into_iter().chain(others) {
            self.faces[side as usize / 3][side as usize % 3] = point;
            self.lengths[side as usize] = length;
        }
        let moved = [next(slot), previous(slot), next(twin), previous(twin)];
        // A side that was glued to another of the four follows it to its new slot.
        let new_slot = |old: u32| outside.iter().position(|side| side.2 == old).map_or(old, |index| moved[index]);
        for (side, (_, old_twin, _)) in moved.into_iter().zip(outside) {
            let partner = if old_twin == NONE { NONE } else { new_slot(old_twin) };
            self.twins[side as usize] = partner;
            if partner != NONE {
                self.twins[partner as usize] = side;
            }
        }
    }

    /// Whether no boundary side lies opposite an obtuse angle.
    fn has_sharp_boundary(&self) -> bool {
        let boundary = (0..self.twins.len()).filter(|&slot| self.twins[slot] == NONE);
        boundary.into_iter().all(|slot| self.cotan_opposite(slot as u32) >= -FLIP_TOLERANCE)
    }

    /// Number of edges flipped.
    pub fn flips(&self) -> usize {
        self.flips
    }

    /// How often the surface is covered: 1, or 2 by the tufted cover.
    pub fn sheets(&self) -> u32 {
        self.sheets
    }

    /// The triangles laid out in the plane.
    pub(crate) fn elements(self) -> Elements {
        let shapes = self.lengths.as_chunks().0.iter().map(|&lengths| Element::of_lengths(lengths)).collect();
        let is_boundary = self.twins.iter().map(|&twin| twin == NONE).collect();
        Elements { faces: self.faces, shapes, is_boundary, share: 1.0 / f64::from(self.sheets) }
    }
}

/// `3 #F`, length of each face's sides.
fn side_lengths(surface: &Surface) -> Vec<f64> {
    let sides = surface.mesh.faces().flat_map(|face| {
        let [p, q, r] = surface.corners(face);
        [q - p, r - q, p - r].map(triangle::length)
    });
    sides.collect()
}

/// Sorts the sides that share an edge by the angle of their faces around it.
fn sort_around(surface: &Surface, sides: &mut [u32]) {
    if sides.len() < 3 {
        return;
    }
    let face = |slot: u32| surface.faces.as_slice()[slot as usize / 3];
    let apex = |slot: u32| surface.position(face(slot)[(slot as usize + 2) % 3]);
    let [start, end] = [0, 1].map(|k| surface.position(face(sides[0])[(sides[0] as usize + k) % 3]));
    let axis = triangle::unit(end - start);
    let out = |slot: u32| triangle::unit((apex(slot) - start).reject_from_normalized(axis));
    let (x, y) = (out(sides[0]), axis.cross(out(sides[0])));
    let angle = |slot: u32| out(slot).dot(y).atan2(out(slot).dot(x));
    sides.sort_by(|&a, &b| angle(a).total_cmp(&angle(b)));
}

fn next(slot: u32) -> u32 {
    if slot % 3 == 2 { slot - 2 } else { slot + 1 }
}

fn previous(slot: u32) -> u32 {
    if slot.is_multiple_of(3) { slot + 2 } else { slot - 1 }
}
