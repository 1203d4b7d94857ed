//! The log map and parallel transport, against closed forms and exact paths.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DQuat, DVec2, DVec3, dvec2, dvec3};
use heatwalk::exact::{ExactGeometry, PlaceDistances, Wavefront};
use heatwalk::heat::VectorHeat;
use heatwalk::{
    Bridges, Costs, Element, Error, FaceId, HalfedgeId, LogMap, LogMapSearch, Place, Portal, Soup, Surface, ToPoint,
    VertexId, Windows, go_on, log_map, propagated_log_map, transport,
};
use heatwalk_shapes as shapes;

use crate::common::searches::geometry;
use crate::common::truth::Random;
use crate::common::{band, book, meshes, nearest, soup, square, surface, two_squares};

/// Rounding of lines through some dozens of faces of unit size.
const ROUNDING: f64 = 1e-9;

fn laid_out(soup: &Soup) -> (Arc<Surface>, Arc<ExactGeometry>) {
    let surface = Arc::new(surface(soup));
    (Arc::clone(&surface), geometry(&surface))
}

fn mapped(geometry: &Arc<ExactGeometry>, source: impl ToPoint, direction: Option<DVec3>) -> LogMap {
    log_map(geometry, source, direction, &mut go_on).expect("a log map")
}

/// A square of which vertices have moved inside, without the quarter where x and y are beyond 0.5, if so wished.
fn plane(is_whole: bool) -> Soup {
    let mut soup = square(10);
    let mut random = Random::new(5);
    let is_inside = |x: f64| (0.01..0.99).contains(&x) && (x - 0.5).abs() > 0.01;
    for position in soup.positions.iter_mut().filter(|position| is_inside(position.x) && is_inside(position.y)) {
        *position += 0.01 * dvec3(random.share(), random.share(), 0.0);
    }
    let positions = &soup.positions;
    let middle = |face: &[u32; 3]| face.iter().map(|&corner| positions[corner as usize]).sum::<DVec3>() / 3.0;
    let kept = soup.triangles.iter().copied().filter(|face| is_whole || middle(face).truncate().min_element() < 0.5);
    self::soup(positions.clone(), kept.collect())
}

/// A vertex inside and one at a corner of the square, an edge inside and one of the boundary, and a face.
fn places(surface: &Surface) -> Vec<Place> {
    let at = |x: f64, y: f64| nearest(surface, dvec3(x, y, 0.0));
    let boundary = surface.mesh().halfedge_of_face(surface.mesh().boundary_loops().next().expect("a boundary"));
    vec![
        Place::Vertex(at(0.3, 0.4)),
        Place::Vertex(at(0.0, 0.0)),
        Place::Vertex(at(0.0, 0.5)),
        Place::Edge { halfedge: HalfedgeId(77), fraction: 0.3 },
        Place::Edge { halfedge: boundary, fraction: 0.6 },
        Place::Face { face: FaceId(60), weights: [0.2, 0.3, 0.5] },
    ]
}

#[test]
fn on_a_plane_the_log_map_is_where_vertices_lie() {
    let (surface, geometry) = laid_out(&plane(true));
    for place in places(&surface) {
        let from = place.position(&surface);
        let map = mapped(&geometry, place, None);
        let turned = mapped(&geometry, place, Some(dvec3(3.0, 4.0, 5.0)));
        assert!(map.axes[0].distance(DVec3::X) < ROUNDING && map.axes[1].distance(DVec3::Y) < ROUNDING);
        for vertex in surface.vertices() {
            let expected = (surface.position(vertex) - from).truncate();
            assert!(map.coordinates[vertex].distance(expected) < ROUNDING, "{place:?} {vertex:?}");
            let expected = dvec2(0.6, -0.8).rotate(expected);
            assert!(turned.coordinates[vertex].distance(expected) < ROUNDING, "{place:?} {vertex:?}");
            assert!((map.distances[vertex] - expected.length()).abs() < ROUNDING);
        }
    }
}

