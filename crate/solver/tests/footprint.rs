//! The memory that a mesh is said to take is what it takes.

#![cfg(not(target_arch = "wasm32"))]

use std::num::NonZeroU16;
use std::sync::{Arc, Mutex};

use heatwalk::exact::ExactGeometry;
use heatwalk::{Propagation, PropagationOptions, Soup, Surface, VertexId, Windows, footprint};
use heatwalk_shapes as shapes;
use peak_alloc::PeakAlloc;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Tests that run at once would count each other's memory.
static ALONE: Mutex<()> = Mutex::new(());

/// The most bytes in use at once from a soup, which goes as soon as it is built, to the first field and its directions.
fn used(soup: Soup, windows: u16) -> usize {
    let before = ALLOCATOR.current_usage();
    ALLOCATOR.reset_peak_usage();
    let surface = Surface::build(&soup).expect("a surface");
    drop(soup);
    let geometry = Arc::new(ExactGeometry::new(surface));
    let windows = Windows::AtMost(NonZeroU16::new(windows).expect("a window"));
    let options = PropagationOptions { windows, ..PropagationOptions::default() };
    let mut propagation = Propagation::new(Arc::clone(&geometry), &[VertexId(0)], options).expect("a source");
    propagation.advance(f64::INFINITY, usize::MAX).expect("room for windows");
    let distance = propagation.distance();
    distance.directions(geometry.surface()).expect("its own surface");
    ALLOCATOR.peak_usage() - before
}

/// Each triangle with vertices of its own, as in an STL file.
fn loose(soup: &Soup) -> Soup {
    let positions = soup.triangles.iter().flatten().map(|&vertex| soup.positions[vertex as usize]).collect();
    let triangles = (0..soup.triangles.len() as u32).map(|triangle| [0, 1, 2].map(|k| 3 * triangle + k)).collect();
    Soup::single("loose", positions, triangles)
}

#[test]
fn the_memory_told_is_the_memory_taken() {
    let _alone = ALONE.lock().expect("no test has failed");
    let sphere = || shapes::icosphere(6);
    let shapes = [
        ("sphere", sphere()),
        ("loose sphere", loose(&sphere())),
        ("hemisphere", shapes::hemisphere(120).select(&[0]).expect("a part")),
        ("maze", shapes::by_name("maze").expect("a shape").soup),
    ];
    for (name, soup) in shapes {
        for windows in [1, 2, 8] {
            let told = footprint(soup.positions.len(), soup.triangles.len(), windows);
            let share = told as f64 / used(soup.clone(), windows) as f64;
            // How many windows the exact search has in lists depends on the shape, and lists grow by doubling.
            assert!((0.85..1.25).contains(&share), "{name}, {windows} windows: {share}");
        }
    }
}
