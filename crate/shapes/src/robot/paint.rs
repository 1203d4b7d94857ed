//! What is painted on the robot.

use heatwalk_surface::appearance::{Channel, Image, Material, Texture, Wrap};

use super::png;

/// Texels along a side.
const SIZE: u32 = 256;

type Color = [u8; 3];

const TEAL: Color = [38, 148, 160];
const DARK: Color = [24, 34, 40];
const YELLOW: Color = [240, 190, 60];
const CREAM: Color = [231, 214, 178];
const RED: Color = [196, 66, 52];

/// A material with one of the images.
pub fn textured(image: usize, roughness: f32) -> Material {
    let mut material = Material { metalness: 0.0, roughness, ..Material::default() };
    material.textures[Channel::BaseColor as usize] =
        Some(Texture { image, set: 0, transform: Texture::IDENTITY, wrap: [Wrap::Clamp; 2], is_sharp: false });
    material
}

/// A panel with rivets above a warning stripe.
pub fn chest() -> Image {
    image(|u, v| {
        let is_panel = near(u, 0.5, 0.40) && near(v, 0.42, 0.34);
        let is_seam = is_panel && !(near(u, 0.5, 0.385) && near(v, 0.42, 0.325));
        let is_rivet = [0.15, 0.85].iter().any(|&x| [0.13, 0.42, 0.71].iter().any(|&y| (u - x).hypot(v - y) < 0.018));
        if is_seam || is_rivet {
            DARK
        } else if near(v, 0.87, 0.055) && near(u, 0.5, 0.45) {
            if (6.0 * (u + v)).rem_euclid(1.0) < 0.5 { DARK } else { YELLOW }
        } else {
            TEAL
        }
    })
}

/// A dark visor, cheeks and a stripe over the top.
pub fn face() -> Image {
    image(|u, v| {
        let is_cheek = [0.16, 0.84].iter().any(|&x| (u - x).hypot(v - 0.66) < 0.05);
        if near(v, 0.39, 0.17) {
            DARK
        } else if is_cheek || near(u, 0.5, 0.06) && v < 0.18 {
            RED
        } else {
            CREAM
        }
    })
}

fn near(value: f32, middle: f32, reach: f32) -> bool {
    (value - middle).abs() < reach
}

/// Each texel is the mean of four samples of the color at shares of width and height.
fn image(color: impl Fn(f32, f32) -> Color) -> Image {
    let texel = |column: u32, row: u32| -> Color {
        let at = |number: u32, part: f32| (number as f32 + part) / SIZE as f32;
        let samples = [0.25, 0.75].map(|x| [0.25, 0.75].map(|y| color(at(column, x), at(row, y))));
        std::array::from_fn(|channel| {
            let sum: u16 = samples.as_flattened().iter().map(|sample| u16::from(sample[channel])).sum();
            (sum / 4) as u8
        })
    };
    let texels = (0..SIZE).flat_map(|row| (0..SIZE).map(move |column| (column, row)));
    let texels: Vec<u8> = texels.flat_map(|(column, row)| texel(column, row)).collect();
    Image { media_type: "image/png".to_owned(), bytes: png::encode(SIZE, &texels), ..Image::default() }
}
