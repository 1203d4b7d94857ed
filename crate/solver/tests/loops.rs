//! Loops through places, tightened and around handles.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::{PI, TAU};

use glam::{DVec3, dvec3};
use heatwalk::exact::exact_distance;
use heatwalk::{
    Error, FaceId, Path, Place, Soup, Surface, VertexId, closed_geodesic, edge_polyline, geodesic_loop, go_on,
    handle_loops,
};
use heatwalk_shapes as shapes;

use crate::common::searches::geometry;
use crate::common::shortness::{check_valid, largest_kink, sharpest_turn};
use crate::common::truth::Random;
use crate::common::{band, nearest, quads, square, surface, two_squares};
use crate::straighten::cube;

/// Checks all that must hold of a closed geodesic, where it begins as well.
fn check_closed(surface: &Surface, path: &Path) {
    check_valid(surface, path);
    let [first, last] = [path.points[0], path.points[path.points.len() - 1]];
    assert!(first.position.distance(last.position) <= 1e-12 * surface.mean_edge());
    let twice = [&path.points[..path.points.len() - 1], &path.points].concat();
    let twice = Path::new(surface, twice);
    // As of straightened paths.
    let turn = sharpest_turn(surface, &twice);
    assert!(turn >= PI - 1e-6, "a turn short of π by {:e}", PI - turn);
    let kink = largest_kink(surface, &twice);
    assert!(kink < 1e-6, "a kink of {kink:e}");
}

/// Along edges through these places and back.
fn around(surface: &Surface, places: &[DVec3]) -> Path {
    let through: Vec<VertexId> = places.iter().map(|&place| nearest(surface, place)).collect();
    let mut line = edge_polyline(surface, &through, true).expect("one component");
    line.push(line[0]);
    Path::along_edges(surface, &line).expect("edges")
}

/// On the torus of radii 1 and 0.4: around the axis and around the tube.
fn on_torus(around: f64, tube: f64) -> DVec3 {
    let out = 1.0 + 0.4 * tube.cos();
    dvec3(out * around.cos(), 0.4 * tube.sin(), out * around.sin())
}

#[test]
fn on_a_torus_the_loops_of_the_handle_are_the_inner_equator_and_a_meridian() {
    let (rings, sides) = (72, 30);
    let surface = surface(&shapes::torus(1.0, 0.4, rings, sides));
    let loops = handle_loops(&surface, &mut go_on).expect("loops");
    assert_eq!(loops.len(), 2);
    loops.iter().for_each(|path| check_closed(&surface, path));
    let polygon = |count: u32, radius: f64| 2.0 * f64::from(count) * radius * (PI / f64::from(count)).sin();
    // In planes between those of the vertices the tube is narrower by this.
    let narrower = (PI / f64::from(rings)).cos();
    let meridian = loops[0].length();
    assert!((narrower * polygon(sides, 0.4)..=polygon(sides, 0.4) + 1e-12).contains(&meridian), "{meridian}");
    assert!((meridian - TAU * 0.4).abs() < 0.01);
    let equator = loops[1].length();
    assert!((equator - polygon(rings, 0.6)).abs() < 1e-12, "{equator}");
    assert!((equator - TAU * 0.6).abs() < 0.01);
}

#[test]
fn any_closed_walk_on_a_torus_tightens_to_a_closed_geodesic_of_its_class() {
    let surface = surface(&shapes::torus(1.0, 0.4, 36, 16));
    let third = TAU / 3.0;
    for start in 0..12 {
        let start = 0.5 * f64::from(start);
        let outside = [0.0, third, 2.0 * third].map(|step| on_torus(start + step, 0.3));
        let equator = closed_geodesic(&surface, &around(&surface, &outside)).expect("a loop");
        check_closed(&surface, &equator);
        assert!((equator.length() - TAU * 0.6).abs() < 0.03, "{}", equator.length());
        let meridian = [0.0, third, 2.0 * third].map(|step| on_torus(start, start + step));
        let meridian = closed_geodesic(&surface, &around(&surface, &meridian)).expect("a loop");
        check_closed(&surface, &meridian);
        assert!((meridian.length() - TAU * 0.4).abs() < 0.03, "{}", meridian.length());
    }
}

