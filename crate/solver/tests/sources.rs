//! Several sources: distances are those of matrices factored anew with the sources held, whatever way they are found.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::ops::ControlFlow;

use crate::common::truth::Random;
use crate::common::{heat_only, nearest, solver_with, square, surface};
use faer::prelude::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};
use glam::DVec3;
use heatwalk::operator::Operators;
use heatwalk::operator::laplacian::Laplacian;
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    Boundary, Element, Error, ExactRadius, FaceId, LinearSolver, MultiSource, Operator, Parameters, Place, Soup,
    Source, Surface, VertexId,
};
use heatwalk_shapes as shapes;

/// The heat method alone on the triangles as they are.
fn plain() -> Parameters {
    Parameters { operator: Operator::Plain, ..heat_only(1.0, Boundary::Neumann) }
}

fn vertices(points: &[u32]) -> Vec<Place> {
    points.iter().map(|&point| Place::Vertex(VertexId(point))).collect()
}

/// `(L + scale M) x = right` with some points held at values, factored for the purpose.
fn held_solve(laplacian: &Laplacian, scale: f64, held: &[(u32, f64)], right: &[f64]) -> Vec<f64> {
    let size = laplacian.size();
    let mut values: Vec<Option<f64>> = vec![None; size];
    for &(point, value) in held {
        values[point as usize] = Some(value);
    }
    let mut x = Mat::from_fn(size, 1, |row, _| values[row].unwrap_or(right[row]));
    let mut triplets = Vec::new();
    for column in 0..size {
        for entry in laplacian.column(column) {
            let row = laplacian.rows()[entry] as usize;
            let mut weight = laplacian.stiffness[entry];
            if row == column {
                weight += scale * laplacian.mass[row];
            }
            match (values[row], values[column]) {
                (None, None) => triplets.push(Triplet::new(row, column, weight)),
                (None, Some(value)) => x[(row, 0)] -= weight * value,
                (Some(value), None) => x[(column, 0)] -= weight * value,
                (Some(_), Some(_)) if row == column => triplets.push(Triplet::new(row, row, 1.0)),
                (Some(_), Some(_)) => {}
            }
        }
    }
    let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(size, size, &triplets).expect("a lower triangle");
    let factor = matrix.sp_cholesky(Side::Lower).expect("positive definite");
    factor.solve_in_place(x.as_mut());
    x.col(0).iter().copied().collect()
}

/// The heat method with heat 1 and distance 0 held at the sources, written out in three dimensions.
fn refactored(surface: &Surface, time: f64, sources: &[u32]) -> Vec<f64> {
    let laplacian = Operators::new(surface, Operator::Plain).laplacian().clone();
    let zeros = vec![0.0; laplacian.size()];
    let hot: Vec<(u32, f64)> = sources.iter().map(|&source| (source, 1e290)).collect();
    let heat = held_solve(&laplacian, 1.0 / time, &hot, &zeros);
    let mut divergence = zeros;
    for face in surface.mesh().faces() {
        let corners = surface.faces()[face].map(Element::index);
        let [p, q, r] = surface.corners(face);
        let edges = [r - q, p - r, q - p];
        let normal = (q - p).cross(r - p);
        let largest = corners.map(|corner| heat[corner]).into_iter().fold(0.0, f64::max);
        let gradient: DVec3 = (0..3).map(|k| normal.cross(edges[k]) * (heat[corners[k]] / largest)).sum();
        let field = -gradient.normalize();
        for k in 0..3 {
            divergence[corners[k]] += 0.5 * field.dot(normal.normalize().cross(edges[k]));
        }
    }
    let cold: Vec<(u32, f64)> = sources.iter().map(|&source| (source, 0.0)).collect();
    held_solve(&laplacian, 0.0, &cold, &divergence)
}

