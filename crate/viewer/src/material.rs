//! Materials of a file on the device.

use std::collections::HashMap;

use encase::ShaderType;
use glam::{Vec3, Vec4};

use crate::binding::{FILTERED_TEXTURE, fragment_entry, uniform_entry};
use crate::context::Context;
use crate::image::{Image, ImageLoader};
use crate::uniform::Uniform;

/// Textures of a material.
pub const CHANNELS: usize = 5;
/// Whether the images of a channel are colors in sRGB: base color, metalness and roughness, normal, occlusion, emission.
const IS_SRGB: [bool; CHANNELS] = [true, false, false, false, true];
const NORMAL: usize = 2;

/// A material in the metallic-roughness model of glTF 2.0 (3.9).
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Linear RGBA.
    pub base_color: Vec4,
    /// 0 is a dielectric, 1 a metal.
    pub metalness: f32,
    /// 0 is a mirror, 1 is matt.
    pub roughness: f32,
    /// Linear color of the light given off.
    pub emission: Vec3,
    /// Factor on the slope of the normal texture.
    pub normal_scale: f32,
    /// How much of the occlusion texture is applied, 0..1.
    pub occlusion_strength: f32,
    /// Alpha below which nothing is drawn.
    pub cutoff: f32,
    /// What is behind shows through by alpha.
    pub is_blended: bool,
    /// Shown in its base color, whatever the light.
    pub is_unlit: bool,
    /// Seen from behind as well.
    pub is_double_sided: bool,
    /// Base color, metalness (blue) and roughness (green), normal, occlusion (red), emission.
    pub textures: [Option<TextureUse>; CHANNELS],
}

impl Default for Material {
    fn default() -> Self {
        Self {
            base_color: Vec4::ONE,
            metalness: 0.0,
            roughness: 0.6,
            emission: Vec3::ZERO,
            normal_scale: 1.0,
            occlusion_strength: 1.0,
            cutoff: 0.0,
            is_blended: false,
            is_unlit: false,
            is_double_sided: true,
            textures: [None; CHANNELS],
        }
    }
}

/// How a channel of a material uses an image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// Index of the image.
    pub image: usize,
    /// Which set of texture coordinates, 0 or 1.
    pub set: u32,
    /// Rows of the affine map from (u, v, 1) of the vertices to the image.
    pub transform: [Vec3; 2],
    /// Beyond the image along u and v.
    pub wrap: [wgpu::AddressMode; 2],
    /// Whether magnified texels keep sharp edges.
    pub is_sharp: bool,
}

/// `TextureUse` of model.wgsl.
#[derive(Clone, Copy, Debug, ShaderType)]
struct TextureUniform {
    along: Vec4,
    down: Vec4,
}

/// `FileMaterial` of model.wgsl.
#[derive(Clone, Copy, Debug, ShaderType)]
struct MaterialUniform {
    base_color: Vec4,
    emission: Vec3,
    metalness: f32,
    roughness: f32,
    normal_scale: f32,
    occlusion_strength: f32,
    cutoff: f32,
    unlit: f32,
    single_sided: f32,
    textures: [TextureUniform; CHANNELS],
}

impl Material {
    fn uniform(&self) -> MaterialUniform {
        let flag = |is_set| if is_set { 1.0 } else { 0.0 };
        let texture = |texture: Option<TextureUse>| {
            let [along, down] = texture.map_or([Vec3::X, Vec3::Y], |texture| texture.transform);
            TextureUniform {
                along: along.extend(texture.map_or(0.0, |texture| texture.set as f32)),
                down: down.extend(0.0),
            }
        };
        MaterialUniform {
            base_color: self.base_color,
            emission: self.emission,
            metalness: self.metalness,
            roughness: self.roughness,
            normal_scale: self.textures[NORMAL].map_or(0.0, |_| self.normal_scale),
            occlusion_strength: self.occlusion_strength,
            cutoff: self.cutoff,
            unlit: flag(self.is_unlit),
            single_sided: flag(!self.is_double_sided),
            textures: self.textures.map(texture),
        }
    }
}

