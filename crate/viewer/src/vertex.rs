//! Vertex buffer layouts, read off the types that fill the buffers.

use glam::{Vec2, Vec3, Vec4};

/// A type that a shader reads as one vertex attribute.
pub(crate) trait Attribute: bytemuck::Pod {
    const FORMAT: wgpu::VertexFormat;
}

/// Four signed bytes that shaders read as −1 to 1.
pub(crate) type Snorm8x4 = [i8; 4];

/// Four unsigned bytes that shaders read as 0 to 1.
pub(crate) type Unorm8x4 = [u8; 4];

/// Four unsigned words that shaders read as 0 to 1.
pub(crate) type Unorm16x4 = [u16; 4];

macro_rules! attribute {
    ($type:ty, $format:ident) => {
        impl Attribute for $type {
            const FORMAT: wgpu::VertexFormat = wgpu::VertexFormat::$format;
        }
    };
}
attribute!(f32, Float32);
attribute!(Vec2, Float32x2);
attribute!(Vec3, Float32x3);
attribute!(Vec4, Float32x4);
attribute!(Snorm8x4, Snorm8x4);
attribute!(Unorm8x4, Unorm8x4);
attribute!(Unorm16x4, Unorm16x4);

/// The format of the field that a function borrows.
pub(crate) const fn format_of<T, A: Attribute>(_field: fn(&T) -> &A) -> wgpu::VertexFormat {
    A::FORMAT
}

/// The layout of a buffer of structs: `vertex_layout!(Pin per Instance: 3 => foot, 4 => up)` gives the field `foot` to
/// location 3 of the shader.
macro_rules! vertex_layout {
    ($type:ty, per $step:ident: $($location:literal => $field:ident),+ $(,)?) => {
        wgpu::VertexBufferLayout {
            array_stride: size_of::<$type>() as u64,
            step_mode: wgpu::VertexStepMode::$step,
            attributes: &[$(wgpu::VertexAttribute {
                format: $crate::vertex::format_of(|vertex: &$type| &vertex.$field),
                offset: core::mem::offset_of!($type, $field) as u64,
                shader_location: $location,
            }),+],
        }
    };
}
pub(crate) use vertex_layout;

/// The one attribute of a buffer that holds nothing else, at a location of the shader.
pub(crate) const fn attribute<A: Attribute>(shader_location: u32) -> wgpu::VertexAttribute {
    wgpu::VertexAttribute { format: A::FORMAT, offset: 0, shader_location }
}

/// The layout of a buffer of such attributes.
pub(crate) const fn single<A: Attribute>(
    step_mode: wgpu::VertexStepMode,
    attribute: &[wgpu::VertexAttribute; 1],
) -> wgpu::VertexBufferLayout<'_> {
    wgpu::VertexBufferLayout { array_stride: size_of::<A>() as u64, step_mode, attributes: attribute }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[repr(C)]
    struct Sample {
        place: Vec3,
        tag: f32,
        direction: Snorm8x4,
        axis: Vec4,
    }

    #[test]
    fn formats_and_offsets_are_those_of_the_fields() {
        const LAYOUT: wgpu::VertexBufferLayout<'static> =
            vertex_layout!(Sample, per Instance: 2 => direction, 5 => tag, 3 => axis);
        assert_eq!(LAYOUT.array_stride, size_of::<Sample>() as u64);
        let found: Vec<_> = LAYOUT.attributes.iter().map(|a| (a.shader_location, a.offset, a.format)).collect();
        let expected = [
            (2, 16, wgpu::VertexFormat::Snorm8x4),
            (5, 12, wgpu::VertexFormat::Float32),
            (3, core::mem::offset_of!(Sample, axis) as u64, wgpu::VertexFormat::Float32x4),
        ];
        assert_eq!(found, expected);
    }
}
