//! Distances of pairs of vertices without a search: hub labels over nested dissection.
//!
//! Separators part the mesh again and again. Each vertex has the exact distances to all vertices of the separators of the parts that it
//! is in, and to those of its own smallest part. A shortest path between two vertices enters the separators of the parts that have them both: where it
//! goes through a vertex of these, the sum of two labels is its length; where it crosses an edge between two of them, the sum at the nearer end is
//! longer by no more than that edge, and in fact by little, since it grows with the square of the way aside.
//!
//! Cohen, Halperin, Kaplan, Zwick, "Reachability and distance queries via 2-hop labels" (2003); Dibbelt, Strasser, Wagner, "Customizable
//! contraction hierarchies" (2016), for labels by nested dissection.

mod build;
mod error;
mod file;
mod tree;

pub use error::{Error, Result};

use tree::{NONE, Tree};

/// How much more than a number itself its neighbour in 32 bits may be.
const ROUNDING: f64 = f32::EPSILON as f64;

/// Distances between all vertices of a surface, as labels.
#[derive(Debug, Clone, PartialEq)]
pub struct DistanceIndex {
    /// Of the surface that it is of.
    fingerprint: u64,
    /// Of each vertex of the input its place in the order of the tree; [`NONE`] where no face uses it.
    place_of_input: Vec<u32>,
    tree: Tree,
    /// What a length of 1 below is in the file's unit: a power of two, which rounds nothing.
    unit: f64,
    /// Of each place, the longest edge from its vertex to one of a separator.
    longest: Vec<f32>,
    /// Of each place, one after another: distances to the separators above it, those of the whole first.
    labels: Vec<f32>,
}

/// What is known of the distance of two vertices, in the file's unit. Infinite where one is not reached from the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// It is no less than this.
    pub lower: f64,
    /// It is no more than this, the length of a path; much nearer to it than the lower one.
    pub upper: f64,
}

impl Bounds {
    const APART: Self = Self { lower: f64::INFINITY, upper: f64::INFINITY };
}

impl DistanceIndex {
    /// Bounds of the distance of two vertices of the input, by their numbers there.
    ///
    /// # Errors
    /// [`Error::NoVertex`] for a vertex that the input has not.
    pub fn distance(&self, from: usize, to: usize) -> Result<Bounds> {
        let place = |vertex: usize| {
            let place = self.place_of_input.get(vertex).copied();
            place.ok_or(Error::NoVertex { vertex, count: self.place_of_input.len() })
        };
        let [from, to] = [place(from)?, place(to)?];
        if from == NONE || to == NONE {
            return Ok(Bounds::APART);
        }
        Ok(self.between(from as usize, to as usize))
    }

    fn between(&self, from: usize, to: usize) -> Bounds {
        let common = self.tree.common(from, to);
        for (hub, other) in [(from, to), (to, from)] {
            if self.tree.part_of(hub) == common {
                let distance = f64::from(self.labels_of(other)[self.tree.label_of(hub)]);
                return self.bounds(distance, distance);
            }
        }
        let [from, to] = [self.labels_of(from), self.labels_of(to)];
        let (mut lower, mut upper, mut apart) = (f32::INFINITY, f32::INFINITY, 0.0_f32);
        for (labels, places) in self.tree.upward(common) {
            let pairs = from[labels.clone()].iter().zip(&to[labels]);
            for ((from, to), longest) in pairs.zip(&self.longest[places]) {
                let sum = from + to;
                upper = upper.min(sum);
                lower = lower.min(sum - longest);
                // The triangle inequality, without what rounding may have made of its small rest. Where both are infinite it says nothing.
                apart = apart.max((from - to).abs() - sum * f32::EPSILON);
            }
        }
        self.bounds(f64::from(lower.max(apart)), f64::from(upper))
    }

    /// In the file's unit, with room for numbers and sums of 32 bits.
    fn bounds(&self, lower: f64, upper: f64) -> Bounds {
        Bounds { lower: lower * (1.0 - 2.0 * ROUNDING) * self.unit, upper: upper * (1.0 + 2.0 * ROUNDING) * self.unit }
    }

    fn labels_of(&self, place: usize) -> &[f32] {
        &self.labels[self.tree.labels_of(place)]
    }

    /// Vertices of the input.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.place_of_input.len()
    }

    /// Labels of all vertices together.
    #[must_use]
    pub fn label_count(&self) -> usize {
        self.labels.len()
    }
}
