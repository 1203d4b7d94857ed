//! A hierarchy over oriented triangles: the distance to the nearest one, and the generalized winding number (Jacobson, Kavan &
//! Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding numbers", 2013) with far triangles taken
//! together (Barill, Dickson, Schmidt, Levin & Jacobson, "Fast winding numbers for soups and clouds", 2018).

use std::f64::consts::PI;
use std::num::NonZeroUsize;

use glam::{DMat3, DVec3};
use heatwalk::surface::index::{Bounds, Tree, along_curve};

use super::triangle::{Crossing, Triangle, area_vector, crossing, solid_angle, to_nearest};

/// Triangles of a leaf, but for the last one.
const LEAF: usize = 4;

/// How far away, in radii of a node, its triangles are taken together: the β of Barill and others, who choose 2.
const FAR: f64 = 2.0;

/// What the triangles of a node look like from far away: Barill and others, equation 11 up to its second term, whose integrals over
/// triangles are exact.
#[derive(Debug, Clone, Copy)]
struct Moments {
    /// Centroid of the area.
    centre: DVec3,
    /// Square of the distance beyond which the node is far.
    squared_far: f64,
    /// Sum of the areas times normals.
    normal: DVec3,
    /// Sum of the areas times the outer products of places relative to the centre (rows) and normals (columns).
    first: DMat3,
}

impl Moments {
    /// The winding number of the triangles around a point far from them.
    #[inline]
    fn winding(&self, away: DVec3, squared: f64) -> f64 {
        let cubed = squared * squared.sqrt();
        let trace = self.first.x_axis.x + self.first.y_axis.y + self.first.z_axis.z;
        let bilinear = away.dot(self.first * away);
        (self.normal.dot(away) + trace - 3.0 * bilinear / squared) / (4.0 * PI * cubed)
    }
}

/// Sums over the triangles of a node.
#[derive(Debug, Clone, Copy)]
struct Sums {
    area: f64,
    /// Areas times centroids.
    weighted: DVec3,
    /// Areas times normals.
    normal: DVec3,
    /// Areas times the outer products of centroids and normals.
    first: DMat3,
}

impl Sums {
    /// Centroids relative to `origin`.
    fn of(triangle: &Triangle, origin: DVec3) -> Self {
        let (normal, centroid) = (0.5 * area_vector(triangle), triangle.iter().sum::<DVec3>() / 3.0 - origin);
        let area = normal.length();
        Self { area, weighted: area * centroid, normal, first: outer(centroid, normal) }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            area: self.area + other.area,
            weighted: self.weighted + other.weighted,
            normal: self.normal + other.normal,
            first: self.first + other.first,
        }
    }
}

/// Oriented triangles in boxes.
#[derive(Debug)]
pub struct Hierarchy {
    tree: Tree<2, LEAF>,
    triangles: Vec<Triangle>,
    boxes: Vec<Bounds>,
    moments: Vec<Moments>,
}

impl Hierarchy {
    /// Of one triangle at least.
    pub fn new(triangles: &[Triangle], threads: NonZeroUsize) -> Self {
        let middle = |index: usize| triangles[index].iter().sum::<DVec3>() / 3.0;
        let order = along_curve(triangles.len(), middle, threads);
        let triangles: Vec<Triangle> = order.iter().map(|&index| triangles[index as usize]).collect();
        let tree = Tree::new(triangles.len());
        let origin = triangles[0][0];
        let boxes = tree.values(|leaf| Bounds::of_points(triangles[leaf].iter().flatten().copied()), Bounds::around);
        let zero = Sums { area: 0.0, weighted: DVec3::ZERO, normal: DVec3::ZERO, first: DMat3::ZERO };
        let of_leaf =
            |leaf: &[Triangle]| leaf.iter().fold(zero, |sums, triangle| sums.plus(Sums::of(triangle, origin)));
        let sums = tree.values(|leaf| of_leaf(&triangles[leaf]), Sums::plus);
        let moments = sums.iter().zip(&boxes).map(|(&Sums { area, weighted, normal, first }, own)| {
            let relative = if area > 0.0 { weighted / area } else { 0.5 * (own.low + own.high) - origin };
            let centre = origin + relative;
            let reach = (centre - own.low).max(own.high - centre);
            let squared_far = FAR * FAR * reach.length_squared();
            Moments { centre, squared_far, normal, first: first - outer(relative, normal) }
        });
        Self { moments: moments.collect(), tree, triangles, boxes }
    }

    /// The least box that holds all triangles.
    pub fn bounds(&self) -> Bounds {
        self.boxes[0]
    }

    /// How often the triangles wind around a point: 1 inside of a closed surface, 0 outside; a fraction where it has holes.
    pub fn winding(&self, point: DVec3) -> f64 {
        let (mut angle, mut far) = (0.0, 0.0);
        let near = self.tree.leaves(|node| {
            let moments = &self.moments[node];
            let away = moments.centre - point;
            let squared = away.length_squared();
            let is_far = squared > moments.squared_far;
            if is_far {
                far += moments.winding(away, squared);
            }
            !is_far
        });
        for leaf in near {
            angle += self.triangles[leaf].iter().map(|triangle| solid_angle(triangle, point)).sum::<f64>();
        }
        far + angle / (4.0 * PI)
    }

    /// Where there are triangles on the way from one point to another, in this order.
    pub fn crossings(&self, start: DVec3, end: DVec3) -> Vec<Crossing> {
        let (along, segment) = (end - start, Bounds::of_points([start, end]));
        let mut crossings = Vec::new();
        for leaf in self.tree.leaves(|node| self.boxes[node].meets(segment)) {
            crossings.extend(self.triangles[leaf].iter().filter_map(|triangle| crossing(triangle, start, along)));
        }
        crossings.sort_unstable_by(|a: &Crossing, b| a.share.total_cmp(&b.share));
        crossings
    }

    /// Whether a triangle is nearer than this.
    pub fn is_nearer(&self, point: DVec3, distance: f64) -> bool {
        let (mut is_nearer, place) = (false, Bounds::at(point));
        let to_box = |node: usize| self.boxes[node].squared_distance(place);
        self.tree.nearest(distance * distance, to_box, |leaf, nearest| {
            let mut triangles = self.triangles[leaf].iter();
            is_nearer = triangles.any(|triangle| to_nearest(triangle, point).length_squared() < nearest);
            // One is enough.
            if is_nearer { 0.0 } else { nearest }
        });
        is_nearer
    }

    /// The way from a point to the nearest one of a triangle.
    pub fn to_nearest(&self, point: DVec3) -> DVec3 {
        let (mut way, place) = (DVec3::INFINITY, Bounds::at(point));
        let distance = |node: usize| self.boxes[node].squared_distance(place);
        self.tree.nearest(f64::INFINITY, distance, |leaf, mut nearest| {
            for triangle in &self.triangles[leaf] {
                let to_triangle = to_nearest(triangle, point);
                if to_triangle.length_squared() < nearest {
                    (way, nearest) = (to_triangle, to_triangle.length_squared());
                }
            }
            nearest
        });
        way
    }
}

/// `a bᵀ`.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
