//! Meshes that files should not hold and do: right distances by every method, or an error.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DVec2, DVec3};
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    DistanceOptions, DistanceSolver, Element, Error, InputVertex, Method, PathKind, Soup, Surface, VertexId, go_on,
};

use crate::common::truth::Random;
use crate::common::truth::brute_force::all_distances;
use crate::common::{any_triangles, grid_triangles, quads, soup, square, surface};

/// What rounding may take from a distance, as a share of the largest.
const ROUNDING: f64 = 1e-9;
const METHODS: [Method; 3] = [Method::Exact, Method::Propagation, Method::Heat];

/// Distances of the vertices of the soup.
fn distances(soup: &Soup, from: u32, method: Method) -> Vec<f64> {
    let mut solver = DistanceSolver::new(surface(soup));
    let answer = solver.distance(&[InputVertex(from)], &DistanceOptions::by(method), &mut go_on).expect("a source");
    solver.of_inputs(&answer)
}

/// By every method: right where it is exact, else at most so many times as far, and no nearer: by heat than all but a tenth.
fn check(soup: &Soup, from: u32, right: impl Fn(usize) -> f64, most: f64) {
    let largest = (0..soup.positions.len()).map(&right).filter(|value| value.is_finite()).fold(0.0, f64::max);
    for method in METHODS {
        let [least, most] = match method {
            Method::Exact => [1.0, 1.0],
            Method::Heat => [0.9, most],
            _ => [1.0, most],
        };
        for (vertex, value) in distances(soup, from, method).into_iter().enumerate() {
            let (right, rounding) = (right(vertex), ROUNDING * largest);
            let is_right = value == right || (right * least - rounding..=right * most + rounding).contains(&value);
            assert!(is_right, "{method:?}, vertex {vertex}: {value} for {right}");
        }
    }
}

#[test]
fn what_has_no_triangle_with_area_is_refused() {
    let point = soup(vec![DVec3::splat(3.0); 30], (0..10).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect());
    let line =
        soup((0..30).map(|k| DVec3::splat(f64::from(k))).collect(), (0..28).map(|k| [k, k + 1, k + 2]).collect());
    for soup in [point, line, Soup::default()] {
        assert!(matches!(Surface::build(&soup), Err(SurfaceError::Empty { .. })));
    }
}

#[test]
fn small_and_huge_coordinates_are_measured_or_refused() {
    let sheet = square(3);
    for power in [-120, 149, 151, 300] {
        let scale = 10_f64.powi(power);
        let scaled = soup(sheet.positions.iter().map(|&position| position * scale).collect(), sheet.triangles.clone());
        match Surface::build(&scaled) {
            Ok(_) => check(&scaled, 0, |vertex| sheet.positions[vertex].length() * scale, 1.2),
            Err(error) => assert!(matches!(error, SurfaceError::TooFar { .. } | SurfaceError::Empty { .. }), "{error}"),
        }
    }
}

#[test]
fn needles_of_a_trillionth_are_crossed_straight() {
    let points: Vec<DVec3> = (0..50).map(|k| DVec3::new(f64::from(k % 5), 1e-12 * f64::from(k / 5), 0.0)).collect();
    let needles = soup(points.clone(), quads(0..9, 4, |column, row| 5 * column + row).collect());
    // Along edges it is no farther than twice.
    check(&needles, 12, |vertex| points[vertex].distance(points[12]), 2.0);
}

#[test]
fn ten_thousand_faces_on_an_edge_are_all_across_it() {
    const PAGES: u32 = 10_000;
    let apex = |page: u32| {
        let (sin, cos) = (TAU * f64::from(page) / f64::from(PAGES)).sin_cos();
        DVec3::new(cos, sin, 0.5)
    };
    let positions = [DVec3::ZERO, DVec3::Z].into_iter().chain((0..PAGES).map(apex)).collect();
    let book = soup(positions, (2..PAGES + 2).map(|page| [0, 1, page]).collect());
    // Straight across the middle of the edge, which is as high as the apexes.
    let right = |vertex: usize| match vertex {
        0 | 1 => 1.25_f64.sqrt(),
        2 => 0.0,
        _ => 2.0,
    };
    check(&book, 2, right, 1.2);
}

