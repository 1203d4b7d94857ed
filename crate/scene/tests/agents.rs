//! Agents: they stay on the surface, come to where they are sent, and make way.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use glam::DVec3;
use heatwalk::{
    Distance, DistanceOptions, DistanceSolver, Error, Place, Surface, SurfacePoint, VertexId, Walls, go_on,
};
use heatwalk_scene::{Agent, Agents, Obstacle};

use crate::common::truth::Random;
use crate::common::{any_triangles, nearest, square, surface};

const FRAME: f64 = 1.0 / 60.0;

fn agents_to(surface: &Arc<Surface>, source: VertexId) -> Agents {
    let mut agents = Agents::new(Arc::clone(surface));
    agents.follow(&distance(surface, source), None).unwrap();
    agents
}

fn distance(surface: &Arc<Surface>, source: VertexId) -> Distance {
    let mut solver = DistanceSolver::new(Arc::clone(surface));
    solver.distance(&[source], &DistanceOptions::default(), &mut go_on).unwrap().distance
}

fn at(surface: &Surface, x: f64, y: f64) -> SurfacePoint {
    surface.point(nearest(surface, DVec3::new(x, y, 0.0))).unwrap()
}

/// Everything that an agent promises, whatever the surface.
fn check(surface: &Surface, agents: &Agents) {
    for agent in agents.agents() {
        let Agent { face, weights, position, velocity, upright, heading, speed, .. } = *agent;
        assert!(weights.iter().all(|weight| (0.0..=1.0).contains(weight)), "{agent:?}");
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{agent:?}");
        let extent = surface.positions().iter().map(|position| position.length()).fold(0.0, f64::max);
        let place = Place::Face { face, weights };
        assert!(place.position(surface).distance(position) <= 1e-12 * extent, "{agent:?}");
        assert!(velocity.length() <= speed * (1.0 + 1e-12), "{agent:?}");
        assert!((upright.length() - 1.0).abs() < 1e-9 && (heading.length() - 1.0).abs() < 1e-9, "{agent:?}");
        assert!(upright.dot(heading).abs() < 1e-9, "{agent:?}");
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::NEG_Z].map(|axis| agent.orientation() * axis);
        assert!(y.distance(upright) < 1e-9 && z.distance(heading) < 1e-9, "{agent:?}");
        assert!(x.distance(heading.cross(upright)) < 1e-9);
    }
}

#[test]
fn one_alone_goes_at_its_speed_and_arrives() {
    let surface = Arc::new(surface(&square(20)));
    let mut agents = agents_to(&surface, nearest(&surface, DVec3::new(0.0, 0.0, 0.0)));
    agents.add(&at(&surface, 1.0, 1.0), 0.01, 0.5).unwrap();
    for _ in 0..60 {
        agents.update(FRAME).unwrap();
        check(&surface, &agents);
    }
    // A second, of which it took some to come to its speed.
    let left = agents.agents()[0].position.truncate().length();
    let walked = 2f64.sqrt() - left;
    assert!((0.5 * 0.5..0.5).contains(&walked), "{walked}");
    assert!(!agents.agents()[0].has_arrived);
    for _ in 0..300 {
        agents.update(FRAME).unwrap();
    }
    let agent = agents.agents()[0];
    assert!(agent.has_arrived && agent.position.truncate().length() < 0.02, "{agent:?}");
    assert!(agent.velocity.length() < 0.01, "it stays there");
}

#[test]
fn two_that_would_meet_make_way() {
    let surface = Arc::new(surface(&square(30)));
    // Both go to the left; the slow one is ahead.
    let mut agents = agents_to(&surface, nearest(&surface, DVec3::new(0.0, 0.5, 0.0)));
    agents.add(&at(&surface, 0.6, 0.5), 0.03, 0.02).unwrap();
    agents.add(&at(&surface, 1.0, 0.5), 0.03, 0.3).unwrap();
    let mut least = f64::INFINITY;
    for _ in 0..200 {
        agents.update(FRAME).unwrap();
        let [slow, fast] = [0, 1].map(|k| agents.agents()[k].position);
        least = least.min(slow.distance(fast));
    }
    assert!(least > 0.055, "they overlap: {least}");
    let [slow, fast] = [0, 1].map(|k| agents.agents()[k].position.x);
    assert!(fast < slow - 0.05, "the fast one has overtaken: {fast} {slow}");
}

