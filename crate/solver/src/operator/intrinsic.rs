//! Intrinsic triangulations: triangles given by edge lengths and glued along edges, flipped until they are Delaunay.
//!
//! Fisher, Springborn, Schröder, Bobenko, "An algorithm for the construction of intrinsic Delaunay triangulations"
//! (2006); Sharp and Crane, "A Laplacian for nonmanifold triangle meshes" (2020), sections 3.1 (mollification) and 3.3.

use heatwalk_base::csr::NONE;
use heatwalk_base::sort;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element as _, FaceId, HalfedgeId, VertexId, triangle};

use crate::error::{Error, Result};
use crate::operator::elements::{Element, Elements, edge_statistics, require_triangles};
use crate::operator::waiting::{Flippable, Waiting};

/// Share of the mean edge by which every triangle must miss being flat after mollification (Sharp and Crane, 4.5).
const MOLLIFICATION: f64 = 1e-5;

/// An edge is flipped where the sum of the cotangents beside it is below minus this. Rounding of the sum after
/// mollification is far below; without the margin four points on a circle could be flipped back and forth.
const FLIP_TOLERANCE: f64 = 1e-9;

/// Flips on the mean of all sides that it takes at most. Meshes need a fraction of one; from a few hubs that all edges lead to it would
/// be as many as there are vertices, and triangles that are not Delaunay are better than none.
const MOST_FLIPS: usize = 8;

/// Triangles of given edge lengths, glued. Slot `3 f + k` is the side of face `f` from corner `k` to the next.
#[derive(Debug, Clone)]
pub struct IntrinsicTriangulation {
    /// `#F × 3` vertices, counter-clockwise. A face may have one twice.
    faces: Vec<[u32; 3]>,
    /// `3 #F`, length of each side, in the file's unit.
    lengths: Vec<f64>,
    /// `3 #F`, cotangent of the angle opposite each side.
    cotans: Vec<f64>,
    /// `3 #F`, the slot glued to each; of an open side, a number of its own from `3 #F` on.
    twins: Vec<u32>,
    /// How often the surface is covered: 1, or 2 by the tufted cover.
    sheets: u32,
    flips: usize,
    /// `#F` of one sheet, or empty: what lengths in each face count. No edge between two costs is flipped, so that a face
    /// keeps its cost.
    costs: Vec<f64>,
}

impl IntrinsicTriangulation {
    /// Of any triangles: `faces` (`#F × 3`) are vertices, counter-clockwise, `lengths` (`#F × 3`) those of the sides from
    /// corner 0 to 1, 1 to 2 and 2 to 0, and `twins` (`#F × 3`) the side glued to each, none where it is open. Side `k` of
    /// face `f` is half-edge `3 f + k`. Vertices are counted from 0.
    ///
    /// # Errors
    /// [`Error::BadParameter`] where there is not a triple of each for every face, for lengths that make no triangle, and
    /// for a vertex in no face; [`Error::BadGlue`] for two sides that do not fit.
    pub fn new(faces: &[[VertexId; 3]], lengths: &[[f64; 3]], twins: &[[Option<HalfedgeId>; 3]]) -> Result<Self> {
        if [lengths.len(), twins.len()] != [faces.len(); 2] {
            return Err(Error::BadParameter {
                name: "the number of triples of lengths and of glued sides",
                value: format!("{} and {}", lengths.len(), twins.len()),
                range: "one of each for every face",
            });
        }
        require_triangles(lengths)?;
        let faces: Vec<[u32; 3]> = faces.iter().map(|face| face.map(|vertex| vertex.0)).collect();
        let corners = faces.as_flattened();
        let count = corners.iter().max().map_or(0, |&last| (last as usize).saturating_add(1));
        let mut is_used = vec![false; count.min(corners.len() + 1)];
        for &corner in corners {
            is_used.get_mut(corner as usize).into_iter().for_each(|used| *used = true);
        }
        if let Some(unused) = is_used.iter().position(|&used| !used) {
            let range = "a corner of some face, as all below the highest are";
            return Err(Error::BadParameter { name: "a vertex", value: unused.to_string(), range });
        }
        let (twins, sides) = (twins.as_flattened(), lengths.as_flattened());
        let ends = |side: usize| [corners[side], corners[next(side as u32) as usize]];
        let fits = |side: usize, twin: usize| {
            let [start, end] = ends(side);
            twin != side && twin < sides.len() && ends(twin) == [end, start] && sides[twin] == sides[side]
        };
        let is_bad = |side: usize| {
            twins[side]
                .is_some_and(|twin| !fits(side, twin.index()) || twins[twin.index()] != Some(HalfedgeId(side as u32)))
        };
        if let Some(side) = (0..sides.len()).find(|&side| is_bad(side)) {
            return Err(Error::BadGlue { side });
        }
        let mut open = sides.len() as u32..;
        let slot = |twin: &Option<HalfedgeId>| twin.map(|twin| twin.0).or_else(|| open.next()).unwrap_or(NONE);
        let twins = twins.iter().map(slot).collect();
        Ok(Self::glued(faces, sides.to_vec(), twins))
    }

