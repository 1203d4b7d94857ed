//! How a figure walks: where its feet are, and the body between them. Lengths are in heights of the figure.
//!
//! Feet are planted at fixed places of the path and only move in the air, so they cannot slide.

use std::f32::consts::{PI, TAU};

use glam::{Vec3, Vec4};

use crate::pose::{CrowdPose, Pose, Track};

/// Length of a full cycle, a step with each foot, about.
pub(crate) const STRIDE: f32 = 0.66;
/// Share of the cycle that a foot is in the air.
const AIRBORNE: f32 = 0.4;
/// Height of the ankle over the ground, and of the hip over it when standing.
pub(crate) const ANKLE: f32 = 0.05;
pub(crate) const HIP: f32 = 0.42;
/// Length of thigh and shin together, a little less than they have, so that a knee is never quite straight.
const LEG: f32 = 0.39;
/// From the middle to a foot.
pub(crate) const SIDE: f32 = 0.075;
/// Greatest height of a step.
const STEP_HEIGHT: f32 = 0.075;
/// Greatest turn of a foot in the air, and of the arms; radians.
const FOOT_PITCH: f32 = 0.55;
const ARM_SWING: f32 = 0.6;
/// A path whose end is not in sight: far enough for a stride of usual length.
const FAR: f32 = 1e5;
/// Length over which heading and upright are taken, to either side.
const REACH: f32 = 0.35;

/// A foot of a walking figure.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Foot {
    /// Place along the path.
    arc: f32,
    lift: f32,
    /// Toes down, radians.
    pitch: f32,
    is_planted: bool,
}

/// Length of a full cycle on a path of a length: a whole number of steps lead to its end.
fn stride(length: f32) -> f32 {
    2.0 * length / (2.0 * length / STRIDE).round().max(1.0)
}

/// The foot whose plants are at `(k + offset)` strides, for the body at an arc of a path of a length.
fn foot(arc: f32, length: f32, offset: f32) -> Foot {
    let stride = stride(length);
    let planted = 0.5 * (1.0 - AIRBORNE);
    let plant = (arc / stride - offset + planted).floor();
    // The feet begin and end side by side.
    let [from, to] = [plant, plant + 1.0].map(|plant| ((plant + offset) * stride).clamp(0.0, length));
    let [leaves, lands] =
        [plant + planted, plant + 1.0 - planted].map(|at| ((at + offset) * stride).clamp(0.0, length));
    let flight = if lands > leaves { ((arc - leaves) / (lands - leaves)).clamp(0.0, 1.0) } else { 1.0 };
    let eased = flight * flight * (3.0 - 2.0 * flight);
    let share = (to - from) / stride;
    Foot {
        arc: from + (to - from) * eased,
        lift: STEP_HEIGHT * share * (PI * flight).sin(),
        pitch: FOOT_PITCH * share * (TAU * flight).sin(),
        is_planted: flight == 0.0 || flight == 1.0 || share == 0.0,
    }
}

/// A figure in the middle of its walk, as walker.wgsl reads it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct Figure {
    /// Foot point, world space, and height in world units.
    pub(crate) place: Vec4,
    /// Up, unit length, and how far the body is above where it stands.
    pub(crate) up: Vec4,
    /// Ahead, unit length, and swing of the left arm, radians.
    pub(crate) ahead: Vec4,
    /// Left and right ankle: to the left, up, ahead of the foot point, and pitch of the foot.
    pub(crate) left: Vec4,
    pub(crate) right: Vec4,
}

impl Figure {
    /// At an arc length of a track; `height` and `arc` in world units.
    pub(crate) fn on(track: &Track, arc: f32, height: f32) -> Self {
        let length = track.length() / height;
        let arc = arc.clamp(0.0, track.length());
        let reach = REACH * height;
        let pose = track.pose(arc, reach);
        let ankle = |offset: f32, side: f32| {
            let foot = foot(arc / height, length, offset);
            let stands = track.pose(foot.arc * height, reach);
            let ground = stands.position + side * SIDE * height * left_of(&stands) - pose.position;
            let local =
                Vec3::new(ground.dot(left_of(&pose)), ground.dot(pose.normal), ground.dot(pose.tangent)) / height;
            (local + Vec3::Y * (ANKLE + foot.lift), foot)
        };
        Self::between(&pose, height, arc / height, length, [ankle(0.0, 1.0), ankle(0.5, -1.0)])
    }

    /// One of the crowd, on ground that is flat as far as its feet go.
    pub(crate) fn in_crowd(&CrowdPose { position, normal, heading, arc }: &CrowdPose, height: f32) -> Self {
        let arc = arc / height;
        let ankle = |offset: f32, side: f32| {
            let foot = foot(arc, FAR, offset);
            (Vec3::new(side * SIDE, ANKLE + foot.lift, foot.arc - arc), foot)
        };
        Self::between(
            &Pose { position, normal, tangent: heading },
            height,
            arc,
            FAR,
            [ankle(0.0, 1.0), ankle(0.5, -1.0)],
        )
    }

