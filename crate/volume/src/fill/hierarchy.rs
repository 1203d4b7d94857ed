//! A hierarchy over oriented triangles: the distance to the nearest one, and the generalized winding number (Jacobson, Kavan &
//! Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding numbers", 2013) with far triangles taken
//! together (Barill, Dickson, Schmidt, Levin & Jacobson, "Fast winding numbers for soups and clouds", 2018).
//!
//! Triangles lie along a Morton curve in leaves of a few, under a complete binary tree.

use std::f64::consts::PI;
use std::num::NonZeroUsize;

use glam::{DMat3, DVec3};
use heatwalk::surface::along_curve;

use super::triangle::{Crossing, Triangle, area_vector, crossing, solid_angle, to_nearest};

/// Triangles of a leaf, but for the last one.
const LEAF: usize = 4;

/// How far away, in radii of a node, its triangles are taken together: the β of Barill and others, who choose 2.
const FAR: f64 = 2.0;

/// Nodes that can wait: a complete tree has fewer than 32 levels, and each puts one aside.
const STACK: usize = 32;

#[derive(Debug, Clone, Copy)]
struct Box {
    low: DVec3,
    high: DVec3,
}

impl Box {
    fn around(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    #[inline]
    fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && self.high.cmpge(other.low).all()
    }

    #[inline]
    fn squared_distance(&self, point: DVec3) -> f64 {
        (self.low - point).max(point - self.high).max(DVec3::ZERO).length_squared()
    }
}

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

/// Oriented triangles in boxes.
#[derive(Debug)]
pub struct Hierarchy {
    triangles: Vec<Triangle>,
    /// The root, then the children of node `i` at `2 i + 1` and `2 i + 2`; the leaves come last.
    boxes: Vec<Box>,
    moments: Vec<Moments>,
}

impl Hierarchy {
    /// Of one triangle at least.
    pub fn new(triangles: &[Triangle], threads: NonZeroUsize) -> Self {
        let middle = |index: usize| triangles[index].iter().sum::<DVec3>() / 3.0;
        let order = along_curve(triangles.len(), middle, threads);
        let triangles: Vec<Triangle> = order.iter().map(|&index| triangles[index as usize]).collect();
        let leaves = triangles.len().div_ceil(LEAF);
        let inner = leaves - 1;
        let empty = Box { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };
        let mut boxes = vec![empty; inner];
        // Area, area times centroid, area times normal, area times outer product about the origin of coordinates.
        let mut sums = vec![(0.0, DVec3::ZERO, DVec3::ZERO, DMat3::ZERO); inner];
        let origin = triangles[0][0];
        for leaf in triangles.chunks(LEAF) {
            let (mut own, mut sum) = (empty, (0.0, DVec3::ZERO, DVec3::ZERO, DMat3::ZERO));
            for triangle in leaf {
                for &corner in triangle {
                    own = own.around(Box { low: corner, high: corner });
                }
                let (normal, centroid) = (0.5 * area_vector(triangle), triangle.iter().sum::<DVec3>() / 3.0 - origin);
                let area = normal.length();
                sum.0 += area;
                sum.1 += area * centroid;
                sum.2 += normal;
                sum.3 += outer(centroid, normal);
            }
            boxes.push(own);
            sums.push(sum);
        }
        for node in (0..inner).rev() {
            let [first, second] = [2 * node + 1, 2 * node + 2];
            boxes[node] = boxes[first].around(boxes[second]);
            let (a, b) = (sums[first], sums[second]);
            sums[node] = (a.0 + b.0, a.1 + b.1, a.2 + b.2, a.3 + b.3);
        }
        let moments = sums.iter().zip(&boxes).map(|(&(area, weighted, normal, first), own)| {
            let relative = if area > 0.0 { weighted / area } else { 0.5 * (own.low + own.high) - origin };
            let centre = origin + relative;
            let reach = (centre - own.low).max(own.high - centre);
            let squared_far = FAR * FAR * reach.length_squared();
            Moments { centre, squared_far, normal, first: first - outer(relative, normal) }
        });
        Self { moments: moments.collect(), triangles, boxes }
    }

