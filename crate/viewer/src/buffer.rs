use wgpu::util::DeviceExt;

use crate::context::Context;
use crate::error::Error;

/// A buffer of a mesh with its final size.
///
/// # Errors
/// When the device does not allow a buffer that large.
pub(crate) fn mesh_buffer(
    context: &Context,
    what: &'static str,
    bytes: &[u8],
    usage: wgpu::BufferUsages,
) -> Result<wgpu::Buffer, Error> {
    let limit = context.device.limits().max_buffer_size;
    if bytes.len() as u64 > limit {
        return Err(Error::MeshTooLarge { what, bytes: bytes.len() as u64, limit });
    }
    let contents = wgpu::util::BufferInitDescriptor { label: Some(what), contents: bytes, usage };
    Ok(context.device.create_buffer_init(&contents))
}

/// A buffer that is rewritten often: reallocated only when it must grow.
pub(crate) struct Growing {
    label: &'static str,
    usage: wgpu::BufferUsages,
    buffer: Option<wgpu::Buffer>,
}

impl Growing {
    pub(crate) fn new(label: &'static str, usage: wgpu::BufferUsages) -> Self {
        Self { label, usage, buffer: None }
    }

    pub(crate) fn write(&mut self, context: &Context, bytes: &[u8]) {
        if bytes.is_empty() {
            return;
        }
        let size = bytes.len() as u64;
        let buffer = self.buffer.take().filter(|buffer| buffer.size() >= size).unwrap_or_else(|| {
            context.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(self.label),
                size: size.next_power_of_two(),
                usage: self.usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        });
        context.queue.write_buffer(&buffer, 0, bytes);
        self.buffer = Some(buffer);
    }

    /// None as long as nothing was written.
    pub(crate) fn get(&self) -> Option<&wgpu::Buffer> {
        self.buffer.as_ref()
    }
}

/// Instances of a primitive, in a vertex buffer that grows with them.
pub(crate) struct Instances<T> {
    buffer: Growing,
    /// What is on the device; kept for its memory.
    items: Vec<T>,
}

impl<T: bytemuck::NoUninit> Instances<T> {
    pub(crate) fn new(label: &'static str) -> Self {
        Self { buffer: Growing::new(label, wgpu::BufferUsages::VERTEX), items: Vec::new() }
    }

    /// Replaces all.
    pub(crate) fn set(&mut self, context: &Context, items: impl IntoIterator<Item = T>) {
        self.items.clear();
        self.extend(context, items);
    }

    /// Adds more.
    pub(crate) fn extend(&mut self, context: &Context, items: impl IntoIterator<Item = T>) {
        self.items.extend(items);
        self.buffer.write(context, bytemuck::cast_slice(&self.items));
    }

    pub(crate) fn clear(&mut self) {
        self.items.clear();
    }

    pub(crate) fn items(&self) -> &[T] {
        &self.items
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Binds the buffer to a slot and tells how many instances there are; None where there are none.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass<'_>, slot: u32) -> Option<u32> {
        let buffer = self.buffer.get().filter(|_| !self.is_empty())?;
        pass.set_vertex_buffer(slot, buffer.slice(..));
        Some(self.items.len() as u32)
    }
}
