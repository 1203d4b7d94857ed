//! What holds of distances in meshes full of holes, whatever they look like.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::riddled::{along_edges, riddled};
use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_volume::{
    Error, TetId, TetMesh, TetPoint, TetSoup, TetSource, VolumeCrowd, VolumeMethod, VolumeOptions, VolumeSolver,
};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

/// Rounding of sums of lengths.
const ROUNDING: f64 = 1e-12;

/// Some of each kind: of few and of many points, little and half of it taken out.
fn solvers() -> impl Iterator<Item = VolumeSolver> {
    let mut random = SplitMix64::seed_from_u64(5);
    let kinds = [(8, 0.1), (10, 0.3), (15, 0.5), (20, 0.2), (30, 0.4), (40, 0.1), (50, 0.5), (60, 0.3)];
    kinds
        .into_iter()
        .map(move |(points, share)| VolumeSolver::new(TetMesh::build(&riddled(points, share, &mut random)).unwrap()))
}

/// `#V × #V`, from each vertex to each.
fn distances(solver: &mut VolumeSolver, method: VolumeMethod) -> Vec<Vec<f64>> {
    let count = solver.mesh().vertex_count() as u32;
    let from = |source| solver.distance(&[VertexId(source)], &VolumeOptions::by(method)).unwrap().values;
    (0..count).map(from).collect()
}

#[test]
fn no_distance_is_above_the_way_along_edges_or_below_the_straight_line() {
    for method in [VolumeMethod::March, VolumeMethod::Heat] {
        for mut solver in solvers() {
            let values = distances(&mut solver, method);
            let mesh = solver.mesh();
            for (from, (values, edges)) in values.iter().zip(along_edges(mesh)).enumerate() {
                for (to, (&value, along)) in values.iter().zip(edges).enumerate() {
                    let straight = mesh.positions()[from].distance(mesh.positions()[to]);
                    let what = format!("{method}, {from} to {to}: {value}, straight {straight}, along edges {along}");
                    assert!(value >= straight * (1.0 - ROUNDING), "{what}");
                    assert!(value == along || value <= along * (1.0 + ROUNDING), "{what}");
                }
            }
        }
    }
}

#[test]
fn marched_distances_there_and_back_differ_by_a_hundredth_at_most() {
    for mut solver in solvers() {
        let values = distances(&mut solver, VolumeMethod::March);
        for (from, to) in (0..values.len()).flat_map(|from| (0..from).map(move |to| (from, to))) {
            let [there, back] = [values[from][to], values[to][from]];
            assert!(there == back || (there - back).abs() <= 0.01 * there.max(back), "{from} to {to}: {there} {back}");
        }
    }
}

#[test]
fn in_larger_meshes_distances_there_and_back_differ_by_a_hundredth_at_most() {
    let mut random = SplitMix64::seed_from_u64(9);
    for (points, share) in [(300, 0.05), (400, 0.3), (500, 0.5)] {
        let mut solver = VolumeSolver::new(TetMesh::build(&riddled(points, share, &mut random)).unwrap());
        let count = solver.mesh().vertex_count() as u32;
        let mut from = |source| solver.distance(&[VertexId(source)], &VolumeOptions::default()).unwrap().values;
        let vertices: Vec<u32> = (0..count).step_by(count as usize / 20).collect();
        let values: Vec<Vec<f64>> = vertices.iter().map(|&source| from(source)).collect();
        for (from, to) in (0..vertices.len()).flat_map(|from| (0..from).map(move |to| (from, to))) {
            let [there, back] = [values[from][vertices[to] as usize], values[to][vertices[from] as usize]];
            assert!(there == back || (there - back).abs() <= 0.01 * there.max(back), "{from} to {to}: {there} {back}");
        }
    }
}

#[test]
fn a_largest_distance_leaves_out_what_is_farther_and_changes_nothing_else() {
    for mut solver in solvers() {
        let full = solver.distance(&[VertexId(0)], &VolumeOptions::default()).unwrap();
        for max_distance in full.values.clone().into_iter().filter(|&value| value > 0.0 && value.is_finite()) {
            let options = VolumeOptions { max_distance, ..VolumeOptions::default() };
            let values = solver.distance(&[VertexId(0)], &options).unwrap().values;
            let kept = |&value: &f64| if value <= max_distance { value } else { f64::INFINITY };
            assert_eq!(values, full.values.iter().map(kept).collect::<Vec<f64>>());
        }
    }
}