    /// The faces of a surface as they are, but for the lengths of flat ones. Vertices are those of its half-edge mesh: where
    /// that is cut, each copy is one.
    pub fn of_surface(surface: &Surface) -> Self {
        let mesh = surface.mesh();
        let corners = |face: FaceId| [0, 1, 2].map(|k| mesh.vertex(face.halfedge(k)).0);
        Self::of_faces(surface, mesh.faces().map(corners).collect())
    }

    /// The faces of a surface, of these vertices.
    fn of_faces(surface: &Surface, faces: Vec<[u32; 3]>) -> Self {
        let mut lengths = surface.side_lengths();
        mollify(&mut lengths, surface.mean_edge());
        let twins = (0..lengths.len() as u32).map(|slot| surface.mesh().twin(HalfedgeId(slot)).0).collect();
        Self::glued(faces, lengths, twins)
    }

    fn glued(faces: Vec<[u32; 3]>, lengths: Vec<f64>, twins: Vec<u32>) -> Self {
        let cotans = lengths.as_chunks().0.iter().flat_map(|&sides| cotans_opposite(sides)).collect();
        Self { faces, lengths, cotans, twins, sheets: 1, flips: 0, costs: Vec::new() }
    }

    /// The Delaunay triangulation of a surface. It has a single sheet where the surface is an oriented manifold and
    /// no boundary edge lies opposite an obtuse angle; otherwise it lives on the tufted cover, where every edge has two
    /// sides and can be flipped, so that no cotan weight is negative in either case.
    pub fn delaunay(surface: &Surface) -> Self {
        Self::delaunay_within(surface, &[])
    }

    /// The same within areas of one cost (`#F`, or none).
    pub(crate) fn delaunay_within(surface: &Surface, costs: &[f64]) -> Self {
        let faces = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
        let mut triangulation = Self { costs: costs.to_vec(), ..Self::of_faces(surface, faces) };
        triangulation.flip_to_delaunay(0..3 * surface.face_count() as u32, |_, _| {});
        if surface.is_oriented_manifold() && triangulation.has_sharp_boundary() {
            return triangulation;
        }
        // Inside its sheets the cover is Delaunay already.
        let seams = triangulation.cover(surface);
        triangulation.flip_to_delaunay(seams.into_iter(), |_, _| {});
        triangulation
    }

    /// Makes the tufted cover: adds a reversed copy of each face and glues open sides in pairs around their edges.
    /// Returns one slot of each pair.
    fn cover(&mut self, surface: &Surface) -> Vec<u32> {
        let count = self.faces.len() as u32;
        // The side of the other copy of its face along the same edge.
        let reversed = |slot: u32| 3 * ((slot / 3 + count) % (2 * count)) + 2 - slot % 3;
        self.faces.extend_from_within(..);
        self.lengths.extend_from_within(..);
        self.cotans.extend_from_within(..);
        for face in count as usize..2 * count as usize {
            self.faces[face].swap(1, 2);
            self.lengths.swap(3 * face, 3 * face + 2);
            self.cotans.swap(3 * face, 3 * face + 2);
        }
        let mut open = vec![NONE; surface.mesh().halfedge_count() - 3 * count as usize];
        for slot in 0..3 * count {
            let twin = self.twins[slot as usize];
            if twin >= 3 * count {
                open[(twin - 3 * count) as usize] = slot;
            }
        }
        let copies = (3 * count..6 * count).map(|slot| {
            let twin = self.twins[reversed(slot) as usize];
            if twin < 3 * count { reversed(twin) } else { NONE }
        });
        let copies: Vec<u32> = copies.collect();
        self.twins.extend(copies);
        self.sheets = 2;
        let origin = |slot: u32| self.faces[slot as usize / 3][slot as usize % 3];
        let mut seams = Vec::with_capacity(open.len());
        let mut ring = Vec::new();
        for last in surface.edges().representatives() {
            let outer = |side: u32| surface.mesh().twin(HalfedgeId(side)).0;
            if outer(last.0) < 3 * count {
                continue;
            }
            ring.clear();
            ring.extend(surface.edges().around(last).map(|halfedge| halfedge.0));
            sort_around(surface, &mut ring);
            for side in &mut ring {
                *side = open[(outer(*side) - 3 * count) as usize];
            }
            let is_upward = |slot: u32| origin(slot) == origin(ring[0]);
            for (index, &side) in ring.iter().enumerate() {
                let next = ring[(index + 1) % ring.len()];
                let up = if is_upward(side) { side } else { reversed(side) };
                let down = if is_upward(next) { reversed(next) } else { next };
                self.twins[up as usize] = down;
                self.twins[down as usize] = up;
                seams.push(up);
            }
        }
        seams
    }