fn check_against_refactored(soup: &Soup, sources: &[u32]) {
    let solver = solver_with(soup, plain());
    let reference = refactored(solver.surface(), solver.time(), sources);
    let distance = solver.distance(&vertices(sources)).expect("sources");
    let diameter = distance.max();
    for &source in sources {
        assert_eq!(distance.values[VertexId(source)], 0.0);
    }
    for (point, (value, reference)) in distance.values.iter().zip(&reference).enumerate() {
        assert!(*value >= 0.0);
        // Condition of the Poisson matrix times rounding is some 1e-12. Where the reference is below 0, between
        // sources next to each other, distances are cut at 0.
        assert!((value - reference.max(0.0)).abs() <= 1e-9 * diameter, "{point}: {value} for {reference}");
    }
}

#[test]
fn few_sources_as_if_factored_anew() {
    for soup in [square(20), shapes::icosphere(4), shapes::torus(2.0, 0.7, 48, 24)] {
        let count = soup.positions.len();
        let mut random = Random::new(5);
        check_against_refactored(&soup, &[random.below(count) as u32]);
        let five: Vec<u32> = (0..5).map(|_| random.below(count) as u32).collect();
        check_against_refactored(&soup, &five);
    }
}

#[test]
fn a_line_of_sources_as_if_factored_anew() {
    let soup = square(60);
    let surface = surface(&soup);
    let line: Vec<u32> = (0..61).map(|i| nearest(&surface, DVec3::new(f64::from(i) / 60.0, 0.5, 0.0)).0).collect();
    check_against_refactored(&soup, &line);
}

#[test]
fn a_boundary_of_sources_as_if_factored_anew() {
    let soup = square(100);
    let surface = surface(&soup);
    let boundary: Vec<u32> =
        surface.vertices().filter(|&vertex| surface.boundary_vertices()[vertex]).map(|vertex| vertex.0).collect();
    assert_eq!(boundary.len(), 400);
    check_against_refactored(&soup, &boundary);
}

#[test]
fn asking_again_gives_the_same() {
    // Responses kept from before must not change the answer, whatever was asked in between.
    let soup = shapes::icosphere(4);
    let solver = solver_with(&soup, Parameters::default());
    let questions =
        [vec![3, 900, 1500], vec![3, 900], vec![3, 900, 1500, 77], vec![1500, 3, 900]].map(|q| vertices(&q));
    let first: Vec<_> = questions.iter().map(|q| solver.distance(q).expect("sources").values).collect();
    for (question, before) in questions.iter().zip(&first) {
        let anew = solver_with(&soup, Parameters::default()).distance(question).expect("sources").values;
        for (after, before) in anew.iter().zip(before) {
            assert!((after - before).abs() < 1e-12, "{after} {before}");
        }
    }
}

#[test]
fn what_was_asked_before_changes_no_bit_of_a_source_s_distance() {
    let soup = shapes::torus(1.0, 0.4, 60, 30);
    let asked = solver_with(&soup, Parameters::default());
    for question in [vec![900], vec![3], vec![3, 900, 1500], vec![900], vec![1500]].map(|q| vertices(&q)) {
        let after = asked.distance(&question).expect("sources");
        if question.len() == 1 {
            let first = solver_with(&soup, Parameters::default()).distance(&question).expect("a source");
            assert_eq!((after.values, after.exact_below), (first.values, first.exact_below));
        }
    }
}

