use encase::ShaderType;
use glam::{Mat4, Vec2, Vec3, Vec4};

use crate::binding::uniform_layout;
use crate::camera::Eye;
use crate::context::Context;
use crate::environment::{Environment, LIGHT_COUNT, Light};
use crate::lighting::Lighting;
use crate::planes::Cut;
use crate::punctual::{self, MOST_PUNCTUAL, PunctualLight, dimmed};
use crate::shadow::ShadowView;
use crate::uniform::Uniform;
use heatwalk_bake::Cube;

/// What all primitives of one frame have in common.
pub(crate) struct Frame<'a> {
    pub(crate) eye: Eye,
    /// Bounding radius of the surface; world units.
    pub(crate) radius: f32,
    pub(crate) pixel_ratio: f32,
    pub(crate) shadows: ShadowView,
    /// Least and greatest x and y, in the maps' clip space, of shadows of what moves; least above greatest for none.
    pub(crate) moving: [Vec2; 2],
    /// Of the occlusion grid.
    pub(crate) cube: Cube,
    pub(crate) environment: Environment,
    /// Of the file; where there are some, those of the environment are out.
    pub(crate) punctual: &'a [PunctualLight],
    pub(crate) cut: Cut,
    /// Whether a section closes the cut.
    pub(crate) is_capped: bool,
}

/// `Frame` of shared.wgsl.
#[derive(ShaderType)]
struct FrameUniform {
    clip_from_world: Mat4,
    shadow_from_world: Mat4,
    back: Vec3,
    pixel_slope: f32,
    eye: Vec3,
    radius: f32,
    occlusion_low: Vec3,
    occlusion_side: f32,
    moving_low: Vec2,
    moving_high: Vec2,
    zenith: Vec3,
    pixel_ratio: f32,
    horizon: Vec3,
    shadow_texel: f32,
    nadir: Vec3,
    punctual_count: i32,
    lights: [Light; LIGHT_COUNT],
    punctual: [PunctualLight; MOST_PUNCTUAL],
    cut: [Vec4; 2],
    is_capped: f32,
}

impl Frame<'_> {
    fn uniform(&self, clip_from_world: Mat4) -> FrameUniform {
        let [moving_low, moving_high] = self.moving;
        let (colors, lights) = (self.environment.colors(), self.environment.lights());
        let is_lit_by_file = !self.punctual.is_empty();
        let [zenith, horizon, nadir] = if is_lit_by_file { dimmed(colors) } else { colors };
        FrameUniform {
            clip_from_world,
            shadow_from_world: self.shadows.clip_from_world,
            back: self.eye.world_from_view.z_axis.as_vec3(),
            pixel_slope: self.eye.pixel_slope as f32,
            eye: self.eye.position.as_vec3(),
            radius: self.radius,
            occlusion_low: self.cube.low,
            occlusion_side: self.cube.side,
            moving_low,
            moving_high,
            zenith,
            pixel_ratio: self.pixel_ratio,
            horizon,
            shadow_texel: self.shadows.texel,
            nadir,
            punctual_count: self.punctual.len().min(MOST_PUNCTUAL) as i32,
            lights: if is_lit_by_file { lights.map(Light::out) } else { lights },
            punctual: punctual::drawn(self.punctual),
            cut: self.cut.uniform(),
            is_capped: f32::from(u8::from(self.is_capped)),
        }
    }
}

/// What all pipelines share: the frame's uniform as the camera sees it and as the key light does (group 0), and what keeps
/// light off (group 1).
pub(crate) struct Shared {
    pub(crate) frame_layout: wgpu::BindGroupLayout,
    pub(crate) camera_group: wgpu::BindGroup,
    pub(crate) shadow_group: wgpu::BindGroup,
    pub(crate) lighting: Lighting,
    camera: Uniform<FrameUniform>,
    shadow: Uniform<FrameUniform>,
}

impl Shared {
    pub(crate) fn new(context: &Context) -> Self {
        let frame_layout = uniform_layout(context, "frame layout");
        let [camera, shadow] = ["frame uniform", "shadow uniform"].map(|label| Uniform::new(context, label));
        Self {
            camera_group: camera.group(context, &frame_layout, "frame"),
            shadow_group: shadow.group(context, &frame_layout, "shadow frame"),
            lighting: Lighting::new(context),
            frame_layout,
            camera,
            shadow,
        }
    }

    pub(crate) fn write(&self, context: &Context, frame: &Frame) {
        self.camera.write(context, &frame.uniform(frame.eye.clip_from_world.as_mat4()));
        self.shadow.write(context, &frame.uniform(frame.shadows.clip_from_world));
    }
}