/// Without what joins both sides of the plane x = 1/2 below y = 1/2, and one side this far away there.
fn with_crack(TetSoup { mut positions, mut tetrahedra }: TetSoup, width: f64) -> TetSoup {
    let mut twins = vec![None; positions.len()];
    for corners in &mut tetrahedra {
        if corners.map(|corner| positions[corner as usize].x).iter().sum::<f64>() > 2.0 {
            *corners = corners.map(|corner| {
                let place = positions[corner as usize];
                if place.y > 0.5 {
                    return corner;
                }
                *twins[corner as usize].get_or_insert_with(|| {
                    positions.push(place + width * DVec3::X);
                    positions.len() as u32 - 1
                })
            });
        }
    }
    TetSoup { positions, tetrahedra }
}

#[test]
fn nothing_is_seen_through_cracks_of_no_width() {
    let mut random = SplitMix64::seed_from_u64(21);
    for (points, share) in [(40, 0.0), (60, 0.1), (200, 0.0), (200, 0.1)] {
        let soup = riddled(points, share, &mut random);
        // Wide enough for two sides not to be at one place.
        const HAIR: f64 = 1e-7;
        let [closed, open] = [0.0, HAIR].map(|width| TetMesh::build(&with_crack(soup.clone(), width)).unwrap());
        let whole = TetMesh::build(&soup).unwrap();
        let count = closed.vertex_count() as u32;
        assert!(count as usize > whole.vertex_count());
        let mut solvers = [closed, open].map(VolumeSolver::new);
        let mut is_longer = false;
        for source in (0..count).step_by(7) {
            let source = VertexId(source);
            let [closed, open] = solvers.each_mut().map(|solver| solver.distance(&[source], &VolumeOptions::default()));
            let [closed, open] = [closed.unwrap(), open.unwrap()];
            for (vertex, (&one, &other)) in closed.values.iter().zip(&open.values).enumerate() {
                let what = format!("{points} {share}, {} to {vertex}: {one} {other}", source.0);
                // Of paths around both sides of something, the one found may be another one.
                assert!(one == other || (one - other).abs() <= 0.01 * one.max(other), "{what}");
                let straight = solvers[0].mesh().positions()[vertex].distance(solvers[0].mesh().position(source));
                is_longer |= one.is_finite() && one > 1.1 * straight;
            }
        }
        assert!(is_longer, "{points} {share}: some paths go around the crack");
    }
}

#[test]
fn the_distance_at_a_place_is_that_from_there() {
    let mut random = SplitMix64::seed_from_u64(17);
    for mut solver in solvers() {
        let mesh = Arc::clone(solver.mesh());
        for _ in 0..10 {
            let [one, other] = [0; 2].map(|_| inside(&mesh, &mut random));
            let [there, back] = [[one, other], [other, one]].map(|[from, to]| {
                let distance = solver.distance(&[to], &VolumeOptions::default()).unwrap();
                solver.at(&distance, from).unwrap()
            });
            assert!(
                there == back || (there - back).abs() <= 0.01 * there.max(back),
                "{one:?} {other:?}: {there} {back}"
            );
        }
    }
}

/// A place at random.
fn inside(mesh: &TetMesh, random: &mut SplitMix64) -> TetPoint {
    let shares: [f64; 4] = random.random();
    let sum: f64 = shares.iter().sum();
    let tetrahedron = TetId(random.random_range(0..mesh.tetrahedron_count()) as u32);
    TetPoint::Inside { tetrahedron, weights: shares.map(|share| share / sum) }
}

#[test]
fn marched_paths_are_as_long_as_the_distance_also_from_inside() {
    let mut random = SplitMix64::seed_from_u64(11);
    for mut solver in solvers() {
        let mesh = Arc::clone(solver.mesh());
        let vertex =
            |random: &mut SplitMix64| TetPoint::Vertex(VertexId(random.random_range(0..mesh.vertex_count()) as u32));
        for to in [inside(&mesh, &mut random), vertex(&mut random)] {
            let distance = solver.distance(&[to], &VolumeOptions::default()).unwrap();
            assert_eq!(solver.at(&distance, to).unwrap(), 0.0);
            for from in [inside(&mesh, &mut random), inside(&mesh, &mut random), vertex(&mut random)] {
                let told = solver.at(&distance, from).unwrap();
                match solver.path(&distance, from) {
                    Ok(path) => {
                        assert!((path.length - told).abs() <= 1e-9 * told, "{from:?} {to:?}: {} {told}", path.length);
                        let straight = from.position(&mesh).distance(to.position(&mesh));
                        assert!(told >= straight * (1.0 - ROUNDING), "{from:?} {to:?}: {told} {straight}");
                    }
                    Err(error) => assert_eq!((error, told), (Error::Unreachable, f64::INFINITY)),
                }
            }
        }
    }
}

