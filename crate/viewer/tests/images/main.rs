//! Pictures that the renderer draws without a canvas, against reference images.
//!
//! They need a Vulkan device; the processor's own is taken where there is one, so that every machine draws the same. Where
//! there is none the tests are ignored and say so, unless `HEATWALK_REQUIRE_GPU=1` makes that a failure.
//! `WRITE_REFERENCES=1` writes the reference images anew.

mod halves;
mod image;
mod inside;
mod materials;
mod patches;
mod scenes;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use glam::Vec2;
use heatwalk_viewer::{Context, Error, Hierarchy, MeshArrays, Renderer};
use libtest_mimic::{Arguments, Failed, Trial};

use self::image::Image;
use self::scenes::SCENES;

const NO_DEVICE: &str = "there is no software Vulkan device. On Debian, mesa-vulkan-drivers has one.";

type Test = fn(&Context) -> Result<(), Failed>;

fn main() -> ExitCode {
    // Wherever pictures are drawn by the processor, one at a time is fastest.
    let arguments = Arguments { test_threads: Some(1), ..Arguments::from_args() };
    let device = pollster::block_on(Context::offscreen(true)).map_err(|_| NO_DEVICE);
    let is_required = std::env::var("HEATWALK_REQUIRE_GPU").is_ok_and(|value| value == "1");
    let is_ignored = device.is_err() && !is_required;
    if is_ignored {
        println!("The image tests are ignored: {NO_DEVICE}");
    }
    let pictures = SCENES.iter().map(|scene| {
        let device = device.clone();
        Trial::test(scene.name, move || {
            compare_with_reference(scene.name, &picture(&mut shown(&device?, scene.show)?)?)
        })
    });
    let others: [(_, Test); 18] = [
        ("a_refused_mesh_leaves_the_picture_as_it_is", a_refused_mesh_leaves_the_picture_as_it_is),
        ("the_unit_of_a_field_does_not_matter", the_unit_of_a_field_does_not_matter),
        ("balls_of_pins_are_met_where_they_are_seen", balls_of_pins_are_met_where_they_are_seen),
        ("a_leaning_normal_map_leans_the_surface", materials::a_leaning_normal_map_leans_the_surface),
        ("panes_are_blended_from_back_to_front", materials::panes_are_blended_from_back_to_front),
        ("lights_of_a_file_follow_their_laws", materials::lights_of_a_file_follow_their_laws),
        ("unlit_colors_are_those_of_the_file", materials::unlit_colors_are_those_of_the_file),
        ("patches_lie_on_the_surface_and_let_it_through", patches::patches_lie_on_the_surface_and_let_it_through),
        ("each_half_has_its_field", halves::each_half_has_its_field),
        ("a_refused_second_field_changes_nothing", halves::a_refused_second_field_changes_nothing),
        ("picks_go_through_the_cut", inside::picks_go_through_the_cut),
        ("what_was_inside_goes", inside::what_was_inside_goes),
        ("each_half_has_its_inside", inside::each_half_has_its_inside),
        ("a_section_follows_the_field", inside::a_section_follows_the_field),
        ("refused_insides_leave_the_picture_as_it_is", inside::refused_insides_leave_the_picture_as_it_is),
        ("edges_are_cut_as_the_surface_is", inside::edges_are_cut_as_the_surface_is),
        ("arrows_of_the_surface_go_with_it", inside::arrows_of_the_surface_go_with_it),
        ("what_is_cut_away_casts_no_shadow", inside::what_is_cut_away_casts_no_shadow),
    ];
    let others = others.map(|(name, test)| {
        let device = device.clone();
        Trial::test(name, move || test(&device?))
    });
    let trials = pictures.chain(others).map(|trial| trial.with_ignored_flag(is_ignored)).collect();
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// A renderer of pictures of the images' size that shows a scene.
fn shown(device: &Context, show: fn(&mut Renderer) -> Result<(), Error>) -> Result<Renderer, Failed> {
    let mut renderer = Renderer::new(device.clone(), None)?;
    renderer.resize(image::WIDTH, image::HEIGHT, 1.0);
    show(&mut renderer)?;
    Ok(renderer)
}

fn picture(renderer: &mut Renderer) -> Result<Image, Failed> {
    let capture = renderer.capture(1.0, false)?;
    while !capture.is_ready() {
        std::thread::yield_now();
    }
    if let Some(error) = renderer.take_error() {
        return Err(error.into());
    }
    Ok(Image::of(&capture.into_pixels()))
}

fn reference(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/images/reference").join(format!("{name}.png"))
}

fn compare_with_reference(name: &str, drawn: &Image) -> Result<(), Failed> {
    let path = reference(name);
    if std::env::var("WRITE_REFERENCES").is_ok_and(|value| value == "1") {
        drawn.write(&path)?;
    }
    let difference = drawn.difference(&Image::read(&path)?);
    if difference.is_small() {
        return Ok(());
    }
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    drawn.write(&kept)?;
    Err(format!("{difference} from {}; what was drawn is in {}", path.display(), kept.display()).into())
}

fn a_refused_mesh_leaves_the_picture_as_it_is(device: &Context) -> Result<(), Failed> {
    let scene = SCENES.iter().find(|scene| scene.name == "pins_path_and_walker").expect("a scene with everything");
    let mut renderer = shown(device, scene.show)?;
    let before = picture(&mut renderer)?;
    for spoil in [f32::NAN, f32::INFINITY, 1e25] {
        let mut arrays = scenes::sphere().arrays();
        arrays.positions[7].y = spoil;
        let refused = renderer.set_surface(arrays, None);
        assert!(refused.is_err(), "a coordinate of {spoil}");
    }
    let mut arrays = scenes::sphere().arrays();
    arrays.triangles[3][1] = u32::MAX;
    assert!(renderer.set_surface(arrays, None).is_err(), "a vertex that is not there");
    let arrays = MeshArrays { hierarchy: Hierarchy::default(), ..scenes::sphere().arrays() };
    assert!(renderer.set_surface(arrays, None).is_err(), "a hierarchy of other triangles");
    assert_eq!(picture(&mut renderer)?.difference(&before).pixels, 0);
    Ok(())
}

/// The same stripes at any size that a single-precision number has.
fn the_unit_of_a_field_does_not_matter(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |_| Ok(()))?;
    let mut drawn = |unit| {
        scenes::stripes_in_unit(&mut renderer, unit)?;
        picture(&mut renderer)
    };
    let usual = drawn(1.0)?;
    for unit in [1e-30, 1e30] {
        let difference = drawn(unit)?.difference(&usual);
        assert!(difference.is_small(), "{difference} at {unit:e}");
    }
    Ok(())
}

