//! Distances by the march, against closed forms.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::{around_cylinder, around_sphere, errors, mesh, nearest, truth, two_of};
use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_volume::{Error, TetId, TetMesh, TetPoint, TetSoup, TetSource, VolumeOptions, VolumeSolver, shapes};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

/// Rounding of a straight line's length, and of walks along it.
const ROUNDING: f64 = 1e-12;

fn distances<S: Into<TetSource> + Copy>(solver: &mut VolumeSolver, sources: &[S]) -> Vec<f64> {
    solver.distance(sources, &VolumeOptions::default()).unwrap().values
}

#[test]
fn distances_are_exact_where_straight_lines_lead_to_the_source() {
    let shapes = [shapes::cube(6, 0.2), shapes::cube(6, 0.0), shapes::ball(5, 0.2), shapes::straight_tube(4.0, 4, 0.2)];
    for soup in shapes {
        let mut solver = VolumeSolver::new(mesh(&soup));
        let mesh = Arc::clone(solver.mesh());
        for place in [DVec3::ZERO, DVec3::new(-0.7, 0.4, 0.3), DVec3::new(1.0, 0.0, 0.0)] {
            let source = nearest(&mesh, place);
            let values = distances(&mut solver, &[source]);
            let [_, largest] = errors(&values, &truth(&mesh, mesh.position(source), DVec3::distance));
            assert!(largest < ROUNDING, "{place}: {largest}");
            assert_eq!(values[source.0 as usize], 0.0);
        }
    }
}

#[test]
fn behind_a_cylinder_and_a_sphere_errors_are_small_and_fall_with_the_cells() {
    type Exact = Box<dyn Fn(DVec3, DVec3) -> f64>;
    type Case<'a> = (&'a dyn Fn(usize) -> TetSoup, Exact, DVec3, f64);
    let cylinder = |cells| shapes::pierced_cube(0.4, cells, 0.15);
    let sphere = |cells| shapes::cave(0.5, cells, 0.15);
    let cases: [Case<'_>; 4] = [
        (&cylinder, Box::new(around_cylinder(0.4)), DVec3::new(-0.7, 0.0, 0.0), 5e-4),
        (&cylinder, Box::new(around_cylinder(0.4)), DVec3::new(-0.4, 0.0, 0.4), 1e-3),
        (&sphere, Box::new(around_sphere(0.5)), DVec3::new(-0.7, 0.1, 0.2), 3e-3),
        (&sphere, Box::new(around_sphere(0.5)), DVec3::new(-0.5, 0.0, 0.0), 6e-3),
    ];
    for (shape, exact, place, bound) in cases {
        let mut before = f64::INFINITY;
        for cells in [2, 4] {
            let mut solver = VolumeSolver::new(mesh(&shape(cells)));
            let mesh = Arc::clone(solver.mesh());
            let source = nearest(&mesh, place);
            let [mean, _] = errors(&distances(&mut solver, &[source]), &truth(&mesh, mesh.position(source), &exact));
            assert!(mean < before, "{cells} cells: {mean} after {before}");
            before = mean;
        }
        assert!(before < bound, "{before}");
    }
}

#[test]
fn in_a_bent_tube_errors_fall_towards_a_finer_mesh() {
    // 6 cells along for each across, so that the vertices of a mesh are among those of one with a multiple of its cells.
    let solved = |cells: usize| {
        let mut solver = VolumeSolver::new(mesh(&shapes::bent_tube(0.35, 4.2, cells, 0.0)));
        let mesh = Arc::clone(solver.mesh());
        let source = nearest(&mesh, DVec3::new(1.0, 0.0, 0.0));
        (distances(&mut solver, &[source]), mesh)
    };
    let (finest, mesh) = solved(12);
    let mut before = 0.01;
    for cells in [2, 4] {
        let (values, coarse) = solved(cells);
        let same = |&place: &DVec3| finest[nearest(&mesh, place).0 as usize];
        let truth: Vec<f64> = coarse.positions().iter().map(same).collect();
        let [mean, _] = errors(&values, &truth);
        println!("{cells} cells: {mean}");
        assert!(mean < before, "{cells} cells: {mean} after {before}");
        before = 0.5 * mean;
    }
}

#[test]
fn around_a_straight_edge_distance_is_that_of_unrolled_walls() {
    // A cube without a quarter, along z: the concave edge is the z axis.
    let soup = shapes::cube(8, 0.0);
    let is_kept = |corners: &&[u32; 4]| {
        let middle = corners.iter().map(|&corner| soup.positions[corner as usize]).sum::<DVec3>() / 4.0;
        middle.x < 0.0 || middle.y < 0.0
    };
    let tetrahedra = soup.tetrahedra.iter().filter(is_kept).copied().collect();
    let mut solver = VolumeSolver::new(mesh(&TetSoup { tetrahedra, ..soup.clone() }));
    let mesh = Arc::clone(solver.mesh());
    let source = nearest(&mesh, DVec3::new(0.75, -0.25, -0.5));
    let exact = |from: DVec3, to: DVec3| {
        // Adding 0 makes a zero positive, on which side of the cut it is.
        let angle = |place: DVec3| (-place.x + 0.0).atan2(-place.y);
        let is_seen = (angle(from) - angle(to)).abs() <= std::f64::consts::PI;
        let across = if is_seen {
            from.truncate().distance(to.truncate())
        } else {
            from.truncate().length() + to.truncate().length()
        };
        across.hypot(from.z - to.z)
    };
    let [_, largest] = errors(&distances(&mut solver, &[source]), &truth(&mesh, mesh.position(source), exact));
    assert!(largest < ROUNDING, "{largest}");
}

