//! Bézier curves, against polynomials of the plane and mirrored ones on a sphere.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DVec3, dvec3};
use heatwalk::exact::ExactGeometry;
use heatwalk::{Bezier, Error, FaceId, Place, Surface, VertexId, bezier, go_on};
use heatwalk_shapes as shapes;

use crate::common::searches::geometry;
use crate::common::{nearest, square, surface, two_squares};

/// Rounding of lines through some dozens of faces of unit size.
const ROUNDING: f64 = 1e-9;

fn on(soup: &heatwalk::Soup) -> (Arc<Surface>, Arc<ExactGeometry>) {
    let surface = Arc::new(surface(soup));
    (Arc::clone(&surface), geometry(&surface))
}

fn curve(geometry: &Arc<ExactGeometry>, controls: &[Place]) -> Bezier {
    bezier(geometry, controls, &mut go_on).expect("a curve")
}

/// De Casteljau's algorithm in space.
fn polynomial(controls: &[DVec3], at: f64) -> DVec3 {
    match controls {
        [only] => *only,
        _ => {
            let next: Vec<DVec3> = controls.windows(2).map(|ends| ends[0].lerp(ends[1], at)).collect();
            polynomial(&next, at)
        }
    }
}

#[test]
fn on_a_plane_it_is_the_polynomial() {
    let (surface, geometry) = on(&square(12));
    let vertex = |x: f64, y: f64| Place::Vertex(nearest(&surface, dvec3(x, y, 0.0)));
    let face = Place::Face { face: FaceId(100), weights: [0.2, 0.3, 0.5] };
    let controls = [vertex(0.1, 0.1), vertex(0.2, 0.9), face, vertex(0.9, 0.8), vertex(0.6, 0.3)];
    for count in 1..=controls.len() {
        let places = &controls[..count];
        let positions: Vec<DVec3> = places.iter().map(|place| place.position(&surface)).collect();
        let Bezier { path, points } = curve(&geometry, places);
        for (at, point) in &points {
            let expected = polynomial(&positions, *at);
            assert!(point.place().position(&surface).distance(expected) < ROUNDING, "{at} of {count}");
        }
        assert!(points.windows(2).all(|ends| ends[0].0 < ends[1].0) && count < 3 || points.len() > 8);
        let ends = [path.points[0], path.points[path.points.len() - 1]].map(|point| point.position);
        assert!(ends[0].distance(positions[0]) < ROUNDING && ends[1].distance(positions[count - 1]) < ROUNDING);
    }
}

#[test]
fn it_does_not_depend_on_the_side_or_the_end_that_it_is_seen_from() {
    let (surface, geometry) = on(&shapes::icosphere(3));
    let mirrored = |position: DVec3| dvec3(-position.x, position.y, position.z);
    let controls = [dvec3(0.9, 0.3, 0.2), dvec3(0.5, 0.8, 0.1), dvec3(0.1, 0.5, 0.8), dvec3(-0.6, 0.2, 0.7)];
    let of = |positions: &[DVec3]| {
        let places: Vec<Place> = positions.iter().map(|&position| Place::Vertex(nearest(&surface, position))).collect();
        curve(&geometry, &places).points
    };
    let here = of(&controls);
    let there = of(&controls.map(mirrored));
    let mut back = controls;
    back.reverse();
    let back = of(&back);
    assert!(here.len() > 8 && here.len() == there.len() && here.len() == back.len());
    for (number, (at, point)) in here.iter().enumerate() {
        let position = point.place().position(&surface);
        let (at_mirrored, mirror) = &there[number];
        let (at_back, from_end) = &back[back.len() - 1 - number];
        assert!(at == at_mirrored && *at == 1.0 - at_back);
        assert!(mirror.place().position(&surface).distance(mirrored(position)) < ROUNDING, "{at}");
        assert!(from_end.place().position(&surface).distance(position) < ROUNDING, "{at}");
    }
}

#[test]
fn refuses_what_no_path_joins_and_nothing_at_all() {
    let (two, first) = two_squares(4);
    let (_, geometry) = on(&two);
    let apart = [VertexId(0), VertexId(first)];
    assert!(matches!(bezier(&geometry, &apart, &mut go_on), Err(Error::Unreachable)));
    assert_eq!(bezier::<VertexId>(&geometry, &[], &mut go_on), Err(Error::NoSource));
    let cancel = &mut |_, _| ControlFlow::Break(());
    assert_eq!(bezier(&geometry, &[VertexId(0), VertexId(3)], cancel), Err(Error::Cancelled));
    let still = bezier(&geometry, &[VertexId(3)], &mut go_on).expect("a point");
    assert_eq!((still.path.length(), still.points.len()), (0.0, 2));
}
