//! Strips of what is flat once it is cut open have the areas and edge lengths of the surface in the plane.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};
use heatwalk_curves::{Error, Field, Isolines, Levels, Sheet, Strips};
use heatwalk_surface::Soup;

use super::{area, field, plane_area, tube};

/// A number between −1 and 1 for each place, as rounding might give.
fn noise(position: DVec3) -> f64 {
    (position.dot(DVec3::new(127.1, 311.7, 74.7)).sin() * 43_758.547).fract()
}

/// Quads between rings of places: so many rings of so many, closed around, without those quads that `is_open` names.
fn rings(around: u32, count: u32, place: impl Fn(u32, f64) -> DVec3, is_open: impl Fn(u32, u32) -> bool) -> Soup {
    let positions =
        (0..count).flat_map(|ring| (0..around).map(move |index| (ring, TAU * f64::from(index) / f64::from(around))));
    let positions = positions.map(|(ring, angle)| place(ring, angle)).collect();
    let mut triangles = Vec::new();
    for (ring, index) in (0..count - 1).flat_map(|ring| (0..around).map(move |index| (ring, index))) {
        if !is_open(ring, index) {
            let [a, b] = [index, (index + 1) % around].map(|index| ring * around + index);
            triangles.extend([[a, b, b + around], [a, b + around, a + around]]);
        }
    }
    Soup::single("rings", positions, triangles)
}

/// The length of all loops.
fn outline(loops: &[Vec<DVec2>]) -> f64 {
    let of = |points: &Vec<DVec2>| {
        let next = |index: usize| points[(index + 1) % points.len()];
        points.iter().enumerate().map(|(index, point)| point.distance(next(index))).sum::<f64>()
    };
    loops.iter().map(of).sum()
}

/// The length of the edges of one triangle of a strip.
fn rim(strips: &Strips, strip: usize) -> f64 {
    let triangles = &strips.triangles[strips.ranges[strip].clone()];
    let sides = || triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let key = |[a, b]: [u32; 2]| (a.min(b), a.max(b));
    let mut edges: Vec<(u32, u32)> = sides().map(key).collect();
    edges.sort_unstable();
    let alone = edges.chunk_by(|a, b| a == b).filter(|group| group.len() == 1);
    let position = |vertex: u32| strips.positions[vertex as usize];
    alone.map(|group| position(group[0].0).distance(position(group[0].1))).sum()
}

/// Unrolls all strips and checks that each has one shape of its area, with so many loops, and edges longer than its own by two
/// sides of cuts of this length in all.
fn check(field: &Field, levels: &[f64], expected: impl Fn(usize) -> (usize, f64)) -> Sheet {
    let strips = Strips::cut(field, &Levels::at(levels).unwrap()).unwrap();
    let sheet = Sheet::unroll(field, &strips).unwrap();
    assert_eq!(sheet.left_out, []);
    let drawn: Vec<usize> = sheet.planes.iter().map(|plane| plane.strip).collect();
    assert_eq!(drawn, (0..=levels.len()).filter(|&strip| !strips.ranges[strip].is_empty()).collect::<Vec<_>>());
    for plane in &sheet.planes {
        let (loops, cuts) = expected(plane.strip);
        assert_eq!(plane.loops.len(), loops, "loops of strip {}", plane.strip);
        let whole = area(&strips.positions, &strips.triangles[strips.ranges[plane.strip].clone()]);
        let drawn = plane_area(&plane.loops);
        assert!((drawn / whole - 1.0).abs() < 1e-9, "area of strip {}: {drawn} of {whole}", plane.strip);
        let edges = rim(&strips, plane.strip) + 2.0 * cuts;
        let around = outline(&plane.loops);
        assert!((around / edges - 1.0).abs() < 1e-9, "edges of strip {}: {around} of {edges}", plane.strip);
    }
    sheet
}

