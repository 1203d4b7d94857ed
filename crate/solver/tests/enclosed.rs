//! Areas on both sides of closed curves, as closed forms and as the areas of the faces give them.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{band, nearest, soup, square, surface};
use glam::DVec3;
use heatwalk::exact::{ExactGeometry, shortest_path};
use heatwalk::surface::VertexId;
use heatwalk::{Enclosed, Error, Path, Place, Surface, ToPoint, edge_polyline, enclosed};
use heatwalk_shapes as shapes;

/// Sums of a few thousand triangles.
const ROUNDING: f64 = 1e-10;

/// Shortest paths from each place to the next, and from the last to the first.
fn ring<P: ToPoint + heatwalk::ToSource>(surface: &Surface, places: &[P]) -> Vec<Path> {
    let geometry = Arc::new(ExactGeometry::new(Arc::new(surface.clone())));
    let next = places.iter().cycle().skip(1);
    places.iter().zip(next).map(|(&from, &to)| shortest_path(&geometry, from, &[to]).expect("connected")).collect()
}

fn area_of(surface: &Surface) -> f64 {
    surface.mesh().faces().map(|face| surface.face_area(face)).sum()
}

fn sides(surface: &Surface, paths: &[Path]) -> [f64; 2] {
    match enclosed(surface, paths) {
        Ok(Enclosed::Sides(sides)) => sides,
        other => panic!("{other:?} instead of two sides"),
    }
}

fn on_square(surface: &Surface, x: f64, y: f64) -> Place {
    let position = DVec3::new(x, y, 0.0);
    let inside = surface.mesh().faces().find_map(|face| {
        let [a, b, c] = surface.corners(face);
        let whole = (b - a).cross(c - a).z;
        let weights = [
            (b - position).cross(c - position),
            (c - position).cross(a - position),
            (a - position).cross(b - position),
        ];
        let weights = weights.map(|part| part.z / whole);
        weights.iter().all(|&weight| weight >= 0.0).then_some(Place::Face { face, weights })
    });
    inside.expect("a place of the unit square")
}

#[test]
fn polygons_on_a_square_have_their_area_on_the_side_that_they_turn_to() {
    let surface = surface(&square(9));
    let mut random = Random::new(5);
    for _ in 0..40 {
        let corner = |random: &mut Random| (random.below(998) as f64 + 1.0) / 1000.0;
        let [a, b, c] = [(); 3].map(|()| [corner(&mut random), corner(&mut random)]);
        let expected = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        let paths = ring(&surface, &[a, b, c].map(|[x, y]| on_square(&surface, x, y)));
        let [left, right] = sides(&surface, &paths);
        let (inner, outer) = if expected > 0.0 { (left, right) } else { (right, left) };
        assert!((inner - expected.abs()).abs() < ROUNDING, "{inner} instead of {}", expected.abs());
        assert!((inner + outer - 1.0).abs() < ROUNDING);
    }
}

#[test]
fn a_curve_within_one_face_encloses_its_polygon() {
    let surface = surface(&soup(vec![DVec3::ZERO, 2.0 * DVec3::X, 2.0 * DVec3::Y], vec![[0, 1, 2]]));
    let places = [[0.8, 0.1, 0.1], [0.3, 0.6, 0.1], [0.3, 0.1, 0.6]].map(|weights| {
        let face = heatwalk::FaceId(0);
        Place::Face { face, weights }
    });
    let [left, right] = sides(&surface, &ring(&surface, &places));
    assert!((left - 0.5).abs() < ROUNDING && (right - 1.5).abs() < ROUNDING, "{left}, {right}");
    let [a, b, c] = places;
    let [left, right] = sides(&surface, &ring(&surface, &[a, c, b]));
    assert!((left - 1.5).abs() < ROUNDING && (right - 0.5).abs() < ROUNDING, "{left}, {right}");
}

