//! Isolines as ordered, oriented curves.
//!
//! A vertex whose distance is the value counts as farther, so each triangle that an isoline meets has corners on both sides
//! and exactly two of its edges are crossed: there is no degenerate case. Points that fall together at such a vertex become one
//! afterwards. Distances that are a value up to rounding are first made that value.

use glam::DVec3;
use heatwalk_surface::triangle;

use crate::area;
use crate::field::Field;
use crate::levels::Levels;

/// A part of an isoline that is in one piece.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Two at least; of a closed curve, the first is not repeated at the end. Larger distances are on the left, seen from
    /// outside. Points that follow each other differ.
    pub points: Vec<DVec3>,
    /// The triangle that the curve goes through after each point; of an open curve, none after the last.
    pub triangles: Vec<u32>,
    /// Whether the curve goes back from its last point to the first.
    pub is_closed: bool,
    /// In the field's unit.
    pub length: f64,
}

/// All places at one distance.
#[derive(Debug, Clone, PartialEq)]
pub struct Isoline {
    /// The distance.
    pub value: f64,
    /// In the order of the first triangle of each.
    pub curves: Vec<Curve>,
    /// Of all curves, in the field's unit.
    pub length: f64,
    /// Of the part of the surface that is nearer, in the square of that unit; triangles with an infinite distance are not
    /// counted.
    pub enclosed_area: f64,
}

/// What curves are, by which files call them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Kind {
    /// Isolines of a distance.
    Isolines,
    /// Where a plane cuts the surface: at 0 of the height over it.
    Girth,
    /// Paths on the surface, their lengths as values.
    Paths(PathKind),
    /// Borders between cells, each between these two, and without a value.
    Borders(Vec<[u32; 2]>),
}

/// Paths that are curves by themselves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathKind {
    /// Closed geodesics around handles.
    HandleLoops,
    /// A closed curve through places.
    Loop,
    /// A Bézier curve.
    Bezier,
}

/// The isolines of a field.
#[derive(Debug, Clone, PartialEq)]
pub struct Isolines {
    /// What they are; those that are traced are isolines of a distance unless it is changed.
    pub kind: Kind,
    /// One a level, ascending; without curves where nothing is at its value.
    pub isolines: Vec<Isoline>,
}

impl Curve {
    /// The ends of its segments, in order.
    pub fn segments(&self) -> impl Iterator<Item = [DVec3; 2]> + '_ {
        let next = |index: usize| self.points[(index + 1) % self.points.len()];
        (0..self.triangles.len()).map(move |index| [self.points[index], next(index)])
    }
}

impl Isolines {
    /// The same in another unit: all lengths times a number.
    #[must_use]
    pub fn scaled(&self, scale: f64) -> Self {
        let mut scaled = self.clone();
        for isoline in &mut scaled.isolines {
            isoline.value *= scale;
            isoline.length *= scale;
            isoline.enclosed_area *= scale * scale;
            for curve in &mut isoline.curves {
                curve.length *= scale;
                curve.points.iter_mut().for_each(|point| *point *= scale);
            }
        }
        scaled
    }

    /// The ends of the segments of all curves, two each.
    pub fn points_of_segments(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.isolines.iter().flat_map(|isoline| &isoline.curves).flat_map(|curve| curve.segments().flatten())
    }

    /// What files call one of them.
    pub fn name(&self, index: usize) -> String {
        match &self.kind {
            Kind::Isolines => format!("isoline_{}", self.isolines[index].value),
            Kind::Girth => "girth".to_owned(),
            Kind::Paths(PathKind::Bezier) => format!("curve_{}", index + 1),
            Kind::Paths(_) => format!("loop_{}", index + 1),
            Kind::Borders(cells) => format!("border_{}_{}", cells[index][0], cells[index][1]),
        }
    }

