use encase::ShaderType;
use glam::Vec3;

use crate::binding::{FILTERED_TEXTURE, fragment_entry, sampled_group, uniform_entry, written_texture};
use crate::context::Context;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shadow::SHADOW_REACH;
use crate::shared::Shared;
use crate::uniform::Uniform;
use heatwalk_bake::{CONTACT_SIZE, Floor};

/// `Ground` of ground.wgsl.
#[derive(ShaderType)]
struct GroundUniform {
    center: Vec3,
    reach: f32,
    key_share: f32,
    shadow_reach: f32,
}

/// The shadow that the scene casts on the floor below it.
pub(crate) struct Ground {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    uniform: Uniform<GroundUniform>,
    contact: wgpu::Texture,
    floor: Option<Floor>,
}

impl Ground {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let layout = context.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("ground layout"),
            entries: &[
                uniform_entry(0),
                fragment_entry(1, FILTERED_TEXTURE),
                fragment_entry(2, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)),
            ],
        });
        let uniform: Uniform<GroundUniform> = Uniform::new(context, "ground uniform");
        let size = CONTACT_SIZE as u32;
        let contact = written_texture(context, "contact", [size, size], wgpu::TextureFormat::R8Unorm);
        let group = sampled_group(context, "ground", &layout, &uniform.buffer, &contact);
        let pipeline = PipelineRecipe {
            label: "ground",
            layouts: &[Some(&shared.frame_layout), Some(&shared.lighting.layout), Some(&layout)],
            module: &shader_module!(context, "ground"),
            vertex: "vs_ground",
            fragment: "fs_ground",
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            place: Place::Over,
        }
        .build(context);
        Self { pipeline, group, uniform, contact, floor: None }
    }

    /// Lays the floor; `contact` is that of a [`Shade`](heatwalk_bake::Shade).
    pub(crate) fn set(&mut self, context: &Context, floor: Floor, contact: &[u8]) {
        self.floor = Some(floor);
        let row = Some(CONTACT_SIZE as u32);
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: row, rows_per_image: None };
        context.queue.write_texture(self.contact.as_image_copy(), contact, layout, self.contact.size());
    }

    /// Takes the floor away.
    pub(crate) fn clear(&mut self) {
        self.floor = None;
    }

    /// Tells the key light's share of the light on the floor.
    pub(crate) fn set_light(&self, context: &Context, key_share: f32) {
        let Some(Floor { center, reach }) = self.floor else { return };
        self.uniform.write(context, &GroundUniform { center, reach, key_share, shadow_reach: SHADOW_REACH });
    }

    /// Seen from below the floor is not there.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, eye_height: f32) {
        if self.floor.is_none_or(|floor| eye_height <= floor.center.y) {
            return;
        }
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &self.group, &[]);
        pass.draw(0..4, 0..1);
    }
}
