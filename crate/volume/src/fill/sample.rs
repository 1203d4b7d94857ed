//! A few points everywhere, which tell whether a surface has an inside, and how much is in it.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk::surface::parallel;

use super::field::Field;
use super::lattice::Lattice;

/// Cells in the box of the surface, about. A hole that matters is seen at this resolution.
const CELLS: f64 = 8000.0;

/// Most cells along the longest side, however flat the box.
const MOST_ALONG: f64 = 200.0;

/// Share of a cell from the low corner of the box to the first point, so that points keep off planes where models end or have
/// walls.
const SHIFT: f64 = 0.219;

/// Farther than this from a whole number, a winding number tells of a hole; far triangles taken together cost a hundredth or two.
const FRACTION: f64 = 0.2;

/// What the points found.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    /// Volume of what is inside.
    pub volume: f64,
    /// Share of points whose winding number is no whole number, of those inside.
    pub undecided: f64,
    /// Whether parts overlap.
    pub has_overlaps: bool,
    /// How often lines along the axes cross the end of what is inside, times the area between such lines: in the mean over all
    /// orientations one and a half times the area.
    pub crossings: f64,
}

impl Sample {
    pub fn new(field: &Field, threads: NonZeroUsize) -> Self {
        let [low, high] = field.bounds();
        let size = high - low;
        let side = (size.element_product() / CELLS).cbrt().max(size.max_element() / MOST_ALONG);
        // Beyond the last point another layer, so that each point inside has neighbours.
        let cells = (size / side).to_array().map(|cells| cells.ceil() as usize + 2);
        let lattice = Lattice::new(low + (SHIFT - 1.0) * DVec3::splat(side), side, cells);
        let windings = parallel::collect(lattice.len(), threads, |point| field.winding(lattice.position(point)));
        let is_inside = |point: usize| windings[point] > 0.5;
        let count = |is_counted: &dyn Fn(usize) -> bool| (0..lattice.len()).filter(|&point| is_counted(point)).count();
        let inside = count(&is_inside);
        let undecided = count(&|point| (windings[point] - windings[point].round()).abs() > FRACTION);
        let ends = |point: &usize| (0..6).filter(|&axis| !is_inside(lattice.neighbour(*point, axis))).count();
        let crossed: usize = (0..lattice.len()).filter(|&point| is_inside(point)).map(|point| ends(&point)).sum();
        Self {
            // Each point stands for half a cell.
            volume: 0.5 * inside as f64 * side.powi(3),
            undecided: undecided as f64 / inside.max(1) as f64,
            has_overlaps: count(&|point| windings[point] > 1.5) > 0,
            crossings: 0.5 * crossed as f64 * side * side,
        }
    }
}
