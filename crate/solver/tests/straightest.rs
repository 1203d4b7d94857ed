//! Straightest geodesics against closed forms and against themselves, backwards; lines along edges.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common;

use std::f64::consts::{PI, TAU};

use crate::common::truth::Random;
use crate::common::{band, book, nearest, quads, soup, square, stretched, surface, two_squares};
use glam::DVec3;
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    Element, Error, FaceId, HalfedgeId, Place, Soup, Straightest, Surface, VertexData, VertexId, edge_path,
    edge_polyline, straighten, straightest,
};
use heatwalk_shapes as shapes;

/// Walks, and checks what holds for any walk.
fn walk(surface: &Surface, from: Place, face: Option<FaceId>, direction: DVec3, length: f64) -> Straightest {
    let walked = straightest(surface, from, face, direction, length).expect("a direction");
    let points = &walked.path.points;
    assert_eq!(points.len(), walked.path.normals.len());
    for pair in points.windows(2) {
        for point in pair {
            let corners = surface.faces()[pair[0].face];
            let lies_in_face = point.location.support(surface).all(|(corner, _)| corners.contains(&corner));
            assert!(lies_in_face, "{point:?} is not in {:?}", pair[0].face);
        }
    }
    let last = points[points.len() - 1];
    let corners = surface.faces()[last.face];
    assert!(last.location.support(surface).all(|(corner, _)| corners.contains(&corner)));
    // Rounding of one normalisation, and of a normal.
    assert!((walked.direction.length() - 1.0).abs() < 1e-12);
    assert!(walked.direction.dot(surface.face_normal(last.face)).abs() < 1e-9);
    // Points within 10⁻¹⁰ of a vertex or an edge are moved to it.
    let moved = walked.path.length() - length;
    assert!(moved.abs() < 1e-9 * surface.mean_edge() || walked.is_at_boundary && moved < 0.0, "{moved:e}");
    walked
}

fn end(walked: &Straightest) -> DVec3 {
    walked.path.points[walked.path.points.len() - 1].position
}

fn random_point(surface: &Surface, random: &mut Random) -> Place {
    let share = random.share();
    match random.below(3) {
        0 => Place::Vertex(VertexId::from_index(random.below(surface.vertex_count()))),
        1 => Place::Edge { halfedge: HalfedgeId(random.below(3 * surface.face_count()) as u32), fraction: share },
        _ => {
            let rest = (1.0 - share) * random.share();
            let face = FaceId(random.below(surface.face_count()) as u32);
            Place::Face { face, weights: [share, rest, 1.0 - share - rest] }
        }
    }
}

fn random_direction(random: &mut Random) -> DVec3 {
    let mut coordinate = || random.below(2001) as f64 - 1000.5;
    DVec3::from_array([(); 3].map(|()| coordinate()))
}

#[test]
fn plane() {
    let surface = surface(&square(16));
    let mut random = Random::new(4);
    for k in 0..300 {
        let from = random_point(&surface, &mut random);
        // Among them many along the edges and through the vertices.
        let turn = if k % 2 == 0 { f64::from(k) * PI / 8.0 } else { f64::from(k) };
        let direction = DVec3::new(turn.cos(), turn.sin(), 0.0);
        let start = from.position(&surface);
        let walked = walk(&surface, from, None, direction + DVec3::Z, 0.4);
        let goal = start + direction * 0.4;
        // Vertices within 10⁻¹⁰ of an edge are taken as met, each turning the line by that at most.
        let length = walked.path.length();
        assert!(end(&walked).distance(start + direction * length) < 1e-10);
        assert!(walked.direction.distance(direction) < 1e-9);
        let is_inside = goal.x.min(goal.y).min(1.0 - goal.x).min(1.0 - goal.y) > 1e-9;
        assert!(walked.is_at_boundary != is_inside || length < 1e-9, "{start} to {goal}");
        if walked.is_at_boundary {
            let stop = end(&walked);
            assert!(stop.x.min(stop.y).min(1.0 - stop.x).min(1.0 - stop.y) < 1e-9);
        }
    }
}

/// The cone of `wedges` flat wedges, rings at distances 1, 2, … from its tip, which is point 0.
fn cone(wedges: u32, rings: u32, height: f64) -> Soup {
    let mut positions = vec![DVec3::ZERO];
    for ring in 1..=rings {
        for wedge in 0..wedges {
            let angle = TAU * f64::from(wedge) / f64::from(wedges);
            positions.push(DVec3::new(angle.cos(), angle.sin(), -height).normalize() * f64::from(ring));
        }
    }
    let vertex = |ring: u32, wedge: u32| 1 + (ring - 1) * wedges + wedge % wedges;
    let mut triangles: Vec<[u32; 3]> = (0..wedges).map(|wedge| [0, vertex(1, wedge), vertex(1, wedge + 1)]).collect();
    triangles.extend(quads(1..rings, wedges, vertex));
    soup(positions, triangles)
}

