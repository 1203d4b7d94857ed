//! Distances and paths across contacts that are found, against exact distances on surfaces that were not cut.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::num::NonZeroU16;
use std::sync::Arc;

use crate::common::pieces::{CHANGES, Errors, Pieces, wholes};
use crate::common::truth::Random;
use glam::DVec3;
use heatwalk::exact::{ExactGeometry, Wavefront, shortest_path};
use heatwalk::{
    BridgeRule, Bridges, Distance, DistanceOptions, DistanceSolver, Element, ExactSearch, Method, Path, Place,
    Propagation, PropagationOptions, Soup, Surface, VertexId, WeldRule, Windows, descend, go_on, straighten,
};
use heatwalk_shapes as shapes;

/// What exact distances over portals may be off, in per cent.
const MOST_MEAN: f64 = 0.3;
const MOST_HIGH: f64 = 2.5;

/// How much longer any of them may be, in mean edges, whatever share of a short distance that is: portals are a mean edge apart,
/// so that a path which crosses beside them, or two contacts in turn, goes around by a few.
const MOST_EXCESS: f64 = 2.5;

/// Percentage points by which heat on the pieces may be farther off than on the whole.
const MOST_OF_HEAT: f64 = 0.3;

/// Share of the scene's diagonal over which [`BridgeRule::Automatic`] joins components at most.
const WIDEST_GAP: f64 = 3e-3;

fn distance(solver: &mut DistanceSolver, source: VertexId, method: Method) -> Distance {
    solver.distance(&[source], &DistanceOptions::by(method), &mut go_on).expect("a distance").distance
}

#[test]
fn a_surface_in_pieces_has_nearly_the_distances_of_the_whole() {
    for whole in wholes() {
        let mut solver = DistanceSolver::new(Arc::clone(&whole.surface));
        let exact = distance(&mut solver, whole.source, Method::Exact).values;
        let by_heat = distance(&mut solver, whole.source, Method::Heat).values;
        let of_whole = Errors::between(&by_heat, &exact);
        for (change, how) in CHANGES {
            let pieces = Pieces::new(&whole, how, WeldRule::Exact);
            let bridges = Bridges::find(&pieces.surface, BridgeRule::Automatic);
            let mut solver = DistanceSolver::new(Arc::clone(&pieces.surface)).bridged(bridges);
            let expected = pieces.copied(&exact);
            let [by_exact, by_heat] =
                [Method::Exact, Method::Heat].map(|method| distance(&mut solver, pieces.source, method).values);
            let [exact, heat] = [&by_exact, &by_heat].map(|values| Errors::between(values, &expected));
            let excesses = by_exact.iter().zip(&expected).map(|(value, expected)| value - expected);
            let excess = excesses.fold(0.0, f64::max) / whole.surface.mean_edge();
            let name = format!("{}, {change}: {exact:?}, {heat:?} for {of_whole:?}", whole.name);
            assert!(exact.mean <= MOST_MEAN && exact.high <= MOST_HIGH, "{name}");
            assert!(excess <= MOST_EXCESS, "{excess} edges, {name}");
            assert!(heat.mean <= of_whole.mean + MOST_OF_HEAT, "{name}");
        }
    }
}

#[test]
fn exact_distances_of_parts_are_nowhere_longer_than_by_a_few_windows() {
    let surface = Arc::new(Surface::build(&shapes::by_name("robot").expect("a shape").soup).expect("a surface"));
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    let portals = Arc::new(ExactGeometry::new(Arc::clone(&surface)).bridged(&bridges));
    for source in [0, 1000] {
        let source = [Place::Vertex(VertexId(source))];
        let mut exact = Wavefront::new(Arc::clone(&portals), &source).expect("a source");
        assert!(exact.advance(f64::INFINITY, usize::MAX).expect("room for windows"));
        // None of them by the exact search, which is what is tested.
        let windows = Windows::AtMost(NonZeroU16::new(8).expect("some"));
        let options = PropagationOptions { windows, exact: ExactSearch::AtMost(0), ..PropagationOptions::default() };
        let mut propagation = Propagation::new(Arc::clone(&portals), &source, options).expect("a source");
        assert!(propagation.advance(f64::INFINITY, usize::MAX).expect("room for windows"));
        for (&exact, &most) in exact.values().iter().zip(propagation.values()) {
            assert!(exact <= most * (1.0 + 1e-9), "{exact} for {most}");
        }
    }
}

/// Parts that pierce each other, lie on each other, and are apart by a little.
fn assembly() -> Arc<Surface> {
    let parts = [
        (shapes::icosphere(3), 1.0, [0.0, 0.0, 0.0]),
        (shapes::torus(1.0, 0.3, 40, 16), 1.0, [1.2, 0.0, 0.1]),
        (shapes::icosphere(2), 0.4, [2.2, 0.0, 0.3]),
        (shapes::cylinder(2.0, 24, 12), 0.5, [-1.1, 0.2, 0.0]),
        (shapes::uv_sphere(24, 16), 0.5, [0.0, 1.505, 0.0]),
    ];
    let mut soup = Soup::default();
    for (part, scale, place) in parts {
        let placed = part.positions.iter().map(|&position| scale * position + DVec3::from_array(place));
        soup.add(placed, &part.triangles);
        soup.end_part("part");
    }
    Arc::new(Surface::build(&soup).expect("a surface"))
}

#[test]
fn paths_through_an_assembly_arrive_and_hop_no_farther_than_allowed() {
    const SOURCES: usize = 20;
    const STARTS: usize = 50;
    let surface = assembly();
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    assert_eq!((surface.report().components, bridges.group_count()), (5, 1));
    let most = WIDEST_GAP * 2.0 * surface.bounding_radius();
    let mut solver = DistanceSolver::new(Arc::clone(&surface)).bridged(bridges);
    let mut random = Random::new(7);
    let mut any = || VertexId::from_index(random.below(surface.vertex_count()));
    for _ in 0..SOURCES {
        let source = any();
        let [exact, propagated, heat] =
            [Method::Exact, Method::Propagation, Method::Heat].map(|method| distance(&mut solver, source, method));
        for _ in 0..STARTS {
            let from = any();
            let least = exact.values[from] * (1.0 - 1e-9);
            let descents = [&exact, &propagated, &heat].map(|distance| descend(&surface, distance, from));
            for descent in descents {
                let descent = descent.expect("a path");
                let straight = straighten(&surface, &descent).expect("a path");
                for path in [descent, straight] {
                    check(&surface, &path, source, most);
                    assert!(path.length() >= least, "{} for {least}", path.length());
                }
            }
        }
        let from = any();
        let path = shortest_path(solver.exact_geometry(), from, &[source]).expect("a path");
        check(&surface, &path, source, most);
        assert!((path.length() - exact.values[from]).abs() <= 1e-9 * path.length());
    }
}

/// That a path ends at the source and jumps no farther than this from one component to another.
fn check(surface: &Surface, path: &Path, source: VertexId, most: f64) {
    assert_eq!(path.points.last().map(|point| point.position), Some(surface.position(source)));
    for pair in path.points.windows(2) {
        let [from, to] = [&pair[0], &pair[1]];
        if from.location.component(surface) != to.location.component(surface) {
            let hop = from.position.distance(to.position);
            assert!(hop <= most, "a hop of {hop}");
        }
    }
}
