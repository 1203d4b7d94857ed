use crate::context::Context;

/// The module of the shader of this name in `build.rs`.
macro_rules! shader_module {
    ($context:expr, $name:literal) => {
        $crate::shader::module($context, $name, include_str!(concat!(env!("OUT_DIR"), "/", $name)))
    };
}
pub(crate) use shader_module;

/// The module of a shader as `build.rs` writes it.
#[cfg(not(feature = "webgl2"))]
pub(crate) fn module(context: &Context, label: &str, text: &str) -> wgpu::ShaderModule {
    let source = wgpu::ShaderSource::Wgsl(text.into());
    context.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(label), source })
}

/// The module of a shader as `build.rs` writes it, which checks it, too.
#[cfg(feature = "webgl2")]
#[allow(unsafe_code, reason = "wgpu does not check what is for one graphics interface alone; the browser does")]
pub(crate) fn module(context: &Context, label: &str, text: &str) -> wgpu::ShaderModule {
    let glsl = Some(text.into());
    let descriptor = wgpu::ShaderModuleDescriptorPassthrough { label: Some(label), glsl, ..Default::default() };
    // Safety: a browser lets no shader harm it.
    unsafe { context.device.create_shader_module_passthrough(descriptor) }
}
