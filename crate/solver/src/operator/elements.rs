//! Linear elements: each triangle, given by the lengths of its sides, laid out in a plane of its own.

use heatwalk_base::sort;
use heatwalk_surface::triangle;

use crate::error::{Error, Result};

/// Triangles whose roots and divisions are best taken together: one by one, each would wait for those of the one before.
pub(crate) const BLOCK: usize = 16;

/// A triangle in the plane with corners (0, 0), (`x1`, 0) and (`x2`, `y2`), counter-clockwise.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Element {
    x1: f64,
    x2: f64,
    y2: f64,
}

impl Element {
    /// From the lengths of the sides that leave corners 0, 1 and 2.
    pub(crate) fn of_lengths([a, b, c]: [f64; 3]) -> Self {
        let x2 = 0.5 * ((c - b) * (c + b) / a + a);
        Self { x1: a, x2, y2: 2.0 * triangle::area_of_lengths([a, b, c]) / a }
    }

    /// Lengths of the sides that leave corners 0, 1 and 2.
    pub(crate) fn sides(&self) -> [f64; 3] {
        let &Self { x1, x2, y2 } = self;
        [x1, triangle::hypotenuse(x2 - x1, y2), triangle::hypotenuse(x2, y2)]
    }

    /// Area, in the file's unit squared.
    pub(crate) fn area(&self) -> f64 {
        0.5 * self.x1 * self.y2
    }

    /// Twice the area, in the file's unit squared.
    pub(crate) fn twice_area(&self) -> f64 {
        self.x1 * self.y2
    }

    /// Cotangents of the three corner angles, cut as [`triangle::limit_cotans`] says.
    pub(crate) fn cotans(&self) -> [f64; 3] {
        let &Self { x1, x2, y2 } = self;
        triangle::limit_cotans([x2 / y2, (x1 - x2) / y2, (y2 - x2 * ((x1 - x2) / y2)) / x1])
    }

    /// Gradient of the linear function with these values at the corners.
    pub(crate) fn gradient(&self, values: [f64; 3]) -> [f64; 2] {
        let [x, y] = self.circulation(values);
        let twice_area = self.x1 * self.y2;
        [-y / twice_area, x / twice_area]
    }

    /// Integrated divergence at corners 1 and 2 of a constant field; that at corner 0 is minus their sum.
    pub(crate) fn divergence(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.edge_products([y, -x]).map(|product| 0.5 * product)
    }

    /// The sum of each corner's value times the edge opposite it: the gradient of the linear function with these
    /// values, turned by a right angle, times twice the area.
    pub(crate) fn circulation(&self, values: [f64; 3]) -> [f64; 2] {
        let [u1, u2] = [values[1] - values[0], values[2] - values[0]];
        [self.x1 * u2 - self.x2 * u1, -self.y2 * u1]
    }

    /// Products of the edges opposite corners 1 and 2 with a vector; that of corner 0 is minus their sum.
    pub(crate) fn edge_products(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [-self.x2 * x - self.y2 * y, self.x1 * x]
    }
}

/// The triangles that the operators are built on.
#[derive(Debug, Clone)]
pub(crate) struct Elements {
    /// `#F × 3` vertices. A face may have one twice.
    pub(crate) faces: Vec<[u32; 3]>,
    /// `#F`, in the same order of corners.
    pub(crate) shapes: Vec<Element>,
    /// Triangles that count for 1 and come first; those after them count for a half, being of one of two sheets.
    pub(crate) whole: usize,
    /// Mean length of the edges, in the file's unit.
    pub(crate) mean_edge: f64,
    /// Root-mean-square deviation of a triangle's sides from their mean, as a share of it.
    pub(crate) deviation: f64,
}

impl Elements {
    /// What a triangle counts for.
    pub(crate) fn share(&self, index: usize) -> f64 {
        if index < self.whole { 1.0 } else { 0.5 }
    }

    /// Area of all triangles, in the file's unit squared.
    pub(crate) fn area(&self) -> f64 {
        self.shapes.iter().enumerate().map(|(index, shape)| self.share(index) * shape.area()).sum()
    }

