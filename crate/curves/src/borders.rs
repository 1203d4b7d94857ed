//! Borders of cells: where another source becomes the nearest one (bisectors, pieces of hyperbolas).
//!
//! Where the source nearest to any place can be asked for, a border crosses an edge between two cells where the answer changes, which is
//! found by halving. Within a triangle it is followed the same way along rays from the corner that it parts from the others. Triangles
//! whose corners are of three cells are divided until they are as small as what halving leaves.

use std::collections::{BTreeMap, HashMap};

use glam::DVec3;
use heatwalk_base::sort;
use heatwalk_surface::triangle;

use crate::field::Field;
use crate::isolines::{Curve, Isoline, Isolines, Kind};
use crate::refine::{sides, split};

/// Edges longer than this share of the diagonal are divided, so that no larger cell falls between corners.
const LONGEST: f64 = 0.01;

/// Where three cells meet, edges longer than this are divided.
const MEETING: f64 = 1e-6;

/// Divisions one after another, at most: of an edge as long as the diagonal, a thousandth of [`MEETING`] would be left.
const MOST_ROUNDS: usize = 30;

/// Chords of a border are no longer than this share of the diagonal.
const CHORD: f64 = 0.002;

/// Halvings of an edge: a millionth of it is left.
const HALVINGS: usize = 20;

/// The cells of sources on a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Borders {
    /// One for each two cells that meet, in the order of these, without values.
    pub curves: Isolines,
    /// The area of each cell, in the square of the unit of positions.
    pub areas: Vec<f64>,
    /// The surface divided along the borders, without what no source reaches.
    pub tiles: Vec<Tile>,
}

/// A triangle within one cell: of the surface, or a part of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tile {
    /// The number of the source.
    pub cell: u32,
    /// The triangle of the surface.
    pub triangle: u32,
    /// The weights of the corners there, in its orientation.
    pub corners: [[f64; 3]; 3],
}

/// A triangle of the surface, or a part of one.
#[derive(Clone, Copy)]
struct Part {
    corners: [u32; 3],
    origin: u32,
    /// Whether there is a source in the triangle.
    has_start: bool,
}

/// Where pieces of borders meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Node {
    /// On the edge between these vertices.
    Edge([u32; 2]),
    /// In a part.
    Inside(usize),
}

/// A piece of a border through one part.
struct Piece {
    cells: [u32; 2],
    ends: [Node; 2],
    /// Two or more.
    points: Vec<DVec3>,
    triangle: u32,
}

struct Tracing<F> {
    positions: Vec<DVec3>,
    nearest: Vec<Option<u32>>,
    parts: Vec<Part>,
    /// Of vertices that are not the surface's, the weights in a triangle of it.
    weights: HashMap<(u32, u32), [f64; 3]>,
    triangles: Vec<[u32; 3]>,
    diagonal: f64,
    /// Where borders cross edges: the share of the way from the lesser end.
    crossings: HashMap<[u32; 2], f64>,
    pieces: Vec<Piece>,
    areas: Vec<f64>,
    tiles: Vec<Tile>,
    ask: F,
}

impl Borders {
    /// `nearest`: the number of the source that is nearest to each vertex, below `cells`, or none. `ask` gives that of a place: a
    /// triangle, and weights of its corners. `starts`: triangles in which sources are. Where a cell that has no vertex is narrower than a
    /// hundredth of the diagonal, borders may be missed.
    ///
    /// # Errors
    /// Those of `ask`.
    ///
    /// # Panics
    /// Where there is not one number a vertex.
    pub fn trace<E>(
        field: &Field,
        (nearest, cells): (&[Option<u32>], usize),
        starts: &[u32],
        ask: impl FnMut(u32, [f64; 3]) -> Result<Option<u32>, E>,
    ) -> Result<Self, E> {
        let (positions, triangles) = (field.positions(), field.triangles());
        assert_eq!(nearest.len(), positions.len(), "one number a vertex");
        let low = positions.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        let high = positions.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
        let mut has_start = vec![false; triangles.len()];
        starts.iter().for_each(|&triangle| has_start[triangle as usize] = true);
        let mut tracing = Tracing {
            positions: positions.to_vec(),
            nearest: nearest.to_vec(),
            parts: (0..)
                .zip(triangles)
                .map(|(origin, &corners)| Part { corners, origin, has_start: has_start[origin as usize] })
                .collect(),
            weights: HashMap::new(),
            triangles: triangles.to_vec(),
            diagonal: triangle::length(high - low),
            crossings: HashMap::new(),
            pieces: Vec::new(),
            areas: vec![0.0; cells],
            tiles: Vec::new(),
            ask,
        };
        tracing.divide()?;
        for index in 0..tracing.parts.len() {
            tracing.cross(index)?;
        }
        Ok(Self { curves: joined(&tracing.pieces), areas: tracing.areas, tiles: tracing.tiles })
    }
}

