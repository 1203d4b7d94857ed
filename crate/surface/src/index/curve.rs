//! The curve of Morton, "A computer oriented geodetic data base", 1966: cells by the interleaved bits of their coordinates.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_base::parallel;
use heatwalk_base::sort::Sorted;

/// Cells of the curve along each axis, as a power of two.
const BITS: u32 = 10;

/// The numbers of points in order of a Morton curve through their bounding box, those of one cell in their own order.
pub fn along_curve(count: usize, point: impl Fn(usize) -> DVec3 + Sync, threads: NonZeroUsize) -> Vec<u32> {
    let bounds = |(low, high): (DVec3, DVec3), point| (low.min(point), high.max(point));
    let (low, high) = (0..count).map(&point).fold((DVec3::MAX, DVec3::MIN), bounds);
    // Halved, so that the size of the largest box is a number.
    let size = (0.5 * high - 0.5 * low).max_element();
    let most = f64::from((1_u32 << BITS) - 1);
    let cells = parallel::collect(count, threads, |number| {
        let cell = (0.5 * point(number) - 0.5 * low) / size * most;
        spread(cell.x as u32) | spread(cell.y as u32) << 1 | spread(cell.z as u32) << 2
    });
    let order = Sorted::new(&cells, 3 * BITS, threads);
    parallel::collect(count, threads, |place| order.number(place))
}

/// The lowest [`BITS`] bits, two zeros before each.
fn spread(bits: u32) -> u32 {
    let bits = (bits | bits << 16) & 0x0300_00FF;
    let bits = (bits | bits << 8) & 0x0300_F00F;
    let bits = (bits | bits << 4) & 0x030C_30C3;
    (bits | bits << 2) & 0x0924_9249
}
