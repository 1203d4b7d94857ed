//! Records what a submission plays.

use std::cell::RefCell;
use std::ops::Range;
use std::rc::Rc;

use wgpu::custom::{
    CommandBufferInterface, CommandEncoderInterface, DispatchBindGroup, DispatchBuffer, DispatchCommandBuffer,
    DispatchComputePass, DispatchQuerySet, DispatchRenderBundle, DispatchRenderPass, DispatchRenderPipeline,
    DispatchTexture, RenderPassInterface,
};

use crate::program::Pipeline;
use crate::resource::{BindGroup, Buffer, OWN, Texture, TextureView};

#[derive(Debug)]
pub(crate) enum Command {
    Begin(Attachments),
    End,
    Pipeline(Pipeline),
    Group(usize, BindGroup),
    Vertices(usize, Buffer, u64),
    Indices(Buffer, wgpu::IndexFormat, u64),
    /// Left, top, width, height.
    Scissor([i32; 4]),
    Draw(Range<u32>, u32),
    DrawIndexed(Range<u32>, u32),
    Read(Texture, Buffer, u32),
}

/// What a pass draws into, and what becomes of that.
#[derive(Debug)]
pub(crate) struct Attachments {
    pub(crate) color: Option<TextureView>,
    pub(crate) resolved: Option<TextureView>,
    pub(crate) clear_color: Option<[f32; 4]>,
    pub(crate) is_color_kept: bool,
    pub(crate) depth: Option<TextureView>,
    pub(crate) clear_depth: Option<f32>,
    pub(crate) is_depth_kept: bool,
}

impl Attachments {
    fn new(descriptor: &wgpu::RenderPassDescriptor<'_>) -> Self {
        let own = |view: &wgpu::TextureView| view.as_custom::<TextureView>().expect(OWN).clone();
        assert!(descriptor.color_attachments.len() <= 1, "a pass draws into one picture");
        let color = descriptor.color_attachments.first().and_then(Option::as_ref);
        let depth = descriptor.depth_stencil_attachment.as_ref();
        let depth_ops = depth.and_then(|attachment| attachment.depth_ops);
        Self {
            color: color.map(|attachment| own(attachment.view)),
            resolved: color.and_then(|attachment| attachment.resolve_target).map(own),
            clear_color: color.and_then(|attachment| match attachment.ops.load {
                wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }) => Some([r as f32, g as f32, b as f32, a as f32]),
                _ => None,
            }),
            is_color_kept: color.is_none_or(|attachment| attachment.ops.store == wgpu::StoreOp::Store),
            depth: depth.map(|attachment| own(attachment.view)),
            clear_depth: depth_ops.and_then(|operations| match operations.load {
                wgpu::LoadOp::Clear(depth) => Some(depth),
                _ => None,
            }),
            is_depth_kept: depth_ops.is_none_or(|operations| operations.store == wgpu::StoreOp::Store),
        }
    }
}

type Commands = Rc<RefCell<Vec<Command>>>;

#[derive(Debug, Default)]
pub(crate) struct CommandEncoder(Commands);

/// What an encoder has recorded.
#[derive(Debug)]
pub(crate) struct CommandBuffer(pub(crate) Vec<Command>);

impl CommandBufferInterface for CommandBuffer {}

/// Panics with the name of what only other devices can do.
macro_rules! missing {
    ($($name:ident($($argument:ty),*) $(-> $result:ty)?;)*) => {
        $(fn $name(&mut self, $(_: $argument),*) $(-> $result)? {
            unimplemented!(stringify!($name))
        })*
    };
    (shared $($name:ident($($argument:ty),*) $(-> $result:ty)?;)*) => {
        $(fn $name(&self, $(_: $argument),*) $(-> $result)? {
            unimplemented!(stringify!($name))
        })*
    };
}
pub(crate) use missing;

impl CommandEncoderInterface for CommandEncoder {
    fn begin_render_pass(&self, descriptor: &wgpu::RenderPassDescriptor<'_>) -> DispatchRenderPass {
        self.0.borrow_mut().push(Command::Begin(Attachments::new(descriptor)));
        DispatchRenderPass::custom(RenderPass(Rc::clone(&self.0)))
    }

    fn copy_texture_to_buffer(
        &self,
        source: wgpu::TexelCopyTextureInfo<'_>,
        destination: wgpu::TexelCopyBufferInfo<'_>,
        _: wgpu::Extent3d,
    ) {
        let texture = source.texture.as_custom::<Texture>().expect(OWN).clone();
        let buffer = destination.buffer.as_custom::<Buffer>().expect(OWN).clone();
        let row = destination.layout.bytes_per_row.expect("the bytes of a row are told");
        self.0.borrow_mut().push(Command::Read(texture, buffer, row));
    }

    fn finish(&mut self) -> DispatchCommandBuffer {
        DispatchCommandBuffer::custom(CommandBuffer(self.0.take()))
    }

