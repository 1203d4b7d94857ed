//! A few points everywhere, which tell whether a surface has an inside, and how much is in it.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_base::parallel;

use super::field::Field;
use super::lattice::Lattice;
use super::triangle::{Triangle, area_vector};

/// Cells in the box of the surface, about. A hole that matters is seen at this resolution.
const CELLS: f64 = 8000.0;

/// Most cells along the longest side, however flat the box.
const MOST_ALONG: f64 = 200.0;

/// Share of a cell from the low corner of the box to the first point, so that points keep off planes where models end or have
/// walls.
const SHIFT: f64 = 0.219;

/// Farther than this from a whole number, a winding number tells of a hole; far triangles taken together cost a hundredth or two.
const FRACTION: f64 = 0.2;

/// Points that the surface winds around more often are in two parts.
const TWICE: f64 = 1.5;

/// Most triangles under which is looked for other parts.
const TRIANGLES: usize = 4096;

/// How far under them, as a share of the longest side of the box: overlaps as thin hold nothing.
const UNDER: f64 = 1e-6;

/// What the points found.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    /// Volume of what is inside.
    pub volume: f64,
    /// Share of points whose winding number is no whole number, of those inside.
    pub undecided: f64,
    /// Whether parts overlap that are not thin.
    pub has_overlaps: bool,
    /// Whether parts overlap at all.
    pub has_thin_overlaps: bool,
    /// How often lines along the axes cross the end of what is inside, times the area between such lines: in the mean over all
    /// orientations one and a half times the area.
    pub crossings: f64,
}

impl Sample {
    /// `triangles`: those of the field.
    pub fn new(field: &Field, triangles: &[Triangle], threads: NonZeroUsize) -> Self {
        let (low, size) = (field.bounds().low, field.bounds().size());
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
            has_overlaps: count(&|point| windings[point] > TWICE) > 0,
            has_thin_overlaps: has_thin_overlaps(field, triangles, threads),
            crossings: 0.5 * crossed as f64 * side * side,
        }
    }
}

/// Whether some triangles have another part right under them: where parts overlap, some of each lie in the other, however thin the
/// overlap is.
fn has_thin_overlaps(field: &Field, triangles: &[Triangle], threads: NonZeroUsize) -> bool {
    let under = UNDER * field.bounds().size().max_element();
    let step = triangles.len().div_ceil(TRIANGLES);
    let windings = parallel::collect(triangles.len().div_ceil(step), threads, |index| {
        let triangle = &triangles[step * index];
        let middle = triangle.iter().sum::<DVec3>() / 3.0;
        field.winding(middle - under * area_vector(triangle).normalize_or_zero())
    });
    windings.into_iter().any(|winding| winding > TWICE)
}
