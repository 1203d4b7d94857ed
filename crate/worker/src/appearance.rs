//! What the page gets of materials and images.

use heatwalk::surface::appearance::{self, Alpha, Texels, Wrap};
use js_sys::{Array, Float32Array, Int32Array, Uint8Array};
use wasm_bindgen::prelude::*;

/// The types of what has none in Rust.
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = "
/** How a channel of a material uses an image. */
export interface Texture {
  /** Index of the image. */
  image: number;
  /** Which set of texture coordinates, 0 or 1. */
  set: number;
  /** Two rows of three: the affine map from (u, v, 1) of the vertices to the image. */
  transform: Float32Array;
  /** Beyond the image along u. */
  wrapU: Wrap;
  /** Beyond the image along v. */
  wrapV: Wrap;
  /** Whether magnified texels keep sharp edges. */
  sharp: boolean;
}

/** What is beyond an image. */
export type Wrap = 'repeat' | 'mirror' | 'clamp';

/** What alpha means. */
export type Alpha = 'opaque' | 'mask' | 'blend';
";

/// A material in the metallic-roughness model of glTF 2.0.
#[wasm_bindgen(inspectable)]
pub struct Material(appearance::Material);

impl Material {
    pub(crate) fn new(material: &appearance::Material) -> Self {
        Self(material.clone())
    }
}

#[wasm_bindgen]
impl Material {
    /// Linear red, green, blue and alpha.
    #[wasm_bindgen(getter, js_name = baseColor)]
    pub fn base_color(&self) -> Float32Array {
        self.0.base_color.as_slice().into()
    }

    /// 0 is a dielectric, 1 a metal.
    #[wasm_bindgen(getter)]
    pub fn metalness(&self) -> f32 {
        self.0.metalness
    }

    /// 0 is a mirror, 1 is matt.
    #[wasm_bindgen(getter)]
    pub fn roughness(&self) -> f32 {
        self.0.roughness
    }

    /// Linear red, green and blue of the light given off.
    #[wasm_bindgen(getter)]
    pub fn emission(&self) -> Float32Array {
        self.0.emission.as_slice().into()
    }

    /// Factor on the slope of the normal texture.
    #[wasm_bindgen(getter, js_name = normalScale)]
    pub fn normal_scale(&self) -> f32 {
        self.0.normal_scale
    }

    /// How much of the occlusion texture is applied, 0 to 1.
    #[wasm_bindgen(getter, js_name = occlusionStrength)]
    pub fn occlusion_strength(&self) -> f32 {
        self.0.occlusion_strength
    }

    /// What alpha means.
    #[wasm_bindgen(getter, unchecked_return_type = "Alpha")]
    pub fn alpha(&self) -> String {
        match self.0.alpha {
            Alpha::Opaque => "opaque",
            Alpha::Mask(_) => "mask",
            Alpha::Blend => "blend",
        }
        .to_owned()
    }

    /// Alpha below which a mask shows nothing.
    #[wasm_bindgen(getter)]
    pub fn cutoff(&self) -> f32 {
        if let Alpha::Mask(cutoff) = self.0.alpha { cutoff } else { 0.0 }
    }

    /// Shown in its base color, whatever the light.
    #[wasm_bindgen(getter)]
    pub fn unlit(&self) -> bool {
        self.0.is_unlit
    }

    /// Seen from behind as well.
    #[wasm_bindgen(getter, js_name = doubleSided)]
    pub fn is_double_sided(&self) -> bool {
        self.0.is_double_sided
    }

    /// Of base color, metalness and roughness, normal, occlusion and emission; null where a channel has none.
    #[wasm_bindgen(getter, unchecked_return_type = "(Texture | null)[]")]
    pub fn textures(&self) -> Array {
        self.0.textures.iter().map(|texture| texture.as_ref().map_or(JsValue::NULL, plain_texture)).collect()
    }
}

fn plain_texture(texture: &appearance::Texture) -> JsValue {
    let wrap = |wrap| match wrap {
        Wrap::Repeat => "repeat",
        Wrap::Mirror => "mirror",
        Wrap::Clamp => "clamp",
    };
    let object = js_sys::Object::new();
    let set = |key: &str, value: JsValue| {
        // Setting a property of a plain object cannot fail.
        let _ = js_sys::Reflect::set(&object, &key.into(), &value);
    };
    set("image", (texture.image as u32).into());
    set("set", (texture.set as u32).into());
    set("transform", Float32Array::from(texture.transform.as_flattened()).into());
    set("wrapU", wrap(texture.wrap[0]).into());
    set("wrapV", wrap(texture.wrap[1]).into());
    set("sharp", texture.is_sharp.into());
    object.into()
}

/// An image, encoded as in the file, or made of such.
#[wasm_bindgen(inspectable)]
pub struct EncodedImage(appearance::Image);

impl EncodedImage {
    pub(crate) fn new(image: &appearance::Image) -> Self {
        Self(image.clone())
    }
}

#[wasm_bindgen]
impl EncodedImage {
    /// What the file calls it; empty where it does not say.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.0.name.clone()
    }

    /// `image/png`; empty where the file does not say.
    #[wasm_bindgen(getter, js_name = mediaType)]
    pub fn media_type(&self) -> String {
        self.0.media_type.clone()
    }

    /// Empty where the image could not be found, or is made of others.
    #[wasm_bindgen(getter)]
    pub fn bytes(&self) -> Uint8Array {
        self.0.bytes.as_slice().into()
    }

    /// Whether shades of gray are heights, in place of which their normals are wanted.
    #[wasm_bindgen(getter, js_name = mayBeHeights)]
    pub fn may_be_heights(&self) -> bool {
        self.0.texels == Texels::Heights
    }

    /// 4 × 2: for red, green, blue and alpha the index of an image and its channel, −1 for a channel of 1; empty for an image
    /// that is not made of others.
    #[wasm_bindgen(getter)]
    pub fn channels(&self) -> Int32Array {
        let Texels::Channels(channels) = self.0.texels else { return Int32Array::new_with_length(0) };
        let pair = |channel: (usize, usize)| [channel.0 as i32, channel.1 as i32];
        let pairs = channels.map(|channel| channel.map_or([-1; 2], pair));
        Int32Array::from(pairs.as_flattened())
    }
}
