//! Materials of the MTL format (Wavefront Technologies, Advanced Visualizer manual, chapter 5), with the statements for physically
//! based rendering that Burley's model brought (`Pr`, `Pm`, `norm`), in the metallic-roughness model.

use std::rc::Rc;

use super::texture::{Images, Map};
use crate::appearance::{Alpha, Channel, Material, Texels};
use crate::io::color::light;
use crate::io::reader::numbers;

/// Alpha from which on a texture with holes is solid.
const CUTOFF: f32 = 0.5;

/// What a library says of a material.
pub struct Definition {
    /// Of the library, with its last slash.
    folder: Rc<str>,
    diffuse: Option<[f32; 3]>,
    specular: Option<[f32; 3]>,
    emission: Option<[f32; 3]>,
    /// Of Phong's model.
    exponent: f32,
    opacity: Option<f32>,
    transparency: Option<f32>,
    illumination: Option<f32>,
    roughness: Option<f32>,
    metalness: Option<f32>,
    diffuse_map: Option<Map>,
    opacity_map: Option<Map>,
    emission_map: Option<Map>,
    roughness_map: Option<Map>,
    metalness_map: Option<Map>,
    normal_map: Option<Map>,
    bump_map: Option<Map>,
}

impl Definition {
    /// Of a library in a folder.
    pub fn new(folder: Rc<str>) -> Self {
        Self {
            folder,
            diffuse: None,
            specular: None,
            emission: None,
            exponent: 0.0,
            opacity: None,
            transparency: None,
            illumination: None,
            roughness: None,
            metalness: None,
            diffuse_map: None,
            opacity_map: None,
            emission_map: None,
            roughness_map: None,
            metalness_map: None,
            normal_map: None,
            bump_map: None,
        }
    }

    /// Adds a statement; `keyword` is in lower case.
    pub fn add(&mut self, keyword: &str, arguments: &str) {
        match keyword {
            "kd" => self.diffuse = color(arguments),
            "ks" => self.specular = color(arguments),
            "ke" => self.emission = color(arguments),
            "ns" => self.exponent = number(arguments).unwrap_or(0.0),
            "d" => self.opacity = number(arguments.trim_start().trim_start_matches("-halo")),
            "tr" => self.transparency = number(arguments),
            "illum" => self.illumination = number(arguments),
            "pr" => self.roughness = number(arguments),
            "pm" => self.metalness = number(arguments),
            "map_kd" => self.diffuse_map = Map::parse(arguments),
            "map_d" => self.opacity_map = Map::parse(arguments),
            "map_ke" => self.emission_map = Map::parse(arguments),
            "map_pr" => self.roughness_map = Map::parse(arguments),
            "map_pm" => self.metalness_map = Map::parse(arguments),
            "norm" | "map_norm" | "map_kn" => self.normal_map = Map::parse(arguments),
            "bump" | "map_bump" => self.bump_map = Map::parse(arguments),
            _ => {}
        }
    }

    /// The material, its images among `images`.
    pub fn material(&self, images: &mut Images) -> Material {
        // Some programs write black where a texture has the color, or the light.
        let factor = |color: Option<[f32; 3]>, map: &Option<Map>, default: f32| match (color, map) {
            (Some(color), None) => color,
            (Some(color), _) if color != [0.0; 3] => color,
            (_, Some(_)) => [1.0; 3],
            (_, None) => [default; 3],
        };
        let [red, green, blue] = factor(self.diffuse, &self.diffuse_map, 1.0).map(linear);
        let opacity = self.opacity.or(self.transparency.map(|share| 1.0 - share)).unwrap_or(1.0).clamp(0.0, 1.0);
        let is_given = |number: Option<f32>, map: &Option<Map>| number.or(map.as_ref().map(|_| 1.0));
        let mut material = Material {
            base_color: [red, green, blue, opacity],
            metalness: is_given(self.metalness, &self.metalness_map).unwrap_or(0.0).clamp(0.0, 1.0),
            roughness: is_given(self.roughness, &self.roughness_map)
                .map_or_else(|| self.gloss(), |r| r.clamp(0.0, 1.0)),
            emission: factor(self.emission, &self.emission_map, 0.0).map(linear),
            alpha: if opacity < 1.0 { Alpha::Blend } else { Alpha::Opaque },
            is_unlit: self.illumination == Some(0.0),
            is_double_sided: true,
            ..Material::default()
        };
        self.add_textures(&mut material, images);
        material
    }