impl<E, F: FnMut(u32, [f64; 3]) -> Result<Option<u32>, E>> Tracing<F> {
    /// Divides long edges where cells meet, or may be within a triangle, and all edges where three meet.
    fn divide(&mut self) -> Result<(), E> {
        for _ in 0..MOST_ROUNDS {
            let mut long: Vec<([u32; 2], u32)> = Vec::new();
            for part in self.parts.iter().filter(|part| part.has_start || self.is_mixed(part)) {
                let most = self.diagonal * if self.is_meeting(part) { MEETING } else { LONGEST };
                let is_long = |[a, b]: &[u32; 2]| {
                    let [a, b] = [a, b].map(|&end| self.positions[end as usize]);
                    triangle::length(b - a) > most
                };
                long.extend(sides(part.corners).into_iter().filter(is_long).map(|side| (side, part.origin)));
            }
            sort::sort(&mut long);
            long.dedup_by_key(|&mut (side, _)| side);
            if long.is_empty() {
                break;
            }
            self.divide_at(&long)?;
        }
        Ok(())
    }

    fn is_mixed(&self, part: &Part) -> bool {
        let [a, b, c] = part.corners.map(|corner| self.nearest[corner as usize]);
        a != b || b != c
    }

    /// Whether the corners of a part are of three cells.
    fn is_meeting(&self, part: &Part) -> bool {
        let [a, b, c] = part.corners.map(|corner| self.nearest[corner as usize]);
        a.is_some() && b.is_some() && c.is_some() && a != b && b != c && c != a
    }

    /// Divides edges, each with a triangle of the surface, in their middles.
    fn divide_at(&mut self, edges: &[([u32; 2], u32)]) -> Result<(), E> {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        for &(side, origin) in edges {
            middles.insert(side, self.positions.len() as u32);
            let [a, b] = side.map(|end| self.positions[end as usize]);
            self.positions.push(0.5 * (a + b));
            let weights = between(self.ends_in(side, origin), 0.5);
            self.nearest.push((self.ask)(origin, weights)?);
        }
        let mut is_end = vec![false; self.positions.len()];
        edges.iter().flat_map(|(side, _)| side).for_each(|&end| is_end[end as usize] = true);
        for part in std::mem::take(&mut self.parts) {
            // Most are far away from all of them.
            if part.corners.iter().filter(|&&corner| is_end[corner as usize]).count() < 2 {
                self.parts.push(part);
                continue;
            }
            let found = sides(part.corners).map(|side| middles.get(&side).copied());
            for (side, middle) in sides(part.corners).into_iter().zip(found) {
                if let Some(middle) = middle {
                    let weights = between(self.ends_in(side, part.origin), 0.5);
                    self.weights.insert((middle, part.origin), weights);
                }
            }
            let parts = &mut self.parts;
            split(part.corners, found, &self.positions, |corners| parts.push(Part { corners, ..part }));
        }
        Ok(())
    }

    /// The weights of a vertex in a triangle of the surface.
    fn weights_in(&self, vertex: u32, origin: u32) -> [f64; 3] {
        let at_corner = self.triangles[origin as usize].map(|corner| f64::from(u8::from(corner == vertex)));
        self.weights.get(&(vertex, origin)).copied().unwrap_or(at_corner)
    }

    fn ends_in(&self, side: [u32; 2], origin: u32) -> [[f64; 3]; 2] {
        side.map(|end| self.weights_in(end, origin))
    }

