//! From soups of every kind to a manifold, oriented, welded surface.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common;

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{band, book, distance_from, flat, soup, square, surface};
use glam::DVec3;
use heatwalk::exact::exact_distance;
use heatwalk::operator::intrinsic::IntrinsicTriangulation;
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    CutVertex, Element, FaceId, HalfedgeId, HalfedgeMesh, InputTriangle, InputVertex, Soup, Surface, VertexId, go_on,
};
use heatwalk_shapes as shapes;

/// The documented invariants of a half-edge mesh.
fn check(surface: &Surface) {
    let mesh: &HalfedgeMesh = surface.mesh();
    let mut seen = vec![false; mesh.halfedge_count()];
    for halfedge in mesh.halfedges() {
        let twin = mesh.twin(halfedge);
        assert!(twin != halfedge && mesh.twin(twin) == halfedge);
        assert_eq!(mesh.vertex(mesh.next(halfedge)), mesh.vertex(twin), "next and twin leave the tip");
        assert_eq!(mesh.face(mesh.next(halfedge)), mesh.face(halfedge));
        assert!(!std::mem::replace(&mut seen[mesh.next(halfedge).0 as usize], true), "next is a permutation");
        assert!(!(mesh.is_boundary(mesh.face(halfedge)) && mesh.is_boundary(mesh.face(twin))));
    }
    for face in mesh.faces() {
        let around: Vec<HalfedgeId> = mesh.halfedges_of_face(face).collect();
        let corners = around.iter().map(|&halfedge| surface.vertex_of_cut(mesh.vertex(halfedge)));
        assert!(corners.eq(surface.faces()[face]), "faces list their corners in the mesh's order");
    }
    let mut outgoing = 0;
    for vertex in mesh.vertices() {
        for halfedge in mesh.outgoing(vertex) {
            assert_eq!(mesh.vertex(halfedge), vertex);
            outgoing += 1;
        }
    }
    assert_eq!(outgoing, mesh.halfedge_count(), "one fan a vertex holds all its half-edges");
    assert!(mesh.boundary_loops().all(|cap| mesh.is_boundary(cap)));
}

fn checked(soup: &Soup) -> Surface {
    let surface = surface(soup);
    check(&surface);
    surface
}

#[test]
fn known_shapes() {
    for (soup, euler, loops, components) in [
        (shapes::icosphere(2), 2, 0, 1),
        (shapes::uv_sphere(12, 8), 2, 0, 1),
        (shapes::torus(2.0, 0.5, 20, 10), 0, 0, 1),
        (square(4), 1, 1, 1),
        (band(20, 0), 0, 2, 1),
        (band(20, 2), 0, 2, 1),
    ] {
        let surface = checked(&soup);
        assert_eq!(surface.report().euler_characteristic, euler);
        assert_eq!(surface.mesh().euler_characteristic(), euler, "manifold shapes are not cut");
        assert_eq!(surface.report().boundary_loops, loops);
        assert_eq!(surface.mesh().boundary_loops().len(), loops);
        assert_eq!((surface.report().components, surface.mesh().components()), (components, components));
        assert_eq!((surface.report().flipped_faces, surface.report().non_manifold_edges), (0, 0));
    }
}

/// The same surface with its vertices and triangles in an order that has nothing to do with where they are.
fn shuffled(soup: &Soup, random: &mut Random) -> Soup {
    let mut order = |count: usize| {
        let mut order: Vec<usize> = (0..count).collect();
        (1..count).rev().for_each(|i| order.swap(i, random.below(i + 1)));
        order
    };
    let (vertices, triangles) = (order(soup.positions.len()), order(soup.triangles.len()));
    let mut new_number = vec![0; vertices.len()];
    vertices.iter().enumerate().for_each(|(new, &old)| new_number[old] = new as u32);
    let corners = |&old: &usize| soup.triangles[old].map(|vertex| new_number[vertex as usize]);
    Soup::single(
        "shuffled",
        vertices.iter().map(|&old| soup.positions[old]).collect(),
        triangles.iter().map(corners).collect(),
    )
}