    missing! { shared
        copy_buffer_to_buffer(&DispatchBuffer, u64, &DispatchBuffer, u64, Option<u64>);
        copy_buffer_to_texture(wgpu::TexelCopyBufferInfo<'_>, wgpu::TexelCopyTextureInfo<'_>, wgpu::Extent3d);
        copy_texture_to_texture(wgpu::TexelCopyTextureInfo<'_>, wgpu::TexelCopyTextureInfo<'_>, wgpu::Extent3d);
        begin_compute_pass(&wgpu::ComputePassDescriptor<'_>) -> DispatchComputePass;
        clear_texture(&DispatchTexture, &wgpu::ImageSubresourceRange);
        clear_buffer(&DispatchBuffer, u64, Option<u64>);
        insert_debug_marker(&str);
        push_debug_group(&str);
        pop_debug_group();
        write_timestamp(&DispatchQuerySet, u32);
        resolve_query_set(&DispatchQuerySet, u32, u32, &DispatchBuffer, u64);
    }

    fn mark_acceleration_structures_built<'a>(
        &self,
        _: &mut dyn Iterator<Item = &'a wgpu::Blas>,
        _: &mut dyn Iterator<Item = &'a wgpu::Tlas>,
    ) {
        unimplemented!("acceleration structures")
    }

    fn build_acceleration_structures<'a>(
        &self,
        _: &mut dyn Iterator<Item = &'a wgpu::BlasBuildEntry<'a>>,
        _: &mut dyn Iterator<Item = &'a wgpu::Tlas>,
    ) {
        unimplemented!("acceleration structures")
    }

    fn transition_resources<'a>(
        &mut self,
        _: &mut dyn Iterator<Item = wgpu::wgt::BufferTransition<&'a DispatchBuffer>>,
        _: &mut dyn Iterator<Item = wgpu::wgt::TextureTransition<&'a DispatchTexture>>,
    ) {
        unimplemented!("transitions")
    }
}

/// A pass that is being recorded.
#[derive(Debug)]
struct RenderPass(Commands);

impl RenderPass {
    fn push(&self, command: Command) {
        self.0.borrow_mut().push(command);
    }
}

impl Drop for RenderPass {
    fn drop(&mut self) {
        self.push(Command::End);
    }
}

impl RenderPassInterface for RenderPass {
    fn set_pipeline(&mut self, pipeline: &DispatchRenderPipeline) {
        self.push(Command::Pipeline(pipeline.as_custom::<Pipeline>().expect(OWN).clone()));
    }

    fn set_bind_group(&mut self, index: u32, group: Option<&DispatchBindGroup>, offsets: &[u32]) {
        assert!(offsets.is_empty(), "no offset is dynamic");
        let Some(group) = group else { return };
        self.push(Command::Group(index as usize, group.as_custom::<BindGroup>().expect(OWN).clone()));
    }

    fn set_index_buffer(
        &mut self,
        buffer: &DispatchBuffer,
        format: wgpu::IndexFormat,
        offset: u64,
        _: Option<wgpu::BufferSize>,
    ) {
        self.push(Command::Indices(buffer.as_custom::<Buffer>().expect(OWN).clone(), format, offset));
    }

    fn set_vertex_buffer(
        &mut self,
        slot: u32,
        buffer: Option<&DispatchBuffer>,
        offset: u64,
        _: Option<wgpu::BufferSize>,
    ) {
        let Some(buffer) = buffer else { return };
        self.push(Command::Vertices(slot as usize, buffer.as_custom::<Buffer>().expect(OWN).clone(), offset));
    }

    fn set_scissor_rect(&mut self, x: u32, y: u32, width: u32, height: u32) {
        self.push(Command::Scissor([x, y, width, height].map(|pixels| pixels as i32)));
    }

    fn draw(&mut self, vertices: Range<u32>, instances: Range<u32>) {
        assert_eq!(instances.start, 0, "WebGL2 has no first instance");
        self.push(Command::Draw(vertices, instances.end));
    }

    fn draw_indexed(&mut self, indices: Range<u32>, base_vertex: i32, instances: Range<u32>) {
        assert_eq!((base_vertex, instances.start), (0, 0), "WebGL2 has no first vertex or instance");
        self.push(Command::DrawIndexed(indices, instances.end));
    }

    missing! {
        set_immediates(u32, &[u8]);
        set_blend_constant(wgpu::Color);
        set_viewport(f32, f32, f32, f32, f32, f32);
        set_stencil_reference(u32);
        draw_mesh_tasks(u32, u32, u32);
        draw_indirect(&DispatchBuffer, u64);
        draw_indexed_indirect(&DispatchBuffer, u64);
        draw_mesh_tasks_indirect(&DispatchBuffer, u64);
        multi_draw_indirect(&DispatchBuffer, u64, u32);
        multi_draw_indexed_indirect(&DispatchBuffer, u64, u32);
        multi_draw_indirect_count(&DispatchBuffer, u64, &DispatchBuffer, u64, u32);
        multi_draw_mesh_tasks_indirect(&DispatchBuffer, u64, u32);
        multi_draw_indexed_indirect_count(&DispatchBuffer, u64, &DispatchBuffer, u64, u32);
        multi_draw_mesh_tasks_indirect_count(&DispatchBuffer, u64, &DispatchBuffer, u64, u32);
        insert_debug_marker(&str);
        push_debug_group(&str);
        pop_debug_group();
        write_timestamp(&DispatchQuerySet, u32);
        begin_occlusion_query(u32);
        end_occlusion_query();
        begin_pipeline_statistics_query(&DispatchQuerySet, u32);
        end_pipeline_statistics_query();
        execute_bundles(&mut dyn Iterator<Item = &DispatchRenderBundle>);
    }
}