    /// Finds the isolines of all levels. Triangles with an infinite distance have none.
    pub fn trace(field: &Field, levels: &Levels) -> Self {
        let field = &field.at_levels(levels);
        let areas = area::enclosed(field, levels);
        let mut is_traced = vec![false; field.triangles().len()];
        let isoline = |((&value, crossed), enclosed_area): ((&f64, Vec<u32>), f64)| {
            let mut curves = Vec::new();
            for &start in &crossed {
                if !is_traced[start as usize] {
                    curves.extend(trace_from(field, start as usize, value, &mut is_traced));
                }
            }
            crossed.iter().for_each(|&triangle| is_traced[triangle as usize] = false);
            // The empty sum of floats is −0.
            let length = curves.iter().fold(0.0, |sum, curve| sum + curve.length);
            Isoline { value, curves, length, enclosed_area }
        };
        let all = levels.values().iter().zip(crossed_triangles(field, levels)).zip(areas);
        Self { kind: Kind::Isolines, isolines: all.map(isoline).collect() }
    }
}

/// For each level the triangles with corners on both sides.
fn crossed_triangles(field: &Field, levels: &Levels) -> Vec<Vec<u32>> {
    let values = levels.values();
    let mut crossed = vec![Vec::new(); values.len()];
    for index in 0..field.triangles().len() {
        let Some([a, b, c]) = field.corner_distances(index) else { continue };
        let first = values.partition_point(|&value| value <= a.min(b).min(c));
        let end = values.partition_point(|&value| value <= a.max(b).max(c));
        crossed[first.min(end)..end].iter_mut().for_each(|list| list.push(index as u32));
    }
    crossed
}

/// The half-edges where the isoline enters a triangle that it crosses, and where it leaves it: the first leads from farther to
/// nearer, which has the farther side on the left.
fn crossed_halfedges(field: &Field, triangle: usize, value: f64) -> Option<[usize; 2]> {
    let is_far = field.corner_distances(triangle)?.map(|distance| distance >= value);
    let side = |from: bool| (0..3).find(|&k| is_far[k] == from && is_far[(k + 1) % 3] != from);
    Some([3 * triangle + side(true)?, 3 * triangle + side(false)?])
}

/// The curve through a triangle, which is crossed. None where it is a single point.
fn trace_from(field: &Field, start: usize, value: f64, is_traced: &mut [bool]) -> Option<Curve> {
    let across = |halfedge: usize| {
        let triangle = field.twin(halfedge)? / 3;
        Some((triangle, crossed_halfedges(field, triangle, value)?))
    };
    let crossed = crossed_halfedges(field, start, value)?;
    // Back to where the curve begins, or around to the triangle itself.
    let (mut first, mut is_closed) = ((start, crossed), false);
    while let Some(before) = across(first.1[0]) {
        if before.0 == start {
            is_closed = true;
            break;
        }
        first = before;
    }
    if is_closed {
        first = (start, crossed);
    }
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    let mut at = first;
    let last = loop {
        let (triangle, [enter, leave]) = at;
        is_traced[triangle] = true;
        points.push(field.crossing(enter, value));
        triangles.push(triangle as u32);
        match across(leave) {
            Some(next) if next.0 != first.0 => at = next,
            _ => break leave,
        }
    };
    if !is_closed {
        points.push(field.crossing(last, value));
    }
    Curve::without_repetitions(&points, &triangles, is_closed)
}

impl Curve {
    /// Of points that may fall together.
    fn without_repetitions(points: &[DVec3], triangles: &[u32], is_closed: bool) -> Option<Self> {
        let count = points.len();
        let (mut kept, mut beside) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (index, &triangle) in triangles.iter().enumerate() {
            if points[index] != points[(index + 1) % count] {
                kept.push(points[index]);
                beside.push(triangle);
            }
        }
        if kept.is_empty() {
            return None;
        }
        if !is_closed {
            kept.push(points[count - 1]);
        }
        let mut curve = Self { points: kept, triangles: beside, is_closed, length: 0.0 };
        curve.length = curve.segments().map(|[from, to]| triangle::length(to - from)).sum();
        Some(curve)
    }
}