#[test]
fn several_sources_give_the_least_of_each() {
    let mut solver = VolumeSolver::new(mesh(&shapes::pierced_cube(0.4, 3, 0.15)));
    let mesh = Arc::clone(solver.mesh());
    let [a, b] = [DVec3::new(-0.9, 0.2, -0.3), DVec3::new(0.8, -0.8, 0.9)].map(|place| nearest(&mesh, place));
    let sources = [TetSource::from(a), TetSource { initial_distance: 0.4, ..TetSource::from(b) }];
    let both = distances(&mut solver, &sources);
    let [one, other] = sources.map(|source| distances(&mut solver, &[source]));
    let least: Vec<f64> = one.iter().zip(&other).map(|(one, other)| one.min(*other)).collect();
    assert_eq!((both[a.0 as usize], both[b.0 as usize]), (0.0, 0.4));
    // Where the two meet on an edge that waves bend around, they share it.
    let [mean, largest] = errors(&both, &least);
    assert!(mean < 1e-4 && largest < 0.02, "{mean} {largest}");
}

#[test]
fn a_source_may_be_anywhere_inside() {
    let mut solver = VolumeSolver::new(mesh(&shapes::ball(4, 0.2)));
    let mesh = Arc::clone(solver.mesh());
    for weights in [[0.1, 0.2, 0.3, 0.4], [0.0, 0.5, 0.25, 0.25], [0.5, 0.0, 0.0, 0.5], [0.0, 0.0, 1.0, 0.0]] {
        let point = TetPoint::Inside { tetrahedron: TetId(77), weights };
        let values = distances(&mut solver, &[point]);
        let [_, largest] = errors(&values, &truth(&mesh, point.position(&mesh), DVec3::distance));
        assert!(largest < ROUNDING, "{weights:?}: {largest}");
    }
}

#[test]
fn a_constant_cost_scales_the_distance() {
    for soup in [shapes::ball(4, 0.2), shapes::pierced_cube(0.4, 3, 0.15)] {
        let mesh = Arc::new(mesh(&soup));
        let plain = distances(&mut VolumeSolver::new(Arc::clone(&mesh)), &[VertexId(3)]);
        for cost in [1e-3, 3.0, 1e3] {
            let costs = vec![cost; mesh.tetrahedron_count()];
            let mut solver = VolumeSolver::with_costs(Arc::clone(&mesh), &costs).unwrap();
            let values: Vec<f64> = distances(&mut solver, &[VertexId(3)]).iter().map(|value| value / cost).collect();
            let [_, largest] = errors(&values, &plain);
            assert!(largest < 1e-9, "{cost}: {largest}");
        }
    }
}

/// Least cost from a place below the plane z = 0 to one above, where a unit costs `above`: by golden section over where the line
/// breaks, which is Fermat's principle.
fn refracted(above: f64) -> impl Fn(DVec3, DVec3) -> f64 {
    move |from, to| {
        if to.z <= 0.0 {
            // Straight, or at the critical angle along a cheaper medium above, which no test has.
            return from.distance(to);
        }
        let (down, up, across) = (-from.z, to.z, from.truncate().distance(to.truncate()));
        let cost = |x: f64| down.hypot(x) + above * up.hypot(across - x);
        let (mut low, mut high) = (0.0, across);
        for _ in 0..80 {
            let third = (high - low) / 3.0;
            if cost(low + third) < cost(high - third) { high -= third } else { low += third }
        }
        cost(low)
    }
}

#[test]
fn paths_into_a_dearer_medium_refract() {
    for cost in [2.0, 10.0] {
        for cells in [8, 16] {
            let mesh = Arc::new(mesh(&shapes::cube(cells, 0.0)));
            let middle = |tetrahedron: usize| mesh.corners(TetId(tetrahedron as u32)).iter().sum::<DVec3>().z / 4.0;
            let costs: Vec<f64> = (0..mesh.tetrahedron_count())
                .map(|tetrahedron| if middle(tetrahedron) > 0.0 { cost } else { 1.0 })
                .collect();
            let mut solver = VolumeSolver::with_costs(Arc::clone(&mesh), &costs).unwrap();
            let source = nearest(&mesh, DVec3::new(0.25, -0.25, -0.5));
            let values = distances(&mut solver, &[source]);
            let [mean, _] = errors(&values, &truth(&mesh, mesh.position(source), refracted(cost)));
            assert!(mean < 5e-3, "cost {cost}, {cells} cells: {mean}");
        }
    }
}

