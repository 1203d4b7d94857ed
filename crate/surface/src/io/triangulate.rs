//! Polygons to triangles: a fan where the polygon is strictly convex, ear clipping (Meisters 1975) elsewhere.

use glam::{DVec2, DVec3};

use super::budget::Budget;
use crate::error::{Error, Result};

/// Ear clipping costs (corners × reflex corners); beyond this a hostile polygon could stall the page, so it is fanned.
const MAX_EAR_CLIPPED_CORNERS: usize = 4096;

/// Bytes a corner that a polygon takes while it is cut: a point in space and in the plane, both neighbors, the list of reflex corners.
const CUTTING_BYTES: u64 = (size_of::<DVec3>() + size_of::<DVec2>() + 3 * size_of::<usize>()) as u64;

/// Polygons as one list of corners. They are triangulated last, since a file may name vertices before it gives them.
pub struct Polygons<'a> {
    budget: &'a Budget,
    corners: Vec<u32>,
    ends: Vec<usize>,
}

impl<'a> Polygons<'a> {
    pub fn new(budget: &'a Budget) -> Self {
        Self { budget, corners: Vec::new(), ends: Vec::new() }
    }

    /// Adds a corner to the polygon that the next [`Self::close`] ends.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`] for an index that no mesh can hold; `vertices` is the number known so far. [`Error::OverBudget`].
    pub fn corner(&mut self, vertex: u64, vertices: usize) -> Result<()> {
        let triangle = self.ends.len();
        let corner = u32::try_from(vertex).map_err(|_| Error::IndexOutOfRange { triangle, vertex, vertices })?;
        self.budget.push(&mut self.corners, corner)
    }

    /// Ends the polygon. Fewer than three corners make a point or a line, which triangulate to nothing.
    ///
    /// # Errors
    /// [`Error::OverBudget`].
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

    /// Appends the triangles of polygon `index` to `triangles`, each corner by its place in the list of all corners.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`] where a corner names no vertex; the polygon is counted as the triangle. [`Error::OverBudget`].
    pub fn triangulate_corners(
        &self,
        index: usize,
        positions: &[DVec3],
        triangles: &mut Vec<[usize; 3]>,
    ) -> Result<()> {
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        let corners = &self.corners[start..self.ends[index]];
        if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= positions.len()) {
            return Err(Error::IndexOutOfRange { triangle: index, vertex: vertex.into(), vertices: positions.len() });
        }
        self.budget.reserve(triangles, corners.len().saturating_sub(2))?;
        match corners.len() {
            0..=2 => {}
            3 => triangles.push([start, start + 1, start + 2]),
            count => {
                let _loan = self.budget.loan();
                self.budget.lend(CUTTING_BYTES * count as u64)?;
                polygon(start, corners, positions, triangles);
            }
        }
        Ok(())
    }

    /// The triangles of all polygons in order.
    ///
    /// # Errors
    /// As [`Self::triangulate_corners`].
    pub fn triangulate_all(&self, positions: &[DVec3]) -> Result<Vec<[u32; 3]>> {
        let mut triangles = self.budget.list(self.corners.len().saturating_sub(2 * self.ends.len()))?;
        let mut corners = Vec::new();
        for index in 0..self.ends.len() {
            corners.clear();
            self.triangulate_corners(index, positions, &mut corners)?;
            self.budget.reserve(&mut triangles, corners.len())?;
            triangles.extend(corners.iter().map(|&places| self.vertices(places)));
        }
        Ok(triangles)
    }
}

/// `first`: the place of the first corner in the list of all.
fn polygon(first: usize, corners: &[u32], positions: &[DVec3], triangles: &mut Vec<[usize; 3]>) {
    let plane = project(corners, positions);
    let count = corners.len();
    let convex = (0..count).all(|i| area(plane[i], plane[(i + 1) % count], plane[(i + 2) % count]) > 0.0);
    if convex || count > MAX_EAR_CLIPPED_CORNERS {
        triangles.extend((1..count - 1).map(|i| [first, first + i, first + i + 1]));
    } else {
        clip_ears(first, &plane, triangles);
    }
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

fn clip_ears(first: usize, plane: &[DVec2], triangles: &mut Vec<[usize; 3]>) {
    let count = plane.len();
    let mut next: Vec<usize> = (0..count).map(|i| (i + 1) % count).collect();
    let mut previous: Vec<usize> = (0..count).map(|i| (i + count - 1) % count).collect();
    let turn = |previous: &[usize], next: &[usize], i: usize| area(plane[previous[i]], plane[i], plane[next[i]]);
    // Only a corner that is not convex can lie in an ear, and clipping never makes a convex corner reflex.
    let mut reflex: Vec<usize> = (0..count).filter(|&i| turn(&previous, &next, i) <= 0.0).collect();
    let mut remaining = count;
    let mut current = 0;
    let mut tried = 0;
    while remaining > 3 {
        let (before, after) = (previous[current], next[current]);
        let is_ear = turn(&previous, &next, current) > 0.0 && {
            let (a, b, c) = (plane[before], plane[current], plane[after]);
            !reflex.iter().any(|&i| {
                let point = plane[i];
                // A corner that coincides with one of the ear's is where a hole's bridge returns, not an obstacle.
                point != a
                    && point != b
                    && point != c
                    && area(a, b, point) >= 0.0
                    && area(b, c, point) >= 0.0
                    && area(c, a, point) >= 0.0
            })
        };
        // A polygon that crosses itself or has no area may have no ear: clip anyway, so that the loop ends.
        if !is_ear && tried < remaining {
            tried += 1;
            current = after;
            continue;
        }
        triangles.push([before, current, after].map(|corner| first + corner));
        next[before] = after;
        previous[after] = before;
        remaining -= 1;
        tried = 0;
        reflex.retain(|&i| i != current && ((i != before && i != after) || turn(&previous, &next, i) <= 0.0));
        // Skipping a corner between ears avoids a fan of slivers.
        current = next[after];
    }
    triangles.push([previous[current], current, next[current]].map(|corner| first + corner));
}
