use glam::Vec3;

use crate::buffer::Instances;
use crate::context::Context;
use crate::error::Error;
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::solid::{Detail, Solid, SolidBuffers, SolidPipelines};
use crate::vertex::vertex_layout;
use heatwalk_bake::Ray;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Pin {
    /// World space.
    foot: Vec3,
    /// Unit length.
    up: Vec3,
    /// 1 for the selected one, else 0.
    selected: f32,
}

const PIN: wgpu::VertexBufferLayout<'static> = vertex_layout!(Pin, per Instance: 3 => foot, 4 => up, 5 => selected);

/// Shares of the pin's height.
const BALL_RADIUS: f32 = 0.2;
const NEEDLE_RADIUS: f32 = 0.035;
/// Greatest height of a pin, in bounding radii; see pin.wgsl.
const TALLEST: f32 = 0.2;
/// As pin.wgsl has them: height in bounding radii, CSS pixels at most, and the factor for the selected one.
const SIZE: f32 = 0.15;
const MAX_PIXELS: f32 = 76.0;
const SELECTED: f32 = 1.22;
const NEEDLE: [f32; 2] = [0.0, 0.0];
const BALL: [f32; 2] = [1.0, 0.0];

/// Draws the sources.
pub(crate) struct Pins {
    pipelines: SolidPipelines,
    solid: SolidBuffers,
    instances: Instances<Pin>,
}

impl Pins {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Result<Self, Error> {
        let mut solid = Solid::new(Detail::FINE);
        // The tip starts below the surface, so that it never hovers over a coarse triangle.
        solid.turned(Vec3::NEG_Y * 0.08, Vec3::Y, &[(0.0, 0.3 * NEEDLE_RADIUS), (0.9, NEEDLE_RADIUS)], NEEDLE);
        solid.ball(Vec3::Y * (1.0 - BALL_RADIUS), Vec3::Y, BALL_RADIUS, BALL_RADIUS, BALL);
        let module = shader_module!(context, "pin");
        let names = ["pin", "vs_pin", "fs_pin"];
        Ok(Self {
            pipelines: SolidPipelines::new(context, shared, &module, names, PIN),
            solid: solid.upload(context)?,
            instances: Instances::new("pins"),
        })
    }

    /// Replaces the pins; one direction a foot point.
    pub(crate) fn set(&mut self, context: &Context, feet: &[Vec3], directions: &[Vec3], selected: Option<usize>) {
        let pins = feet.iter().zip(directions).enumerate().map(|(index, (&foot, direction))| Pin {
            foot,
            up: direction.try_normalize().unwrap_or(Vec3::Y),
            selected: if selected == Some(index) { 1.0 } else { 0.0 },
        });
        self.instances.set(context, pins);
    }

    /// The pin whose ball a ray meets first, and how far along the ray; `slack` makes balls so much larger. `radius` is the surface's
    /// bounding radius; `pixel` says how large a CSS pixel is at a place.
    pub(crate) fn cast(&self, ray: Ray, slack: f32, radius: f32, pixel: impl Fn(Vec3) -> f32) -> Option<(usize, f32)> {
        let depths = self.instances.items().iter().enumerate().filter_map(|(index, pin)| {
            let pixel = pixel(pin.foot);
            let size = (SIZE * radius).min(MAX_PIXELS * pixel) * if pin.selected > 0.0 { SELECTED } else { 1.0 };
            let ball = pin.foot + (1.0 - BALL_RADIUS) * size * pin.up - ray.origin;
            let depth = ball.dot(ray.direction);
            let is_met = ball.length_squared() - depth * depth < (BALL_RADIUS * size + slack * pixel).powi(2);
            (depth > 0.0 && is_met).then_some((index, depth))
        });
        depths.min_by(|one, other| one.1.total_cmp(&other.1))
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(pass, &self.pipelines.drawn);
    }

    pub(crate) fn draw_shadow(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(pass, &self.pipelines.shadow);
    }

    /// Around each pin; `radius` is the surface's bounding radius.
    pub(crate) fn balls(&self, radius: f32) -> impl Iterator<Item = (Vec3, f32)> + '_ {
        self.instances.items().iter().map(move |pin| (pin.foot, TALLEST * radius))
    }

    /// Whether there are any.
    pub(crate) fn is_empty(&self) -> bool {
        self.instances.is_empty()
    }

    fn draw_with(&self, pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline) {
        let Some(count) = self.instances.bind(pass, 1) else { return };
        pass.set_pipeline(pipeline);
        self.solid.draw(pass, count);
    }
}
