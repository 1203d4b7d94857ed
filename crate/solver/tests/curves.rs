//! Distance from curves, against closed forms in the plane and against points along them.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::slice::from_ref;
use std::sync::Arc;

use glam::{DVec2, DVec3, dvec2};
use heatwalk::exact::{ExactGeometry, Wavefront, exact_distance};
use heatwalk::{
    Costs, Curve, Element, Error, FaceId, Line, Place, Sign, Soup, Source, Surface, VertexData, VertexId,
    curve_distance, curve_search, go_on, signed_curve_distance,
};
use heatwalk_shapes as shapes;

use crate::common::searches::geometry;
use crate::common::shortness::check_valid;
use crate::common::truth::Random;
use crate::common::{Damage, band, book, damaged, flat, grid_triangles, nearest, soup, surface, two_squares};

/// Rounding of lines through some dozens of faces of unit size.
const ROUNDING: f64 = 1e-11;

fn laid_out(soup: &Soup) -> (Arc<Surface>, Arc<ExactGeometry>) {
    let surface = Arc::new(surface(soup));
    (Arc::clone(&surface), geometry(&surface))
}

fn through(geometry: &Arc<ExactGeometry>, places: &[Place], is_closed: bool) -> Curve {
    Curve::through(geometry, places, is_closed, &mut go_on).expect("a curve")
}

fn distance(geometry: &Arc<ExactGeometry>, curves: &[Curve]) -> VertexData<f64> {
    curve_distance(geometry, curves, &mut go_on).expect("distance")
}

fn signed(geometry: &Arc<ExactGeometry>, curves: &[Curve]) -> VertexData<f64> {
    signed_curve_distance(geometry, curves, Sign::Nearest, &mut go_on).expect("distance").values
}

/// The unit square in so many edges across, of which vertices have moved by as large a share of an edge at most, but for those of the
/// boundary.
fn plane(edges: u32, share: f64) -> Soup {
    let mut random = Random::new(4);
    let mut at = |i: u32| {
        let shift = if i == 0 || i == edges { 0.0 } else { random.between(-share, share) };
        (f64::from(i) + shift) / f64::from(edges)
    };
    let places: Vec<(u32, u32)> = (0..=edges).flat_map(|i| (0..=edges).map(move |j| (i, j))).collect();
    let points: Vec<(f64, f64)> = places.into_iter().map(|(i, j)| (at(i), at(j))).collect();
    soup(flat(&points), grid_triangles(0, edges).collect())
}

fn searched(geometry: &Arc<ExactGeometry>, curves: &[Curve], targets: &[Place]) -> Wavefront {
    let mut front = curve_search(geometry, curves, targets).expect("a search");
    while !front.advance(f64::INFINITY, usize::MAX).expect("memory") {}
    front
}

/// A place of a flat surface.
fn place_at(surface: &Surface, point: DVec2) -> Place {
    let of_face = |face: FaceId| {
        let [a, b, c] = surface.corners(face).map(DVec3::truncate);
        let area = (b - a).perp_dot(c - a);
        let weights =
            [(b - point).perp_dot(c - point), (c - point).perp_dot(a - point), (a - point).perp_dot(b - point)];
        weights
            .iter()
            .all(|&weight| weight >= -1e-15)
            .then(|| Place::Face { face, weights: weights.map(|weight| weight / area) })
    };
    surface.faces().ids().find_map(of_face).expect("a place of the square")
}

