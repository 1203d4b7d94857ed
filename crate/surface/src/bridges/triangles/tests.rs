//! Pairs of triangles, random and degenerate, against a search by ever finer samples.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use super::*;
use crate::triangle;

/// Corners in a cube of side 3, or on whole numbers in one of side 2: there, sides are parallel, meet and lie in one plane.
fn random_triangle(random: &mut SplitMix64, is_whole: bool) -> Triangle {
    loop {
        let corners = [(); 3].map(|()| {
            let corner = DVec3::from_array(random.random());
            if is_whole { (2.0 * corner).round() } else { 3.0 * corner }
        });
        if triangle::length(area_vector(corners)) > 0.01 {
            return corners;
        }
    }
}

/// The least distance that is found by samples around the best pair of samples before. Distance is convex, so that it ends up
/// near the least one there is.
fn sampled_distance(triangles: &[Triangle; 2]) -> f64 {
    let weights = |[u, v]: [f64; 2]| [1.0 - u - v, u, v];
    let is_inside = |&[u, v]: &[f64; 2]| u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    let distance = |places: [[f64; 2]; 2]| {
        point(&triangles[0], weights(places[0])).distance(point(&triangles[1], weights(places[1])))
    };
    let mut best = [[1.0 / 3.0; 2]; 2];
    let mut step = 0.25;
    while step > 1e-4 {
        let around = |[u, v]: [f64; 2]| {
            let offsets = (-2..=2).flat_map(|i| (-2..=2).map(move |j| [f64::from(i), f64::from(j)]));
            offsets.map(move |[i, j]| [u + i * step, v + j * step]).filter(is_inside).collect::<Vec<_>>()
        };
        let [first, second] = best.map(around);
        let pairs = first.iter().flat_map(|&a| second.iter().map(move |&b| [a, b]));
        let next = pairs.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).expect("the best before");
        if distance(next) >= 0.999 * distance(best) {
            step *= 0.5;
        }
        best = next;
    }
    distance(best)
}

fn assert_inside(weights: [f64; 3]) {
    assert!(weights.iter().all(|&weight| weight >= 0.0), "{weights:?}");
    assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-14, "{weights:?}");
}

#[test]
fn the_distance_is_that_of_samples() {
    let mut random = SplitMix64::seed_from_u64(1);
    let (mut crossings, mut touching, mut apart, mut beyond) = (0, 0, 0, 0);
    for number in 0..120 {
        let is_whole = number % 2 == 1;
        let triangles = [(); 2].map(|()| random_triangle(&mut random, is_whole));
        let sampled = sampled_distance(&triangles);
        let pair = nearest(&triangles, [Features::ALL; 2], f64::INFINITY, 0.0).expect("a pair");
        pair.weights.into_iter().for_each(assert_inside);
        let between = point(&triangles[0], pair.weights[0]).distance(point(&triangles[1], pair.weights[1]));
        assert_eq!(pair.distance, between);
        let does_cross = crossing(&triangles).is_some();
        let distance = if does_cross { 0.0 } else { pair.distance };
        assert!(sampled >= distance - 1e-12 && sampled <= distance + 0.01, "{sampled} {distance} {triangles:?}");
        let normals = triangles.map(|corners| triangle::unit(area_vector(corners)));
        let apart_by = |within: f64| separation([&triangles[0], &triangles[1]], normals, within);
        let Separation { least, is_by_plane } = apart_by(distance + 1e-12).expect("no more than the distance");
        assert!(least <= distance + 1e-12);
        assert!(least == 0.0 || apart_by(0.9 * least).is_none());
        assert!(!(does_cross && is_by_plane));
        apart += u32::from(distance > 0.1 && least > 0.9 * distance);
        beyond += u32::from(least > 0.1 && !is_by_plane);
        // What is left out for being too far leaves the nearest points.
        if !does_cross {
            let again = nearest(&triangles, [Features::ALL; 2], distance + 1e-12, 0.0).expect("the pair");
            assert!((again.distance - distance).abs() <= 1e-12, "{} {distance}", again.distance);
            let nearer = nearest(&triangles, [Features::ALL; 2], 0.999 * distance, 0.0);
            assert!(nearer.is_none_or(|pair| pair.distance < 1e-12));
        }
        crossings += u32::from(does_cross);
        touching += u32::from(!does_cross && distance < 1e-12);
    }
    assert!((20..100).contains(&crossings) && touching > 0, "{crossings} {touching}");
    // Bounds are of use, and so are those beyond sides, where planes tell nothing.
    assert!(apart > 10 && beyond > 0, "{apart} {beyond}");
}

#[test]
fn crossings_end_where_a_side_meets_a_triangle() {
    let ground = [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(0.0, 4.0, 0.0)];
    let upright = [DVec3::new(1.0, -1.0, -1.0), DVec3::new(1.0, 5.0, -1.0), DVec3::new(1.0, 2.0, 2.0)];
    let ends = crossing(&[ground, upright]).expect("they cross");
    for end in ends {
        end.into_iter().for_each(assert_inside);
        assert!(point(&ground, end[0]).distance(point(&upright, end[1])) < 1e-14);
    }
    let mut along = ends.map(|end| point(&ground, end[0]));
    along.sort_by(|a, b| a.y.total_cmp(&b.y));
    assert!(
        along[0].distance(DVec3::new(1.0, 0.0, 0.0)) < 1e-14 && along[1].distance(DVec3::new(1.0, 3.0, 0.0)) < 1e-14
    );
    let above = upright.map(|corner| corner + DVec3::Z * 1.001);
    assert_eq!(crossing(&[ground, above]), None);
    assert_eq!(crossing(&[ground, ground.map(|corner| corner + DVec3::X)]), None);
}

#[test]
fn points_are_spread_over_an_overlap() {
    const SPACING: f64 = 0.05;
    let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let other = triangle.map(|corner| DVec3::new(0.8 - corner.x, 0.7 - corner.y, 0.01));
    let mut found = Vec::new();
    spread(&[triangle, other], [Features::ALL; 2], 0.011, SPACING, &mut |pair| found.push(pair));
    assert!(found.iter().all(|pair| pair.distance >= 0.01 - 1e-14 && pair.distance <= 0.011));
    let places: Vec<DVec3> = found.iter().map(|pair| point(&triangle, pair.weights[0])).collect();
    let farthest = |x: f64, y: f64| {
        let place = DVec3::new(x, y, 0.0);
        places.iter().map(|&other| other.distance(place)).fold(f64::INFINITY, f64::min)
    };
    // The overlap is the rectangle 0.8 by 0.7 less a triangle at two of its corners.
    for i in 0..=40 {
        for j in 0..=40 {
            let (x, y) = (0.8 * f64::from(i) / 40.0, 0.7 * f64::from(j) / 40.0);
            if !(0.5..=1.0).contains(&(x + y)) {
                continue;
            }
            let is_rim = i == 0 || j == 0 || i == 40 || j == 40;
            let most = if is_rim { 0.5 * SPACING } else { INNER_SPACING * SPACING };
            assert!(farthest(x, y) <= most, "{} at {x} {y}", farthest(x, y));
        }
    }
}
