#![cfg(not(target_arch = "wasm32"))]

use super::super::samples::torn_terrain;
use super::*;

#[test]
fn the_number_of_threads_makes_no_difference() {
    let soup = torn_terrain(150, 37);
    let surface = Arc::new(Surface::build(&soup).expect("a surface"));
    let one = ExactGeometry::new(Arc::clone(&surface));
    for bend in [Bend::Never, Bend::Saddle, Bend::Reflex, Bend::Anywhere] {
        assert!(one.bends.contains(&bend), "{bend:?}");
    }
    let numbers = |geometry: &ExactGeometry| -> Vec<[u64; 5]> {
        let sides = geometry.frames.iter().flat_map(|frame| frame.0);
        sides
            .map(|Side { length, cos, sin, vertex, next_on_edge }| {
                [length.to_bits(), cos.to_bits(), sin.to_bits(), vertex.into(), next_on_edge.into()]
            })
            .collect()
    };
    for threads in [2, 3, 8] {
        let other = ExactGeometry::on_threads(Arc::clone(&surface), NonZeroUsize::new(threads).expect("a thread"));
        assert!(numbers(&one) == numbers(&other), "{threads} threads");
        assert_eq!(one.bends, other.bends, "{threads} threads");
    }
}
