//! What building makes of good and bad tetrahedra.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::mesh;
use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_volume::{Error, TetId, TetMesh, TetPoint, TetSoup, shapes};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

/// Two tetrahedra on both sides of a triangle.
fn pair() -> TetSoup {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, -DVec3::Z];
    TetSoup { positions, tetrahedra: vec![[0, 1, 2, 3], [0, 2, 1, 4]] }
}

#[test]
fn every_tetrahedron_knows_the_others_across_its_faces() {
    let mesh = mesh(&pair());
    let beyond: Vec<_> = (0..4).map(|corner| mesh.neighbor(TetId(0), corner)).collect();
    assert_eq!(beyond, [None, None, None, Some(TetId(1))]);
    assert_eq!(mesh.report().boundary_faces, 6);
    assert_eq!(mesh.tetrahedra_of(VertexId(0)).count(), 2);
    assert_eq!(mesh.tetrahedra_of(VertexId(4)).collect::<Vec<_>>(), [TetId(1)]);
    assert!((mesh.report().volume - 1.0 / 3.0).abs() < 1e-15);
}

#[test]
fn the_boundary_faces_outward() {
    for soup in [shapes::ball(3, 0.2), shapes::pierced_cube(0.4, 2, 0.1), shapes::cave(0.5, 2, 0.1)] {
        let mesh = mesh(&soup);
        let boundary = mesh.boundary();
        let position = |vertex: u32| boundary.soup.positions[vertex as usize];
        // By the divergence theorem.
        let signed = |&[a, b, c]: &[u32; 3]| position(a).dot(position(b).cross(position(c))) / 6.0;
        let volume: f64 = boundary.soup.triangles.iter().map(signed).sum();
        assert!((volume - mesh.report().volume).abs() < 1e-12, "{volume}");
        for (&vertex, &position) in boundary.vertices.iter().zip(&boundary.soup.positions) {
            assert_eq!(mesh.position(vertex), position);
        }
        assert_eq!(boundary.tetrahedra.len(), mesh.report().boundary_faces);
        heatwalk::Surface::build(&boundary.soup).unwrap();
    }
}

#[test]
fn inverted_flat_and_duplicate_tetrahedra_and_lone_vertices_are_counted() {
    let mut soup = pair();
    soup.positions.extend([DVec3::new(9.0, 9.0, 9.0), DVec3::new(0.5, 0.5, 0.0)]);
    soup.tetrahedra[1] = [0, 1, 2, 4];
    soup.tetrahedra.extend([[0, 1, 2, 6], [3, 2, 1, 0], [0, 0, 1, 2]]);
    let mesh = mesh(&soup);
    let report = mesh.report();
    assert_eq!((report.tetrahedra, report.inverted_tetrahedra), (2, 1));
    assert_eq!((report.flat_tetrahedra, report.duplicate_tetrahedra), (2, 1));
    assert_eq!((report.vertices, report.unreferenced_vertices), (5, 2));
    assert_eq!(mesh.vertex_of_input(5), None);
    assert_eq!(mesh.tetrahedron_of_input(1), Some(TetId(1)));
    assert_eq!(mesh.tetrahedron_of_input(2), None);
    assert_eq!(mesh.to_inputs(&[0.0, 1.0, 2.0, 3.0, 4.0], -1.0), [0.0, 1.0, 2.0, 3.0, 4.0, -1.0, -1.0]);
}

#[test]
fn rejects_what_is_no_mesh_by_the_numbers_of_the_input() {
    let refused = |change: fn(&mut TetSoup)| {
        let mut soup = pair();
        change(&mut soup);
        TetMesh::build(&soup).unwrap_err()
    };
    assert_eq!(refused(|soup| soup.tetrahedra.clear()), Error::NoTetrahedra);
    let out_of_range = Error::IndexOutOfRange { tetrahedron: 1, vertex: 5, vertices: 5 };
    assert_eq!(refused(|soup| soup.tetrahedra[1][3] = 5), out_of_range);
    assert!(matches!(refused(|soup| soup.positions[4].x = f64::NAN), Error::NotFinite { vertex: 4, .. }));
    assert_eq!(refused(|soup| soup.positions.fill(DVec3::ONE)), Error::AllFlat { tetrahedra: 2 });
    let third = refused(|soup| {
        soup.positions.extend([DVec3::ONE, DVec3::new(0.2, 0.2, 2.0)]);
        soup.tetrahedra.insert(0, [0, 0, 1, 2]);
        soup.tetrahedra.push([0, 1, 2, 6]);
    });
    assert_eq!(third, Error::NonManifoldFace { tetrahedra: [1, 2, 3], vertices: [0, 1, 2] });
    assert!(third.to_string().contains("tetrahedra [1, 2, 3]"), "{third}");
}

