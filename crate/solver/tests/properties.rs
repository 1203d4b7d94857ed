//! What must hold on any surface and for any sources, tried on random ones: holes, slivers, seams, fins, several
//! pieces. The same code runs on wasm32 in the other tests; random numbers there would need the browser's.
#![cfg(not(target_arch = "wasm32"))]

use crate::common;

use std::sync::Arc;

use crate::common::shortness::{check_valid, largest_kink, sharpest_turn};
use crate::common::{Damage, band, book, damaged, square};
use glam::DVec3;
use heatwalk::exact::{exact_distance, shortest_path};
use heatwalk::operator::Operators;
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    Boundary, Error, ExactRadius, FaceId, HeatSolver, MultiSource, Operator, Parameters, Place, Soup, Source, Surface,
    TimeStep, VertexId, descend, go_on, straighten,
};
use heatwalk_scene::{Crowd, DrawTransform};
use heatwalk_shapes as shapes;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// What sums along some hundred pieces of a path lose, as a share of the largest distance: triangles here are as thin as
/// a millionth of their length, which costs unfolding six of sixteen digits.
const ROUNDING: f64 = 1e-9;

/// A base shape bent, squeezed, torn and doubled.
fn any_soup() -> impl Strategy<Value = Soup> {
    let base = prop_oneof![
        Just(shapes::icosphere(2)),
        Just(shapes::torus(2.0, 0.7, 16, 9)),
        Just(square(5)),
        Just(band(12, 0)),
        Just(band(13, 1)),
        Just(book(3, 3)),
    ];
    let damage = (
        any::<u64>(),
        0.0..0.3_f64,
        prop_oneof![Just(1.0), Just(1e-1), Just(1e-3), Just(1e-6)],
        0.0..0.3_f64,
        any::<bool>(),
        any::<bool>(),
    );
    (base, damage).prop_map(|(soup, (seed, jitter, squeeze, tear, doubled, unwelded))| {
        let soup = damaged(soup, seed, Damage { jitter, squeeze, tear });
        repeated(soup, doubled, unwelded)
    })
}

/// A soup beside a copy of it, and with a vertex for each corner.
fn repeated(mut soup: Soup, doubled: bool, unwelded: bool) -> Soup {
    if doubled {
        let count = soup.positions.len() as u32;
        let copies: Vec<DVec3> = soup.positions.iter().map(|&position| position + DVec3::Z * 10.0).collect();
        soup.positions.extend(copies);
        let copies: Vec<[u32; 3]> =
            soup.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + count)).collect();
        soup.triangles.extend(copies);
    }
    if unwelded {
        let positions = soup.triangles.iter().flatten().map(|&vertex| soup.positions[vertex as usize]).collect();
        let triangles = (0..soup.triangles.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        return common::soup(positions, triangles);
    }
    common::soup(soup.positions, soup.triangles)
}

/// Places by random numbers: vertices and points of faces, one to five, some with a starting value.
fn any_places() -> impl Strategy<Value = Vec<(u32, bool, [f64; 2], f64)>> {
    let start = prop_oneof![3 => Just(0.0), 1 => 0.0..2.0_f64];
    prop::collection::vec((any::<u32>(), any::<bool>(), [0.0..1.0_f64, 0.0..1.0_f64], start), 1..6)
}

fn sources(surface: &Surface, places: &[(u32, bool, [f64; 2], f64)]) -> Vec<Source> {
    let source = |&(number, is_vertex, [a, b], initial_distance): &(u32, bool, [f64; 2], f64)| {
        let point = if is_vertex {
            Place::Vertex(VertexId(number % surface.vertex_count() as u32))
        } else {
            let weights = [a, (1.0 - a) * b, (1.0 - a) * (1.0 - b)];
            Place::Face { face: FaceId(number % surface.face_count() as u32), weights }
        };
        surface.source(point, initial_distance).expect("a valid source")
    };
    places.iter().map(source).collect()
}

fn any_parameters() -> impl Strategy<Value = Parameters> {
    let operator =
        prop_oneof![3 => Just(Operator::Delaunay), 1 => Just(Operator::Plain), 1 => Just(Operator::Relocate)];
    let time_step =
        prop_oneof![Just(TimeStep::Automatic), (-2.0..2.0_f64).prop_map(|log| TimeStep::Factor(10_f64.powf(log)))];
    let boundary = prop_oneof![Just(Boundary::Neumann), Just(Boundary::Dirichlet), Just(Boundary::Average)];
    let sources = prop_oneof![3 => Just(MultiSource::Exact), 1 => Just(MultiSource::Summed)];
    let exact_radius = prop_oneof![
        Just(ExactRadius::Automatic),
        (0.0..6.0_f64).prop_map(ExactRadius::Edges),
        Just(ExactRadius::Edges(0.0))
    ];
    (operator, time_step, boundary, sources, exact_radius).prop_map(
        |(operator, time_step, boundary, sources, exact_radius)| Parameters {
            operator,
            time_step,
            boundary,
            sources,
            exact_radius,
            ..Parameters::default()
        },
    )
}

