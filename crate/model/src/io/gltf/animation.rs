//! Animations. A channel that cannot be read is left out: the mesh is right without.

use gltf::json::Root;
use gltf::json::animation::{Animation, Interpolation as Named, Property, Sampler};
use gltf::json::validation::Checked;

use super::accessor::{Accessors, number};
use crate::motion::{Channel, Clip, Interpolation, Target, Track};

/// The clips of a file, with those channels that can be read.
pub fn clips(root: &Root, accessors: Accessors) -> Vec<Clip> {
    let clip = |(number, animation): (usize, &Animation)| {
        let name = animation.name.clone().filter(|name| !name.is_empty());
        let channels = animation.channels.iter().filter_map(|channel| {
            let node = channel.target.node.value();
            let sampler = animation.samplers.get(channel.sampler.value())?;
            let Checked::Valid(property) = channel.target.path else { return None };
            let target = Keyframes::read(accessors, sampler)?.of(property)?;
            (node < root.nodes.len()).then_some(Channel { node, target })
        });
        let channels: Vec<Channel> = channels.collect();
        let left_out = animation.channels.len() - channels.len();
        Clip { name: name.unwrap_or_else(|| format!("animation {number}")), channels, left_out }
    };
    root.animations.iter().enumerate().map(clip).collect()
}

/// What a sampler says.
struct Keyframes<'a> {
    accessors: Accessors<'a>,
    times: Vec<f32>,
    output: u32,
    interpolation: Interpolation,
}

impl<'a> Keyframes<'a> {
    fn read(accessors: Accessors<'a>, sampler: &Sampler) -> Option<Self> {
        let interpolation = match sampler.interpolation {
            Checked::Valid(Named::Step) => Interpolation::Step,
            Checked::Valid(Named::Linear) => Interpolation::Linear,
            Checked::Valid(Named::CubicSpline) => Interpolation::CubicSpline,
            Checked::Invalid => return None,
        };
        let times = accessors.numbers(number(sampler.input)).ok()?;
        let times = times.into_iter().map(|time| time as f32).collect();
        Some(Self { accessors, times, output: number(sampler.output), interpolation })
    }

    fn of(self, property: Property) -> Option<Target> {
        let Self { accessors, output, .. } = self;
        Some(match property {
            Property::Translation => Target::Translation(self.track(vectors(accessors, output)?)?),
            Property::Scale => Target::Scale(self.track(vectors(accessors, output)?)?),
            Property::Rotation => {
                let rotations = accessors.rotations(output).ok()?;
                Target::Rotation(self.track(rotations.into_iter().map(|numbers| numbers.map(|x| x as f32)).collect())?)
            }
            Property::MorphTargetWeights => Target::Weights(self.weights(&accessors.numbers(output).ok()?)?),
        })
    }

    fn track<const N: usize>(self, values: Vec<[f32; N]>) -> Option<Track<N>> {
        Track::new(self.times, values, self.interpolation)
    }

    /// One track a morph target. All weights of a keyframe are together; of cubic splines, all incoming tangents, all weights, all
    /// outgoing tangents.
    fn weights(self, values: &[f64]) -> Option<Vec<Track<1>>> {
        let rows = self.times.len() * if self.interpolation == Interpolation::CubicSpline { 3 } else { 1 };
        let targets = values.len().checked_div(rows).filter(|targets| targets * rows == values.len())?;
        let track = |target: usize| {
            let values = (0..rows).map(|row| [values[row * targets + target] as f32]).collect();
            Track::new(self.times.clone(), values, self.interpolation)
        };
        (0..targets).map(track).collect()
    }
}

fn vectors(accessors: Accessors, output: u32) -> Option<Vec<[f32; 3]>> {
    let vectors = accessors.vectors(output).ok()?;
    Some(vectors.into_iter().map(|vector| vector.as_vec3().to_array()).collect())
}
