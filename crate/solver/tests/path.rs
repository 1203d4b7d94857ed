//! Paths: they arrive, stay on the surface, are as long as they must be and hardly longer.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{band, book, distance_from, nearest, solver, soup, square, stretched, surface, two_squares};
use glam::DVec3;
use heatwalk::exact::{ExactGeometry, shortest_path};
use heatwalk::{
    Boundary, Element, Error, FaceId, HeatSolver, Path, PathPoint, Place, Soup, Surface, VertexId, descend,
};
use heatwalk_shapes as shapes;

/// Points of a path follow each other through the faces that they name, and end at a source.
fn check(solver: &HeatSolver, path: &Path, from: Place, sources: &[Place]) {
    let surface = solver.surface();
    assert_eq!(path.points.len(), path.normals.len());
    assert!(path.points[0].position.distance(from.position(surface)) < 1e-9 * surface.mean_edge());
    let end = path.points[path.points.len() - 1].position;
    assert!(sources.iter().any(|source| source.position(surface).distance(end) < 1e-9 * surface.mean_edge()));
    for pair in path.points.windows(2) {
        for point in pair {
            let corners = surface.faces()[pair[0].face];
            let lies_in_face = point.location.support(surface).all(|(corner, _)| corners.contains(&corner));
            assert!(lies_in_face, "{point:?} is not in {:?}", pair[0].face);
        }
    }
    // Rounding of one normalisation.
    assert!(path.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-12));
}

/// Paths between random points, with the straight-line or great-circle distance as a bar.
fn try_pairs(soup: &Soup, boundary: Boundary, pairs: usize, exact: impl Fn(DVec3, DVec3) -> f64, longest: f64) {
    let solver = solver(soup, 1.0, boundary);
    let surface = solver.surface();
    let mut random = Random::new(11);
    for _ in 0..pairs {
        let [source, from] = [(); 2].map(|()| match random.below(2) {
            0 => Place::Vertex(VertexId::from_index(random.below(surface.vertex_count()))),
            _ => {
                let a = random.share();
                let b = (1.0 - a) * random.share();
                let face = FaceId(random.below(surface.face_count()) as u32);
                Place::Face { face, weights: [a, b, 1.0 - a - b] }
            }
        });
        let distance = solver.distance(&[source]).expect("a source");
        let path = descend(surface, &distance, from).expect("reachable");
        check(&solver, &path, from, &[source]);
        let exact = exact(from.position(surface), source.position(surface));
        assert!(path.length() >= 0.999_999 * exact, "{} under {exact}", path.length());
        assert!(path.length() <= longest * exact + surface.mean_edge(), "{} for {exact}", path.length());
    }
}

#[test]
fn plane() {
    // Lines of equal distance bend by the Neumann condition near the boundary and in the first rings: some per cent.
    try_pairs(&square(20), Boundary::Neumann, 60, DVec3::distance, 1.05);
    try_pairs(&square(20), Boundary::Average, 20, DVec3::distance, 1.05);
}

#[test]
fn sphere() {
    // The polyhedron lies inside the sphere: the arc over its chord bounds what it may be shorter by.
    let inside = 1.0 - 0.002;
    let arc = |a: DVec3, b: DVec3| inside * a.normalize().dot(b.normalize()).clamp(-1.0, 1.0).acos();
    try_pairs(&shapes::icosphere(4), Boundary::Neumann, 60, arc, 1.05);
}

#[test]
fn always_arrives() {
    // Cuts, spines, badly shaped faces: only arrival counts.
    let squashed = stretched(square(12), 1e-4);
    for soup in [band(24, 1), book(3, 6), squashed, shapes::torus(2.0, 0.7, 24, 12)] {
        try_pairs(&soup, Boundary::Neumann, 40, DVec3::distance, 1e9);
    }
}

#[test]
fn several_sources() {
    let solver = solver(&square(16), 1.0, Boundary::Neumann);
    let surface = solver.surface();
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y].map(|corner| Place::Vertex(nearest(surface, corner)));
    let distance = solver.distance(&corners).expect("sources");
    for point in 0..surface.vertex_count() as u32 {
        let from = Place::Vertex(VertexId(point));
        let path = descend(surface, &distance, from).expect("reachable");
        check(&solver, &path, from, &corners);
    }
}

#[test]
fn constant_distance_still_arrives() {
    // No gradient at all: the path must take edges.
    let (solver, mut distance) = distance_from(&square(8), 0);
    distance.values.as_mut_slice().fill(1.0);
    let from = Place::Face { face: FaceId(200), weights: [0.2, 0.3, 0.5] };
    let path = descend(solver.surface(), &distance, from).expect("reachable");
    check(&solver, &path, from, &distance.sources);
}

