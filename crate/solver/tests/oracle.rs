//! Brute force, by which the other tests measure, against closed forms.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::truth::brute_force::all_distances;
use crate::common::{band, book, flat, grid_triangles};
use glam::{DQuat, DVec2, DVec3};

/// What coordinates and lengths as 64-bit floats lose, as a share of the largest distance.
const ROUNDING: f64 = 1e-15;

fn check(positions: &[DVec3], triangles: &[[u32; 3]], right: impl Fn(usize, usize) -> f64) {
    let distances = all_distances(positions, triangles);
    let largest = distances.iter().flatten().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    for (from, row) in distances.iter().enumerate() {
        for (to, &value) in row.iter().enumerate() {
            let right = right(from, to);
            let is_right = value == right || (value - right).abs() <= ROUNDING * largest;
            assert!(is_right, "from {from} to {to}: {value} for {right}");
        }
    }
}

fn turned(positions: &mut [DVec3]) {
    let turn = DQuat::from_euler(glam::EulerRot::XYZ, 0.4, -1.1, 2.0);
    positions.iter_mut().for_each(|position| *position = turn * *position);
}

#[test]
fn flat_and_convex_is_straight() {
    for squeeze in [1.0, 1e-3, 1e-8, 1e-14] {
        // The diagonals of a grid are grazed by as many straight lines as can be.
        let mut points = flat(&(0..25).map(|k| (f64::from(k % 5), squeeze * f64::from(k / 5))).collect::<Vec<_>>());
        let triangles: Vec<_> = grid_triangles(0, 4).collect();
        check(&points, &triangles, |from, to| points[from].distance(points[to]));
        turned(&mut points);
        check(&points, &triangles, |from, to| points[from].distance(points[to]));
    }
}

#[test]
fn triangles_of_no_area_join_their_sides() {
    // A T-junction: the long side of the one triangle is two of the others'.
    let positions = flat(&[(0.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, -1.0), (0.5, 1.0), (1.5, 1.0)]);
    let triangles = [[0, 1, 2], [0, 3, 1], [0, 2, 4], [2, 5, 4], [2, 1, 5]];
    let distances = all_distances(&positions, &triangles);
    for (from, to) in [(3, 2), (3, 4), (3, 5), (2, 3), (5, 3), (0, 1)] {
        assert_eq!(distances[from][to], positions[from].distance(positions[to]), "from {from} to {to}");
    }
}

#[test]
fn boxes_are_crossed_by_the_shortest_net() {
    for size in [DVec3::ONE, DVec3::new(1.0, 1.0, 2.0), DVec3::new(1.0, 2.0, 1e-6), DVec3::new(3.0, 1e-4, 5.0)] {
        let corner = |k: u32| size * DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2));
        let positions: Vec<DVec3> = (0..8).map(corner).collect();
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles: Vec<[u32; 3]> = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let across = |[a, b, c]: [f64; 3]| [(a, b, c), (b, c, a), (c, a, b)].map(|(a, b, c)| (a + b).hypot(c));
        let opposite = across(size.to_array()).into_iter().fold(f64::INFINITY, f64::min);
        check(&positions, &triangles, |from, to| match from ^ to {
            7 => opposite,
            _ => positions[from].distance(positions[to]),
        });
    }
}

#[test]
fn tetrahedra_tile_the_plane() {
    // Corners of a regular tetrahedron of side 2, and the middles of its sides.
    let corners = [DVec3::ONE, DVec3::new(1.0, -1.0, -1.0), DVec3::new(-1.0, 1.0, -1.0), DVec3::new(-1.0, -1.0, 1.0)];
    let corners = corners.map(|corner| corner / 2_f64.sqrt());
    let sides = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    let positions: Vec<DVec3> =
        corners.into_iter().chain(sides.map(|[a, b]| 0.5 * (corners[a] + corners[b]))).collect();
    let middle = |a: usize, b: usize| 4 + sides.iter().position(|&side| side == [a.min(b), a.max(b)]).expect("a side");
    let mut triangles = Vec::new();
    for [a, b, c] in [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]] {
        let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
        triangles.extend([[a, x, z], [x, b, y], [z, y, c], [x, y, z]].map(|face| face.map(|vertex| vertex as u32)));
    }
    // Where corners and middles lie in the unrolled plane, in coordinates along two sides of length 1.
    let unrolled = [[0, 0], [2, 0], [0, 2], [2, 2], [1, 0], [0, 1], [1, -1], [1, 1], [2, 1], [1, 2]];
    let place = |[i, j]: [i32; 2]| DVec2::new(f64::from(i) + 0.5 * f64::from(j), 0.75_f64.sqrt() * f64::from(j));
    check(&positions, &triangles, |from, to| {
        let mut least = f64::INFINITY;
        // Half turns about corners, and so shifts by two sides, map the tiling to itself.
        for sign in [1, -1] {
            for shift in (-3..=3).flat_map(|i| (-3..=3).map(move |j| [4 * i, 4 * j])) {
                let image = [0, 1].map(|k| sign * unrolled[to][k] + shift[k]);
                least = least.min(place(image).distance(place(unrolled[from])));
            }
        }
        least
    });
}

#[test]
fn pages_of_a_book_are_half_planes() {
    let soup = book(3, 2);
    // Each page brings its own spine.
    let mut triangles = soup.triangles.clone();
    for triangle in &mut triangles {
        for vertex in triangle {
            if *vertex % 9 < 3 {
                *vertex %= 9;
            }
        }
    }
    let unrolled = |vertex: usize, side: f64| {
        let position = soup.positions[vertex];
        DVec2::new(side * position.truncate().length(), position.z)
    };
    let is_used = |vertex: usize| vertex < 9 || vertex % 9 >= 3;
    check(&soup.positions, &triangles, |from, to| {
        let side = if from / 9 == to / 9 || from < 3 || to < 3 { 1.0 } else { -1.0 };
        match (from == to, is_used(from) && is_used(to)) {
            (true, _) => 0.0,
            (false, true) => unrolled(from, 1.0).distance(unrolled(to, side)),
            (false, false) => f64::INFINITY,
        }
    });
}

#[test]
fn bands_are_unrolled_and_components_stay_apart() {
    let mut soup = band(6, 0);
    let chord = soup.positions[0].distance(soup.positions[5]);
    let count = soup.positions.len();
    soup.positions.extend([DVec3::ZERO, DVec3::X, DVec3::Y]);
    soup.triangles.push([0, 1, 2].map(|corner| corner + count as u32));
    check(&soup.positions, &soup.triangles, |from, to| {
        if from == to {
            return 0.0;
        }
        if from >= count || to >= count {
            return if from >= count && to >= count {
                soup.positions[from].distance(soup.positions[to])
            } else {
                f64::INFINITY
            };
        }
        let around = (from / 5).abs_diff(to / 5);
        let across = (from % 5).abs_diff(to % 5) as f64 / 4.0;
        (chord * around.min(6 - around) as f64).hypot(across)
    });
}