    /// The roughness at which a microfacet highlight is as wide as Phong's: its exponent is 2/roughness⁴ − 2 (Karis,
    /// "Specular BRDF Reference", 2013). Without a highlight, a surface is matt.
    fn gloss(&self) -> f32 {
        let is_matt = self.specular == Some([0.0; 3]) || self.illumination.is_some_and(|model| model < 2.0);
        if is_matt { 1.0 } else { (2.0 / (self.exponent.max(0.0) + 2.0)).powf(0.25) }
    }

    fn add_textures(&self, material: &mut Material, images: &mut Images) {
        let folder = &self.folder;
        let mut set =
            |channel: Channel, map: &Map, image| material.textures[channel as usize] = Some(map.texture(image));
        match (&self.diffuse_map, &self.opacity_map) {
            (Some(color), None) => set(Channel::BaseColor, color, images.of(folder, color, Texels::Encoded)),
            // The alpha of the color image itself is what cuts it out.
            (Some(color), Some(opacity)) if color.is_of_file(opacity) => {
                set(Channel::BaseColor, color, images.of(folder, color, Texels::Encoded));
                material.alpha = Alpha::Mask(CUTOFF);
            }
            (color, Some(opacity)) => {
                let color_channel = |channel| color.as_ref().map(|color| (color, Some(channel)));
                let [red, green, blue] = [0, 1, 2].map(color_channel);
                let image = images.of_channels(folder, [red, green, blue, Some((opacity, None))]);
                set(Channel::BaseColor, color.as_ref().unwrap_or(opacity), image);
                material.alpha = Alpha::Mask(CUTOFF);
            }
            (None, None) => {}
        }
        let mut set =
            |channel: Channel, map: &Map, image| material.textures[channel as usize] = Some(map.texture(image));
        match (&self.roughness_map, &self.metalness_map) {
            // One image for both has them where glTF has them.
            (Some(roughness), Some(metalness)) if roughness.is_of_file(metalness) => {
                set(Channel::MetallicRoughness, roughness, images.of(folder, roughness, Texels::Encoded));
            }
            (None, None) => {}
            (roughness, metalness) => {
                let [green, blue] = [roughness, metalness].map(|map| map.as_ref().map(|map| (map, None)));
                let image = images.of_channels(folder, [None, green, blue, None]);
                if let Some(map) = roughness.as_ref().or(metalness.as_ref()) {
                    set(Channel::MetallicRoughness, map, image);
                }
            }
        }
        if let Some(map) = &self.emission_map {
            let image = images.of(folder, map, Texels::Encoded);
            set(Channel::Emission, map, image);
            // All of the surface would give off light in place of what the image lights.
            if images.images[image].bytes.is_empty() {
                material.emission = self.emission.unwrap_or_default().map(linear);
            }
        }
        if let Some((map, texels)) = self
            .normal_map
            .as_ref()
            .map(|map| (map, Texels::Encoded))
            .or(self.bump_map.as_ref().map(|map| (map, Texels::Heights)))
        {
            set(Channel::Normal, map, images.of(folder, map, texels));
            material.normal_scale = map.bump;
        }
    }
}

/// Red, green and blue; one number is for all of them. None where a curve of a spectrum or another color space is named.
fn color(arguments: &str) -> Option<[f32; 3]> {
    let first = number(arguments)?;
    let is_single = arguments.split_whitespace().nth(1).is_none();
    Some(if is_single { [first; 3] } else { numbers(arguments) }.map(|channel| channel.max(0.0)))
}

fn number(arguments: &str) -> Option<f32> {
    arguments.split_whitespace().next()?.parse().ok().filter(|number: &f32| number.is_finite())
}

/// Colors of the format are as displays take them; what is brighter than these stays as it is.
fn linear(channel: f32) -> f32 {
    if channel > 1.0 { channel } else { light(channel.into()) as f32 }
}
