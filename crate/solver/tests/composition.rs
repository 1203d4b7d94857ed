//! Operators, heat flow and Poisson put together anew: signed distance, weighted and anisotropic metrics, which the crate
//! itself does not offer.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::common::{nearest, square, surface};
use glam::{DVec2, DVec3};
use heatwalk::heat::{Condition, Constraint, HeatFlow, Poisson, Systems};
use heatwalk::operator::Operators;
use heatwalk::{Element, Error, FaceId, LinearSolver, Operator, Surface, VertexData, VertexId, go_on};

fn systems(operators: Operators) -> Arc<Systems> {
    Systems::new(operators, LinearSolver::Cholesky, &mut go_on).expect("an order")
}

/// The heat method on any metric, put together by hand.
fn distance_in(operators: Operators, source: VertexId) -> Vec<f64> {
    let systems = systems(operators);
    let operators = systems.operators();
    let time = operators.mean_edge().powi(2);
    let flow = HeatFlow::new(&systems, time, Condition::Neumann, &mut go_on).expect("factors");
    let (heat, supplies) = flow
        .solve_constrained(&vec![0.0; operators.vertex_count()], &[Constraint::at_vertex(source, 1.0)])
        .expect("heat");
    assert!(supplies[0] > 0.0, "the source gives heat");
    let field: Vec<[f64; 2]> = operators
        .gradient(&heat)
        .into_iter()
        .map(|gradient| (-DVec2::from(gradient)).normalize_or_zero().to_array())
        .collect();
    let poisson = Poisson::new(&systems, &mut go_on).expect("factors");
    poisson.solve(&operators.divergence(&field), &[Constraint::at_vertex(source, 0.0)]).expect("distance")
}

/// The operators of a plane surface whose metric gives segments these lengths.
fn metric(surface: &Surface, length: impl Fn(DVec3, DVec3) -> f64) -> Operators {
    let lengths: Vec<[f64; 3]> = (0..surface.face_count() as u32)
        .map(|face| {
            let [a, b, c] = surface.corners(FaceId(face));
            [length(a, b), length(b, c), length(c, a)]
        })
        .collect();
    Operators::from_lengths(surface.faces().as_slice(), &lengths).expect("a metric")
}

fn assert_near(surface: &Surface, values: &[f64], exact: impl Fn(DVec3) -> f64, tolerance: f64) {
    let largest = surface.positions().iter().map(|&position| exact(position).abs()).fold(0.0, f64::max);
    for (&value, &position) in values.iter().zip(surface.positions()) {
        let error = (value - exact(position)).abs() / largest;
        assert!(error < tolerance, "{value} instead of {} at {position}", exact(position));
    }
}

/// In a square where this is the length of straight lines, from the vertex nearest to a place.
fn assert_distance_follows(length: impl Fn(DVec3, DVec3) -> f64, place: DVec3) {
    let surface = surface(&square(48));
    let source = nearest(&surface, place);
    let from = surface.position(source);
    let values = distance_in(metric(&surface, &length), source);
    assert_near(&surface, &values, |position| length(from, position), 0.04);
}

#[test]
fn a_conformal_metric_gives_hyperbolic_distance() {
    // The half-plane y > 0 with lengths divided by y. The square lies above y = 1.
    let up = |p: DVec3| DVec2::new(p.x, p.y + 1.0);
    let hyperbolic = |p: DVec3, q: DVec3| {
        let (p, q) = (up(p), up(q));
        (1.0 + p.distance_squared(q) / (2.0 * p.y * q.y)).acosh()
    };
    assert_distance_follows(hyperbolic, DVec3::new(0.5, 0.3, 0.0));
}

#[test]
fn an_anisotropic_metric_gives_stretched_distance() {
    let stretched = |p: DVec3, q: DVec3| DVec2::new(2.0 * (q.x - p.x), q.y - p.y).length();
    assert_distance_follows(stretched, DVec3::new(0.4, 0.5, 0.0));
}

