//! Distances on a device against exact ones.
//!
//! They need a Vulkan device; the processor's own is taken where there is one. Where there is none the tests are ignored and say so,
//! unless `HEATWALK_REQUIRE_GPU=1` makes that a failure. Those of large meshes are ignored unless HEATWALK_MESHES names their folder.

mod device;
mod errors;
mod large;
mod meshes;
mod sources;

use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};

use self::device::Device;

type Test = fn(&Device) -> Result<(), Failed>;

/// The tests that this machine has what it takes for; `name` is that of the function.
macro_rules! tests {
    ($($module:ident::$name:ident),* $(,)?) => {
        [$((stringify!($name), $module::$name as Test)),*]
    };
}

fn main() -> ExitCode {
    // A device that the processor imitates has all of it.
    let arguments = Arguments { test_threads: Some(1), ..Arguments::from_args() };
    let device = device::open();
    let is_required = std::env::var("HEATWALK_REQUIRE_GPU").is_ok_and(|value| value == "1");
    let is_ignored = device.is_err() && !is_required;
    if is_ignored {
        println!("The tests of distances on a device are ignored: {}", device::NONE);
    }
    let small = tests![
        meshes::a_plane_is_straight,
        meshes::large_patches_give_the_same,
        meshes::curved_surfaces_are_near_to_the_exact_distance,
        meshes::paths_bend_at_saddles_and_at_the_boundary,
        meshes::components_without_a_source_are_not_reached,
        meshes::flipped_triangles_keep_the_metric,
        meshes::many_patches_around_one_vertex,
        meshes::patches_that_wait_keep_what_has_come,
        sources::a_source_in_a_face_or_on_an_edge,
        sources::the_nearest_of_several_sources,
        sources::a_later_source_counts_from_its_initial_distance,
        sources::an_answer_does_not_depend_on_the_one_before,
        sources::the_buffer_has_the_order_of_the_caller,
        errors::meshes_that_do_not_fit_are_refused,
        errors::orders_that_are_none_are_refused,
        errors::a_front_that_goes_on_for_long_is_given_up,
        errors::sources_that_are_not_there_are_refused,
    ];
    let large = tests![large::errors_of_large_meshes_are_small];
    let are_there = std::env::var_os("HEATWALK_MESHES").is_some();
    let trial = |(name, test): (&'static str, Test), is_ignored: bool| {
        let device = device.clone();
        Trial::test(name, move || test(&device?)).with_ignored_flag(is_ignored)
    };
    let small = small.map(|test| trial(test, is_ignored));
    let large = large.map(|test| trial(test, is_ignored || !are_there));
    libtest_mimic::run(&arguments, small.into_iter().chain(large).collect()).exit_code()
}