#[test]
fn neighbours_on_a_large_surface_are_neighbours_in_memory() {
    let soup = shuffled(&shapes::torus(2.0, 0.7, 240, 120), &mut Random::new(5));
    let surface = checked(&soup);
    let jump = |vertex: VertexId| {
        let other = surface.neighbours(vertex).next().expect("a neighbour");
        vertex.0.abs_diff(other.0) as usize
    };
    let mean = surface.vertices().map(jump).sum::<usize>() / surface.vertex_count();
    assert!(mean < surface.vertex_count() / 20, "{mean} numbers apart, of {} vertices", surface.vertex_count());
    for (input, &position) in soup.positions.iter().enumerate() {
        let vertex = surface.vertex_of_input(InputVertex::from_index(input)).expect("used");
        assert_eq!(surface.position(vertex), position);
    }
    let triangles = surface.faces_in_input_order().map(|face| surface.triangle_of_face(face));
    assert!(triangles.eq((0..soup.triangles.len()).map(InputTriangle::from_index)));
    for (face, corners) in surface.faces().enumerate() {
        let input = soup.triangles[surface.triangle_of_face(face).index()].map(InputVertex);
        assert_eq!(surface.inputs_of_face(face), input);
        assert_eq!(corners.map(Some), input.map(|vertex| surface.vertex_of_input(vertex)));
    }
}

#[test]
fn seam_is_welded() {
    // −0 and +0 are one place.
    let cut = soup(
        flat(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.0, 1.0), (1.0, -0.0), (1.0, 1.0), (9.0, 9.0)]),
        vec![[0, 1, 2], [4, 5, 3]],
    );
    let surface = checked(&cut);
    let report = surface.report();
    assert_eq!((report.input_vertices, report.vertices, report.welded_vertices), (7, 4, 2));
    assert_eq!((report.unreferenced_vertices, report.components, report.boundary_loops), (1, 1, 1));
    let welded = [Some(0), Some(1), Some(2), Some(2), Some(1), Some(3), None].map(|number| number.map(VertexId));
    assert_eq!(surface.vertices_of_inputs().as_slice(), welded);
    assert_eq!(surface.inputs_of_vertex(VertexId(1)), [1, 4].map(InputVertex));
    let inputs = [0, 1].map(|face| surface.inputs_of_face(FaceId(face)));
    assert_eq!(inputs, [[0, 1, 2], [4, 5, 3]].map(|corners| corners.map(InputVertex)));
    let (_, distance) = distance_from(&cut, 0);
    assert!(distance.values.iter().all(|value| value.is_finite()), "heat crosses the seam");
}

#[test]
fn useless_triangles_go() {
    let mut messy = square(3);
    let kept = messy.triangles.len();
    let first = messy.triangles[0];
    let place = messy.positions[0];
    let outside = messy.positions.len() as u32;
    messy.positions.extend([place, DVec3::new(3.0, 0.0, 0.0)]);
    messy.triangles.extend([
        [first[1], first[2], first[0]], // duplicate, turned round
        [first[0], first[2], first[1]], // duplicate, other side
        [first[0], first[0], first[1]], // repeated corner
        [0, outside, first[1]],         // repeated corner once welded
        [0, 4, outside + 1],            // collinear on the x axis
    ]);
    let surface = checked(&messy);
    assert_eq!((surface.report().duplicate_faces, surface.report().degenerate_faces), (2, 3));
    assert_eq!((surface.report().faces, messy.triangles.len()), (kept, kept + 5));
    for triangle in (0..messy.triangles.len()).map(InputTriangle::from_index) {
        let face = surface.face_of_triangle(triangle);
        assert_eq!(face.map(|face| surface.triangle_of_face(face)), Some(triangle).filter(|_| triangle.index() < kept));
    }
    assert_eq!(surface.report().unreferenced_vertices, 1, "the collinear corner; the copy of a corner is welded");
}

