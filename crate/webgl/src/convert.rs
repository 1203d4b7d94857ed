//! Words of wgpu in those of WebGL2.

use web_sys::WebGl2RenderingContext as Gl;

/// How WebGL2 describes the texels of a texture: as they are kept, and as they come.
#[derive(Clone, Copy)]
pub(crate) struct Format {
    pub(crate) internal: u32,
    pub(crate) external: u32,
    pub(crate) kind: u32,
    /// Of a texel.
    pub(crate) bytes: u32,
}

pub(crate) fn format(format: wgpu::TextureFormat) -> Format {
    use wgpu::TextureFormat::{Depth32Float, R8Unorm, Rgba8Unorm, Rgba8UnormSrgb};
    let (internal, external, kind, bytes) = match format {
        R8Unorm => (Gl::R8, Gl::RED, Gl::UNSIGNED_BYTE, 1),
        Rgba8Unorm => (Gl::RGBA8, Gl::RGBA, Gl::UNSIGNED_BYTE, 4),
        Rgba8UnormSrgb => (Gl::SRGB8_ALPHA8, Gl::RGBA, Gl::UNSIGNED_BYTE, 4),
        Depth32Float => (Gl::DEPTH_COMPONENT32F, Gl::DEPTH_COMPONENT, Gl::FLOAT, 4),
        _ => unimplemented!("this format of textures"),
    };
    Format { internal, external, kind, bytes }
}

/// The numbers of an attribute, and their type.
pub(crate) fn attribute(format: wgpu::VertexFormat) -> (i32, u32) {
    use wgpu::VertexFormat::{Float32, Float32x2, Float32x3, Float32x4, Snorm8x4, Unorm8x4, Unorm16x4};
    match format {
        Float32 => (1, Gl::FLOAT),
        Float32x2 => (2, Gl::FLOAT),
        Float32x3 => (3, Gl::FLOAT),
        Float32x4 => (4, Gl::FLOAT),
        Snorm8x4 => (4, Gl::BYTE),
        Unorm8x4 => (4, Gl::UNSIGNED_BYTE),
        Unorm16x4 => (4, Gl::UNSIGNED_SHORT),
        _ => unimplemented!("this format of vertices"),
    }
}

/// The type of indices, and the bytes of one.
pub(crate) fn index(format: wgpu::IndexFormat) -> (u32, u32) {
    match format {
        wgpu::IndexFormat::Uint16 => (Gl::UNSIGNED_SHORT, 2),
        wgpu::IndexFormat::Uint32 => (Gl::UNSIGNED_INT, 4),
    }
}

pub(crate) fn topology(topology: wgpu::PrimitiveTopology) -> u32 {
    match topology {
        // Shaders that give points no size.
        wgpu::PrimitiveTopology::PointList => unimplemented!("points"),
        wgpu::PrimitiveTopology::LineList => Gl::LINES,
        wgpu::PrimitiveTopology::LineStrip => Gl::LINE_STRIP,
        wgpu::PrimitiveTopology::TriangleList => Gl::TRIANGLES,
        wgpu::PrimitiveTopology::TriangleStrip => Gl::TRIANGLE_STRIP,
    }
}

pub(crate) fn compare(function: wgpu::CompareFunction) -> u32 {
    match function {
        wgpu::CompareFunction::Never => Gl::NEVER,
        wgpu::CompareFunction::Less => Gl::LESS,
        wgpu::CompareFunction::Equal => Gl::EQUAL,
        wgpu::CompareFunction::LessEqual => Gl::LEQUAL,
        wgpu::CompareFunction::Greater => Gl::GREATER,
        wgpu::CompareFunction::NotEqual => Gl::NOTEQUAL,
        wgpu::CompareFunction::GreaterEqual => Gl::GEQUAL,
        wgpu::CompareFunction::Always => Gl::ALWAYS,
    }
}

/// The equation of a blended channel, and the factors of what comes and of what is there.
pub(crate) fn blend(component: wgpu::BlendComponent) -> [u32; 3] {
    let equation = match component.operation {
        wgpu::BlendOperation::Add => Gl::FUNC_ADD,
        wgpu::BlendOperation::Subtract => Gl::FUNC_SUBTRACT,
        wgpu::BlendOperation::ReverseSubtract => Gl::FUNC_REVERSE_SUBTRACT,
        wgpu::BlendOperation::Min => Gl::MIN,
        wgpu::BlendOperation::Max => Gl::MAX,
    };
    [equation, factor(component.src_factor), factor(component.dst_factor)]
}

fn factor(factor: wgpu::BlendFactor) -> u32 {
    match factor {
        wgpu::BlendFactor::Zero => Gl::ZERO,
        wgpu::BlendFactor::One => Gl::ONE,
        wgpu::BlendFactor::SrcAlpha => Gl::SRC_ALPHA,
        wgpu::BlendFactor::OneMinusSrcAlpha => Gl::ONE_MINUS_SRC_ALPHA,
        _ => unimplemented!("this blend factor"),
    }
}

pub(crate) fn wrap(mode: wgpu::AddressMode) -> u32 {
    match mode {
        wgpu::AddressMode::ClampToEdge => Gl::CLAMP_TO_EDGE,
        wgpu::AddressMode::Repeat => Gl::REPEAT,
        wgpu::AddressMode::MirrorRepeat => Gl::MIRRORED_REPEAT,
        wgpu::AddressMode::ClampToBorder => unimplemented!("borders of textures"),
    }
}

pub(crate) fn magnify(filter: wgpu::FilterMode) -> u32 {
    match filter {
        wgpu::FilterMode::Nearest => Gl::NEAREST,
        wgpu::FilterMode::Linear => Gl::LINEAR,
    }
}

pub(crate) fn minify(filter: wgpu::FilterMode, of_levels: wgpu::MipmapFilterMode) -> u32 {
    match (filter, of_levels) {
        (wgpu::FilterMode::Nearest, wgpu::MipmapFilterMode::Nearest) => Gl::NEAREST_MIPMAP_NEAREST,
        (wgpu::FilterMode::Nearest, wgpu::MipmapFilterMode::Linear) => Gl::NEAREST_MIPMAP_LINEAR,
        (wgpu::FilterMode::Linear, wgpu::MipmapFilterMode::Nearest) => Gl::LINEAR_MIPMAP_NEAREST,
        (wgpu::FilterMode::Linear, wgpu::MipmapFilterMode::Linear) => Gl::LINEAR_MIPMAP_LINEAR,
    }
}
