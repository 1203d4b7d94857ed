use std::marker::PhantomData;

use encase::internal::WriteInto;
use encase::{ShaderType, UniformBuffer};

use crate::context::Context;

/// A uniform buffer that holds one struct, laid out as WGSL lays it out.
pub(crate) struct Uniform<T> {
    pub(crate) buffer: wgpu::Buffer,
    content: PhantomData<T>,
}

impl<T: ShaderType + WriteInto> Uniform<T> {
    /// Zeros until written.
    pub(crate) fn new(context: &Context, label: &str) -> Self {
        let buffer = context.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: T::min_size().get(),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { buffer, content: PhantomData }
    }

    pub(crate) fn write(&self, context: &Context, content: &T) {
        let mut bytes = UniformBuffer::new(Vec::<u8>::new());
        bytes.write(content).expect("a vector grows");
        context.queue.write_buffer(&self.buffer, 0, &bytes.into_inner());
    }

    /// A group that binds it alone.
    pub(crate) fn group(&self, context: &Context, layout: &wgpu::BindGroupLayout, label: &str) -> wgpu::BindGroup {
        context.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(label),
            layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: self.buffer.as_entire_binding() }],
        })
    }
}
