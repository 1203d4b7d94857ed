//! Clips: what changes over time, by keyframes.

use glam::{DQuat, DVec3, DVec4};

use super::state::State;

/// A named animation.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Clip {
    /// Name in the file, or a made one.
    pub name: String,
    /// What it changes.
    pub channels: Vec<Channel>,
    /// How many channels of the file are left out: those that are damaged, or change something else than the shape.
    pub left_out: usize,
}

/// One property of a node over time.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Channel {
    /// The node, or that of the mesh whose morph targets are weighted.
    pub node: usize,
    /// What is changed, to which values.
    pub target: Target,
}

/// A property and its values.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Target {
    /// Of the node in its parent.
    Translation(Track<3>),
    /// Of the node, a quaternion (x, y, z, w).
    Rotation(Track<4>),
    /// Of the node, along each axis.
    Scale(Track<3>),
    /// Weights of the morph targets, one track each.
    Weights(Vec<Track<1>>),
}

/// How values between keyframes are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Interpolation {
    /// That of the keyframe before.
    Step,
    /// Linear; rotations along the shorter great arc.
    Linear,
    /// By cubic Hermite splines.
    CubicSpline,
}

/// Values of `N` numbers over time.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Track<const N: usize> {
    times: Vec<f32>,
    /// One a time; for cubic splines three: incoming tangent, value, outgoing tangent.
    #[cfg_attr(feature = "packed", serde(with = "heatwalk_base::packed::rows"))]
    values: Vec<[f32; N]>,
    interpolation: Interpolation,
}

impl Clip {
    /// Seconds from 0 to its last keyframe.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.channels.iter().map(|channel| channel.target.end()).fold(0.0, f64::max)
    }
}

impl Channel {
    pub(super) fn apply(&self, seconds: f64, state: &mut State) {
        let placement = &mut state.placements[self.node];
        match &self.target {
            Target::Translation(track) => *placement.parts().0 = DVec3::from(track.at(seconds, lerp)),
            Target::Scale(track) => *placement.parts().2 = DVec3::from(track.at(seconds, lerp)),
            Target::Rotation(track) => {
                let rotation = DVec4::from(track.at(seconds, slerp));
                *placement.parts().1 = DQuat::from_vec4(rotation.normalize_or(DVec4::W));
            }
            Target::Weights(tracks) => {
                let weights = tracks.iter().map(|track| track.at(seconds, lerp)[0]);
                state.weights[self.node] = Some(weights.collect());
            }
        }
    }
}

impl Target {
    fn end(&self) -> f64 {
        match self {
            Self::Translation(track) | Self::Scale(track) => track.end(),
            Self::Rotation(track) => track.end(),
            Self::Weights(tracks) => tracks.first().map_or(0.0, Track::end),
        }
    }
}

impl<const N: usize> Track<N> {
    /// Of keyframes at these times, in seconds, with one value each; for cubic splines with three: incoming tangent, value
    /// and outgoing tangent. None where the times do not increase from 0 or later, where there are none, where the numbers of
    /// values and times do not fit together, and where a number is not finite.
    #[must_use]
    pub fn new(times: Vec<f32>, values: Vec<[f32; N]>, interpolation: Interpolation) -> Option<Self> {
        let per_time = if interpolation == Interpolation::CubicSpline { 3 } else { 1 };
        let is_sound = times.first().is_some_and(|&first| first >= 0.0)
            && times.is_sorted_by(|before, after| before < after)
            && times.last().is_some_and(|last| last.is_finite())
            && values.len() == per_time * times.len()
            && values.iter().flatten().all(|value| value.is_finite());
        is_sound.then_some(Self { times, values, interpolation })
    }

    fn end(&self) -> f64 {
        self.times.last().map_or(0.0, |&last| last.into())
    }

    /// The value at a time: the first one before the first keyframe, the last one after the last. `between` interpolates two
    /// values linearly.
    fn at(&self, seconds: f64, between: impl Fn([f64; N], [f64; N], f64) -> [f64; N]) -> [f64; N] {
        let after = self.times.partition_point(|&time| f64::from(time) <= seconds);
        let (Some(before), Some(&next)) = (after.checked_sub(1), self.times.get(after)) else {
            return self.value(after.saturating_sub(1));
        };
        let (start, step) = (f64::from(self.times[before]), f64::from(next) - f64::from(self.times[before]));
        let share = (seconds - start) / step;
        match self.interpolation {
            Interpolation::Step => self.value(before),
            Interpolation::Linear => between(self.value(before), self.value(after), share),
            Interpolation::CubicSpline => self.spline(before, step, share),
        }
    }

    /// The value of a keyframe.
    fn value(&self, keyframe: usize) -> [f64; N] {
        let index = if self.interpolation == Interpolation::CubicSpline { 3 * keyframe + 1 } else { keyframe };
        self.values[index].map(f64::from)
    }

    /// glTF 2.0, appendix C.5: tangents are in units a second.
    fn spline(&self, before: usize, step: f64, t: f64) -> [f64; N] {
        let leaving = self.values[3 * before + 2].map(f64::from);
        let entering = self.values[3 * (before + 1)].map(f64::from);
        let (start, end) = (self.value(before), self.value(before + 1));
        let (t2, t3) = (t * t, t * t * t);
        let weights = [2.0 * t3 - 3.0 * t2 + 1.0, step * (t3 - 2.0 * t2 + t), 3.0 * t2 - 2.0 * t3, step * (t3 - t2)];
        std::array::from_fn(|k| {
            weights[0] * start[k] + weights[1] * leaving[k] + weights[2] * end[k] + weights[3] * entering[k]
        })
    }
}

fn lerp<const N: usize>(start: [f64; N], end: [f64; N], share: f64) -> [f64; N] {
    std::array::from_fn(|k| start[k] + share * (end[k] - start[k]))
}

fn slerp(start: [f64; 4], end: [f64; 4], share: f64) -> [f64; 4] {
    let [start, end] = [start, end].map(|rotation| DQuat::from_vec4(DVec4::from(rotation).normalize_or(DVec4::W)));
    start.slerp(end, share).to_array()
}
