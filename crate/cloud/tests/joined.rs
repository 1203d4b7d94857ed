//! Surfaces of the vertices of shapes alone: complete, and with the distances that the shapes have.

use std::f64::consts::PI;
use std::num::NonZeroUsize;
use std::sync::Arc;

use glam::{DVec3, Vec3, dvec3};
use heatwalk::exact::exact_distance;
use heatwalk::{InputVertex, RelativeError, Soup, Surface, go_on};
use heatwalk_cloud::{Cloud, Error, join, read_within};
use heatwalk_model::io::Budget;
use heatwalk_shapes as shapes;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

fn joined(points: &[DVec3]) -> Cloud {
    Cloud::join("cloud", points.to_vec(), NonZeroUsize::MIN).expect("a surface")
}

/// Exact distances of all points from the first.
fn distances(soup: &Soup) -> Vec<f64> {
    let surface = Arc::new(Surface::build(soup).expect("a surface"));
    let distances = exact_distance(&surface, &[InputVertex(0)], &mut go_on).expect("distances");
    surface.to_inputs(&distances, f64::INFINITY)
}

/// Joins the vertices of a shape. Returns the mean relative error of distances on what was made, against those on the shape.
fn mean_error(shape: &Soup, loops: usize) -> f64 {
    let cloud = joined(&shape.positions);
    assert_eq!((cloud.report.unjoined_points, cloud.report.boundary_loops), (0, loops), "{}", cloud.report);
    assert_eq!(cloud.soup.positions, shape.positions);
    let surface = Surface::build(&cloud.soup).expect("a surface");
    assert!(surface.is_oriented_manifold() && surface.report().flipped_faces == 0);
    let known = Surface::build(shape).expect("a surface");
    assert_eq!(surface.report().euler_characteristic, known.report().euler_characteristic);
    RelativeError::between(&distances(&cloud.soup), &distances(shape)).mean
}

/// Each point moved by less than this share of `spacing` along each axis.
fn noisy(points: &[DVec3], spacing: f64, share: f64) -> Vec<DVec3> {
    let mut random = SplitMix64::seed_from_u64(5);
    let mut move_by = || (2.0 * random.random::<f64>() - 1.0) * share * spacing;
    points.iter().map(|&point| point + dvec3(move_by(), move_by(), move_by())).collect()
}

/// Of the points `(i, j)` of a square grid those that are chosen, lifted.
fn sheet(cells: i32, chosen: impl Fn(i32, i32) -> bool, height: impl Fn(f64, f64) -> f64) -> Vec<DVec3> {
    let places = (0..=cells).flat_map(|i| (0..=cells).map(move |j| (i, j))).filter(|&(i, j)| chosen(i, j));
    let at = |(i, j)| [f64::from(i), f64::from(j)].map(|x| x / f64::from(cells));
    places.map(at).map(|[x, y]| dvec3(x, y, height(x, y))).collect()
}

#[test]
fn vertices_of_closed_shapes_alone_have_their_surface_and_distances() {
    // That triangles are not those of the shape, on quads and elsewhere, is all the difference.
    for (shape, most) in
        [(shapes::icosphere(4), 1e-3), (shapes::torus(1.0, 0.4, 60, 24), 3e-3), (shapes::ring(0.05), 3e-3)]
    {
        let error = mean_error(&shape, 0);
        assert!(error < most, "{error} on {}", shape.parts[0].name);
    }
}

#[test]
fn on_parts_as_thin_as_points_are_apart_all_are_joined_though_holes_may_remain() {
    for shape in [shapes::animal(0.05), shapes::horse(0.03), shapes::high_genus(0.08)] {
        let cloud = joined(&shape.positions);
        let name = &shape.parts[0].name;
        assert_eq!(cloud.report.unjoined_points, 0, "{name}: {}", cloud.report);
        let error = RelativeError::between(&distances(&cloud.soup), &distances(&shape)).mean;
        assert!(error < 5e-3, "{error} on {name}");
    }
}

#[test]
fn where_a_surface_ends_its_cloud_ends() {
    assert!(mean_error(&shapes::hemisphere(24).select(&[0]).expect("the dome"), 1) < 1e-3);
    // A hole wider than some spacings stays one.
    let ring = sheet(30, |i, j| (i - 15).pow(2) + (j - 15).pow(2) > 50, |_, _| 0.0);
    let cloud = joined(&ring);
    assert_eq!(cloud.report.boundary_loops, 2, "{} of {}", cloud.report, ring.len());
}