#[test]
fn triangles_without_area_that_close_t_junctions_stay() {
    // Above the x axis one triangle, below it three.
    let places = [(0.0, 0.0), (3.0, 0.0), (1.0, 2.0), (1.0, 0.0), (2.0, 0.0), (1.0, -2.0), (2.0, 4.0)];
    let real = [[0, 1, 2], [0, 5, 3], [3, 5, 4], [4, 5, 1]];
    let of = |flat_ones: &[[u32; 3]]| {
        let surface = checked(&soup(flat(&places), [&real, flat_ones].concat()));
        (surface.report().faces, surface.report().degenerate_faces, surface.report().boundary_loops)
    };
    let closing = [[1, 0, 3], [3, 4, 1]];
    assert_eq!(of(&closing), (6, 0, 1));
    let hanging = [[0, 6, 2], [0, 1, 4], [2, 6, 6]];
    assert_eq!(of(&[closing.as_slice(), &hanging].concat()), (6, 3, 1));
}

#[test]
fn triangles_without_area_that_join_others_at_a_vertex_or_a_junction_stay() {
    let distance = |real: &[[u32; 3]], flat_ones: &[[u32; 3]], to: u32| {
        let places = [(0.0, 0.0), (3.0, 0.0), (1.0, 2.0), (1.0, 0.0), (1.0, -2.0), (2.0, -2.0), (1.0, -4.0)];
        let surface = Arc::new(checked(&soup(flat(&places), [real, flat_ones].concat())));
        exact_distance(&surface, &[VertexId(2)], &mut go_on).expect("a valid source")[VertexId(to)]
    };
    // Below the x axis another triangle, with a corner on the long edge of the one above.
    let at_vertex = [[0, 1, 2], [3, 4, 5]];
    assert_eq!(distance(&at_vertex, &[], 4), f64::INFINITY);
    assert_eq!(distance(&at_vertex, &[[0, 3, 1]], 4), 4.0);
    // Two triangles have one of the short edges in common, and the one above has the long one alone.
    let at_junction = [[0, 1, 2], [0, 3, 4], [3, 0, 6]];
    assert_eq!(distance(&at_junction, &[[1, 0, 3]], 4), 4.0);
}

#[test]
fn flipped_faces_are_turned() {
    let mut flipped = shapes::icosphere(2);
    for triangle in [3, 50, 51, 200] {
        flipped.triangles[triangle].swap(0, 1);
    }
    let surface = checked(&flipped);
    assert_eq!(surface.report().flipped_faces, 4);
    assert_eq!(surface.mesh().boundary_loops().len(), 0);
    // The majority pointed outward.
    assert!(surface.mesh().faces().all(|face| surface.face_normal(face).dot(surface.corners(face)[0]) > 0.0));
}

#[test]
fn moebius_strip_is_cut_but_whole() {
    let soup = band(40, 1);
    let surface = checked(&soup);
    assert_eq!((surface.report().euler_characteristic, surface.report().boundary_loops), (0, 1));
    assert_eq!((surface.report().components, surface.report().non_manifold_edges), (1, 0));
    assert!(surface.mesh().vertex_count() > surface.vertex_count(), "copies along the cut");
    assert_eq!(surface.boundary_vertices().iter().filter(|&&boundary| boundary).count(), 80, "cuts are no boundary");
    // Nothing marks the cut in the distance: going round either way is the same, by the strip's half-turn symmetry.
    // A barrier would make one way longer by many edges.
    let (_, distance) = distance_from(&soup, 2);
    for segment in 1..40 {
        let (there, back) =
            (distance.values[VertexId(segment * 5 + 2)], distance.values[VertexId((40 - segment) * 5 + 2)]);
        // The diagonals of the quads are not symmetric; they shift values by less than a tenth of an edge of 0.3.
        assert!((there - back).abs() < 0.03, "{segment}: {there} {back}");
    }
}

