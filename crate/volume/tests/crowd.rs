//! Crowds inside of meshes: they start anywhere that has a path, walk by the step, arrive, and start again.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::{mesh, nearest, two_of};
use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_volume::crowd::{VolumeCrowd, VolumePose};
use heatwalk_volume::{Error, TetId, TetMesh, TetSoup, VolumeOptions, VolumeSolver, shapes};

const SEED: u64 = 5;

/// Steps in which every one of 100 walkers has got a path, at 8 a step.
const SETTING_OUT: usize = 13;

fn poses(crowd: &VolumeCrowd) -> Vec<VolumePose> {
    crowd.poses(DVec3::Y).collect()
}

/// A mesh with its solver and a crowd of 100 that follows the distance from a vertex.
fn crowd(soup: &TetSoup, costs: Option<&dyn Fn(DVec3) -> f64>, source: DVec3) -> (VolumeSolver, VolumeCrowd) {
    let mesh = Arc::new(mesh(soup));
    let centroid = |tetrahedron: usize| mesh.corners(TetId(tetrahedron as u32)).iter().sum::<DVec3>() / 4.0;
    let mut solver = match costs {
        Some(cost) => {
            let costs: Vec<f64> = (0..mesh.tetrahedron_count()).map(|number| cost(centroid(number))).collect();
            VolumeSolver::with_costs(Arc::clone(&mesh), &costs).unwrap()
        }
        None => VolumeSolver::new(Arc::clone(&mesh)),
    };
    let distance = solver.distance(&[nearest(&mesh, source)], &VolumeOptions::default()).unwrap();
    let mut crowd = VolumeCrowd::new(mesh, 100, SEED);
    crowd.follow(&solver, distance).unwrap();
    (solver, crowd)
}

fn check_poses(mesh: &TetMesh, crowd: &VolumeCrowd) {
    for pose in poses(crowd) {
        assert!((pose.up.length() - 1.0).abs() < 1e-12 && (pose.heading.length() - 1.0).abs() < 1e-12, "{pose:?}");
        assert!(pose.up.dot(pose.heading).abs() < 1e-12, "{pose:?}");
        assert!(pose.up.y >= -1e-12, "{pose:?}");
        assert!(mesh.locate(pose.position).is_some() && pose.arc >= 0.0, "{pose:?}");
    }
}

#[test]
fn walkers_come_nearer_by_each_step_and_start_again_where_they_arrive() {
    let source = DVec3::splat(-1.0);
    let (solver, mut crowd) = crowd(&shapes::cube(6, 0.2), None, source);
    for _ in 0..SETTING_OUT {
        crowd.advance(0.0).unwrap();
    }
    let step = 0.11;
    let mut arrivals = 0;
    for _ in 0..40 {
        let before = poses(&crowd);
        crowd.advance(step).unwrap();
        check_poses(solver.mesh(), &crowd);
        for (old, new) in before.iter().zip(poses(&crowd)) {
            let nearer = old.position.distance(source) - new.position.distance(source);
            if new.arc > 0.0 {
                assert!((nearer - step).abs() < 1e-9 && (new.arc - old.arc - step).abs() < 1e-12, "{old:?} {new:?}");
                assert!(new.heading.dot((source - new.position).normalize()) > 1.0 - 1e-9);
            } else if new.position != old.position {
                assert!(old.position.distance(source) <= step * (1.0 + 1e-9));
                arrivals += 1;
            }
        }
    }
    assert!(arrivals > 100, "{arrivals}");
}

#[test]
fn a_few_get_their_paths_in_each_step_and_the_others_wait() {
    let (_, mut crowd) = crowd(&shapes::cube(4, 0.2), None, DVec3::ONE);
    for advanced in 1..=SETTING_OUT {
        crowd.advance(1e-6).unwrap();
        let walking = poses(&crowd).iter().filter(|pose| pose.arc > 0.0).count();
        assert_eq!(walking, (8 * advanced).min(100));
    }
}

#[test]
fn places_are_spread_by_volume() {
    let (_, mut crowd) = crowd(&shapes::cube(3, 0.2), None, DVec3::ONE);
    crowd.set_count(4000);
    crowd.advance(0.0).unwrap();
    assert_eq!((crowd.count(), poses(&crowd).len()), (4000, 4000));
    for octant in 0..8 {
        let is_in = |pose: &&VolumePose| {
            let [x, y, z] = pose.position.to_array().map(|x| usize::from(x > 0.0));
            x + 2 * y + 4 * z == octant
        };
        // 500 are expected, and 21 more or less are likely.
        let count = poses(&crowd).iter().filter(is_in).count();
        assert!((400..600).contains(&count), "{count}");
    }
    crowd.set_count(10);
    assert_eq!(poses(&crowd).len(), 10);
}

#[test]
fn the_same_seed_gives_the_same_crowd() {
    let run = |seed| {
        let (mut solver, _) = crowd(&shapes::ball(4, 0.2), None, DVec3::X);
        let distance = solver.distance(&[VertexId(9)], &VolumeOptions::default()).unwrap();
        let mut crowd = VolumeCrowd::new(Arc::clone(solver.mesh()), 20, seed);
        crowd.follow(&solver, distance).unwrap();
        (0..30).for_each(|_| crowd.advance(0.1).unwrap());
        poses(&crowd)
    };
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
}