#[test]
fn any_closed_walk_anywhere_tightens_to_a_closed_geodesic_or_to_nothing() {
    let mut random = Random::new(12);
    let mut kept = 0;
    for soup in [shapes::torus(1.0, 0.4, 9, 5), double_torus(), band(7, 1), frustum(3), frustum(5)] {
        let flat = surface(&soup);
        for _ in 0..30 {
            let mut jitter = || 0.2 * (random.share() - 0.5);
            let moved = flat.positions().iter().map(|&position| position + dvec3(jitter(), jitter(), jitter()));
            let surface = flat.posed(moved.collect());
            let places: Vec<DVec3> =
                (0..4).map(|_| surface.position(VertexId(random.below(surface.vertex_count()) as u32))).collect();
            let walk = around(&surface, &places);
            match walk.is_closed(&surface).then(|| closed_geodesic(&surface, &walk)) {
                None => {}
                Some(Err(error)) => assert_eq!(error, Error::Contractible),
                Some(Ok(path)) => {
                    kept += 1;
                    check_closed(&surface, &path);
                    assert!(path.length() <= walk.length());
                }
            }
        }
    }
    assert!(kept > 30, "{kept}");
}

/// A pyramid of so many sides without its base and without its top, the upper rim half as wide as the lower one.
fn frustum(sides: u32) -> Soup {
    let rows = 3;
    let at = |row: u32, side: u32| {
        let (sin, cos) = (TAU * f64::from(side) / f64::from(sides)).sin_cos();
        let up = f64::from(row) / f64::from(rows);
        dvec3(cos * (2.0 - up), sin * (2.0 - up), 3.0 * up)
    };
    let positions = (0..=rows).flat_map(|row| (0..sides).map(move |side| at(row, side))).collect();
    let quads = quads(0..rows, sides, |row, side| row * sides + side % sides);
    Soup::single("frustum", positions, quads.collect())
}

#[test]
fn around_a_frustum_it_slides_to_the_narrow_rim() {
    for sides in [3, 4, 7] {
        let surface = surface(&frustum(sides));
        let lower: Vec<DVec3> = (0..sides).map(|side| surface.position(VertexId(side))).collect();
        let path = closed_geodesic(&surface, &around(&surface, &lower)).expect("a loop");
        check_closed(&surface, &path);
        let rim = 2.0 * f64::from(sides) * (PI / f64::from(sides)).sin();
        assert!((path.length() - rim).abs() < 1e-12, "{} for {rim}", path.length());
    }
}

#[test]
fn loops_of_several_handles_are_independent_two_each() {
    for (soup, handles) in [(shapes::high_genus(0.065), None), (double_torus(), Some(2))] {
        let surface = surface(&soup);
        let loops = handle_loops(&surface, &mut go_on).expect("loops");
        let expected = 2 - surface.report().euler_characteristic;
        assert_eq!(loops.len() as i64, expected);
        assert!(handles.is_none_or(|handles| 2 * handles == expected));
        loops.iter().for_each(|path| check_closed(&surface, path));
        assert!(loops.is_sorted_by(|a, b| a.length() <= b.length()));
    }
}

/// Seven cubes by five, with two holes of two cubes each.
fn double_torus() -> Soup {
    let is_full = |x: i32, y: i32, z: i32| {
        (0..7).contains(&x) && (0..5).contains(&y) && z == 0 && !(y == 2 && (x == 1 || x == 2 || x == 4 || x == 5))
    };
    let mut positions: Vec<DVec3> = Vec::new();
    let mut triangles = Vec::new();
    for (x, y) in (0..7).flat_map(|x| (0..5).map(move |y| (x, y))).filter(|&(x, y)| is_full(x, y, 0)) {
        for (axis, step) in (0..3).flat_map(|axis| [(axis, -1), (axis, 1)]) {
            let mut beside = [x, y, 0];
            beside[axis] += step;
            if is_full(beside[0], beside[1], beside[2]) {
                continue;
            }
            let first = positions.len() as u32;
            for corner in [[0, 0], [1, 0], [1, 1], [0, 1]] {
                let mut at = [x, y, 0].map(f64::from);
                at[axis] += f64::from((step + 1) / 2);
                at[(axis + 1) % 3] += f64::from(corner[0]);
                at[(axis + 2) % 3] += f64::from(corner[1]);
                positions.push(DVec3::from_array(at));
            }
            let [a, b] = if step > 0 { [1, 2] } else { [2, 1] };
            triangles.push([first, first + a, first + b]);
            let [a, b] = if step > 0 { [2, 3] } else { [3, 2] };
            triangles.push([first, first + a, first + b]);
        }
    }
    Soup::single("double torus", positions, triangles)
}