/// A figure of eight that turns over on its way around: closed, of one side, through itself.
fn klein_bottle(around: u32, across: u32) -> Soup {
    let place = |u: u32, v: u32| {
        let (u, v) = (TAU * f64::from(u) / f64::from(around), TAU * f64::from(v) / f64::from(across));
        let (half, sin, twice) = (0.5 * u, v.sin(), (2.0 * v).sin());
        let radius = 3.0 + half.cos() * sin - half.sin() * twice;
        DVec3::new(radius * u.cos(), radius * u.sin(), half.sin() * sin + half.cos() * twice)
    };
    let positions = (0..around).flat_map(|u| (0..across).map(move |v| place(u, v))).collect();
    let vertex = |u: u32, v: u32| {
        // Half a turn puts the circle on itself from the other side.
        let v = if u == around { across - v % across } else { v };
        (u % around) * across + v % across
    };
    soup(positions, quads(0..around, across, vertex).collect())
}

#[test]
fn a_klein_bottle_has_the_distances_of_its_triangles() {
    let bottle = klein_bottle(9, 6);
    let built = surface(&bottle);
    let report = built.report();
    assert_eq!((report.euler_characteristic, report.boundary_loops, report.components), (0, 0, 1));
    assert!(!built.is_oriented_manifold());
    let right = all_distances(&bottle.positions, &bottle.triangles);
    for from in [0, 20] {
        // So coarse, heat is off by a third.
        check(&bottle, from, |vertex| right[from as usize][vertex], 1.35);
    }
}

#[test]
fn of_ten_thousand_components_the_others_are_infinitely_far() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let positions = (0..10_000).flat_map(|k| corners.map(|corner| corner + 3.0 * DVec3::Z * f64::from(k))).collect();
    let many = soup(positions, (0..10_000).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect());
    let right = |vertex: usize| if vertex < 3 { corners[vertex].length() } else { f64::INFINITY };
    check(&many, 0, right, 1.0);
}

#[test]
fn thousands_of_holes_leave_the_straight_lines_between_them() {
    const HOLES: u32 = 64;
    let side = 2 * HOLES + 1;
    let vertex = |column: u32, row: u32| column * (side + 1) + row;
    let positions = (0..=side).flat_map(|x| (0..=side).map(move |y| DVec3::new(x.into(), y.into(), 0.0))).collect();
    let is_hole = |column: u32, row: u32| column % 2 == 1 && row % 2 == 1;
    let cells = (0..side).flat_map(|column| (0..side).map(move |row| (column, row)));
    let cells = cells.filter(|&(column, row)| !is_hole(column, row));
    let triangles = cells.flat_map(|(column, row)| quads(column..column + 1, 1, move |c, r| vertex(c, row + r)));
    let sieve = soup(positions, triangles.collect());
    assert_eq!(surface(&sieve).report().boundary_loops, (HOLES * HOLES + 1) as usize);
    for method in [Method::Exact, Method::Propagation] {
        let values = distances(&sieve, 0, method);
        for along in 0..=side {
            for at in [vertex(0, along), vertex(along, 0)] {
                let value = values[at as usize];
                assert!((value - f64::from(along)).abs() <= ROUNDING * f64::from(side), "{method:?}: {value}");
            }
        }
    }
}