    fn between(pose: &Pose, height: f32, arc: f32, length: f32, ankles: [(Vec3, Foot); 2]) -> Self {
        // A hip is no farther from a foot than the leg is long.
        let reach = |(ankle, _): &(Vec3, Foot)| ankle.y + (LEG * LEG - ankle.z * ankle.z).max(0.0).sqrt();
        let lift = ankles.iter().map(reach).fold(HIP, f32::min) - HIP;
        let stride = stride(length);
        let settled = (arc.min(length - arc) / (0.5 * stride)).clamp(0.0, 1.0);
        // The left arm goes with the right foot.
        let swing = -ARM_SWING * settled * (TAU * arc / stride).sin();
        let [left, right] = ankles.map(|(ankle, foot)| ankle.extend(foot.pitch));
        Self {
            place: pose.position.extend(height),
            up: pose.normal.extend(lift),
            ahead: pose.tangent.extend(swing),
            left,
            right,
        }
    }
}

fn left_of(pose: &Pose) -> Vec3 {
    pose.normal.cross(pose.tangent)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTH: f32 = 5.0;

    #[test]
    fn feet_begin_and_end_side_by_side() {
        for length in [0.1, 0.5, LENGTH, 5.1, 5.25, 5.4] {
            for offset in [0.0, 0.5] {
                assert_eq!(foot(0.0, length, offset).arc, 0.0);
                let end = foot(length, length, offset);
                assert!((end.arc - length).abs() < 1e-5 && end.lift.abs() < 1e-5, "{end:?}");
            }
        }
    }

    #[test]
    fn a_planted_foot_stays_where_it_is_and_one_is_always_planted() {
        let mut before: [Option<Foot>; 2] = [None; 2];
        let mut steps = 0;
        for index in 0..=5000 {
            let arc = LENGTH * index as f32 / 5000.0;
            let feet = [0.0, 0.5].map(|offset| foot(arc, LENGTH, offset));
            assert!(feet.iter().any(|foot| foot.is_planted), "at {arc}");
            for (foot, before) in feet.iter().zip(&mut before) {
                if let Some(before) = before.filter(|before| before.is_planted && foot.is_planted) {
                    // Places are products of small numbers: rounding.
                    assert!((foot.arc - before.arc).abs() < 1e-5, "at {arc}");
                    assert!(foot.lift.abs() < 1e-5);
                }
                steps += usize::from(before.is_some_and(|before| before.is_planted) && !foot.is_planted);
                *before = Some(*foot);
            }
        }
        assert_eq!(steps, 16, "one a half stride, and one to stand side by side");
    }

    #[test]
    fn planted_feet_stay_at_one_place_of_a_bent_track() {
        let bend: Vec<Vec3> =
            (0..=200).map(|i| 0.02 * i as f32).map(|s| Vec3::new(s.cos(), 0.1 * s, s.sin())).collect();
        let normals = bend.iter().map(|point| point.with_y(0.0)).collect();
        let track = Track::new(bend, normals).expect("a track");
        let height = 0.2;
        let mut before: Option<Vec3> = None;
        let mut compared = 0;
        for index in 0..=2000 {
            let arc = track.length() * index as f32 / 2000.0;
            let figure = Figure::on(&track, arc, height);
            let planted = foot(arc / height, track.length() / height, 0.0).is_planted;
            let [up, ahead] = [figure.up, figure.ahead].map(Vec4::truncate);
            let ankle = figure.left;
            let place = figure.place.truncate()
                + height * (ankle.x * up.cross(ahead) + (ankle.y - ANKLE) * up + ankle.z * ahead);
            if let Some(before) = before.filter(|_| planted) {
                assert!((place - before).length() < 1e-4 * height.recip(), "at {arc}");
                compared += 1;
            }
            before = planted.then_some(place);
        }
        assert!(compared > 900);
    }

    #[test]
    fn legs_reach_their_feet() {
        let line: Vec<Vec3> = (0..=50).map(|i| Vec3::X * (0.1 * i as f32)).collect();
        let track = Track::new(line, vec![Vec3::Y; 51]).expect("a track");
        for index in 0..=1000 {
            let figure = Figure::on(&track, track.length() * index as f32 / 1000.0, 1.0);
            for ankle in [figure.left, figure.right] {
                let hip = HIP + figure.up.w;
                assert!(Vec3::new(0.0, hip - ankle.y, ankle.z).length() < LEG + 1e-5, "{figure:?}");
            }
            assert!(figure.up.w > -0.1 && figure.up.w <= 0.0);
        }
    }
}