#[test]
fn distances_start_at_sources_inside_faces_and_on_edges() {
    let soup = shapes::icosphere(4);
    let mut random = Random::new(9);
    for exact_radius in [ExactRadius::Automatic, ExactRadius::Edges(0.0)] {
        let solver = solver_with(&soup, Parameters { exact_radius, ..Parameters::default() });
        let surface = solver.surface();
        let sources: Vec<Place> = (0..6)
            .map(|index| {
                let face = FaceId(random.below(surface.face_count()) as u32);
                let halfedge = heatwalk::HalfedgeId(face.0 * 3);
                match index % 2 {
                    0 => Place::Face { face, weights: [0.2, 0.3, 0.5] },
                    _ => Place::Edge { halfedge, fraction: 0.4 },
                }
            })
            .collect();
        let distance = solver.distance(&sources).expect("sources");
        for (point, value) in surface.positions().iter().zip(&distance.values) {
            let arc = |source: &Place| point.dot(source.position(surface).normalize()).clamp(-1.0, 1.0).acos();
            let exact = sources.iter().map(arc).fold(f64::INFINITY, f64::min);
            // The method's own offset in the first rings is half an edge; where two fronts meet it is rounded off.
            assert!((value - exact).abs() < 1.2 * surface.mean_edge(), "{value} for {exact}");
        }
        for source in &sources {
            let corners: Vec<VertexId> = source.support(surface).map(|(corner, _)| corner).collect();
            let straight = corners.iter().map(|&corner| surface.position(corner).distance(source.position(surface)));
            for (&corner, straight) in corners.iter().zip(straight) {
                // Rounding: the corners see the source straight on, across one triangle.
                assert!(
                    (distance.values[corner] - straight).abs() < 1e-12,
                    "{} for {straight}",
                    distance.values[corner]
                );
            }
        }
    }
}

#[test]
fn dependent_sources_are_no_obstacle() {
    // The three corners of a face, a point inside it and one of the corners again.
    let solver = solver_with(&shapes::icosphere(3), heat_only(1.0, Boundary::Neumann));
    let surface = solver.surface();
    let mut sources = surface.faces()[FaceId(10)].map(Place::Vertex).to_vec();
    sources.push(Place::Face { face: FaceId(10), weights: [0.2, 0.3, 0.5] });
    sources.push(sources[0]);
    let distance = solver.distance(&sources).expect("sources");
    assert!(distance.values.iter().all(|value| value.is_finite()));
    for point in surface.faces()[FaceId(10)] {
        assert_eq!(distance.values[point], 0.0);
    }
}

#[test]
fn starting_values() {
    let soup = square(40);
    let solver = solver_with(&soup, Parameters::default());
    let surface = solver.surface();
    let at = |x: f64, y: f64| Place::Vertex(nearest(surface, DVec3::new(x, y, 0.0)));
    let sources = [(at(0.2, 0.5), 0.0), (at(0.8, 0.5), 0.25), (at(0.5, 0.9), 3.0)]
        .map(|(place, initial_distance)| surface.source(place, initial_distance).expect("a valid source"));
    let distance = solver.distance(&sources).expect("sources");
    for (point, value) in surface.positions().iter().zip(&distance.values) {
        let from = |source: &Source| source.initial_distance() + point.distance(source.place().position(surface));
        let exact = sources.iter().map(from).fold(f64::INFINITY, f64::min);
        assert!((value - exact).abs() < 1.5 * surface.mean_edge(), "{value} for {exact} at {point}");
    }
    let value = |source: &Source| source.place().interpolate(surface, &distance.values);
    assert_eq!([value(&sources[0]), value(&sources[1])], [0.0, 0.25]);
    assert_eq!(distance.sources.len(), 2, "the third starts later than the others arrive there");
    for initial_distance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(surface.source(sources[0].place(), initial_distance), Err(SurfaceError::BadParameter { .. })));
        let bad = (sources[0].place(), initial_distance);
        assert!(matches!(solver.distance(&[bad]), Err(Error::Surface(SurfaceError::BadParameter { .. }))));
    }
}

#[test]
fn the_exact_radius_goes_from_heat_alone_to_exact_everywhere() {
    let soup = square(20);
    let answer = |edges| {
        let parameters = Parameters { exact_radius: ExactRadius::Edges(edges), ..heat_only(1.0, Boundary::Neumann) };
        solver_with(&soup, parameters).distance(&vertices(&[0])).expect("a source")
    };
    let surface = surface(&soup);
    for (edges, is_all) in [(0.0, false), (3.0, false), (1e9, true), (f64::INFINITY, true)] {
        let distance = answer(edges);
        assert_eq!(distance.exact_below.is_infinite(), is_all);
        assert!(is_all || (distance.exact_below - edges * surface.mean_edge()).abs() < 1e-12);
        let exact: Vec<f64> = surface.positions().iter().map(|p| p.distance(surface.position(VertexId(0)))).collect();
        // Rounding of some unfolded faces.
        let is_exact = |(value, exact): (&f64, &f64)| (value - exact).abs() < 1e-12;
        let inside = distance.values.iter().zip(&exact).filter(|&(_, exact)| *exact < distance.exact_below);
        assert!(inside.into_iter().all(is_exact), "{edges}");
        assert_eq!(distance.values.iter().zip(&exact).all(is_exact), is_all, "{edges}");
    }
}