#[test]
fn walkers_are_slower_where_tetrahedra_cost_more() {
    for (costs, cost_at) in [
        (&(|place: DVec3| if place.x > 0.0 { 4.0 } else { 1.0 }) as &dyn Fn(DVec3) -> f64, [1.0, 4.0]),
        (&|_: DVec3| 2.0, [2.0, 2.0]),
    ] {
        let (_, mut crowd) = crowd(&shapes::cube(4, 0.0), Some(costs), DVec3::new(-1.0, 0.0, 0.0));
        for _ in 0..SETTING_OUT {
            crowd.advance(0.0).unwrap();
        }
        let step = 0.01;
        for _ in 0..10 {
            let before = poses(&crowd);
            crowd.advance(step).unwrap();
            for (old, new) in before.iter().zip(poses(&crowd)).filter(|(_, new)| new.arc > 0.0) {
                let sides = [old.position.x, new.position.x];
                if sides.iter().all(|x| *x > 1e-6) || sides.iter().all(|x| *x < -1e-6) {
                    let expected = step / cost_at[usize::from(sides[0] > 0.0)];
                    assert!((new.arc - old.arc - expected).abs() < 1e-12, "{old:?} {new:?}");
                }
            }
        }
    }
}

#[test]
fn a_new_distance_turns_walkers_where_they_are() {
    let (mut solver, mut crowd) = crowd(&shapes::cave(0.5, 3, 0.15), None, DVec3::X);
    (0..30).for_each(|_| crowd.advance(0.02).unwrap());
    let before = poses(&crowd);
    let source = nearest(solver.mesh(), -DVec3::X);
    let distance = solver.distance(&[source], &VolumeOptions::default()).unwrap();
    crowd.follow(&solver, distance.clone()).unwrap();
    (0..SETTING_OUT).for_each(|_| crowd.advance(0.0).unwrap());
    for (old, new) in before.iter().zip(poses(&crowd)) {
        assert_eq!((old.position, old.arc), (new.position, new.arc));
        let from = solver.mesh().locate(new.position).unwrap();
        let path = solver.path(&distance, from).unwrap();
        assert!((path.points[1] - path.points[0]).normalize().dot(new.heading) > 1.0 - 1e-6, "{new:?} {path:?}");
    }
}

#[test]
fn nobody_starts_where_no_source_is_reached() {
    let soup = two_of(shapes::cube(2, 0.0));
    let wall = |place: DVec3| if place.y > 0.0 { f64::INFINITY } else { 1.0 };
    let (mut solver, mut crowd) = crowd(&soup, Some(&wall), DVec3::splat(-1.0));
    for _ in 0..50 {
        crowd.advance(0.3).unwrap();
        assert_eq!(poses(&crowd).len(), 100);
        assert!(poses(&crowd).iter().all(|pose| pose.position.x <= 1.0 && pose.position.y <= 1e-9));
    }
    // They move over when the source does.
    let there = nearest(solver.mesh(), DVec3::new(4.0, -1.0, 1.0));
    let distance = solver.distance(&[there], &VolumeOptions::default()).unwrap();
    crowd.follow(&solver, distance).unwrap();
    (0..SETTING_OUT).for_each(|_| crowd.advance(0.0).unwrap());
    assert!(poses(&crowd).iter().all(|pose| pose.position.x >= 2.0));
    // No tetrahedron has a path from everywhere: nobody comes, and those who are out stay.
    let near = VolumeOptions { max_distance: 1e-3, ..VolumeOptions::default() };
    let distance = solver.distance(&[there], &near).unwrap();
    crowd.follow(&solver, distance).unwrap();
    crowd.set_count(120);
    (0..SETTING_OUT).for_each(|_| crowd.advance(1.0).unwrap());
    assert_eq!(poses(&crowd).len(), 100);
}

#[test]
fn up_leans_where_walkers_climb_and_has_a_direction_where_they_climb_upright() {
    let (_, mut crowd) = crowd(&shapes::cube(4, 0.0), None, DVec3::new(0.0, 1.0, 0.0));
    (0..20).for_each(|_| crowd.advance(0.01).unwrap());
    for up in [DVec3::Y, DVec3::Z, -DVec3::X, 5.0 * DVec3::Y, poses(&crowd)[0].heading, DVec3::ZERO] {
        for pose in crowd.poses(up) {
            assert!((pose.up.length() - 1.0).abs() < 1e-12 && pose.up.dot(pose.heading).abs() < 1e-12);
            assert!(pose.up.dot(up) >= -1e-9 * up.length());
        }
    }
}

#[test]
fn rejects_bad_steps_and_distances_of_another_mesh() {
    let (solver, mut crowd) = crowd(&shapes::cube(2, 0.0), None, DVec3::ONE);
    for step in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(crowd.advance(step).unwrap_err().code(), "bad-parameter");
    }
    let mut other = VolumeSolver::new(mesh(&shapes::cube(2, 0.0)));
    let distance = other.distance(&[VertexId(0)], &VolumeOptions::default()).unwrap();
    let refused = [crowd.follow(&other, distance.clone()), crowd.follow(&solver, distance)];
    for (refused, what) in refused.into_iter().zip(["solver", "distance"]) {
        assert_eq!(refused.unwrap_err(), Error::ForeignMesh { what });
    }
    let mut idle = VolumeCrowd::new(Arc::clone(solver.mesh()), 10, SEED);
    idle.advance(1.0).unwrap();
    assert_eq!(poses(&idle).len(), 0);
}
