//! Surfaces with large triangles, divided into small ones in the same places.

use std::collections::HashMap;

use glam::DVec3;
use heatwalk_surface::triangle;

use crate::refine::{sides, split};

/// Triangles divided until no edge is longer than wanted. Distances on the surface stay what they are.
#[derive(Debug, Clone)]
pub struct Division {
    /// Those of the surface, and after them the middles of edges.
    pub positions: Vec<DVec3>,
    /// `#P × 3`, the parts of one triangle after those of the one before.
    pub triangles: Vec<[u32; 3]>,
    parts: Vec<Part>,
}

/// Where a part lies: its triangle, and the weights of that one's corners at the part's.
#[derive(Debug, Clone, Copy)]
struct Part {
    origin: u32,
    corners: [[f64; 3]; 3],
}

impl Division {
    /// Divides edges longer than `longest` in their middles, again and again while there are fewer parts than `most`.
    pub fn of(positions: &[DVec3], triangles: &[[u32; 3]], longest: f64, most: usize) -> Self {
        let whole = |origin| Part { origin, corners: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };
        let mut division = Self {
            positions: positions.to_vec(),
            triangles: triangles.to_vec(),
            parts: (0..triangles.len() as u32).map(whole).collect(),
        };
        while division.parts.len() < most && division.divide(longest) {}
        division
    }

    /// Divides long edges once; whether there were any.
    fn divide(&mut self, longest: f64) -> bool {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        for &corners in &self.triangles {
            for side in sides(corners) {
                let [a, b] = side.map(|end| self.positions[end as usize]);
                if triangle::length(b - a) > longest && !middles.contains_key(&side) {
                    middles.insert(side, self.positions.len() as u32);
                    self.positions.push(a.midpoint(b));
                }
            }
        }
        let (triangles, parts) = (std::mem::take(&mut self.triangles), std::mem::take(&mut self.parts));
        for (corners, part) in triangles.into_iter().zip(parts) {
            let sides = sides(corners);
            let found = sides.map(|side| middles.get(&side).copied());
            let weights_of = |vertex: u32| {
                if let Some(k) = corners.iter().position(|&corner| corner == vertex) {
                    return part.corners[k];
                }
                let k = found.iter().position(|&middle| middle == Some(vertex)).unwrap_or_default();
                let (a, b) = (part.corners[k], part.corners[(k + 1) % 3]);
                std::array::from_fn(|i| 0.5 * (a[i] + b[i]))
            };
            split(corners, found, &self.positions, |corners| {
                self.triangles.push(corners);
                self.parts.push(Part { origin: part.origin, corners: corners.map(weights_of) });
            });
        }
        !middles.is_empty()
    }

    /// The part in which a place of a triangle is, and the weights of the part's corners there. None where there is no such triangle.
    pub fn part_at(&self, triangle: u32, weights: [f64; 3]) -> Option<(u32, [f64; 3])> {
        let first = self.parts.partition_point(|part| part.origin < triangle);
        let of_triangle = self.parts[first..].iter().take_while(|part| part.origin == triangle);
        let inside = of_triangle.map(|part| part.weights_of(weights));
        let least = |weights: &[f64; 3]| weights.iter().copied().fold(f64::INFINITY, f64::min);
        let (index, weights) = (first as u32..).zip(inside).max_by(|(_, a), (_, b)| least(a).total_cmp(&least(b)))?;
        let within = weights.map(|weight| weight.max(0.0));
        let sum: f64 = within.iter().sum();
        Some((index, within.map(|weight| weight / sum)))
    }

    /// The triangle that a part is of, and the weights of its corners at a place of the part.
    pub fn place_in(&self, part: u32, weights: [f64; 3]) -> (u32, [f64; 3]) {
        let Part { origin, corners } = self.parts[part as usize];
        (origin, std::array::from_fn(|i| (0..3).map(|k| weights[k] * corners[k][i]).sum()))
    }
}

impl Part {
    /// The weights of its corners at a place of the triangle, by Cramer's rule.
    fn weights_of(&self, weights: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.corners.map(DVec3::from_array);
        let place = DVec3::from_array(weights);
        let whole = a.dot(b.cross(c));
        [place.dot(b.cross(c)) / whole, place.dot(c.cross(a)) / whole, place.dot(a.cross(b)) / whole]
    }
}
