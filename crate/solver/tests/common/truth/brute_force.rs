//! Exact polyhedral distances between the vertices of small meshes, by brute force: every sequence of faces from a vertex
//! is unfolded, as long as straight lines through it may be shortest, in numbers of 32 digits. Any triangles will do: many
//! on an edge, needles, triangles of no area, several components.
//!
//! A shortest path is straight from vertex to vertex, and crosses no face twice. So lengths of straight lines make a graph,
//! whose distances are those of the surface.

use std::collections::HashMap;

use glam::DVec3;

use super::double_double::{DoubleDouble, Vector, area, combination, cross, difference, dot, length};

/// Where a window is left out for a longer path through it, by what share longer at least: what 32 digits lose on the way
/// through needles is far less.
const CLEARLY_LONGER: DoubleDouble = DoubleDouble::new(1.0 + 1e-14);

/// `#V × #V` distances, infinite where there is no path. No triangle may have two corners of one position.
pub fn all_distances(positions: &[DVec3], triangles: &[[u32; 3]]) -> Vec<Vec<f64>> {
    let largest = positions.iter().map(|position| position.abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
    // A power of two, near 1 / largest, which no digit is lost by.
    let scale = f64::exp2(-largest.log2().round());
    let scaled: Vec<DVec3> = positions.iter().map(|&position| position * scale).collect();
    let mut search = Search::new(&scaled, triangles);
    search.close();
    for source in 0..positions.len() {
        search.see_from(source);
    }
    search.close();
    search.distances.into_iter().map(|row| row.into_iter().map(|value| value.to_f64() / scale).collect()).collect()
}

/// A side of a triangle, from the first corner to the second, and where the third is beside it.
#[derive(Clone, Copy)]
struct Side {
    length: DoubleDouble,
    /// Where the altitude of the third corner meets the line of the side, from each end.
    feet: [DoubleDouble; 2],
    height: DoubleDouble,
    /// From the third corner to the ends.
    legs: [DoubleDouble; 2],
}

impl Side {
    fn new([p, q, r]: [DVec3; 3]) -> Self {
        let (along, up, down) = (difference(q, p), difference(r, p), difference(r, q));
        let length_of_side = length(along);
        assert!(length_of_side > DoubleDouble::ZERO, "{p} is two corners of a triangle");
        Self {
            length: length_of_side,
            feet: [dot(up, along) / length_of_side, -(dot(down, along) / length_of_side)],
            height: area(along, up) / length_of_side,
            legs: [length(up), length(down)],
        }
    }

    fn reversed(self) -> Self {
        let Self { length, feet: [a, b], height, legs: [c, d] } = self;
        Self { length, feet: [b, a], height, legs: [d, c] }
    }
}

struct Search<'a> {
    triangles: &'a [[u32; 3]],
    /// The side from each corner to the next.
    sides: Vec<[Side; 3]>,
    /// The triangles of each edge, whose ends ascend, each with the corner where its side begins.
    edges: HashMap<[u32; 2], Vec<(usize, usize)>>,
    /// Lengths of the shortest paths known.
    distances: Vec<Vec<DoubleDouble>>,
    /// Whether the sequence of faces has a face.
    is_crossed: Vec<bool>,
}

/// What the source, at the origin of the plane, sees of an edge.
#[derive(Clone, Copy)]
struct Window {
    /// The ends of the edge, counter-clockwise as seen from the source.
    ends: [u32; 2],
    at: Vector<2>,
    /// From the first end to the second, of length 1.
    direction: Vector<2>,
    length: DoubleDouble,
    /// What lies counter-clockwise of the first and clockwise of the second is seen.
    rays: [Vector<2>; 2],
}

impl<'a> Search<'a> {
    fn new(positions: &[DVec3], triangles: &'a [[u32; 3]]) -> Self {
        let mut edges: HashMap<_, Vec<_>> = HashMap::new();
        let mut sides = Vec::new();
        let mut distances = vec![vec![DoubleDouble::INFINITY; positions.len()]; positions.len()];
        for (vertex, row) in distances.iter_mut().enumerate() {
            row[vertex] = DoubleDouble::ZERO;
        }
        for (face, triangle) in triangles.iter().enumerate() {
            let side = |k: usize| Side::new([0, 1, 2].map(|step| positions[triangle[(k + step) % 3] as usize]));
            let sides_of_face = [0, 1, 2].map(side);
            for (k, side) in sides_of_face.iter().enumerate() {
                let [a, b] = [triangle[k], triangle[(k + 1) % 3]];
                edges.entry([a.min(b), a.max(b)]).or_default().push((face, k));
                for [a, b] in [[a, b], [b, a]] {
                    distances[a as usize][b as usize] = side.length;
                }
            }
            sides.push(sides_of_face);
        }
        Self { triangles, sides, edges, distances, is_crossed: vec![false; triangles.len()] }
    }

