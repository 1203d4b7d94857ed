//! Joints of the robot, and how they move.

use std::ops::Range;

use glam::{DQuat, DVec3, EulerRot};
use heatwalk_model::Motion;
use heatwalk_model::motion::{
    Channel, Clip, Deformer, Influences, Interpolation, Node, NodeTree, Placement, Target, Track,
};

/// What parts are fixed to.
#[derive(Clone, Copy, PartialEq)]
pub enum Joint {
    Body,
    Head,
    /// Of the left side or the right one.
    Limb(Limb, bool),
}

#[derive(Clone, Copy, PartialEq)]
pub enum Limb {
    Arm,
    Forearm,
    Thigh,
    Shin,
    Foot,
}

const LIMBS: [Limb; 5] = [Limb::Arm, Limb::Forearm, Limb::Thigh, Limb::Shin, Limb::Foot];

impl Joint {
    fn all() -> impl Iterator<Item = Self> {
        let limbs = [true, false].into_iter().flat_map(|is_left| LIMBS.map(|limb| Self::Limb(limb, is_left)));
        [Self::Body, Self::Head].into_iter().chain(limbs)
    }

    /// Its place among all of them.
    fn index(self) -> usize {
        match self {
            Self::Body => 0,
            Self::Head => 1,
            Self::Limb(limb, is_left) => 2 + limb as usize + if is_left { 0 } else { LIMBS.len() },
        }
    }

    /// Where it is while nothing moves.
    pub fn place(self) -> DVec3 {
        let of_left = match self {
            Self::Body => DVec3::ZERO,
            Self::Head => DVec3::new(0.0, 1.64, 0.0),
            Self::Limb(Limb::Arm, _) => DVec3::new(0.50, 1.43, 0.0),
            Self::Limb(Limb::Forearm, _) => DVec3::new(0.66, 1.06, 0.04),
            Self::Limb(Limb::Thigh, _) => DVec3::new(0.19, 0.78, 0.0),
            Self::Limb(Limb::Shin, _) => DVec3::new(0.22, 0.45, 0.04),
            Self::Limb(Limb::Foot, _) => DVec3::new(0.24, 0.12, 0.0),
        };
        if matches!(self, Self::Limb(_, false)) { of_left * DVec3::new(-1.0, 1.0, 1.0) } else { of_left }
    }

    /// None for those that stand on the ground.
    fn parent(self) -> Option<Self> {
        match self {
            Self::Body | Self::Limb(Limb::Thigh, _) => None,
            Self::Head | Self::Limb(Limb::Arm, _) => Some(Self::Body),
            Self::Limb(Limb::Forearm, is_left) => Some(Self::Limb(Limb::Arm, is_left)),
            Self::Limb(Limb::Shin, is_left) => Some(Self::Limb(Limb::Thigh, is_left)),
            Self::Limb(Limb::Foot, is_left) => Some(Self::Limb(Limb::Shin, is_left)),
        }
    }

    fn in_parent(self) -> DVec3 {
        self.place() - self.parent().map_or(DVec3::ZERO, Self::place)
    }
}

/// The motion of parts, each of consecutive vertices, that are fixed to joints.
pub fn joint_motion(positions: &[DVec3], fixed: Vec<(Joint, Range<usize>)>) -> Motion {
    let node = |joint: Joint| Node {
        parent: joint.parent().map(Joint::index),
        placement: Placement::Parts { translation: joint.in_parent(), rotation: DQuat::IDENTITY, scale: DVec3::ONE },
    };
    let hierarchy = NodeTree::new(Joint::all().map(node).collect()).expect("joints form trees");
    let deformer = |(joint, vertices): (Joint, Range<usize>)| Deformer {
        node: joint.index(),
        skin: None,
        positions: positions[vertices.clone()].iter().map(|place| place - joint.place()).collect(),
        normals: Vec::new(),
        influences: Influences::default(),
        targets: Vec::new(),
        weights: Vec::new(),
        vertices,
    };
    let deformers = fixed.into_iter().map(deformer).collect();
    Motion::new(hierarchy, Vec::new(), deformers, vec![wave(), walk()]).expect("joints that there are")
}

