//! Shaders and pipelines.

use std::cell::Cell;
use std::pin::Pin;
use std::rc::Rc;

use web_sys::{WebGl2RenderingContext as Gl, WebGlProgram};
use wgpu::custom::{
    DispatchBindGroupLayout, RenderPipelineInterface, ShaderCompilationInfoFuture, ShaderModuleInterface,
};

use crate::context::Context;
use crate::convert;
use crate::resource::{Layout, OWN};

/// The entry points of a module, in GLSL.
#[derive(Debug)]
pub(crate) struct ShaderModule(pub(crate) String);

impl ShaderModule {
    /// The uniforms of an entry point, and its text.
    fn entry(&self, name: &str) -> (Vec<Uniform>, &str) {
        let entries = self.0.split("//").filter_map(|entry| entry.split_once('\n'));
        let mut entries = entries.map(|(words, text)| (words.split(' '), text));
        let (words, text) =
            entries.find(|(words, _)| words.clone().next() == Some(name)).expect("the name of an entry point");
        (words.skip(1).map(Uniform::new).collect(), text)
    }
}

impl ShaderModuleInterface for ShaderModule {
    fn get_compilation_info(&self) -> Pin<Box<dyn ShaderCompilationInfoFuture>> {
        unimplemented!("messages about shaders")
    }
}

/// Something of a bind group that a shader uses.
#[derive(Debug)]
pub(crate) struct Uniform {
    name: String,
    /// Group and binding.
    pub(crate) place: Place,
    /// That of the sampler of a texture.
    pub(crate) sampler: Option<Place>,
}

type Place = (usize, u32);

impl Uniform {
    fn new(name: &str) -> Self {
        let mut numbers = name.split('_').filter_map(|word| word.parse::<u32>().ok());
        let mut place = || Some((numbers.next()? as usize, numbers.next()?));
        Self { name: name.to_owned(), place: place().expect("the name of a uniform"), sampler: place() }
    }
}

/// A pipeline; a clone is the same one.
#[derive(Clone, Debug)]
pub(crate) struct Pipeline(pub(crate) Rc<PipelineStore>);

#[derive(Debug)]
pub(crate) struct PipelineStore {
    context: Context,
    raw: Option<WebGlProgram>,
    pub(crate) uniforms: Vec<Uniform>,
    is_linked: Cell<bool>,
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) topology: u32,
    /// Equations of color and alpha with their factors.
    pub(crate) blend: Option<[[u32; 3]; 2]>,
    /// The comparison, and whether depth is written.
    pub(crate) depth: Option<(u32, bool)>,
}

#[derive(Debug)]
pub(crate) struct Attribute {
    pub(crate) location: u32,
    pub(crate) slot: usize,
    pub(crate) count: i32,
    pub(crate) kind: u32,
    pub(crate) offset: u64,
    pub(crate) stride: i32,
    pub(crate) divisor: u32,
}

impl Pipeline {
    pub(crate) fn new(context: &Context, descriptor: &wgpu::RenderPipelineDescriptor<'_>) -> Self {
        assert!(descriptor.primitive.cull_mode.is_none(), "both sides of triangles are drawn");
        let raw = context.create_program();
        let mut uniforms = Vec::new();
        let mut add = |stage, module: Option<&wgpu::ShaderModule>, entry: Option<&str>| {
            let module = module.map(|module| module.as_custom::<ShaderModule>().expect(OWN));
            let (used, text) = match (module, entry) {
                (Some(module), Some(entry)) => module.entry(entry),
                // WebGL2 has no pipeline without one of the two.
                _ => (Vec::new(), "#version 300 es\nvoid main() {}"),
            };
            uniforms.extend(used);
            let (Some(program), Some(shader)) = (&raw, context.create_shader(stage)) else { return };
            context.shader_source(&shader, text);
            context.compile_shader(&shader);
            context.attach_shader(program, &shader);
            // It goes with the program.
            context.delete_shader(Some(&shader));
        };
        let fragment = descriptor.fragment.as_ref();
        add(Gl::VERTEX_SHADER, Some(descriptor.vertex.module), descriptor.vertex.entry_point);
        add(Gl::FRAGMENT_SHADER, fragment.map(|stage| stage.module), fragment.and_then(|stage| stage.entry_point));
        if let Some(program) = &raw {
            context.link_program(program);
        }
        let target = fragment.and_then(|stage| stage.targets.first()?.as_ref());
        let depth = descriptor.depth_stencil.as_ref();
        Self(Rc::new(PipelineStore {
            context: context.clone(),
            raw,
            uniforms,
            is_linked: Cell::new(false),
            attributes: attributes(descriptor.vertex.buffers),
            topology: convert::topology(descriptor.primitive.topology),
            blend: target.and_then(|target| target.blend).map(|blend| [blend.color, blend.alpha].map(convert::blend)),
            depth: depth.map(|state| {
                let function = convert::compare(state.depth_compare.unwrap_or_default());
                (function, state.depth_write_enabled.unwrap_or_default())
            }),
        }))
    }
}

fn attributes(buffers: &[Option<wgpu::VertexBufferLayout<'_>>]) -> Vec<Attribute> {
    let buffers = buffers.iter().enumerate().filter_map(|(slot, layout)| Some((slot, layout.as_ref()?)));
    let attributes = buffers.flat_map(|(slot, layout)| {
        layout.attributes.iter().map(move |attribute| {
            let (count, kind) = convert::attribute(attribute.format);
            Attribute {
                location: attribute.shader_location,
                slot,
                count,
                kind,
                offset: attribute.offset,
                stride: layout.array_stride as i32,
                divisor: u32::from(layout.step_mode == wgpu::VertexStepMode::Instance),
            }
        })
    });
    attributes.collect()
}

impl PipelineStore {
    /// Uses the program. The first time, the browser may still be compiling it: it compiles several at once, and nobody waits for
    /// those that are not used.
    pub(crate) fn bind(&self) {
        let Some(program) = &self.raw else { return };
        self.context.use_program(Some(program));
        if !self.is_linked.replace(true) {
            self.link(program);
        }
    }

    /// Gives each uniform the place that its index says.
    fn link(&self, program: &WebGlProgram) {
        let context = &self.context;
        if context.get_program_parameter(program, Gl::LINK_STATUS).is_falsy() && !context.is_context_lost() {
            let shaders = context.get_attached_shaders(program);
            let logs = shaders
                .iter()
                .flat_map(|shaders| shaders.iter())
                .filter_map(|shader| context.get_shader_info_log(&shader.into()));
            let log = context.get_program_info_log(program).into_iter().chain(logs).collect::<String>();
            context.report(log);
        }
        for (index, uniform) in (0..).zip(&self.uniforms) {
            if uniform.sampler.is_some() {
                let location = context.get_uniform_location(program, &uniform.name);
                context.uniform1i(location.as_ref(), index);
            } else {
                let block = context.get_uniform_block_index(program, &uniform.name);
                if block != Gl::INVALID_INDEX {
                    context.uniform_block_binding(program, block, index as u32);
                }
            }
        }
    }
}

impl Drop for PipelineStore {
    fn drop(&mut self) {
        self.context.delete_program(self.raw.as_ref());
    }
}

impl RenderPipelineInterface for Pipeline {
    fn get_bind_group_layout(&self, _: u32) -> DispatchBindGroupLayout {
        DispatchBindGroupLayout::custom(Layout)
    }
}