#[test]
fn rings_of_a_tube_unroll_where_vertices_are_at_the_levels_up_to_rounding() {
    // As 64 bits have distances of 100: a few units in the last place from the rows of vertices.
    let field = field(&tube(96, 40, 100.0), |position| position.z + 4e-14 * noise(position));
    let sheet = check(&field, &[10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0], |_| (1, 10.0));
    // A straight cut makes rectangles.
    for plane in &sheet.planes {
        let high = plane.loops[0].iter().copied().reduce(DVec2::max).unwrap();
        let low = plane.loops[0].iter().copied().reduce(DVec2::min).unwrap();
        let box_area = (high - low).element_product();
        assert!((box_area / plane_area(&plane.loops) - 1.0).abs() < 1e-9, "strip {} fills its box", plane.strip);
    }
}

#[test]
fn rings_unroll_however_near_their_rims_are_to_vertices() {
    // More than what is taken for rounding, and much less than a triangle: far from the origin, as in map coordinates, what the
    // isoline cuts off there has no angles in 64 bits.
    let far = 1e5;
    for distance in [2e-10, 1e-9, 1e-6, 1e-3] {
        let mut soup = tube(96, 40, 100.0);
        soup.positions.iter_mut().for_each(|position| *position += far);
        let field = field(&soup, |position| position.z - far + distance * (1.5 + noise(position)));
        let strips = Strips::cut(&field, &Levels::at(&[10.0, 20.0]).unwrap()).unwrap();
        let sheet = Sheet::unroll(&field, &strips).unwrap();
        assert_eq!((sheet.planes.len(), sheet.left_out.len()), (3, 0), "{distance}");
        for plane in &sheet.planes {
            let whole = area(&strips.positions, &strips.triangles[strips.ranges[plane.strip].clone()]);
            assert!((plane_area(&plane.loops) / whole - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn nothing_lies_beyond_the_largest_distance() {
    let field = field(&tube(96, 40, 100.0), |position| position.z + 4e-14 * noise(position));
    let girth = 2.0 * 96.0 * (PI / 96.0).sin();
    assert!(field.largest() > 100.0);
    let at_rim = Levels::at(&[50.0, 100.0]).unwrap();
    let [_, isoline] = &Isolines::trace(&field, &at_rim).isolines[..] else { panic!("two levels") };
    let [curve] = &isoline.curves[..] else { panic!("one curve along the rim, not {}", isoline.curves.len()) };
    assert!(curve.is_closed && (curve.length - girth).abs() < 1e-9);
    assert!((isoline.enclosed_area - 100.0 * girth).abs() < 1e-9);
    let strips = Strips::cut(&field, &at_rim).unwrap();
    assert!(strips.ranges[2].is_empty());
    assert_eq!(Sheet::unroll(&field, &strips).unwrap().planes.len(), 2);
    assert_eq!(Levels::spaced(50.0, field.largest()).unwrap().values(), [50.0]);
    assert!(matches!(Levels::spaced(100.0, field.largest()), Err(Error::NoLevel { .. })));
}

#[test]
fn a_flat_ring_is_not_cut() {
    // Tilted, so that positions are rounded.
    let tilt = glam::DQuat::from_rotation_x(0.7);
    let soup = rings(
        30,
        9,
        |ring, angle| tilt * (DVec2::from_angle(angle).extend(0.0) * (1.0 + 0.25 * f64::from(ring))),
        |_, _| false,
    );
    check(&field(&soup, |position| position.length()), &[1.6, 2.1], |_| (2, 0.0));
}

#[test]
fn a_plane_with_holes_keeps_them() {
    let soup = heatwalk_shapes::grid(12, 12);
    let Soup { positions, triangles, .. } = soup;
    let center = |corners: &[u32; 3]| corners.iter().map(|&corner| positions[corner as usize]).sum::<DVec3>() / 3.0;
    let is_in = |point: DVec3, x: f64, y: f64| (point.x - x).abs() < 1.0 / 12.0 && (point.z + y).abs() < 1.0 / 12.0;
    let holes = [(0.25, 0.25), (0.25, 0.75), (0.75, 0.5)];
    let is_kept = |corners: &[u32; 3]| !holes.iter().any(|&(x, y)| is_in(center(corners), x, y));
    let triangles: Vec<[u32; 3]> = triangles.iter().copied().filter(is_kept).collect();
    let soup = Soup::single("holes", positions, triangles);
    check(&field(&soup, |position| position.x), &[0.52], |strip| ([3, 2][strip], 0.0));
}

#[test]
fn a_ring_of_a_cone_unrolls_to_its_sector() {
    let (around, slant) = (40, 2.0);
    // Slant 2 for a radius of 1: half a disc, of facets.
    let place = |ring: u32, angle: f64| {
        let radius = 1.0 + 0.2 * f64::from(ring);
        DVec3::new(radius * angle.cos(), radius * angle.sin(), -radius * 3.0_f64.sqrt())
    };
    let soup = rings(around, 6, place, |_, _| false);
    let field = field(&soup, |position| slant * position.truncate().length());
    let sheet = check(&field, &[2.5, 3.1], |strip| (1, [0.5, 0.6, 0.9][strip]));
    // Sides of the cut meet at this angle.
    let sector = f64::from(around) * 2.0 * (0.5 * (PI / f64::from(around)).sin()).asin();
    for plane in &sheet.planes {
        let points = &plane.loops[0];
        let step = |index: usize| points[(index + 1) % points.len()] - points[index];
        let turn = |index: usize| step(index).angle_to(step((index + 1) % points.len()));
        let sharp: Vec<usize> = (0..points.len()).filter(|&index| turn(index) > 1.0).collect();
        assert_eq!(sharp.len(), 4, "four corners of strip {}", plane.strip);
        let along = |from: usize, to: usize| (points[(to) % points.len()] - points[from]).normalize();
        let corners: Vec<usize> = sharp.iter().map(|&index| (index + 1) % points.len()).collect();
        let sides: Vec<DVec2> = (0..4).map(|k| along(corners[k], corners[(k + 1) % 4])).collect();
        let angle = [0, 1].map(|k| sides[k].angle_to(-sides[k + 2]).abs());
        assert!(angle.iter().any(|angle| (angle - sector).abs() < 1e-9), "{angle:?} of {sector}");
    }
}

#[test]
fn a_ring_of_more_than_a_turn_is_cut_though_its_ends_meet() {
    // Two turns of a flat ring, joined: a saddle's surroundings, of quads that have their lengths on a wave around the axis.
    let angles = |index: f64| DVec2::from_angle(index);
    let around = 24;
    let place = |ring: u32, angle: f64| (angles(2.0 * angle) * (1.0 + f64::from(ring))).extend(0.0);
    let soup = rings(around, 3, place, |_, _| false);
    let triangles = soup.triangles.clone();
    let distances = soup.positions.iter().map(|position| position.length()).collect();
    let field = Field::new(soup.positions, triangles, distances).unwrap();
    check(&field, &[1.7], |strip| (1, [0.7, 1.3][strip]));
}

#[test]
fn a_tube_with_windows_is_cut_from_rim_to_rim_alone() {
    let place = |ring: u32, angle: f64| DVec3::new(angle.cos(), angle.sin(), 0.5 * f64::from(ring));
    // Away from the seam, two in the lower half and one in the upper.
    let is_open = |ring: u32, index: u32| (index % 12 == 6 && ring == 2) || (index == 15 && ring == 7);
    let soup = rings(24, 11, place, is_open);
    let field = field(&soup, |position| position.z);
    let strips = Strips::cut(&field, &Levels::at(&[2.6]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&field, &strips).unwrap();
    assert_eq!(sheet.left_out, []);
    for plane in &sheet.planes {
        let whole = area(&strips.positions, &strips.triangles[strips.ranges[plane.strip].clone()]);
        assert!((plane_area(&plane.loops) / whole - 1.0).abs() < 1e-9);
        // A cut that leads through a window takes its loop into the outline, and is as long as what is left of it.
        let cut = 0.5 * (outline(&plane.loops) - rim(&strips, plane.strip));
        assert!(cut < 2.6 && cut > 2.4 - 0.5 - 1e-9, "strip {}: {cut}", plane.strip);
    }
    assert_eq!(sheet.planes.iter().map(|plane| plane.loops.len()).sum::<usize>(), 2 + 3 - 2);
}

#[test]
fn strips_of_a_moebius_band_are_in_one_piece() {
    // Quads around a circle with half a twist, one across: no vertex is inside, so that all is flat.
    let segments = 40;
    let place = |segment: u32, across: f64| {
        let angle = TAU * f64::from(segment) / f64::from(segments);
        let (sin, cos) = (0.5 * angle).sin_cos();
        let radius = 2.0 + across * sin;
        DVec3::new(radius * angle.cos(), radius * angle.sin(), across * cos)
    };
    let positions: Vec<DVec3> =
        (0..segments).flat_map(|segment| [-0.5, 0.5].map(|across| place(segment, across))).collect();
    let vertex = |segment: u32, row: u32| if segment == segments { 1 - row } else { 2 * segment + row };
    let quad = |segment: u32| {
        let [a, b, c, d] = [vertex(segment, 0), vertex(segment + 1, 0), vertex(segment + 1, 1), vertex(segment, 1)];
        [[a, b, c], [a, c, d]]
    };
    let soup = Soup::single("band", positions, (0..segments).flat_map(quad).collect());
    // Away from one side of a place of the band: two strips that lead around it, one that does not.
    let whole = field(&soup, |position| position.x + 3.0);
    let strips = Strips::cut(&whole, &Levels::at(&[1.2]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&whole, &strips).unwrap();
    assert_eq!(sheet.left_out, []);
    assert_eq!(sheet.planes.iter().map(|plane| plane.strip).collect::<Vec<_>>(), [0, 1]);
    // One strip that is all of the band: one cut across it.
    check(&whole, &[9.0], |_| (1, 1.0));
    let drawn: f64 = sheet.planes.iter().map(|plane| plane_area(&plane.loops)).sum();
    assert!((drawn / area(&strips.positions, &strips.triangles) - 1.0).abs() < 1e-9);
}

#[test]
fn a_farthest_place_that_is_the_tip_of_a_cone_is_cut_open_to_the_rim() {
    let (around, slant) = (12, 2.0_f64.sqrt());
    let mut soup = rings(
        around,
        3,
        |ring, angle| {
            let radius = 1.0 + f64::from(ring);
            DVec3::new(radius * angle.cos(), radius * angle.sin(), -radius)
        },
        |_, _| false,
    );
    let tip = soup.positions.len() as u32;
    soup.positions.push(DVec3::ZERO);
    let facets: Vec<[u32; 3]> = (0..around).map(|index| [index, (index + 1) % around, tip]).collect();
    let soup = Soup::single("cone", soup.positions, [soup.triangles, facets].concat());
    // From its rim.
    let field = field(&soup, |position| slant * (3.0 - position.truncate().length()));
    check(&field, &[1.5 * slant], |_| (1, 1.5 * slant));
}

#[test]
fn each_component_is_a_shape_and_the_curved_one_is_named() {
    let Soup { positions, triangles, .. } = tube(16, 4, 4.0);
    let ball = heatwalk_shapes::icosphere(2);
    let first = positions.len() as u32;
    let both: Vec<DVec3> = positions
        .into_iter()
        .chain(ball.positions.iter().map(|&position| position + 5.0 * DVec3::X + DVec3::Z))
        .collect();
    let faces = triangles.into_iter().chain(ball.triangles.iter().map(|corners| corners.map(|corner| corner + first)));
    let soup = Soup::single("both", both, faces.collect());
    let field = field(&soup, |position| position.z);
    let strips = Strips::cut(&field, &Levels::at(&[2.5]).unwrap()).unwrap();
    let sheet = Sheet::unroll(&field, &strips).unwrap();
    assert_eq!(sheet.planes.iter().map(|plane| plane.strip).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(sheet.strips_left_out(), [0]);
}
