//! Materials, their textures and images, and the attributes of vertices that these need. What cannot be read is left out:
//! a surface has its distances without.

use std::ops::Range;

use glam::Vec3;
use gltf::json::material::{self, AlphaMode};
use gltf::json::mesh::{Primitive, Semantic};
use gltf::json::texture::{self, MagFilter, WrappingMode};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};
use serde_json::{Map, Value};

use super::accessor::{Accessors, number};
use super::container::Buffers;
use crate::appearance::{Alpha, Appearance, Channel, Image, Material, Run, Texels, Texture, Wrap};
use crate::error::{Error, Result};

/// The accessors of a primitive's attributes: texture coordinates of both sets, colors, normals.
pub fn attributes_of(primitive: &Primitive) -> [Option<u32>; 4] {
    [Semantic::TexCoords(0), Semantic::TexCoords(1), Semantic::Colors(0), Semantic::Normals]
        .map(|semantic| primitive.attributes.get(&Checked::Valid(semantic)).map(|&index| number(index)))
}

/// Collects the appearance of a file's primitives.
#[derive(Default)]
pub struct Collector {
    appearance: Appearance,
}

impl Collector {
    /// Adds texture coordinates and colors of these vertices.
    ///
    /// # Errors
    /// Where the budget has no room for them.
    pub fn add_vertices(&mut self, accessors: Accessors, primitive: &Primitive, vertices: &Range<usize>) -> Result<()> {
        let budget = accessors.buffers.budget;
        let [first_set, second_set, colors, _] = attributes_of(primitive);
        let Range { start: first, .. } = *vertices;
        let count = vertices.len();
        let sets = [first_set, second_set].map(|set| {
            let read = set.and_then(|index| accessors.texcoords(index).ok());
            read.filter(|coordinates| coordinates.len() == count)
        });
        if sets.iter().any(Option::is_some) {
            let at = |set: usize, vertex: usize| sets[set].as_ref().map_or([0.0; 2], |coordinates| coordinates[vertex]);
            budget.resize(&mut self.appearance.texcoords, first, [0.0; 4])?;
            budget.reserve(&mut self.appearance.texcoords, count)?;
            self.appearance.texcoords.extend((0..count).map(|vertex| {
                let ([u, v], [u1, v1]) = (at(0, vertex), at(1, vertex));
                [u, v, u1, v1].map(|coordinate| coordinate as f32)
            }));
        }
        let colors = colors.and_then(|index| accessors.colors(index).ok());
        if let Some(colors) = colors.filter(|colors| colors.len() == count) {
            let wide = |share: f64| (share.clamp(0.0, 1.0) * f64::from(u16::MAX)).round() as u16;
            budget.resize(&mut self.appearance.colors, first, [u16::MAX; 4])?;
            budget.reserve(&mut self.appearance.colors, count)?;
            self.appearance.colors.extend(colors.into_iter().map(|color| color.map(wide)));
        }
        Ok(())
    }

    /// Adds the triangles of a primitive.
    pub fn add_triangles(&mut self, primitive: &Primitive, triangles: Range<usize>) {
        let material = primitive.material.map(|index| index.value());
        self.appearance.runs.push(Run { triangles, material });
    }

    /// What was collected, over so many vertices. `normals`: of each, zero for none.
    ///
    /// # Errors
    /// Where the budget has no room for it.
    pub fn finish<'b>(
        self,
        root: &'b Root,
        buffers: &'b Buffers<'b>,
        vertices: usize,
        normals: Vec<Vec3>,
    ) -> Result<Appearance> {
        let mut appearance = self.appearance;
        if normals.iter().any(|&normal| normal != Vec3::ZERO) {
            appearance.normals = normals;
        }
        if !appearance.texcoords.is_empty() {
            buffers.budget.resize(&mut appearance.texcoords, vertices, [0.0; 4])?;
        }
        if !appearance.colors.is_empty() {
            buffers.budget.resize(&mut appearance.colors, vertices, [u16::MAX; 4])?;
        }
        if appearance.runs.iter().all(|run| run.material.is_none()) {
            appearance.runs.clear();
            appearance.texcoords.clear();
            return Ok(appearance);
        }
        let mut images =
            Images { root, buffers, of_file: vec![None; root.images.len()], images: Vec::new(), missing: Vec::new() };
        appearance.materials = root.materials.iter().map(|material| read_material(material, &mut images)).collect();
        (appearance.images, appearance.missing) = (images.images, images.missing);
        let count = appearance.materials.len();
        for run in &mut appearance.runs {
            run.material = run.material.filter(|&material| material < count);
        }
        Ok(appearance)
    }
}