#[test]
fn lines_along_edges_part_the_faces_on_their_sides() {
    let surface = surface(&square(8));
    let corner = |x: f64, y: f64| nearest(&surface, DVec3::new(x, y, 0.0));
    let picked = [corner(0.25, 0.25), corner(0.75, 0.25), corner(0.75, 0.75), corner(0.25, 0.75)];
    let mut line = edge_polyline(&surface, &picked, true).expect("connected");
    line.push(line[0]);
    let path = Path::along_edges(&surface, &line).expect("along edges");
    let [left, right] = sides(&surface, &[path]);
    assert!((left - 0.25).abs() < ROUNDING && (right - 0.75).abs() < ROUNDING, "{left}, {right}");
}

#[test]
fn the_equator_halves_a_sphere_through_vertices_and_places_in_faces() {
    let surface = surface(&shapes::by_name("icosphere").expect("a shape").soup);
    let around = |z: f64| -> Vec<VertexId> {
        let at = |turn: f64| (std::f64::consts::TAU * turn).sin_cos();
        [0.0, 0.2, 0.4, 0.6, 0.8].map(|turn| nearest(&surface, DVec3::new(at(turn).1, at(turn).0, z))).to_vec()
    };
    let whole = area_of(&surface);
    for z in [0.0, 0.4] {
        let paths = ring(&surface, &around(z));
        let [left, right] = sides(&surface, &paths);
        assert!((left + right - whole).abs() < ROUNDING * whole);
        let [back_left, back_right] =
            sides(&surface, &ring(&surface, &around(z).into_iter().rev().collect::<Vec<_>>()));
        // The paths back may be other ones of the same length.
        let slack = 0.02 * whole;
        assert!((back_left - right).abs() < slack && (back_right - left).abs() < slack);
        assert!(left < 0.55 * whole, "the cap above is on the left: {left} of {whole}");
    }
}

#[test]
fn around_a_torus_there_are_no_two_sides() {
    let surface = surface(&shapes::by_name("torus").expect("a shape").soup);
    let far = surface.vertices().max_by(|&a, &b| surface.position(a).x.total_cmp(&surface.position(b).x));
    let far = surface.position(far.expect("vertices"));
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    // Of two turns by the axes across one is the axis of the torus.
    let rings = [axes[1], axes[2]].map(|axis| {
        let places: Vec<VertexId> = (0..6)
            .map(|k| {
                let turned = glam::DQuat::from_axis_angle(axis, std::f64::consts::TAU * f64::from(k) / 6.0) * far;
                nearest(&surface, turned)
            })
            .collect();
        enclosed(&surface, &ring(&surface, &places))
    });
    assert!(rings.contains(&Ok(Enclosed::Whole)), "{rings:?}");
}

#[test]
fn curves_that_cross_themselves_and_surfaces_without_sides_are_told() {
    let plane = surface(&square(9));
    let bow = [(0.1, 0.1), (0.9, 0.9), (0.9, 0.12), (0.1, 0.88)].map(|(x, y)| on_square(&plane, x, y));
    assert_eq!(enclosed(&plane, &ring(&plane, &bow)), Ok(Enclosed::Crossed));
    let small = [(0.51, 0.501), (0.53, 0.503), (0.53, 0.501), (0.51, 0.503)].map(|(x, y)| on_square(&plane, x, y));
    assert_eq!(enclosed(&plane, &ring(&plane, &small)), Ok(Enclosed::Crossed));

    let twisted = surface(&band(24, 1));
    let places = [0, 7, 13].map(VertexId);
    assert_eq!(enclosed(&twisted, &ring(&twisted, &places)), Ok(Enclosed::Sideless));

    let mut open = ring(&plane, &bow[..3]);
    open.pop();
    assert!(matches!(enclosed(&plane, &open), Err(Error::BadParameter { name: "curve", .. })));
    assert!(matches!(enclosed(&twisted, &open), Err(Error::Surface(heatwalk::surface::Error::ForeignSurface { .. }))));
}