#[test]
fn on_a_plane_vectors_stay_the_same_around_corners_too() {
    for is_whole in [true, false] {
        let (surface, geometry) = laid_out(&plane(is_whole));
        let vector = dvec3(0.5, -2.0, 0.0);
        for place in places(&surface) {
            let carried = transport(&geometry, &[(place, vector + DVec3::Z)], &mut go_on).expect("vectors");
            assert!(surface.vertices().all(|vertex| carried[vertex].distance(vector) < ROUNDING), "{place:?}");
        }
    }
}

#[test]
fn behind_a_corner_the_log_map_keeps_the_direction_towards_it() {
    let (surface, geometry) = laid_out(&plane(false));
    let corner = DVec2::splat(0.5);
    let source = nearest(&surface, dvec3(0.3, 0.9, 0.0));
    let from = surface.position(source).truncate();
    let map = mapped(&geometry, source, None);
    let mut hidden = 0;
    for vertex in surface.vertices() {
        let to = surface.position(vertex).truncate();
        // On the right of the line from the source through the corner, beyond it.
        if (corner - from).perp_dot(to - from) > ROUNDING && to.x > 0.5 {
            hidden += 1;
            let length = from.distance(corner) + corner.distance(to);
            let expected = (corner - from).normalize() * length;
            assert!(map.coordinates[vertex].distance(expected) < ROUNDING, "{to}");
        }
    }
    assert!(hidden > 10);
}

#[test]
fn on_a_cylinder_the_log_map_is_its_unrolling() {
    let segments = 40;
    let (surface, geometry) = laid_out(&band(segments, 0));
    let side = 2.0 * 2.0 * (0.5 * TAU / f64::from(segments)).sin();
    let place = |vertex: VertexId| {
        let position = surface.position(vertex);
        let column = (position.y.atan2(position.x) / TAU * f64::from(segments)).round();
        dvec2(column * side, position.z)
    };
    let source = nearest(&surface, dvec3(2.0, 0.0, 0.0));
    let map = mapped(&geometry, source, Some(DVec3::Y));
    let seen_from_outside = map.axes[0].cross(map.axes[1]).dot(surface.vertex_normal(source));
    assert!(seen_from_outside > 0.5);
    let up = map.axes[1].z.signum();
    for vertex in surface.vertices() {
        let offset = place(vertex) - place(source);
        // On the other side two paths are equally long.
        if offset.x.abs() < (0.5 * f64::from(segments) - 0.1) * side {
            let expected = dvec2(offset.x, up * offset.y);
            assert!(map.coordinates[vertex].distance(expected) < ROUNDING, "{expected} {}", map.coordinates[vertex]);
        }
    }
}

#[test]
fn around_a_tip_angles_are_scaled_to_a_full_turn() {
    // Of a pyramid, with a flat ring around.
    let sides = 5;
    let rim = |angle: f64, radius: f64, z: f64| dvec3(radius * angle.cos(), radius * angle.sin(), z);
    for height in [1.0, -0.7] {
        let mut positions = vec![dvec3(0.0, 0.0, height)];
        positions.extend((0..sides).map(|k| rim(TAU * f64::from(k) / f64::from(sides), 1.0, 0.0)));
        let faces = (0..sides).map(|k| [0, 1 + k, 1 + (k + 1) % sides]).collect();
        let (_, geometry) = laid_out(&soup(positions, faces));
        let map = mapped(&geometry, VertexId(0), Some(DVec3::X));
        let slant = (1.0 + height * height).sqrt();
        for k in 0..sides {
            let angle = TAU * f64::from(k) / f64::from(sides);
            let expected = slant * dvec2(angle.cos(), angle.sin());
            assert!(map.coordinates[VertexId(1 + k)].distance(expected) < ROUNDING, "{k} at {height}");
        }
    }
}

