//! A piece of a strip unfolded into the plane, triangle after triangle.
//!
//! A surface has a plane shape of the same lengths where the angles around each inner vertex add up to a full turn; what is
//! missing to it is the angle defect, the curvature of that vertex (K. Polthier and M. Schmies, "Straightest geodesics on
//! polyhedral surfaces", 1998, section 2). A piece with holes is cut open besides, and one with sources that are tips of cones from
//! these to its rim.

use std::collections::BinaryHeap;
use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use heatwalk_surface::triangle;

use crate::error::{MAX_DEFECT, NotDevelopable};
use crate::field::Edges;
use crate::strips::Strips;

/// Triangles of one strip that hang together by edges.
pub(crate) struct Piece<'a> {
    strips: &'a Strips,
    strip: usize,
    /// Of the strips.
    triangles: Vec<[u32; 3]>,
    edges: Edges,
    /// Its vertices, ascending, by which others are numbered here.
    vertices: Vec<u32>,
    /// Those around which all angles are its own.
    is_inner: Vec<bool>,
}

/// The pieces of a strip, in the order of their first triangles.
pub(crate) fn pieces(strips: &Strips, strip: usize) -> Vec<Piece<'_>> {
    let triangles = &strips.triangles[strips.ranges[strip].clone()];
    let edges = Edges::of(triangles);
    let mut is_taken = vec![false; triangles.len()];
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
            for beside in (3 * triangle..3 * triangle + 3).filter_map(|side| edges.twin(side)) {
                if !is_taken[beside / 3] {
                    is_taken[beside / 3] = true;
                    members.push(beside / 3);
                }
            }
        }
        members.sort_unstable();
        let own: Vec<[u32; 3]> = members.iter().map(|&triangle| triangles[triangle]).collect();
        pieces.push(Piece::new(strips, strip, own));
    }
    pieces
}

impl<'a> Piece<'a> {
    fn new(strips: &'a Strips, strip: usize, triangles: Vec<[u32; 3]>) -> Self {
        let edges = Edges::of(&triangles);
        let mut vertices = triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let is_inner = vec![true; vertices.len()];
        let mut piece = Self { strips, strip, triangles, edges, vertices, is_inner };
        for side in piece.sides().filter(|&side| piece.edges.twin(side).is_none()) {
            for end in [side, next(side)].map(|side| piece.number(side)) {
                piece.is_inner[end] = false;
            }
        }
        piece
    }