    fn position(&self, origin: u32, weights: [f64; 3]) -> DVec3 {
        let corners = self.triangles[origin as usize].map(|corner| self.positions[corner as usize]);
        weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]
    }

    /// The share of the way between two places of a triangle where the first one's cell ends.
    fn change(&mut self, origin: u32, ends: [[f64; 3]; 2], cell: u32) -> Result<f64, E> {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if (self.ask)(origin, between(ends, middle))? == Some(cell) { low = middle } else { high = middle }
        }
        Ok(0.5 * (low + high))
    }

    /// The weights of the place where a border crosses an edge of a part, from one corner to another.
    fn crossing(&mut self, [from, to]: [u32; 2], origin: u32) -> Result<[f64; 3], E> {
        let side = [from.min(to), from.max(to)];
        let ends = self.ends_in(side, origin);
        let share = match (self.crossings.get(&side), self.nearest[side[0] as usize]) {
            (Some(&share), _) => share,
            (None, Some(cell)) => {
                let share = self.change(origin, ends, cell)?;
                self.crossings.insert(side, share);
                share
            }
            (None, None) => 0.5,
        };
        Ok(between(ends, share))
    }

    /// Adds what a part has of borders and areas.
    fn cross(&mut self, index: usize) -> Result<(), E> {
        let Part { corners, origin, .. } = self.parts[index];
        let places = corners.map(|corner| self.positions[corner as usize]);
        let whole = 0.5 * triangle::length(triangle::area_vector(places));
        let [Some(a), Some(b), Some(c)] = corners.map(|corner| self.nearest[corner as usize]) else { return Ok(()) };
        let cells = [a, b, c];
        if a == b && b == c {
            self.areas[a as usize] += whole;
            self.tiles.push(Tile {
                cell: a,
                triangle: origin,
                corners: corners.map(|vertex| self.weights_in(vertex, origin)),
            });
        } else if self.is_meeting(&self.parts[index]) {
            self.meet(index, cells)?;
        } else {
            let lone = if b == c {
                0
            } else if c == a {
                1
            } else {
                2
            };
            let turned = [lone, (lone + 1) % 3, (lone + 2) % 3];
            let border = self.border(origin, turned.map(|k| corners[k]), cells[lone])?;
            let [corner, left, right] = turned.map(|k| corners[k]);
            let points: Vec<DVec3> = border.iter().map(|&weights| self.position(origin, weights)).collect();
            let area = fan(places[lone], &points);
            let [mine, others] = [cells[lone], cells[turned[1]]];
            let ends = [corner, left, right].map(|vertex| self.weights_in(vertex, origin));
            self.tile(origin, [mine, others], ends, &border);
            self.areas[mine as usize] += area;
            self.areas[others as usize] += whole - area;
            let ends = [[corner, left], [corner, right]].map(|[a, b]| Node::Edge([a.min(b), a.max(b)]));
            self.pieces.push(Piece { cells: [mine.min(others), mine.max(others)], ends, points, triangle: origin });
        }
        Ok(())
    }

    /// The border around the first of three corners, from the edge to the second to that to the third.
    fn border(&mut self, origin: u32, corners: [u32; 3], cell: u32) -> Result<Vec<[f64; 3]>, E> {
        let [corner, left, right] = corners;
        let ends = [self.crossing([corner, left], origin)?, self.crossing([corner, right], origin)?];
        let [from, to] = ends.map(|weights| self.position(origin, weights));
        let chords = (triangle::length(to - from) / (CHORD * self.diagonal)).ceil().max(1.0) as usize;
        let [corner, left, right] = [corner, left, right].map(|vertex| self.weights_in(vertex, origin));
        let mut border = vec![ends[0]];
        for chord in 1..chords {
            let ray = [corner, between([left, right], chord as f64 / chords as f64)];
            let share = self.change(origin, ray, cell)?;
            border.push(between(ray, share));
        }
        border.push(ends[1]);
        Ok(border)
    }

    /// Divides a part along the border around the first of its corners.
    fn tile(
        &mut self,
        triangle: u32,
        [mine, others]: [u32; 2],
        [corner, left, right]: [[f64; 3]; 3],
        border: &[[f64; 3]],
    ) {
        let chords = border.len() - 1;
        let beyond = |chord: usize| between([left, right], chord as f64 / chords as f64);
        for (chord, ends) in border.windows(2).enumerate() {
            let (from, to) = (beyond(chord), beyond(chord + 1));
            let pieces =
                [(mine, [corner, ends[0], ends[1]]), (others, [ends[0], from, to]), (others, [ends[0], to, ends[1]])];
            self.tiles.extend(pieces.map(|(cell, corners)| Tile { cell, triangle, corners }));
        }
    }

    /// Three cells meet in a part.
    fn meet(&mut self, index: usize, cells: [u32; 3]) -> Result<(), E> {
        let Part { corners, origin, .. } = self.parts[index];
        let mut weights = [[0.0; 3]; 3];
        for (k, there) in weights.iter_mut().enumerate() {
            *there = self.crossing([corners[k], corners[(k + 1) % 3]], origin)?;
        }
        let crossed = weights.map(|there| self.position(origin, there));
        let middle = crossed.iter().sum::<DVec3>() / 3.0;
        let inside = [0, 1, 2].map(|k| weights.iter().map(|there| there[k]).sum::<f64>() / 3.0);
        for k in 0..3 {
            let (next, before) = ((k + 1) % 3, (k + 2) % 3);
            let corner = self.positions[corners[k] as usize];
            self.areas[cells[k] as usize] += fan(corner, &[crossed[k], middle, crossed[before]]);
            let own = self.weights_in(corners[k], origin);
            for corners in [[own, weights[k], inside], [own, inside, weights[before]]] {
                self.tiles.push(Tile { cell: cells[k], triangle: origin, corners });
            }
            let side = [corners[k].min(corners[next]), corners[k].max(corners[next])];
            self.pieces.push(Piece {
                cells: [cells[k].min(cells[next]), cells[k].max(cells[next])],
                ends: [Node::Edge(side), Node::Inside(index)],
                points: vec![crossed[k], middle],
                triangle: origin,
            });
        }
        Ok(())
    }
}

