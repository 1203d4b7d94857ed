//! The curve of Morton, "A computer oriented geodetic data base", 1966: cells by the interleaved bits of their coordinates.

use std::num::NonZeroUsize;

use glam::DVec3;

use super::Bounds;
use crate::parallel;
use crate::sort::Sorted;

/// Cells of the curve along each axis, as a power of two.
const BITS: u32 = 10;

/// The same of the fine curve.
const FINE_BITS: u32 = 21;

/// The numbers of points in order of a Morton curve through their bounding box, those of one cell in their own order.
pub fn along_curve(count: usize, point: impl Fn(usize) -> DVec3 + Sync, threads: NonZeroUsize) -> Vec<u32> {
    let bounds = |(low, high): (DVec3, DVec3), point| (low.min(point), high.max(point));
    let (low, high) = (0..count).map(&point).fold((DVec3::MAX, DVec3::MIN), bounds);
    // Halved, so that the size of the largest box is a number.
    let size = (0.5 * high - 0.5 * low).max_element();
    let most = f64::from((1_u32 << BITS) - 1);
    let cells =
        parallel::collect(count, threads, |number| cell((0.5 * point(number) - 0.5 * low) / size * most) as u32);
    let order = Sorted::new(&cells, 3 * BITS, threads);
    parallel::collect(count, threads, |place| order.number(place))
}

/// The same in cells 2,048 times as small, for points most of which may be in one of the larger cells. Their bounding box is none of
/// the largest.
#[must_use]
pub fn along_fine_curve(points: &[DVec3]) -> Vec<u32> {
    let bounds = Bounds::of_points(points.iter().copied());
    let scale = f64::from((1_u32 << FINE_BITS) - 1) / bounds.size().max_element();
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by_cached_key(|&number| cell((points[number as usize] - bounds.low) * scale));
    order
}

/// The number of a cell on the curve, by its coordinates.
fn cell(place: DVec3) -> u64 {
    spread(place.x) | spread(place.y) << 1 | spread(place.z) << 2
}

/// The lowest [`FINE_BITS`] bits, two zeros before each.
fn spread(coordinate: f64) -> u64 {
    let bits = coordinate as u64;
    let bits = (bits | bits << 32) & 0x001F_0000_0000_FFFF;
    let bits = (bits | bits << 16) & 0x001F_0000_FF00_00FF;
    let bits = (bits | bits << 8) & 0x100F_00F0_0F00_F00F;
    let bits = (bits | bits << 4) & 0x10C3_0C30_C30C_30C3;
    (bits | bits << 2) & 0x1249_2492_4924_9249
}
