//! Operators, frames, heat flow and Poisson put together anew: signed distance, transport of vectors, weighted and anisotropic
//! metrics, beside what the crate itself offers.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use crate::common::{nearest, soup, square, surface};
use glam::{DQuat, DVec2, DVec3};
use heatwalk::heat::{Condition, Constraint, HeatFlow, Poisson, Systems};
use heatwalk::operator::intrinsic::IntrinsicTriangulation;
use heatwalk::operator::{ConnectionLaplacian, Frames, Operators, TangentPlane};
use heatwalk::sparse::{Scalar, System, c64};
use heatwalk::{
    Element, Error, FaceId, HalfedgeId, LinearSolver, Operator, Soup, Surface, VertexData, VertexId, go_on,
};
use heatwalk_shapes::icosphere;

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

/// Tangent vectors of a surface on its intrinsic Delaunay triangles, with one step of their diffusion.
struct Vectors {
    surface: Surface,
    frames: Frames,
    planes: Vec<TangentPlane>,
    systems: Arc<Systems>,
    diffusion: System<c64>,
}

impl Vectors {
    fn new(soup: &Soup) -> Self {
        let surface = surface(soup);
        let mut frames = Frames::new(IntrinsicTriangulation::of_surface(&surface)).expect("a fan at each vertex");
        frames.flip_to_delaunay();
        let (systems, diffusion) = diffusion(&frames);
        let planes = frames.in_space(&surface);
        Self { surface, frames, planes, systems, diffusion }
    }

    /// A vector at a vertex, carried to all (`#V × 3`, unit length): Sharp, Soliman, Crane, "The vector heat method" (2019).
    fn transported(&self, source: VertexId, vector: DVec3) -> Vec<DVec3> {
        let mut supply = vec![c64::new(0.0, 0.0); self.planes.len()];
        supply[source.index()] = self.planes[source.index()].number(vector);
        let carried = self.diffusion.solve(&supply).expect("vectors");
        let in_space = |(plane, &number): (&TangentPlane, &c64)| plane.vector(number / number.magnitude());
        self.planes.iter().zip(&carried).map(in_space).collect()
    }

    /// Distance (`#V`) to a curve of such places, positive where their normals point: Feng and Crane, "A heat method for
    /// generalized signed distance" (2024).
    fn signed_distance(&self, curve: &[(DVec3, DVec3)]) -> Vec<f64> {
        let mut supply = vec![c64::new(0.0, 0.0); self.planes.len()];
        let on_curve: Vec<VertexId> = curve.iter().map(|&(place, _)| nearest(&self.surface, place)).collect();
        for (vertex, &(_, normal)) in on_curve.iter().zip(curve) {
            supply[vertex.index()] += self.planes[vertex.index()].number(normal);
        }
        let diffused = self.diffusion.solve(&supply).expect("normals");
        let unit = |vector: [f64; 2]| DVec2::from(vector).try_normalize().expect("normals everywhere").to_array();
        let field: Vec<[f64; 2]> = self.frames.in_faces(&diffused).into_iter().map(unit).collect();
        let poisson = Poisson::new(&self.systems, &mut go_on).expect("factors");
        let share = 1.0 / curve.len() as f64;
        let mean = Constraint::new(on_curve.into_iter().map(|vertex| (vertex, share)), 0.0);
        poisson.solve(&self.systems.operators().divergence(&field), &[mean]).expect("signed distance")
    }
}

/// The order and analysis of the real systems serve that of vectors too.
fn diffusion(frames: &Frames) -> (Arc<Systems>, System<c64>) {
    let systems = systems(Operators::of_triangulation(frames.triangulation()));
    let operators = systems.operators();
    let matrix = ConnectionLaplacian::new(frames, operators).heat_matrix(operators.mean_edge().powi(2));
    assert_eq!(matrix.pattern(), operators.laplacian().stiffness.pattern());
    let diffusion = systems.system_of(matrix, &mut go_on).expect("positive definite");
    (systems, diffusion)
}

/// No direction that the triangles of an icosphere prefer.
const AXIS: DVec3 = DVec3::new(0.36, 0.48, 0.8);

/// On the unit sphere, the points at an angle from [`AXIS`], with the normals away from it.
fn circle_of_latitude(angle: f64) -> Vec<(DVec3, DVec3)> {
    let x = AXIS.any_orthonormal_vector();
    let (sin, cos) = angle.sin_cos();
    let steps = 1440;
    let at = |step: u32| {
        let out = DQuat::from_axis_angle(AXIS, TAU * f64::from(step) / f64::from(steps)) * x;
        (cos * AXIS + sin * out, cos * out - sin * AXIS)
    };
    (0..steps).map(at).collect()
}

/// On a part of the unit sphere, where distance to that circle is along meridians.
fn assert_signed_distance_to_a_circle(soup: &Soup, angle: f64) {
    let vectors = Vectors::new(soup);
    let values = vectors.signed_distance(&circle_of_latitude(angle));
    let exact = |position: DVec3| position.angle_between(AXIS) - angle;
    // A third of a side of the triangles, of 0.035, by the largest distance of 2.
    assert_near(&vectors.surface, &values, exact, 0.005);
    for (value, &position) in values.iter().zip(vectors.surface.positions()) {
        assert!(value * exact(position) > 0.0 || exact(position).abs() < 0.012, "the sign at {position}");
    }
}

#[test]
fn diffused_normals_of_a_circle_of_latitude_give_signed_distance_on_a_sphere() {
    assert_signed_distance_to_a_circle(&icosphere(5), 1.0);
}