#[test]
fn a_sheet_folded_through_itself_has_its_distances_when_flat() {
    const SIDE: u32 = 12;
    // Each fold turns by more than a half, so that every leaf goes through those before.
    let mut profile = vec![DVec2::ZERO];
    for leaf in 0..SIDE {
        let angle = 2.5 * f64::from(leaf);
        profile.push(profile[leaf as usize] + DVec2::new(angle.cos(), angle.sin()));
    }
    let places = || (0..=SIDE as usize).flat_map(|leaf| (0..=SIDE).map(move |y| (leaf, f64::from(y))));
    let folded = places().map(|(leaf, y)| DVec3::new(profile[leaf].x, y, profile[leaf].y)).collect();
    let flat: Vec<DVec2> = places().map(|(leaf, y)| DVec2::new(leaf as f64, y)).collect();
    check(&soup(folded, grid_triangles(0, SIDE).collect()), 30, |vertex| flat[vertex].distance(flat[30]), 1.1);
}

#[test]
fn layers_that_nearly_coincide_are_apart_but_where_they_are_joined() {
    const SIDE: u32 = 8;
    for gap in [1e-3, 1e-9, 1e-14] {
        // A sheet folded flat onto itself: from the one layer to the other it is around the fold.
        let along = |column: u32| f64::from(column.min(2 * SIDE - column));
        let height = |column: u32| if column > SIDE { gap } else { 0.0 };
        let places = || (0..=2 * SIDE).flat_map(|column| (0..=SIDE).map(move |row| (column, row)));
        let positions = places().map(|(column, row)| DVec3::new(along(column), row.into(), height(column))).collect();
        let flat: Vec<DVec2> = places().map(|(column, row)| DVec2::new(column.into(), row.into())).collect();
        let folded = soup(positions, quads(0..2 * SIDE, SIDE, |column, row| column * (SIDE + 1) + row).collect());
        // The fold is longer by the gap.
        for method in METHODS {
            let far = distances(&folded, 0, method)[flat.len() - SIDE as usize - 1];
            let right = f64::from(2 * SIDE);
            assert!((0.9 * right..=1.1 * right + gap).contains(&far), "{method:?} at {gap}: {far}");
        }
    }
}

/// Random triangles between places of a lattice, stretched and moved by parts of nothing.
fn hostile(random: &mut Random) -> Soup {
    let mut any = any_triangles(4 + random.below(12), random);
    let powers = [0, 0, -12, -6, 3];
    let stretch = [(); 3].map(|()| 10_f64.powi(powers[random.below(powers.len())]));
    for position in &mut any.positions {
        *position = (*position * 6.0).round() * DVec3::from(stretch);
        if random.chance(0.1) {
            *position += DVec3::splat(1e-12) * random.point();
        }
        if random.chance(0.01) {
            *position *= f64::NAN;
        }
    }
    any
}

#[test]
fn any_triangles_have_distances_and_paths_or_an_error() {
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let soup = hostile(&mut random);
        let surface = match Surface::build(&soup) {
            Ok(surface) => Arc::new(surface),
            Err(SurfaceError::Empty { .. } | SurfaceError::NotFinite { .. }) => continue,
            Err(error) => panic!("seed {seed}: {error}"),
        };
        let [source, start] = [(); 2].map(|()| VertexId::from_index(random.below(surface.vertex_count())));
        for method in METHODS {
            let mut solver = DistanceSolver::new(Arc::clone(&surface));
            let answer = solver.distance(&[source], &DistanceOptions::by(method), &mut go_on).expect("a source");
            for vertex in surface.vertices() {
                let value = answer.distance.values[vertex];
                let is_reached = surface.component(vertex) == surface.component(source);
                assert!(value >= 0.0 && value.is_finite() == is_reached, "seed {seed}, {method:?}: {value}");
            }
            match solver.path(&answer, start, PathKind::Straightened) {
                Ok(path) => {
                    let end = path.points[path.points.len() - 1].position;
                    assert_eq!(end, surface.position(source), "seed {seed}, {method:?}");
                    assert!(path.length().is_finite(), "seed {seed}, {method:?}");
                }
                Err(error) => assert_eq!(error, Error::Unreachable, "seed {seed}, {method:?}"),
            }
        }
    }
}
