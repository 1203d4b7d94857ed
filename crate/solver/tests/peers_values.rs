//! What other programs assert of distances in their own tests, on meshes made here from their description. Each value has a
//! closed form, so it is held to rounding and not to the tolerance of the program.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{flat, grid_triangles, soup, surface};
use glam::{DVec2, DVec3};
use heatwalk::exact::{ExactGeometry, shortest_path};
use heatwalk::{
    Distance, DistanceOptions, DistanceSolver, FaceId, Method, Place, Soup, Surface, ToSource, VertexId, go_on,
};
use heatwalk_shapes::icosphere;

/// Rounding of a few triangles, as a share of the distance.
const ROUNDING: f64 = 1e-14;

fn distance_by<S: ToSource>(method: Method, surface: &Arc<Surface>, sources: &[S]) -> Distance {
    let mut solver = DistanceSolver::new(Arc::clone(surface));
    let options = DistanceOptions::by(method);
    solver.distance(sources, &options, &mut go_on).expect("valid sources").distance
}

/// Exactly, by default, and by propagation, which is exact on meshes as small as these.
fn check<S: ToSource>(soup: &Soup, sources: &[S], right: &[f64]) {
    let surface = Arc::new(surface(soup));
    assert_eq!(surface.vertex_count(), right.len(), "no vertex is welded");
    for method in [Method::Exact, Method::Auto, Method::Propagation] {
        let values = distance_by(method, &surface, sources).values;
        for (vertex, (&value, &right)) in values.iter().zip(right).enumerate() {
            assert!((value - right).abs() <= ROUNDING * right, "{method}, vertex {vertex}: {value} for {right}");
        }
    }
}

fn vertex(number: u32) -> Place {
    Place::Vertex(VertexId(number))
}

/// libigl: a unit square of two triangles. PyTorch Geometric: the same of side 2, cut by its other diagonal.
#[test]
fn a_square_has_sides_and_a_diagonal() {
    let corners = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    check(&soup(corners.clone(), vec![[0, 1, 2], [0, 2, 3]]), &[vertex(0)], &[0.0, 1.0, 2_f64.sqrt(), 1.0]);
    let doubled: Vec<DVec3> = corners.iter().map(|corner| 2.0 * corner).collect();
    check(&soup(doubled, vec![[0, 1, 3], [1, 2, 3]]), &[vertex(0)], &[0.0, 2.0, 8_f64.sqrt(), 2.0]);
}

/// The flat mesh that comes with Kirsanov's library, of 11 × 11 vertices 0.2 apart and alternating diagonals.
fn kirsanovs_flat_mesh() -> Soup {
    let points = (0..121).map(|k| (1.5 + 0.2 * f64::from(k % 11), -1.0 + 0.2 * f64::from(k / 11))).collect::<Vec<_>>();
    let mut triangles: Vec<[u32; 3]> = grid_triangles(0, 10).collect();
    for quad in triangles.chunks_exact_mut(2).step_by(2) {
        let ([a, b, c], d) = (quad[0], quad[1][2]);
        quad.copy_from_slice(&[[a, b, d], [b, c, d]]);
    }
    soup(flat(&points), triangles)
}

/// tvb-gdist: neighbours are 0.2 apart; all distances from vertex 1 are straight. pygeodesic: 1.2 √2 from (1.9, −0.4) to
/// (3.1, 0.8), by a path along the diagonal; the nearest of two sources.
#[test]
fn kirsanovs_flat_mesh_is_flat() {
    let mesh = kirsanovs_flat_mesh();
    let straight = |sources: &[u32]| {
        let to_source = |at: &DVec3, &source: &u32| at.distance(mesh.positions[source as usize]);
        let nearest = |at| sources.iter().map(|source| to_source(at, source)).fold(f64::INFINITY, f64::min);
        mesh.positions.iter().map(nearest).collect::<Vec<_>>()
    };
    let values = straight(&[1]);
    assert!((values[2] - 0.2).abs() <= ROUNDING);
    check(&mesh, &[vertex(1)], &values);
    check(&mesh, &[vertex(25), vertex(100)], &straight(&[25, 100]));

    let number = |x: f64, y: f64| {
        let place = DVec3::new(x, y, 0.0);
        vertex(mesh.positions.iter().position(|at| at.distance(place) < 0.01).expect("a vertex there") as u32)
    };
    let geometry = Arc::new(ExactGeometry::new(surface(&mesh)));
    let path = shortest_path(&geometry, number(3.1, 0.8), &[number(1.9, -0.4)]).expect("reachable");
    assert!((path.length() - 1.697_056_274_847_714).abs() <= ROUNDING * path.length());
    assert!(path.points.iter().all(|point| (point.position.x - point.position.y - 2.3).abs() <= ROUNDING));
}