const UNLIT: &str = "KHR_materials_unlit";
const EMISSIVE_STRENGTH: &str = "KHR_materials_emissive_strength";
const SPECULAR_GLOSSINESS: &str = "KHR_materials_pbrSpecularGlossiness";

/// Extensions of materials that are shown.
const UNDERSTOOD: [&str; 3] = [UNLIT, EMISSIVE_STRENGTH, SPECULAR_GLOSSINESS];

fn read_material(given: &material::Material, images: &mut Images) -> Material {
    let pbr = &given.pbr_metallic_roughness;
    let extensions = given.extensions.as_ref().map(|extensions| &extensions.others);
    let extension = |name: &str| extensions.and_then(|others| others.get(name));
    let mut material = Material {
        base_color: pbr.base_color_factor.0,
        metalness: pbr.metallic_factor.0,
        roughness: pbr.roughness_factor.0,
        is_unlit: extension(UNLIT).is_some(),
        is_double_sided: given.double_sided,
        alpha: match given.alpha_mode {
            Checked::Valid(AlphaMode::Mask) => Alpha::Mask(given.alpha_cutoff.unwrap_or_default().0),
            Checked::Valid(AlphaMode::Blend) => Alpha::Blend,
            _ => Alpha::Opaque,
        },
        ..Material::default()
    };
    let strength = extension(EMISSIVE_STRENGTH).and_then(|strength| strength.get("emissiveStrength")?.as_f64());
    material.emission = given.emissive_factor.0.map(|color| color * strength.unwrap_or(1.0) as f32);
    let mut set = |channel: Channel, texture| material.textures[channel as usize] = texture;
    set(Channel::BaseColor, images.texture_of_info(pbr.base_color_texture.as_ref()));
    set(Channel::MetallicRoughness, images.texture_of_info(pbr.metallic_roughness_texture.as_ref()));
    set(Channel::Emission, images.texture_of_info(given.emissive_texture.as_ref()));
    if let Some(normal) = &given.normal_texture {
        let others = normal.extensions.as_ref().map(|extensions| &extensions.others);
        set(Channel::Normal, images.texture(normal.index, normal.tex_coord, others));
    }
    if let Some(occlusion) = &given.occlusion_texture {
        let others = occlusion.extensions.as_ref().map(|extensions| &extensions.others);
        set(Channel::Occlusion, images.texture(occlusion.index, occlusion.tex_coord, others));
    }
    material.normal_scale = given.normal_texture.as_ref().map_or(1.0, |normal| normal.scale);
    material.occlusion_strength = given.occlusion_texture.as_ref().map_or(1.0, |occlusion| occlusion.strength.0);
    material.further = extensions.map(further).unwrap_or_default();
    if let Some(extension) = extension(SPECULAR_GLOSSINESS) {
        read_specular_glossiness(extension, images, &mut material);
    }
    material
}

/// Extensions of a material that are not understood here, of which nothing but numbers is kept: a texture would be another one elsewhere.
fn further(extensions: &Map<String, Value>) -> Vec<(String, String)> {
    let is_further = |name: &str| name.starts_with("KHR_materials_") && !UNDERSTOOD.contains(&name);
    let has_texture =
        |value: &Value| value.as_object().is_none_or(|keys| keys.keys().any(|key| key.ends_with("Texture")));
    extensions
        .iter()
        .filter(|&(name, value)| is_further(name) && !has_texture(value))
        .map(|(name, value)| (name.clone(), value.to_string()))
        .collect()
}

/// The older model: its diffuse color is the base color of a dielectric, whose specular color is taken as usual.
fn read_specular_glossiness(extension: &Value, images: &mut Images, material: &mut Material) {
    let diffuse = extension.get("diffuseFactor").and_then(Value::as_array);
    let factor = |index: usize| diffuse.and_then(|factors| factors.get(index)?.as_f64()).unwrap_or(1.0) as f32;
    material.base_color = [0, 1, 2, 3].map(factor);
    material.metalness = 0.0;
    material.roughness = 1.0 - extension.get("glossinessFactor").and_then(Value::as_f64).unwrap_or(1.0) as f32;
    let info = extension.get("diffuseTexture").cloned();
    let info: Option<texture::Info> = info.and_then(|info| serde_json::from_value(info).ok());
    material.textures[Channel::BaseColor as usize] = images.texture_of_info(info.as_ref());
    material.textures[Channel::MetallicRoughness as usize] = None;
}