#[test]
fn along_the_boundary_to_the_next_vertex() {
    let surface = surface(&square(4));
    for (from, along) in [(DVec3::ZERO, DVec3::X), (DVec3::Y, DVec3::X), (DVec3::X, DVec3::Y)] {
        let corner = nearest(&surface, from);
        let walked = walk(&surface, Place::Vertex(corner), None, along, 0.1);
        assert!(!walked.is_at_boundary && end(&walked).distance(from + along * 0.1) < 1e-12);
        let last = walked.path.points[1];
        let walked = walk(&surface, last.location, Some(last.face), along, 1.0);
        assert!(walked.is_at_boundary && end(&walked).distance(from + along * 0.25) < 1e-12);
    }
}

#[test]
fn cone_unrolled() {
    for height in [0.3, 1.0, 4.0] {
        let surface = surface(&cone(12, 30, height));
        let mut random = Random::new(6);
        for _ in 0..50 {
            let face = FaceId(12 + random.below(12 * 2 * 9) as u32);
            let from = Place::Face { face, weights: [0.3, 0.3, 0.4] };
            let start = from.position(&surface);
            let direction = random_direction(&mut random).reject_from_normalized(surface.face_normal(face)).normalize();
            let walked = walk(&surface, from, Some(face), direction, 12.0);
            // The cosine rule in the unrolled cone.
            let (radius, cos) = (start.length(), start.normalize().dot(direction));
            let exact = (radius * radius + 24.0 * radius * cos + 144.0).sqrt();
            assert!(!walked.is_at_boundary);
            // Rounding of some hundred faces.
            assert!((end(&walked).length() - exact).abs() < 1e-10, "{} for {exact}", end(&walked).length());
        }
    }
}

#[test]
fn through_the_tip_of_a_cone() {
    let surface = surface(&cone(12, 8, 1.0));
    for spoke in 0..12 {
        let from = VertexId(1 + 12 * 4 + spoke);
        let start = surface.position(from);
        let walked = walk(&surface, Place::Vertex(from), None, -start, 8.0);
        // Half of the angle at the tip: the opposite spoke. Rounding of a few angles.
        let opposite = surface.position(VertexId(1 + 12 * 2 + (spoke + 6) % 12));
        assert!(end(&walked).distance(opposite) < 1e-9, "{} for {opposite}", end(&walked));
        // From the tip, a third of a wedge beside the spoke.
        let along = (start * 2.0 + surface.position(VertexId(1 + 12 * 4 + (spoke + 1) % 12))).normalize();
        let walked = walk(&surface, Place::Vertex(VertexId(0)), None, along, 6.5);
        assert!(end(&walked).distance(along * 6.5) < 1e-12);
    }
}

#[test]
fn around_a_sphere() {
    let surface = surface(&shapes::icosphere(4));
    let mut random = Random::new(9);
    for _ in 0..40 {
        let from = random_point(&surface, &mut random);
        let start = from.position(&surface);
        let walked = walk(&surface, from, None, random_direction(&mut random), TAU);
        // Between a great circle and the walk lies as much curvature as between the faces and the sphere: some parts
        // in a hundred of a turn, at edges of 0.07.
        assert!(end(&walked).distance(start) < 0.1, "{}", end(&walked).distance(start));
    }
}

#[test]
fn backwards_to_the_start() {
    let needle = stretched(shapes::icosphere(3), 50.0);
    let shapes = [shapes::torus(2.0, 0.7, 40, 20), needle, band(30, 1), shapes::uv_sphere(24, 12)];
    for soup in shapes {
        let surface = surface(&soup);
        let mut random = Random::new(10);
        for _ in 0..100 {
            let from = random_point(&surface, &mut random);
            let there = walk(&surface, from, None, random_direction(&mut random), 40.0 * surface.mean_edge());
            let last = there.path.points[there.path.points.len() - 1];
            let length = there.path.length();
            if there.is_at_boundary && matches!(last.location, Place::Vertex(_)) {
                continue;
            }
            let back = walk(&surface, last.location, Some(last.face), -there.direction, length);
            // Rounding of directions, 10⁻¹⁶ each, over the length, times the spread of lines by negative curvature.
            let error = end(&back).distance(from.position(&surface)) / surface.mean_edge();
            assert!(error < 1e-9, "{error:e} of an edge, {from:?}");
        }
    }
}

#[test]
fn never_shorter_than_the_straightened_path() {
    for soup in [shapes::torus(2.0, 0.7, 40, 20), band(30, 1), shapes::icosphere(3)] {
        let surface = surface(&soup);
        let mut random = Random::new(13);
        for _ in 0..60 {
            let from = random_point(&surface, &mut random);
            let walked = walk(&surface, from, None, random_direction(&mut random), 20.0 * surface.mean_edge());
            assert!(
                straighten(&surface, &walked.path).expect("a path of this surface").length() <= walked.path.length()
            );
        }
    }
}

