//! Surfaces built on several threads are those built on one, to the last bit.
#![cfg(not(target_arch = "wasm32"))]

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_shapes as shapes;
use heatwalk_surface::{BridgeRule, Bridges, Element, Error, FaceId, InputTriangle, Soup, Surface};
use rand::RngExt;
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_xoshiro::SplitMix64;

const COUNTS: [usize; 3] = [2, 3, 8];

fn threads(count: usize) -> NonZeroUsize {
    NonZeroUsize::new(count).expect("a thread")
}

fn shuffled(mut soup: Soup) -> Soup {
    let mut random = SplitMix64::seed_from_u64(5);
    let mut place: Vec<u32> = (0..soup.positions.len() as u32).collect();
    place.shuffle(&mut random);
    let old = soup.positions.clone();
    for (position, &new) in old.iter().zip(&place) {
        soup.positions[new as usize] = *position;
    }
    for triangle in &mut soup.triangles {
        *triangle = triangle.map(|corner| place[corner as usize]);
    }
    soup.triangles.shuffle(&mut random);
    soup
}

/// A vertex for each corner.
fn unwelded(soup: &Soup) -> Soup {
    let positions = soup.triangles.as_flattened().iter().map(|&vertex| soup.positions[vertex as usize]).collect();
    let triangles = (0..soup.triangles.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    Soup::single("corners", positions, triangles)
}

/// Every kind of damage: holes, flipped, duplicate and degenerate triangles, fins on edges, fans that touch in a vertex,
/// vertices that nothing uses.
fn damaged(mut soup: Soup) -> Soup {
    let mut random = SplitMix64::seed_from_u64(9);
    soup.triangles.retain(|_| random.random_range(0..40) > 0);
    for index in 0..soup.triangles.len() {
        let triangle @ [a, b, _] = soup.triangles[index];
        match random.random_range(0..50) {
            0 => soup.triangles[index].swap(1, 2),
            1 => soup.triangles.push(triangle),
            2 => soup.triangles.push([b, a, a]),
            3 => {
                soup.positions.push(soup.positions[a as usize] * 1.1);
                soup.triangles.push([a, b, soup.positions.len() as u32 - 1]);
            }
            4 => {
                let first = soup.positions.len() as u32;
                soup.positions.extend([1.2, 1.3].map(|scale| soup.positions[a as usize] * scale + DVec3::X));
                soup.triangles.push([a, first, first + 1]);
            }
            5 => soup.positions.push(DVec3::NAN),
            _ => (),
        }
    }
    Soup::single("damaged", soup.positions, soup.triangles)
}

fn soups() -> Vec<Soup> {
    let torus = shapes::torus(2.0, 0.7, 260, 130);
    let terrain = shapes::terrain(150);
    vec![
        torus.clone(),
        terrain.clone(),
        shuffled(torus.clone()),
        shuffled(unwelded(&terrain)),
        damaged(torus.clone()),
        damaged(terrain),
        shuffled(damaged(torus.clone())),
        unwelded(&damaged(torus)),
        shapes::icosphere(2),
    ]
}

/// Everything that is told of a surface.
fn assert_same(one: &Surface, other: &Surface) {
    assert_eq!(one.report(), other.report());
    assert_eq!(one.mean_edge().to_bits(), other.mean_edge().to_bits());
    assert!(one.positions() == other.positions(), "positions");
    assert_eq!(one.faces(), other.faces());
    assert_eq!(one.vertices_of_inputs(), other.vertices_of_inputs());
    assert_eq!(one.components(), other.components());
    assert_eq!(one.boundary_vertices(), other.boundary_vertices());
    assert_eq!(one.is_oriented_manifold(), other.is_oriented_manifold());
    for vertex in one.vertices() {
        assert!(one.corners_of_vertex(vertex).eq(other.corners_of_vertex(vertex)), "corners of {vertex}");
        assert_eq!(one.inputs_of_vertex(vertex), other.inputs_of_vertex(vertex));
    }
    for face in one.mesh().faces() {
        assert_eq!(one.inputs_of_face(face), other.inputs_of_face(face));
        assert_eq!(one.triangle_of_face(face), other.triangle_of_face(face));
        for halfedge in [0, 1, 2].map(|k| face.halfedge(k)) {
            assert_eq!(one.edges().next_on_edge(halfedge), other.edges().next_on_edge(halfedge));
        }
    }
    let (mesh, others) = (one.mesh(), other.mesh());
    assert_eq!(mesh.halfedge_count(), others.halfedge_count());
    assert!(mesh.boundary_loops().eq(others.boundary_loops()));
    for halfedge in mesh.halfedges() {
        let told = |mesh: &heatwalk_surface::HalfedgeMesh| {
            (mesh.vertex(halfedge), mesh.twin(halfedge), mesh.next(halfedge), mesh.face(halfedge))
        };
        assert_eq!(told(mesh), told(others));
    }
    for vertex in mesh.vertices() {
        assert_eq!(mesh.halfedge_of_vertex(vertex), others.halfedge_of_vertex(vertex));
        assert_eq!(one.vertex_of_cut(vertex), other.vertex_of_cut(vertex));
    }
}

#[test]
fn the_number_of_threads_makes_no_difference() {
    for soup in soups() {
        let one = Surface::build(&soup).expect("a surface");
        for count in COUNTS {
            assert_same(&one, &Surface::build_on(&soup, threads(count)).expect("a surface"));
        }
        let triangles = (0..soup.triangles.len()).map(InputTriangle::from_index);
        assert!(triangles.filter_map(|triangle| one.face_of_triangle(triangle)).count() == one.face_count());
    }
}

#[test]
fn the_shapes_have_what_is_claimed_of_them() {
    let reports: Vec<_> =
        soups().iter().map(|soup| Surface::build(soup).expect("a surface").report().clone()).collect();
    let damaged = &reports[6];
    assert!(damaged.degenerate_faces > 100 && damaged.duplicate_faces > 100 && damaged.flipped_faces > 100);
    assert!(damaged.non_manifold_edges > 100 && damaged.boundary_loops > 100 && damaged.unreferenced_vertices > 100);
    assert!(reports[3].welded_vertices > 10_000 && reports[7].welded_vertices > 10_000);
    let scattered = Surface::build(&soups()[2]).expect("a surface");
    assert_ne!(scattered.triangle_of_face(FaceId(0)), InputTriangle(0));
    assert!(scattered.vertices().zip(0..).any(|(vertex, number)| scattered.inputs_of_vertex(vertex)[0].0 != number));
}

#[test]
fn the_first_error_is_told() {
    let mut soup = shapes::torus(2.0, 0.7, 260, 130);
    let vertices = soup.positions.len();
    for triangle in [60_000, 20_000, 40_000] {
        soup.triangles[triangle][1] = u32::MAX;
    }
    let error = Error::IndexOutOfRange { triangle: 20_000, vertex: u32::MAX.into(), vertices };
    assert_eq!(Surface::build_on(&soup, threads(8)).map(|_| ()), Err(error));
    let mut soup = shapes::torus(2.0, 0.7, 260, 130);
    for vertex in [30_000, 10_000, 20_000] {
        soup.positions[vertex] = DVec3::NAN;
    }
    assert_eq!(Surface::build_on(&soup, threads(8)).map(|_| ()), Err(Error::NotFinite { vertex: 10_000 }));
}

#[test]
fn contacts_found_on_several_threads_are_the_same() {
    // Near copies of so many triangles that all threads have something to do.
    let mut soup = Soup::default();
    for scale in [1.0, 1.001] {
        let part = shapes::torus(2.0, 0.7, 160, 120);
        soup.add(part.positions.iter().map(|&position| scale * position), &part.triangles);
        soup.end_part("part");
    }
    let surface = Surface::build(&soup).expect("a surface");
    let one = Bridges::find(&surface, BridgeRule::Automatic);
    assert!(one.portals().len() > 1000, "{}", one.portals().len());
    for count in COUNTS {
        assert!(one == Bridges::find_on_threads(&surface, BridgeRule::Automatic, threads(count)), "{count}");
    }
}
