//! Lines that show how a surface is meshed.

use crate::common;

use crate::common::surface;
use glam::DVec3;
use heatwalk::{BridgeRule, Bridges, HeatSolver, Operator, Parameters, VertexId, go_on};
use heatwalk_scene::overlay::{self, Segment};
use heatwalk_shapes as shapes;

fn total(segments: &[Segment]) -> f64 {
    segments.iter().map(|[a, b]| a.distance(*b)).sum()
}

#[test]
fn a_closed_surface_has_half_as_many_edges_again_as_faces_and_no_boundary() {
    let torus = surface(&shapes::torus(1.0, 0.4, 24, 12));
    assert_eq!(2 * overlay::inner_edges(&torus).len(), 3 * torus.face_count());
    assert!(overlay::boundary_edges(&torus).is_empty());
}

#[test]
fn edges_that_cut_polygons_are_not_drawn() {
    let mut soup = shapes::grid(3, 2);
    soup.polygons = (0..6).map(|square| 2 * square..2 * square + 2).collect();
    let squares = surface(&soup);
    assert_eq!((squares.report().polygons, squares.report().faces), (6, 12));
    // Each is 1 / 3 by 1 / 2; two lines across, one along.
    assert!((total(&overlay::inner_edges(&squares)) - 3.0).abs() < 1e-12);
    assert!((total(&overlay::boundary_edges(&squares)) - 4.0).abs() < 1e-12);
    // A triangle beside a square shares an edge that is drawn.
    soup.polygons.pop();
    assert_eq!(overlay::inner_edges(&surface(&soup)).len(), overlay::inner_edges(&squares).len() + 1);
}

#[test]
fn the_boundary_of_a_strip_is_its_outline() {
    let strip = surface(&shapes::strip(1.0, 4.0, 2));
    // Sums of a few dozen lengths.
    assert!((total(&overlay::boundary_edges(&strip)) - 10.0).abs() < 1e-12);
}

#[test]
fn edges_of_the_plain_operator_are_those_of_the_mesh() {
    let sphere = surface(&shapes::uv_sphere(24, 12));
    let edges = overlay::inner_edges(&sphere).len();
    let plain = Parameters { operator: Operator::Plain, ..Parameters::default() };
    let solver = HeatSolver::new(sphere, plain, &mut go_on).expect("a sphere");
    assert_eq!(overlay::operator_edges(&solver, solver.surface()).expect("edges").len(), edges);
}

#[test]
fn a_flipped_edge_is_drawn_across_faces_with_its_own_length() {
    // Two obtuse triangles folded along their longest edge, closed by four long ones: the Delaunay edge
    // crosses the fold.
    let corners = [[-0.2, 0.0, 0.4], [4.0, 0.5, 0.0], [-4.0, 0.5, 0.0], [0.2, 0.0, -0.4], [0.0, -8.0, 0.0]];
    let triangles = vec![[0, 1, 2], [3, 2, 1], [1, 0, 4], [0, 2, 4], [2, 3, 4], [3, 1, 4]];
    let tent = surface(&common::soup(corners.map(DVec3::from_array).to_vec(), triangles));
    let expected = {
        let [a, b, c, d] = [0, 1, 2, 3].map(|vertex| tent.position(VertexId(vertex)));
        // Unfolded about the edge between b and c.
        let along = (c - b).normalize();
        let place = |p: DVec3| ((p - b).dot(along), (p - b).cross(along).length());
        let ((ax, ay), (dx, dy)) = (place(a), place(d));
        (ax - dx).hypot(ay + dy)
    };
    let solver = HeatSolver::new(tent, Parameters::default(), &mut go_on).expect("a tent");
    let is_on_fold = |point: &DVec3| point.y == 0.5 && point.x.abs() < 1.0;
    let crossing: Vec<Segment> = overlay::operator_edges(&solver, solver.surface())
        .expect("edges")
        .into_iter()
        .filter(|ends| ends.iter().any(is_on_fold))
        .collect();
    assert_eq!(crossing.len(), 2);
    assert!((total(&crossing) - expected).abs() < 1e-12 * expected, "{crossing:?}");
}

#[test]
fn portals_are_crosses_on_the_surface_and_hops() {
    let mut balls = shapes::icosphere(2);
    let (first, gap) = (balls.positions.len() as u32, 0.004);
    balls.positions.extend(shapes::icosphere(2).positions.iter().map(|&position| position + (2.0 + gap) * DVec3::Y));
    balls.triangles.extend(shapes::icosphere(2).triangles.iter().map(|triangle| triangle.map(|vertex| first + vertex)));
    let balls = surface(&balls);
    let bridges = Bridges::find(&balls, BridgeRule::Automatic);
    let portals = bridges.portals().len();
    assert!(portals > 0);
    let lines = overlay::contact_lines(&balls, &bridges);
    // A hop and two crosses each.
    assert_eq!(lines.len(), 5 * portals);
    for (lines, portal) in lines.chunks(5).zip(bridges.portals()) {
        let [from, to] = portal.ends.map(|end| end.position(&balls));
        assert_eq!(lines[0], [from, to]);
        for (line, middle) in lines[1..].iter().zip([from, from, to, to]) {
            assert!((0.5 * (line[0] + line[1])).distance(middle) < 1e-12);
        }
    }
    assert!(overlay::contact_lines(&balls, &Bridges::default()).is_empty());
}