/// CGAL: from the centre of a face of a regular tetrahedron of side 2 to its corners ⅔ of the altitude, to the fourth
/// corner 4⁄3.
#[test]
fn a_tetrahedron_from_the_middle_of_a_face() {
    let corners = [DVec3::ONE, DVec3::new(1.0, -1.0, -1.0), DVec3::new(-1.0, 1.0, -1.0), DVec3::new(-1.0, -1.0, 1.0)];
    let positions = corners.iter().map(|corner| corner / 2_f64.sqrt()).collect();
    let mesh = soup(positions, vec![[1, 3, 2], [0, 1, 2], [0, 2, 3], [0, 3, 1]]);
    let middle = Place::Face { face: FaceId(0), weights: [1.0 / 3.0; 3] };
    let altitude = 3_f64.sqrt();
    let near = altitude * 2.0 / 3.0;
    check(&mesh, &[middle], &[altitude * 4.0 / 3.0, near, near, near]);
}

/// CGAL: a pyramid on a triangle of side 6 pointing down, and one on a triangle of side 2 in its midst pointing up, whose
/// three corners are saddles that paths bend at.
#[test]
fn paths_bend_at_saddles() {
    let third = 1.0 / 3_f64.sqrt();
    let [wide, narrow] = [3.0 * third, 2.0 * third];
    let positions = vec![
        DVec3::new(0.0, -3.0, 0.0),
        DVec3::new(-3.0, 0.0, -wide),
        DVec3::new(3.0, 0.0, -wide),
        DVec3::new(0.0, 0.0, 2.0 * wide),
        DVec3::new(-1.0, 0.0, third),
        DVec3::new(1.0, 0.0, third),
        DVec3::new(0.0, 0.0, -narrow),
        DVec3::new(0.0, 3.0, 0.0),
    ];
    let below = [[0, 2, 1], [0, 3, 2], [0, 1, 3]];
    let around = [[1, 2, 6], [2, 5, 6], [2, 3, 5], [3, 4, 5], [3, 1, 4], [1, 6, 4]];
    let above = [[4, 6, 7], [6, 5, 7], [5, 4, 7]];
    let mesh = soup(positions, [below.as_slice(), &around, &above].concat());
    // From a wide corner, straight to the saddles beside it; between them, to the tip above.
    let (down, saddle) = (21_f64.sqrt(), (28.0_f64 / 3.0).sqrt());
    let tip = (saddle * saddle - 1.0).sqrt() + (28.0_f64 / 3.0).sqrt();
    check(&mesh, &[vertex(1)], &[down, 0.0, 6.0, 6.0, saddle, saddle + 2.0, saddle, tip]);
    // With the saddle opposite as a second source, from which the tip below is over the middle of a wide side.
    let (over_side, along) = (third + 12_f64.sqrt(), (31.0_f64 / 3.0).sqrt());
    check(&mesh, &[vertex(1), vertex(5)], &[over_side, 0.0, saddle, saddle, 2.0, 0.0, 2.0, along]);
    check(&mesh, &[vertex(5)], &[over_side, saddle + 2.0, saddle, saddle, 2.0, 0.0, 2.0, along]);
}

/// CGAL: on a flat mesh with a concave boundary, paths bend at its corners, also from and to points inside faces.
#[test]
fn paths_bend_around_corners_of_the_boundary() {
    let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0), (1.0, 1.0), (2.0, 1.0), (0.0, 2.0), (1.0, 2.0)];
    let triangles = vec![[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [3, 4, 7], [3, 7, 6]];
    let mesh = soup(flat(&points), triangles);
    let two = 2_f64.sqrt();
    let five = 5_f64.sqrt();
    check(&mesh, &[vertex(7)], &[five, 2.0, 1.0 + two, two, 1.0, 2.0, 1.0, 0.0]);
    // The middle of the last face but one is at (⅔, 4⁄3).
    let middle = Place::Face { face: FaceId(4), weights: [1.0 / 3.0; 3] };
    let at = DVec2::new(2.0 / 3.0, 4.0 / 3.0);
    let to = |number: usize| DVec2::from(points[number]).distance(at);
    let around = |number: usize| to(4) + DVec2::from(points[number]).distance(DVec2::ONE);
    check(&mesh, &[middle], &[to(0), to(1), to(2), to(3), to(4), around(5), to(6), to(7)]);
}