    /// The corners of the least box that holds all triangles.
    pub fn bounds(&self) -> [DVec3; 2] {
        [self.boxes[0].low, self.boxes[0].high]
    }

    fn leaf(&self, node: usize) -> Option<&[Triangle]> {
        let inner = self.boxes.len() / 2;
        let first = LEAF * node.checked_sub(inner)?;
        Some(&self.triangles[first..self.triangles.len().min(first + LEAF)])
    }

    /// How often the triangles wind around a point: 1 inside of a closed surface, 0 outside; a fraction where it has holes.
    pub fn winding(&self, point: DVec3) -> f64 {
        let (mut angle, mut far) = (0.0, 0.0);
        let mut waiting = [0_u32; STACK];
        let (mut count, mut node) = (0, 0);
        loop {
            let moments = &self.moments[node];
            let away = moments.centre - point;
            let squared = away.length_squared();
            if squared > moments.squared_far {
                far += moments.winding(away, squared);
            } else if let Some(leaf) = self.leaf(node) {
                angle += leaf.iter().map(|triangle| solid_angle(triangle, point)).sum::<f64>();
            } else {
                waiting[count] = 2 * node as u32 + 2;
                count += 1;
                node = 2 * node + 1;
                continue;
            }
            if count == 0 {
                return far + angle / (4.0 * PI);
            }
            count -= 1;
            node = waiting[count] as usize;
        }
    }

    /// Where there are triangles on the way from one point to another, in this order.
    pub fn crossings(&self, start: DVec3, end: DVec3) -> Vec<Crossing> {
        let along = end - start;
        let segment = Box { low: start.min(end), high: start.max(end) };
        let mut crossings = Vec::new();
        let mut waiting = [0_u32; STACK];
        let (mut count, mut node) = (0, 0);
        loop {
            if self.boxes[node].meets(&segment) {
                match self.leaf(node) {
                    Some(leaf) => crossings.extend(leaf.iter().filter_map(|triangle| crossing(triangle, start, along))),
                    None => {
                        waiting[count] = 2 * node as u32 + 2;
                        count += 1;
                        node = 2 * node + 1;
                        continue;
                    }
                }
            }
            if count == 0 {
                crossings.sort_unstable_by(|a: &Crossing, b| a.share.total_cmp(&b.share));
                return crossings;
            }
            count -= 1;
            node = waiting[count] as usize;
        }
    }

    /// The way from a point to the nearest one of a triangle.
    pub fn to_nearest(&self, point: DVec3) -> DVec3 {
        let (mut way, mut nearest) = (DVec3::INFINITY, f64::INFINITY);
        let mut waiting = [(0_u32, 0.0); STACK];
        let (mut count, mut node) = (0, 0);
        loop {
            if let Some(leaf) = self.leaf(node) {
                for triangle in leaf {
                    let to_triangle = to_nearest(triangle, point);
                    if to_triangle.length_squared() < nearest {
                        (way, nearest) = (to_triangle, to_triangle.length_squared());
                    }
                }
            } else {
                let [a, b] =
                    [2 * node + 1, 2 * node + 2].map(|child| (child, self.boxes[child].squared_distance(point)));
                let (near, far) = if b.1 < a.1 { (b, a) } else { (a, b) };
                if near.1 < nearest {
                    if far.1 < nearest {
                        waiting[count] = (far.0 as u32, far.1);
                        count += 1;
                    }
                    node = near.0;
                    continue;
                }
            }
            loop {
                if count == 0 {
                    return way;
                }
                count -= 1;
                if waiting[count].1 < nearest {
                    node = waiting[count].0 as usize;
                    break;
                }
            }
        }
    }
}

/// `a bᵀ`.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
