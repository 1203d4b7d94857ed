//! Surfaces whose boundaries run along each other a little apart.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::{PI, TAU};
use std::num::NonZeroUsize;
use std::sync::Arc;

use crate::common::pieces::{Change, Errors, Pieces, wholes};
use crate::common::soup;
use glam::{DVec3, dvec3};
use heatwalk::{
    BuildReport, DistanceOptions, DistanceSolver, InputVertex, Method, Soup, Surface, VertexData, VertexId, WeldRule,
    go_on,
};
use heatwalk_shapes as shapes;

/// What noise of 10⁻⁵ of the diagonal changes of exact distances at most, in per cent: it moves an edge's ends, on meshes whose
/// edges are a hundredth of the diagonal, by a thousandth of the edge.
const MOST_OF_NOISE: f64 = 0.1;

fn built(soup: &Soup, rule: WeldRule) -> Surface {
    Surface::build_by(soup, rule, NonZeroUsize::MIN).expect("a surface")
}

fn exact(surface: &Arc<Surface>, source: VertexId) -> VertexData<f64> {
    let mut solver = DistanceSolver::new(Arc::clone(surface));
    let answer = solver.distance(&[source], &DistanceOptions::by(Method::Exact), &mut go_on);
    answer.expect("a distance").distance.values
}

/// The side of a cylinder of radius 1, rolled up of a grid whose two ends miss each other by this in every direction.
fn rolled(gap: f64) -> Soup {
    const AROUND: u32 = 48;
    const UP: u32 = 24;
    let at = |i: u32, j: u32| {
        let (y, x) = (TAU * f64::from(i) / f64::from(AROUND)).sin_cos();
        let moved = if i == AROUND { gap } else { 0.0 };
        dvec3(x + moved, y + moved, 3.0 * f64::from(j) / f64::from(UP) - moved)
    };
    let number = |i: u32, j: u32| i * (UP + 1) + j;
    let positions = (0..=AROUND).flat_map(|i| (0..=UP).map(move |j| at(i, j))).collect();
    let quads = (0..AROUND).flat_map(|i| (0..UP).map(move |j| [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]));
    let triangles = quads.flat_map(|quad| {
        let [a, b, c, d] = quad.map(|(i, j)| number(i, j));
        [[a, b, c], [a, c, d]]
    });
    soup(positions, triangles.collect())
}

/// A square of 4 × 4 cells at a height, shifted along by so much.
fn sheet(height: f64, shift: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let grid = shapes::grid(4, 4);
    (grid.positions.iter().map(|&position| position + dvec3(shift, height, shift)).collect(), grid.triangles)
}

fn together(parts: &[(Vec<DVec3>, Vec<[u32; 3]>)]) -> Soup {
    let mut whole = Soup::default();
    for (positions, triangles) in parts {
        whole.add(positions.iter().copied(), triangles);
        whole.end_part("sheet");
    }
    whole
}

fn without_inputs(report: &BuildReport) -> BuildReport {
    BuildReport { input_vertices: 0, welded_vertices: 0, crack_vertices: 0, crack_width: 0.0, ..report.clone() }
}

#[test]
fn pieces_that_miss_each_other_by_little_become_the_whole() {
    for whole in wholes() {
        let expected = exact(&whole.surface, whole.source);
        for noise in [1e-9, 1e-6, 1e-5] {
            let pieces = Pieces::new(&whole, Change::Noise(noise), WeldRule::Automatic);
            let report = pieces.surface.report();
            assert_eq!(without_inputs(report), without_inputs(whole.surface.report()), "{} {noise}", whole.name);
            assert!(report.crack_vertices > 100 && report.crack_width > noise, "{report:?}");
            let errors = Errors::between(&exact(&pieces.surface, pieces.source), &pieces.copied(&expected));
            assert!(errors.mean <= MOST_OF_NOISE, "{} {noise}: {errors:?}", whole.name);
            let apart = Pieces::new(&whole, Change::Noise(noise), WeldRule::Exact);
            let report = apart.surface.report();
            assert!(report.components >= 10 && report.crack_vertices == 0, "{report:?}");
        }
    }
}

#[test]
fn a_seam_within_one_component_is_closed() {
    // The side of a cylinder is flat when it is unrolled: straight across the seam, not around the other side.
    let rolled = rolled(1e-6);
    let [from, to] = [24 + 25, 46 * 25 + 24].map(InputVertex);
    let distance = |rule| {
        let surface = Arc::new(built(&rolled, rule));
        let [from, to] = [from, to].map(|input| surface.vertex_of_input(input).expect("a vertex"));
        (surface.report().boundary_loops, exact(&surface, from)[to])
    };
    let (loops, across) = distance(WeldRule::Automatic);
    let angle = TAU / 48.0;
    assert_eq!(loops, 2);
    assert!((across - 3.0 * angle).abs() < 0.01 * angle, "{across}");
    let (loops, around) = distance(WeldRule::Exact);
    assert_eq!(loops, 1);
    assert!((around - 45.0 * angle).abs() < 0.01 * PI, "{around}");
}