/// Of three pins the third is behind the surface, and one is before another.
fn balls_of_pins_are_met_where_they_are_seen(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, scenes::alone)?;
    let without = picture(&mut renderer)?;
    let pins = scenes::pins(&mut renderer)?;
    let with = picture(&mut renderer)?;
    let centers = pins.map(|pin| renderer.project(1.12 * pin).expect("before the eye").truncate());
    let mut seen = [0; 3];
    let mut elsewhere = 0;
    for (y, x) in (0..image::HEIGHT).flat_map(|y| (0..image::WIDTH).map(move |x| (y, x))) {
        let [red, green, blue] = with.pixel(x, y).map(u32::from);
        let is_ball = with.pixel(x, y) != without.pixel(x, y) && green > 60 && green > 2 * blue.max(red / 2);
        let pixel = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
        let met = renderer.pick_pin(pixel, 0.0);
        if let Some(index) = met {
            seen[index] += 1;
            assert!(pixel.distance(centers[index]) < 20.0, "the pin that is there");
        }
        elsewhere += u32::from(met.is_some() != is_ball);
    }
    assert!(seen[0] > 40 && seen[1] > 40 && seen[2] == 0, "{seen:?}");
    assert!(5 * elsewhere < seen[0] + seen[1], "{elsewhere} of {seen:?} along rims");
    let [x, y] = centers[0].to_array();
    let beside = (0..image::WIDTH).map(|right| Vec2::new(x + right as f32, y));
    let beside = beside.take_while(|&pixel| renderer.pick_pin(pixel, 0.0) == Some(0)).last().expect("the ball");
    assert_eq!(renderer.pick_pin(beside + 4.0 * Vec2::X, 0.0), None);
    assert_eq!(renderer.pick_pin(beside + 4.0 * Vec2::X, 6.0), Some(0));
    Ok(())
}
