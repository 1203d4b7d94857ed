//! Plays what was recorded.

use js_sys::Array;
use web_sys::WebGl2RenderingContext as Gl;

use crate::command::{Attachments, Command};
use crate::context::Context;
use crate::convert::{self, Format};
use crate::program::PipelineStore;
use crate::resource::{BindGroup, Bound, Buffer, Texture};

const GROUPS: usize = 4;
const SLOTS: usize = 8;

/// What is set until the next draw, and how much of it the context has yet to be told.
pub(crate) struct Player<'a> {
    context: &'a Context,
    attachments: Option<&'a Attachments>,
    pipeline: Option<&'a PipelineStore>,
    groups: [Option<&'a BindGroup>; GROUPS],
    vertices: [Option<(&'a Buffer, u64)>; SLOTS],
    indices: Option<(&'a Buffer, wgpu::IndexFormat, u64)>,
    is_pipeline_new: bool,
    are_groups_new: bool,
    are_vertices_new: bool,
    /// Attributes that are enabled, one a bit.
    enabled: u32,
}

impl<'a> Player<'a> {
    pub(crate) fn new(context: &'a Context) -> Self {
        Self {
            context,
            attachments: None,
            pipeline: None,
            groups: [None; GROUPS],
            vertices: [None; SLOTS],
            indices: None,
            is_pipeline_new: false,
            are_groups_new: false,
            are_vertices_new: false,
            enabled: 0,
        }
    }

    pub(crate) fn play(&mut self, command: &'a Command) {
        match command {
            Command::Begin(attachments) => self.begin(attachments),
            Command::End => self.end(),
            Command::Pipeline(pipeline) => {
                self.pipeline = Some(&pipeline.0);
                (self.is_pipeline_new, self.are_groups_new, self.are_vertices_new) = (true, true, true);
            }
            Command::Group(index, group) => {
                self.groups[*index] = Some(group);
                self.are_groups_new = true;
            }
            Command::Vertices(slot, buffer, offset) => {
                self.vertices[*slot] = Some((buffer, *offset));
                self.are_vertices_new = true;
            }
            Command::Indices(buffer, format, offset) => self.indices = Some((buffer, *format, *offset)),
            Command::Scissor([x, y, width, height]) => self.context.scissor(*x, *y, *width, *height),
            Command::Draw(vertices, instances) => {
                let Some(topology) = self.bind() else { return };
                let (first, count) = (vertices.start as i32, vertices.len() as i32);
                // Not `drawArrays`, even for one instance: ANGLE ignores divisors there.
                self.context.draw_arrays_instanced(topology, first, count, *instances as i32);
            }
            Command::DrawIndexed(indices, instances) => {
                let (Some(topology), Some((buffer, format, offset))) = (self.bind(), self.indices) else { return };
                let (kind, bytes) = convert::index(format);
                let start = offset as i32 + (indices.start * bytes) as i32;
                let count = indices.len() as i32;
                self.context.bind_buffer(Gl::ELEMENT_ARRAY_BUFFER, buffer.raw());
                self.context.draw_elements_instanced_with_i32(topology, count, kind, start, *instances as i32);
            }
            Command::Read(texture, buffer, row) => read(self.context, texture, buffer, *row),
        }
    }

    fn begin(&mut self, attachments: &'a Attachments) {
        let context = self.context;
        self.attachments = Some(attachments);
        (self.pipeline, self.groups, self.vertices, self.indices) = (None, [None; GROUPS], [None; SLOTS], None);
        context.bind_framebuffer(Gl::DRAW_FRAMEBUFFER, context.drawn.as_ref());
        let places = [(Gl::COLOR_ATTACHMENT0, &attachments.color), (Gl::DEPTH_ATTACHMENT, &attachments.depth)];
        for (place, view) in places {
            match view {
                Some(view) => view.attach(Gl::DRAW_FRAMEBUFFER, place),
                None => context.framebuffer_renderbuffer(Gl::DRAW_FRAMEBUFFER, place, Gl::RENDERBUFFER, None),
            }
        }
        context.draw_buffers(&numbers(attachments.color.iter().map(|_| Gl::COLOR_ATTACHMENT0)));
        if let Some(view) = attachments.color.as_ref().or(attachments.depth.as_ref()) {
            let (width, height) = view.size();
            context.viewport(0, 0, width, height);
            context.scissor(0, 0, width, height);
        }
        context.enable(Gl::SCISSOR_TEST);
        if let Some(color) = attachments.clear_color {
            context.clear_bufferfv_with_f32_array(Gl::COLOR, 0, &color);
        }
        if let Some(depth) = attachments.clear_depth {
            context.depth_mask(true);
            context.clear_depth(depth);
            context.clear(Gl::DEPTH_BUFFER_BIT);
        }
    }

    fn end(&mut self) {
        let context = self.context;
        context.disable(Gl::SCISSOR_TEST);
        self.enable(0);
        let Some(attachments) = self.attachments.take() else { return };
        if let (Some(color), Some(resolved)) = (&attachments.color, &attachments.resolved) {
            context.bind_framebuffer(Gl::READ_FRAMEBUFFER, context.drawn.as_ref());
            context.bind_framebuffer(Gl::DRAW_FRAMEBUFFER, context.copied.as_ref());
            resolved.attach(Gl::DRAW_FRAMEBUFFER, Gl::COLOR_ATTACHMENT0);
            let (width, height) = color.size();
            let (color, nearest) = (Gl::COLOR_BUFFER_BIT, Gl::NEAREST);
            context.blit_framebuffer(0, 0, width, height, 0, 0, width, height, color, nearest);
            context.bind_framebuffer(Gl::DRAW_FRAMEBUFFER, context.drawn.as_ref());
        }
        let color = (!attachments.is_color_kept).then_some(Gl::COLOR_ATTACHMENT0);
        let depth = (!attachments.is_depth_kept).then_some(Gl::DEPTH_ATTACHMENT);
        // Throws where the list is no list.
        let _ = context.invalidate_framebuffer(Gl::DRAW_FRAMEBUFFER, &numbers(color.into_iter().chain(depth)));
    }

    /// Tells the context what has changed since the last draw; gives the topology.
    fn bind(&mut self) -> Option<u32> {
        let pipeline = self.pipeline?;
        if std::mem::take(&mut self.is_pipeline_new) {
            self.bind_pipeline(pipeline);
        }
        if std::mem::take(&mut self.are_groups_new) {
            self.bind_groups(pipeline);
        }
        if std::mem::take(&mut self.are_vertices_new) {
            self.bind_vertices(pipeline);
        }
        Some(pipeline.topology)
    }

    fn bind_pipeline(&self, pipeline: &PipelineStore) {
        let context = self.context;
        pipeline.bind();
        let switch = |what, is_on| if is_on { context.enable(what) } else { context.disable(what) };
        switch(Gl::BLEND, pipeline.blend.is_some());
        if let Some([[color, color_source, color_target], [alpha, alpha_source, alpha_target]]) = pipeline.blend {
            context.blend_equation_separate(color, alpha);
            context.blend_func_separate(color_source, color_target, alpha_source, alpha_target);
        }
        switch(Gl::DEPTH_TEST, pipeline.depth.is_some());
        if let Some((function, is_written)) = pipeline.depth {
            context.depth_func(function);
            context.depth_mask(is_written);
        }
    }

    fn bind_groups(&self, pipeline: &PipelineStore) {
        let context = self.context;
        let bound = |(group, binding): (usize, u32)| self.groups[group].and_then(|group| group.get(binding));
        for (index, uniform) in (0..).zip(&pipeline.uniforms) {
            match bound(uniform.place) {
                Some(Bound::Buffer(buffer)) => context.bind_buffer_base(Gl::UNIFORM_BUFFER, index, buffer.raw()),
                Some(Bound::View(view)) => {
                    context.active_texture(Gl::TEXTURE0 + index);
                    view.bind();
                    if let Some(Bound::Sampler(sampler)) = uniform.sampler.and_then(bound) {
                        context.bind_sampler(index, sampler.raw());
                    }
                }
                _ => {}
            }
        }
    }

    fn bind_vertices(&mut self, pipeline: &PipelineStore) {
        let context = self.context;
        let mut enabled = 0;
        for attribute in &pipeline.attributes {
            let Some((buffer, offset)) = self.vertices[attribute.slot] else { continue };
            let (location, offset) = (attribute.location, (offset + attribute.offset) as i32);
            enabled |= 1 << location;
            context.bind_buffer(Gl::ARRAY_BUFFER, buffer.raw());
            let (count, kind, stride) = (attribute.count, attribute.kind, attribute.stride);
            context.vertex_attrib_pointer_with_i32(location, count, kind, true, stride, offset);
            context.vertex_attrib_divisor(location, attribute.divisor);
        }
        self.enable(enabled);
    }

    /// Enables these attributes, one a bit, and no other.
    fn enable(&mut self, wanted: u32) {
        for location in 0..u32::BITS {
            let [is, was] = [wanted, self.enabled].map(|attributes| attributes >> location & 1 == 1);
            match (is, was) {
                (true, false) => self.context.enable_vertex_attrib_array(location),
                (false, true) => self.context.disable_vertex_attrib_array(location),
                _ => {}
            }
        }
        self.enabled = wanted;
    }
}

/// Reads a texture into a buffer, with so many bytes a row.
fn read(context: &Context, texture: &Texture, buffer: &Buffer, row: u32) {
    let Format { external, kind, bytes, .. } = texture.format();
    let (width, height) = texture.size();
    context.bind_framebuffer(Gl::READ_FRAMEBUFFER, context.copied.as_ref());
    texture.view(0..1).attach(Gl::READ_FRAMEBUFFER, Gl::COLOR_ATTACHMENT0);
    context.pixel_storei(Gl::PACK_ROW_LENGTH, (row / bytes) as i32);
    context.bind_buffer(Gl::PIXEL_PACK_BUFFER, buffer.raw());
    if let Err(error) = context.read_pixels_with_i32(0, 0, width, height, external, kind, 0) {
        context.report(format!("{error:?}"));
    }
    context.bind_buffer(Gl::PIXEL_PACK_BUFFER, None);
}

/// Shows a texture on the canvas, the right way up.
pub(crate) fn present(context: &Context, texture: &Texture) {
    let (width, height) = texture.size();
    context.bind_framebuffer(Gl::READ_FRAMEBUFFER, context.copied.as_ref());
    texture.view(0..1).attach(Gl::READ_FRAMEBUFFER, Gl::COLOR_ATTACHMENT0);
    context.bind_framebuffer(Gl::DRAW_FRAMEBUFFER, None);
    context.blit_framebuffer(0, height, width, 0, 0, 0, width, height, Gl::COLOR_BUFFER_BIT, Gl::NEAREST);
}

fn numbers(numbers: impl Iterator<Item = u32>) -> Array {
    numbers.map(wasm_bindgen::JsValue::from).collect()
}