#[test]
fn the_rule_says_how_wide_cracks_may_be() {
    let rolled = rolled(1e-3);
    let crack = 1e-3 * 3_f64.sqrt();
    for (rule, count) in [
        (WeldRule::Exact, 0),
        (WeldRule::Automatic, 0),
        (WeldRule::Within(0.999 * crack), 0),
        (WeldRule::Within(1.001 * crack), 25),
        // Of triangles with an altitude of 0.09, vertices move by 0.0045 at most.
        (WeldRule::Within(f64::MAX), 25),
    ] {
        let report = built(&rolled, rule).report().clone();
        assert_eq!(report.crack_vertices, count, "{rule}");
        assert!((report.crack_width - if count > 0 { crack } else { 0.0 }).abs() < 1e-15);
    }
    assert_eq!(built(&self::rolled(0.01), WeldRule::Within(1.0)).report().crack_vertices, 0);
}

#[test]
fn layers_stay_apart() {
    for shift in [0.0, 1e-7] {
        let layers = together(&[sheet(0.0, 0.0), sheet(1e-6, shift)]);
        let report = built(&layers, WeldRule::Automatic).report().clone();
        assert_eq!((report.components, report.crack_vertices, report.duplicate_faces), (2, 0, 0));
        assert_eq!(report.faces, layers.triangles.len());
    }
}

#[test]
fn what_only_touches_stays_apart() {
    // Closed: nothing is a boundary. Sheets: they come together in a corner alone.
    let ball = shapes::icosphere(2);
    let beside = ball.positions.iter().map(|&position| position + dvec3(2.0, 0.0, 1e-7)).collect();
    let balls = together(&[(ball.positions.clone(), ball.triangles.clone()), (beside, ball.triangles)]);
    let side = {
        let (positions, _) = sheet(0.0, 0.0);
        positions.iter().map(|position| position.x).fold(0.0, f64::max)
            - positions.iter().map(|position| position.x).fold(0.0, f64::min)
    };
    let sheets = together(&[sheet(0.0, 0.0), sheet(0.0, side * (1.0 + 1e-7))]);
    for apart in [balls, sheets] {
        let [exact, automatic] = [WeldRule::Exact, WeldRule::Automatic].map(|rule| built(&apart, rule));
        assert_eq!(exact.report(), automatic.report());
    }
}

#[test]
fn three_sheets_meet_along_a_line() {
    let wing = |angle: f64| {
        let (positions, triangles) = sheet(0.0, 0.0);
        let least = positions.iter().map(|position| position.x).fold(0.0, f64::min);
        let turned = positions.iter().map(|position| {
            let (sin, cos) = angle.sin_cos();
            let out = position.x - least;
            dvec3(out * cos, out * sin, position.z) + 1e-6 * dvec3(cos, sin, angle)
        });
        (turned.collect(), triangles)
    };
    let report = built(&together(&[wing(0.0), wing(2.0), wing(4.0)]), WeldRule::Automatic).report().clone();
    assert_eq!((report.components, report.crack_vertices, report.non_manifold_edges), (1, 10, 4));
}

#[test]
fn neither_the_unit_nor_the_origin_matters() {
    for (scale, offset) in [(1.0, 0.0), (1e-6, 0.0), (1e-140, 0.0), (1e140, 0.0), (1.0, 1e6)] {
        let mut rolled = rolled(1e-6);
        for position in &mut rolled.positions {
            *position = scale * *position + offset;
        }
        let report = built(&rolled, WeldRule::Automatic).report().clone();
        assert_eq!((report.crack_vertices, report.boundary_loops), (25, 2), "{scale} {offset}");
    }
}

/// So many triangles in a row, each a little farther from the last one than that was from the one before.
fn row(count: u32) -> Soup {
    let mut start = 0.0;
    let corners = (0..count).flat_map(|number| {
        let corners = [dvec3(start, 0.0, 0.0), dvec3(start + 1.0, 0.5, 0.0), dvec3(start + 0.5, 1.0, 0.0)];
        start += 1.0 + 1e-3 * (1.0 + f64::from(number) / f64::from(count));
        corners
    });
    let positions = corners.collect();
    soup(positions, (0..count).map(|number| [0, 1, 2].map(|k| 3 * number + k)).collect())
}

#[test]
fn a_long_row_of_triangles_takes_no_longer_than_any_other_surface() {
    // As many rounds of a tree of them all would be a matter of hours.
    let report = built(&row(50_000), WeldRule::Automatic).report().clone();
    assert_eq!((report.components, report.crack_vertices), (50_000, 0));
}
