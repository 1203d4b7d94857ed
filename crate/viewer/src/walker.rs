use std::f32::consts::TAU;

use glam::{Mat4, Vec3, Vec4};

use crate::context::Context;
use crate::error::Error;
use crate::pose::Track;
use crate::shared::{PipelineRecipe, Shared, shader, uniform, uniform_layout};
use crate::solid::{Solid, SolidBuffers};

/// The walker's height in bounding radii of the surface.
pub(crate) const HEIGHT: f32 = 0.105;
/// Length of a full cycle of two steps, in heights.
const STRIDE: f32 = 0.9;
/// Reach of the walker's shadow, in heights.
const SHADOW: f32 = 0.34;
/// Length over which the walker takes its heading, in heights to either side.
const HEADING: f32 = 0.35;
/// Greatest swing of the legs; radians. A leg of 0.36 heights then steps about half a stride.
const LEG_SWING: f32 = 0.65;
const ARM_SWING: f32 = 0.7;
/// Rise of the body in the middle of a step, in heights.
const BOB: f32 = 0.035;
const LEAN: f32 = -0.06;

// What a part hangs from, and its colour: the tags that walker.wgsl reads.
const TRUNK: f32 = 0.0;
const LEFT_LEG: f32 = 1.0;
const RIGHT_LEG: f32 = 2.0;
const LEFT_ARM: f32 = 3.0;
const RIGHT_ARM: f32 = 4.0;
const COAT: f32 = 0.0;
const SKIN: f32 = 1.0;
const CAP: f32 = 2.0;
const DARK: f32 = 3.0;

/// Vec4s in the uniform: the matrix and the gait.
const VECTORS: usize = 5;

/// Draws the figure that walks along the path.
pub(crate) struct Walker {
    pipeline: wgpu::RenderPipeline,
    solid: SolidBuffers,
    buffer: wgpu::Buffer,
    group: wgpu::BindGroup,
    /// The foot point while the walker is out.
    foot: Option<Vec3>,
}

impl Walker {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Result<Self, Error> {
        let layout = uniform_layout(context, "walker layout");
        let (buffer, group) = uniform(context, &layout, "walker uniform", VECTORS);
        let pipeline = PipelineRecipe {
            label: "walker",
            layouts: &[Some(&shared.layout), Some(&layout)],
            module: &shader(context, "walker.wgsl", include_str!("walker.wgsl")),
            vertex: "vs_walker",
            fragment: "fs_walker",
            buffers: &[Some(SolidBuffers::LAYOUT)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            depth: true,
        }
        .build(context);
        Ok(Self { pipeline, solid: figure().upload(context)?, buffer, group, foot: None })
    }

    /// Stands the walker at an arc length of the track; `radius` is the surface's bounding radius.
    pub(crate) fn stand(&mut self, context: &Context, track: &Track, arc: f32, radius: f32) {
        let height = HEIGHT * radius;
        let arc = arc.clamp(0.0, track.length());
        let pose = track.pose(arc, HEADING * height);
        let right = pose.normal.cross(pose.tangent);
        let matrix = Mat4::from_cols(
            (height * right).extend(0.0),
            (height * pose.normal).extend(0.0),
            (height * pose.tangent).extend(0.0),
            pose.position.extend(1.0),
        );
        let gait = gait(arc, track.length(), height);
        let vectors: [Vec4; VECTORS] = [matrix.x_axis, matrix.y_axis, matrix.z_axis, matrix.w_axis, gait];
        context.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&vectors));
        self.foot = Some(pose.position);
    }

    pub(crate) fn hide(&mut self) {
        self.foot = None;
    }

    /// Foot point and reach of the shadow while the walker is out.
    pub(crate) fn shadow(&self, radius: f32) -> Option<(Vec3, f32)> {
        self.foot.map(|foot| (foot, SHADOW * HEIGHT * radius))
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if self.foot.is_none() {
            return;
        }
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(1, &self.group, &[]);
        self.solid.draw(pass, 1);
    }
}

/// Leg swing, lift, arm swing and lean at an arc length. The walker starts and arrives with its feet together.
fn gait(arc: f32, length: f32, height: f32) -> Vec4 {
    let stride = STRIDE * height;
    let phase = TAU * arc / stride;
    let settled = (arc.min(length - arc) / (0.5 * stride)).clamp(0.0, 1.0);
    let (sin, lift) = (phase.sin(), BOB * phase.cos().powi(2));
    settled * Vec4::new(LEG_SWING * sin, lift, ARM_SWING * sin, LEAN)
}

/// The figure: one unit high, on its feet at the origin, facing +z.
fn figure() -> Solid {
    let mut solid = Solid::default();
    for (side, leg, arm) in [(1.0, LEFT_LEG, LEFT_ARM), (-1.0, RIGHT_LEG, RIGHT_ARM)] {
        let hip = Vec3::new(0.085 * side, 0.36, 0.0);
        let ankle = Vec3::new(0.085 * side, 0.07, 0.0);
        solid.limb((ankle, 0.055), (hip, 0.07), [leg, DARK]);
        solid.ball(Vec3::new(0.085 * side, 0.05, 0.045), Vec3::Z, 0.115, 0.06, [leg, DARK]);
        let shoulder = Vec3::new(0.15 * side, 0.60, 0.0);
        let wrist = Vec3::new(0.245 * side, 0.38, 0.0);
        solid.limb((wrist, 0.045), (shoulder, 0.058), [arm, COAT]);
        solid.ball(wrist + Vec3::new(0.012 * side, -0.03, 0.0), Vec3::Y, 0.05, 0.05, [arm, SKIN]);
        solid.ball(Vec3::new(0.062 * side, 0.80, 0.158), Vec3::Y, 0.032, 0.022, [TRUNK, DARK]);
    }
    // A coat that widens downwards, closed below.
    let coat = [
        (0.0, 0.001),
        (0.0, 0.14),
        (0.012, 0.190),
        (0.05, 0.198),
        (0.12, 0.182),
        (0.20, 0.160),
        (0.28, 0.142),
        (0.345, 0.122),
        (0.385, 0.085),
        (0.40, 0.001),
    ];
    solid.turned(Vec3::Y * 0.27, Vec3::Y, &coat, [TRUNK, COAT]);
    solid.ball(Vec3::Y * 0.79, Vec3::Y, 0.172, 0.180, [TRUNK, SKIN]);
    // A cap pulled over the back of the head, with a bobble.
    solid.ball(Vec3::new(0.0, 0.855, -0.028), Vec3::new(0.0, 1.0, -0.35), 0.135, 0.188, [TRUNK, CAP]);
    solid.ball(Vec3::new(0.0, 0.995, -0.085), Vec3::Y, 0.05, 0.05, [TRUNK, CAP]);
    solid
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_walker_starts_and_ends_with_its_feet_together() {
        assert_eq!(gait(0.0, 5.0, 0.1), Vec4::ZERO);
        assert_eq!(gait(5.0, 5.0, 0.1), Vec4::ZERO);
    }

    #[test]
    fn a_stride_returns_the_legs_to_where_they_were() {
        let height = 0.1;
        let (one, next) = (gait(1.0, 5.0, height), gait(1.0 + STRIDE * height, 5.0, height));
        // The phase is about seventy radians: eight digits less two.
        assert!((one - next).length() < 1e-4);
        assert!(
            (gait(1.0 + 0.5 * STRIDE * height, 5.0, height).x + one.x).abs() < 1e-4,
            "half a stride swaps the legs"
        );
    }
}
