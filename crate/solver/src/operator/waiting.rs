//! Edges that wait to be flipped, and their order.
//!
//! What is farthest from Delaunay goes first, so that flat triangles in a row, as at a T-junction, are flipped away one after another
//! and not among themselves. Around a vertex of many edges, the next edge would always be the neighbor of the one before: flips would go
//! around it again and again, as often as the square of its edges says. So edges there go in rounds, the longest first, behind all
//! others: what changes in a round waits for the next one, which takes every second edge or so.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use heatwalk_base::csr::NONE;

/// A surface with a vertex of so many faces has hubs; then all vertices are hubs that have more than the second.
const LEAST_HUB: u32 = 256;
const HUB: u32 = 16;

/// Edges by one of their slots.
pub(super) struct Waiting {
    /// By rounds, in these by the bits of a positive number, which order as the number does.
    edges: BinaryHeap<(Reverse<u32>, u64, u32)>,
    /// By slot, the round for which it waits; [`NONE`] where it does not.
    rounds: Vec<u32>,
    /// Faces by vertex; none where there are no hubs.
    degrees: Vec<u32>,
}

/// An edge that may be flipped.
pub(super) struct Flippable {
    pub slot: u32,
    /// The vertices at its ends.
    pub ends: [u32; 2],
    pub length: f64,
    /// How far it is from Delaunay, above 0.
    pub excess: f64,
}

impl Waiting {
    /// None yet, of triangles of these vertices.
    pub fn new(faces: &[[u32; 3]]) -> Self {
        let corners = faces.as_flattened();
        let mut degrees = vec![0; corners.iter().max().map_or(0, |&last| last as usize + 1)];
        corners.iter().for_each(|&corner| degrees[corner as usize] += 1);
        if degrees.iter().all(|&degree| degree < LEAST_HUB) {
            degrees = Vec::new();
        }
        Self { edges: BinaryHeap::new(), rounds: vec![NONE; corners.len()], degrees }
    }

    /// Lets an edge wait that was changed in the round before this one.
    pub fn push(&mut self, edge: &Flippable, round: u32) {
        let is_at_hub = edge.ends.iter().any(|&end| self.degrees.get(end as usize).is_some_and(|&degree| degree > HUB));
        let (round, rank) = if is_at_hub { (round, edge.length) } else { (0, edge.excess) };
        let waits_for = &mut self.rounds[edge.slot as usize];
        if *waits_for == NONE || (is_at_hub && *waits_for < round) {
            *waits_for = round;
            self.edges.push((Reverse(round), rank.to_bits(), edge.slot));
        }
    }

    /// Takes the first out, with its round.
    pub fn pop(&mut self) -> Option<(u32, u32)> {
        loop {
            let (Reverse(round), _, slot) = self.edges.pop()?;
            // Else it has been put off.
            if self.rounds[slot as usize] == round {
                self.rounds[slot as usize] = NONE;
                return Some((slot, round));
            }
        }
    }

    /// An edge between two vertices has become one between others.
    pub fn flipped(&mut self, from: [u32; 2], to: [u32; 2]) {
        if !self.degrees.is_empty() {
            from.into_iter().for_each(|end| self.degrees[end as usize] -= 1);
            to.into_iter().for_each(|end| self.degrees[end as usize] += 1);
        }
    }
}