/// Turns of a joint about x, y and z in degrees, at even steps of time.
fn turns(joint: Joint, seconds: f32, degrees: &[[f64; 3]]) -> Channel {
    let turn = |[x, y, z]: [f64; 3]| {
        DQuat::from_euler(EulerRot::ZYX, z.to_radians(), y.to_radians(), x.to_radians()).as_quat().to_array()
    };
    let values = degrees.iter().map(|&angles| turn(angles)).collect();
    let track = Track::new(times(seconds, degrees.len()), values, Interpolation::Linear);
    Channel { node: joint.index(), target: Target::Rotation(track.expect("a value for each time")) }
}

fn times(seconds: f32, count: usize) -> Vec<f32> {
    (0..count).map(|step| seconds * step as f32 / (count - 1) as f32).collect()
}

/// The right arm is raised and waves; the head follows it.
fn wave() -> Clip {
    const SECONDS: f32 = 2.4;
    let right = |limb: Limb| Joint::Limb(limb, false);
    let channels = vec![
        turns(
            right(Limb::Arm),
            SECONDS,
            &[0.0, -70.0, -105.0, -110.0, -105.0, -110.0, -105.0, -70.0, 0.0].map(|z| [0.0, 0.0, z]),
        ),
        turns(
            right(Limb::Forearm),
            SECONDS,
            &[0.0, -40.0, -95.0, -50.0, -95.0, -50.0, -95.0, -40.0, 0.0].map(|z| [0.0, 0.0, z]),
        ),
        turns(
            Joint::Head,
            SECONDS,
            &[0.0, 0.6, 1.0, 0.9, 1.0, 0.9, 1.0, 0.6, 0.0].map(|share| [0.0, -22.0 * share, 7.0 * share]),
        ),
        turns(Joint::Limb(Limb::Arm, true), SECONDS, &[0.0, 6.0, 0.0].map(|z| [0.0, 0.0, z])),
    ];
    Clip { name: "Wave".to_owned(), channels, left_out: 0 }
}

/// One step of each leg, on the spot.
fn walk() -> Clip {
    const SECONDS: f32 = 1.2;
    // From the heel that touches the ground to the next time that it does.
    const THIGH: [f64; 4] = [-24.0, 0.0, 22.0, 2.0];
    const SHIN: [f64; 4] = [4.0, 6.0, 14.0, 52.0];
    const FOOT: [f64; 4] = [14.0, -4.0, -22.0, -24.0];
    const ARM: [f64; 4] = [20.0, 0.0, -22.0, 0.0];
    let mut channels = Vec::new();
    for is_left in [true, false] {
        let begin = if is_left { 0 } else { 2 };
        let phases = |angles: [f64; 4]| [0, 1, 2, 3, 4].map(|phase| [angles[(phase + begin) % 4], 0.0, 0.0]);
        for (limb, angles) in [
            (Limb::Thigh, THIGH),
            (Limb::Shin, SHIN),
            (Limb::Foot, FOOT),
            (Limb::Arm, ARM),
            (Limb::Forearm, [-18.0, -10.0, -24.0, -14.0]),
        ] {
            channels.push(turns(Joint::Limb(limb, is_left), SECONDS, &phases(angles)));
        }
    }
    channels.push(turns(Joint::Head, SECONDS, &[5.0, 0.0, -5.0, 0.0, 5.0].map(|y| [0.0, y, 0.0])));
    let lift = [0.0, 0.022, 0.0, 0.022, 0.0].map(|y| [0.0, y, 0.0]);
    let track = Track::new(times(SECONDS, lift.len()), lift.to_vec(), Interpolation::Linear);
    let target = Target::Translation(track.expect("a value for each time"));
    channels.push(Channel { node: Joint::Body.index(), target });
    Clip { name: "Walk".to_owned(), channels, left_out: 0 }
}
