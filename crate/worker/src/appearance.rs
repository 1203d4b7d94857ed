//! What the page gets of materials and images.

use heatwalk_bindings::Message;
use heatwalk_model::appearance::{self, Alpha, Texels, Wrap};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::JsValue;

/// A material in the metallic-roughness model of glTF 2.0.
#[derive(Message)]
pub struct Material {
    /// Linear red, green, blue and alpha.
    pub base_color: Vec<f32>,
    /// 0 is a dielectric, 1 a metal.
    pub metalness: f32,
    /// 0 is a mirror, 1 is matt.
    pub roughness: f32,
    /// Linear red, green and blue of the light given off.
    pub emission: Vec<f32>,
    /// Factor on the slope of the normal texture.
    pub normal_scale: f32,
    /// How much of the occlusion texture is applied, 0 to 1.
    pub occlusion_strength: f32,
    /// What alpha means.
    #[typescript("'opaque' | 'mask' | 'blend'")]
    pub alpha: &'static str,
    /// Alpha below which a mask shows nothing.
    pub cutoff: f32,
    /// Shown in its base color, whatever the light.
    pub unlit: bool,
    /// Seen from behind as well.
    pub double_sided: bool,
    /// Of base color, metalness and roughness, normal, occlusion and emission; null where a channel has none.
    #[typescript("(Texture | null)[]")]
    pub textures: Array,
}

impl Material {
    pub(crate) fn new(material: &appearance::Material) -> Self {
        let (alpha, cutoff) = match material.alpha {
            Alpha::Opaque => ("opaque", 0.0),
            Alpha::Mask(cutoff) => ("mask", cutoff),
            Alpha::Blend => ("blend", 0.0),
        };
        let texture = |texture: &Option<_>| texture.as_ref().map_or(JsValue::NULL, |own| Texture::new(own).into());
        Self {
            base_color: material.base_color.to_vec(),
            metalness: material.metalness,
            roughness: material.roughness,
            emission: material.emission.to_vec(),
            normal_scale: material.normal_scale,
            occlusion_strength: material.occlusion_strength,
            alpha,
            cutoff,
            unlit: material.is_unlit,
            double_sided: material.is_double_sided,
            textures: material.textures.iter().map(texture).collect(),
        }
    }
}

/// How a channel of a material uses an image.
#[derive(Message)]
pub struct Texture {
    /// Index of the image.
    pub image: usize,
    /// Which set of texture coordinates, 0 or 1.
    pub set: usize,
    /// Two rows of three: the affine map from (u, v, 1) of the vertices to the image.
    pub transform: Vec<f32>,
    /// What is beyond the image along u.
    #[typescript("'repeat' | 'mirror' | 'clamp'")]
    pub wrap_u: &'static str,
    /// What is beyond the image along v.
    #[typescript("'repeat' | 'mirror' | 'clamp'")]
    pub wrap_v: &'static str,
    /// Whether magnified texels keep sharp edges.
    pub sharp: bool,
}

impl Texture {
    fn new(texture: &appearance::Texture) -> Self {
        let [wrap_u, wrap_v] = texture.wrap.map(|wrap| match wrap {
            Wrap::Repeat => "repeat",
            Wrap::Mirror => "mirror",
            Wrap::Clamp => "clamp",
        });
        Self {
            image: texture.image,
            set: texture.set,
            transform: texture.transform.as_flattened().to_vec(),
            wrap_u,
            wrap_v,
            sharp: texture.is_sharp,
        }
    }
}

/// An image, encoded as in the file, or made of such.
#[derive(Message)]
pub struct EncodedImage {
    /// What the file calls it; empty where it does not say.
    pub name: String,
    /// `image/png`; empty where the file does not say.
    pub media_type: String,
    /// Empty where the image could not be found, or is made of others.
    pub bytes: Uint8Array,
    /// Whether shades of gray are heights, in place of which their normals are wanted.
    pub may_be_heights: bool,
    /// 4 × 2: for red, green, blue and alpha the index of an image and its channel, −1 for a channel of 1; empty for an image
    /// that is not made of others.
    pub channels: Vec<i32>,
}

impl EncodedImage {
    pub(crate) fn new(image: &appearance::Image) -> Self {
        let pair = |channel: Option<(usize, usize)>| channel.map_or([-1; 2], |(image, own)| [image as i32, own as i32]);
        Self {
            name: image.name.clone(),
            media_type: image.media_type.clone(),
            bytes: image.bytes.as_slice().into(),
            may_be_heights: image.texels == Texels::Heights,
            channels: match image.texels {
                Texels::Channels(channels) => channels.map(pair).as_flattened().to_vec(),
                _ => Vec::new(),
            },
        }
    }
}