#[test]
fn the_exact_region_is_exact_and_takes_few_windows_on_small_meshes() {
    for soup in [shapes::torus(1.0, 0.4, 40, 20), shapes::uv_sphere(40, 60), square(30)] {
        let solver = solver_with(&soup, Parameters::default());
        let count = solver.surface().vertex_count();
        let source = vertices(&[count as u32 / 3]);
        let distance = solver.distance(&source).expect("a source");
        let mut front = solver.wavefront(&source).expect("a source");
        front.advance(distance.exact_below, usize::MAX).expect("room for windows");
        let inside: Vec<VertexId> =
            solver.surface().vertices().filter(|&vertex| front.values()[vertex] < distance.exact_below).collect();
        assert!(inside.len() > 30, "{} of {count}", inside.len());
        assert!(inside.iter().all(|&vertex| distance.values[vertex] == front.values()[vertex]));
        // Those that wait at one edge cross together.
        assert!(front.windows() < count, "{} windows for {count} vertices", front.windows());
    }
}

#[test]
fn superposed_sources_are_not_at_zero() {
    let soup = square(40);
    let parameters = Parameters { sources: MultiSource::Summed, ..heat_only(1.0, Boundary::Neumann) };
    let solver = solver_with(&soup, parameters);
    let surface = solver.surface();
    let at = |x: f64, y: f64| Place::Vertex(nearest(surface, DVec3::new(x, y, 0.0)));
    let sources = [at(0.2, 0.2), at(0.3, 0.2), at(0.8, 0.7)];
    let distance = solver.distance(&sources).expect("sources");
    let values: Vec<f64> = sources.iter().map(|source| source.interpolate(surface, &distance.values)).collect();
    assert!(values.iter().any(|value| *value > 1e-3), "{values:?}");
    assert!(distance.values.iter().all(|value| *value >= 0.0));
}

#[test]
fn conjugate_gradients_agree_near_the_sources() {
    let soup = shapes::icosphere(3);
    for sources in [vec![0], vec![0, 100, 401]] {
        let answer = |solver| {
            let parameters = Parameters { solver, ..heat_only(1.0, Boundary::Neumann) };
            solver_with(&soup, parameters).distance(&vertices(&sources)).expect("sources").values
        };
        let [direct, iterated] = [LinearSolver::Cholesky, LinearSolver::ConjugateGradients].map(answer);
        for (direct, iterated) in direct.iter().zip(&iterated) {
            // The sphere is 20 edges around, so heat falls to e⁻¹⁰ of its maximum and keeps 1e-12 / e⁻¹⁰ of its digits.
            assert!((direct - iterated).abs() < 1e-6, "{direct} {iterated}");
        }
    }
}

#[test]
fn boundary_conditions_change_at_no_cost_the_second_time() {
    let soup = square(30);
    let mut solver = solver_with(&soup, heat_only(1.0, Boundary::Neumann));
    let mut factored = |boundary| {
        let mut any = false;
        let mut tell = |_, _| {
            any = true;
            ControlFlow::Continue(())
        };
        solver.set_parameters(heat_only(1.0, boundary), &mut tell).expect("factors");
        any
    };
    assert_eq!(
        [Boundary::Dirichlet, Boundary::Average, Boundary::Neumann, Boundary::Dirichlet].map(&mut factored),
        [true, false, false, false]
    );
}
