//! Distances and paths with walls.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{nearest, surface};
use glam::DVec3;
use heatwalk::{
    Costs, DistanceOptions, DistanceSolver, Element, FaceId, HalfedgeId, InputTriangle, Method, Place, Soup, Surface,
    VertexData, VertexId, Walls, descend, go_on,
};
use heatwalk_shapes::{grid, icosphere, torus};

fn distances(surface: &Arc<Surface>, source: VertexId) -> VertexData<f64> {
    let mut solver = DistanceSolver::new(Arc::clone(surface));
    solver.distance(&[source], &DistanceOptions::by(Method::Exact), &mut go_on).expect("a source").distance.values
}

/// A tenth of the faces, in clusters around random ones.
fn random_walls(surface: &Surface, random: &mut Random) -> Walls {
    let mut is_wall = vec![false; surface.face_count()];
    while is_wall.iter().filter(|&&wall| wall).count() < surface.face_count() / 10 {
        let mut face = FaceId(random.below(surface.face_count()) as u32);
        for _ in 0..6 {
            is_wall[face.0 as usize] = true;
            let side = surface.mesh().twin(face.halfedge(random.below(3)));
            if (side.0 as usize) < 3 * surface.face_count() {
                face = side.triangle();
            }
        }
    }
    let faces = (0..).map(FaceId).zip(&is_wall).filter(|&(_, &wall)| wall).map(|(face, _)| face).collect();
    Walls { faces, edges: Vec::new() }
}

fn open_vertex(surface: &Surface, random: &mut Random) -> VertexId {
    loop {
        let vertex = VertexId::from_index(random.below(surface.vertex_count()));
        if !surface.is_in_wall(Place::Vertex(vertex)) {
            return vertex;
        }
    }
}

#[test]
fn distances_with_walls_are_those_of_the_surface_without_their_faces() {
    let mut random = Random::new(1);
    for soup in [icosphere(3), torus(1.0, 0.4, 40, 20), grid(20, 20)] {
        let whole = surface(&soup);
        for _ in 0..3 {
            let walls = random_walls(&whole, &mut random);
            let walled = Arc::new(whole.walled(&walls).expect("faces of the surface"));
            let is_open = |triangle: usize| {
                let face = whole.face_of_triangle(InputTriangle(triangle as u32)).expect("a kept triangle");
                !walls.faces.contains(&face)
            };
            let triangles = soup.triangles.iter().enumerate().filter(|&(index, _)| is_open(index));
            let rest = Soup::single("rest", soup.positions.clone(), triangles.map(|(_, &corners)| corners).collect());
            let rest = Arc::new(surface(&rest));
            let source = open_vertex(&walled, &mut random);
            let input = walled.inputs_of_vertex(source)[0];
            let expected = distances(&rest, rest.vertex_of_input(input).expect("an open vertex"));
            let found = distances(&walled, source);
            let mut compared = 0;
            for vertex in rest.vertices() {
                let there = walled.vertex_of_input(rest.inputs_of_vertex(vertex)[0]).expect("kept there too");
                let (expected, found) = (expected[vertex], found[there]);
                assert!(expected == found || (expected - found).abs() <= 1e-12 * expected, "{expected} {found}");
                compared += usize::from(expected.is_finite());
            }
            assert!(compared > rest.vertex_count() / 2, "{compared} of {}", rest.vertex_count());
        }
    }
}

#[test]
fn what_walls_cost_makes_no_difference() {
    let mut random = Random::new(3);
    let whole = Arc::new(surface(&icosphere(3)));
    let walls = random_walls(&whole, &mut random);
    let source = open_vertex(&whole.walled(&walls).expect("faces of the surface"), &mut random);
    let costs = |of_wall: f64, of_open: &dyn Fn(FaceId) -> f64| {
        let cost = |face| if walls.faces.contains(&face) { of_wall } else { of_open(face) };
        let of_face = (0..whole.face_count() as u32).map(FaceId).map(cost).collect();
        Costs::new(&whole, of_face).expect("in range")
    };
    let answer = |costs: Costs, are_walls_first: bool, method: Method| {
        let mut solver = DistanceSolver::new(Arc::clone(&whole));
        if are_walls_first {
            solver.set_walls(&walls).expect("faces of the surface");
        }
        solver.set_costs(Some(costs));
        solver.set_walls(&walls).expect("faces of the surface");
        solver.distance(&[source], &DistanceOptions::by(method), &mut go_on).expect("a source")
    };
    let halves = |face: FaceId| if face.index().is_multiple_of(2) { 2.0 } else { 3.0 };
    for method in [Method::Heat, Method::Propagation] {
        let expected = answer(costs(2.0, &halves), true, method).distance.values;
        for (of_wall, are_walls_first) in [(1.0, true), (1000.0, false), (0.001, true)] {
            let found = answer(costs(of_wall, &halves), are_walls_first, method).distance.values;
            assert_eq!(found, expected, "walls that cost {of_wall}");
        }
    }
    // Where all that can be walked on costs the same, distances are exact.
    let answer = answer(costs(1.0, &|_| 5.0), false, Method::Auto);
    assert_eq!(answer.method, Method::Exact);
    let plain = distances(&Arc::new(whole.walled(&walls).expect("faces of the surface")), source);
    for (found, plain) in answer.distance.values.iter().zip(plain.iter()) {
        assert!(*found == 5.0 * plain || (found - 5.0 * plain).abs() <= 1e-12 * found, "{found} {plain}");
    }
}