#[test]
fn diffused_normals_of_a_curve_give_signed_distance() {
    // Feng and Crane, "A heat method for generalized signed distance" (2024), on a plane, where transport keeps components.
    let surface = surface(&square(64));
    let systems = systems(Operators::new(&surface, Operator::Plain));
    let operators = systems.operators();
    let (center, radius) = (DVec3::new(0.5, 0.5, 0.0), 0.3);
    let mut normals = [vec![0.0; surface.vertex_count()], vec![0.0; surface.vertex_count()]];
    let steps = 720;
    for step in 0..steps {
        let angle = TAU * f64::from(step) / f64::from(steps);
        let normal = DVec3::new(angle.cos(), angle.sin(), 0.0);
        let vertex = nearest(&surface, center + radius * normal).0 as usize;
        normals[0][vertex] += normal.x;
        normals[1][vertex] += normal.y;
    }
    let flow = HeatFlow::new(&systems, operators.mean_edge().powi(2), Condition::Neumann, &mut go_on).expect("factors");
    let [x, y] = normals.map(|supply| flow.solve(&supply).expect("a component"));
    let field: Vec<[f64; 2]> = (0..operators.triangle_count())
        .map(|triangle| {
            let corners = operators.corners(triangle);
            let [a, b, _] = surface.corners(FaceId(triangle as u32));
            let sum = |component: &[f64]| corners.iter().map(|vertex| component[vertex.0 as usize]).sum::<f64>();
            let normal = DVec2::new(sum(&x), sum(&y)).normalize_or_zero();
            // Into the triangle's own coordinates.
            let along = (b - a).truncate().normalize();
            [along.dot(normal), along.perp_dot(normal)]
        })
        .collect();
    let on_curve = nearest(&surface, center + DVec3::new(radius, 0.0, 0.0));
    let signed = |position: DVec3| position.distance(center) - radius;
    let constraint = Constraint::at_vertex(on_curve, signed(surface.position(on_curve)));
    let poisson = Poisson::new(&systems, &mut go_on).expect("factors");
    let values = poisson.solve(&operators.divergence(&field), &[constraint]).expect("signed distance");
    assert_near(&surface, &values, signed, 0.05);
}

#[test]
fn divergence_of_a_gradient_is_the_stiffness_and_poisson_inverts_it() {
    let surface = surface(&square(12));
    for operator in [Operator::Delaunay, Operator::Plain] {
        let systems = systems(Operators::new(&surface, operator));
        let operators = systems.operators();
        let wave = |position: &DVec3| (5.0 * position.x).sin() + position.y.powi(3);
        let values: Vec<f64> = surface.positions().iter().map(wave).collect();
        let divergence = operators.divergence(&operators.gradient(&values));
        let (low, high) = (VertexId(3), VertexId(100));
        let at = |vertex: VertexId| Constraint::at_vertex(vertex, values[vertex.0 as usize]);
        let solved = Poisson::new(&systems, &mut go_on)
            .expect("factors")
            .solve(&divergence, &[at(low), at(high)])
            .expect("solves");
        for (value, wanted) in solved.iter().zip(&values) {
            assert!((value - wanted).abs() < 1e-9, "{value} instead of {wanted} with {operator}");
        }
    }
}

#[test]
fn rejects_lengths_that_make_no_triangle() {
    let face = [VertexId(0), VertexId(1), VertexId(2)];
    for lengths in [[1.0, 1.0, 2.5], [1.0, 0.0, 1.0], [1.0, f64::NAN, 1.0], [f64::INFINITY; 3]] {
        let refused = Operators::from_lengths(&[face], &[lengths]);
        assert!(matches!(refused, Err(Error::BadParameter { .. })), "{lengths:?}");
    }
}

#[test]
fn constraints_on_cold_vertices_and_beside_them_are_met_together() {
    let surface = surface(&square(8));
    let systems = systems(Operators::new(&surface, Operator::default()));
    let time = systems.operators().mean_edge().powi(2);
    let is_cold: VertexData<bool> = surface.positions().iter().map(|position| position.x == 0.0).collect();
    let cold = nearest(&surface, DVec3::new(0.0, 0.5, 0.0));
    let beside = surface.neighbours(cold).find(|&vertex| !is_cold[vertex]).expect("an inner neighbour");
    let flow =
        HeatFlow::new(&systems, time, Condition::Dirichlet(Arc::new(is_cold.clone())), &mut go_on).expect("factors");
    let prescribed = Constraint::at_vertex(cold, 2.0);
    let mean = Constraint::new([(cold, 0.25), (beside, 0.75)], 0.5);
    let mut supply = vec![0.0; surface.vertex_count()];
    let (values, given) = flow.solve_constrained(&supply, &[prescribed.clone(), mean]).expect("heat");
    let values = VertexData::from(values);
    assert_eq!(values[cold], 2.0);
    assert!(values.enumerate().all(|(vertex, &value)| vertex == cold || !is_cold[vertex] || value == 0.0));
    // Rounding of a small system.
    assert!((0.25 * 2.0 + 0.75 * values[beside] - 0.5).abs() < 1e-12, "{}", values[beside]);
    // What the mean puts in, by its weight on a vertex that is not cold, gives the same heat as a supply.
    supply[beside.index()] = 0.75 * given[1];
    let (supplied, _) = flow.solve_constrained(&supply, &[prescribed]).expect("heat");
    assert!(supplied.iter().zip(values.iter()).all(|(a, b)| (a - b).abs() < 1e-12));
}
