//! Two fields of a sphere side by side.

use std::f32::consts::PI;

use heatwalk_viewer::{Context, Error, Insets, MeshArrays, Renderer};
use libtest_mimic::Failed;

use crate::image::{HEIGHT, Image, WIDTH};
use crate::scenes::{self, BANDS};
use crate::{picture, shown};

/// Distance from the north pole, a multiple of it, and its direction from nowhere.
fn fill(arrays: &MeshArrays, times: f32) -> impl FnOnce(&mut [f32], &mut [i8]) + use<> {
    let polar: Vec<f32> = arrays.positions.iter().map(|place| times * place.y.clamp(-1.0, 1.0).acos()).collect();
    move |values, directions| {
        values.copy_from_slice(&polar);
        directions.fill(0);
    }
}

fn show(renderer: &mut Renderer, times: f32) -> Result<(), Error> {
    let arrays = scenes::sphere().arrays();
    let (count, fill) = (arrays.positions.len(), fill(&arrays, times));
    scenes::show_mesh(renderer, arrays, BANDS)?;
    renderer.set_field(count, f64::from(2.0 * PI), false, fill)
}

fn show_beside(renderer: &mut Renderer, times: f32) -> Result<(), Error> {
    let arrays = scenes::sphere().arrays();
    renderer.set_other_field(arrays.positions.len(), false, fill(&arrays, times))
}

/// Columns that are not as in one picture left of a column, and as in another one from it on.
pub fn columns_apart(drawn: &Image, left: &Image, right: &Image, middle: u32) -> Vec<u32> {
    let expected = |x: u32| if x < middle { left } else { right };
    let is_apart = |&x: &u32| (0..HEIGHT).any(|y| drawn.pixel(x, y) != expected(x).pixel(x, y));
    (0..WIDTH).filter(is_apart).collect()
}

fn assert_joined(drawn: &Image, left: &Image, right: &Image, middle: u32) {
    let apart = columns_apart(drawn, left, right, middle);
    assert!(apart.is_empty(), "columns {apart:?} with the split at {middle}");
}

/// Each half is that of the picture of its field alone, wherever the split is.
pub fn each_half_has_its_field(device: &Context) -> Result<(), Failed> {
    let one = picture(&mut shown(device, |renderer| show(renderer, 1.0))?)?;
    let other = picture(&mut shown(device, |renderer| show(renderer, 2.0))?)?;
    assert_ne!(one.difference(&other).pixels, 0);
    let mut renderer = shown(device, |renderer| {
        show(renderer, 1.0)?;
        show_beside(renderer, 2.0)
    })?;
    for (split, middle) in [(0.0, WIDTH / 2), (-0.25, WIDTH / 4), (-0.5, 0), (0.5, WIDTH), (-3.0, 0)] {
        renderer.set_split(split);
        assert_joined(&picture(&mut renderer)?, &one, &other, middle);
    }
    // Insets move the middle on the canvas; a picture has none.
    renderer.set_insets(Insets { right: 40.0, ..Insets::default() });
    renderer.set_split(0.0);
    assert_joined(&picture(&mut renderer)?, &one, &other, WIDTH / 2);
    renderer.set_insets(Insets::default());
    renderer.set_other_field(0, false, |_, _| {})?;
    assert_joined(&picture(&mut renderer)?, &one, &other, WIDTH);
    Ok(())
}

/// What does not fit is refused, and another surface has no second field.
pub fn a_refused_second_field_changes_nothing(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |renderer| {
        show(renderer, 1.0)?;
        show_beside(renderer, 2.0)
    })?;
    let before = picture(&mut renderer)?;
    assert!(renderer.set_other_field(7, false, |_, _| {}).is_err(), "too few");
    assert!(renderer.set_other_field(7, true, |_, _| {}).is_err(), "corners of a surface without tints");
    assert_eq!(picture(&mut renderer)?.difference(&before).pixels, 0);
    show(&mut renderer, 1.0)?;
    let alone = picture(&mut shown(device, |renderer| show(renderer, 1.0))?)?;
    assert_eq!(picture(&mut renderer)?.difference(&alone).pixels, 0);
    Ok(())
}