#[test]
fn around_a_cube_through_the_middles_of_its_sides_it_is_four_sides_long() {
    let surface = std::sync::Arc::new(surface(&cube(4)));
    let middles = [[1.0, 0.5], [0.5, 1.0], [0.0, 0.5], [0.5, 0.0]];
    let middles = middles.map(|[x, y]| nearest(&surface, dvec3(x, y, 0.5)));
    let held = geodesic_loop(&geometry(&surface), &middles, &mut go_on).expect("a loop");
    check_valid(&surface, &held);
    assert!((held.length() - 4.0).abs() < 1e-12, "{}", held.length());
    let free = closed_geodesic(&surface, &held).expect("closed");
    check_closed(&surface, &free);
    assert!((free.length() - 4.0).abs() < 1e-12, "{}", free.length());
    // Through no vertex it is as long.
    let side = |axis: DVec3| {
        let is_there = |face: &FaceId| {
            let [a, b, c] = surface.corners(*face);
            let middle = (a + b + c) / 3.0;
            ((middle - 0.5).dot(axis) - 0.5).abs() < 1e-9 && (middle.z - 0.6).abs() < 0.1
        };
        surface.faces().ids().find(is_there).map(|face| Place::Face { face, weights: [0.3, 0.4, 0.3] })
    };
    let places = [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y].map(|axis| side(axis).expect("a face"));
    let held = geodesic_loop(&geometry(&surface), &places, &mut go_on).expect("a loop");
    assert!(held.length() > 4.0 + 1e-6);
    let free = closed_geodesic(&surface, &held).expect("closed");
    check_closed(&surface, &free);
    assert!((free.length() - 4.0).abs() < 1e-12, "{}", free.length());
}

#[test]
fn through_places_it_is_held_there_and_free_it_is_not() {
    let surface = std::sync::Arc::new(surface(&shapes::torus(1.0, 0.4, 36, 16)));
    let geometry = geometry(&surface);
    let places = [0.0, 2.0, 4.0].map(|around| nearest(&surface, on_torus(around, 0.1)));
    let held = geodesic_loop(&geometry, &places, &mut go_on).expect("a loop");
    check_valid(&surface, &held);
    let first = exact_distance(&surface, &places[..1], &mut go_on).expect("distances");
    let second = exact_distance(&surface, &places[1..2], &mut go_on).expect("distances");
    let sum = first[places[1]] + second[places[2]] + first[places[2]];
    assert!((held.length() - sum).abs() < 1e-12, "{} for {sum}", held.length());
    for place in places {
        assert!(held.points.iter().any(|point| point.location == Place::Vertex(place)));
    }
    // Places that are given twice are one.
    let twice = [places[0], places[0], places[1], places[2], places[2], places[0]];
    let again = geodesic_loop(&geometry, &twice, &mut go_on).expect("a loop");
    assert_eq!(again.points, held.points);
    assert!(closed_geodesic(&surface, &held).expect("closed").length() < held.length() - 0.1);
}