    /// Flips edges until those of `sides` and of the triangles changed on the way are Delaunay, or [`MOST_FLIPS`] are done. `flipped` is
    /// told of each with one of its new slots.
    pub(crate) fn flip_to_delaunay(&mut self, sides: impl Iterator<Item = u32>, mut flipped: impl FnMut(&Self, u32)) {
        let mut waiting = Waiting::new(&self.faces);
        sides.for_each(|side| self.let_wait(side, 0, &mut waiting));
        let most = self.flips + MOST_FLIPS * self.twins.len();
        while let Some((slot, round)) = waiting.pop().filter(|_| self.flips < most) {
            if !self.is_to_flip(slot) {
                continue;
            }
            let (twin, ends) = (self.twins[slot as usize], self.corners_of(slot));
            self.flip(slot);
            waiting.flipped(ends, self.corners_of(slot));
            flipped(self, slot);
            self.flips += 1;
            for side in [next(slot), previous(slot), next(twin), previous(twin)] {
                self.let_wait(side, round + 1, &mut waiting);
            }
        }
    }

    /// Lets an edge wait to be flipped in this round or before, where it is to be.
    fn let_wait(&self, side: u32, round: u32, waiting: &mut Waiting) {
        // Of the two slots of an edge, the lower one stands for it.
        let slot = side.min(self.twins[side as usize]);
        if self.is_to_flip(slot) {
            let (ends, length) = (self.corners_of(slot), self.lengths[slot as usize]);
            waiting.push(&Flippable { slot, ends, length, excess: self.excess(slot) }, round);
        }
    }

    /// The vertices that a side leaves and enters.
    fn corners_of(&self, slot: u32) -> [u32; 2] {
        [slot, next(slot)].map(|slot| self.faces[slot as usize / 3][slot as usize % 3])
    }

    /// How far an edge is from Delaunay, above 0 where it is to be flipped.
    fn excess(&self, slot: u32) -> f64 {
        let twin = self.twins[slot as usize];
        -self.cotans[slot as usize] - self.cotans[twin as usize]
    }

    fn is_open(&self, slot: usize) -> bool {
        self.twins[slot] as usize >= self.twins.len()
    }

    /// Whether a side has two triangles and is not Delaunay.
    fn is_to_flip(&self, slot: u32) -> bool {
        let (slot, twin) = (slot as usize, self.twins[slot as usize] as usize);
        !self.is_open(slot)
            && twin / 3 != slot / 3
            && self.excess(slot as u32) > FLIP_TOLERANCE
            && self.cost(slot / 3) == self.cost(twin / 3)
    }

