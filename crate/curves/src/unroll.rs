//! A piece of a strip unfolded into the plane, face after face.
//!
//! A surface has a plane shape of the same lengths where the angles around each inner vertex add up to a full turn; what is
//! missing to it is the angle defect, the curvature of that vertex (K. Polthier and M. Schmies, "Straightest geodesics on
//! polyhedral surfaces", 1998, section 2). Inner vertices of a strip are vertices of the surface, so whole faces have the angles, and
//! whole faces are laid into the plane: what an isoline cuts off a face may be too narrow for either.
//!
//! A piece with holes is cut open besides where it does not close in the plane, and one with sources or farthest places that are
//! tips of cones from these to its rim: along shortest paths of edges.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};
use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;
use heatwalk_surface::triangle;

use crate::error::{MAX_DEFECT, NotDevelopable};
use crate::field::{Edges, Field, NONE};
use crate::strips::Strips;

/// Sides of a cut that are no farther apart in the plane than this share of the piece's extent are one edge: positions in files
/// are right to 6e-8 of their size at worst, as 32 bits are.
const SAME_PLACE: f64 = 1e-6;

/// Triangles of one strip that hang together by edges, turned so that neighbors agree in orientation where they can.
pub(crate) struct Piece<'a> {
    field: &'a Field,
    strips: &'a Strips,
    strip: usize,
    /// Of the strips.
    triangles: Vec<[u32; 3]>,
    /// The face of the field that each triangle is a part of; those of a face follow each other.
    origins: Vec<u32>,
    /// The corners of that face, turned as the triangle is.
    faces: Vec<[u32; 3]>,
    edges: Edges,
    /// Of each half-edge the number of the vertex that it leaves. A vertex where the piece only touches itself has several.
    numbers: Vec<usize>,
    /// Of each number, whether all around it are triangles of the piece.
    is_inner: Vec<bool>,
}

/// The pieces of a strip, in the order of their first triangles.
pub(crate) fn pieces<'a>(field: &'a Field, strips: &'a Strips, strip: usize) -> Vec<Piece<'a>> {
    let range = strips.ranges[strip].clone();
    let triangles = &strips.triangles[range.clone()];
    let edges = Edges::of(triangles);
    let mut is_taken = vec![false; triangles.len()];
    let mut is_turned = vec![false; triangles.len()];
    let mut pieces = Vec::new();
    for first in 0..triangles.len() {
        if is_taken[first] {
            continue;
        }
        is_taken[first] = true;
        let mut members = vec![first];
        let mut done = 0;
        while let Some(&triangle) = members.get(done) {
            done += 1;
            for side in 3 * triangle..3 * triangle + 3 {
                let Some(beside) = edges.other(side).map(|other| other / 3) else { continue };
                if !is_taken[beside] {
                    is_taken[beside] = true;
                    is_turned[beside] = is_turned[triangle] != edges.is_turned(side);
                    members.push(beside);
                }
            }
        }
        sort::sort(&mut members);
        let members = members.into_iter().map(|triangle| (range.start + triangle, is_turned[triangle]));
        pieces.push(Piece::new(field, strips, strip, members));
    }
    pieces
}

impl<'a> Piece<'a> {
    /// Of triangles of the strips, each with whether it has to be turned.
    fn new(field: &'a Field, strips: &'a Strips, strip: usize, members: impl Iterator<Item = (usize, bool)>) -> Self {
        let (mut triangles, mut origins, mut faces) = (Vec::new(), Vec::new(), Vec::new());
        for (index, is_turned) in members {
            let turned = |[a, b, c]: [u32; 3]| if is_turned { [a, c, b] } else { [a, b, c] };
            let origin = strips.origins[index];
            triangles.push(turned(strips.triangles[index]));
            origins.push(origin);
            faces.push(turned(field.triangles()[origin as usize]));
        }
        let edges = Edges::of(&triangles);
        let fans = UnionFind::new(3 * triangles.len());
        for side in 0..3 * triangles.len() {
            if let Some(twin) = edges.twin(side) {
                fans.join(side as u32, next(twin) as u32);
            }
        }
        let (numbers, count) = fans.sets();
        let numbers = numbers.into_iter().map(|number| number as usize).collect();
        let is_inner = vec![true; count as usize];
        let mut piece = Self { field, strips, strip, triangles, origins, faces, edges, numbers, is_inner };
        for side in piece.rims() {
            for end in [side, next(side)] {
                piece.is_inner[piece.numbers[end]] = false;
            }
        }
        piece
    }

