//! What must hold of any surface: symmetry of the operators, motion, scale, numbering, positivity.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common;

use std::ops::ControlFlow;

use crate::common::truth::Random;
use crate::common::{band, distance_from, solver, solver_with, soup, square, surface};
use glam::{DQuat, DVec3};
use heatwalk::operator::Operators;
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    Boundary, Distance, Element, Error, FaceId, HeatSolver, Operator, Parameters, Place, Soup, Stage, VertexData,
    VertexId, go_on,
};
use heatwalk_model::Appearance;
use heatwalk_scene::{DrawTransform, draw_mesh};
use heatwalk_shapes as shapes;

/// Largest difference of two distances, as a share of the largest distance.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let largest = a.iter().copied().fold(0.0, f64::max);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
}

fn values(soup: &Soup) -> Vec<f64> {
    distance_from(soup, 0).1.values.into_vec()
}

/// A closed shape, one with boundary, one that cannot be oriented.
fn samples() -> [Soup; 3] {
    [shapes::icosphere(3), square(10), band(40, 1)]
}

#[test]
fn laplacian_rows_sum_to_zero() {
    for soup in samples() {
        let surface = surface(&soup);
        let laplacian = Operators::new(&surface, Operator::default()).laplacian().clone();
        let mut sums = vec![0.0; laplacian.size()];
        let mut energy = 0.0;
        let mut random = Random::new(1);
        let probe: Vec<f64> = (0..laplacian.size()).map(|_| random.share()).collect();
        for column in 0..laplacian.size() {
            for entry in laplacian.column(column) {
                let (row, weight) = (laplacian.rows()[entry] as usize, laplacian.stiffness[entry]);
                assert!(row >= column, "only the lower triangle is stored, so the matrix is symmetric");
                sums[row] += weight;
                energy += probe[row] * weight * probe[column];
                if row != column {
                    sums[column] += weight;
                    energy += probe[row] * weight * probe[column];
                }
            }
        }
        // Weights are of order 1, a dozen a row: rounding.
        assert!(sums.iter().all(|sum| sum.abs() < 1e-12));
        assert!(energy > 0.0, "positive semidefinite");
        // Rounding of sums over some thousand faces.
        let area: f64 = surface.mesh().faces().map(|face| surface.face_area(face)).sum();
        assert!((laplacian.mass.iter().sum::<f64>() / area - 1.0).abs() < 1e-12, "the masses share out the area");
    }
}

#[test]
fn operators_agree_where_all_triangles_are_delaunay_and_none_is_thin() {
    let moved = |mut soup: Soup, along: DVec3| {
        soup.positions[60] += along;
        soup
    };
    let cases = [
        (shapes::icosphere(3), true),
        (square(10), true),
        (moved(square(10), DVec3::new(0.07, -0.05, 0.0)), false),
        (moved(square(10), DVec3::new(0.0, 0.0, 5.0)), false),
        (band(40, 1), false),
    ];
    for (soup, agree) in cases {
        let surface = surface(&soup);
        let [delaunay, plain, relocated] = [Operator::Delaunay, Operator::Plain, Operator::Relocate]
            .map(|operator| Operators::new(&surface, operator).laplacian().clone());
        let is_same = [plain, relocated].iter().all(|other| {
            let weights = delaunay.stiffness.values().iter().zip(other.stiffness.values());
            other.rows() == delaunay.rows() && weights.into_iter().all(|(a, b)| (a - b).abs() < 1e-12)
        });
        assert_eq!((is_same, Operators::agree(&surface)), (agree, agree), "{}", surface.face_count());
    }
}

#[test]
fn motion_and_scale_do_not_matter() {
    for soup in samples() {
        let before = values(&soup);
        let turn = DQuat::from_euler(glam::EulerRot::XYZ, 0.4, -1.1, 2.0);
        for scale in [1e-8, 3.0, 1e8] {
            let mut moved = soup.clone();
            for position in &mut moved.positions {
                *position = scale * (turn * *position + DVec3::new(5.0, -3.0, 11.0));
            }
            let after: Vec<f64> = values(&moved).iter().map(|value| value / scale).collect();
            // Coordinates of size 15 against edges of 0.1 are rounded to 1e-14; solving loses four more digits.
            assert!(difference(&before, &after) < 1e-9, "{scale}: {}", difference(&before, &after));
        }
    }
}