#[test]
fn non_manifold_edge_carries_heat() {
    let soup = book(3, 8);
    let surface = checked(&soup);
    assert_eq!((surface.report().non_manifold_edges, surface.report().components), (8, 1));
    assert_eq!(surface.mesh().components(), 3, "cut into pages");
    assert_eq!(surface.report().boundary_loops, 3);
    // From the middle of one page's outer edge straight over the spine to the others'.
    let source = common::nearest(&surface, DVec3::new(1.0, 0.0, 0.5));
    let (solver, distance) = distance_from(&soup, source.0);
    for page in 1..3 {
        let angle = TAU * f64::from(page) / 3.0;
        let end = common::nearest(solver.surface(), DVec3::new(angle.cos(), angle.sin(), 0.5));
        // Edges of 1/8 on a way of 2: the method's offset is about half an edge.
        assert!((distance.values[end] - 2.0).abs() < 0.1, "{}", distance.values[end]);
    }
}

#[test]
fn touching_fans_share_a_point() {
    let bow_tie =
        soup(flat(&[(0.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)]), vec![[0, 1, 2], [0, 4, 3]]);
    let surface = checked(&bow_tie);
    assert_eq!((surface.mesh().vertex_count(), surface.vertex_count()), (6, 5));
    assert_eq!(surface.vertex_of_cut(CutVertex(5)), VertexId(0));
    assert_eq!((surface.report().components, surface.mesh().components(), surface.report().boundary_loops), (1, 2, 2));
    let (_, distance) = distance_from(&bow_tie, 1);
    assert!(distance.values.iter().all(|value| value.is_finite()));
}

#[test]
fn sheets_that_touch_are_no_short_cut() {
    // A strip of triangles bent to a ring whose two ends meet in one corner.
    let count = 12;
    let mut positions = Vec::new();
    for step in 0..=count {
        let angle = TAU * f64::from(step) / f64::from(count);
        let inside = DVec3::new(angle.cos(), angle.sin(), 0.0);
        // The last step comes back to the first inner position, but not to the first outer one.
        let outside = inside * 2.0 + DVec3::Z * 0.1 * f64::from(step);
        positions.extend([if step == count { DVec3::X } else { inside }, outside]);
    }
    let quads = (0..count).map(|step| 2 * step);
    let triangles: Vec<[u32; 3]> = quads.flat_map(|i| [[i, i + 1, i + 3], [i, i + 3, i + 2]]).collect();
    let ring = checked(&soup(positions.clone(), triangles.clone()));
    assert_eq!((ring.report().components, ring.vertex_count(), ring.report().welded_vertices), (1, 26, 0));
    let (solver, distance) = distance_from(&soup(positions.clone(), triangles.clone()), 0);
    let end = solver.surface().vertex_of_input(InputVertex(2 * count)).expect("used");
    assert!(distance.values[end] > 5.0, "all the way around");
    // Joined where the file joins them.
    let closed = triangles.iter().map(|triangle| triangle.map(|vertex| if vertex == 2 * count { 0 } else { vertex }));
    assert_eq!(checked(&soup(positions, closed.collect())).vertex_count(), 25);
}

#[test]
fn a_touch_that_holds_pieces_together_is_kept() {
    let positions = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (-1.0, 0.0), (-1.0, -1.0), (0.0, 0.0)]);
    let two_fans = checked(&soup(positions, vec![[0, 1, 2], [5, 3, 4]]));
    assert_eq!((two_fans.report().components, two_fans.vertex_count(), two_fans.report().welded_vertices), (1, 5, 1));
}

#[test]
fn separate_parts_are_infinitely_far() {
    let mut two = square(4);
    let first = two.positions.len();
    let other = shapes::icosphere(1);
    two.positions.extend(other.positions.iter().map(|&position| position + DVec3::X * 10.0));
    two.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + first as u32)));
    let (solver, distance) = distance_from(&two, 0);
    assert_eq!(solver.surface().report().components, 2);
    assert!(distance.values.as_slice()[..first].iter().all(|value| value.is_finite()));
    assert!(distance.values.as_slice()[first..].iter().all(|value| *value == f64::INFINITY));
    assert_eq!(distance.unreachable(), other.positions.len());
    assert!(distance.max() < 2.0);
    assert!(distance.gradients(solver.surface()).expect("its surface").iter().all(|gradient| gradient.is_finite()));
    let both = [heatwalk::Place::Vertex(VertexId(0)), heatwalk::Place::Vertex(VertexId::from_index(first))];
    let distance = solver.distance(&both).expect("sources");
    assert_eq!(
        (distance.values[VertexId(0)], distance.values[VertexId::from_index(first)]),
        (0.0, 0.0),
        "one source a part is exact in each"
    );
}