#[test]
fn where_pages_meet_it_goes_on_into_the_flattest() {
    let surface = surface(&book(4, 6));
    let from = Place::Vertex(nearest(&surface, DVec3::new(0.5, 0.0, 1.0 / 3.0)));
    let walked = walk(&surface, from, None, DVec3::new(-1.0, 0.0, 0.31), 1.0);
    let exact = DVec3::new(0.5, 0.0, 1.0 / 3.0) + DVec3::new(-1.0, 0.0, 0.31).normalize();
    // Rounding of some ten faces, and of the pages' angles.
    assert!(end(&walked).distance(exact) < 1e-12, "{} for {exact}", end(&walked));
    assert!(walked.direction.distance(DVec3::new(-1.0, 0.0, 0.31).normalize()) < 1e-12);
}

#[test]
fn any_triangles() {
    common::for_any_triangles(22, |surface, random| {
        for _ in 0..30 {
            let from = random_point(surface, random);
            walk(surface, from, None, random_direction(random), 30.0);
        }
    });
}

#[test]
fn a_walk_of_no_length_is_a_point() {
    let surface = surface(&square(4));
    let walked = walk(&surface, Place::Vertex(VertexId(6)), None, DVec3::X, 0.0);
    assert_eq!((walked.path.points.len(), walked.is_at_boundary), (1, false));
}

#[test]
fn rejects_invalid_arguments_of_a_walk() {
    let surface = surface(&square(4));
    let from = Place::Vertex(VertexId(6));
    let name_of = |from, face, direction, length| match straightest(&surface, from, face, direction, length) {
        Err(Error::BadParameter { name, .. }) => name,
        Err(Error::Surface(SurfaceError::NotOnFace { .. })) => "point",
        Err(Error::Surface(SurfaceError::NoSuchVertex { .. })) => "vertex",
        other => panic!("{other:?}"),
    };
    assert_eq!(name_of(from, None, DVec3::ZERO, 1.0), "direction");
    assert_eq!(name_of(from, None, DVec3::Z, 1.0), "direction");
    assert_eq!(name_of(from, None, DVec3::X * f64::NAN, 1.0), "direction");
    assert_eq!(name_of(from, None, DVec3::X, -1.0), "length");
    assert_eq!(name_of(from, None, DVec3::X, f64::INFINITY), "length");
    assert_eq!(name_of(from, Some(FaceId(60)), DVec3::X, 1.0), "point");
    assert_eq!(name_of(Place::Vertex(VertexId(999)), None, DVec3::X, 1.0), "vertex");
    let closed = common::surface(&shapes::icosphere(0));
    let endless = straightest(&closed, Place::Vertex(VertexId(0)), None, DVec3::new(0.3, 0.5, 0.7), 1e9);
    assert!(matches!(endless, Err(Error::BadParameter { name: "length", .. })));
}

#[test]
fn edge_path_on_a_grid() {
    let surface = surface(&shapes::grid(6, 6));
    let mut random = Random::new(15);
    for _ in 0..60 {
        let [from, to] = [(); 2].map(|()| VertexId::from_index(random.below(surface.vertex_count())));
        let way = edge_path(&surface, from, to).expect("connected");
        assert_eq!((way[0], way[way.len() - 1]), (from, to));
        let length: f64 = way.windows(2).map(|e| surface.position(e[0]).distance(surface.position(e[1]))).sum();
        // Rounding of a short sum.
        assert!((length - all_ways(&surface, from)[to]).abs() < 1e-12);
    }
}

/// Distances along edges by relaxing all of them (Bellman and Ford).
fn all_ways(surface: &Surface, from: VertexId) -> VertexData<f64> {
    let mut best = VertexData::from(vec![f64::INFINITY; surface.vertex_count()]);
    best[from] = 0.0;
    loop {
        let before = best.clone();
        for corners in surface.faces() {
            for k in 0..3 {
                for [a, b] in [[corners[k], corners[(k + 1) % 3]], [corners[(k + 1) % 3], corners[k]]] {
                    let length = best[a] + surface.position(a).distance(surface.position(b));
                    best[b] = best[b].min(length);
                }
            }
        }
        if best == before {
            return best;
        }
    }
}

#[test]
fn edge_polyline_joins_once() {
    let surface = surface(&square(4));
    let [a, b, c] = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0)].map(|corner| nearest(&surface, corner));
    let open = edge_polyline(&surface, &[a, b, b, c], false).expect("connected");
    assert_eq!((open.len(), open[0], open[4], open[8]), (9, a, b, c));
    let closed = edge_polyline(&surface, &[a, b, c], true).expect("connected");
    let mut once = closed.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), closed.len());
    assert_eq!(&closed[..9], &open[..]);
    assert_eq!(edge_polyline(&surface, &[b], true), Ok(vec![b]));
    assert_eq!(edge_polyline(&surface, &[b, b], true), Ok(vec![b]));
    assert!(matches!(edge_polyline(&surface, &[], false), Err(Error::BadParameter { .. })));
    assert!(matches!(
        edge_path(&surface, VertexId(0), VertexId(999)),
        Err(Error::Surface(SurfaceError::NoSuchVertex { vertex: 999, .. }))
    ));
}

#[test]
fn edge_path_between_two_pieces_is_unreachable() {
    let (two, first) = two_squares(2);
    assert_eq!(edge_path(&surface(&two), VertexId(0), VertexId(first)), Err(Error::Unreachable));
}