    /// Shortest paths of what is known (Floyd and Warshall).
    fn close(&mut self) {
        for middle in 0..self.distances.len() {
            let second = self.distances[middle].clone();
            for row in &mut self.distances {
                let first = row[middle];
                if first.is_finite() {
                    row.iter_mut().zip(&second).for_each(|(value, &second)| *value = value.min(first + second));
                }
            }
        }
    }

    /// Straight lines from a vertex to all that it sees.
    fn see_from(&mut self, source: usize) {
        for face in 0..self.triangles.len() {
            let Some(k) = self.triangles[face].iter().position(|&corner| corner as usize == source) else { continue };
            let (near, far) = (self.sides[face][k], self.sides[face][(k + 1) % 3]);
            let [foot, foot_behind] = near.feet;
            let window = Window {
                ends: [self.triangles[face][(k + 1) % 3], self.triangles[face][(k + 2) % 3]],
                at: [near.length, DoubleDouble::ZERO],
                direction: [-(foot_behind / far.length), near.height / far.length],
                length: far.length,
                rays: [[near.length, DoubleDouble::ZERO], [foot, near.height]],
            };
            // Beside a flat triangle the source sees the half plane, or nothing.
            if near.height > DoubleDouble::ZERO || foot < DoubleDouble::ZERO {
                self.cross_edge(source, face, window);
            }
        }
    }

    /// Through an edge, out of a face, into all others there.
    fn cross_edge(&mut self, source: usize, from: usize, window: Window) {
        if self.is_passed_by(source, &window) {
            return;
        }
        self.is_crossed[from] = true;
        let [p, q] = window.ends;
        let beyond = self.edges[&[p.min(q), p.max(q)]].clone();
        for (face, k) in beyond {
            if !self.is_crossed[face] {
                self.cross_face(source, (face, k), window);
            }
        }
        self.is_crossed[from] = false;
    }

    fn cross_face(&mut self, source: usize, (face, k): (usize, usize), window: Window) {
        let Window { ends: [p, q], at, direction, rays: [right, left], .. } = window;
        let (apex, side) = (self.triangles[face][(k + 2) % 3], self.sides[face][k]);
        let side = if self.triangles[face][k] == p { side } else { side.reversed() };
        let out = [direction[1], -direction[0]];
        let [near, far] = side.feet;
        let seen = combination(at, (near, direction), (side.height, out));
        let is_left = cross(right, seen);
        let is_right = cross(seen, left);
        if is_left >= DoubleDouble::ZERO && is_right >= DoubleDouble::ZERO {
            let known = &mut self.distances[source][apex as usize];
            *known = known.min(length(seen));
        }
        let origin = [DoubleDouble::ZERO; 2];
        if is_left > DoubleDouble::ZERO {
            let [down, _] = side.legs;
            let direction = combination(origin, (near / down, direction), (side.height / down, out));
            let rays = [right, if is_right >= DoubleDouble::ZERO { seen } else { left }];
            self.cross_edge(source, face, Window { ends: [p, apex], at, direction, length: down, rays });
        }
        if is_right > DoubleDouble::ZERO {
            let [_, up] = side.legs;
            let direction = combination(origin, (far / up, direction), (-(side.height / up), out));
            let rays = [if is_left >= DoubleDouble::ZERO { seen } else { right }, left];
            self.cross_edge(source, face, Window { ends: [apex, q], at: seen, direction, length: up, rays });
        }
    }

    /// Whether all that is seen through a window is nearer by other paths: by one of the edge's ends (Xin and Wang,
    /// "Improving Chen and Han's algorithm on the discrete geodesic problem", 2009), or because nothing is so far away.
    fn is_passed_by(&self, source: usize, window: &Window) -> bool {
        let &Window { ends, at, direction, length: whole, rays } = window;
        let known = &self.distances[source];
        let slopes = rays.map(|ray| cross(ray, direction));
        if slopes.contains(&DoubleDouble::ZERO) {
            return false;
        }
        let hit = |k: usize| (-(cross(rays[k], at) / slopes[k])).max(DoubleDouble::ZERO).min(whole);
        let hits = [hit(0), hit(1)];
        let far = hits.map(|hit| length(combination(at, (hit, direction), (DoubleDouble::ZERO, direction))));
        let passes = |by: u32, along: DoubleDouble, straight: DoubleDouble| {
            (known[by as usize] + along) * CLEARLY_LONGER < straight
        };
        if passes(ends[0], hits[1], far[1]) || passes(ends[1], whole - hits[0], far[0]) {
            return true;
        }
        let nearest = -dot(at, direction);
        let is_between = hits[0] < nearest && nearest < hits[1];
        let least = if is_between { cross(at, direction).abs() } else { far[0].min(far[1]) };
        let farthest = known.iter().filter(|known| known.is_finite()).fold(DoubleDouble::ZERO, |a, &b| a.max(b));
        farthest * CLEARLY_LONGER < least
    }
}