fn solver(surface: &Arc<Surface>, parameters: Parameters) -> HeatSolver {
    HeatSolver::new(Arc::clone(surface), parameters, &mut go_on).expect("factors")
}

/// The same random cases at every run.
fn check<S: Strategy>(cases: u32, strategy: &S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    if let Err(failure) = runner.run(strategy, test) {
        panic!("{failure}");
    }
}

/// Soups of which nothing is left are not what these tests are about.
fn surface_of(soup: &Soup) -> Result<Arc<Surface>, TestCaseError> {
    match Surface::build(soup) {
        Ok(surface) => Ok(Arc::new(surface)),
        Err(SurfaceError::Empty { .. }) => Err(TestCaseError::reject("no triangle")),
        Err(error) => Err(TestCaseError::fail(error.to_string())),
    }
}

#[test]
fn distances_are_distances() {
    check(200, &(any_soup(), any_places(), any_parameters()), |(soup, places, parameters)| {
        let surface = surface_of(&soup)?;
        let sources = sources(&surface, &places);
        let solver = match HeatSolver::new(Arc::clone(&surface), parameters, &mut go_on) {
            Ok(solver) => solver,
            // Weights of both signs and of any size, as plain slivers have them, may defeat rounding; it is said.
            Err(Error::NotPositiveDefinite { .. }) if parameters.operator != Operator::Delaunay => return Ok(()),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        };
        let distance = solver.distance(&sources).expect("valid sources");
        let mut is_reached = vec![false; surface.report().components];
        for source in &sources {
            is_reached[source.place().component(&surface) as usize] = true;
        }
        for (value, &component) in distance.values.iter().zip(surface.components()) {
            if is_reached[component as usize] {
                prop_assert!(value.is_finite() && *value >= 0.0, "{value}");
            } else {
                prop_assert_eq!(*value, f64::INFINITY);
            }
        }
        prop_assert!(!distance.sources.is_empty());
        prop_assert!(distance.gradients(&surface).expect("its surface").iter().all(|gradient| gradient.is_finite()));
        prop_assert!(distance.tangents(&surface).expect("its surface").iter().all(|tangent| tangent.is_finite()));
        if parameters.sources == MultiSource::Exact {
            for source in &sources {
                if let Place::Vertex(vertex) = source.place() {
                    prop_assert!(distance.values[vertex] <= source.initial_distance());
                }
            }
        }
        Ok(())
    });
}

#[test]
fn delaunay_weights_are_never_negative() {
    check(200, &(any_soup(), any_places()), |(soup, places)| {
        let surface = surface_of(&soup)?;
        let laplacian = Operators::new(&surface, Operator::Delaunay).laplacian().clone();
        for column in 0..laplacian.size() {
            for entry in laplacian.column(column).skip(1) {
                // The tolerance of the flips.
                prop_assert!(laplacian.stiffness[entry] <= 1e-9, "{}", laplacian.stiffness[entry]);
            }
        }
        prop_assert!(laplacian.mass.iter().all(|mass| *mass > 0.0));
        // So heat is positive wherever a source can be reached.
        let sources = sources(&surface, &places);
        let distance = solver(&surface, Parameters::default()).distance(&sources).expect("valid sources");
        for (heat, value) in distance.heat().expect("heat").iter().zip(&distance.values) {
            prop_assert!(*heat > 0.0 || value.is_infinite(), "{heat} at {value}");
        }
        Ok(())
    });
}

#[test]
fn exact_distances_change_by_no_more_than_the_path_between() {
    check(200, &(any_soup(), any_places()), |(soup, places)| {
        let surface = surface_of(&soup)?;
        let sources: Vec<(Place, f64)> =
            sources(&surface, &places).iter().map(|source| (source.place(), source.initial_distance())).collect();
        let exact = exact_distance(&surface, &sources, &mut go_on).expect("valid sources");
        let largest = exact.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
        for face in surface.mesh().faces() {
            let [p, q, r] = surface.corners(face);
            let [a, b, c] = surface.faces()[face].map(|point| exact[point]);
            for (x, y, length) in [(a, b, p.distance(q)), (b, c, q.distance(r)), (c, a, r.distance(p))] {
                prop_assert_eq!(x.is_infinite(), y.is_infinite());
                if x.is_finite() {
                    prop_assert!((x - y).abs() <= length + ROUNDING * largest, "{x} and {y} at {length}");
                }
            }
        }
        for &(point, offset) in &sources {
            if let Place::Vertex(vertex) = point {
                prop_assert!(exact[vertex] <= offset);
            }
        }
        Ok(())
    });
}