#[test]
fn bad_input_is_named() {
    let corners = || flat(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    let error = |positions, triangles| Surface::build(&soup(positions, triangles)).err();
    let out_of_range = SurfaceError::IndexOutOfRange { triangle: 1, vertex: 3, vertices: 3 };
    assert_eq!(error(corners(), vec![[0, 1, 2], [0, 1, 3]]), Some(out_of_range));
    for bad in [f64::NAN, f64::INFINITY] {
        let mut positions = corners();
        positions[2].y = bad;
        assert_eq!(error(positions, vec![[0, 1, 2]]), Some(SurfaceError::NotFinite { vertex: 2 }));
    }
    let mut far = corners();
    far[1].z = -1.1e150;
    assert_eq!(error(far, vec![[0, 1, 2]]), Some(SurfaceError::TooFar { vertex: 1 }));
    assert!(matches!(error(corners(), vec![]), Some(SurfaceError::Empty { .. })));
    assert!(matches!(error(corners(), vec![[0, 1, 1]]), Some(SurfaceError::Empty { .. })));
}

#[test]
fn smallest_surface_works() {
    let (_, distance) = distance_from(&soup(flat(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]), vec![[0, 1, 2]]), 0);
    assert_eq!(distance.values[VertexId(0)], 0.0);
    assert!(distance.values[VertexId(1)] > 0.5 && distance.values[VertexId(1)] < 1.5);
}

#[test]
fn around_one_vertex_each_edge_is_flipped_few_times() {
    // The rim goes up and down, so that no edge to the vertex stays for long.
    let flips = |count: u32| {
        let on_rim = |corner: u32| {
            let (y, x) = (TAU * f64::from(corner) / f64::from(count)).sin_cos();
            DVec3::new(x, y, 0.2 * (7.0 * TAU * f64::from(corner) / f64::from(count)).sin())
        };
        let positions = std::iter::once(DVec3::ZERO).chain((0..count).map(on_rim)).collect();
        let triangles = (0..count).map(|corner| [0, 1 + corner, 1 + (corner + 1) % count]).collect();
        IntrinsicTriangulation::delaunay(&surface(&soup(positions, triangles))).flips() as f64
    };
    for count in [1000, 8000] {
        let flips = flips(count);
        assert!(flips > 0.5 * f64::from(count) && flips < 4.0 * f64::from(count), "{flips} flips of {count} edges");
    }
}

#[test]
fn the_tufted_cover_is_used_where_it_is_needed() {
    let delaunay = |soup: &Soup| IntrinsicTriangulation::delaunay(&surface(soup));
    // Closed, or with a boundary that lies opposite sharp angles only.
    for soup in [shapes::icosphere(2), square(3)] {
        assert_eq!(delaunay(&soup).sheets(), 1);
    }
    // Edges of three faces, no orientation, an obtuse angle opposite the boundary.
    let obtuse = soup(flat(&[(0.0, 0.0), (4.0, 0.0), (2.0, 0.5)]), vec![[0, 1, 2]]);
    for soup in [book(3, 3), band(20, 1), obtuse] {
        assert_eq!(delaunay(&soup).sheets(), 2);
    }
    // A kite cut along its longer diagonal.
    let kite = soup(flat(&[(0.0, 0.0), (3.0, 1.0), (6.0, 0.0), (3.0, -1.0)]), vec![[0, 3, 2], [0, 2, 1]]);
    let triangulation = delaunay(&kite);
    assert_eq!((triangulation.flips(), triangulation.sheets()), (1, 1));
}
