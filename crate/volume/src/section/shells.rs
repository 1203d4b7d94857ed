//! Surfaces of equal distance, and how they are cut.

use std::collections::HashMap;

use glam::DVec3;

use super::cut::{Cut, Part, Plane};

/// Level sets of a distance as triangles: where its linear interpolation in each tetrahedron has a value.
#[derive(Debug, Clone, Default)]
pub struct Shells {
    /// Of each vertex where it is, in the file's unit.
    pub positions: Vec<DVec3>,
    /// Of each vertex the unit normal, along the gradient of the distance, away from the sources: that of the triangles around,
    /// weighted by their areas.
    pub normals: Vec<DVec3>,
    /// Of each vertex its level.
    pub values: Vec<f64>,
    /// Vertices of each triangle, counter-clockwise seen from where distance is larger. Triangles share vertices where tetrahedra share
    /// edges.
    pub triangles: Vec<[u32; 3]>,
}

impl Shells {
    /// Keeps what is in this part of a cut. Triangles that cross a plane are cut there; those at one edge share the vertex where it is cut.
    pub(super) fn clip(&mut self, cut: &Cut, part: Part) {
        let triangles = std::mem::take(&mut self.triangles);
        self.triangles = match cut {
            Cut::Whole => triangles,
            Cut::Plane(plane) => {
                let [left, taken_away] = self.split(&triangles, plane);
                match part {
                    Part::Left => left,
                    Part::TakenAway => taken_away,
                }
            }
            Cut::Wedge([first, second]) => {
                // What a wedge leaves is not convex: all before one plane, and of the rest what is before the other.
                let [mut left, beyond] = self.split(&triangles, first);
                let [rest, taken_away] = self.split(&beyond, second);
                left.extend(rest);
                match part {
                    Part::Left => left,
                    Part::TakenAway => taken_away,
                }
            }
        };
        self.compact();
    }

    /// Triangles before and beyond a plane. What crosses it is cut, with vertices added where it does.
    fn split(&mut self, triangles: &[[u32; 3]], plane: &Plane) -> [Vec<[u32; 3]>; 2] {
        let beyond: Vec<f64> = self.positions.iter().map(|&place| plane.beyond(place)).collect();
        let mut crossings: HashMap<[u32; 2], u32> = HashMap::new();
        let mut parts = [Vec::with_capacity(triangles.len()), Vec::new()];
        for &triangle in triangles {
            let is_beyond = triangle.map(|vertex| beyond[vertex as usize] > 0.0);
            let count = is_beyond.iter().filter(|&&is_beyond| is_beyond).count();
            if count % 3 == 0 {
                parts[usize::from(count == 3)].push(triangle);
                continue;
            }
            // Turned so that the first vertex is alone on its side.
            let alone = (0..3).find(|&k| is_beyond[k] == (count == 1)).unwrap_or_default();
            let [a, b, c] = [0, 1, 2].map(|k| triangle[(alone + k) % 3]);
            let [ab, ac] = [b, c].map(|other| {
                let ends = if is_beyond[alone] { [other, a] } else { [a, other] };
                // Where the plane goes through a vertex, the edge is not cut.
                if beyond[ends[0] as usize] == 0.0 {
                    return ends[0];
                }
                *crossings.entry(ends).or_insert_with(|| self.add_between(ends, ends.map(|end| beyond[end as usize])))
            });
            let pieces = [(count == 1, [a, ab, ac]), (count == 2, [ab, b, c]), (count == 2, [ab, c, ac])];
            for (is_beyond, piece @ [a, b, c]) in pieces {
                if a != b && b != c && c != a {
                    parts[usize::from(is_beyond)].push(piece);
                }
            }
        }
        parts
    }

    /// Adds the vertex between two that are before and beyond a plane by so much.
    fn add_between(&mut self, ends: [u32; 2], [before, beyond]: [f64; 2]) -> u32 {
        let share = before / (before - beyond);
        let [a, b] = ends.map(|end| end as usize);
        self.positions.push(self.positions[a].lerp(self.positions[b], share));
        self.normals.push(self.normals[a].lerp(self.normals[b], share).normalize_or(self.normals[a]));
        self.values.push(self.values[a]);
        self.positions.len() as u32 - 1
    }

    /// Leaves out vertices that no triangle has.
    fn compact(&mut self) {
        let mut number = vec![u32::MAX; self.positions.len()];
        for &vertex in self.triangles.iter().flatten() {
            number[vertex as usize] = 0;
        }
        for (next, number) in number.iter_mut().filter(|number| **number == 0).enumerate() {
            *number = next as u32;
        }
        let is_kept = |vertex: usize| number[vertex] != u32::MAX;
        self.positions = kept(&self.positions, is_kept);
        self.normals = kept(&self.normals, is_kept);
        self.values = kept(&self.values, is_kept);
        for vertex in self.triangles.iter_mut().flatten() {
            *vertex = number[*vertex as usize];
        }
    }
}

fn kept<T: Copy>(items: &[T], is_kept: impl Fn(usize) -> bool) -> Vec<T> {
    items.iter().enumerate().filter(|&(index, _)| is_kept(index)).map(|(_, &item)| item).collect()
}
