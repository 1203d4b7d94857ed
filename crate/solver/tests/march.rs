//! Distance carried by vertices alone: near to the exact one on both sides, never above that along edges.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::media::{jittered_square, least_cost, two_media};
use crate::common::searches::{self, Case, at, exact, geometry};
use crate::common::{nearest, square, surface};
use glam::DVec3;
use heatwalk::exact::ExactGeometry;
use heatwalk::{
    Carriers, Costs, ExactSearch, Place, Propagation, PropagationOptions, RelativeError, Surface, VertexId,
};
use heatwalk_shapes as shapes;

/// What rounding may take from the length of a path.
const ROUNDING: f64 = 1e-9;

fn start(geometry: &Arc<ExactGeometry>, sources: &[(Place, f64)], exact: ExactSearch) -> Propagation {
    let options = PropagationOptions { carriers: Carriers::Vertices, exact, ..PropagationOptions::default() };
    Propagation::new(Arc::clone(geometry), sources, options).expect("valid sources")
}

fn marched(geometry: &Arc<ExactGeometry>, sources: &[(Place, f64)], exact: ExactSearch) -> Propagation {
    searches::grown(start(geometry, sources, exact))
}

/// Whether no vertex has more than a neighbour's distance and the edge to it.
fn is_within_edges(surface: &Surface, march: &Propagation) -> bool {
    let values = march.values();
    let is_within = |vertex: VertexId, neighbour: VertexId| {
        let along = values[neighbour] + surface.position(vertex).distance(surface.position(neighbour));
        values[vertex] <= along * (1.0 + ROUNDING)
    };
    surface.vertices().all(|vertex| surface.neighbours(vertex).all(|neighbour| is_within(vertex, neighbour)))
}

#[test]
fn all_that_can_be_reached_is_and_no_later_than_along_edges() {
    for Case { surface, geometry, sources, exact } in searches::cases_of_all_kinds() {
        for search in [ExactSearch::Automatic, ExactSearch::AtMost(0)] {
            let march = marched(&geometry, &sources, search);
            assert!(is_within_edges(&surface, &march));
            for (value, least) in march.values().iter().zip(exact.values()) {
                assert_eq!(value.is_finite(), least.is_finite());
            }
        }
    }
}

#[test]
fn it_is_off_by_little() {
    for (soup, search, [mean, max]) in [
        (shapes::torus(2.0, 0.7, 120, 60), ExactSearch::Automatic, [0.2, 0.7]),
        (shapes::torus(2.0, 0.7, 120, 60), ExactSearch::AtMost(0), [0.2, 0.7]),
        (shapes::horse(0.05), ExactSearch::Automatic, [0.3, 2.0]),
    ] {
        let surface = Arc::new(surface(&soup));
        let geometry = geometry(&surface);
        let march = marched(&geometry, &at(5), search);
        let error = RelativeError::between(march.values(), exact(&geometry, &at(5)).values());
        assert!(100.0 * error.mean < mean && 100.0 * error.max < max, "{error:?}");
    }
}

#[test]
fn what_the_exact_search_knows_stays() {
    for soup in [shapes::maze(6, 2), shapes::torus(2.0, 0.7, 60, 30)] {
        let surface = Arc::new(surface(&soup));
        let geometry = geometry(&surface);
        for (vertex, windows) in [(2, 100), (2, 800), (17, 50), (40, 1600)] {
            let exact = exact(&geometry, &at(vertex));
            let march = marched(&geometry, &at(vertex), ExactSearch::AtMost(windows));
            let below = march.exact_below();
            for (&value, &least) in march.values().iter().zip(exact.values()) {
                assert!(if least < below { value == least } else { value >= below }, "{value} for {least}, {below}");
            }
        }
    }
}

#[test]
fn on_a_plane_it_is_straight() {
    let surface = Arc::new(surface(&jittered_square(40, 1)));
    let geometry = geometry(&surface);
    let source = nearest(&surface, DVec3::new(0.3, 0.4, 0.0));
    let march = marched(&geometry, &at(source.0), ExactSearch::AtMost(0));
    let from = surface.position(source);
    let straight: Vec<f64> = surface.positions().iter().map(|position| position.distance(from)).collect();
    let error = RelativeError::between(march.values(), &straight);
    assert!(error.max < 1e-12, "{error:?}");
}

#[test]
fn slices_and_a_used_solver_change_nothing() {
    searches::slices_and_use_change_nothing(|geometry, sources| start(geometry, sources, ExactSearch::Automatic));
}

#[test]
fn the_nearest_source_is_told() {
    let start = |geometry: &_, sources: &_| start(geometry, sources, ExactSearch::AtMost(1000));
    searches::nearest_sources_are_told(start, |value, least| (value - least).abs() <= 0.03 * least);
}

#[test]
fn the_size_of_a_mesh_does_not_matter() {
    searches::size_does_not_matter(|geometry, sources| start(geometry, sources, ExactSearch::AtMost(0)));
}

#[test]
fn where_costs_differ_it_follows_snell() {
    let cost = 3.0;
    let square = Arc::new(surface(&jittered_square(80, 1)));
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&square)).weighted(&two_media(&square, cost)));
    let source = nearest(&square, DVec3::new(0.2, 0.5, 0.0));
    let march = marched(&geometry, &at(source.0), ExactSearch::Automatic);
    let place = |vertex: VertexId| square.position(vertex).truncate();
    let least: Vec<f64> = square.vertices().map(|vertex| least_cost(place(source), place(vertex), cost)).collect();
    let error = RelativeError::between(march.values(), &least);
    assert!(100.0 * error.mean < 0.25 && 100.0 * error.max < 1.0, "{error:?}");
}

#[test]
fn one_cost_everywhere_makes_every_distance_as_many_times_as_large() {
    let surface = Arc::new(surface(&square(30)));
    let of = |cost: f64| {
        let costs = Costs::new(&surface, (0..surface.face_count()).map(|_| cost).collect()).expect("in range");
        let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)).weighted(&costs));
        marched(&geometry, &at(5), ExactSearch::Automatic).values().clone()
    };
    for (value, one) in of(7.3).iter().zip(&of(1.0)) {
        assert!((value - 7.3 * one).abs() <= ROUNDING * value, "{value} {one}");
    }
}