#[test]
fn a_grid_in_a_plane_is_a_square_though_four_points_each_lie_on_a_circle() {
    let points = sheet(20, |_, _| true, |_, _| 0.0);
    let cloud = joined(&points);
    assert_eq!((cloud.report.triangles, cloud.report.boundary_loops, cloud.report.unjoined_points), (800, 1, 0));
    for (&point, distance) in points.iter().zip(distances(&cloud.soup)) {
        assert!((distance - point.distance(points[0])).abs() < 1e-12);
    }
    // So few that all are on the boundary.
    for cells in [1, 2] {
        let cloud = joined(&sheet(cells, |_, _| true, |_, _| 0.0));
        assert_eq!((cloud.report.triangles, cloud.report.boundary_loops), (2 * (cells * cells) as usize, 1));
    }
    let triangle = joined(&[DVec3::ZERO, DVec3::X, DVec3::Y]);
    assert_eq!(triangle.report.triangles, 1);
}

#[test]
fn noise_of_a_fifth_of_the_spacing_leaves_no_hole() {
    let shape = shapes::icosphere(4);
    let spacing = Surface::build(&shape).expect("a surface").mean_edge();
    let cloud = joined(&noisy(&shape.positions, spacing, 0.2));
    assert_eq!((cloud.report.unjoined_points, cloud.report.boundary_loops), (0, 0), "{}", cloud.report);
    let error = RelativeError::between(&distances(&cloud.soup), &distances(&shape)).mean;
    // Of the noise itself: a rough surface has longer paths.
    assert!(error < 0.02, "{error}");
}

#[test]
fn a_half_that_is_thinned_to_a_ninth_is_joined_to_the_other() {
    let height = |x: f64, y: f64| 0.1 * (5.0 * x).sin() * (4.0 * y).cos();
    let points = sheet(60, |i, j| i <= 30 || (i % 3 == 0 && j % 3 == 0), height);
    let cloud = joined(&points);
    assert_eq!((cloud.report.unjoined_points, cloud.report.boundary_loops), (0, 1), "{}", cloud.report);
    assert_eq!(Surface::build(&cloud.soup).expect("a surface").report().euler_characteristic, 1);
}

#[test]
fn two_sheets_three_spacings_apart_stay_apart() {
    let height = |x: f64, y: f64| 0.1 * (3.0 * x).sin() * (4.0 * y).cos();
    let lower = sheet(40, |_, _| true, height);
    let upper = lower.iter().map(|&point| point + DVec3::Z * (3.0 / 40.0));
    let cloud = joined(&lower.iter().copied().chain(upper).collect::<Vec<_>>());
    assert_eq!((cloud.report.unjoined_points, cloud.report.boundary_loops), (0, 2), "{}", cloud.report);
    assert_eq!(Surface::build(&cloud.soup).expect("a surface").report().components, 2);
}

#[test]
fn points_of_one_place_are_one_and_those_that_are_nowhere_are_on_no_triangle() {
    let shape = shapes::icosphere(3);
    let mut points = shape.positions.clone();
    points.extend([points[3], points[3], points[7], DVec3::NAN, dvec3(f64::INFINITY, 0.0, 0.0)]);
    let cloud = joined(&points);
    assert_eq!((cloud.report.points, cloud.report.unjoined_points), (points.len(), 2));
    let found = distances(&cloud.soup);
    let [first, rest] = [&found[..shape.positions.len()], &found[shape.positions.len()..]];
    assert_eq!(rest, [first[3], first[3], first[7], f64::INFINITY, f64::INFINITY]);
    // What is far from all others is on none either, and nothing leads there.
    points.truncate(shape.positions.len());
    points.push(DVec3::splat(40.0));
    let cloud = joined(&points);
    assert_eq!(cloud.report.unjoined_points, 1, "{}", cloud.report);
    assert!(distances(&cloud.soup).last().is_some_and(|distance| distance.is_infinite()));
}