/// A regular tetrahedron of side 1, whose first face lies in z = 0 and is seen from below.
fn tetrahedron() -> Soup {
    let height = 0.75_f64.sqrt();
    let base = [dvec3(0.0, 0.0, 0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.5, height, 0.0)];
    let tip = dvec3(0.5, height / 3.0, (2.0 / 3.0_f64).sqrt());
    soup([base[0], base[1], base[2], tip].into(), vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
}

#[test]
fn on_a_tetrahedron_the_log_map_is_its_net() {
    let (surface, geometry) = laid_out(&tetrahedron());
    let place = Place::Face { face: FaceId(0), weights: [0.45, 0.1, 0.45] };
    let from = place.position(&surface);
    let map = mapped(&geometry, place, Some(DVec3::X));
    // Seen from outside, which is below, y points to the right of x.
    let seen = |position: DVec3| dvec2(position.x - from.x, from.y - position.y);
    for vertex in [0, 1, 2].map(VertexId) {
        assert!(map.coordinates[vertex].distance(seen(surface.position(vertex))) < ROUNDING);
    }
    // The tip, unfolded across the side along the x axis.
    let tip = seen(dvec3(0.5, -(0.75_f64.sqrt()), 0.0));
    assert!(map.coordinates[VertexId(3)].distance(tip) < ROUNDING);
}

#[test]
fn the_log_map_has_the_directions_of_exact_paths() {
    for (name, face) in [("bunny", 1000), ("high_genus", 700), ("triceratops", 300)] {
        let (surface, geometry) = laid_out(&meshes::mesh(name));
        let place = Place::Face { face: FaceId(face), weights: [0.5, 0.2, 0.3] };
        let map = mapped(&geometry, place, None);
        let mut front = Wavefront::new(Arc::clone(&geometry), &[place]).expect("a source");
        front.advance(f64::INFINITY, usize::MAX).expect("room for windows");
        let mut angles = Vec::new();
        for vertex in surface.vertices().filter(|&vertex| front.values()[vertex].is_finite()) {
            let path = front.path_from_vertex(vertex).expect("a path");
            let [.., before, end] = &path.points[..] else { panic!("a path from elsewhere") };
            let first = before.position - end.position;
            let expected = dvec2(first.dot(map.axes[0]), first.dot(map.axes[1]));
            let coordinates = map.coordinates[vertex];
            assert!((coordinates.length() - front.values()[vertex]).abs() <= 1e-12 * coordinates.length());
            angles.push(coordinates.perp_dot(expected).atan2(coordinates.dot(expected)).abs().to_degrees());
        }
        angles.sort_by(f64::total_cmp);
        let percentile = angles[angles.len() * 95 / 100];
        assert!(percentile < 1e-8, "{name}: {percentile}");
        assert!(angles[angles.len() * 999 / 1000] < 1e-3, "{name}: {:?}", angles.last());
    }
}

#[test]
fn on_a_sphere_vectors_are_carried_along_great_circles() {
    let (surface, geometry) = laid_out(&shapes::icosphere(5));
    assert_eq!(surface.vertex_count(), 10_242);
    let axis = dvec3(0.36, 0.48, 0.8);
    let source = nearest(&surface, axis);
    let start = surface.position(source);
    let vector = 3.0 * start.any_orthonormal_vector();
    let carried = transport(&geometry, &[(source, vector)], &mut go_on).expect("vectors");
    // Three quarters of the area.
    let near = surface.vertices().filter(|&vertex| surface.position(vertex).dot(start) > -0.5);
    let error = |vertex: VertexId| {
        let end = surface.position(vertex);
        assert!((carried[vertex].length() - 3.0).abs() < ROUNDING);
        assert!(carried[vertex].dot(surface.vertex_normal(vertex)).abs() < ROUNDING);
        carried[vertex].angle_between(DQuat::from_rotation_arc(start, end) * vector).to_degrees()
    };
    let mut errors: Vec<f64> = near.map(error).collect();
    errors.sort_by(f64::total_cmp);
    let [median, largest] = [errors[errors.len() / 2], errors[errors.len() - 1]];
    assert!(median < 0.5 && largest < 2.0, "{median} {largest}");
}

#[test]
fn at_a_tip_vectors_keep_their_scaled_angle_with_the_path() {
    // Of four equilateral triangles, whose angles of 60° become 90° in the plane of the tip.
    let height = 0.5_f64.sqrt();
    let rim = [(height, 0.0), (0.0, height), (-height, 0.0), (0.0, -height)];
    let positions = [dvec3(0.0, 0.0, height)].into_iter().chain(rim.map(|(x, y)| dvec3(x, y, 0.0))).collect();
    let (surface, geometry) = laid_out(&soup(positions, vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]]));
    let tip = surface.position(VertexId(0));
    let on_edge = surface.halfedge_between(VertexId(0), VertexId(1)).expect("an edge");
    let on_edge = Place::Edge { halfedge: on_edge, fraction: 0.5 };
    let in_face = Place::Face { face: FaceId(0), weights: [0.4, 0.3, 0.3] };
    for (place, from) in [(on_edge, DVec3::X), (in_face, dvec3(1.0, 1.0, 0.0).normalize())] {
        let up = (tip - place.position(&surface)).normalize();
        let left = dvec3(-from.y, from.x, 0.0);
        for (vector, expected) in [(up, -from), (left, left), (2.0 * up - left, -2.0 * from - left)] {
            let carried = transport(&geometry, &[(place, vector)], &mut go_on).expect("vectors");
            assert!(carried[VertexId(0)].distance(expected) < ROUNDING, "{} {expected}", carried[VertexId(0)]);
        }
    }
}

