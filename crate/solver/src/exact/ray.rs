//! Straight lines, followed back to their source from face to face.

use heatwalk_sparse::c64;
use heatwalk_surface::{Place, VertexId};

use super::geometry::{after, before};
use super::goal::Goal;
use super::wavefront::Wavefront;
use super::window::length;
use crate::extremum::{larger, smaller};

/// A line that passes a vertex at no more than this share of its length may go through it instead, if the vertex's
/// value agrees: the ends of windows are rays through vertices, and rounding must not choose a side there.
const SNAP: f64 = 1e-10;

/// A source unfolded along the line to it comes to lie on itself within this share of the line, far more than rounding.
const MEETS: f64 = 1e-7;

/// A source may come to lie behind an edge that the line to it crosses by this share of their lengths.
const BEHIND: f64 = 1e-6;

/// Where a line back to its source leaves a face: at `at` of a half-edge, seen from that face, to `(x, −depth)`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ray {
    pub halfedge: u32,
    pub at: f64,
    pub x: f64,
    pub depth: f64,
}

/// What a step into a face finds.
pub(super) enum Found {
    /// The source, at these weights of the face.
    Arrived([f64; 3]),
    /// A way out, and what turns directions from the frame of the half-edge before to the one there, both seen from the faces that they
    /// are left by; that of a mirrored face turns by half a turn more.
    Leaves(Ray, c64),
    /// Nothing: the line belongs to another face of the edge, and ends here without having met the source.
    Lost,
}

impl Ray {
    /// Within this of a place where it ends its source has been met.
    pub fn near(&self, grain: f64) -> f64 {
        MEETS * length(self.x - self.at, self.depth) + grain
    }
}

impl Wavefront {
    /// Takes a ray into the face of `half-edge`, on the far side of its edge; `is_mirrored` where that half-edge runs in the
    /// ray's half-edge's direction. Its source is met by what comes as near as
    /// `near`.
    #[inline(always)]
    pub(super) fn step(&self, ray: Ray, (halfedge, is_mirrored): (u32, bool), (source, near): (Goal, f64)) -> Found {
        let (frame, k) = self.geometry.frame_of(halfedge);
        let (l, r) = (before(k), after(k));
        let across = frame[k].length;
        // The source is above the half-edge now.
        let turn = |x: f64| if is_mirrored { x } else { across - x };
        let (at, x, y) = (turn(ray.at), turn(ray.x), ray.depth);
        let opposite = frame.opposite(k);
        if let Some(weights) = self.weights_of_goal(source, halfedge, [x, y]) {
            let [root_x, root_y] = frame.place(k, weights);
            if length(root_x - x, root_y - y) <= near {
                return Found::Arrived(weights);
            }
        }
        let [forward, up] = [x - at, y];
        // A source on this edge that is none of the face's corners lies beyond it, where the face is flat.
        let is_here = up <= near && length(forward, up) <= near;
        let is_left = if is_here { x <= opposite[0] } else { (opposite[0] - at) * up - opposite[1] * forward >= 0.0 };
        // From the end that both edges share.
        let (out, corner, from_end, aside, towards) =
            if is_left { (l, k, at, x, -forward) } else { (r, r, across - at, across - x, forward) };
        let (cos, sin, out_length) = (frame[corner].cos, frame[corner].sin, frame[out].length);
        let closing = cos * up + sin * towards;
        let meets = if closing > 0.0 { smaller(from_end * up / closing, out_length) } else { out_length };
        let (along, depth) = (aside * cos + y * sin, y * cos - aside * sin);
        if depth.is_nan() || depth < -BEHIND * (out_length + y) || (is_here && depth > near) {
            return Found::Lost;
        }
        let (at, x, turn) = if is_left {
            (out_length - meets, out_length - along, c64::new(cos, -sin))
        } else {
            (meets, along, c64::new(cos, sin))
        };
        let at = if is_here { x.clamp(0.0, out_length) } else { at };
        let halfedge = halfedge - k as u32 + out as u32;
        Found::Leaves(Ray { halfedge, at, x, depth: larger(depth, 0.0) }, turn)
    }

    /// The end of the half-edge that a ray passes through, if the path may continue from there: to a place at this distance, straight from
    /// a root.
    #[inline(always)]
    pub(super) fn passes(&self, to: f64, root: u32, ray: &Ray) -> Option<u32> {
        let (frame, k) = self.geometry.frame_of(ray.halfedge);
        let ends = [(frame[k].vertex, ray.at), (frame[after(k)].vertex, frame[k].length - ray.at)];
        // Most lines pass far from both, which a longer way than the line tells.
        let bound = SNAP * ((ray.x - ray.at).abs() + ray.depth) + self.geometry.grain;
        if smaller(ends[0].1, ends[1].1) > bound {
            return None;
        }
        let left = length(ray.x - ray.at, ray.depth);
        let near = SNAP * left + self.geometry.grain;
        let (vertex, _) = ends.into_iter().find(|&(_, distance)| distance <= near)?;
        let value = self.values[VertexId(vertex)];
        (value < to && value <= self.value_of_root(root) + left + 2.0 * near).then_some(vertex)
    }

    /// The corner of a face here by which the source is nearest, if it is nearer than here.
    pub(super) fn nearer_corner(&self, place: Place, value: f64) -> Option<(u32, u32)> {
        let corners = self.geometry.faces_at(&self.surface, place).into_iter().flat_map(|(face, weights)| {
            let frame = self.geometry.frame(face);
            let [x, y] = frame.place(0, weights);
            [0, 1, 2].map(|k| {
                let [along, up] = frame.place(0, std::array::from_fn(|corner| f64::from(u8::from(corner == k))));
                (face, frame[k].vertex, length(along - x, up - y))
            })
        });
        let nearer = corners.filter(|&(_, corner, _)| self.values[VertexId(corner)] < value);
        let by = |(_, corner, length): (u32, u32, f64)| self.values[VertexId(corner)] + length;
        let (face, corner, _) = nearer.min_by(|&a, &b| by(a).total_cmp(&by(b)))?;
        Some((face, corner))
    }
}
