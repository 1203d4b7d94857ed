//! Polygons to triangles: a fan where the polygon is strictly convex, a constrained Delaunay triangulation by spade elsewhere.

use std::cmp::Reverse;
use std::ops::Range;

use glam::{DVec2, DVec3};
use heatwalk_base::parallel;
use heatwalk_base::sort;
use heatwalk_surface::index::along_curve;
use heatwalk_surface::{WarningCode, Warnings};
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation, mitigate_underflow};

use super::budget::Budget;
use crate::error::Result;

/// Bytes a corner that a polygon takes while it is cut: its points, as they are and sorted, and vertices, edges and faces of spade.
/// All of reading a comb of 100,000 corners takes 366.
const CUTTING_BYTES: u64 = 384;

/// Corners from which on they are inserted one by one: all at once grow as the square of their number where they lie on circles.
const MANY: usize = 4096;

/// Polygons as one list of corners. They are triangulated last, since a file may name vertices before it gives them.
#[derive(Debug)]
pub struct Polygons<'a> {
    budget: &'a Budget,
    corners: Vec<u32>,
    ends: Vec<usize>,
    /// The first corner of a vertex that no mesh can hold.
    beyond: Option<Missing>,
}

/// A corner that names a vertex that there is not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Missing {
    /// Polygon, counted from 0.
    pub polygon: usize,
    /// The vertex that it names.
    pub vertex: u64,
}

/// Triangles, and the range of those of each polygon that has more than one.
type Cut = (Vec<[u32; 3]>, Vec<Range<usize>>);

impl<'a> Polygons<'a> {
    /// None yet.
    pub fn new(budget: &'a Budget) -> Self {
        Self { budget, corners: Vec::new(), ends: Vec::new(), beyond: None }
    }

    /// Adds a corner to the polygon that the next [`Self::close`] ends.
    ///
    /// # Errors
    /// [`OverBudget`](crate::Error::OverBudget).
    pub fn corner(&mut self, vertex: u64) -> Result<()> {
        let corner = u32::try_from(vertex).unwrap_or_else(|_| {
            self.beyond.get_or_insert(Missing { polygon: self.ends.len(), vertex });
            u32::MAX
        });
        self.budget.push(&mut self.corners, corner)
    }

    /// Ends the polygon. Fewer than three corners make a point or a line, which triangulate to nothing.
    ///
    /// # Errors
    /// [`OverBudget`](crate::Error::OverBudget).
    pub fn close(&mut self) -> Result<()> {
        self.budget.push(&mut self.ends, self.corners.len())
    }

    /// Polygons so far.
    pub fn count(&self) -> usize {
        self.ends.len()
    }

    /// Corners of all polygons so far.
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// The vertices at some places of the list of all corners.
    pub fn vertices(&self, places: [usize; 3]) -> [u32; 3] {
        places.map(|place| self.corners[place])
    }

    /// Refuses corners of vertices from `vertices` on.
    ///
    /// # Errors
    /// The first such corner.
    pub fn check(&self, vertices: usize) -> std::result::Result<(), Missing> {
        let place = self.corners.iter().position(|&vertex| vertex as usize >= vertices);
        let missing = place.map(|place| Missing {
            polygon: self.ends.partition_point(|&end| end <= place),
            vertex: self.corners[place].into(),
        });
        self.beyond.or(missing).map_or(Ok(()), Err)
    }

    /// Appends the triangles of polygon `index`, after [`Self::check`], to `triangles`, each corner by its place in the list of all
    /// corners. Returns false where no triangles have its outline, because it crosses itself.
    ///
    /// # Errors
    /// [`OverBudget`](crate::Error::OverBudget).
    pub fn triangulate_corners(
        &self,
        index: usize,
        positions: &[DVec3],
        triangles: &mut Vec<[usize; 3]>,
    ) -> Result<bool> {
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        let corners = &self.corners[start..self.ends[index]];
        self.budget.reserve(triangles, corners.len().saturating_sub(2))?;
        Ok(match corners.len() {
            0..=2 => true,
            3 => {
                triangles.push([start, start + 1, start + 2]);
                true
            }
            count => {
                let _loan = self.budget.loan();
                self.budget.lend(CUTTING_BYTES * count as u64)?;
                polygon(start, corners, positions, triangles)
            }
        })
    }