#[test]
fn any_points_at_all_are_joined_or_refused_and_what_is_joined_has_distances() {
    let mut random = SplitMix64::seed_from_u64(9);
    for round in 0..3000 {
        let count = 3 + round % 60;
        // On few places, so that many points are of one, on one line or in one plane.
        let few = 2 + round % 7;
        let mut coordinate = || f64::from((random.random::<f64>() * few as f64) as u32) * 0.5;
        let points: Vec<DVec3> = (0..count).map(|_| dvec3(coordinate(), coordinate(), coordinate())).collect();
        match Cloud::join("cloud", points, NonZeroUsize::MIN) {
            Ok(cloud) => {
                let joined = count - cloud.report.unjoined_points;
                let surface = Arc::new(Surface::build(&cloud.soup).expect("a surface"));
                assert_eq!(surface.vertices_of_inputs().iter().flatten().count(), joined, "{}", cloud.report);
                assert!(surface.report().non_manifold_edges == 0);
            }
            Err(error) => assert!(matches!(error, Error::TooFew { .. } | Error::Line { .. }), "{error}"),
        }
    }
}

#[test]
fn what_is_no_surface_is_refused() {
    let refused = |points: Vec<DVec3>| Cloud::join("cloud", points, NonZeroUsize::MIN).expect_err("no surface");
    assert_eq!(refused(Vec::new()), Error::TooFew { points: 0, different: 0 });
    assert_eq!(refused(vec![DVec3::X]), Error::TooFew { points: 1, different: 1 });
    assert_eq!(refused(vec![DVec3::X; 50]), Error::TooFew { points: 50, different: 1 });
    assert_eq!(refused(vec![DVec3::NAN; 9]), Error::TooFew { points: 9, different: 0 });
    for step in [dvec3(1.0, 0.0, 0.0), dvec3(0.3, -0.1, 0.7)] {
        for count in [3, 100] {
            let line = (0..count).map(|k| dvec3(5.0, 6.0, 7.0) + step * f64::from(k)).collect();
            let error = refused(line);
            assert_eq!(error, Error::Line { points: count as usize });
            assert!(error.to_string().contains("lie on lines"));
        }
    }
}

#[test]
fn size_and_threads_change_nothing() {
    let shape = shapes::torus(1.0, 0.4, 120, 48);
    let own = joined(&shape.positions);
    let several = Cloud::join("cloud", shape.positions.clone(), NonZeroUsize::new(3).expect("three"));
    assert_eq!(several.expect("a surface").soup, own.soup);
    for size in [1e-9, 1e9] {
        let scaled = joined(&shape.positions.iter().map(|&point| size * point).collect::<Vec<_>>());
        assert_eq!(scaled.report, own.report, "{size}");
    }
    let far = joined(&shape.positions.iter().map(|&point| point + DVec3::splat(1e5)).collect::<Vec<_>>());
    assert_eq!((far.report.unjoined_points, far.report.boundary_loops), (0, 0));
}

#[test]
fn random_points_on_a_sphere_are_joined_to_one() {
    let mut random = SplitMix64::seed_from_u64(3);
    let mut share = || 2.0 * random.random::<f64>() - 1.0;
    let points: Vec<DVec3> = (0..4000)
        .map(|_| {
            let (z, angle) = (share(), PI * share());
            let out = (1.0 - z * z).sqrt();
            dvec3(out * angle.cos(), out * angle.sin(), z)
        })
        .collect();
    let cloud = joined(&points);
    assert_eq!((cloud.report.unjoined_points, cloud.report.boundary_loops), (0, 0), "{}", cloud.report);
    let known: Vec<f64> = points.iter().map(|point| point.angle_between(points[0])).collect();
    let error = RelativeError::between(&distances(&cloud.soup), &known).mean;
    // Chords are shorter than arcs.
    assert!(error < 0.01, "{error}");
}

/// A plate with points on both sides, so many spacings thick, round at its rim, and the normals there.
fn plate(cells: i32, thickness: f64) -> (Vec<DVec3>, Vec<DVec3>) {
    let side = |sign: f64| {
        let points = sheet(cells, |_, _| true, |_, _| 0.0);
        points.into_iter().map(move |point| {
            let middle = dvec3(0.5, 0.5, 0.0);
            let is_rim = (point - middle).abs().max_element() > 0.5 - 1e-9;
            let aside = if is_rim { (point - middle).normalize() } else { DVec3::ZERO };
            let lift = 0.5 * sign * thickness / f64::from(cells);
            (point + dvec3(0.0, 0.0, lift), (aside + sign * DVec3::Z).normalize())
        })
    };
    side(1.0).chain(side(-1.0)).unzip()
}