/// A share of the way between two places of a triangle.
fn between([from, to]: [[f64; 3]; 2], share: f64) -> [f64; 3] {
    [0, 1, 2].map(|k| from[k] + share * (to[k] - from[k]))
}

/// The area between a corner and a line in a plane with it.
fn fan(corner: DVec3, line: &[DVec3]) -> f64 {
    let sum: DVec3 = line.windows(2).map(|ends| (ends[0] - corner).cross(ends[1] - corner)).sum();
    0.5 * triangle::length(sum)
}

/// The pieces of each two cells as curves.
fn joined(pieces: &[Piece]) -> Isolines {
    let mut of_cells: BTreeMap<[u32; 2], Vec<&Piece>> = BTreeMap::new();
    for piece in pieces {
        of_cells.entry(piece.cells).or_default().push(piece);
    }
    let names = of_cells.keys().copied().collect();
    let isolines = of_cells.into_values().map(|pieces| {
        let curves = curves_of(&pieces);
        let length = curves.iter().fold(0.0, |sum, curve| sum + curve.length);
        Isoline { value: 0.0, curves, length, enclosed_area: 0.0 }
    });
    Isolines { isolines: isolines.collect(), kind: Kind::Borders(names) }
}

/// Joins pieces at their ends.
fn curves_of(pieces: &[&Piece]) -> Vec<Curve> {
    let mut at: HashMap<Node, Vec<usize>> = HashMap::new();
    for (index, piece) in pieces.iter().enumerate() {
        piece.ends.iter().for_each(|&end| at.entry(end).or_default().push(index));
    }
    let mut is_taken = vec![false; pieces.len()];
    let is_end = |piece: &&Piece| piece.ends.iter().position(|end| at[end].len() != 2);
    // Open curves from an end of theirs, then closed ones from anywhere.
    let open = (0..pieces.len()).filter_map(|index| is_end(&pieces[index]).map(|end| (index, end)));
    let starts: Vec<(usize, usize)> = open.chain((0..pieces.len()).map(|index| (index, 0))).collect();
    let mut curves = Vec::new();
    for (start, end) in starts {
        let (mut index, mut node) = (start, pieces[start].ends[end]);
        let first = node;
        let (mut points, mut triangles): (Vec<DVec3>, Vec<u32>) = (Vec::new(), Vec::new());
        while !is_taken[index] {
            is_taken[index] = true;
            let piece = pieces[index];
            let is_forward = piece.ends[0] == node;
            let count = piece.points.len();
            points.extend((0..count - 1).map(|k| piece.points[if is_forward { k } else { count - 1 - k }]));
            triangles.extend(std::iter::repeat_n(piece.triangle, count - 1));
            node = piece.ends[usize::from(is_forward)];
            let last = piece.points[if is_forward { count - 1 } else { 0 }];
            match at[&node].iter().find(|&&next| !is_taken[next]) {
                Some(&next) if at[&node].len() == 2 => index = next,
                _ => points.push(last),
            }
        }
        if points.is_empty() {
            continue;
        }
        let is_closed = node == first && points.len() > 2;
        if is_closed {
            points.pop();
        }
        let length = points.windows(2).map(|ends| triangle::length(ends[1] - ends[0])).sum::<f64>()
            + if is_closed { triangle::length(points[0] - points[points.len() - 1]) } else { 0.0 };
        curves.push(Curve { points, triangles, is_closed, length });
    }
    curves
}