    /// How much larger triangles are where most of the surface is than where most vertices are: the geometric mean of
    /// their areas, weighted by area, over that of an equilateral triangle with the mean edge. About 1 where all are of
    /// one size.
    pub(crate) fn grading(&self) -> f64 {
        let unit = self.mean_edge * self.mean_edge;
        let areas = self.shapes.iter().enumerate().map(|(index, shape)| (self.share(index), shape.area() / unit));
        let (whole, logarithms) = areas
            .filter(|&(_, area)| area > 0.0)
            .fold((0.0, 0.0), |(whole, sum), (share, area)| (whole + share * area, sum + share * area * area.ln()));
        let equilateral = 0.25 * 3.0_f64.sqrt();
        (logarithms / whole).exp() / equilateral
    }

    /// Adds the divergence at corners 1 and 2 of a triangle, and minus their sum at corner 0, to that of the vertices.
    #[inline]
    pub(crate) fn add_divergence(&self, triangle: usize, [at_b, at_c]: [f64; 2], divergence: &mut [f64]) {
        let ([a, b, c], share) = (self.faces[triangle], self.share(triangle));
        divergence[a as usize] -= share * (at_b + at_c);
        divergence[b as usize] += share * at_b;
        divergence[c as usize] += share * at_c;
    }

    /// The sides of all triangles: vertices, the lower first, and length. Sides of the same vertices whose lengths differ by a
    /// share of `tolerance` at most count once.
    pub(crate) fn edges(&self, tolerance: f64) -> Vec<([u32; 2], f64)> {
        let sides = self.faces.iter().zip(&self.shapes).flat_map(|(&[a, b, c], shape)| {
            let [ab, bc, ca] = shape.sides();
            [([a.min(b), a.max(b)], ab), ([b.min(c), b.max(c)], bc), ([c.min(a), c.max(a)], ca)]
        });
        let mut edges: Vec<([u32; 2], f64)> = sides.collect();
        sort::sort_by(&mut edges, |(ends, length), (others, other)| ends.cmp(others).then(length.total_cmp(other)));
        edges.dedup_by(|(ends, length), (others, other)| ends == others && *length <= *other * (1.0 + tolerance));
        edges
    }

    /// Triangles that count for 1. `lengths`, `3 #F`, are those of the sides that leave each corner, and `is_boundary` tells of each
    /// side whether no other is glued to it; sides are counted face by face.
    pub(crate) fn from_lengths(faces: Vec<[u32; 3]>, lengths: &[f64], is_boundary: impl Fn(usize) -> bool) -> Self {
        let shapes = lengths.as_chunks().0.iter().map(|&sides| Element::of_lengths(sides)).collect();
        let (mean_edge, deviation) = edge_statistics(lengths, is_boundary);
        Self { whole: faces.len(), faces, shapes, mean_edge, deviation }
    }
}

/// Refuses lengths of sides that make no triangle.
///
/// # Errors
/// [`Error::BadParameter`].
pub(crate) fn require_triangles(lengths: &[[f64; 3]]) -> Result<()> {
    let is_bad =
        |&(_, &[a, b, c]): &(usize, &[f64; 3])| !(a + b > c && b + c > a && c + a > b && a + b + c < f64::INFINITY);
    let Some((face, lengths)) = lengths.iter().enumerate().find(is_bad) else { return Ok(()) };
    Err(Error::BadParameter {
        name: "a triple of edge lengths",
        value: format!("{lengths:?} at face {face}"),
        range: "finite, each less than the sum of the other two",
    })
}

/// Mean length of the edges, and the root-mean-square deviation of a triangle's sides from their mean, as a share of it.
/// `lengths` are those of the triangles' sides, of which two make an edge, or one that is a boundary.
pub(crate) fn edge_statistics(lengths: &[f64], is_boundary: impl Fn(usize) -> bool) -> (f64, f64) {
    let sides = lengths.iter().enumerate();
    let (sum, count) = sides
        .map(|(side, &length)| (length, if is_boundary(side) { 2.0 } else { 1.0 }))
        .fold((0.0, 0.0), |(sum, count), (length, weight)| (sum + weight * length, count + weight));
    let triangles = lengths.as_chunks().0;
    let variance = |&[a, b, c]: &[f64; 3]| {
        let third = 3.0 / (a + b + c);
        [a, b, c].map(|side| (side * third - 1.0).powi(2)).iter().sum::<f64>() / 3.0
    };
    (sum / count, (triangles.iter().map(variance).sum::<f64>() / triangles.len() as f64).sqrt())
}
