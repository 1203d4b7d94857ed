//! Where a solid is: inside or outside of points, and where it ends along the edges of a lattice.

use std::num::NonZeroUsize;
use std::ops::Range;

use glam::DVec3;
use heatwalk::surface::index::Bounds;
use heatwalk::{Progress, Stage};
use heatwalk_base::parallel;

use super::error::{Error, Result};
use super::hierarchy::Hierarchy;
use super::lattice::{BLOCK, Lattice};
use super::triangle::Crossing;
use crate::boxes::Boxes;
use crate::mesh::locate::weights;
use crate::soup::TetSoup;

/// Points that wind around more often than this are inside.
const INSIDE: f64 = 0.5;

/// Blocks, and distances or cuts, between two calls of the progress callback: some ten milliseconds.
const BLOCKS: usize = 1 << 12;
const EDGES: usize = 1 << 13;

/// Radii of a block that its middle has to be away from the surface, for the middle to tell of all its points.
const CLEAR: f64 = 1.5;

/// How far the winding number there may be from a whole one: at two thirds of the way to the surface it is 15 times as far at most,
/// (1 + ρ) / (1 − ρ)², and that is less than a half.
const WHOLE: f64 = 0.03;

/// Parts of an edge that are shorter than this share of it are not told apart: far below what is seen, far above rounding.
const PRECISION: f64 = 1e-4;

/// Powers of the inverse of the root of x⁴ = x + 1: their multiples, less whole numbers, are spread evenly in a cube (Roberts, "The
/// unreasonable effectiveness of quasirandom sequences", 2018).
const SEQUENCE: DVec3 = DVec3::new(0.819_172_513_396_164_5, 0.671_043_606_703_789_3, 0.549_700_477_901_970_3);

/// What is inside of oriented triangles.
#[derive(Debug)]
pub struct Field {
    hierarchy: Hierarchy,
}

impl Field {
    pub fn new(hierarchy: Hierarchy) -> Self {
        Self { hierarchy }
    }

    /// Nothing outside of this box is inside.
    pub fn bounds(&self) -> Bounds {
        self.hierarchy.bounds()
    }

    /// How often the triangles wind around a point: 0 outside of their box.
    pub fn winding(&self, point: DVec3) -> f64 {
        if self.bounds().holds(point) { self.hierarchy.winding(point) } else { 0.0 }
    }

    /// The way from a point to the nearest one of the surface.
    pub fn to_nearest(&self, point: DVec3) -> DVec3 {
        self.hierarchy.to_nearest(point)
    }

    pub fn is_inside(&self, point: DVec3) -> bool {
        self.winding(point) > INSIDE
    }

    /// By lattice point whether it is inside, and the points that are near the surface. `progress` goes from one share to another.
    pub fn insides(
        &self,
        lattice: &Lattice,
        threads: NonZeroUsize,
        shares: Range<f64>,
        progress: Progress<'_>,
    ) -> Result<(Vec<bool>, Vec<usize>)> {
        let blocks = lattice.blocks();
        let masks = slices(blocks.len(), BLOCKS, threads, shares, progress, |block| {
            let mut masks = [0_u128; 2];
            self.block(lattice, blocks[block], BLOCK, &mut masks);
            masks
        })?;
        let mut is_inside = vec![false; lattice.len()];
        let mut near = Vec::new();
        for (&block, masks) in blocks.iter().zip(&masks).filter(|(_, masks)| **masks != [0; 2]) {
            for (bit, point) in lattice.points_of(block, BLOCK) {
                is_inside[point] = masks[0] >> bit & 1 == 1;
                if masks[1] >> bit & 1 == 1 {
                    near.push(point);
                }
            }
        }
        Ok((is_inside, near))
    }

    /// Sets the bits of the points inside among those of a block of so many cells along each side. Off the surface winding numbers
    /// are harmonic, so that Harnack's inequality bounds them: if the number in the middle of a ball without surface is nearly whole,
    /// none within two thirds of the ball is on the other side of a half.
    fn block(&self, lattice: &Lattice, first: [usize; 3], cells: usize, masks: &mut [u128; 2]) {
        let (middle, radius) = lattice.ball(first, cells);
        if !self.hierarchy.is_nearer(middle, CLEAR * radius) {
            let winding = self.winding(middle);
            if (winding - winding.round()).abs() <= WHOLE {
                if winding > INSIDE {
                    let points = lattice
                        .points_of(first, cells)
                        .filter(|&(_, point)| self.bounds().holds(lattice.position(point)));
                    points.for_each(|(bit, _)| masks[0] |= 1 << bit);
                }
                return;
            }
        }
        if cells > 2 {
            let half = cells / 2;
            for part in 0..8 {
                let corner = [0, 1, 2].map(|axis| first[axis] + half * (part >> axis & 1));
                self.block(lattice, corner, half, masks);
            }
            return;
        }
        for (bit, point) in lattice.points_of(first, cells) {
            masks[0] |= u128::from(self.is_inside(lattice.position(point))) << bit;
            masks[1] |= 1 << bit;
        }
    }