    /// The loops around its plane shape, counter-clockwise around it and clockwise around holes, in the field's unit.
    pub(crate) fn unroll(&self) -> Result<Vec<Vec<DVec2>>, NotDevelopable> {
        let mut is_flat = self.is_inner.clone();
        self.tips()?.into_iter().for_each(|tip| is_flat[tip] = false);
        let (corners, mut is_joined) = self.lay_out();
        self.close(&is_flat, &mut is_joined);
        let cut_open = self.loops(&corners, &is_joined);
        if !self.close_in_plane(&is_flat, &corners, &mut is_joined) {
            return Ok(cut_open);
        }
        let whole = self.loops(&corners, &is_joined);
        Ok(if is_around_holes(&whole) { whole } else { cut_open })
    }

    /// What is around the triangles where they are joined like this.
    fn loops(&self, corners: &[DVec2], is_joined: &[bool]) -> Vec<Vec<DVec2>> {
        let mut loops = Vec::new();
        let mut is_walked = is_joined.to_vec();
        for start in self.sides() {
            let mut side = start;
            let mut outline = Vec::new();
            while !is_walked[side] {
                is_walked[side] = true;
                outline.push(corners[side]);
                side = next(side);
                while let (true, Some(twin)) = (is_joined[side], self.edges.twin(side)) {
                    side = next(twin);
                }
            }
            if outline.len() > 2 {
                loops.push(outline);
            }
        }
        loops
    }

    fn position(&self, side: usize) -> DVec3 {
        self.strips.positions[self.vertex(side) as usize]
    }

    fn length(&self, side: usize) -> f64 {
        triangle::length(self.position(next(side)) - self.position(side))
    }

    /// The vertex that a half-edge leaves.
    fn vertex(&self, side: usize) -> u32 {
        self.triangles[side / 3][side % 3]
    }

    fn sides(&self) -> std::ops::Range<usize> {
        0..3 * self.triangles.len()
    }

    /// The half-edges without a neighbor.
    fn rims(&self) -> Vec<usize> {
        self.sides().filter(|&side| self.edges.twin(side).is_none()).collect()
    }

    /// The tips of cones, of sources and of farthest places: cut open to the rim, they lie in the plane. Refuses a piece that is curved elsewhere.
    fn tips(&self) -> Result<Vec<usize>, NotDevelopable> {
        let count = self.is_inner.len();
        let (mut angles, mut vertices, mut last) = (vec![0.0; count], vec![NONE; count], vec![NONE; count]);
        let (mut is_least, mut is_largest) = (self.is_inner.clone(), self.is_inner.clone());
        let distance = |side: usize| self.strips.distances[self.vertex(side) as usize];
        for side in self.sides() {
            let (number, vertex, triangle) = (self.numbers[side], self.vertex(side), side / 3);
            // Of an inner vertex, each edge begins there in one triangle.
            is_least[number] &= distance(side) < distance(next(side));
            is_largest[number] &= distance(side) > distance(next(side));
            // A face may have several triangles there, and all of its angle is the vertex's.
            if self.is_inner[number] && last[number] != self.origins[triangle] {
                last[number] = self.origins[triangle];
                vertices[number] = vertex;
                let corners = self.faces[triangle];
                let at = corners.iter().position(|&corner| corner == vertex);
                angles[number] += at.map_or(0.0, |at| {
                    let corner = |k: usize| self.field.positions()[corners[(at + k) % 3] as usize];
                    triangle::angle([corner(0), corner(1), corner(2)])
                });
            }
        }
        let (mut largest, mut at, mut total) = (0.0, 0, 0.0);
        let mut tips = Vec::new();
        for number in (0..count).filter(|&number| self.is_inner[number]) {
            let defect = TAU - angles[number];
            if defect > MAX_DEFECT && (is_least[number] || is_largest[number]) {
                tips.push(number);
                continue;
            }
            let defect = defect.abs();
            total += defect;
            if defect > largest {
                (largest, at) = (defect, number);
            }
        }
        if total <= MAX_DEFECT {
            return Ok(tips);
        }
        Err(NotDevelopable { strip: self.strip, largest, vertex: vertices[at], total })
    }

    /// Where each half-edge begins in the plane, and whether its two sides lie together there: across the edges of a spanning
    /// tree of the triangles, which leaves out shortest paths to the rim if it can. Of longest edges, since short ones turn what lies
    /// beyond them by more.
    fn lay_out(&self) -> (Vec<DVec2>, Vec<bool>) {
        let is_path = self.shortest_paths();
        let mut frames = vec![[DVec2::ZERO; 3]; self.triangles.len()];
        let mut is_joined = vec![false; self.sides().len()];
        let mut is_placed = vec![false; self.triangles.len()];
        let mut heap = BinaryHeap::new();
        frames[0] = self.placed(0, [self.faces[0][0], self.faces[0][1]], [DVec2::ZERO, DVec2::X]);
        is_placed[0] = true;
        // Lengths are not negative, so that their bits are ordered as they are.
        let reached = |triangle: usize| {
            let key = |side: usize| (!is_path[side], self.length(side).to_bits(), side);
            (3 * triangle..3 * triangle + 3).map(key)
        };
        heap.extend(reached(0));
        while let Some((_, _, side)) = heap.pop() {
            let Some(twin) = self.edges.twin(side).filter(|twin| !is_placed[twin / 3]) else { continue };
            let (from, to) = (side / 3, twin / 3);
            (is_joined[side], is_joined[twin], is_placed[to]) = (true, true, true);
            frames[to] = if self.origins[from] == self.origins[to] {
                frames[from]
            } else {
                let ends = self.edge_of_face(twin);
                self.placed(to, ends, ends.map(|vertex| self.place(from, &frames[from], vertex)))
            };
            heap.extend(reached(to));
        }
        let corner = |side: usize| self.place(side / 3, &frames[side / 3], self.vertex(side));
        (self.sides().map(corner).collect(), is_joined)
    }