#[test]
fn through_one_place_it_is_the_shortest_that_goes_around_something() {
    let surface = std::sync::Arc::new(surface(&shapes::torus(1.0, 0.4, 36, 16)));
    let geometry = geometry(&surface);
    let mut random = Random::new(4);
    for _ in 0..8 {
        let face = FaceId(random.below(surface.face_count()) as u32);
        let place = Place::Face { face, weights: [0.2, 0.3, 0.5] };
        let path = geodesic_loop(&geometry, &[place], &mut go_on).expect("a loop");
        check_valid(&surface, &path);
        assert!(path.points[0].location == place && path.points[path.points.len() - 1].location == place);
        // Around the tube, which is nowhere longer than around the hole.
        assert!((path.length() - TAU * 0.4).abs() < 0.03, "{}", path.length());
    }
    // Through two places opposite each other, and half around.
    let ends = [nearest(&surface, on_torus(1.0, 0.0)), nearest(&surface, on_torus(1.0, PI))];
    let both = geodesic_loop(&geometry, &ends, &mut go_on).expect("a loop");
    assert!((both.length() - TAU * 0.4).abs() < 0.03, "{}", both.length());
    assert!(both.points.iter().any(|point| point.location == Place::Vertex(ends[1])));
}

#[test]
fn a_hole_is_gone_around_by_loops_but_is_no_handle() {
    let surface = std::sync::Arc::new(surface(&band(20, 0)));
    assert!(handle_loops(&surface, &mut go_on).expect("none").is_empty());
    let path = geodesic_loop(&geometry(&surface), &[VertexId(0)], &mut go_on).expect("a loop");
    check_valid(&surface, &path);
    // The regular polygon of twenty sides in the circle of radius 2.
    let polygon = 80.0 * (PI / 20.0).sin();
    assert!((path.length() - polygon).abs() < 1e-12, "{}", path.length());
    check_closed(&surface, &closed_geodesic(&surface, &path).expect("closed"));
}

#[test]
fn a_möbius_strip_has_a_loop_though_it_has_one_side() {
    let surface = surface(&band(20, 1));
    let through: Vec<DVec3> = (0..4).map(|quarter| surface.position(VertexId(25 * quarter + 1))).collect();
    let once = closed_geodesic(&surface, &around(&surface, &through)).expect("a loop");
    check_closed(&surface, &once);
    assert!(once.length() < 4.0 * PI, "{}", once.length());
    let twice = closed_geodesic(&surface, &around(&surface, &[through.as_slice(), &through].concat()));
    let twice = twice.expect("a loop");
    check_closed(&surface, &twice);
    assert!(twice.length() <= 2.0 * once.length() + 1e-9, "{}", twice.length());
}

#[test]
fn what_shrinks_to_a_point_is_told_and_so_is_what_is_no_loop() {
    let sphere = std::sync::Arc::new(surface(&shapes::icosphere(3)));
    let of_sphere = geometry(&sphere);
    assert!(handle_loops(&sphere, &mut go_on).expect("none").is_empty());
    let places = [dvec3(0.9, 0.3, 0.1), dvec3(0.8, 0.1, 0.5), dvec3(0.7, 0.6, 0.4)].map(|at| nearest(&sphere, at));
    let held = geodesic_loop(&of_sphere, &places, &mut go_on).expect("held by three places");
    assert!(held.length() > 0.5);
    let free = closed_geodesic(&sphere, &held).expect_err("a point");
    assert!(free == Error::Contractible && free.to_string().contains("shrinks to a point"), "{free}");
    for count in [1, 2] {
        assert_eq!(geodesic_loop(&of_sphere, &places[..count], &mut go_on), Err(Error::Contractible));
    }
    let flat = std::sync::Arc::new(surface(&square(5)));
    assert_eq!(geodesic_loop(&geometry(&flat), &[VertexId(0)], &mut go_on), Err(Error::Contractible));
    let none: [VertexId; 0] = [];
    assert_eq!(geodesic_loop(&of_sphere, &none, &mut go_on), Err(Error::NoSource));
    let open = Path::along_edges(&sphere, &edge_polyline(&sphere, &places, false).expect("a line")).expect("edges");
    assert!(closed_geodesic(&sphere, &open).expect_err("open").to_string().contains("curve is open"));
    let apart = std::sync::Arc::new(surface(&two_squares(3).0));
    let last = VertexId(apart.vertex_count() as u32 - 1);
    let places = [VertexId(0), VertexId(2), last];
    assert_eq!(geodesic_loop(&geometry(&apart), &places, &mut go_on), Err(Error::Unreachable));
}
