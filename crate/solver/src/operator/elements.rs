//! Linear elements: each triangle laid out in a plane of its own. All operators need no more of a surface.

use heatwalk_surface::surface::Surface;
use heatwalk_surface::triangle;
use heatwalk_surface::{FaceId, HalfedgeId};

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

    fn of_face(surface: &Surface, face: FaceId) -> Self {
        let [p, q, r] = surface.corners(face);
        let x1 = triangle::length(q - p);
        let along = triangle::unit(q - p);
        Self { x1, x2: along.dot(r - p), y2: triangle::length(along.cross(r - p)) }
    }

    /// Lengths of the sides that leave corners 0, 1 and 2.
    fn sides(&self) -> [f64; 3] {
        let &Self { x1, x2, y2 } = self;
        [x1, triangle::hypotenuse(x2 - x1, y2), triangle::hypotenuse(x2, y2)]
    }

    /// Area, in the file's unit squared.
    pub(crate) fn area(&self) -> f64 {
        0.5 * self.x1 * self.y2
    }

    /// Cotangents of the three corner angles, cut as [`triangle::limit_cotans`] says.
    pub(crate) fn cotans(&self) -> [f64; 3] {
        let &Self { x1, x2, y2 } = self;
        triangle::limit_cotans([x2 / y2, (x1 - x2) / y2, (y2 - x2 * ((x1 - x2) / y2)) / x1])
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
    /// `#F × 3` points. A face may have a point twice.
    pub(crate) faces: Vec<[u32; 3]>,
    /// `#F`, in the same order of corners.
    pub(crate) shapes: Vec<Element>,
    /// Triangles that count for 1 and come first; those after them count for a half, being of one of two sheets.
    pub(crate) whole: usize,
    /// Mean length of the edges, in the file's unit.
    pub(crate) mean_edge: f64,
    /// Root-mean-square deviation of the edges' lengths, as a share of their mean.
    pub(crate) deviation: f64,
}

impl Elements {
    /// What a triangle counts for.
    pub(crate) fn share(&self, index: usize) -> f64 {
        if index < self.whole { 1.0 } else { 0.5 }
    }

    /// The sides of all triangles: points, the lower first, and length. Sides of the same points whose lengths differ by a
    /// share of `tolerance` at most count once.
    pub(crate) fn edges(&self, tolerance: f64) -> Vec<([u32; 2], f64)> {
        let sides = self.faces.iter().zip(&self.shapes).flat_map(|(&[a, b, c], shape)| {
            let [ab, bc, ca] = shape.sides();
            [([a.min(b), a.max(b)], ab), ([b.min(c), b.max(c)], bc), ([c.min(a), c.max(a)], ca)]
        });
        let mut edges: Vec<([u32; 2], f64)> = sides.collect();
        edges.sort_unstable_by(|(ends, length), (others, other)| ends.cmp(others).then(length.total_cmp(other)));
        edges.dedup_by(|(ends, length), (others, other)| ends == others && *length <= *other * (1.0 + tolerance));
        edges
    }

    /// The faces of a surface as they are.
    pub(crate) fn of_surface(surface: &Surface) -> Self {
        let shapes = surface.mesh().faces().map(|face| Element::of_face(surface, face)).collect();
        let sides = 3 * surface.face_count();
        let is_boundary = |side: usize| surface.mesh().twin(HalfedgeId(side as u32)).0 as usize >= sides;
        let (mean_edge, deviation) = edge_statistics(&surface.side_lengths(), is_boundary);
        let faces: Vec<[u32; 3]> = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
        Self { whole: faces.len(), faces, shapes, mean_edge, deviation }
    }
}

/// Mean length of the edges and its root-mean-square deviation, as a share of the mean. `lengths` are those of the
/// triangles' sides, of which two make an edge, or one that is a boundary.
pub(crate) fn edge_statistics(lengths: &[f64], is_boundary: impl Fn(usize) -> bool) -> (f64, f64) {
    let sides = || {
        let sides = lengths.iter().enumerate();
        sides.map(|(side, &length)| (length, if is_boundary(side) { 2.0 } else { 1.0 }))
    };
    let (sum, count) =
        sides().fold((0.0, 0.0), |(sum, count), (length, weight)| (sum + weight * length, count + weight));
    let mean = sum / count;
    let deviation = |(length, weight): (f64, f64)| weight * (length / mean - 1.0).powi(2);
    (mean, (sides().map(deviation).sum::<f64>() / count).sqrt())
}
