//! Distances and paths across portals between components, against every way through the portals one by one.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::square;
use crate::common::truth::Random;
use glam::dvec3;
use heatwalk::exact::{ExactGeometry, PlaceDistances, Wavefront, shortest_path};
use heatwalk::path::shortest;
use heatwalk::{
    Bridges, Carriers, DistanceOptions, DistanceSolver, Element, ExactSearch, FaceId, Method, Place, Portal,
    Propagation, PropagationOptions, PropagationRefinement, Soup, Surface, VertexId, descend, go_on, straighten,
};
use heatwalk_shapes as shapes;

const ROUNDING: f64 = 1e-11;

/// Three components side by side, and a fourth that nothing leads to.
fn parts() -> Arc<Surface> {
    let mut soup = Soup::default();
    let parts = [shapes::icosphere(3), shapes::torus(1.0, 0.4, 24, 12), square(9), shapes::icosphere(1)];
    for (part, number) in parts.into_iter().zip(0..) {
        let place = dvec3(3.0 * f64::from(number), 0.0, 0.0);
        soup.add(part.positions.iter().map(|&position| position + place), &part.triangles);
    }
    soup.end_part("parts");
    Arc::new(Surface::build(&soup).expect("a surface"))
}

/// A place in a component: in a face, on an edge or at a vertex.
fn place(surface: &Surface, component: u32, random: &mut Random) -> Place {
    let faces: Vec<FaceId> = (0..surface.face_count()).map(FaceId::from_index).collect();
    let own: Vec<FaceId> = faces.into_iter().filter(|&face| component_of(surface, face) == component).collect();
    let face = own[random.below(own.len())];
    let weights = match random.below(4) {
        0 => [1.0, 0.0, 0.0],
        1 => [0.25, 0.75, 0.0],
        _ => [0.2, 0.3, 0.5],
    };
    Place::Face { face, weights }.snapped(surface)
}

fn component_of(surface: &Surface, face: FaceId) -> u32 {
    surface.components()[surface.faces()[face][0]]
}

/// Portals between the first three components, some of them one after another, and within one.
fn bridges(surface: &Surface, random: &mut Random) -> Bridges {
    let between = [[0, 1], [1, 2], [0, 2], [1, 1]];
    let contact = |components: [u32; 2]| {
        let portal = |_| {
            let ends = components.map(|component| place(surface, component, random));
            let [a, b] = ends.map(|end| end.position(surface));
            Portal { ends, gap: a.distance(b) }
        };
        (components, (0..4).map(portal).collect())
    };
    Bridges::new(surface, between.map(contact).into())
}

/// Exact distances from a place within its component, to all vertices and to `targets`.
fn within(geometry: &Arc<ExactGeometry>, from: Place, targets: &[Place]) -> (Vec<f64>, Vec<f64>) {
    let mut front = Wavefront::with_targets(Arc::clone(geometry), &[from], targets).expect("places");
    assert!(front.advance(f64::INFINITY, usize::MAX).expect("room for windows"));
    (front.values().as_slice().to_vec(), front.target_values().to_vec())
}

/// The distance of all vertices by every way through the portals.
fn expected(surface: &Arc<Surface>, bridges: &Bridges, source: Place) -> Vec<f64> {
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(surface)));
    let ends: Vec<Place> = bridges.portals().iter().flat_map(|portal| portal.ends).collect();
    let (mut values, mut at_ends) = within(&geometry, source, &ends);
    let from_ends: Vec<_> = ends.iter().map(|&end| within(&geometry, end, &ends)).collect();
    // Bellman and Ford: a path crosses each portal once at most.
    for _ in 0..ends.len() {
        for end in 0..ends.len() {
            let through = at_ends[end ^ 1] + bridges.portals()[end / 2].gap;
            for (other, known) in at_ends.iter_mut().enumerate() {
                *known = known.min(through + from_ends[end].1[other]);
            }
        }
    }
    for (end, (from_end, _)) in from_ends.iter().enumerate() {
        for (value, further) in values.iter_mut().zip(from_end) {
            *value = value.min(at_ends[end] + further);
        }
    }
    values
}

struct Case {
    surface: Arc<Surface>,
    bridges: Bridges,
    source: Place,
    expected: Vec<f64>,
}

fn cases() -> Vec<Case> {
    let surface = parts();
    let case = |seed: u64| {
        let mut random = Random::new(seed);
        let bridges = bridges(&surface, &mut random);
        let source = place(&surface, 0, &mut random);
        let expected = expected(&surface, &bridges, source);
        Case { surface: Arc::clone(&surface), bridges, source, expected }
    };
    (1..=4).map(case).collect()
}

fn geometry(case: &Case) -> Arc<ExactGeometry> {
    Arc::new(ExactGeometry::new(Arc::clone(&case.surface)).bridged(&case.bridges))
}

fn is_near(value: f64, expected: f64) -> bool {
    value == expected || (value - expected).abs() <= ROUNDING * expected
}

#[test]
fn exact_distances_cross_portals() {
    for case in cases() {
        let mut front = Wavefront::new(geometry(&case), &[case.source]).expect("a source");
        assert!(front.advance(f64::INFINITY, usize::MAX).expect("room for windows"));
        for (vertex, (&value, &expected)) in front.values().iter().zip(&case.expected).enumerate() {
            assert!(is_near(value, expected), "vertex {vertex}: {value} for {expected}");
            let vertex = VertexId::from_index(vertex);
            if value < f64::INFINITY {
                let path = front.path_from_vertex(vertex).expect("a path");
                assert!(is_near(path.length(), value), "{vertex:?}: {} for {value}", path.length());
            } else {
                assert!(front.path_from_vertex(vertex).is_err());
            }
        }
        // In the same memory once more.
        front.restart(&[case.source]).expect("a source");
        front.advance(f64::INFINITY, usize::MAX).expect("room for windows");
        assert!(front.values().iter().zip(&case.expected).all(|(&value, &expected)| is_near(value, expected)));
    }
}

