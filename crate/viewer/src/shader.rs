use crate::context::Context;

/// The module of the shader of this name in `build.rs`.
macro_rules! shader_module {
    ($context:expr, $name:literal) => {
        $crate::shader::module($context, $name, include_bytes!(concat!(env!("OUT_DIR"), "/", $name)))
    };
}
pub(crate) use shader_module;

/// The module of a shader as `build.rs` writes it.
pub(crate) fn module(context: &Context, label: &str, built: &[u8]) -> wgpu::ShaderModule {
    let descriptor = wgpu::ShaderModuleDescriptor { label: Some(label), source: source(built) };
    context.device.create_shader_module(descriptor)
}

#[cfg(not(feature = "parsed"))]
fn source(built: &[u8]) -> wgpu::ShaderSource<'_> {
    wgpu::ShaderSource::Wgsl(str::from_utf8(built).expect("WGSL is UTF-8").into())
}

/// A parser of the text would be a tenth of the module for WebGL2.
#[cfg(feature = "parsed")]
fn source(built: &[u8]) -> wgpu::ShaderSource<'static> {
    let module: naga::Module = postcard::from_bytes(built).expect("the build writes what its naga reads");
    wgpu::ShaderSource::Naga(std::borrow::Cow::Owned(module))
}
