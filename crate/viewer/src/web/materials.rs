//! Materials and images of a file, from the page's objects.

use glam::{Vec3, Vec4};
use js_sys::{Array, Float32Array};
use wasm_bindgen::prelude::*;
use web_sys::ImageBitmap;

use super::properties::properties;
use crate::error::Error;
use crate::image::Image;
use crate::material::{CHANNELS, Material, TextureUse};

#[wasm_bindgen(typescript_custom_section)]
const MATERIALS: &str = "
/** A material in the metallic-roughness model of glTF 2.0. */
export interface DrawnMaterial {
  /** Linear red, green, blue and alpha. */
  baseColor: Float32Array;
  metalness: number;
  roughness: number;
  /** Linear red, green and blue. */
  emission: Float32Array;
  normalScale: number;
  occlusionStrength: number;
  alpha: 'opaque' | 'mask' | 'blend';
  /** Alpha below which a mask shows nothing. */
  cutoff: number;
  unlit: boolean;
  doubleSided: boolean;
  /** Of base color, metalness and roughness, normal, occlusion and emission. */
  textures: (DrawnTexture | null)[];
}

/** How a channel of a material uses an image. */
export interface DrawnTexture {
  image: number;
  /** Which set of texture coordinates, 0 or 1. */
  set: number;
  /** Two rows of three. */
  transform: Float32Array;
  wrapU: 'repeat' | 'mirror' | 'clamp';
  wrapV: 'repeat' | 'mirror' | 'clamp';
  sharp: boolean;
}
";

#[wasm_bindgen]
extern "C" {
    /// A material as an object of JavaScript's.
    #[wasm_bindgen(typescript_type = "DrawnMaterial")]
    pub type DrawnMaterial;

    /// A texture as an object of JavaScript's.
    #[wasm_bindgen(typescript_type = "DrawnTexture")]
    type DrawnTexture;
}

properties! {
    DrawnMaterial {
        base_color as baseColor: Float32Array,
        metalness: f32,
        roughness: f32,
        emission: Float32Array,
        normal_scale as normalScale: f32,
        occlusion_strength as occlusionStrength: f32,
        alpha: String,
        cutoff: f32,
        unlit: bool,
        double_sided as doubleSided: bool,
        textures: Array,
    }
}

properties! {
    DrawnTexture {
        image: u32,
        set: u32,
        transform: Float32Array,
        wrap_u as wrapU: String,
        wrap_v as wrapV: String,
        sharp: bool,
    }
}

fn numbers<const N: usize>(what: &'static str, array: &Float32Array) -> Result<[f32; N], Error> {
    let found = array.length() as usize;
    array.to_vec().try_into().map_err(|_| Error::WrongLength { what, expected: N, found })
}

pub(super) fn material(given: &DrawnMaterial) -> Result<Material, Error> {
    let mut textures = [None; CHANNELS];
    for (texture, channel) in given.textures().iter().zip(&mut textures) {
        if !texture.is_null() {
            *channel = Some(texture_use(texture.unchecked_ref())?);
        }
    }
    let alpha = given.alpha();
    Ok(Material {
        base_color: Vec4::from_array(numbers("base color", &given.base_color())?),
        metalness: given.metalness(),
        roughness: given.roughness(),
        emission: Vec3::from_array(numbers("emission", &given.emission())?),
        normal_scale: given.normal_scale(),
        occlusion_strength: given.occlusion_strength(),
        cutoff: if alpha == "mask" { given.cutoff() } else { 0.0 },
        is_blended: alpha == "blend",
        is_unlit: given.unlit(),
        is_double_sided: given.double_sided(),
        textures,
    })
}

fn texture_use(given: &DrawnTexture) -> Result<TextureUse, Error> {
    let wrap = |name: String| match name.as_str() {
        "clamp" => wgpu::AddressMode::ClampToEdge,
        "mirror" => wgpu::AddressMode::MirrorRepeat,
        _ => wgpu::AddressMode::Repeat,
    };
    let [a, b, c, d, e, f] = numbers("texture transform", &given.transform())?;
    Ok(TextureUse {
        image: given.image() as usize,
        set: given.set(),
        transform: [Vec3::new(a, b, c), Vec3::new(d, e, f)],
        wrap: [wrap(given.wrap_u()), wrap(given.wrap_v())],
        is_sharp: given.sharp(),
    })
}

pub(super) fn image(given: JsValue) -> Image {
    given.dyn_into::<ImageBitmap>().map_or(Image::Missing, Image::Bitmap)
}