#[test]
fn each_vertex_has_the_vector_of_the_nearest_source() {
    let (surface, geometry) = laid_out(&plane(true));
    let [a, b] = [dvec3(0.1, 0.2, 0.0), dvec3(0.9, 0.7, 0.0)].map(|place| nearest(&surface, place));
    let carried = transport(&geometry, &[(a, DVec3::X), (b, 2.0 * DVec3::Y)], &mut go_on).expect("vectors");
    for vertex in surface.vertices() {
        let [to_a, to_b] = [a, b].map(|source| surface.position(source).distance(surface.position(vertex)));
        let expected = if to_a < to_b { DVec3::X } else { 2.0 * DVec3::Y };
        assert!((to_a - to_b).abs() < ROUNDING || carried[vertex].distance(expected) < ROUNDING, "{vertex:?}");
    }
}

#[test]
fn a_search_tells_what_it_has_come_to() {
    let (surface, geometry) = laid_out(&shapes::torus(1.0, 0.4, 60, 30));
    let source = Place::Face { face: FaceId(17), weights: [0.2, 0.3, 0.5] };
    let whole = mapped(&geometry, source, Some(DVec3::Z));
    let mut search = LogMapSearch::new(&geometry, source).unwrap();
    for radius in [0.3, 0.9, f64::INFINITY] {
        while !search.advance(radius, 200).unwrap() {}
        let part = search.map(Some(DVec3::Z)).unwrap();
        let mut count = 0;
        for vertex in surface.vertices() {
            if part.distances[vertex].is_finite() {
                count += 1;
                assert!(part.coordinates[vertex].distance(whole.coordinates[vertex]) < 1e-12);
                assert_eq!(part.distances[vertex], whole.distances[vertex]);
            } else {
                assert!(whole.distances[vertex] >= radius && part.coordinates[vertex].is_nan());
            }
        }
        assert!(count > 0 && (count < surface.vertex_count()) == radius.is_finite());
        assert_eq!(part.axes, whole.axes);
    }
}

#[test]
fn what_no_source_reaches_has_no_direction() {
    let (two, first) = two_squares(4);
    let (surface, geometry) = laid_out(&two);
    let map = mapped(&geometry, VertexId(3), None);
    let carried = transport(&geometry, &[(VertexId(3), DVec3::X)], &mut go_on).expect("vectors");
    for vertex in surface.vertices() {
        let is_reached = vertex.0 < first;
        assert_eq!(map.coordinates[vertex].is_nan(), !is_reached);
        assert_eq!(map.distances[vertex].is_infinite(), !is_reached);
        assert_eq!(carried[vertex].is_nan(), !is_reached);
    }
}

