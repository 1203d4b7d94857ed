//! A surface cut along isolines into the strips between them.
//!
//! Each triangle is split by the isolines that cross it. What decides is order alone: a corner at a value lies on its isoline,
//! and a triangle has no part of a strip that it only touches. Points on an edge are shared by all of its triangles, so the
//! strips fit together without gaps.

use std::ops::Range;

use glam::DVec3;

use crate::error::{Error, Result};
use crate::field::{Field, NONE};
use crate::levels::Levels;

/// A surface in strips.
#[derive(Debug, Clone, PartialEq)]
pub struct Strips {
    /// `#V × 3`: the vertices of the field first, then those on isolines.
    pub positions: Vec<DVec3>,
    /// `#V`, the distance at each; on isolines the value.
    pub distances: Vec<f64>,
    /// `#F × 3`, oriented as those of the field, by strips. Those with an infinite distance are left out.
    pub triangles: Vec<[u32; 3]>,
    /// `#F`, the triangle of the field that each is a part of.
    pub origins: Vec<u32>,
    /// The triangles of each strip. The first one is nearer than the least level, the last one farther than the largest.
    pub ranges: Vec<Range<usize>>,
    /// The levels.
    pub values: Vec<f64>,
    /// Of each vertex after those of the field, the ends of the edge that it is on, and which share of the way it is.
    pub(crate) crossings: Vec<([u32; 2], f64)>,
}

impl Strips {
    /// Cuts a surface along the isolines of all levels.
    ///
    /// # Errors
    /// [`Error::TooManyVertices`].
    pub fn cut(field: &Field, levels: &Levels) -> Result<Self> {
        let field = &field.at_levels(levels);
        let values = levels.values();
        let mut points = EdgePoints::new(field, values)?;
        let mut parts = vec![Vec::new(); values.len() + 1];
        let (mut around, mut polygons) = (Vec::new(), Vec::new());
        for triangle in 0..field.triangles().len() {
            if field.corner_distances(triangle).is_none() {
                continue;
            }
            around.clear();
            (3 * triangle..3 * triangle + 3).for_each(|side| points.push_side(field, values, side, &mut around));
            split(&around, &mut polygons, |strip, corners| parts[strip].push((corners, triangle as u32)));
        }
        let mut ranges = Vec::with_capacity(parts.len());
        let mut end = 0;
        for part in &parts {
            ranges.push(end..end + part.len());
            end += part.len();
        }
        let (triangles, origins) = parts.into_iter().flatten().unzip();
        let EdgePoints { positions, distances, crossings, .. } = points;
        Ok(Self { positions, distances, triangles, origins, ranges, values: values.to_vec(), crossings })
    }

    /// The distances that a strip lies between; none where it has no bound but the surface's own.
    pub fn bounds(&self, strip: usize) -> [Option<f64>; 2] {
        [strip.checked_sub(1).map(|before| self.values[before]), self.values.get(strip).copied()]
    }

    /// What a strip is called in files: the distances that it lies between.
    pub fn name(&self, strip: usize) -> String {
        match self.bounds(strip) {
            [None, Some(end)] => format!("strip_{strip}_below_{}", written(end)),
            [Some(start), None] => format!("strip_{strip}_above_{}", written(start)),
            [start, end] => {
                format!("strip_{strip}_{}_to_{}", written(start.unwrap_or_default()), written(end.unwrap_or_default()))
            }
        }
    }
}

/// A value as it was meant: multiples of a spacing have digits of rounding at the end.
fn written(value: f64) -> String {
    format!("{value:.11e}").parse::<f64>().unwrap_or(value).to_string()
}

/// A vertex on the way around a triangle, and where its distance is among the levels: `2 k` in strip `k`, which is between levels
/// `k − 1` and `k`; `2 k + 1` on level `k`.
type Stop = (u32, usize);