/// Distance from a polygon's sides, and whether the nearest point is seen from the left; where it is a corner, whether the turn there is
/// to the right.
fn to_polygon(points: &[DVec2], is_closed: bool, from: DVec2) -> (f64, bool) {
    let count = points.len() - usize::from(!is_closed);
    let sides = (0..count).map(|k| [points[k], points[(k + 1) % points.len()]]);
    let near = sides.map(|[a, b]| {
        let share = ((from - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        let aside = (b - a).normalize().perp_dot(from - a);
        (from.distance(a + share * (b - a)), aside)
    });
    // Of two sides that meet at the nearest point, the one that is farther from the straight continuation of the other tells.
    let near: Vec<(f64, f64)> = near.collect();
    let least = near.iter().map(|near| near.0).fold(f64::INFINITY, f64::min);
    let tied = near.iter().filter(|near| near.0 < least + 1e-12);
    let aside = tied.map(|near| near.1).max_by(|a, b| a.abs().total_cmp(&b.abs())).expect("a side");
    (least, aside > 0.0)
}

/// A simple polygon around a middle, counterclockwise.
fn star(random: &mut Random, corners: u32) -> Vec<DVec2> {
    let corner = |k: u32| {
        let angle = TAU * (f64::from(k) + 0.3 * random.share()) / f64::from(corners);
        dvec2(0.5, 0.5) + random.between(0.1, 0.45) * DVec2::from_angle(angle)
    };
    (0..corners).map(corner).collect()
}

#[test]
fn in_the_plane_distance_is_to_the_nearest_point_of_polygons_and_signed_by_their_sides() {
    let mut random = Random::new(11);
    let (surface, geometry) = laid_out(&plane(16, 0.2));
    for corners in [3, 4, 5, 9, 30] {
        for is_closed in [true, false] {
            let points = star(&mut random, corners);
            let places: Vec<Place> = points.iter().map(|&point| place_at(&surface, point)).collect();
            let curve = through(&geometry, &places, is_closed);
            let (found, with_sign) = (distance(&geometry, from_ref(&curve)), signed(&geometry, &[curve]));
            for vertex in surface.vertices() {
                let (right, is_left) = to_polygon(&points, is_closed, surface.position(vertex).truncate());
                assert!((found[vertex] - right).abs() < ROUNDING, "{} for {right} at {vertex:?}", found[vertex]);
                let right = if is_left { -right } else { right };
                assert!(
                    (with_sign[vertex] - right).abs() < ROUNDING,
                    "{} for {right} at {vertex:?}",
                    with_sign[vertex]
                );
            }
        }
    }
}

#[test]
fn along_the_edges_of_a_grid_as_well() {
    let (surface, geometry) = laid_out(&plane(13, 0.0));
    let points = [(0.25, 0.25), (0.75, 0.25), (0.75, 0.5), (0.5, 0.75), (0.25, 0.75)];
    let places = points.map(|(x, y)| Place::Vertex(nearest(&surface, DVec3::new(x, y, 0.0))));
    let points = places.map(|place| place.position(&surface).truncate());
    let found = signed(&geometry, &[through(&geometry, &places, true)]);
    for vertex in surface.vertices() {
        let (right, is_left) = to_polygon(&points, true, surface.position(vertex).truncate());
        let right = if is_left { -right } else { right };
        assert!((found[vertex] - right).abs() < ROUNDING, "{} for {right} at {vertex:?}", found[vertex]);
    }
}

/// Places along a curve, no farther apart than `spacing`.
fn along(surface: &Surface, curve: &Curve, spacing: f64) -> Vec<Source> {
    let mut sources = Vec::new();
    for line in curve.lines() {
        let parts = (line.length(surface) / spacing).ceil().max(1.0);
        for part in 0..=parts as u32 {
            sources.push(surface.source(line.at(surface, f64::from(part) / parts), 0.0).expect("a place"));
        }
    }
    sources
}

fn assert_as_from_points(soup: &Soup, places: &[Place], is_closed: bool, name: &str) {
    let (surface, geometry) = laid_out(soup);
    let curve = through(&geometry, places, is_closed);
    let front = searched(&geometry, from_ref(&curve), &[]);
    let spacing = curve.length(&surface).expect("its surface") / 2000.0;
    let points = exact_distance(&surface, &along(&surface, &curve, spacing), &mut go_on).expect("points");
    for vertex in surface.vertices() {
        let (found, points) = (front.values()[vertex], points[vertex]);
        if points.is_infinite() {
            assert!(found.is_infinite());
            continue;
        }
        let rounding = 1e-9 * (points + spacing);
        assert!(found <= points + rounding, "{name}: {found} for {points} at {vertex:?}");
        // Straight to the curve from where the shortest path bends last.
        let path = front.path_from_vertex(vertex).expect("a path");
        let bends = path.points.iter().rev().find_map(|point| match point.location {
            Place::Vertex(bend) if front.values()[bend] > 0.0 => Some(front.values()[bend]),
            _ => None,
        });
        let leg = bends.unwrap_or(spacing);
        // Paths to a point of the curve beside it may have to pass a vertex on its other side.
        let most = found - leg + (leg * leg + spacing * spacing).sqrt();
        assert!(points <= most + rounding, "{name}: {found} for {points} at {vertex:?}, {leg} and {spacing}");
    }
}

fn some_places(soup: &Soup, random: &mut Random, count: usize) -> Vec<Place> {
    let surface = surface(soup);
    let place = || {
        let face = FaceId::from_index(random.below(surface.face_count()));
        let [a, b] = [random.share(), random.share()];
        Place::Face { face, weights: [a * b, a * (1.0 - b), 1.0 - a] }
    };
    std::iter::repeat_with(place).take(count).collect()
}

#[test]
fn on_surfaces_as_from_many_points_along_the_curve() {
    let mut random = Random::new(3);
    let torn = Damage { jitter: 0.05, squeeze: 0.4, tear: 0.05 };
    let shapes = [
        ("torus", shapes::torus(1.0, 0.4, 32, 16)),
        ("terrain", shapes::terrain(20)),
        ("bunny-like", shapes::icosphere(3)),
        ("torn", damaged(shapes::torus(1.0, 0.4, 24, 12), 5, torn)),
        ("Möbius strip", band(24, 1)),
        ("book", book(3, 8)),
    ];
    for (name, soup) in shapes {
        let whole = surface(&soup);
        let main = whole.component(VertexId(0));
        for is_closed in [false, true] {
            let mut places = some_places(&soup, &mut random, 24);
            places.retain(|place| place.component(&whole) == main);
            places.truncate(4);
            assert_as_from_points(&soup, &places, is_closed, name);
        }
    }
}

#[test]
fn paths_end_on_the_curve_and_are_as_long_as_the_distance() {
    let mut random = Random::new(8);
    for soup in [shapes::torus(1.0, 0.4, 32, 16), shapes::terrain(16), plane(12, 0.2)] {
        let places = some_places(&soup, &mut random, 3);
        let (surface, geometry) = laid_out(&soup);
        let curve = through(&geometry, &places, true);
        let ends = some_places(&soup, &mut random, 5);
        let front = searched(&geometry, from_ref(&curve), &ends);
        let of_vertices = surface.vertices().map(|vertex| (front.path_from_vertex(vertex), front.values()[vertex]));
        let of_places = (0..ends.len()).map(|place| (front.path_from_target(place), front.target_values()[place]));
        for (path, value) in of_vertices.chain(of_places) {
            let path = path.expect("a path");
            check_valid(&surface, &path);
            assert!((path.length() - value).abs() < 1e-9, "{} for {value}", path.length());
            let end = path.points.last().expect("points").position;
            let is_on = |line: &Line| {
                let [a, b] = line.ends.map(|place| place.position(&surface));
                let share = ((end - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                end.distance(a + share * (b - a)) < 1e-7
            };
            assert!(curve.lines().iter().any(is_on), "{end}");
        }
    }
}

/// On the unit sphere, around the axis at this height over its equator.
const AXIS: DVec3 = DVec3::new(0.36, 0.48, 0.8);
const HEIGHT: f64 = 0.6;

/// So many of forty places of a circle of latitude, counterclockwise around the axis.
fn circle(surface: &Surface, places: u32) -> Vec<Place> {
    let x = AXIS.any_orthonormal_vector();
    let y = AXIS.cross(x);
    let at = |step: u32| {
        let (sin, cos) = (TAU * f64::from(step) / 40.0).sin_cos();
        Place::Vertex(nearest(surface, HEIGHT * AXIS + (1.0 - HEIGHT * HEIGHT).sqrt() * (cos * x + sin * y)))
    };
    (0..places).map(at).collect()
}

/// The share of the vertices beyond a side of the triangles on which the sign is that of the circle, and how it was found.
fn right_share(surface: &Surface, geometry: &Arc<ExactGeometry>, curves: &[Curve], sign: Sign) -> (f64, Sign) {
    let found = signed_curve_distance(geometry, curves, sign, &mut go_on).expect("distance");
    let height = |vertex: VertexId| surface.position(vertex).dot(AXIS) - HEIGHT;
    let far: Vec<VertexId> = surface.vertices().filter(|&vertex| height(vertex).abs() > 0.08).collect();
    let right = far.iter().filter(|&&vertex| (found.values[vertex] < 0.0) == (height(vertex) > 0.0)).count();
    (right as f64 / far.len() as f64, found.sign)
}

#[test]
fn a_circle_of_latitude_has_the_pole_on_its_left_even_if_a_fifth_is_missing() {
    let (surface, geometry) = laid_out(&shapes::icosphere(4));
    let whole = through(&geometry, &circle(&surface, 40), true);
    assert_eq!(right_share(&surface, &geometry, from_ref(&whole), Sign::Auto), (1.0, Sign::Nearest));
    assert_eq!(right_share(&surface, &geometry, &[whole], Sign::Heat), (1.0, Sign::Heat));
    let broken = [through(&geometry, &circle(&surface, 33), false)];
    let (heat, sign) = right_share(&surface, &geometry, &broken, Sign::Auto);
    assert!(heat > 0.99 && sign == Sign::Heat, "{heat}");
    let (nearest, _) = right_share(&surface, &geometry, &broken, Sign::Nearest);
    assert!(nearest < heat, "beyond its ends the nearest point tells less: {nearest} for {heat}");
}

#[test]
fn curves_that_cross_themselves_have_their_sign_by_heat() {
    let (surface, geometry) = laid_out(&plane(12, 0.2));
    let at = |points: &[(f64, f64)]| -> Vec<Place> {
        points.iter().map(|&(x, y)| place_at(&surface, dvec2(x, y))).collect()
    };
    let eight = through(&geometry, &at(&[(0.2, 0.3), (0.8, 0.7), (0.8, 0.3), (0.2, 0.7)]), true);
    let found = signed_curve_distance(&geometry, &[eight], Sign::Auto, &mut go_on).expect("distance");
    assert_eq!(found.sign, Sign::Heat);
    // One half runs counterclockwise, the other clockwise.
    let of = |x: f64, y: f64| found.values[nearest(&surface, DVec3::new(x, y, 0.0))];
    assert!(of(0.72, 0.5) > 0.0 && of(0.28, 0.5) < 0.0 || of(0.72, 0.5) < 0.0 && of(0.28, 0.5) > 0.0);
}

#[test]
fn the_boundary_is_a_curve() {
    let (surface, geometry) = laid_out(&plane(12, 0.2));
    let boundary = Curve::boundary(&surface).expect("a boundary");
    let found = signed(&geometry, &[boundary]);
    for vertex in surface.vertices() {
        let position = surface.position(vertex).truncate();
        let right = position.min_element().min((1.0 - position).min_element());
        assert!((found[vertex] - right).abs() < ROUNDING, "{} for {right}", found[vertex]);
    }
    assert_eq!(Curve::boundary(&self::surface(&shapes::icosphere(1))), None);
}

#[test]
fn what_is_no_curve_is_refused() {
    let (surface, geometry) = laid_out(&two_squares(4).0);
    let places = [VertexId(0), VertexId(1), VertexId(20)];
    let bad = |curve: Result<Curve, Error>, words: &str| {
        let message = curve.expect_err("no curve").to_string();
        assert!(message.contains(words), "{message}");
    };
    bad(Curve::new(&surface, &places[..1], true), "given by 1 place; it must be given by two different places");
    bad(Curve::new(&surface, &[VertexId(3); 3], true), "two different places");
    bad(Curve::new(&surface, &places, false), "place 2 of it");
    let far = VertexId::from_index(surface.vertex_count() - 1);
    assert!(matches!(Curve::through(&geometry, &[VertexId(0), far], false, &mut go_on), Err(Error::Unreachable)));
    assert!(Curve::new(&surface, &[VertexId(0), VertexId(9999)], false).is_err());
    assert!(matches!(curve_distance(&geometry, &[], &mut go_on), Err(Error::NoSource)));

    let curve = through(&geometry, &[Place::Vertex(VertexId(0)), Place::Vertex(VertexId(20))], false);
    let (_, pages) = laid_out(&book(3, 2));
    let spine = through(&pages, &[VertexId(0), VertexId(1), VertexId(5)].map(Place::Vertex), false);
    let refused = signed_curve_distance(&pages, &[spine], Sign::Nearest, &mut go_on).expect_err("no sides").to_string();
    assert!(
        refused.starts_with("a place of the curve is at vertex 0; it must be where the triangles around"),
        "{refused}"
    );
    let (_, other) = laid_out(&shapes::icosphere(5));
    assert!(curve_distance(&other, from_ref(&curve), &mut go_on).is_err());
    let large = through(&other, &[Place::Vertex(VertexId(0)), Place::Vertex(VertexId(1))], false);
    assert!(matches!(curve_distance(&other, &[large], &mut |_, _| ControlFlow::Break(())), Err(Error::Cancelled)));
    let costs: Vec<f64> = (0..surface.face_count()).map(|face| 1.0 + (face % 2) as f64).collect();
    let costs = Costs::new(&surface, costs.into()).expect("costs");
    let weighted = Arc::new(ExactGeometry::new(Arc::clone(&surface)).weighted(&costs));
    assert!(matches!(curve_distance(&weighted, &[curve], &mut go_on), Err(Error::NotExact)));
}

#[test]
fn places_have_the_distance_of_vertices_with_their_sign() {
    let mut random = Random::new(21);
    let soup = plane(10, 0.2);
    let (surface, geometry) = laid_out(&soup);
    let points = star(&mut random, 7);
    let corners: Vec<Place> = points.iter().map(|&point| place_at(&surface, point)).collect();
    let curve = through(&geometry, &corners, true);
    let places = some_places(&soup, &mut random, 200);
    for sign in [Sign::Nearest, Sign::Heat] {
        let found = signed_curve_distance(&geometry, from_ref(&curve), sign, &mut go_on).expect("distances");
        let at = found.at(&geometry, from_ref(&curve), &places, &mut go_on).expect("distances");
        assert_eq!(found.sign, sign);
        for (place, found) in places.iter().zip(at) {
            let (right, is_left) = to_polygon(&points, true, place.position(&surface).truncate());
            let right = if is_left { -right } else { right };
            assert!((found - right).abs() < ROUNDING, "{found} for {right} at {place:?}");
        }
    }
}