#[test]
fn two_places_in_one_tetrahedron_are_as_far_apart_as_the_straight_line() {
    for method in [VolumeMethod::March, VolumeMethod::Heat] {
        for mut solver in solvers() {
            let mesh = Arc::clone(solver.mesh());
            let at = |weights| TetPoint::Inside { tetrahedron: TetId(0), weights };
            let [one, other] = [at([0.1, 0.2, 0.3, 0.4]), at([0.4, 0.1, 0.3, 0.2])];
            let distance = solver.distance(&[one], &VolumeOptions::by(method)).unwrap();
            let straight = one.position(&mesh).distance(other.position(&mesh));
            let told = solver.at(&distance, other).unwrap();
            assert!((told - straight).abs() <= ROUNDING, "{method}: {told} {straight}");
            assert_eq!(solver.at(&distance, one).unwrap(), 0.0, "{method}");
        }
    }
}

#[test]
fn answers_do_not_depend_on_the_size_of_the_mesh() {
    let soup = riddled(20, 0.3, &mut SplitMix64::seed_from_u64(3));
    let scaled = |size: f64| {
        let positions: Vec<DVec3> = soup.positions.iter().map(|&place| size * place).collect();
        TetMesh::build(&TetSoup { positions, tetrahedra: soup.tetrahedra.clone() })
    };
    for method in [VolumeMethod::March, VolumeMethod::Heat] {
        let expected = distances(&mut VolumeSolver::new(scaled(1.0).unwrap()), method);
        for size in [-498, -300, -99, 99, 300, 498].map(|power| 2.0_f64.powi(power)) {
            let values = distances(&mut VolumeSolver::new(scaled(size).unwrap()), method);
            for (value, expected) in values.iter().flatten().zip(expected.iter().flatten()) {
                assert_eq!(value / size, *expected, "{method} {size:e}");
            }
        }
    }
    for size in [1e-160, 1e160] {
        assert_eq!(scaled(size).unwrap_err().code(), "bad-size", "{size:e}");
    }
}

#[test]
fn places_and_paths_in_meshes_of_extreme_sizes_are_those_of_ordinary_ones() {
    let soup = riddled(20, 0.1, &mut SplitMix64::seed_from_u64(3));
    let weights = [0.1, 0.2, 0.3, 0.4];
    let [from, to] = [0, 30].map(|tetrahedron| TetPoint::Inside { tetrahedron: TetId(tetrahedron), weights });
    let answers = |size: f64| {
        let positions: Vec<DVec3> = soup.positions.iter().map(|&place| size * place).collect();
        let mesh = TetMesh::build(&TetSoup { positions, tetrahedra: soup.tetrahedra.clone() }).unwrap();
        let costs = vec![3.0; mesh.tetrahedron_count()];
        let mut solver = VolumeSolver::with_costs(mesh, &costs).unwrap();
        let distance = solver.distance(&[TetSource { initial_distance: size, ..to.into() }], &VolumeOptions::default());
        let distance = distance.unwrap();
        let path = solver.path(&distance, from).unwrap();
        let mut crowd = VolumeCrowd::new(Arc::clone(solver.mesh()), 3, 7);
        crowd.follow(&solver, distance.clone()).unwrap();
        crowd.advance(0.01 * size).unwrap();
        let mesh = solver.mesh();
        let near = VolumeOptions { max_distance: 2.0 * size, ..VolumeOptions::default() };
        (
            [path.length / size, path.cost / size, solver.at(&distance, from).unwrap() / size],
            path.points.iter().map(|&point| point / size).collect::<Vec<_>>(),
            crowd.poses(DVec3::Y).map(|pose| (pose.position / size, pose.heading)).collect::<Vec<_>>(),
            mesh.locate(from.position(mesh)),
            mesh.quality(),
            distance.gradient(mesh).unwrap(),
            VolumeSolver::new(Arc::clone(mesh)).distance(&[to], &near).unwrap().unreachable(),
        )
    };
    let expected = answers(1.0);
    for size in [-498, -99, 99, 498].map(|power| 2.0_f64.powi(power)) {
        assert_eq!(answers(size), expected, "{size:e}");
    }
}