#[test]
fn normals_tell_the_sides_of_what_is_thinner_than_points_are_apart() {
    let (points, normals) = plate(20, 0.5);
    let threads = NonZeroUsize::MIN;
    let cloud = Cloud::join_oriented("plate", points.clone(), &normals, threads).expect("a surface");
    assert_eq!((cloud.report.unjoined_points, cloud.report.boundary_loops), (0, 0), "{}", cloud.report);
    let surface = Surface::build(&cloud.soup).expect("a surface");
    assert_eq!((surface.report().euler_characteristic, surface.report().flipped_faces), (2, 0));
    // No way leads through the plate.
    let middle = 10 * 21 + 10;
    let surface = Arc::new(surface);
    let distances = exact_distance(&surface, &[InputVertex(middle)], &mut go_on).expect("distances");
    let around = surface.to_inputs(&distances, f64::INFINITY)[21 * 21 + middle as usize];
    assert!((around - 1.025).abs() < 0.01, "{around}");
    // Turned inward, they turn the surface inside out.
    let inward: Vec<DVec3> = normals.iter().map(|&normal| -2.0 * normal).collect();
    let turned = Cloud::join_oriented("plate", points.clone(), &inward, threads).expect("a surface");
    let volume = |soup: &Soup| -> f64 {
        let six = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|vertex| soup.positions[vertex as usize]);
            a.dot(b.cross(c))
        };
        soup.triangles.iter().map(six).sum::<f64>() / 6.0
    };
    assert!((volume(&cloud.soup) - 0.025).abs() < 1e-3, "{}", volume(&cloud.soup));
    assert!((volume(&turned.soup) + 0.025).abs() < 1e-3, "{}", volume(&turned.soup));
    // Without them, sides are mixed.
    let mixed = joined(&points);
    assert!((volume(&mixed.soup) - 0.025).abs() > 1e-3 || mixed.report.boundary_loops > 0, "{}", mixed.report);
    // None known is as none given.
    let unknown = Cloud::join_oriented("plate", points, &vec![DVec3::ZERO; normals.len()], threads).expect("a surface");
    assert_eq!(unknown.soup, Soup { parts: unknown.soup.parts.clone(), ..mixed.soup });
}

#[test]
fn normals_of_a_file_are_those_of_points_alone() {
    let file = |faces: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n\
             property float ny\nproperty float nz\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n\
             0 0 0 0 0 -2\n1 0 0 0 0 -1\n1 1 0 0 0 -1\n0 1 0 0 0 -1\n{faces}",
            faces.lines().count()
        )
    };
    let read = |name: &str, text: &str| {
        let budget = Budget::of_file(text.len());
        read_within(&budget, name, text.as_bytes(), &|_| None).expect("a model")
    };
    let mut cloud = read("a.ply", &file(""));
    assert_eq!(cloud.appearance.normals, [-Vec3::Z; 4]);
    let mut text = read("a.xyz", "0 0 0 0 0 -1\n1 0 0 0 0 -1\n1 1 0 0 0 -1\n0 1 0 0 0 -1\n");
    assert_eq!(text.appearance.normals, [-Vec3::Z; 4]);
    for model in [&mut cloud, &mut text] {
        let report = join("a", model, NonZeroUsize::MIN).expect("a surface").expect("of points");
        assert_eq!((report.triangles, report.boundary_loops), (2, 1));
        for corners in &model.soup.triangles {
            let [a, b, c] = corners.map(|vertex| model.soup.positions[vertex as usize]);
            assert!((b - a).cross(c - a).z < 0.0, "the file says that below is outside");
        }
    }
    let mut mesh = read("a.ply", &file("4 0 1 2 3\n"));
    assert!(mesh.appearance.normals.is_empty());
    assert_eq!(join("a", &mut mesh, NonZeroUsize::MIN).expect("a mesh"), None);
}