/// The images that materials use, each once.
struct Images<'a> {
    root: &'a Root,
    buffers: &'a Buffers<'a>,
    /// For each image of the file, its place among those in use.
    of_file: Vec<Option<usize>>,
    images: Vec<Image>,
    missing: Vec<String>,
}

impl Images<'_> {
    fn texture_of_info(&mut self, info: Option<&texture::Info>) -> Option<Texture> {
        let info = info?;
        self.texture(info.index, info.tex_coord, info.extensions.as_ref().map(|extensions| &extensions.others))
    }

    fn texture(
        &mut self,
        index: Index<texture::Texture>,
        set: u32,
        extensions: Option<&Map<String, Value>>,
    ) -> Option<Texture> {
        let texture = self.root.textures.get(index.value())?;
        let source = |name: &str| {
            let source = texture.extensions.as_ref()?.others.get(name)?.get("source")?.as_u64();
            source.and_then(|source| usize::try_from(source).ok())
        };
        // A browser decodes the others by itself.
        let plain = Some(texture.source.value()).filter(|&source| source < self.root.images.len());
        let image = self.image(source("EXT_texture_webp").or(plain).or(source("KHR_texture_basisu"))?)?;
        let sampler = texture.sampler.and_then(|index| self.root.samplers.get(index.value()));
        let wrap = |mode: Checked<WrappingMode>| match mode {
            Checked::Valid(WrappingMode::ClampToEdge) => Wrap::Clamp,
            Checked::Valid(WrappingMode::MirroredRepeat) => Wrap::Mirror,
            _ => Wrap::Repeat,
        };
        let transform = extensions.and_then(|others| others.get("KHR_texture_transform"));
        let set = transform.and_then(|transform| transform.get("texCoord")?.as_u64()).unwrap_or(set.into());
        Some(Texture {
            image,
            set: usize::from(set == 1),
            transform: transform.map_or(Texture::IDENTITY, texture_transform),
            wrap: sampler.map_or([Wrap::Repeat; 2], |sampler| [wrap(sampler.wrap_s), wrap(sampler.wrap_t)]),
            is_sharp: sampler
                .is_some_and(|sampler| matches!(sampler.mag_filter, Some(Checked::Valid(MagFilter::Nearest)))),
        })
    }

    /// The place of an image of the file among those in use.
    fn image(&mut self, source: usize) -> Option<usize> {
        if let Some(place) = *self.of_file.get(source)? {
            return Some(place);
        }
        let image = &self.root.images[source];
        let media_type = image.mime_type.as_ref().map_or_else(String::new, |media_type| media_type.0.clone());
        let bytes = match (image.buffer_view, &image.uri) {
            (Some(view), _) => self.buffers.copy(view),
            (None, Some(uri)) => self.buffers.fetch(uri, || format!("image {source}")),
            (None, None) => Ok(Vec::new()),
        };
        let name = image.uri.as_deref().filter(|uri| !uri.starts_with("data:")).or(image.name.as_deref());
        let name = name.unwrap_or_default().to_owned();
        if let Err(Error::MissingResource { uri }) = &bytes {
            self.missing.push(uri.clone());
        }
        self.images.push(Image { name, media_type, bytes: bytes.unwrap_or_default(), texels: Texels::Encoded });
        self.of_file[source] = Some(self.images.len() - 1);
        self.of_file[source]
    }
}

/// Rows of offset · rotation · scale (KHR_texture_transform).
fn texture_transform(extension: &Value) -> [[f32; 3]; 2] {
    let number = |place: &str, default: f64| extension.pointer(place).and_then(Value::as_f64).unwrap_or(default);
    let [x, y] = ["/offset/0", "/offset/1"].map(|place| number(place, 0.0));
    let [u, v] = ["/scale/0", "/scale/1"].map(|place| number(place, 1.0));
    let (sine, cosine) = number("/rotation", 0.0).sin_cos();
    [[cosine * u, sine * v, x], [-sine * u, cosine * v, y]].map(|row| row.map(|number| number as f32))
}