#[test]
fn many_at_one_place_come_apart() {
    let surface = Arc::new(surface(&square(20)));
    let mut agents = agents_to(&surface, nearest(&surface, DVec3::new(0.0, 0.0, 0.0)));
    for _ in 0..30 {
        agents.add(&at(&surface, 0.5, 0.5), 0.02, 0.2).unwrap();
    }
    for _ in 0..120 {
        agents.update(FRAME).unwrap();
        check(&surface, &agents);
    }
    apart(&agents);
    // They come to rest around the source.
    for _ in 0..600 {
        agents.update(FRAME).unwrap();
    }
    apart(&agents);
    assert!(agents.agents().iter().all(|agent| agent.has_arrived && agent.position.length() < 0.5));
    // Where those in front are gone, the others go on.
    let nearest = agents.agents().iter().map(|agent| agent.left).fold(f64::INFINITY, f64::min);
    let front: Vec<bool> = agents.agents().iter().map(|agent| agent.left < nearest + 0.05).collect();
    agents.retain(|number| !front[number]);
    agents.update(FRAME).unwrap();
    assert!(agents.agents().iter().any(|agent| !agent.has_arrived));
}

/// No two agents, of radius 0.02, lie half within each other.
fn apart(agents: &Agents) {
    let positions: Vec<DVec3> = agents.agents().iter().map(|agent| agent.position).collect();
    for (k, a) in positions.iter().enumerate() {
        for b in &positions[..k] {
            assert!(a.distance(*b) > 0.02, "{a} {b}");
        }
    }
}

#[test]
fn obstacles_are_gone_around() {
    let surface = Arc::new(surface(&square(30)));
    let mut agents = agents_to(&surface, nearest(&surface, DVec3::new(0.0, 0.5, 0.0)));
    agents.add(&at(&surface, 1.0, 0.5), 0.02, 0.3).unwrap();
    let obstacle = Obstacle { position: DVec3::new(0.5, 0.5, 0.0), velocity: DVec3::ZERO, radius: 0.1 };
    agents.set_obstacles(vec![obstacle]);
    for _ in 0..400 {
        agents.update(FRAME).unwrap();
        let agent = agents.agents()[0];
        assert!(agent.position.distance(obstacle.position) > 0.115, "{agent:?}");
    }
    assert!(agents.agents()[0].has_arrived, "{:?}", agents.agents()[0]);
}

#[test]
fn nobody_passes_a_wall_or_leaves_the_surface() {
    let whole = Arc::new(surface(&square(20)));
    let mut solver = DistanceSolver::new(Arc::clone(&whole));
    // All faces of a column of squares but one row: a gate.
    let middle = |face: heatwalk::FaceId| whole.corners(face).iter().map(|corner| corner.x).sum::<f64>() / 3.0;
    let low = |face: heatwalk::FaceId| whole.corners(face).iter().all(|corner| corner.y < 0.051);
    let faces: Vec<_> =
        whole.mesh().faces().filter(|&face| (0.5..0.55).contains(&middle(face)) && !low(face)).collect();
    assert!(faces.len() > 30);
    solver.set_walls(&Walls { faces: faces.clone(), edges: Vec::new() }).unwrap();
    let parted = Arc::clone(solver.surface());
    let source = nearest(&parted, DVec3::new(0.0, 1.0, 0.0));
    let answer = solver.distance(&[source], &DistanceOptions::default(), &mut go_on).unwrap();
    let mut agents = Agents::new(Arc::clone(&parted));
    agents.follow(&answer.distance, None).unwrap();
    let mut random = Random::new(5);
    for _ in 0..200 {
        let start = at(&parted, 0.6 + 0.4 * random.share(), random.share());
        agents.add(&start, 0.01, 0.2 + 0.2 * random.share()).unwrap();
    }
    let mut before: Vec<DVec3> = agents.agents().iter().map(|agent| agent.position).collect();
    for _ in 0..1500 {
        agents.update(FRAME).unwrap();
        for (agent, before) in agents.agents().iter().zip(&mut before) {
            assert!(!faces.contains(&agent.face), "in the wall: {agent:?}");
            assert!(agent.position.distance(*before) < 0.05, "through the wall: {before} {agent:?}");
            *before = agent.position;
        }
    }
    check(&parted, &agents);
    let through = agents.agents().iter().filter(|agent| agent.position.x < 0.5).count();
    assert!(through > 150, "{through} came through the gate");
}

