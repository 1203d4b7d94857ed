use crate::context::{Context, DEPTH_FORMAT, SAMPLE_COUNT};

/// What tells one pipeline from another; the rest is common to all.
#[derive(Clone)]
pub(crate) struct PipelineRecipe<'a> {
    pub(crate) label: &'a str,
    pub(crate) layouts: &'a [Option<&'a wgpu::BindGroupLayout>],
    pub(crate) module: &'a wgpu::ShaderModule,
    pub(crate) vertex: &'a str,
    pub(crate) fragment: &'a str,
    pub(crate) buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub(crate) topology: wgpu::PrimitiveTopology,
    pub(crate) place: Place,
}

/// How what a pipeline draws goes together with what is there.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    /// Behind everything.
    Behind,
    /// Over what is behind, premultiplied; hides nothing.
    Over,
    /// Hides what is farther away.
    Solid,
    /// Hides what is farther away, and is over what is behind where that is drawn before; premultiplied.
    Fading,
}

impl PipelineRecipe<'_> {
    pub(crate) fn build(&self, context: &Context) -> wgpu::RenderPipeline {
        let is_blended = matches!(self.place, Place::Over | Place::Fading);
        let blend = is_blended.then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        let target = wgpu::ColorTargetState { format: context.format, blend, write_mask: wgpu::ColorWrites::ALL };
        let fragment = wgpu::FragmentState {
            module: self.module,
            entry_point: Some(self.fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(target)],
        };
        self.create(context, SAMPLE_COUNT, Some(fragment))
    }

    /// Of what casts a shadow: depth alone, into a shadow map.
    pub(crate) fn build_shadow(&self, context: &Context) -> wgpu::RenderPipeline {
        self.create(context, 1, None)
    }

    /// Of what casts a shadow but for the pixels that the fragment shader discards.
    pub(crate) fn build_holed_shadow(&self, context: &Context) -> wgpu::RenderPipeline {
        let fragment = wgpu::FragmentState {
            module: self.module,
            entry_point: Some(self.fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[],
        };
        self.create(context, 1, Some(fragment))
    }

    fn create(
        &self,
        context: &Context,
        sample_count: u32,
        fragment: Option<wgpu::FragmentState<'_>>,
    ) -> wgpu::RenderPipeline {
        let layout = context.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: self.layouts,
            immediate_size: 0,
        });
        let compare = match self.place {
            Place::Behind => wgpu::CompareFunction::Always,
            Place::Over | Place::Solid | Place::Fading => wgpu::CompareFunction::Less,
        };
        context.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: self.module,
                entry_point: Some(self.vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: self.buffers,
            },
            primitive: wgpu::PrimitiveState { topology: self.topology, ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(matches!(self.place, Place::Solid | Place::Fading)),
                depth_compare: Some(compare),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: sample_count, ..Default::default() },
            fragment,
            multiview_mask: None,
            cache: None,
        })
    }
}
