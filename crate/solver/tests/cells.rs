//! Nearest sources against a search from each of them.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::ops::ControlFlow;
use std::sync::Arc;

use heatwalk::exact::{ExactGeometry, PlaceDistances, exact_distance};
use heatwalk::{Error, FaceId, Place, Source, VertexId, cell_map, cells, go_on};
use heatwalk_shapes as shapes;

use crate::common::{surface, two_squares};

#[test]
fn each_vertex_and_place_belongs_to_a_source_that_is_as_near_as_any() {
    for soup in [shapes::torus(1.0, 0.4, 24, 12), shapes::grid(9, 9), shapes::icosphere(2)] {
        let surface = Arc::new(surface(&soup));
        let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
        let face = Place::Face { face: FaceId(31), weights: [0.2, 0.5, 0.3] };
        let sources: Vec<Source> = [
            surface.source(VertexId(3), 0.0),
            surface.source(face, 0.1),
            surface.source(VertexId(40), 0.0),
            surface.source(VertexId(60), 0.05),
        ]
        .map(|source| source.expect("a place"))
        .into();
        let found = cells(&geometry, &sources, &mut go_on).expect("cells");
        let alone: Vec<_> =
            sources.iter().map(|&source| exact_distance(&surface, &[source], &mut go_on).expect("a source")).collect();
        for vertex in surface.vertices() {
            let number = found.nearest[vertex].expect("all are reached") as usize;
            let least = alone.iter().map(|field| field[vertex]).fold(f64::INFINITY, f64::min);
            assert!((found.distances[vertex] - least).abs() < 1e-12);
            assert!((alone[number][vertex] - least).abs() < 1e-12, "{vertex:?} of {number}");
        }
        let map = cell_map(&geometry, &sources, &mut go_on).expect("cells");
        assert_eq!(map.cells, found);
        let of_each: Vec<_> = (0..sources.len())
            .map(|number| PlaceDistances::new(&geometry, &alone[number], &sources[number..=number]).expect("places"))
            .collect();
        for face in surface.faces().ids() {
            for weights in [[0.15, 0.25, 0.6], [0.5, 0.5, 0.0], [0.01, 0.98, 0.01], [1.0 / 3.0; 3]] {
                let place = Place::Face { face, weights };
                let number = map.at(face, weights).expect("a place").expect("all are reached") as usize;
                let lengths = of_each.iter().map(|of| of.at(place).expect("a place"));
                let least = lengths.fold(f64::INFINITY, f64::min);
                assert!((of_each[number].at(place).expect("a place") - least).abs() < 1e-9, "{face:?} of {number}");
            }
        }
        let is_own = |(number, source): (usize, &Source)| match source.place() {
            Place::Vertex(vertex) => found.nearest[vertex] == Some(number as u32),
            _ => true,
        };
        assert!(sources.iter().enumerate().filter(|(_, source)| source.initial_distance() == 0.0).all(is_own));
    }
}

#[test]
fn what_no_source_reaches_is_of_none_and_what_cannot_be_asked_is_refused() {
    let surface = Arc::new(surface(&two_squares(4).0));
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let found = cells(&geometry, &[VertexId(0)], &mut go_on).expect("cells");
    assert!(surface.vertices().all(|vertex| found.nearest[vertex].is_some() == found.distances[vertex].is_finite()));
    assert!(surface.vertices().any(|vertex| found.nearest[vertex].is_none()));
    let none: [VertexId; 0] = [];
    assert!(matches!(cells(&geometry, &none, &mut go_on), Err(Error::NoSource)));
    let large = Arc::new(ExactGeometry::new(self::surface(&shapes::icosphere(5))));
    assert!(matches!(cells(&large, &[VertexId(0)], &mut |_, _| ControlFlow::Break(())), Err(Error::Cancelled)));
    assert!(cells(&geometry, &[VertexId(99)], &mut go_on).is_err());
}