#[test]
fn places_in_faces_are_reached_through_portals() {
    let mut random = Random::new(5);
    for case in cases() {
        let geometry = geometry(&case);
        let places: Vec<Place> = (0..30).map(|number| place(&case.surface, number % 3, &mut random)).collect();
        let mut front = Wavefront::with_targets(Arc::clone(&geometry), &[case.source], &places).expect("valid places");
        front.advance(f64::INFINITY, usize::MAX).expect("room for windows");
        let distances = PlaceDistances::new(&geometry, front.values(), &[case.source]).expect("a source");
        for (&place, &expected) in places.iter().zip(front.target_values()) {
            let value = distances.at(place).expect("a valid place");
            assert!(is_near(value, expected), "{place:?}: {value} for {expected}");
            if expected.is_finite() {
                let length = shortest(&distances, place).expect("a path").length();
                assert!(is_near(length, expected), "{place:?}: a path of {length} for {expected}");
            }
        }
    }
}

#[test]
fn propagated_distances_cross_portals_and_become_exact() {
    for case in cases() {
        let geometry = geometry(&case);
        let searches = [ExactSearch::AtMost(0), ExactSearch::AtMost(300)];
        // Vertices alone are off to both sides.
        let carriers = [(Carriers::Windows, [1.0 - ROUNDING, 1.03]), (Carriers::Vertices, [0.96, 1.06])];
        for (exact, (carriers, [least, most])) in searches.into_iter().flat_map(|exact| carriers.map(|by| (exact, by)))
        {
            let options = PropagationOptions { exact, carriers, ..PropagationOptions::default() };
            let mut propagation = Propagation::new(Arc::clone(&geometry), &[case.source], options).expect("a source");
            assert!(propagation.advance(f64::INFINITY, usize::MAX).expect("room for windows"));
            let distance = propagation.distance();
            let nearest = propagation.nearest_sources();
            for ((&value, &expected), nearest) in distance.values.iter().zip(&case.expected).zip(&nearest) {
                let is_near = value <= most * expected + 1e-3 || value == expected;
                assert!(value >= expected * least && is_near, "{value} for {expected}");
                assert_eq!(*nearest, (value < f64::INFINITY).then_some(0));
            }
            let mut refinement = PropagationRefinement::new(&geometry, &[case.source], distance).expect("room");
            while !refinement.is_done() {
                let distance = refinement.step(200).expect("room");
                for vertex in case.surface.vertices().filter(|&vertex| distance.values[vertex] < f64::INFINITY) {
                    descend(&case.surface, &distance, vertex).expect("a path, however far it is exact");
                }
            }
            let distance = refinement.step(1).expect("room");
            assert!(distance.values.iter().zip(&case.expected).all(|(&value, &expected)| is_near(value, expected)));
        }
    }
}

#[test]
fn paths_arrive_through_portals_and_are_no_shorter_than_exact_ones() {
    for case in cases() {
        let mut solver = DistanceSolver::new(Arc::clone(&case.surface)).bridged(case.bridges.clone());
        let end = case.source.position(&case.surface);
        for method in [Method::Exact, Method::Propagation, Method::Heat] {
            let answer = solver.distance(&[case.source], &DistanceOptions::by(method), &mut go_on).expect("a distance");
            let distance = answer.distance;
            assert_eq!(distance.sources.len(), 1);
            let (mut error, mut count) = (0.0, 0.0);
            for vertex in case.surface.vertices() {
                let expected = case.expected[vertex.index()];
                assert_eq!(distance.values[vertex].is_finite(), expected.is_finite(), "{method:?}");
                if expected.is_infinite() {
                    continue;
                }
                if expected > 0.0 {
                    error += (distance.values[vertex] / expected - 1.0).abs();
                    count += 1.0;
                }
                let path = descend(&case.surface, &distance, vertex).expect("a path");
                let straight = straighten(&case.surface, &path).expect("a path");
                for path in [&path, &straight] {
                    assert_eq!(path.points.last().map(|point| point.position), Some(end));
                    assert!(path.length() >= expected * (1.0 - ROUNDING), "{} for {expected}", path.length());
                }
                assert!(straight.length() <= path.length() * (1.0 + ROUNDING));
            }
            let most = if method == Method::Heat { 0.05 } else { 0.01 };
            assert!(error / count <= most, "{method:?}: {}", error / count);
        }
        let from = place(&case.surface, 2, &mut Random::new(9));
        let path = shortest_path(&geometry(&case), from, &[case.source]).expect("a path");
        let value = within(&geometry(&case), case.source, &[from]).1[0];
        assert!(is_near(path.length(), value), "{} for {value}", path.length());
    }
}

#[test]
fn components_that_are_joined_are_one_group() {
    let surface = parts();
    assert_eq!(Bridges::new(&surface, Vec::new()).group_count(), 4);
    let bridges = bridges(&surface, &mut Random::new(1));
    assert_eq!(bridges.group_count(), 2);
    assert_eq!([0, 1, 2, 3].map(|component| bridges.group(component)), [0, 0, 0, 1]);
    assert_eq!(bridges.contacts().len(), 4);
}