#[test]
fn diffused_normals_of_a_circle_of_latitude_give_signed_distance_on_a_part_of_a_sphere() {
    let mut cap = icosphere(5);
    let is_inside = |vertex: u32| cap.positions[vertex as usize].dot(AXIS) > -0.2;
    let kept: Vec<[u32; 3]> =
        cap.triangles.iter().copied().filter(|corners| corners.iter().all(|&v| is_inside(v))).collect();
    cap = soup(cap.positions, kept);
    assert_signed_distance_to_a_circle(&cap, 0.9);
}

#[test]
fn diffused_vectors_are_parallel_along_great_circles() {
    let vectors = Vectors::new(&icosphere(5));
    let surface = &vectors.surface;
    let source = nearest(surface, AXIS);
    let start = surface.position(source);
    let vector = start.any_orthonormal_vector();
    let carried = vectors.transported(source, vector);
    let mut sum = 0.0;
    for (vertex, carried) in surface.vertices().zip(&carried) {
        let end = surface.position(vertex);
        let error = carried.angle_between(DQuat::from_rotation_arc(start, end) * vector);
        // A vector turns by the area between its way and a great circle, and heat of so short a time prefers ways along edges.
        // Near the antipode great circles from all sides meet.
        assert!(error < 0.03 || start.angle_between(end) > PI - 0.3, "{error} at {end}");
        sum += error;
    }
    let mean = sum / carried.len() as f64;
    assert!(mean < 0.004, "{mean}");
}

#[test]
fn vectors_carried_around_a_cone_to_both_sides_differ_by_its_angle() {
    // Nearly square quads on a cone without its tip, which is flat. Places on it, and directions out and around.
    let (segments, rows, slope) = (90, 40, 0.5_f64);
    let angle = |position: DVec3| position.y.atan2(position.x);
    let out = |angle: f64| DVec3::new(slope.sin() * angle.cos(), slope.sin() * angle.sin(), -slope.cos());
    let around = |angle: f64| DVec3::new(-angle.sin(), angle.cos(), 0.0);
    let places = (0..segments * (rows + 1)).map(|index: u32| {
        let along = 0.5 + f64::from(index % (rows + 1)) / f64::from(rows);
        along * out(TAU * f64::from(index / (rows + 1)) / f64::from(segments))
    });
    let vertex = |segment: u32, row: u32| segment % segments * (rows + 1) + row;
    let quads = (0..segments).flat_map(|segment| (0..rows).map(move |row| (segment, row)));
    let triangles = quads.flat_map(|(i, j)| {
        let [a, b, c, d] = [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)];
        [[a, b, c], [a, c, d]]
    });
    let cone = soup(places.collect(), triangles.collect());
    let vectors = Vectors::new(&cone);
    let surface = &vectors.surface;
    let source = nearest(surface, out(0.0));
    let carried = vectors.transported(source, out(0.0));
    // Of one segment, laid out in the plane.
    let segment = 2.0 * ((PI / f64::from(segments)).sin() * slope.sin()).asin();
    for (&position, carried) in surface.positions().iter().zip(carried) {
        let angle = angle(position);
        let laid_out = angle / TAU * f64::from(segments) * segment;
        let wanted = laid_out.cos() * out(angle) - laid_out.sin() * around(angle);
        // Behind the cone vectors from both sides meet.
        let is_behind = angle.abs() > PI - 0.4;
        assert!(is_behind || carried.angle_between(wanted) < 0.02, "{carried} instead of {wanted}");
    }
}

/// The same triangles, the last first.
fn relisted(triangulation: &IntrinsicTriangulation) -> IntrinsicTriangulation {
    let faces = triangulation.face_count() as u32;
    let sides = |face: u32| [0, 1, 2].map(|k| HalfedgeId(3 * face + k));
    let moved = |side: HalfedgeId| HalfedgeId(3 * (faces - 1 - side.0 / 3) + side.0 % 3);
    let listed = || (0..faces).rev().map(sides);
    let corners: Vec<_> = listed().map(|sides| sides.map(|side| triangulation.ends(side)[0])).collect();
    let lengths: Vec<_> = listed().map(|sides| sides.map(|side| triangulation.length(side))).collect();
    let twins: Vec<_> = listed().map(|sides| sides.map(|side| triangulation.twin(side).map(moved))).collect();
    IntrinsicTriangulation::new(&corners, &lengths, &twins).expect("the same triangles")
}

#[test]
fn another_reference_at_each_vertex_gives_the_same_vectors() {
    let triangulation = IntrinsicTriangulation::of_surface(&surface(&icosphere(3)));
    let last = 3 * triangulation.face_count() as u32 - 3;
    let answer = |triangulation: &IntrinsicTriangulation, side: HalfedgeId| {
        let frames = Frames::new(triangulation.clone()).expect("a fan at each vertex");
        let (_, diffusion) = diffusion(&frames);
        let mut supply = vec![c64::new(0.0, 0.0); frames.vertex_count()];
        supply[frames.triangulation().ends(side)[0].index()] = frames.direction(side);
        let carried = diffusion.solve(&supply).expect("vectors");
        (frames.in_faces(&carried), carried)
    };
    let (field, carried) = answer(&triangulation, HalfedgeId(0));
    let (other_field, other_carried) = answer(&relisted(&triangulation), HalfedgeId(last));
    let turned = carried.iter().zip(&other_carried).filter(|&(a, b)| (a - b).magnitude() > 0.1 * a.magnitude());
    assert!(turned.count() > carried.len() / 2, "else the references are the same");
    for (vector, other) in field.iter().zip(other_field.iter().rev()).map(|(&a, &b)| (DVec2::from(a), DVec2::from(b))) {
        // Rounding, in units that hold for small vectors too.
        assert!((vector - other).length() < 1e-9 * vector.length(), "{vector} and {other}");
    }
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