#[test]
fn no_path_enters_a_wall() {
    let mut random = Random::new(2);
    let whole = surface(&icosphere(3));
    let mut arrived = 0;
    for _ in 0..100 {
        let walls = random_walls(&whole, &mut random);
        let walled = Arc::new(whole.walled(&walls).expect("faces of the surface"));
        let source = open_vertex(&walled, &mut random);
        let mut solver = DistanceSolver::new(Arc::clone(&walled));
        let answer = solver.distance(&[source], &DistanceOptions::default(), &mut go_on).expect("a source");
        for _ in 0..10 {
            let from = open_vertex(&walled, &mut random);
            let Ok(path) = descend(&walled, &answer.distance, from) else {
                assert!(answer.distance.values[from].is_infinite());
                continue;
            };
            arrived += 1;
            assert!(path.points.iter().all(|point| !walled.is_wall(point.face)));
        }
    }
    assert!(arrived > 800, "{arrived}");
}

#[test]
fn a_line_of_walls_along_edges_is_walked_around() {
    let side = 10;
    let square = surface(&grid(side, side));
    let corner = |x: f64, z: f64| {
        let [low, high] = [f64::min, f64::max].map(|extreme: fn(f64, f64) -> f64| {
            let first = square.position(VertexId(0));
            square
                .positions()
                .iter()
                .fold([first.x, first.z], |so_far, at| [extreme(so_far[0], at.x), extreme(so_far[1], at.z)])
        });
        let at = |low: f64, high: f64, share: f64| low + (high - low) * share;
        nearest(&square, DVec3::new(at(low[0], high[0], x), 0.0, at(low[1], high[1], z)))
    };
    // From the middle of one side of the square to its centre.
    let line = heatwalk::edge_path(&square, corner(0.5, 0.0), corner(0.5, 0.5)).expect("connected");
    let edges = line.windows(2).map(|pair| {
        let leaves = |&halfedge: &HalfedgeId| {
            let mut ends = square.ends(halfedge);
            ends.sort_unstable();
            ends == [pair[0].min(pair[1]), pair[0].max(pair[1])]
        };
        (0..3 * square.face_count() as u32).map(HalfedgeId).find(leaves).expect("an edge")
    });
    let walls = Walls { faces: Vec::new(), edges: edges.collect() };
    let walled = Arc::new(square.walled(&walls).expect("edges of the surface"));
    assert_eq!(walled.vertex_count(), square.vertex_count() + line.len() - 1, "all but the end inside have two sides");
    assert_eq!(walled.report().components, 1);
    let [from, to, end] = [corner(0.4, 0.0), corner(0.6, 0.0), corner(0.5, 0.5)];
    let around = (square.position(from) - square.position(end)).length();
    let found = distances(&walled, from)[to];
    assert!((found - 2.0 * around).abs() < 1e-12 * found, "{found} {around}");
}

#[test]
fn a_source_in_a_wall_is_refused() {
    let whole = surface(&icosphere(2));
    let walled = whole.walled(&Walls { faces: vec![FaceId(7)], edges: Vec::new() }).expect("a face");
    let inside = Place::Face { face: FaceId(7), weights: [0.2, 0.3, 0.5] };
    let error = DistanceSolver::new(walled)
        .distance(&[inside], &DistanceOptions::default(), &mut go_on)
        .expect_err("in a wall");
    assert_eq!(error.code(), "source-in-wall");
    assert!(error.to_string().contains("face 7"), "{error}");
}
