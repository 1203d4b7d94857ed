//! The strips of a surface unrolled and laid side by side.

use glam::DVec2;
use heatwalk_base::sort;

use crate::error::{MAX_DEFECT, NotDevelopable, Result};
use crate::field::Field;
use crate::levels::Levels;
use crate::strips::Strips;
use crate::unroll::pieces;

/// Space between shapes, in shares of the width of a sheet.
const GAP: f64 = 0.02;

/// Spacings that are tried for one by which all strips are flat.
const SPACINGS_TRIED: usize = 4;

/// The plane shape of a piece of a strip.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// Which strip it is a piece of.
    pub strip: usize,
    /// Closed loops, in the field's unit: counter-clockwise around the shape, clockwise around its holes. Where a ring was cut
    /// open, since it does not close in the plane, its loop goes along both sides of the cut. A ring that winds by more than a
    /// turn overlaps itself.
    pub loops: Vec<Vec<DVec2>>,
}

/// Plane shapes side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// By strips, each where it lies on the sheet; X points right and Y up.
    pub planes: Vec<Plane>,
    /// Width and height; the sheet begins at 0, 0.
    pub size: DVec2,
    /// The pieces that have no plane shape.
    pub left_out: Vec<NotDevelopable>,
}

impl Sheet {
    /// Unrolls the pieces of all strips of a field but those that are curved.
    ///
    /// # Errors
    /// [`Error::NotDevelopable`](crate::Error::NotDevelopable) for the first one where all are.
    pub fn unroll(field: &Field, strips: &Strips) -> Result<Self> {
        let (mut planes, mut left_out) = (Vec::new(), Vec::new());
        for strip in 0..strips.ranges.len() {
            for piece in pieces(field, strips, strip) {
                match piece.unroll() {
                    Ok(loops) => planes.push(Plane { strip, loops }),
                    Err(curved) => left_out.push(curved),
                }
            }
        }
        match left_out.first() {
            Some(&curved) if planes.is_empty() => Err(curved.into()),
            _ => Ok(Self { left_out, ..Self::arranged(planes) }),
        }
    }

    /// The strips that have pieces without a plane shape, ascending.
    pub fn strips_left_out(&self) -> Vec<usize> {
        let mut strips: Vec<usize> = self.left_out.iter().map(|curved| curved.strip).collect();
        strips.dedup();
        strips
    }

    /// A smaller spacing by which no strip is left out; none where one vertex is curved too much for any, or where none was
    /// found soon.
    pub fn flat_spacing(&self, field: &Field, strips: &Strips) -> Option<f64> {
        if self.left_out.iter().any(NotDevelopable::is_by_one_vertex) {
            return None;
        }
        let width = |strip: usize| {
            let [from, to] = strips.bounds(strip);
            to.unwrap_or(field.largest()) - from.unwrap_or(0.0)
        };
        // As if the surface were curved evenly.
        let wanted = self.left_out.iter().map(|curved| width(curved.strip) * MAX_DEFECT / curved.total);
        let mut spacing = wanted.reduce(f64::min)?;
        for _ in 0..SPACINGS_TRIED {
            spacing = round_below(spacing);
            let strips = Strips::cut(field, &Levels::spaced(spacing, field.largest()).ok()?).ok()?;
            if Self::unroll(field, &strips).is_ok_and(|sheet| sheet.left_out.is_empty()) {
                return Some(spacing);
            }
            spacing *= 0.6;
        }
        None
    }

    /// Lays shapes in rows about as wide as all rows are high, the highest first.
    fn arranged(mut planes: Vec<Plane>) -> Self {
        let sizes: Vec<DVec2> = planes.iter_mut().map(Plane::move_to_origin).collect();
        let area: f64 = sizes.iter().map(|size| size.x * size.y).sum();
        let widest = sizes.iter().map(|size| size.x).fold(0.0, f64::max);
        let width = area.sqrt().max(widest);
        let gap = GAP * width;
        let mut order: Vec<usize> = (0..planes.len()).collect();
        sort::sort_by(&mut order, |&a, &b| sizes[b].y.total_cmp(&sizes[a].y));
        let (mut at, mut row, mut size) = (DVec2::splat(gap), 0.0_f64, DVec2::ZERO);
        for index in order {
            if at.x > gap && at.x + sizes[index].x > width + gap {
                at = DVec2::new(gap, at.y + row + gap);
                row = 0.0;
            }
            planes[index].loops.as_mut_slice().iter_mut().flatten().for_each(|point| *point += at);
            row = row.max(sizes[index].y);
            size = size.max(at + sizes[index] + gap);
            at.x += sizes[index].x + gap;
        }
        Self { planes, size, left_out: Vec::new() }
    }
}

/// The largest of 1, 2 and 5 times powers of ten that is not above a positive number.
fn round_below(number: f64) -> f64 {
    let power = 10_f64.powf(number.log10().floor());
    [5.0, 2.0].into_iter().map(|digit| digit * power).find(|&round| round <= number).unwrap_or(power)
}

impl Plane {
    /// Moves the shape so that the box around it begins at 0, 0; the size of the box.
    fn move_to_origin(&mut self) -> DVec2 {
        let points = || self.loops.iter().flatten().copied();
        let low = points().reduce(DVec2::min).unwrap_or_default();
        let high = points().reduce(DVec2::max).unwrap_or_default();
        self.loops.iter_mut().flatten().for_each(|point| *point -= low);
        high - low
    }
}