#[test]
fn numbering_does_not_matter() {
    for original in samples() {
        let n = original.positions.len();
        let mut random = Random::new(7);
        let mut new_of_old: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            new_of_old.swap(i, random.below(i + 1));
        }
        let mut positions = vec![DVec3::ZERO; n];
        for old in 0..n {
            positions[new_of_old[old]] = original.positions[old];
        }
        let renumber = |triangle: &[u32; 3]| triangle.map(|vertex| new_of_old[vertex as usize] as u32);
        let mut triangles: Vec<[u32; 3]> = original.triangles.iter().map(renumber).collect();
        triangles.reverse();
        let (_, after) = distance_from(&soup(positions, triangles), new_of_old[0] as u32);
        let after: Vec<f64> = (0..n).map(|old| after.values[VertexId::from_index(new_of_old[old])]).collect();
        // Another elimination order, so other rounding: the condition number, some 1e4, times 1e-16.
        let difference = difference(&values(&original), &after);
        assert!(difference < 1e-10, "{difference}");
    }
}

#[test]
fn distances_are_never_negative() {
    let soup = square(16);
    let mut random = Random::new(3);
    for boundary in [Boundary::Neumann, Boundary::Dirichlet, Boundary::Average] {
        for time_factor in [0.01, 1.0, 100.0] {
            let solver = solver(&soup, time_factor, boundary);
            for count in 1..4 {
                let sources: Vec<Place> = (0..count)
                    .map(|_| Place::Vertex(VertexId::from_index(random.below(solver.surface().vertex_count()))))
                    .collect();
                let distance = solver.distance(&sources).expect("sources");
                assert!(distance.values.iter().all(|value| *value >= 0.0 && value.is_finite()), "{sources:?}");
                if let [Place::Vertex(VertexId(source))] = sources[..] {
                    assert_eq!(distance.values[VertexId(source)], 0.0);
                }
                let gradients = distance.gradients(solver.surface()).expect("its surface");
                assert!(gradients.iter().all(|gradient| gradient.is_finite()));
            }
        }
    }
}

#[test]
fn slivers_do_not_spoil_numbers() {
    // A cap and a needle, far thinner than rounding likes, inside a square.
    for thickness in [1e-6, 1e-12, 1e-200] {
        let mut soup = square(8);
        let [a, b, _] = soup.triangles[100];
        let [p, q] = [a, b].map(|vertex| soup.positions[vertex as usize]);
        let apex = soup.positions.len() as u32;
        soup.positions.push((p + q) / 2.0 + DVec3::Z * thickness);
        soup.positions.push(p + DVec3::Z * thickness);
        soup.triangles.extend([[a, b, apex], [a, b, apex + 1]]);
        let (_, distance) = distance_from(&soup, 0);
        assert!(distance.values.iter().all(|value| value.is_finite()));
        // The rest of the square keeps its distances to some per cent: two faces more are stuck on one edge.
        let plain = values(&square(8));
        assert!(difference(&plain, &distance.values.as_slice()[..plain.len()]) < 0.1, "{thickness}");
    }
}

#[test]
fn face_source_lies_between_vertices() {
    let solver = solver(&shapes::icosphere(4), 1.0, Boundary::Neumann);
    let surface = solver.surface().clone();
    let source = Place::Face { face: FaceId(100), weights: [0.3, 0.3, 0.4] };
    let distance = solver.distance(&[source]).expect("a source");
    let position = source.position(&surface).normalize();
    for (value, point) in distance.values.iter().zip(surface.positions()) {
        let exact = point.dot(position).clamp(-1.0, 1.0).acos();
        // The method's own offset in the first rings is half an edge.
        assert!((value - exact).abs() < surface.mean_edge(), "{value} for {exact}");
    }
    for bad in [[0.5, 0.5, 0.5], [-0.2, 0.6, 0.6], [f64::NAN, 0.5, 0.5]] {
        let source = Place::Face { face: FaceId(0), weights: bad };
        assert!(matches!(solver.distance(&[source]), Err(Error::Surface(SurfaceError::BadWeights { face: 0, .. }))));
    }
    assert!(matches!(
        solver.distance(&[Place::Vertex(VertexId(u32::MAX))]),
        Err(Error::Surface(SurfaceError::NoSuchVertex { .. }))
    ));
    assert_eq!(solver.distance::<Place>(&[]), Err(Error::NoSource));
}