#[test]
fn scale_and_place_do_not_change_what_is_flat() {
    for (scale, shift) in [(1e-30, 0.0), (1e30, 0.0), (1.0, 1e5)] {
        let mut soup = shapes::ball(3, 0.2);
        soup.positions.iter_mut().for_each(|position| *position = *position * scale + DVec3::splat(shift));
        assert_eq!(mesh(&soup).report().flat_tetrahedra, 0, "{scale} {shift}");
    }
}

#[test]
fn places_inside_are_found_with_their_weights() {
    let mesh = mesh(&shapes::pierced_cube(0.4, 2, 0.1));
    let mut random = SplitMix64::seed_from_u64(3);
    for _ in 0..100 {
        let tetrahedron = TetId(random.random_range(0..mesh.tetrahedron_count()) as u32);
        let shares: [f64; 4] = random.random();
        let sum: f64 = shares.iter().sum();
        let place = TetPoint::Inside { tetrahedron, weights: shares.map(|share| share / sum) };
        let position = place.position(&mesh);
        let found = mesh.locate(position).unwrap();
        assert!(found.position(&mesh).distance(position) < 1e-12);
    }
    assert_eq!(mesh.locate(DVec3::ZERO), None, "in the hole");
    assert_eq!(mesh.locate(DVec3::splat(1.001)), None, "outside");
}

#[test]
fn rejects_places_that_are_not_there() {
    let mesh = mesh(&pair());
    let inside = |tetrahedron, weights| TetPoint::Inside { tetrahedron: TetId(tetrahedron), weights }.checked(&mesh);
    assert_eq!(inside(0, [0.0, 1.0, 0.0, 0.0]), Ok(TetPoint::Vertex(VertexId(1))));
    assert!(matches!(inside(2, [0.25; 4]), Err(Error::NoSuchTetrahedron { tetrahedron: 2, tetrahedra: 2 })));
    for weights in [[0.5; 4], [1.5, -0.5, 0.0, 0.0], [f64::NAN, 1.0, 0.0, 0.0]] {
        assert!(matches!(inside(1, weights), Err(Error::BadWeights { tetrahedron: 1, .. })), "{weights:?}");
    }
    let vertex = TetPoint::Vertex(VertexId(5)).checked(&mesh);
    assert_eq!(vertex, Err(Error::NoSuchVertex { vertex: 5, vertices: 5 }));
}

#[test]
fn a_regular_tetrahedron_has_its_angles() {
    let positions =
        vec![DVec3::ONE, DVec3::new(1.0, -1.0, -1.0), DVec3::new(-1.0, 1.0, -1.0), DVec3::new(-1.0, -1.0, 1.0)];
    let quality = mesh(&TetSoup { positions, tetrahedra: vec![[0, 1, 2, 3]] }).quality();
    let expected = (1.0_f64 / 3.0).acos().to_degrees();
    for angle in [quality.least_angle, quality.largest_angle, quality.mean_least_angle] {
        assert!((angle - expected).abs() < 1e-12, "{quality:?}");
    }
}

/// The first tetrahedron whose barycentric weights at a place are all above −10⁻⁹, found by trying each.
fn first_around(mesh: &TetMesh, place: DVec3) -> Option<TetId> {
    (0..mesh.tetrahedron_count() as u32).map(TetId).find(|&tetrahedron| {
        let corners = mesh.corners(tetrahedron);
        let six_volumes = |[a, b, c, d]: [DVec3; 4]| (b - a).cross(c - a).dot(d - a);
        let weight = |corner: usize| {
            let mut moved = corners;
            moved[corner] = place;
            six_volumes(moved) / six_volumes(corners)
        };
        (0..4).all(|corner| weight(corner) >= -1e-9)
    })
}

#[test]
fn places_are_found_in_the_first_tetrahedron_that_has_them() {
    let mut random = SplitMix64::seed_from_u64(12);
    for soup in [pair(), shapes::cube(5, 0.2), shapes::cube(4, 0.0), shapes::cave(0.5, 2, 0.1)] {
        let mesh = mesh(&soup);
        let (low, high) = mesh.bounds();
        let mut places: Vec<DVec3> = mesh.positions().to_vec();
        for tetrahedron in 0..mesh.tetrahedron_count() as u32 {
            let [a, b, c, _] = mesh.corners(TetId(tetrahedron));
            places.extend([(a + b) / 2.0, (a + b + c) / 3.0]);
        }
        places.extend((0..1000).map(|_| {
            let shares = 1.2 * DVec3::from_array(random.random()) - 0.1;
            low + shares * (high - low)
        }));
        places.extend([DVec3::NAN, DVec3::INFINITY, DVec3::splat(1e300)]);
        for place in places {
            let found = mesh.locate(place);
            let tetrahedron = found.map(|point| match point {
                TetPoint::Inside { tetrahedron, .. } => tetrahedron,
                TetPoint::Vertex(_) => panic!("{point:?}"),
            });
            assert_eq!(tetrahedron, first_around(&mesh, place), "{place}");
            assert!(found.is_none_or(|point| point.position(&mesh).distance(place) < 1e-8));
        }
    }
}