#[test]
fn walls_are_as_if_their_tetrahedra_were_not_there() {
    let soup = shapes::cube(6, 0.2);
    let whole = Arc::new(mesh(&soup));
    let mut random = SplitMix64::seed_from_u64(5);
    for _ in 0..20 {
        let (center, radius) = (DVec3::from_array(random.random()) - 0.5, 0.3 + 0.4 * random.random::<f64>());
        let is_wall = |tetrahedron: usize| {
            let corners = whole.corners(TetId(tetrahedron as u32));
            (corners.iter().sum::<DVec3>() / 4.0).distance(center) < radius
        };
        let costs: Vec<f64> = (0..whole.tetrahedron_count())
            .map(|tetrahedron| if is_wall(tetrahedron) { f64::INFINITY } else { 1.0 })
            .collect();
        let open = (0..whole.tetrahedron_count()).filter(|&tetrahedron| !is_wall(tetrahedron));
        let tetrahedra = open.map(|tetrahedron| soup.tetrahedra[tetrahedron]).collect();
        let without = mesh(&TetSoup { tetrahedra, ..soup.clone() });
        let mut walled = VolumeSolver::with_costs(Arc::clone(&whole), &costs).unwrap();
        let source = nearest(&whole, DVec3::new(-1.0, -1.0, 1.0));
        let values = distances(&mut walled, &[source]);
        let there = without.vertex_of_input(source.0 as usize).unwrap();
        let mut solver = VolumeSolver::new(without);
        let expected = distances(&mut solver, &[there]);
        let expected = solver.mesh().to_inputs(&expected, f64::INFINITY);
        for (value, expected) in values.iter().zip(&expected) {
            assert!(value == expected || (value - expected).abs() < ROUNDING, "{value} {expected}");
        }
    }
}

#[test]
fn what_no_source_reaches_is_at_infinity() {
    let soup = two_of(shapes::ball(2, 0.0));
    let mut solver = VolumeSolver::new(mesh(&soup));
    let answer = solver.distance(&[VertexId(0)], &VolumeOptions::default()).unwrap();
    assert_eq!(answer.unreachable(), soup.positions.len() / 2);
    assert!(answer.max() <= 2.0 + ROUNDING);
}

#[test]
fn distance_passes_where_tetrahedra_touch_in_a_vertex() {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    let mut solver = VolumeSolver::new(mesh(&TetSoup { positions, tetrahedra: vec![[0, 1, 2, 3], [0, 4, 5, 6]] }));
    let values = distances(&mut solver, &[VertexId(1)]);
    assert!(values[4..].iter().all(|&value| (value - 2.0).abs() < ROUNDING), "{values:?}");
}

#[test]
fn a_maximum_distance_leaves_the_rest_at_infinity() {
    let mut solver = VolumeSolver::new(mesh(&shapes::cube(6, 0.2)));
    let all = distances(&mut solver, &[VertexId(0)]);
    let options = VolumeOptions { max_distance: 1.0, ..VolumeOptions::default() };
    let near = solver.distance(&[VertexId(0)], &options).unwrap().values;
    for (all, near) in all.into_iter().zip(near) {
        assert!(if all <= 1.0 { near == all } else { near.is_infinite() }, "{all} {near}");
    }
}

#[test]
fn rejects_invalid_costs_and_sources() {
    let mesh: Arc<TetMesh> = Arc::new(mesh(&shapes::cube(2, 0.0)));
    let count = mesh.tetrahedron_count();
    let refused = |costs: &[f64]| VolumeSolver::with_costs(Arc::clone(&mesh), costs).unwrap_err();
    assert!(matches!(refused(&[1.0]), Error::CostCount { costs: 1, .. }));
    for cost in [0.0, -1.0, f64::NAN, 1e4, f64::NEG_INFINITY] {
        let mut costs = vec![1.0; count];
        costs[7] = cost;
        assert!(matches!(refused(&costs), Error::BadCost { tetrahedron: 7, .. }), "{cost}");
    }
    assert_eq!(refused(&vec![f64::INFINITY; count]), Error::AllWalls);
    let around: Vec<TetId> = mesh.tetrahedra_of(VertexId(0)).collect();
    let cost = |tetrahedron| if around.contains(&TetId(tetrahedron as u32)) { f64::INFINITY } else { 1.0 };
    let mut solver = VolumeSolver::with_costs(Arc::clone(&mesh), &(0..count).map(cost).collect::<Vec<_>>()).unwrap();
    let options = VolumeOptions::default();
    let in_wall = solver.distance(&[VertexId(5), VertexId(0)], &options).unwrap_err();
    assert_eq!(in_wall, Error::SourceInWall { source_number: 1 });
    let negative = TetSource { initial_distance: -1.0, ..TetSource::from(VertexId(5)) };
    assert_eq!(solver.distance(&[negative], &options).unwrap_err(), Error::BadInitialDistance { distance: -1.0 });
    assert_eq!(solver.distance::<VertexId>(&[], &options).unwrap_err().code(), "no-source");
}