    /// Where each edge from a point inside to one outside is cut.
    pub fn cuts(
        &self,
        lattice: &Lattice,
        edges: &[(u32, u8)],
        threads: NonZeroUsize,
        shares: Range<f64>,
        progress: Progress<'_>,
    ) -> Result<Vec<Crossing>> {
        slices(edges.len(), EDGES, threads, shares, progress, |index| {
            let (inside, direction) = (edges[index].0 as usize, usize::from(edges[index].1));
            self.cut(lattice.position(inside), lattice.position(lattice.neighbour(inside, direction)))
        })
    }

    /// The volume that tetrahedra lack of what is inside: half a cell for each place, one around each point near the surface, that is
    /// inside and in none of them, less those of the contrary. Unlike the lattice, the places are in no line with walls.
    pub fn missing(
        &self,
        soup: &TetSoup,
        lattice: &Lattice,
        near: &[usize],
        threads: NonZeroUsize,
        shares: Range<f64>,
        progress: Progress<'_>,
    ) -> Result<f64> {
        let corners = |tetrahedron: usize| soup.tetrahedra[tetrahedron].map(|corner| soup.positions[corner as usize]);
        let boxes = Boxes::new(soup.tetrahedra.len(), |tetrahedron| Bounds::of_points(corners(tetrahedron)));
        let is_filled = |place: DVec3| {
            let mut is_in_any = false;
            boxes.near(place, |tetrahedron| {
                is_in_any |= weights(corners(tetrahedron as usize), place).iter().all(|&weight| weight >= 0.0);
            });
            is_in_any
        };
        let lacks = slices(near.len(), EDGES, threads, shares, progress, |index| {
            let place = lattice.place_around(near[index], (index as f64 * SEQUENCE).fract());
            i8::from(self.is_inside(place)) - i8::from(is_filled(place))
        })?;
        Ok(0.5 * lattice.side.powi(3) * lacks.into_iter().map(f64::from).sum::<f64>())
    }

    /// The ways from lattice points to the surface.
    pub fn ways(
        &self,
        lattice: &Lattice,
        points: &[usize],
        threads: NonZeroUsize,
        shares: Range<f64>,
        progress: Progress<'_>,
    ) -> Result<Vec<DVec3>> {
        slices(points.len(), EDGES, threads, shares, progress, |index| self.to_nearest(lattice.position(points[index])))
    }

    /// Where on the way from a point inside to one outside the inside ends for the first time.
    fn cut(&self, inside: DVec3, outside: DVec3) -> Crossing {
        let crossings = self.hierarchy.crossings(inside, outside);
        let is_inside = |share: f64| self.is_inside(inside.lerp(outside, share));
        if let Some((&last, others)) = crossings.split_last() {
            // Between two triangles it may be the one or the other.
            let ends = |pair: &&[Crossing]| {
                let [first, second] = [pair[0].share, pair[1].share];
                second - first > PRECISION && !is_inside(0.5 * (first + second))
            };
            return if others.is_empty() { last } else { crossings.windows(2).find(ends).map_or(last, |pair| pair[0]) };
        }
        // A hole: there is no triangle where the sign changes, and it is taken as if it were across.
        let (mut low, mut high) = (0.0, 1.0);
        while high - low > PRECISION {
            let middle = 0.5 * (low + high);
            if is_inside(middle) { low = middle } else { high = middle }
        }
        Crossing { share: 0.5 * (low + high), rise: inside.distance(outside) }
    }
}

/// `value` of each of `0..count`, a slice after the other, each on several threads.
fn slices<T: bytemuck::Zeroable + Send>(
    count: usize,
    slice: usize,
    threads: NonZeroUsize,
    shares: Range<f64>,
    progress: Progress<'_>,
    value: impl Fn(usize) -> T + Sync,
) -> Result<Vec<T>> {
    let mut values = Vec::with_capacity(count);
    let slice = slice * threads.get();
    for start in (0..count).step_by(slice) {
        let done = shares.start + (shares.end - shares.start) * start as f64 / count as f64;
        if progress(Stage::Filling, done).is_break() {
            return Err(Error::Cancelled);
        }
        let length = slice.min(count - start);
        values.extend(parallel::collect(length, threads, |index| value(start + index)));
    }
    Ok(values)
}
