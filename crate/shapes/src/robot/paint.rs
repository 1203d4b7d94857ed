//! What is painted on the robot.

use heatwalk_model::appearance::{Channel, Image, Material, Texture, Wrap};

use super::png;

/// Texels along a side.
const SIZE: u32 = 256;

/// What covers a place: sRGB color, roughness and metalness, 255 for 1.
#[derive(Clone, Copy)]
struct Coat {
    color: [u8; 3],
    roughness: u8,
    metalness: u8,
}

const fn paint(color: [u8; 3], roughness: u8) -> Coat {
    Coat { color, roughness, metalness: 0 }
}

const TEAL: Coat = paint([38, 148, 160], 89);
const GLASS: Coat = paint([24, 34, 40], 25);
const SEAM: Coat = paint([24, 34, 40], 217);
const STEEL: Coat = Coat { color: [180, 176, 168], roughness: 77, metalness: 255 };
const BLACK: Coat = paint([24, 34, 40], 191);
const YELLOW: Coat = paint([240, 190, 60], 191);
const CREAM: Coat = paint([231, 214, 178], 102);
const RED: Coat = paint([196, 66, 52], 64);

/// A material in the images of a picture: its colors, and after these its roughness and metalness.
pub fn textured(picture: usize) -> Material {
    let mut material = Material::default();
    for (channel, image) in [(Channel::BaseColor, 2 * picture), (Channel::MetallicRoughness, 2 * picture + 1)] {
        material.textures[channel as usize] =
            Some(Texture { image, set: 0, transform: Texture::IDENTITY, wrap: [Wrap::Clamp; 2], is_sharp: false });
    }
    material
}

/// A panel with rivets of steel above a matt warning stripe.
pub fn chest() -> [Image; 2] {
    images(|u, v| {
        let is_panel = near(u, 0.5, 0.40) && near(v, 0.42, 0.34);
        let is_seam = is_panel && !(near(u, 0.5, 0.385) && near(v, 0.42, 0.325));
        let is_rivet = [0.15, 0.85].iter().any(|&x| [0.13, 0.42, 0.71].iter().any(|&y| (u - x).hypot(v - y) < 0.018));
        if is_rivet {
            STEEL
        } else if is_seam {
            SEAM
        } else if near(v, 0.87, 0.055) && near(u, 0.5, 0.45) {
            if (6.0 * (u + v)).rem_euclid(1.0) < 0.5 { BLACK } else { YELLOW }
        } else {
            TEAL
        }
    })
}

/// A visor of dark glass, cheeks and a stripe over the top.
pub fn face() -> [Image; 2] {
    images(|u, v| {
        let is_cheek = [0.16, 0.84].iter().any(|&x| (u - x).hypot(v - 0.66) < 0.05);
        if near(v, 0.39, 0.17) {
            GLASS
        } else if is_cheek || near(u, 0.5, 0.06) && v < 0.18 {
            RED
        } else {
            CREAM
        }
    })
}

/// The colors of a picture; its roughness in green and its metalness in blue.
fn images(coat: impl Fn(f32, f32) -> Coat) -> [Image; 2] {
    [image(|u, v| coat(u, v).color), image(|u, v| [0, coat(u, v).roughness, coat(u, v).metalness])]
}

fn near(value: f32, middle: f32, reach: f32) -> bool {
    (value - middle).abs() < reach
}

/// Each texel is the mean of four samples at shares of width and height.
fn image(sample: impl Fn(f32, f32) -> [u8; 3]) -> Image {
    let texel = |column: u32, row: u32| -> [u8; 3] {
        let at = |number: u32, part: f32| (number as f32 + part) / SIZE as f32;
        let samples = [0.25, 0.75].map(|x| [0.25, 0.75].map(|y| sample(at(column, x), at(row, y))));
        std::array::from_fn(|channel| {
            let sum: u16 = samples.as_flattened().iter().map(|sample| u16::from(sample[channel])).sum();
            (sum / 4) as u8
        })
    };
    let texels = (0..SIZE).flat_map(|row| (0..SIZE).map(move |column| (column, row)));
    let texels: Vec<u8> = texels.flat_map(|(column, row)| texel(column, row)).collect();
    Image { media_type: "image/png".to_owned(), bytes: png::encode(SIZE, &texels), ..Image::default() }
}
