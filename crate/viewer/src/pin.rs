use glam::Vec3;

use crate::buffer::Growing;
use crate::context::Context;
use crate::error::Error;
use crate::shared::{PipelineRecipe, Place, Shared, shader};
use crate::solid::{Detail, Solid, SolidBuffers};

/// Foot, direction, selected.
type Instance = [f32; 7];

const INSTANCE: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<Instance>() as u64,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![3 => Float32x3, 4 => Float32x3, 5 => Float32],
};

/// Shares of the pin's height.
const BALL_RADIUS: f32 = 0.2;
const NEEDLE_RADIUS: f32 = 0.035;
const NEEDLE: [f32; 2] = [0.0, 0.0];
const BALL: [f32; 2] = [1.0, 0.0];

/// Draws the sources.
pub(crate) struct Pins {
    pipeline: wgpu::RenderPipeline,
    shadow: wgpu::RenderPipeline,
    solid: SolidBuffers,
    buffer: Growing,
    instances: Vec<Instance>,
}

impl Pins {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Result<Self, Error> {
        let mut solid = Solid::new(Detail::FINE);
        // The tip starts below the surface, so that it never hovers over a coarse triangle.
        solid.turned(Vec3::NEG_Y * 0.08, Vec3::Y, &[(0.0, 0.3 * NEEDLE_RADIUS), (0.9, NEEDLE_RADIUS)], NEEDLE);
        solid.ball(Vec3::Y * (1.0 - BALL_RADIUS), Vec3::Y, BALL_RADIUS, BALL_RADIUS, BALL);
        let recipe = PipelineRecipe {
            label: "pin",
            layouts: &[Some(&shared.frame_layout), Some(&shared.light_layout)],
            module: &shader(context, "pin.wgsl", include_str!("pin.wgsl")),
            vertex: "vs_pin",
            fragment: "fs_pin",
            buffers: &[Some(SolidBuffers::LAYOUT), Some(INSTANCE)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Solid,
        };
        let casting = PipelineRecipe { layouts: &[Some(&shared.frame_layout)], ..recipe.clone() };
        Ok(Self {
            pipeline: recipe.build(context),
            shadow: casting.build_shadow(context),
            solid: solid.upload(context)?,
            buffer: Growing::new("pin instances"),
            instances: Vec::new(),
        })
    }

    /// Replaces the pins; one direction a foot point.
    pub(crate) fn set(&mut self, context: &Context, feet: &[Vec3], directions: &[Vec3], selected: Option<usize>) {
        self.instances.clear();
        self.instances.extend(feet.iter().zip(directions).enumerate().map(|(index, (foot, direction))| {
            let up = direction.try_normalize().unwrap_or(Vec3::Y);
            let emphasis = if selected == Some(index) { 1.0 } else { 0.0 };
            [foot.x, foot.y, foot.z, up.x, up.y, up.z, emphasis]
        }));
        self.buffer.write(context, bytemuck::cast_slice(&self.instances));
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(pass, &self.pipeline);
    }

    pub(crate) fn draw_shadow(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(pass, &self.shadow);
    }

    /// Whether there are any.
    pub(crate) fn is_empty(&self) -> bool {
        self.instances.is_empty()
    }

    fn draw_with(&self, pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline) {
        let Some(buffer) = self.buffer.get().filter(|_| !self.is_empty()) else { return };
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(1, buffer.slice(..));
        self.solid.draw(pass, self.instances.len() as u32);
    }
}