#[test]
fn across_a_bridge_the_log_map_keeps_its_direction_and_vectors_end() {
    let (two, first) = two_squares(4);
    let surface = Arc::new(surface(&two));
    let [middle, lower] = [dvec3(0.5, 0.5, 1.0), dvec3(0.5, 0.5, 0.0)].map(|place| nearest(&surface, place));
    let portal = Portal { ends: [Place::Vertex(lower), Place::Vertex(middle)], gap: 1.0 };
    let bridges = Bridges::new(&surface, vec![([0, 1], vec![portal])]);
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)).bridged(&bridges));
    let source = nearest(&surface, DVec3::ZERO);
    let map = mapped(&geometry, source, None);
    let carried = transport(&geometry, &[(source, DVec3::X)], &mut go_on).expect("vectors");
    for vertex in surface.vertices().filter(|vertex| vertex.0 >= first) {
        let length = 0.5_f64.sqrt() + 1.0 + surface.position(vertex).distance(surface.position(middle));
        assert!(map.coordinates[vertex].distance(DVec2::splat(0.5_f64.sqrt() * length)) < ROUNDING);
        assert!(carried[vertex].is_nan());
    }
}

#[test]
fn on_any_surface_it_is_as_long_as_the_distance() {
    let mut random = Random::new(3);
    for soup in [band(30, 1), book(3, 6), meshes::mesh("slivers"), shapes::high_genus(0.12)] {
        let (surface, geometry) = laid_out(&soup);
        for _ in 0..4 {
            let face = FaceId::from_index(random.below(surface.face_count()));
            let place = Place::Face { face, weights: [0.3, 0.3, 0.4] };
            let map = mapped(&geometry, place, None);
            let carried = transport(&geometry, &[(place, map.axes[0])], &mut go_on).expect("vectors");
            let known = PlaceDistances::new(&geometry, &map.distances, &[place]).expect("distances");
            for vertex in surface.vertices() {
                let length = known.at(vertex).expect("a vertex");
                assert!((map.coordinates[vertex].length() - length).abs() <= 1e-12 * length, "{vertex:?}");
                assert!(carried[vertex].is_nan() || (carried[vertex].length() - 1.0).abs() < ROUNDING);
            }
        }
    }
}

#[test]
fn vectors_go_on_where_sides_are_exchanged() {
    // Orientations meet in one row across the strip, of column 31.
    let (surface, geometry) = laid_out(&band(60, 1));
    let beside = |column: u32| VertexId(5 * column + 1);
    let across = surface.position(VertexId(127)) - surface.position(VertexId(128));
    let carried = transport(&geometry, &[(VertexId(127), across.normalize())], &mut go_on).expect("vectors");
    assert!(carried[beside(31)].is_nan());
    for column in 26..40 {
        // Three degrees of a half twist each, and six along the circle.
        let [before, here] = [column - 1, column].map(|column| carried[beside(column)]);
        assert!(column == 31 || column == 32 || before.angle_between(here) < 0.1, "{column}: {before} {here}");
    }
    assert!(carried[beside(30)].angle_between(carried[beside(32)]) < 0.2);
}