/// A material that shaders can read.
pub(crate) struct BoundMaterial {
    pub(crate) group: wgpu::BindGroup,
    pub(crate) is_blended: bool,
}

/// The layout of the group of a material.
pub(crate) fn material_layout(context: &Context) -> wgpu::BindGroupLayout {
    let sampling = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let mut entries = vec![uniform_entry(0)];
    for channel in 0..CHANNELS as u32 {
        entries.push(fragment_entry(1 + 2 * channel, FILTERED_TEXTURE));
        entries.push(fragment_entry(2 + 2 * channel, sampling));
    }
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: Some("material layout"), entries: &entries };
    context.device.create_bind_group_layout(&descriptor)
}

/// Binds the materials, and after them the default one.
pub(crate) fn bind_materials(
    context: &Context,
    loader: &ImageLoader,
    layout: &wgpu::BindGroupLayout,
    materials: &[Material],
    images: &[Image],
) -> Vec<BoundMaterial> {
    let mut uploads = Uploads { context, loader, images, views: HashMap::new(), samplers: HashMap::new() };
    materials.iter().chain([&Material::default()]).map(|material| uploads.bind(layout, material)).collect()
}

type SamplerKind = ([wgpu::AddressMode; 2], bool);

/// What materials share: each image is uploaded once a color space.
struct Uploads<'a> {
    context: &'a Context,
    loader: &'a ImageLoader,
    images: &'a [Image],
    views: HashMap<(usize, bool), wgpu::TextureView>,
    samplers: HashMap<SamplerKind, wgpu::Sampler>,
}

impl Uploads<'_> {
    fn bind(&mut self, layout: &wgpu::BindGroupLayout, material: &Material) -> BoundMaterial {
        let uniform: Uniform<MaterialUniform> = Uniform::new(self.context, "material");
        uniform.write(self.context, &material.uniform());
        let textures: Vec<(wgpu::TextureView, wgpu::Sampler)> = material
            .textures
            .iter()
            .zip(IS_SRGB)
            .map(|(texture, is_srgb)| {
                let repeat = [wgpu::AddressMode::Repeat; 2];
                let kind = texture.map_or((repeat, false), |texture| (texture.wrap, texture.is_sharp));
                (self.view(texture.map_or(usize::MAX, |texture| texture.image), is_srgb), self.sampler(kind))
            })
            .collect();
        let mut entries = vec![wgpu::BindGroupEntry { binding: 0, resource: uniform.buffer.as_entire_binding() }];
        for (channel, (view, sampler)) in (0..).zip(&textures) {
            let binding = 1 + 2 * channel;
            entries.push(wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(view) });
            let resource = wgpu::BindingResource::Sampler(sampler);
            entries.push(wgpu::BindGroupEntry { binding: binding + 1, resource });
        }
        let descriptor = wgpu::BindGroupDescriptor { label: Some("material"), layout, entries: &entries };
        let group = self.context.device.create_bind_group(&descriptor);
        BoundMaterial { group, is_blended: material.is_blended }
    }

    fn view(&mut self, image: usize, is_srgb: bool) -> wgpu::TextureView {
        let make = || {
            let image = self.images.get(image).unwrap_or(&Image::Missing);
            let texture = self.loader.texture(self.context, image, is_srgb);
            texture.create_view(&wgpu::TextureViewDescriptor { label: Some("image"), ..Default::default() })
        };
        self.views.entry((image, is_srgb)).or_insert_with(make).clone()
    }

    fn sampler(&mut self, kind: SamplerKind) -> wgpu::Sampler {
        let ([address_mode_u, address_mode_v], is_sharp) = kind;
        let make = || {
            self.context.device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("image sampler"),
                address_mode_u,
                address_mode_v,
                mag_filter: if is_sharp { wgpu::FilterMode::Nearest } else { wgpu::FilterMode::Linear },
                min_filter: wgpu::FilterMode::Linear,
                mipmap_filter: wgpu::MipmapFilterMode::Linear,
                ..Default::default()
            })
        };
        self.samplers.entry(kind).or_insert_with(make).clone()
    }
}