#[test]
fn walks_along_the_boundary() {
    // Lower to the left and, ten times as steeply, out over the lower side.
    let (solver, mut distance) = distance_from(&square(8), 0);
    let surface = solver.surface();
    for (value, position) in distance.values.iter_mut().zip(surface.positions()) {
        *value = position.x + 10.0 * position.y;
    }
    distance.sources = vec![Place::Vertex(nearest(surface, DVec3::ZERO))];
    for face in surface.mesh().faces() {
        let from = Place::Face { face, weights: [0.3, 0.3, 0.4] };
        let path = descend(surface, &distance, from).expect("reachable");
        check(&solver, &path, from, &distance.sources);
        let side = path.points.iter().position(|point| point.position.y == 0.0).expect("the lower side");
        let (down, along) = path.points.split_at(side);
        // In line with the gradient, then on the side; the last piece but one may be cut short by the source in sight.
        let start = from.position(surface);
        for point in down {
            let offset = point.position - start;
            assert!((offset.x - 0.1 * offset.y).abs() < 1e-9 || point.position.x < 0.125, "{point:?}");
        }
        assert!(along.windows(2).all(|pair| pair[1].position.y == 0.0 && pair[1].position.x < pair[0].position.x));
    }
}

#[test]
fn starts_on_an_edge() {
    let solver = solver(&band(24, 1), 1.0, Boundary::Neumann);
    let surface = solver.surface();
    let source = Place::Vertex(VertexId(0));
    let distance = solver.distance(&[source]).expect("a source");
    for halfedge in surface.mesh().halfedges() {
        let from = Place::Edge { halfedge, fraction: 0.37 };
        let path = descend(surface, &distance, from).expect("reachable");
        check(&solver, &path, from, &[source]);
        // The straight line through space is no longer.
        assert!(path.length() >= from.position(surface).distance(surface.position(VertexId(0))) * (1.0 - 1e-12));
    }
}

#[test]
fn start_at_the_source_is_a_point() {
    let (solver, distance) = distance_from(&square(4), 3);
    let path = descend(solver.surface(), &distance, Place::Vertex(VertexId(3))).expect("reachable");
    assert_eq!((path.points.len(), path.length()), (1, 0.0));
}

#[test]
fn rejects_a_start_that_no_source_reaches() {
    let (two, first) = two_squares(2);
    let (solver, distance) = distance_from(&two, 0);
    let path = descend(solver.surface(), &distance, Place::Vertex(VertexId(first)));
    assert_eq!(path, Err(Error::Unreachable));
}

#[test]
fn points_at_one_place_become_one_and_no_coordinate_is_minus_zero() {
    let positions = [(-0.0, -0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, -0.0));
    let square = surface(&soup(positions.to_vec(), vec![[0, 1, 2], [0, 2, 3]]));
    let edge = |face, ends: [u32; 2], share| Place::on_edge(&square, FaceId(face), ends.map(VertexId), share);
    let places = [
        Place::Vertex(VertexId(0)),
        // Rounding beside the vertex.
        edge(0, [0, 1], 1e-15),
        edge(0, [0, 2], 1e-14),
        edge(0, [1, 2], 0.5),
        edge(0, [1, 2], 0.5),
        Place::Vertex(VertexId(2)),
    ];
    let point = |location: Place| PathPoint { position: location.position(&square), location, face: FaceId(0) };
    let path = Path::new(&square, places.map(point).to_vec());
    assert_eq!(path.points.iter().map(|point| point.location).collect::<Vec<_>>(), [places[0], places[3], places[5]]);
    for point in &path.points {
        assert!(point.position.to_array().iter().all(|coordinate| coordinate.to_bits() != (-0.0_f64).to_bits()));
    }
}

#[test]
fn a_path_through_the_corners_of_a_cube_has_no_place_twice() {
    let positions =
        (0..8).map(|corner| DVec3::new(f64::from(corner & 1), f64::from(corner >> 1 & 1), f64::from(corner >> 2)));
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let cube: Surface = surface(&soup(positions.collect(), triangles.collect()));
    let geometry = Arc::new(ExactGeometry::new(cube));
    for start in 0..8 {
        // Over two sides to the opposite corner.
        let path = shortest_path(&geometry, VertexId(start), &[VertexId(7 - start)]).expect("a path");
        let is_still = |pair: &[PathPoint]| pair[0].position == pair[1].position;
        assert!(!path.points.windows(2).any(is_still), "from {start}: {:?}", path.points);
        assert!((path.length() - 5_f64.sqrt()).abs() < 1e-12);
    }
}