    /// The triangles of all polygons in order, after [`Self::check`], and those of each that has more than one. `place`: what the file calls a
    /// polygon, for warnings.
    ///
    /// # Errors
    /// [`OverBudget`](crate::Error::OverBudget).
    pub fn triangulate_all(
        &self,
        positions: &[DVec3],
        warnings: &mut Warnings,
        place: impl Fn(usize) -> String,
    ) -> Result<Cut> {
        let mut triangles = self.budget.list(self.corners.len().saturating_sub(2 * self.ends.len()))?;
        let (mut corners, mut cut) = (Vec::new(), Vec::new());
        for index in 0..self.ends.len() {
            corners.clear();
            if !self.triangulate_corners(index, positions, &mut corners)? {
                warnings.add(WarningCode::CrossedPolygons, || place(index));
            }
            self.budget.reserve(&mut triangles, corners.len())?;
            if corners.len() > 1 {
                self.budget.push(&mut cut, triangles.len()..triangles.len() + corners.len())?;
            }
            triangles.extend(corners.iter().map(|&places| self.vertices(places)));
        }
        Ok((triangles, cut))
    }
}

/// `first`: the place of the first corner in the list of all.
fn polygon(first: usize, corners: &[u32], positions: &[DVec3], triangles: &mut Vec<[usize; 3]>) -> bool {
    let plane = project(corners, positions);
    let count = corners.len();
    let is_turn = |a: usize, b: usize, c: usize| area(plane[a], plane[b], plane[c]) > 0.0;
    let fan = (1..count - 1).map(|i| [0, i, i + 1]);
    // One that winds around twice is convex at each corner, too.
    let is_convex = (0..count).all(|i| is_turn(i, (i + 1) % count, (i + 2) % count))
        && fan.clone().all(|[a, b, c]| is_turn(a, b, c));
    let mut add = |[a, b, c]: [usize; 3]| triangles.push([first + a, first + b, first + c]);
    if is_convex {
        fan.for_each(add);
        return true;
    }
    let cut = cut(&plane);
    match &cut {
        Some(cut) => cut.iter().copied().for_each(&mut add),
        None => fan.for_each(&mut add),
    }
    // One without area has no triangles but flat ones.
    cut.is_some() || (0..count).all(|i| area(plane[0], plane[i], plane[(i + 1) % count]) == 0.0)
}

/// The polygon along the strongest axis of its Newell normal, counter-clockwise.
fn project(corners: &[u32], positions: &[DVec3]) -> Vec<DVec2> {
    let points: Vec<DVec3> = corners.iter().map(|&corner| positions[corner as usize]).collect();
    // Relative to a corner, so that a small polygon far from the origin keeps its digits.
    let origin = points[0];
    let mut normal = DVec3::ZERO;
    for (i, &point) in points.iter().enumerate() {
        normal += (point - origin).cross(points[(i + 1) % points.len()] - origin);
    }
    let size = normal.abs();
    let axis = if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    let (mut u, mut v) = ((axis + 1) % 3, (axis + 2) % 3);
    if normal[axis] < 0.0 {
        std::mem::swap(&mut u, &mut v);
    }
    points.iter().map(|&point| DVec2::new(point[u] - origin[u], point[v] - origin[v])).collect()
}

/// Twice the signed area, positive counter-clockwise.
fn area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// A corner in its plane.
#[derive(Clone, Copy)]
struct Corner {
    point: Point2<f64>,
    index: usize,
}

impl HasPosition for Corner {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.point
    }
}

type Delaunay = ConstrainedDelaunayTriangulation<Corner>;