    /// The loops around its plane shape, counter-clockwise around it and clockwise around holes, in the field's unit.
    pub(crate) fn unroll(&self) -> Result<Vec<Vec<DVec2>>, NotDevelopable> {
        let tips = self.tips()?;
        let (corners, mut is_joined) = self.lay_out();
        self.close(&tips, &mut is_joined);
        let mut loops = Vec::new();
        let mut is_walked = is_joined.clone();
        for start in 0..is_walked.len() {
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
        Ok(loops)
    }

    fn position(&self, side: usize) -> DVec3 {
        self.strips.positions[self.vertex(side) as usize]
    }

    /// The vertex that a half-edge leaves.
    fn vertex(&self, side: usize) -> u32 {
        self.triangles[side / 3][side % 3]
    }

    fn sides(&self) -> std::ops::Range<usize> {
        0..3 * self.triangles.len()
    }

    /// The number of the vertex that a half-edge leaves.
    fn number(&self, side: usize) -> usize {
        self.vertices.partition_point(|&vertex| vertex < self.vertex(side))
    }

    /// The sources that are tips of cones: cut open to the rim, they lie in the plane. Refuses a piece that is curved elsewhere.
    fn tips(&self) -> Result<Vec<usize>, NotDevelopable> {
        let mut angles = vec![0.0; self.vertices.len()];
        let mut is_source = self.is_inner.clone();
        let distance = |side: usize| self.strips.distances[self.vertex(side) as usize];
        for side in self.sides() {
            // Nothing beside it is nearer. Of an inner vertex, each edge begins there in one triangle.
            is_source[self.number(side)] &= distance(side) < distance(next(side));
            let corners = [side, next(side), next(next(side))].map(|side| self.position(side));
            angles[self.number(side)] += triangle::angle(corners);
        }
        let (mut largest, mut at, mut total) = (0.0, 0, 0.0);
        let mut tips = Vec::new();
        for (index, angle) in angles.into_iter().enumerate().filter(|&(index, _)| self.is_inner[index]) {
            let defect = TAU - angle;
            if defect > MAX_DEFECT && is_source[index] {
                tips.push(index);
                continue;
            }
            let defect = defect.abs();
            total += defect;
            if defect > largest {
                (largest, at) = (defect, index);
            }
        }
        if total <= MAX_DEFECT {
            return Ok(tips);
        }
        Err(NotDevelopable { strip: self.strip, largest, vertex: self.vertices[at], total })
    }

    /// Where each half-edge begins in the plane, and whether its two sides lie together there: across the edges of a spanning
    /// tree of the triangles, of the longest edges, since short ones turn what lies beyond them by more.
    fn lay_out(&self) -> (Vec<DVec2>, Vec<bool>) {
        let mut corners = vec![DVec2::ZERO; self.sides().len()];
        let mut is_joined = vec![false; self.sides().len()];
        let mut is_placed = vec![false; self.triangles.len()];
        let mut heap = BinaryHeap::new();
        let length = |side: usize| triangle::length(self.position(next(side)) - self.position(side));
        corners[1] = DVec2::new(length(0), 0.0);
        self.place_apex(0, &mut corners);
        is_placed[0] = true;
        // Lengths are not negative, so that their bits are ordered as they are.
        let reached =
            |triangle: usize| (3 * triangle..3 * triangle + 3).map(move |side| (length(side).to_bits(), side));
        heap.extend(reached(0));
        while let Some((_, side)) = heap.pop() {
            let Some(twin) = self.edges.twin(side).filter(|twin| !is_placed[twin / 3]) else { continue };
            (is_joined[side], is_joined[twin], is_placed[twin / 3]) = (true, true, true);
            (corners[twin], corners[next(twin)]) = (corners[next(side)], corners[side]);
            self.place_apex(twin, &mut corners);
            heap.extend(reached(twin / 3));
        }
        (corners, is_joined)
    }

    /// Places the third corner of a triangle on the left of a side that lies in the plane.
    fn place_apex(&self, side: usize, corners: &mut [DVec2]) {
        let apex = next(next(side));
        let along = triangle::unit(self.position(next(side)) - self.position(side));
        let to_apex = self.position(apex) - self.position(side);
        let ahead = to_apex.dot(along);
        let aside = triangle::length(to_apex - ahead * along);
        let direction = (corners[next(side)] - corners[side]).try_normalize().unwrap_or(DVec2::X);
        corners[apex] = corners[side] + ahead * direction + aside * direction.perp();
    }

    /// Joins the sides that lie together in the plane though no edge of the tree says so: where all but one edge around an
    /// inner vertex are joined, so is that one, by its angles. What is left apart is where a piece with holes or `tips` is cut open.
    fn close(&self, tips: &[usize], is_joined: &mut [bool]) {
        let mut is_flat = self.is_inner.clone();
        tips.iter().for_each(|&tip| is_flat[tip] = false);
        // Open edges around each vertex, by one of their half-edges; a sum of their numbers, so that one that is left is known.
        let (mut counts, mut sums) = (vec![0_usize; self.vertices.len()], vec![0_usize; self.vertices.len()]);
        let mut ready = Vec::new();
        for side in self.sides() {
            if self.edges.twin(side).is_some_and(|twin| twin > side) && !is_joined[side] {
                for end in [side, next(side)].map(|side| self.number(side)) {
                    counts[end] += 1;
                    sums[end] += side;
                }
            }
        }
        ready.extend((0..self.vertices.len()).filter(|&vertex| is_flat[vertex] && counts[vertex] == 1));
        while let Some(vertex) = ready.pop() {
            if counts[vertex] != 1 {
                continue;
            }
            let side = sums[vertex];
            is_joined[side] = true;
            if let Some(twin) = self.edges.twin(side) {
                is_joined[twin] = true;
            }
            for end in [side, next(side)].map(|side| self.number(side)) {
                counts[end] -= 1;
                sums[end] -= side;
                if is_flat[end] && counts[end] == 1 {
                    ready.push(end);
                }
            }
        }
    }
}

/// The half-edge after another one around its triangle.
fn next(side: usize) -> usize {
    if side % 3 == 2 { side - 2 } else { side + 1 }
}
