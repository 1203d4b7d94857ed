//! What agents that would meet, or that overlap, do about each other.

use glam::{DQuat, DVec3};

use super::agent::Agent;

/// Strength of the force between agents, for lengths in radii and seconds.
const STRENGTH: f64 = 20.0;
/// τ₀, seconds after which a meeting counts little.
const FORESIGHT: f64 = 2.0;
/// How far to its left an agent takes others to be, in radii of both: of two that would meet head on neither would turn, else.
const LEFT: f64 = 0.1;
/// Radians between the directions in which agents at one place come apart: never those of two others.
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// What an agent would meet.
pub(super) struct Other {
    pub position: DVec3,
    pub velocity: DVec3,
    pub radius: f64,
    /// Of an overlap, what is the agent's to give way.
    pub share: f64,
}

/// The acceleration of an agent, which has this number, by another, and how far it moves out of it.
pub(super) fn met(agent: &Agent, number: usize, other: &Other) -> (DVec3, DVec3) {
    let laid = |vector: DVec3| vector - agent.upright * agent.upright.dot(vector);
    let away = other.position - agent.position;
    let reach = agent.radius + other.radius;
    let ahead = laid(away);
    let distance_squared = ahead.length_squared();
    // Above or below by more than both are wide.
    if away.length_squared() - distance_squared > reach * reach {
        return (DVec3::ZERO, DVec3::ZERO);
    }
    if distance_squared < reach * reach {
        let distance = distance_squared.sqrt();
        let at_one_place = || DQuat::from_axis_angle(agent.upright, GOLDEN_ANGLE * number as f64) * agent.heading;
        let direction = ahead.try_normalize().unwrap_or_else(at_one_place);
        return (DVec3::ZERO, -direction * (other.share * (reach - distance)));
    }
    let toward = laid(agent.velocity - other.velocity);
    let ahead = ahead + LEFT * reach * agent.upright.cross(agent.heading);
    let [a, b, c] = [toward.length_squared(), ahead.dot(toward), ahead.length_squared() - reach * reach];
    let discriminant = b * b - a * c;
    if b <= 0.0 || discriminant <= 0.0 {
        return (DVec3::ZERO, DVec3::ZERO);
    }
    let root = discriminant.sqrt();
    let time = (b - root) / a;
    // The gradient of the energy by the position, in radii for lengths.
    let strength = STRENGTH * agent.radius * agent.radius * (-time / FORESIGHT).exp() / (a * time * time);
    let gradient = toward - (b * toward - a * ahead) / root;
    (-strength * (2.0 / time + 1.0 / FORESIGHT) * gradient, DVec3::ZERO)
}
