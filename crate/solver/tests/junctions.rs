//! Cracks with T-junctions within one component, against surfaces without them.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::soup;
use glam::{DVec3, dvec3};
use heatwalk::{
    BridgeRule, Bridges, Distance, DistanceOptions, DistanceSolver, Method, Path, Soup, Surface, VertexId, descend,
    go_on, straighten,
};

/// What portals may make distances longer, in per cent: all that crosses passes through one of a row of points.
const MOST_MEAN: f64 = 0.002;
const MOST_HIGH: f64 = 0.05;

/// How much longer straightened paths may be: descent passes through a portal near the best one.
const MOST_OF_PATHS: f64 = 0.01;

/// Cells of the coarse half along each side.
const COARSE: u32 = 12;

/// A square of two halves: in the one, cells are so many times as wide as in the other, but for the row at the seam of which
/// only the ends are vertices of both. `bend` takes places of the unit square into space.
fn halves(finer: u32, bend: impl Fn(f64, f64) -> DVec3) -> Soup {
    let mut whole = Soup::default();
    for (cells, from) in [(COARSE, 0.0), (finer * COARSE, 0.5)] {
        let first = whole.positions.len() as u32;
        let across = cells / 2;
        let share = |number: u32, of: u32| f64::from(number) / f64::from(of);
        let points = (0..=across).flat_map(|i| (0..=cells).map(move |j| (i, j)));
        whole.positions.extend(points.map(|(i, j)| bend(from + 0.5 * share(i, across), share(j, cells))));
        let at = |i: u32, j: u32| first + i * (cells + 1) + j;
        for (i, j) in (0..across).flat_map(|i| (0..cells).map(move |j| (i, j))) {
            let quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            whole.triangles.extend([[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]);
        }
    }
    whole.end_part("halves");
    soup(whole.positions, whole.triangles)
}

fn surface_of(soup: &Soup) -> Arc<Surface> {
    Arc::new(Surface::build(soup).expect("a surface"))
}

fn distance(surface: &Arc<Surface>, bridges: Bridges, source: VertexId, method: Method) -> Distance {
    let mut solver = DistanceSolver::new(Arc::clone(surface)).bridged(bridges);
    solver.distance(&[source], &DistanceOptions::by(method), &mut go_on).expect("a distance").distance
}

/// The vertex nearest to a place.
fn vertex_at(surface: &Surface, place: DVec3) -> VertexId {
    let squared = |vertex: &VertexId| surface.position(*vertex).distance_squared(place);
    surface.vertices().min_by(|a, b| squared(a).total_cmp(&squared(b))).expect("a vertex")
}

/// Errors in per cent: mean and greatest.
fn errors(pairs: impl Iterator<Item = (f64, f64)>) -> [f64; 2] {
    let (mut sum, mut most, mut count) = (0.0, 0.0_f64, 0);
    for (value, expected) in pairs.filter(|&(_, expected)| expected > 0.0) {
        let error = 100.0 * (value / expected - 1.0).abs();
        (sum, most, count) = (sum + error, most.max(error), count + 1);
    }
    [sum / f64::from(count), most]
}

/// Every vertex's distance by a method, and what it should be.
fn compared(
    surface: &Arc<Surface>,
    rule: BridgeRule,
    source: VertexId,
    method: Method,
    expected: impl Fn(DVec3, DVec3) -> f64,
) -> [f64; 2] {
    let distance = distance(surface, Bridges::find(surface, rule), source, method);
    let expected = |vertex| expected(surface.position(source), surface.position(vertex));
    errors(surface.vertices().map(|vertex| (distance.values[vertex], expected(vertex))))
}

/// Places in the coarse half, in the fine one, and on the seam.
const PLACES: [[f64; 2]; 3] = [[0.1, 0.2], [0.9, 0.3], [0.5, 0.5]];

#[test]
fn distances_lead_across_a_seam_with_vertices_on_one_side() {
    for finer in [2, 3, 5] {
        let surface = surface_of(&halves(finer, |x, y| dvec3(x, y, 0.0)));
        let report = surface.report();
        assert_eq!((report.components, report.boundary_loops), (1, 2), "{report:?}");
        for [x, y] in PLACES {
            let source = vertex_at(&surface, dvec3(x, y, 0.0));
            let [mean, most] = compared(&surface, BridgeRule::Automatic, source, Method::Exact, DVec3::distance);
            assert!(mean <= MOST_MEAN && most <= MOST_HIGH, "{finer} {x}: {mean} {most}");
        }
        let source = vertex_at(&surface, dvec3(0.1, 0.2, 0.0));
        let [_, without] = compared(&surface, BridgeRule::Off, source, Method::Exact, DVec3::distance);
        assert!(without > 5.0, "{without}");
        // Heat stays within the surface as it is.
        let by_heat = |rule| distance(&surface, Bridges::find(&surface, rule), source, Method::Heat).values;
        assert_eq!(by_heat(BridgeRule::Automatic), by_heat(BridgeRule::Off));
    }
}

#[test]
fn a_seam_along_an_arc_costs_no_more_than_the_arc_misses() {
    // A part of a cylinder of radius 1, whose seam goes around: the vertices of the fine half are outside the coarse chords.
    const ANGLE: f64 = 1.2;
    let surface = surface_of(&halves(3, |x, y| dvec3(x, (ANGLE * y).sin(), (ANGLE * y).cos())));
    let sagitta = 1.0 - (0.5 * ANGLE / f64::from(COARSE)).cos();
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    let widest = bridges.portals().iter().map(|portal| portal.gap).fold(0.0, f64::max);
    assert!((0.5 * sagitta..=1.01 * sagitta).contains(&widest), "{widest} {sagitta}");
    let angle = |position: DVec3| position.y.atan2(position.z);
    for [x, y] in PLACES {
        let source = vertex_at(&surface, dvec3(x, (ANGLE * y).sin(), (ANGLE * y).cos()));
        let found = distance(&surface, bridges.clone(), source, Method::Exact);
        let from = surface.position(source);
        for vertex in surface.vertices() {
            let to = surface.position(vertex);
            let unrolled = (to.x - from.x).hypot(angle(to) - angle(from));
            let error = (found.values[vertex] - unrolled).abs();
            // Chords are shorter than arcs by a sixth of the square of half their angle; a gap is crossed once.
            let chords = unrolled * (0.5 * ANGLE / f64::from(COARSE)).powi(2) / 6.0;
            assert!(error <= chords + sagitta + 0.01 * MOST_HIGH * unrolled + 1e-12, "{error} of {unrolled}");
        }
    }
}

#[test]
fn paths_cross_where_distances_do() {
    let surface = surface_of(&halves(3, |x, y| dvec3(x, y, 0.0)));
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    let source = vertex_at(&surface, dvec3(0.1, 0.2, 0.0));
    for method in [Method::Exact, Method::Propagation] {
        let distance = distance(&surface, bridges.clone(), source, method);
        for y in [0.1, 0.45, 0.8] {
            let from = vertex_at(&surface, dvec3(0.95, y, 0.0));
            let path: Path =
                straighten(&surface, &descend(&surface, &distance, from).expect("a path")).expect("a path");
            let straight = surface.position(from).distance(surface.position(source));
            assert!(path.length() >= straight * (1.0 - 1e-9), "{} for {straight}", path.length());
            assert!(path.length() <= straight * (1.0 + MOST_OF_PATHS), "{} for {straight}", path.length());
        }
    }
}

#[test]
fn layers_and_edges_that_meet_are_no_cracks() {
    // A strip folded back on itself, nearer than cracks are wide: its long rims lie above each other.
    let (count, gap) = (40, 2e-4);
    let along = |i: u32| {
        let (layer, place) = if i <= count { (0.0, i) } else { (gap, 2 * count + 1 - i) };
        (f64::from(place) / f64::from(count), layer)
    };
    let rows = 2 * count + 2;
    let positions = (0..rows).flat_map(|i| {
        let (x, z) = along(i);
        [dvec3(x, 0.0, z), dvec3(x, 0.2, z)]
    });
    let quads = (0..rows - 1).flat_map(|i| [[2 * i, 2 * i + 2, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 1]]);
    let folded = surface_of(&soup(positions.collect(), quads.collect()));
    assert_eq!(folded.report().components, 1);
    assert!(Bridges::find(&folded, BridgeRule::Automatic).portals().is_empty());
    // The rim of a disc, finely divided: neighbours meet, but nothing runs along anything.
    let disc = surface_of(&heatwalk_shapes::grid(30, 30));
    assert!(Bridges::find(&disc, BridgeRule::Automatic).portals().is_empty());
}