#[test]
fn the_exact_region_is_exact_and_refining_ends_at_exact() {
    check(60, &(any_soup(), any_places()), |(soup, places)| {
        let surface = surface_of(&soup)?;
        let sources = sources(&surface, &places);
        let pairs: Vec<(Place, f64)> =
            sources.iter().map(|source| (source.place(), source.initial_distance())).collect();
        let exact = exact_distance(&surface, &pairs, &mut go_on).expect("valid sources");
        let largest = exact.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
        let same = |a: f64, b: f64| a == b || (a - b).abs() <= ROUNDING * largest;
        let solver = solver(&surface, Parameters::default());
        let distance = solver.distance(&sources).expect("valid sources");
        for (value, exact) in distance.values.iter().zip(&exact) {
            if *value < distance.exact_below {
                prop_assert!(same(*value, *exact), "{value} for {exact}");
            } else {
                prop_assert!(*exact >= distance.exact_below - ROUNDING * largest, "{exact}");
            }
        }
        let mut refinement = solver.refine(&sources).expect("valid sources");
        let mut refined = refinement.step(solver.factorization(), 50).expect("valid sources");
        while !refinement.is_done() {
            refined = refinement.step(solver.factorization(), 500).expect("valid sources");
        }
        prop_assert!(refined.values.iter().zip(&exact).all(|(value, exact)| same(*value, *exact)));
        Ok(())
    });
}

#[test]
fn paths_arrive_and_are_locally_shortest() {
    check(100, &(any_soup(), any_places(), any_places()), |(soup, places, starts)| {
        let surface = surface_of(&soup)?;
        let sources = points(&surface, &places);
        let solver = solver(&surface, Parameters::default());
        let distance = solver.distance(&sources).expect("valid sources");
        for from in points(&surface, &starts) {
            let shortest = match shortest_path(solver.exact_geometry(), from, &sources) {
                Ok(path) => path,
                Err(error) => {
                    prop_assert_eq!(&error, &Error::Unreachable);
                    prop_assert_eq!(descend(&surface, &distance, from), Err(Error::Unreachable));
                    continue;
                }
            };
            let descent = descend(&surface, &distance, from).expect("reachable");
            let straight = straighten(&surface, &descent).expect("a path of this surface");
            prop_assert!(straight.length() <= descent.length());
            // Rounding of some hundred pieces.
            prop_assert!(straight.length() >= shortest.length() * (1.0 - 1e-9) - 1e-12);
            for path in [&shortest, &descent, &straight] {
                check_valid(&surface, path);
                let end = path.points[path.points.len() - 1].position;
                let misses = |source: &Place| source.position(&surface).distance(end) > 1e-9;
                prop_assert!(!sources.iter().all(misses), "{end} is no source");
            }
            // The thinnest triangles here are a millionth of their length high: directions near them are known to
            // 10⁻⁸, and what is straight to 10⁻⁷ is left as it is.
            prop_assert!(sharpest_turn(&surface, &straight) >= std::f64::consts::PI - 1e-6);
            prop_assert!(largest_kink(&surface, &straight) < 1e-8);
        }
        Ok(())
    });
}

#[test]
fn crowds_stay_on_the_surface_and_go_home() {
    check(100, &(any_soup(), any_places(), any_places(), 0.01..20.0_f64), |(soup, places, others, edges)| {
        let surface = surface_of(&soup)?;
        let solver = solver(&surface, Parameters::default());
        let step = edges * surface.mean_edge();
        let mut crowd = Crowd::new(Arc::clone(&surface), 30, surface.mean_edge(), 1).expect("a height");
        for places in [places, others] {
            let distance = solver.distance(&sources(&surface, &places)).expect("valid sources");
            crowd.follow(&distance).expect("a source");
            for _ in 0..40 {
                let before = crowd.walkers().to_vec();
                crowd.advance(step).expect("a step");
                prop_assert!(crowd.poses(&DrawTransform::IDENTITY).iter().all(|number| number.is_finite()));
                for walker in crowd.walkers() {
                    prop_assert!(walker.weights.iter().all(|&weight| weight >= 0.0), "{walker:?}");
                    // Rounding of a sum for each face entered.
                    prop_assert!((walker.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{walker:?}");
                    let place = Place::Face { face: walker.face, weights: walker.weights };
                    prop_assert!(place.interpolate(&surface, &distance.values).is_finite(), "no source there");
                    prop_assert!((walker.heading.length() - 1.0).abs() < 1e-12, "{walker:?}");
                    prop_assert!(walker.heading.dot(walker.upright).abs() < 1e-12, "{walker:?}");
                }
                for (old, new) in before.iter().zip(crowd.walkers()).filter(|(_, new)| new.arc > 0.0) {
                    let walked = new.arc - old.arc;
                    prop_assert!(walked <= step * (1.0 + 1e-9), "{walked} of {step}");
                    prop_assert!(old.position.distance(new.position) <= walked * (1.0 + 1e-9) + 1e-12 * new.arc);
                }
            }
        }
        Ok(())
    });
}

fn points(surface: &Surface, places: &[(u32, bool, [f64; 2], f64)]) -> Vec<Place> {
    sources(surface, places).iter().map(|source| source.place()).collect()
}