#[test]
fn boundary_source_enters_under_dirichlet() {
    let soup = square(16);
    for boundary in [Boundary::Dirichlet, Boundary::Average] {
        let solver = solver(&soup, 1.0, boundary);
        for sources in [vec![8], vec![0, 8], vec![8, 400]] {
            let points: Vec<Place> = sources.iter().map(|&source| Place::Vertex(VertexId(source))).collect();
            let distance = solver.distance(&points).expect("sources");
            let positions = solver.surface().positions();
            for (value, position) in distance.values.iter().zip(positions) {
                let to = |&source: &u32| position.distance(positions[VertexId(source)]);
                let exact = sources.iter().map(to).fold(f64::INFINITY, f64::min);
                // Three edges: the offset of several sources, and heat that falls to 0 along the boundary, where
                // its gradient points across the path from the source.
                assert!((value - exact).abs() < 3.0 / 16.0, "{boundary:?} {sources:?}: {value} for {exact}");
            }
        }
    }
}

#[test]
fn boundary_source_solves_the_freed_matrix() {
    let solver = solver(&square(16), 1.0, Boundary::Dirichlet);
    let surface = solver.surface();
    let source = VertexId(8);
    let heat = solver.distance(&[Place::Vertex(source)]).expect("a source").heat().expect("heat").clone();
    let laplacian = Operators::new(surface, Operator::default()).laplacian().clone();
    let mut supply: Vec<f64> =
        heat.iter().zip(&laplacian.mass).map(|(heat, mass)| heat * mass / solver.time()).collect();
    for column in 0..laplacian.size() {
        for entry in laplacian.column(column) {
            let (row, weight) = (laplacian.rows()[entry] as usize, laplacian.stiffness[entry]);
            supply[row] += weight * heat[VertexId::from_index(column)];
            if row != column {
                supply[column] += weight * heat[VertexId::from_index(row)];
            }
        }
    }
    for (vertex, supply) in surface.vertices().zip(&supply) {
        if vertex == source {
            assert_eq!(heat[vertex], heat.iter().copied().fold(0.0, f64::max), "the source is as hot as can be");
        } else if surface.boundary_vertices()[vertex] {
            assert_eq!(heat[vertex], 0.0);
        } else {
            // Rounding of one solve, as a share of the heat at the source.
            assert!(supply.abs() < 1e-12 * heat[source], "{supply}");
        }
    }
}

/// What two surfaces built alike have in common of a distance: all but whose it is.
fn fields(distance: &Distance) -> [VertexData<f64>; 2] {
    [distance.values.clone(), distance.heat().expect("heat").clone()]
}

#[test]
fn without_a_boundary_all_conditions_are_the_same() {
    let source = [Place::Vertex(VertexId(0))];
    let answer = |boundary| {
        let solver = solver_with(&shapes::icosphere(3), Parameters { boundary, ..Parameters::default() });
        fields(&solver.distance(&source).expect("a source"))
    };
    assert_eq!(answer(Boundary::Neumann), answer(Boundary::Dirichlet));
    assert_eq!(answer(Boundary::Neumann), answer(Boundary::Average));
}

#[test]
fn all_boundary_falls_back_to_neumann() {
    let soup = shapes::strip(1.0, 20.0, 1);
    let source = [Place::Vertex(VertexId(0))];
    let answer = |boundary| fields(&solver(&soup, 1.0, boundary).distance(&source).expect("a source"));
    assert_eq!(answer(Boundary::Neumann), answer(Boundary::Dirichlet));
    assert_eq!(answer(Boundary::Neumann), answer(Boundary::Average));
}