    /// The half-edges on shortest paths of edges from one rim to everything; other rims are passed along at no cost.
    fn shortest_paths(&self) -> Vec<bool> {
        let count = self.is_inner.len();
        let mut starts = vec![0_usize; count + 1];
        let ends = |side: usize| [side, next(side)].map(|side| self.numbers[side]);
        self.sides().flat_map(ends).for_each(|number| starts[number + 1] += 1);
        (0..count).for_each(|number| starts[number + 1] += starts[number]);
        let (mut beside, mut filled) = (vec![0; starts[count]], starts.clone());
        for (side, end) in self.sides().flat_map(|side| ends(side).map(|end| (side, end))) {
            beside[filled[end]] = side;
            filled[end] += 1;
        }
        let mut least = vec![f64::INFINITY; count];
        let mut via = vec![None; count];
        let first = self.rims().first().map_or(0, |&side| self.numbers[side]);
        least[first] = 0.0;
        let mut heap = BinaryHeap::from([Reverse((0_u64, first))]);
        while let Some(Reverse((bits, number))) = heap.pop() {
            if f64::from_bits(bits) > least[number] {
                continue;
            }
            for &side in &beside[starts[number]..starts[number + 1]] {
                let [a, b] = ends(side);
                let end = if a == number { b } else { a };
                let is_rim = self.edges.twin(side).is_none();
                let sum = least[number] + if is_rim { 0.0 } else { self.length(side) };
                if sum < least[end] {
                    (least[end], via[end]) = (sum, Some(side));
                    heap.push(Reverse((sum.to_bits(), end)));
                }
            }
        }
        let mut is_path = vec![false; self.sides().len()];
        for side in via.into_iter().flatten() {
            is_path[side] = true;
            if let Some(twin) = self.edges.twin(side) {
                is_path[twin] = true;
            }
        }
        is_path
    }

    /// The edge of its face that a half-edge is on, in that direction.
    fn edge_of_face(&self, side: usize) -> [u32; 2] {
        let face = self.faces[side / 3];
        let ends = [self.vertex(side), self.vertex(next(side))];
        let [a, b] = ends.iter().find_map(|&vertex| self.crossing(vertex)).map_or(ends, |(edge, _)| edge);
        let leads_on = (0..3).any(|k| [face[k], face[(k + 1) % 3]] == [a, b]);
        if leads_on { [a, b] } else { [b, a] }
    }

    /// The edge of the field that a vertex is on, and which share of the way; none for a vertex of the field.
    fn crossing(&self, vertex: u32) -> Option<([u32; 2], f64)> {
        let index = (vertex as usize).checked_sub(self.field.positions().len())?;
        self.strips.crossings.get(index).copied()
    }

    /// Where a vertex of a triangle is in the plane, by the corners of its face.
    fn place(&self, triangle: usize, frame: &[DVec2; 3], vertex: u32) -> DVec2 {
        let corner = |vertex: u32| {
            let at = self.faces[triangle].iter().position(|&corner| corner == vertex);
            at.map_or(DVec2::ZERO, |at| frame[at])
        };
        match self.crossing(vertex) {
            Some(([below, above], share)) => corner(below).lerp(corner(above), share),
            None => corner(vertex),
        }
    }

    /// The corners of a triangle's face in the plane, where the edge from `a` to `b` goes from one place toward the other, with the
    /// third corner on its left.
    fn placed(&self, triangle: usize, [a, b]: [u32; 2], [from, toward]: [DVec2; 2]) -> [DVec2; 3] {
        let face = self.faces[triangle];
        let position = |vertex: u32| self.field.positions()[vertex as usize];
        let direction = (toward - from).try_normalize().unwrap_or(DVec2::X);
        let edge = position(b) - position(a);
        let along = triangle::unit(edge);
        face.map(|vertex| {
            if vertex == a {
                from
            } else if vertex == b {
                from + triangle::length(edge) * direction
            } else {
                let to_apex = position(vertex) - position(a);
                let ahead = to_apex.dot(along);
                from + ahead * direction + triangle::length(to_apex - ahead * along) * direction.perp()
            }
        })
    }