#[test]
fn rejects_invalid_arguments() {
    let (_, geometry) = laid_out(&plane(true));
    for direction in [DVec3::ZERO, DVec3::Z, dvec3(f64::NAN, 1.0, 0.0), dvec3(f64::INFINITY, 1.0, 0.0)] {
        let refused = log_map(&geometry, VertexId(3), Some(direction), &mut go_on).unwrap_err();
        assert!(matches!(refused, Error::BadParameter { name: "the direction", .. }), "{refused}");
        let refused = transport(&geometry, &[(VertexId(3), direction)], &mut go_on).unwrap_err();
        assert!(matches!(refused, Error::BadParameter { name: "the vector", .. }), "{refused}");
    }
    assert!(matches!(log_map(&geometry, VertexId(9999), None, &mut go_on), Err(Error::Surface(_))));
    assert_eq!(transport::<VertexId>(&geometry, &[], &mut go_on), Err(Error::NoSource));
    let (surface, geometry) = laid_out(&book(3, 4));
    let spine = nearest(&surface, dvec3(0.0, 0.0, 0.5));
    let refused = log_map(&geometry, spine, None, &mut go_on).unwrap_err();
    assert!(refused.to_string().contains(&format!("at vertex {}", spine.0)), "{refused}");
    let along = surface.halfedge_between(spine, nearest(&surface, dvec3(0.0, 0.0, 0.75))).expect("an edge");
    let refused = log_map(&geometry, Place::Edge { halfedge: along, fraction: 0.5 }, None, &mut go_on).unwrap_err();
    assert!(refused.to_string().contains("on the edge of vertices"), "{refused}");
}

#[test]
fn different_costs_are_refused_and_one_cost_scales() {
    let (surface, geometry) = laid_out(&plane(true));
    let costs = |cost: &dyn Fn(usize) -> f64| {
        let of_faces: heatwalk::FaceData<f64> = (0..surface.face_count()).map(cost).collect();
        Costs::new(&surface, of_faces).expect("costs")
    };
    let weighted = |costs| Arc::new(ExactGeometry::new(Arc::clone(&surface)).weighted(&costs));
    let different = weighted(costs(&|face| if face == 3 { 2.0 } else { 1.0 }));
    assert_eq!(log_map(&different, VertexId(3), None, &mut go_on), Err(Error::NotExact));
    assert_eq!(transport(&different, &[(VertexId(3), DVec3::X)], &mut go_on), Err(Error::NotExact));
    let (plain, twice) = (mapped(&geometry, VertexId(3), None), mapped(&weighted(costs(&|_| 2.0)), VertexId(3), None));
    let is_twice = |vertex| (2.0 * plain.coordinates[vertex]).distance(twice.coordinates[vertex]) < ROUNDING;
    assert!(surface.vertices().all(is_twice));
}

#[test]
fn they_can_be_cancelled() {
    let (_, geometry) = laid_out(&shapes::icosphere(5));
    let cancel = &mut |_, _| ControlFlow::Break(());
    assert_eq!(log_map(&geometry, VertexId(0), None, cancel), Err(Error::Cancelled));
    assert_eq!(transport(&geometry, &[(VertexId(0), DVec3::X)], cancel), Err(Error::Cancelled));
}

#[test]
fn heat_carries_vectors_over_a_sphere_and_lengths_and_numbers_from_the_nearest_point() {
    let surface = Arc::new(surface(&shapes::icosphere(4)));
    let heat = VectorHeat::new(&surface, &mut go_on).expect("factors");
    let [near, far] = [0.9, -0.9].map(|z: f64| nearest(&surface, dvec3((1.0 - z * z).sqrt(), 0.0, z)));
    let start = surface.position(near);
    let vector = start.any_orthonormal_vector();
    let carried = heat.transport(&[(near, 3.0 * vector)], &mut go_on).expect("vectors");
    for vertex in surface.vertices().filter(|&vertex| surface.position(vertex).dot(start) > -0.5) {
        let expected = 3.0 * (DQuat::from_rotation_arc(start, surface.position(vertex)) * vector);
        assert!(carried[vertex].distance(expected) < 0.1, "{} for {expected}", carried[vertex]);
    }
    let two = [(near, 2.0 * vector), (far, 5.0 * surface.position(far).any_orthonormal_vector())];
    let lengths = heat.transport(&two, &mut go_on).expect("vectors");
    let numbers = heat.extend(&[(near, 2.0), (far, 5.0)], &mut go_on).expect("numbers");
    for vertex in surface.vertices() {
        let [to_near, to_far] =
            [near, far].map(|point| surface.position(vertex).angle_between(surface.position(point)));
        if (to_near - to_far).abs() > 0.5 {
            let expected = if to_near < to_far { 2.0 } else { 5.0 };
            assert!((numbers[vertex] - expected).abs() < 0.01, "{} for {expected}", numbers[vertex]);
            assert!((lengths[vertex].length() - expected).abs() < 0.01, "{} for {expected}", lengths[vertex].length());
        }
    }
    let none: [(VertexId, f64); 0] = [];
    assert!(matches!(heat.extend(&none, &mut go_on), Err(Error::NoSource)));
    let refused = heat.transport(&[(near, DVec3::ZERO)], &mut go_on).map(|_| ()).expect_err("no direction").to_string();
    assert!(refused.contains("not square to the surface"), "{refused}");
}