#[test]
fn parameters_change_as_if_made_anew() {
    let soup = square(12);
    let source = [Place::Vertex(VertexId(40))];
    let mut solver = solver(&soup, 1.0, Boundary::Neumann);
    for (time_factor, boundary) in [(1.0, Boundary::Average), (30.0, Boundary::Average), (0.1, Boundary::Dirichlet)] {
        solver.set_parameters(common::heat_only(time_factor, boundary), &mut go_on).expect("factors");
        let anew = common::solver(&soup, time_factor, boundary);
        assert_eq!(solver.distance(&source).map(|d| fields(&d)), anew.distance(&source).map(|d| fields(&d)));
        assert_eq!(solver.factor_nonzeros(), anew.factor_nonzeros());
    }
    // What was factored before is still there: nobody is asked whether to go on.
    let back = common::heat_only(1.0, Boundary::Average);
    solver.set_parameters(back, &mut |_, _| ControlFlow::Break(())).expect("nothing to factor");
    let anew = common::solver(&soup, 1.0, Boundary::Average);
    assert_eq!(solver.distance(&source).map(|d| fields(&d)), anew.distance(&source).map(|d| fields(&d)));
    let before = solver.distance(&source);
    let other = common::heat_only(5.0, Boundary::Neumann);
    assert_eq!(solver.set_parameters(other, &mut |_, _| ControlFlow::Break(())), Err(Error::Cancelled));
    assert_eq!(solver.distance(&source), before, "a cancelled change leaves the solver as it was");
    for time_factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let bad = common::heat_only(time_factor, Boundary::Neumann);
        assert!(matches!(solver.set_parameters(bad, &mut go_on), Err(Error::BadParameter { .. })));
    }
}

#[test]
fn progress_names_stages_and_cancels() {
    let mut stages = Vec::new();
    let mut record = |stage: Stage, done: f64| {
        stages.push((stage, done));
        ControlFlow::Continue(())
    };
    let soup = square(6);
    HeatSolver::new(surface(&soup), Parameters::default(), &mut record).expect("factors");
    assert!(stages.is_sorted_by(|a, b| a.1 < b.1), "{stages:?}");
    let mut names: Vec<Stage> = stages.iter().map(|stage| stage.0).collect();
    names.dedup();
    assert_eq!(names, [Stage::Assembling, Stage::Ordering, Stage::Analysing, Stage::Factoring]);
    for (stop, _) in stages {
        let mut progress = |stage, _| if stage == stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
        let result = HeatSolver::new(surface(&soup), Parameters::default(), &mut progress);
        assert!(matches!(result, Err(Error::Cancelled)), "{stop}");
    }
}

#[test]
fn drawing_keeps_faces_and_splits_creases() {
    // A cube of 12 triangles: with a crease at 30° each corner is drawn once a side, without once.
    let cube = {
        let corner = |k: u32| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2));
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        surface(&soup((0..8).map(corner).collect(), triangles))
    };
    for (crease, expected) in [(0.5, 24), (3.2, 8)] {
        let drawing = draw_mesh(&cube, &Appearance::default(), crease, &DrawTransform::IDENTITY);
        assert_eq!(drawing.vertex_of_drawn.len(), expected);
        assert_eq!(drawing.positions.len(), 3 * expected);
        for face in cube.mesh().faces() {
            for k in 0..3 {
                let drawn = drawing.triangles[face.0 as usize * 3 + k] as usize;
                assert_eq!(drawing.vertex_of_drawn[drawn], cube.faces()[face][k]);
                assert_eq!(cube.vertex_of_input(drawing.input_of_drawn[drawn]), Some(cube.faces()[face][k]));
                let normal = DVec3::from_array([0, 1, 2].map(|i| f64::from(drawing.normals[3 * drawn + i])));
                let outward = (cube.position(cube.faces()[face][k]) - 0.5).normalize();
                // Angle weights make the smooth normal of a cube's corner its diagonal, to 32-bit rounding.
                let wanted = if expected == 8 { outward } else { cube.face_normal(face) };
                assert!(normal.distance(wanted) < 1e-6);
            }
        }
    }
}
