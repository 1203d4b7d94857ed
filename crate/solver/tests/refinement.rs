//! Lengths of paths that become exact step by step, and exact paths that are searched so.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{any_triangles, band, flat, soup, surface};
use heatwalk::exact::{ExactGeometry, shortest_path};
use heatwalk::{
    Distance, Error, PathSearch, Propagation, PropagationOptions, PropagationRefinement, Soup, Source, VertexId,
};
use heatwalk_shapes as shapes;

/// What rounding may take from the length of a path.
const ROUNDING: f64 = 1e-9;

struct Case {
    geometry: Arc<ExactGeometry>,
    sources: Vec<Source>,
    propagated: Distance,
}

/// Two sources, the second of which starts later.
fn case(soup: &Soup) -> Case {
    let surface = Arc::new(surface(soup));
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let at = |vertex, value| surface.source(VertexId(vertex), value).expect("a source");
    let sources = vec![at(0, 0.0), at(7, surface.mean_edge())];
    let mut propagation =
        Propagation::new(Arc::clone(&geometry), &sources, PropagationOptions::default()).expect("sources");
    assert!(propagation.advance(f64::INFINITY, usize::MAX).expect("room for windows"));
    let propagated = propagation.distance();
    Case { geometry, sources, propagated }
}

fn cases() -> [Case; 4] {
    let mut random = Random::new(5);
    [
        case(&shapes::torus(2.0, 0.7, 80, 40)),
        case(&shapes::maze(6, 2)),
        case(&band(60, 1)),
        case(&any_triangles(80, &mut random)),
    ]
}

#[test]
fn each_step_is_exact_farther_and_beyond_never_longer_than_before() {
    for Case { geometry, sources, propagated } in &cases() {
        let start = || PropagationRefinement::new(geometry, sources, propagated.clone()).expect("sources");
        let exact = start().step(usize::MAX).expect("room");
        assert_eq!(exact.exact_below, f64::INFINITY);
        assert_eq!(exact.sources, propagated.sources);

        let mut refinement = start();
        let (mut before, mut reached) = (propagated.clone(), 0.0);
        while !refinement.is_done() {
            let distance = refinement.step(100).expect("room");
            assert!(distance.exact_below >= reached);
            reached = distance.exact_below;
            for ((&value, &last), &least) in distance.values.iter().zip(&before.values).zip(&exact.values) {
                assert!(
                    value <= last * (1.0 + ROUNDING) && value >= least * (1.0 - ROUNDING),
                    "{least} {value} {last}"
                );
                assert!(value >= distance.exact_below || value == least, "{value} for {least}");
            }
            before = distance;
        }
        assert_eq!(before.values, exact.values);
        assert_eq!(before.exact_below, f64::INFINITY);
    }
}

#[test]
fn a_path_that_is_searched_in_steps_is_the_shortest_one() {
    for Case { geometry, sources, propagated } in &cases() {
        let is_far = |&(_, &value): &(VertexId, &f64)| value.is_finite();
        let places = geometry.surface().vertices().zip(&propagated.values).filter(is_far);
        let (from, _) = places.max_by(|a, b| a.1.total_cmp(b.1)).expect("a vertex");
        let mut search = PathSearch::new(geometry, from, sources).expect("valid places");
        let mut steps = 0;
        let path = loop {
            steps += 1;
            if let Some(path) = search.step(1).expect("a path") {
                break path;
            }
        };
        assert!(steps > 1);
        let shortest = shortest_path(geometry, from, sources).expect("a path");
        assert_eq!(path.points.len(), shortest.points.len());
        assert_eq!(path.length(), shortest.length());
    }
}

#[test]
fn a_search_that_cannot_succeed_says_so() {
    let triangle = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)];
    let apart = triangle.map(|(x, y)| (x + 3.0, y));
    let two = soup(flat(&[triangle, apart].concat()), vec![[0, 1, 2], [3, 4, 5]]);
    let geometry = Arc::new(ExactGeometry::new(surface(&two)));
    let none: [VertexId; 0] = [];
    assert_eq!(PathSearch::new(&geometry, VertexId(0), &none).unwrap_err(), Error::NoSource);
    let mut search = PathSearch::new(&geometry, VertexId(4), &[VertexId(0)]).expect("valid places");
    assert_eq!(search.step(usize::MAX).unwrap_err(), Error::Unreachable);
}