#[test]
fn the_log_map_by_heat_is_where_vertices_of_a_plane_lie() {
    let surface = Arc::new(surface(&plane(true)));
    let heat = VectorHeat::new(&surface, &mut go_on).expect("factors");
    for place in places(&surface) {
        let from = place.position(&surface);
        let map = heat.log_map(place, Some(dvec3(3.0, 4.0, 5.0)), &mut go_on).expect("a log map");
        assert!(map.axes[0].distance(dvec3(0.6, 0.8, 0.0)) < ROUNDING);
        for vertex in surface.vertices() {
            let expected = dvec2(0.6, -0.8).rotate((surface.position(vertex) - from).truncate());
            assert!(map.coordinates[vertex].distance(expected) < ROUNDING, "{place:?} {vertex:?}");
            assert!((map.distances[vertex] - expected.length()).abs() < ROUNDING);
        }
    }
}

#[test]
fn heat_arrives_at_the_end_of_a_strip_of_five_thousand_edges() {
    let length = 5000;
    let positions = (0..=length).flat_map(|x| [0.0, 1.0].map(|y| dvec3(f64::from(x), y, 0.0))).collect();
    let faces = (0..length).flat_map(|x| [[2 * x, 2 * x + 2, 2 * x + 1], [2 * x + 2, 2 * x + 3, 2 * x + 1]]);
    let surface = Arc::new(surface(&soup(positions, faces.map(|face| face.map(|corner| corner as u32)).collect())));
    let heat = VectorHeat::new(&surface, &mut go_on).expect("factors");
    let map = heat.log_map(VertexId(0), None, &mut go_on).expect("a log map");
    for vertex in surface.vertices() {
        assert!(map.coordinates[vertex].distance(surface.position(vertex).truncate()) < 1e-6, "{vertex:?}");
    }
}

#[test]
fn the_log_map_by_heat_comes_nearer_to_that_of_exact_paths_on_finer_triangles() {
    // Mean distances between the two, in radii, up to 30° from the opposite point.
    let errors = |subdivisions| {
        let (surface, geometry) = laid_out(&shapes::icosphere(subdivisions));
        let heat = VectorHeat::new(&surface, &mut go_on).expect("factors");
        let edge = Place::Edge { halfedge: HalfedgeId(77), fraction: 0.3 };
        let face = Place::Face { face: FaceId(60), weights: [0.2, 0.3, 0.5] };
        [Place::Vertex(VertexId(3)), edge, face].map(|place| {
            let exact = mapped(&geometry, place, None);
            let diffused = heat.log_map(place, None, &mut go_on).expect("a log map");
            assert_eq!(exact.axes, diffused.axes);
            let near = surface.vertices().filter(|&vertex| exact.distances[vertex] < 2.6);
            let errors = near.map(|vertex| exact.coordinates[vertex].distance(diffused.coordinates[vertex]));
            let errors: Vec<f64> = errors.collect();
            errors.iter().sum::<f64>() / errors.len() as f64
        })
    };
    let [coarse, fine] = [3, 5].map(errors);
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(coarse < 0.1 && fine < 0.3 * coarse, "{coarse} {fine}");
    }
}