/// The Delaunay triangulation of corners at different places. Many are inserted in rounds, each of about twice as many as the one
/// before and along a curve (Amenta, Choi and Rote, "Incremental constructions con BRIO", 2003).
fn delaunay(corners: Vec<Corner>) -> Option<Delaunay> {
    if corners.len() < MANY {
        return Delaunay::bulk_load(corners).ok();
    }
    let place = |number: usize| DVec3::new(corners[number].point.x, corners[number].point.y, 0.0);
    let mut order = along_curve(corners.len(), place, parallel::ONE);
    // Multiples of the golden ratio are spread evenly: half of them begin with no zero, a quarter with one.
    sort::sort_by_key(&mut order, |number| Reverse(number.wrapping_mul(0x9e37_79b9).leading_zeros()));
    let mut delaunay = Delaunay::new();
    for number in order {
        delaunay.insert(corners[number as usize]).ok()?;
    }
    Some(delaunay)
}

/// The triangles inside of a counter-clockwise outline: where it winds around counter-clockwise. Corners of one place count as one,
/// and an edge that is gone along both ways, as bridges to holes are, bounds nothing. None where the outline crosses itself or
/// bounds nothing.
fn cut(plane: &[DVec2]) -> Option<Vec<[usize; 3]>> {
    let size = plane.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    // By a power of two, so that what is straight stays straight.
    let scale = (-size.log2().floor()).exp2();
    let points: Vec<_> =
        plane.iter().map(|&point| mitigate_underflow(Point2::new(scale * point.x, scale * point.y))).collect();
    let by_place = |&a: &usize, &b: &usize| {
        let [a, b] = [a, b].map(|corner| points[corner]);
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    };
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    sort::sort_by(&mut sorted, by_place);
    let mut first_there = vec![0; points.len()];
    let mut corners = Vec::with_capacity(points.len());
    for same in sorted.chunk_by(|a, b| points[*a] == points[*b]) {
        same.iter().for_each(|&corner| first_there[corner] = same[0]);
        corners.push(Corner { point: points[same[0]], index: same[0] });
    }
    let mut delaunay = delaunay(corners)?;
    let mut vertex = vec![None; points.len()];
    delaunay.vertices().for_each(|corner| vertex[corner.data().index] = Some(corner.fix()));
    // How often the outline goes along a half-edge, less how often against it. Constraints keep their numbers.
    let mut along = vec![0_i32; delaunay.num_directed_edges()];
    for corner in 0..points.len() {
        let [from, to] = [corner, (corner + 1) % points.len()].map(|corner| vertex[first_there[corner]]);
        if from == to {
            continue;
        }
        let edges = delaunay.try_add_constraint(from?, to?);
        if edges.is_empty() {
            return None;
        }
        for edge in edges {
            along[edge.index()] += 1;
            along[edge.rev().index()] -= 1;
        }
    }
    let mut winding: Vec<Option<i32>> = vec![None; delaunay.num_all_faces()];
    let mut open = Vec::new();
    let hull = delaunay.convex_hull().flat_map(|edge| [edge, edge.rev()]);
    for edge in hull {
        if let Some(face) = edge.face().as_inner() {
            winding[face.index()].get_or_insert_with(|| {
                open.push(face);
                along[edge.fix().index()]
            });
        }
    }
    let mut inside = Vec::new();
    while let Some(face) = open.pop() {
        let here = winding[face.index()].unwrap_or_default();
        for edge in face.adjacent_edges().map(|edge| edge.rev()) {
            if let Some(other) = edge.face().as_inner() {
                winding[other.index()].get_or_insert_with(|| {
                    open.push(other);
                    here + along[edge.fix().index()]
                });
            }
        }
        if here > 0 {
            inside.push(face.vertices().map(|vertex| vertex.data().index));
        }
    }
    // As the corners run, so that what is near in the file stays near.
    sort::sort_by_key(&mut inside, |corners| *corners.iter().min().unwrap_or(&0));
    (!inside.is_empty()).then_some(inside)
}