    /// What lengths in a face count.
    fn cost(&self, face: usize) -> f64 {
        if self.costs.is_empty() { 1.0 } else { self.costs[face % self.costs.len()] }
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
        let diagonal = triangle::hypotenuse(c.0 - d.0, c.1 + d.1);
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
            let partner = new_slot(old_twin);
            self.twins[side as usize] = partner;
            if let Some(back) = self.twins.get_mut(partner as usize) {
                *back = side;
            }
        }
        for face in [slot / 3, twin / 3].map(|face| face as usize) {
            let sides = [3 * face, 3 * face + 1, 3 * face + 2];
            let cotans = cotans_opposite(sides.map(|side| self.lengths[side]));
            self.cotans[3 * face..3 * face + 3].copy_from_slice(&cotans);
        }
    }

    /// Whether no open side lies opposite an obtuse angle.
    fn has_sharp_boundary(&self) -> bool {
        (0..self.twins.len()).all(|slot| !self.is_open(slot) || self.cotans[slot] >= -FLIP_TOLERANCE)
    }

    /// Number of triangles.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// The vertices that a side leaves and enters.
    pub fn ends(&self, side: HalfedgeId) -> [VertexId; 2] {
        self.corners_of(side.0).map(VertexId)
    }

    /// The side glued to a side, none where it is open.
    pub fn twin(&self, side: HalfedgeId) -> Option<HalfedgeId> {
        (!self.is_open(side.index())).then(|| HalfedgeId(self.twins[side.index()]))
    }

    /// Length of a side, in the file's unit.
    pub fn length(&self, side: HalfedgeId) -> f64 {
        self.lengths[side.index()]
    }

    /// The angle between a side and the one before it in its face, radians.
    pub(crate) fn corner_angle(&self, side: u32) -> f64 {
        1.0_f64.atan2(self.cotans[next(side) as usize])
    }

    /// Number of edges flipped.
    pub fn flips(&self) -> usize {
        self.flips
    }

    /// How often the surface is covered: 1, or 2 by the tufted cover.
    pub fn sheets(&self) -> u32 {
        self.sheets
    }

    /// The triangles laid out in the plane. Where both sheets have the same one, it is there once.
    pub(crate) fn elements(self) -> Elements {
        let weighted = self.lengths.iter().enumerate().map(|(slot, length)| length * self.cost(slot / 3));
        let weighted: Vec<f64> = weighted.collect();
        let (mean_edge, deviation) = edge_statistics(&weighted, |slot| self.is_open(slot));
        let lengths = weighted.as_chunks().0;
        let sheet = self.faces.len() / self.sheets as usize;
        let is_alone = |face: usize| {
            let ([a, b, c], [ab, bc, ca]) = (self.faces[face], lengths[face]);
            let copy = face + sheet;
            self.sheets == 2 && (self.faces[copy], lengths[copy]) != ([a, c, b], [ca, bc, ab])
        };
        let (alone, mut order): (Vec<usize>, Vec<usize>) = (0..sheet).partition(|&face| is_alone(face));
        let whole = order.len();
        order.extend(alone.into_iter().flat_map(|face| [face, face + sheet]));
        let faces = order.iter().map(|&face| self.faces[face]).collect();
        let shapes = order.iter().map(|&face| Element::of_lengths(lengths[face])).collect();
        Elements { faces, shapes, whole, mean_edge, deviation }
    }
}

/// Adds one length to every side, the least that leaves no triangle flatter than `MOLLIFICATION`.
fn mollify(lengths: &mut [f64], mean_edge: f64) {
    let margin = MOLLIFICATION * mean_edge;
    let shortfall = |&[a, b, c]: &[f64; 3]| {
        let longest = a.max(b).max(c);
        let others = a + b + c - longest;
        longest - others + margin
    };
    let addition = lengths.as_chunks().0.iter().map(shortfall).fold(0.0, f64::max);
    if addition > 0.0 {
        for length in lengths {
            *length += addition;
        }
    }
}

/// Cotangents of the angles opposite the sides of these lengths.
fn cotans_opposite([a, b, c]: [f64; 3]) -> [f64; 3] {
    let inverse = 0.25 / triangle::area_of_lengths([a, b, c]);
    let [a, b, c] = [a * a, b * b, c * c];
    [(b + c - a) * inverse, (c + a - b) * inverse, (a + b - c) * inverse]
}

/// Sorts the sides that share an edge by the angle of their faces around it.
fn sort_around(surface: &Surface, sides: &mut [u32]) {
    if sides.len() < 3 {
        return;
    }
    let face = |slot: u32| surface.faces()[HalfedgeId(slot).triangle()];
    let apex = |slot: u32| surface.position(face(slot)[(slot as usize + 2) % 3]);
    let [start, end] = [0, 1].map(|k| surface.position(face(sides[0])[(sides[0] as usize + k) % 3]));
    let axis = triangle::unit(end - start);
    let out = |slot: u32| triangle::unit((apex(slot) - start).reject_from_normalized(axis));
    let (x, y) = (out(sides[0]), axis.cross(out(sides[0])));
    let angle = |slot: u32| out(slot).dot(y).atan2(out(slot).dot(x));
    let mut around: Vec<(f64, u32)> = sides.iter().map(|&side| (angle(side), side)).collect();
    sort::sort_by(&mut around, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    for (side, (_, sorted)) in sides.iter_mut().zip(around) {
        *side = sorted;
    }
}

pub(crate) fn next(slot: u32) -> u32 {
    if slot % 3 == 2 { slot - 2 } else { slot + 1 }
}

pub(crate) fn previous(slot: u32) -> u32 {
    if slot.is_multiple_of(3) { slot + 2 } else { slot - 1 }
}
