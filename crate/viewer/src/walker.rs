use glam::Vec3;

use crate::buffer::Instances;
use crate::context::Context;
use crate::error::Error;
use crate::gait::{ANKLE, Figure};
use crate::pose::{CrowdPose, Track};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::solid::{Detail, Solid, SolidBuffers, SolidPipelines};
use crate::vertex::vertex_layout;

/// The walker's height in bounding radii of the surface.
pub(crate) const HEIGHT: f32 = 0.105;

// What a part hangs from, and its colour: the tags that walker.wgsl reads.
const TRUNK: f32 = 0.0;
const THIGH: f32 = 1.0;
const SHIN: f32 = 2.0;
const FOOT: f32 = 3.0;
const ARM: f32 = 4.0;
const FOREARM: f32 = 5.0;
/// Added to the tags of the right side.
const RIGHT: f32 = 5.0;
const COAT: f32 = 0.0;
const SKIN: f32 = 1.0;
const CAP: f32 = 2.0;
const DARK: f32 = 3.0;

const FIGURE: wgpu::VertexBufferLayout<'static> =
    vertex_layout!(Figure, per Instance: 3 => place, 4 => up, 5 => ahead, 6 => left, 7 => right);

/// Draws the figure that walks along the path, and the crowd.
pub(crate) struct Walkers {
    pipelines: SolidPipelines,
    walker: Group,
    crowd: Group,
}

/// Figures of one shape.
struct Group {
    solid: SolidBuffers,
    figures: Instances<Figure>,
}

impl Group {
    fn new(context: &Context, detail: Detail) -> Result<Self, Error> {
        Ok(Self { solid: figure(detail).upload(context)?, figures: Instances::new("figures") })
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline) {
        let Some(count) = self.figures.bind(pass, 1) else { return };
        pass.set_pipeline(pipeline);
        self.solid.draw(pass, count);
    }
}

impl Walkers {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Result<Self, Error> {
        let module = shader_module!(context, "walker");
        let names = ["walker", "vs_walker", "fs_walker"];
        Ok(Self {
            pipelines: SolidPipelines::new(context, shared, &module, names, FIGURE),
            walker: Group::new(context, Detail::FINE)?,
            crowd: Group::new(context, Detail::COARSE)?,
        })
    }

    /// Stands the walker at an arc length of the track; `radius` is the surface's bounding radius.
    pub(crate) fn stand(&mut self, context: &Context, track: &Track, arc: f32, radius: f32) {
        self.walker.figures.set(context, [Figure::on(track, arc, HEIGHT * radius)]);
    }

    pub(crate) fn hide(&mut self) {
        self.walker.figures.clear();
    }

    /// Takes walker and crowd away.
    pub(crate) fn clear(&mut self) {
        self.walker.figures.clear();
        self.crowd.figures.clear();
    }

    /// Replaces the crowd, each `height` high.
    pub(crate) fn set_crowd(&mut self, context: &Context, poses: &[CrowdPose], height: f32) {
        self.crowd.figures.set(context, poses.iter().map(|pose| Figure::in_crowd(pose, height)));
    }

    /// Around each figure.
    pub(crate) fn balls(&self) -> impl Iterator<Item = (Vec3, f32)> + '_ {
        let groups = [&self.walker, &self.crowd].into_iter();
        groups.flat_map(|group| group.figures.items()).map(|figure| (figure.place.truncate(), figure.place.w))
    }

    /// Whether anybody is there.
    pub(crate) fn are_out(&self) -> bool {
        !(self.walker.figures.is_empty() && self.crowd.figures.is_empty())
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.walker.draw(pass, &self.pipelines.drawn);
        self.crowd.draw(pass, &self.pipelines.drawn);
    }

    pub(crate) fn draw_shadow(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.walker.draw(pass, &self.pipelines.shadow);
        self.crowd.draw(pass, &self.pipelines.shadow);
    }
}

/// The figure: one unit high, on its feet at the origin, facing +z, its left at +x. Thighs, shins and feet hang from the
/// origin along −y (feet point along +z): the shader puts them where the joints are.
fn figure(detail: Detail) -> Solid {
    let mut solid = Solid::new(detail);
    for (side, tag) in [(1.0, 0.0), (-1.0, RIGHT)] {
        solid.limb((Vec3::ZERO, 0.068), (Vec3::NEG_Y * 0.2, 0.05), [THIGH + tag, DARK]);
        solid.limb((Vec3::ZERO, 0.05), (Vec3::NEG_Y * 0.2, 0.04), [SHIN + tag, DARK]);
        solid.ball(Vec3::new(0.0, 0.005 - 0.5 * ANKLE, 0.035), Vec3::Z, 0.095, 0.045, [FOOT + tag, DARK]);
        let shoulder = Vec3::new(0.135 * side, 0.655, 0.0);
        let elbow = Vec3::new(0.185 * side, 0.525, 0.0);
        let wrist = Vec3::new(0.205 * side, 0.405, 0.01);
        solid.limb((elbow, 0.045), (shoulder, 0.056), [ARM + tag, COAT]);
        solid.limb((wrist, 0.037), (elbow, 0.045), [FOREARM + tag, COAT]);
        solid.ball(wrist - Vec3::Y * 0.03, Vec3::Y, 0.045, 0.042, [FOREARM + tag, SKIN]);
        solid.ball(Vec3::new(0.055 * side, 0.84, 0.138), Vec3::Y, 0.028, 0.019, [TRUNK, DARK]);
    }
    // A coat that widens downwards, closed below.
    let coat = [
        (0.0, 0.001),
        (0.0, 0.11),
        (0.012, 0.158),
        (0.05, 0.166),
        (0.11, 0.156),
        (0.18, 0.142),
        (0.26, 0.130),
        (0.32, 0.112),
        (0.355, 0.075),
        (0.37, 0.001),
    ];
    solid.turned(Vec3::Y * 0.345, Vec3::Y, &coat, [TRUNK, COAT]);
    solid.ball(Vec3::Y * 0.83, Vec3::Y, 0.148, 0.155, [TRUNK, SKIN]);
    // A cap pulled over the back of the head, with a bobble.
    solid.ball(Vec3::new(0.0, 0.885, -0.024), Vec3::new(0.0, 1.0, -0.35), 0.115, 0.162, [TRUNK, CAP]);
    solid.ball(Vec3::new(0.0, 1.0, -0.073), Vec3::Y, 0.043, 0.043, [TRUNK, CAP]);
    solid
}
