//! Tangent planes: the directions in which the points around one spread most (Hoppe, DeRose, Duchamp, McDonald, Stuetzle, "Surface
//! reconstruction from unorganized points", 1992).

use glam::{DMat3, DVec2, DVec3};
use heatwalk_base::sort;

/// Neighbours that tell how far apart points are.
const NEAREST: usize = 6;
/// Neighbours that lie off a first plane by more than this share of their distance are of another sheet, or beyond an edge.
const STEEP: f64 = 0.6;
/// Least cosine between the normals of triangles and planes: what is steeper goes from sheet to sheet.
pub const STEEPEST: f64 = 0.35;
/// Rounds after which off-diagonal entries are rounding.
const SWEEPS: usize = 8;

/// The plane at a point.
#[derive(Clone, Copy)]
pub struct Plane {
    pub normal: DVec3,
    /// Distance to the points around, on the mean.
    pub spacing: f64,
}

impl Plane {
    /// At a point without triangles.
    pub const NONE: Self = Self { normal: DVec3::Z, spacing: 0.0 };

    /// By the offsets of neighbours, the nearest first; none where they lie on a line.
    pub fn of(offsets: &[DVec3], fall_off: f64) -> Option<Self> {
        let spacing = spacing(offsets)?;
        let weight = |offset: DVec3| (-0.5 * (offset.length() / (fall_off * spacing)).powi(2)).exp();
        let first = normal(offsets.iter().map(|&offset| (offset / spacing, weight(offset))))?;
        let is_beside = |offset: &&DVec3| first.dot(**offset).abs() <= STEEP * offset.length();
        let beside = offsets.iter().filter(is_beside).map(|&offset| (offset / spacing, weight(offset)));
        let normal = normal(beside).unwrap_or(first);
        Some(Self { normal, spacing })
    }

    /// Square to a unit normal, at a point with neighbours at these offsets, the nearest first; none where there are none.
    pub fn square_to(normal: DVec3, offsets: &[DVec3]) -> Option<Self> {
        Some(Self { normal, spacing: spacing(offsets)? })
    }

    /// Where offsets lie in the plane, as far from the origin as in space.
    pub fn lay(&self) -> impl Fn(DVec3) -> Option<DVec2> + use<> {
        let [x, y] = self.axes();
        move |offset| {
            let flat = DVec2::new(x.dot(offset), y.dot(offset));
            flat.try_normalize().map(|direction| direction * offset.length())
        }
    }

    /// The direction of an offset in the plane, counterclockwise around the normal, from −π to π.
    pub fn angle(&self, offset: DVec3) -> f64 {
        let [x, y] = self.axes();
        y.dot(offset).atan2(x.dot(offset))
    }

    fn axes(&self) -> [DVec3; 2] {
        let axis = self.normal.any_orthonormal_vector();
        [axis, self.normal.cross(axis)]
    }
}

/// The mean distance to the nearest neighbours; none where there are none.
fn spacing(offsets: &[DVec3]) -> Option<f64> {
    let nearest = &offsets[..offsets.len().min(NEAREST)];
    let sum: f64 = nearest.iter().map(|offset| offset.length()).sum();
    (!nearest.is_empty()).then(|| sum / nearest.len() as f64)
}

/// The direction in which weighted offsets and the origin spread least; none where they do so in two directions.
fn normal(offsets: impl Iterator<Item = (DVec3, f64)> + Clone) -> Option<DVec3> {
    let (sum, mean) = offsets.clone().fold((1.0, DVec3::ZERO), |(sum, mean), (at, w)| (sum + w, mean + w * at));
    let mean = mean / sum;
    let start = outer(-mean);
    let spread = offsets.fold(start, |spread, (at, weight)| spread + outer(at - mean) * weight);
    let (values, vectors) = eigen(spread);
    let mut order = [0, 1, 2];
    sort::sort_by(&mut order, |&a, &b| values[a].total_cmp(&values[b]));
    let [least, middle, most] = order;
    (values[middle] > LINE * values[most]).then(|| vectors.col(least).normalize())
}

/// Points that spread sideways by the root of this share of their length lie on a line.
const LINE: f64 = 1e-12;

fn outer(a: DVec3) -> DMat3 {
    DMat3::from_cols(a * a.x, a * a.y, a * a.z)
}

/// Eigenvalues and eigenvectors, as columns, of a symmetric matrix (Jacobi 1846).
fn eigen(mut matrix: DMat3) -> (DVec3, DMat3) {
    let mut vectors = DMat3::IDENTITY;
    for _ in 0..SWEEPS {
        for [p, q] in [[0, 1], [0, 2], [1, 2]] {
            let off = matrix.col(q)[p];
            if off == 0.0 {
                continue;
            }
            let slope = (matrix.col(q)[q] - matrix.col(p)[p]) / (2.0 * off);
            let tangent = slope.signum() / (slope.abs() + slope.hypot(1.0));
            let cosine = tangent.hypot(1.0).recip();
            let sine = tangent * cosine;
            let mut turn = DMat3::IDENTITY;
            turn.col_mut(p)[p] = cosine;
            turn.col_mut(q)[q] = cosine;
            turn.col_mut(q)[p] = sine;
            turn.col_mut(p)[q] = -sine;
            matrix = turn.transpose() * matrix * turn;
            vectors *= turn;
        }
    }
    (DVec3::from([0, 1, 2].map(|k| matrix.col(k)[k])), vectors)
}