#[test]
fn the_log_map_by_heat_ends_where_no_heat_arrives_and_refuses_what_has_no_plane() {
    let (two, first) = two_squares(4);
    let surface = Arc::new(surface(&two));
    let heat = VectorHeat::new(&surface, &mut go_on).expect("factors");
    let map = heat.log_map(VertexId(3), None, &mut go_on).expect("a log map");
    for vertex in surface.vertices() {
        assert_eq!(map.coordinates[vertex].is_nan(), vertex.0 >= first);
        assert_eq!(map.distances[vertex].is_infinite(), vertex.0 >= first);
    }
    let refused = heat.log_map(VertexId(3), Some(DVec3::Z), &mut go_on).map(|_| ()).expect_err("no direction");
    assert!(matches!(refused, Error::BadParameter { name: "the direction", .. }), "{refused}");
    let surface = Arc::new(self::surface(&book(3, 4)));
    let heat = VectorHeat::new(&surface, &mut go_on).expect("factors");
    let spine = nearest(&surface, dvec3(0.0, 0.0, 0.5));
    assert!(heat.log_map(spine, None, &mut go_on).is_err());
}

/// Degrees between log maps, sorted.
fn degrees_between(exact: &LogMap, other: &LogMap) -> Vec<f64> {
    let maps = exact.coordinates.iter().zip(&other.coordinates).filter(|(expected, _)| expected.length() > 0.0);
    let mut degrees: Vec<f64> = maps.map(|(expected, place)| place.angle_to(*expected).abs().to_degrees()).collect();
    degrees.sort_by(f64::total_cmp);
    degrees
}

#[test]
fn the_log_map_by_propagation_goes_on_from_exact_directions() {
    // Most of both lies beyond the exact search. Errors of distances of one window a half-edge turn directions a little.
    let (flat, of_plane) = laid_out(&square(160));
    let middle = Place::Vertex(nearest(&flat, dvec3(0.3, 0.4, 0.0)));
    let (_, of_sphere) = laid_out(&shapes::icosphere(6));
    let face = Place::Face { face: FaceId(60), weights: [0.2, 0.3, 0.5] };
    for (geometry, place) in [(of_plane, middle), (of_sphere, face)] {
        let exact = mapped(&geometry, place, None);
        let map = propagated_log_map(&geometry, place, None, Windows::default(), &mut go_on).expect("a log map");
        assert_eq!(map.axes, exact.axes);
        let degrees = degrees_between(&exact, &map);
        let [median, most] = [0.5, 0.95].map(|share| degrees[(degrees.len() as f64 * share) as usize]);
        assert!(median < 0.3 && most < 2.5, "{median} {most}");
        for (place, distance) in map.coordinates.iter().zip(&map.distances) {
            assert!((place.length() - distance).abs() <= 1e-12 * distance);
        }
        let all = propagated_log_map(&geometry, place, None, Windows::All, &mut go_on).expect("a log map");
        assert_eq!(all, exact);
    }
}

#[test]
fn the_log_map_by_propagation_ends_where_nothing_is_reached_and_refuses_costs() {
    let (two, first) = two_squares(4);
    let (surface, geometry) = laid_out(&two);
    let map = propagated_log_map(&geometry, VertexId(3), None, Windows::default(), &mut go_on).expect("a log map");
    for vertex in surface.vertices() {
        assert_eq!(map.coordinates[vertex].is_nan(), vertex.0 >= first);
        assert_eq!(map.distances[vertex].is_infinite(), vertex.0 >= first);
    }
    let of_faces: heatwalk::FaceData<f64> = (0..surface.face_count()).map(|face| 1.0 + face as f64).collect();
    let costs = Costs::new(&surface, of_faces).expect("costs");
    let weighted = Arc::new(ExactGeometry::new(Arc::clone(&surface)).weighted(&costs));
    let refused = propagated_log_map(&weighted, VertexId(3), None, Windows::default(), &mut go_on);
    assert_eq!(refused, Err(Error::NotExact));
}