    /// Joins the sides that lie together in the plane though no edge of the tree says so: where all but one edge around a flat
    /// inner vertex are joined, so is that one, by its angles. What is left apart is where a piece with holes or tips is cut open.
    fn close(&self, is_flat: &[bool], is_joined: &mut [bool]) {
        // Open edges around each vertex, by one of their half-edges; a sum of their numbers, so that one that is left is known.
        let (mut counts, mut sums) = (vec![0_usize; is_flat.len()], vec![0_usize; is_flat.len()]);
        for side in self.open(is_joined) {
            for end in [side, next(side)].map(|side| self.numbers[side]) {
                counts[end] += 1;
                sums[end] += side;
            }
        }
        let mut ready: Vec<usize> =
            (0..is_flat.len()).filter(|&vertex| is_flat[vertex] && counts[vertex] == 1).collect();
        while let Some(vertex) = ready.pop() {
            if counts[vertex] != 1 {
                continue;
            }
            let side = sums[vertex];
            self.join(side, is_joined);
            for end in [side, next(side)].map(|side| self.numbers[side]) {
                counts[end] -= 1;
                sums[end] -= side;
                if is_flat[end] && counts[end] == 1 {
                    ready.push(end);
                }
            }
        }
    }

    /// Joins the sides of cuts that lie together in the plane all along, as around holes of what is flat; whether there are any.
    fn close_in_plane(&self, is_flat: &[bool], corners: &[DVec2], is_joined: &mut [bool]) -> bool {
        let open: Vec<usize> = self.open(is_joined).collect();
        let low = corners.iter().copied().reduce(DVec2::min).unwrap_or_default();
        let high = corners.iter().copied().reduce(DVec2::max).unwrap_or_default();
        let tolerance = SAME_PLACE * (high - low).length();
        // A cut is what hangs together by vertices where it neither ends nor branches.
        let mut around = vec![Vec::new(); is_flat.len()];
        for (cut, &side) in open.iter().enumerate() {
            [side, next(side)].iter().for_each(|&end| around[self.numbers[end]].push(cut as u32));
        }
        let cuts = UnionFind::new(open.len());
        for (vertex, around) in around.iter().enumerate() {
            if let (true, &[a, b]) = (is_flat[vertex], around.as_slice()) {
                cuts.join(a, b);
            }
        }
        let mut is_together = vec![true; open.len()];
        for (cut, &side) in open.iter().enumerate() {
            let Some(twin) = self.edges.twin(side) else { continue };
            let meets = |a: usize, b: usize| corners[a].distance(corners[b]) <= tolerance;
            let least = cuts.least(cut as u32) as usize;
            is_together[least] &= meets(side, next(twin)) && meets(next(side), twin);
        }
        let mut any = false;
        for (cut, &side) in open.iter().enumerate() {
            if is_together[cuts.least(cut as u32) as usize] {
                self.join(side, is_joined);
                any = true;
            }
        }
        any
    }

    /// Edges whose sides are apart, by one of their half-edges.
    fn open(&self, is_joined: &[bool]) -> impl Iterator<Item = usize> {
        self.sides().filter(|&side| !is_joined[side] && self.edges.twin(side).is_some_and(|twin| twin > side))
    }

    fn join(&self, side: usize, is_joined: &mut [bool]) {
        is_joined[side] = true;
        if let Some(twin) = self.edges.twin(side) {
            is_joined[twin] = true;
        }
    }
}

/// Whether one loop goes around others that are holes; not around a branch point, as those of a ring of several turns do.
fn is_around_holes(loops: &[Vec<DVec2>]) -> bool {
    let turns: Vec<f64> = loops.iter().map(|outline| (turning(outline) / TAU).round()).collect();
    turns.iter().filter(|&&turns| turns == 1.0).count() == 1
        && turns.iter().filter(|&&turns| turns == -1.0).count() == turns.len() - 1
}

/// By how much a loop turns to the left in all, in radians.
fn turning(outline: &[DVec2]) -> f64 {
    let next = |index: usize| outline[(index + 1) % outline.len()];
    let steps = outline.iter().enumerate().map(|(index, &point)| next(index) - point);
    let steps: Vec<DVec2> = steps.filter(|&step| step != DVec2::ZERO).collect();
    let angle = |(index, &step): (usize, &DVec2)| step.angle_to(steps[(index + 1) % steps.len()]).clamp(-PI, PI);
    steps.iter().enumerate().map(angle).sum()
}

/// The half-edge after another one around its triangle.
fn next(side: usize) -> usize {
    if side % 3 == 2 { side - 2 } else { side + 1 }
}