/// CGAL: a corner of a square is at distance 0 from itself, also where it is given as a point of a face.
#[test]
fn a_corner_is_no_distance_from_itself() {
    for edges in 3..9 {
        let points: Vec<(f64, f64)> = (0..=edges)
            .flat_map(|i| (0..=edges).map(move |j| (f64::from(i) / f64::from(edges), f64::from(j) / f64::from(edges))))
            .collect();
        let mesh = soup(flat(&points), grid_triangles(0, edges).collect());
        let surface = Arc::new(surface(&mesh));
        let (face, corner) = surface.corners_of_vertex(VertexId(edges)).next().expect("a face");
        let mut weights = [0.0; 3];
        weights[corner] = 1.0;
        for place in [vertex(edges), Place::Face { face, weights }] {
            for method in [Method::Exact, Method::Auto, Method::Propagation, Method::Heat] {
                assert_eq!(distance_by(method, &surface, &[place]).values[VertexId(edges)], 0.0, "{method}");
            }
        }
    }
}

/// pmp: half a great circle on a unit sphere of 20,480 triangles is 3.1355 to the last vertex, by its approximation in
/// 32-bit floats; and both directions of a path are as long to 0.1 %, here to rounding.
#[test]
fn the_end_of_a_sphere_is_half_a_great_circle_away() {
    let surface = Arc::new(surface(&icosphere(5)));
    let there = distance_by(Method::Exact, &surface, &[vertex(0)]);
    let farthest = there.values.ids().max_by(|&a, &b| there.values[a].total_cmp(&there.values[b])).expect("vertices");
    let length = there.values[farthest];
    // The sphere's chords are shorter than its arcs by a fraction h²/24 of the edge h, and detours over edges longer.
    assert!((length - 3.1355).abs() < 2e-3 * length, "{length}");
    let back = distance_by(Method::Exact, &surface, &[Place::Vertex(farthest)]);
    assert!((back.values[VertexId(0)] - length).abs() <= 1e-12 * length);
}

/// CGAL: on a flat star whose rim, of irregular density, is the source, distance is straight to the nearest source. Its
/// heat method, of vertices two to six edges from the rim: 0.85 to 1.3 times as far in the mean, and below three quarters
/// on fewer than a tenth.
#[test]
fn heat_from_an_irregular_rim_is_hardly_shorter_than_straight() {
    let (rings, spokes) = (24, 96_u32);
    let mut random = Random::new(5);
    let mut share = || random.share();
    let mut angles: Vec<f64> = Vec::new();
    let mut angle = 0.0;
    for _ in 0..spokes {
        angles.push(angle);
        angle += if share() < 0.3 { 0.2 } else { 1.0 } + 0.3 * share();
    }
    let turn = std::f64::consts::TAU / angle;
    let mut points = vec![(0.0, 0.0)];
    for ring in 1..=rings {
        for angle in &angles {
            let radius = f64::from(ring) / f64::from(rings) * (1.0 + 0.3 * (5.0 * angle * turn).cos());
            points.push((radius * (angle * turn).cos(), radius * (angle * turn).sin()));
        }
    }
    let at = |ring: u32, spoke: u32| 1 + ring * spokes + spoke % spokes;
    let mut triangles: Vec<[u32; 3]> = (0..spokes).map(|spoke| [0, at(0, spoke), at(0, spoke + 1)]).collect();
    for (ring, spoke) in (1..rings).flat_map(|ring| (0..spokes).map(move |spoke| (ring, spoke))) {
        let [a, b] = [at(ring - 1, spoke), at(ring - 1, spoke + 1)];
        let [c, d] = [at(ring, spoke), at(ring, spoke + 1)];
        triangles.extend([[a, c, d], [a, d, b]]);
    }
    let surface = Arc::new(surface(&soup(flat(&points), triangles)));
    let sources: Vec<Place> = (0..spokes).map(|spoke| vertex(at(rings - 1, spoke))).collect();
    let straight = |vertex: VertexId| {
        let to = |source: &Place| source.position(&surface).distance(surface.position(vertex));
        sources.iter().map(to).fold(f64::INFINITY, f64::min)
    };
    let edge = surface.mean_edge();
    let band: Vec<VertexId> =
        surface.vertices().filter(|&vertex| (2.0 * edge..6.0 * edge).contains(&straight(vertex))).collect();
    assert!(band.len() > 500);
    let distance = distance_by(Method::Heat, &surface, &sources);
    let mean = band.iter().map(|&vertex| distance.values[vertex] / straight(vertex)).sum::<f64>() / band.len() as f64;
    assert!((1.0..1.03).contains(&mean), "{mean}");
    let least = band.iter().map(|&vertex| distance.values[vertex] / straight(vertex)).fold(f64::INFINITY, f64::min);
    assert!(least > 0.9, "{least}");
}
