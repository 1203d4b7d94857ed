//! The shaders, compiled for a device.

use crate::patches::Capacity;

/// Passes over waiting windows and vertices that a patch makes in a round, before what is left waits for the next: by then its
/// neighbors may know of something nearer.
const PASSES: usize = 16;

/// The text of a round for patches of a capacity.
pub fn patch_shader(capacity: Capacity) -> String {
    let Capacity { faces, edges, vertices } = capacity;
    let constants = [("FACES", faces), ("EDGES", edges), ("VERTICES", vertices), ("PASSES", PASSES)];
    let constants = constants.map(|(name, value)| format!("const {name} = {value}u;\n")).concat();
    let texts = [
        include_str!("shaders/window.wgsl"),
        include_str!("shaders/patch.wgsl"),
        include_str!("shaders/front.wgsl"),
        include_str!("shaders/round.wgsl"),
    ];
    constants + &texts.concat()
}

pub const CLEAR_SHADER: &str = include_str!("shaders/clear.wgsl");
pub const GATHER_SHADER: &str = include_str!("shaders/gather.wgsl");

/// Storage buffers of the pipeline that has most.
pub const STORAGE_BUFFERS: u32 = 7;

/// What is bound to a pipeline.
#[derive(Clone, Copy)]
pub enum Binding {
    Read,
    Write,
    Uniform,
    /// A uniform of which each dispatch chooses one.
    Chosen,
}

/// A pipeline and the layout of its one bind group.
pub struct Pipeline {
    pub pipeline: wgpu::ComputePipeline,
    pub layout: wgpu::BindGroupLayout,
}

impl Pipeline {
    /// Of the entry point that has the pipeline's name.
    fn new(device: &wgpu::Device, name: &str, text: &str, bindings: &[Binding]) -> Self {
        let entry = |(binding, &kind): (usize, &Binding)| {
            let ty = match kind {
                Binding::Read => wgpu::BufferBindingType::Storage { read_only: true },
                Binding::Write => wgpu::BufferBindingType::Storage { read_only: false },
                Binding::Uniform | Binding::Chosen => wgpu::BufferBindingType::Uniform,
            };
            let has_dynamic_offset = matches!(kind, Binding::Chosen);
            wgpu::BindGroupLayoutEntry {
                binding: binding as u32,
                visibility: wgpu::ShaderStages::COMPUTE,
                ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset, min_binding_size: None },
                count: None,
            }
        };
        let entries: Vec<_> = bindings.iter().enumerate().map(entry).collect();
        let layout =
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(name), entries: &entries });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(name),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let source = wgpu::ShaderSource::Wgsl(text.into());
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(name), source });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(name),
            layout: Some(&pipeline_layout),
            module: &module,
            entry_point: Some(name),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        Self { pipeline, layout }
    }

    /// What its buffers are, in the order of their bindings.
    pub fn bind(&self, device: &wgpu::Device, label: &str, resources: &[wgpu::BindingResource<'_>]) -> wgpu::BindGroup {
        let entries = resources.iter().cloned().zip(0..);
        let entries: Vec<_> = entries.map(|(resource, binding)| wgpu::BindGroupEntry { binding, resource }).collect();
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(label),
            layout: &self.layout,
            entries: &entries,
        })
    }
}

/// All pipelines.
pub struct Pipelines {
    pub clear: Pipeline,
    pub advance: Pipeline,
    pub gather: Pipeline,
}

impl Pipelines {
    pub fn new(device: &wgpu::Device, capacity: Capacity) -> Self {
        use Binding::{Chosen, Read, Uniform, Write};
        let advance = [Chosen, Read, Read, Write, Write, Write, Write, Write];
        Self {
            clear: Pipeline::new(device, "clear", CLEAR_SHADER, &[Write; 3]),
            advance: Pipeline::new(device, "advance", &patch_shader(capacity), &advance),
            gather: Pipeline::new(device, "gather", GATHER_SHADER, &[Read, Read, Write, Uniform]),
        }
    }
}

#[cfg(test)]
mod tests {
    use naga::valid::{Capabilities, ValidationFlags, Validator};
    use naga::{AddressSpace, Module};

    use super::*;
    use crate::patches::PatchSize;

    fn valid(text: &str) -> Module {
        let module =
            naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
        // Without what a browser need not have.
        let checked = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
        checked.unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
        module
    }

    /// Bytes of the variables of a workgroup, and storage buffers.
    fn used(module: &Module) -> (u64, usize) {
        let mut layouter = naga::proc::Layouter::default();
        layouter.update(module.to_ctx()).expect("types of known size");
        let of = |space: fn(AddressSpace) -> bool| {
            module.global_variables.iter().map(|(_, variable)| variable).filter(move |variable| space(variable.space))
        };
        let bytes = of(|space| space == AddressSpace::WorkGroup).map(|variable| u64::from(layouter[variable.ty].size));
        (bytes.sum(), of(|space| matches!(space, AddressSpace::Storage { .. })).count())
    }

    #[test]
    fn shaders_stay_within_the_default_limits_of_webgpu() {
        let limits = wgpu::Limits::default();
        assert_eq!(limits.max_compute_workgroup_storage_size, 16_384);
        let sizes = [1, 1_000_000].map(|faces| PatchSize::of_mesh(faces).capacity());
        assert_ne!(sizes[0], sizes[1]);
        let texts = sizes.map(patch_shader).into_iter().chain([CLEAR_SHADER, GATHER_SHADER].map(str::to_owned));
        for text in texts {
            let module = valid(&text);
            let (bytes, buffers) = used(&module);
            assert!(bytes <= u64::from(limits.max_compute_workgroup_storage_size), "{bytes} bytes");
            assert!(buffers as u32 <= STORAGE_BUFFERS.min(limits.max_storage_buffers_per_shader_stage), "{buffers}");
            let [entry] = &module.entry_points[..] else { panic!("an entry point") };
            assert!(entry.workgroup_size.iter().product::<u32>() <= limits.max_compute_invocations_per_workgroup);
        }
    }
}