/// The vertices on edges, made where they are first met.
struct EdgePoints {
    positions: Vec<DVec3>,
    distances: Vec<f64>,
    /// Of each vertex that is not the field's.
    crossings: Vec<([u32; 2], f64)>,
    /// Of each edge the vertex on the first level that crosses it, those on the next ones following; [`NONE`] before they are
    /// made.
    firsts: Vec<u32>,
    /// Where each vertex of the field is among the levels.
    places: Vec<usize>,
}

impl EdgePoints {
    fn new(field: &Field, values: &[f64]) -> Result<Self> {
        let place = |&distance: &f64| {
            let below = values.partition_point(|&value| value < distance);
            2 * below + usize::from(values.get(below) == Some(&distance))
        };
        let points = Self {
            positions: field.positions().to_vec(),
            distances: field.distances().to_vec(),
            crossings: Vec::new(),
            firsts: vec![NONE; field.edges().count()],
            places: field.distances().iter().map(place).collect(),
        };
        // Told before anything is made.
        let sides = (0..3 * field.triangles().len()).filter(|&side| field.corner_distances(side / 3).is_some());
        let more: usize = sides.map(|side| points.levels_across(field.ends(side)).len()).sum();
        let fits = (field.positions().len() + more) < NONE as usize;
        if fits { Ok(points) } else { Err(Error::TooManyVertices) }
    }

    /// The levels between the ends of an edge; not those that an end lies on.
    fn levels_across(&self, ends: [usize; 2]) -> Range<usize> {
        let [a, b] = ends.map(|vertex| self.places[vertex]);
        let (low, high) = (a.min(b), a.max(b));
        let start = low.div_ceil(2);
        start..(high / 2).max(start)
    }

    /// Adds the beginning of a side of a triangle and what lies on the side.
    fn push_side(&mut self, field: &Field, values: &[f64], side: usize, around: &mut Vec<Stop>) {
        let ends @ [from, to] = field.ends(side);
        around.push((from as u32, self.places[from]));
        let levels = self.levels_across(ends);
        let edge = field.edges().number(side);
        if self.firsts[edge] == NONE {
            self.firsts[edge] = self.positions.len() as u32;
            self.positions.extend(levels.clone().map(|level| field.crossing(side, values[level])));
            self.crossings.extend(levels.clone().map(|level| field.share_to_crossing(side, values[level])));
            self.distances.extend(&values[levels.clone()]);
        }
        let first = self.firsts[edge];
        let stop = |level: usize| (first + (level - levels.start) as u32, 2 * level + 1);
        if self.places[from] < self.places[to] {
            around.extend(levels.clone().map(stop));
        } else {
            around.extend(levels.clone().rev().map(stop));
        }
    }
}

/// Splits a triangle, given by the stops around it, into triangles of strips. `polygons` is room to work in.
fn split(around: &[Stop], polygons: &mut Vec<Vec<u32>>, mut give: impl FnMut(usize, [u32; 3])) {
    let places = || around.iter().map(|&(_, place)| place);
    let first = places().min().unwrap_or_default() / 2;
    let count = places().max().unwrap_or_default().div_ceil(2) + 1 - first;
    polygons.resize_with(polygons.len().max(count), Vec::new);
    // All of it on one level: farther, as its corners are.
    let is_level = places().all(|place| place == around[0].1);
    for &(vertex, place) in around {
        // On a level, of the strips on both sides.
        let nearer = if is_level { place.div_ceil(2) } else { place / 2 };
        for strip in nearer..=place.div_ceil(2) {
            polygons[strip - first].push(vertex);
        }
    }
    for (index, polygon) in polygons[..count].iter_mut().enumerate() {
        // Convex, and no three in a row on one side of the triangle. What a strip only touches has less than three.
        if let [apex, rest @ ..] = polygon.as_slice() {
            rest.windows(2).for_each(|pair| give(first + index, [*apex, pair[0], pair[1]]));
        }
        polygon.clear();
    }
}