#[test]
fn any_surface() {
    let mut random = Random::new(11);
    for _ in 0..40 {
        let Ok(any) = Surface::build(&any_triangles(12, &mut random)) else { continue };
        let any = Arc::new(any);
        let mut agents = agents_to(&any, VertexId(0));
        for vertex in any.vertices() {
            agents.add(&any.point(vertex).unwrap(), 0.1, 1.0).unwrap();
        }
        for step in [0.0, 0.01, 0.1, 1.0, 10.0, 0.01] {
            agents.update(step).unwrap();
            check(&any, &agents);
        }
    }
}

#[test]
fn agents_are_moved_and_taken_away() {
    let surface = Arc::new(surface(&square(10)));
    let mut agents = Agents::new(Arc::clone(&surface));
    for k in 0..3 {
        assert_eq!(agents.add(&at(&surface, 0.5 * f64::from(k), 0.5), 0.01, 1.0), Ok(k as usize));
    }
    // Nowhere to go.
    agents.update(1.0).unwrap();
    assert_eq!(agents.agents()[2].position, DVec3::new(1.0, 0.5, 0.0));
    agents.put(2, &at(&surface, 0.0, 0.0));
    agents.retain(|number| number != 1);
    let left: Vec<DVec3> = agents.agents().iter().map(|agent| agent.position).collect();
    assert_eq!(left, [DVec3::new(0.0, 0.5, 0.0), DVec3::ZERO]);
}

#[test]
fn bad_numbers_are_refused() {
    let surface = Arc::new(surface(&square(2)));
    let mut agents = Agents::new(Arc::clone(&surface));
    let point = at(&surface, 0.0, 0.0);
    for (radius, speed) in [(0.0, 1.0), (f64::NAN, 1.0), (0.1, -1.0), (0.1, f64::INFINITY)] {
        assert!(matches!(agents.add(&point, radius, speed), Err(Error::BadParameter { .. })));
    }
    assert!(matches!(agents.update(-1.0), Err(Error::BadParameter { .. })));
    assert!(matches!(agents.update(f64::NAN), Err(Error::BadParameter { .. })));
    let other = Arc::new(crate::common::surface(&square(2)));
    assert!(matches!(agents.follow(&distance(&other, VertexId(0)), None), Err(Error::Surface(_))));
}

#[test]
fn agents_go_on_elsewhere_as_they_would_have() {
    let surface = Arc::new(surface(&square(20)));
    let source = nearest(&surface, DVec3::ZERO);
    let mut agents = agents_to(&surface, source);
    for k in 0..20 {
        agents.add(&at(&surface, 0.3 + 0.02 * f64::from(k), 0.4), 0.02, 0.2).unwrap();
    }
    let walk = |agents: &mut Agents| (0..90).for_each(|_| agents.update(FRAME).unwrap());
    walk(&mut agents);
    let mut others = agents_to(&surface, source);
    others.restore(agents.agents().to_vec()).unwrap();
    assert_eq!(others.agents(), agents.agents());
    walk(&mut agents);
    walk(&mut others);
    assert_eq!(others.agents(), agents.agents());
    assert!(agents.agents().iter().any(|agent| agent.has_arrived));

    let mut few = Agents::new(Surface::build(&square(2)).unwrap());
    let refused = few.restore(agents.agents().to_vec()).unwrap_err();
    assert_eq!(refused.to_string(), "the agent belongs to another surface; make it on this one");
}
