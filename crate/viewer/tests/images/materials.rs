//! Spheres and planes in the materials of a file.

use std::f32::consts::TAU;

use glam::{DVec3, Vec3, Vec4};
use heatwalk_viewer::{
    Blend, CHANNELS, Context, Error, Hierarchy, Image as Texels, Material, MeshAppearance, MeshArrays, MeshRun,
    PunctualLight, Renderer, Style, Surroundings, TextureUse, View,
};
use libtest_mimic::Failed;

use crate::image::{HEIGHT, Image, WIDTH};
use crate::scenes::{self, BANDS, show_field};
use crate::{picture, shown};

const BASE_COLOR: usize = 0;
const NORMAL: usize = 2;

fn texture(image: usize, scale: f32) -> Option<TextureUse> {
    let transform = [scale * Vec3::X, scale * Vec3::Y];
    Some(TextureUse { image, set: 0, transform, wrap: [wgpu::AddressMode::Repeat; 2], is_sharp: false })
}

fn textures(uses: &[(usize, Option<TextureUse>)]) -> [Option<TextureUse>; CHANNELS] {
    let mut textures = [None; CHANNELS];
    for &(channel, texture) in uses {
        textures[channel] = texture;
    }
    textures
}

/// `size²` texels.
fn image(size: u32, texel: impl Fn(f32, f32) -> [u8; 4]) -> Texels {
    let share = |step: u32| (step as f32 + 0.5) / size as f32;
    let rgba = (0..size * size).flat_map(|index| texel(share(index % size), share(index / size))).collect();
    Texels::Pixels { width: size, rgba }
}

/// Opaque orange and clear blue squares.
fn checker() -> Texels {
    image(2, |u, v| if (u < 0.5) == (v < 0.5) { [240, 130, 30, 255] } else { [20, 60, 200, 0] })
}

/// Round bumps.
fn bumps() -> Texels {
    image(32, |u, v| {
        let slope = |x: f32| 0.6 * (TAU * x).sin();
        let normal = Vec3::new(slope(u), -slope(v), 1.0).normalize();
        (255.0 * (0.5 * normal + 0.5)).extend(255.0).to_array().map(|channel| channel as u8)
    })
}

/// A sphere in four belts: bumpy squares, glass, squares with holes, and one that gives its color whatever the light. Their
/// stripes stain what they lie on.
pub fn belts(renderer: &mut Renderer) -> Result<(), Error> {
    let belt = Material { base_color: Vec4::new(1.0, 1.0, 1.0, 1.0), roughness: 0.4, ..Material::default() };
    let glass = Material { base_color: Vec4::new(0.2, 0.7, 0.5, 0.4), is_blended: true, ..belt.clone() };
    let bumpy =
        Material { textures: textures(&[(BASE_COLOR, texture(0, 4.0)), (NORMAL, texture(1, 12.0))]), ..belt.clone() };
    let holed = Material { cutoff: 0.5, textures: textures(&[(BASE_COLOR, texture(0, 8.0))]), ..belt.clone() };
    let unlit = Material { base_color: Vec4::new(0.9, 0.1, 0.3, 1.0), is_unlit: true, ..belt };
    renderer.set_materials(&[bumpy, glass, holed, unlit], &[checker(), bumps()]);
    let mut arrays = scenes::sphere().arrays();
    let triangles = arrays.triangles.len() as u32;
    let quarter = |index: u32| index * triangles / 4;
    let run = |index: u32| MeshRun { triangles: quarter(index)..quarter(index + 1), material: index };
    arrays.appearance = MeshAppearance {
        texcoords: arrays.positions.iter().map(|&place| [place.x.atan2(place.z) / TAU, -place.y, 0.0, 0.0]).collect(),
        colors: Vec::new(),
        runs: (0..4).map(run).collect(),
    };
    let style = Style { has_materials_of_file: true, blend: Blend::Multiply, ..BANDS };
    show_field(renderer, arrays, 1.0, 4.0, style)
}

/// A square from above, without a field: texture coordinates along x and z.
fn show_square(renderer: &mut Renderer, material: Material, texels: &[Texels], normal: Vec3) -> Result<(), Error> {
    renderer.set_materials(&[material], texels);
    let positions: Vec<Vec3> =
        [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)].map(|(x, z)| Vec3::new(x, 0.0, z)).to_vec();
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    let appearance = MeshAppearance {
        texcoords: positions.iter().map(|place| [place.x, place.z, 0.0, 0.0]).collect(),
        colors: Vec::new(),
        runs: vec![MeshRun { triangles: 0..2, material: 0 }],
    };
    let hierarchy = Hierarchy::new(&positions, &triangles);
    let normals = vec![normal; 4];
    renderer.set_surface(MeshArrays { positions, normals, triangles, hierarchy, appearance }, None)?;
    renderer.set_environment(Surroundings::Studio, 0.4);
    renderer.set_style(Style { has_materials_of_file: true, ..Style::default() });
    renderer.move_camera(|camera| {
        camera.set_view(View { yaw: 0.3, pitch: 1.2, distance: 3.0, target: DVec3::ZERO });
    });
    Ok(())
}

/// A square across the z axis, without a field, in an unlit material of this color and alpha for each place on the axis.
fn show_panes(renderer: &mut Renderer, panes: &[(f32, Vec4)], yaw: f64) -> Result<(), Error> {
    let pane = |&(_, base_color): &(f32, Vec4)| Material {
        base_color,
        is_blended: base_color.w < 1.0,
        is_unlit: true,
        ..Material::default()
    };
    renderer.set_materials(&panes.iter().map(pane).collect::<Vec<_>>(), &[]);
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let square = |&(z, _): &(f32, Vec4)| corners.map(|(x, y)| Vec3::new(x, y, z));
    let positions: Vec<Vec3> = panes.iter().flat_map(square).collect();
    let count = panes.len() as u32;
    let triangles: Vec<[u32; 3]> = (0..count)
        .flat_map(|pane| [[0, 1, 2], [0, 2, 3]].map(|corners| corners.map(|corner| 4 * pane + corner)))
        .collect();
    let runs = (0..count).map(|pane| MeshRun { triangles: 2 * pane..2 * pane + 2, material: pane }).collect();
    let hierarchy = Hierarchy::new(&positions, &triangles);
    let normals = vec![Vec3::Z; positions.len()];
    let appearance = MeshAppearance { runs, ..MeshAppearance::default() };
    renderer.set_surface(MeshArrays { positions, normals, triangles, hierarchy, appearance }, None)?;
    renderer.set_style(Style { has_materials_of_file: true, ..Style::default() });
    renderer.move_camera(|camera| {
        camera.set_view(View { yaw, pitch: 0.1, distance: 3.0, target: DVec3::ZERO });
    });
    Ok(())
}

/// The color of a pixel is that of the farthest pane, and each nearer one keeps back its share of what is behind it, from
/// whichever side they are seen and in whichever order the file has them; also after the camera or the materials have changed.
pub fn panes_are_blended_from_back_to_front(device: &Context) -> Result<(), Failed> {
    let opaque = |z: f32| (z, Vec4::new(0.9, 0.8, 0.1, 1.0));
    let red = |z: f32| (z, Vec4::new(0.8, 0.05, 0.05, 0.5));
    let green = |z: f32| (z, Vec4::new(0.05, 0.7, 0.1, 0.4));
    let blue = |z: f32| (z, Vec4::new(0.1, 0.1, 0.9, 0.6));
    let srgb = |light: f32| if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    let blend = |behind: Vec3, (_, pane): &(f32, Vec4)| {
        let color = Vec3::from_array([pane.x, pane.y, pane.z].map(srgb));
        pane.w * color + (1.0 - pane.w) * behind
    };
    let mut renderer = shown(device, |_| Ok(()))?;
    let files: [&[(f32, Vec4)]; 3] = [
        &[red(0.3), blue(-0.3), opaque(0.0), green(0.6)],
        &[green(-0.5), opaque(-0.9), red(0.4), blue(0.1)],
        &[opaque(0.8), blue(-0.7), green(0.1), red(-0.3)],
    ];
    for panes in files {
        for (yaw, side) in [(0.0, 1.0), (std::f64::consts::PI, -1.0)] {
            show_panes(&mut renderer, panes, yaw)?;
            let mut seen = panes.to_vec();
            seen.sort_by(|one, other| (side * one.0).total_cmp(&(side * other.0)));
            let first = seen.iter().position(|(_, color)| color.w == 1.0).expect("an opaque pane");
            let expected = seen[first..].iter().fold(Vec3::ZERO, blend);
            let pixel = picture(&mut renderer)?.pixel(WIDTH / 2, HEIGHT / 2);
            let expected = (255.0 * expected).round().to_array().map(|channel| channel as u8);
            // A step of rounding for each pane.
            let is_close = (0..3).all(|channel| pixel[channel].abs_diff(expected[channel]) <= 3);
            assert!(is_close, "{pixel:?} for {expected:?} of {panes:?} from {yaw}");
        }
    }
    Ok(())
}

/// A normal map that leans everywhere alike is a surface that leans: to the right of the image along u, to its top against v,
/// however the image is stretched.
pub fn a_leaning_normal_map_leans_the_surface(device: &Context) -> Result<(), Failed> {
    const TILT: f32 = 0.45;
    let mut renderer = shown(device, |_| Ok(()))?;
    let mut drawn = |map: Vec3, normal: Vec3| -> Result<Image, Failed> {
        let texel = |component: f32| (255.0 * (0.5 * component + 0.5)).round() as u8;
        let leaning = image(1, |_, _| [texel(map.x), texel(map.y), texel(map.z), 255]);
        let stretched = texture(0, 1.0).map(|texture| TextureUse { transform: [Vec3::X, 5.0 * Vec3::Y], ..texture });
        let textures = textures(&[(NORMAL, stretched)]);
        let mirror = Material { metalness: 1.0, roughness: 0.25, textures, ..Material::default() };
        show_square(&mut renderer, mirror, &[leaning], normal)?;
        picture(&mut renderer)
    };
    let (sine, cosine) = TILT.sin_cos();
    let flat = Vec3::Z;
    for (to, on_surface) in [(Vec3::X, Vec3::X), (Vec3::Y, Vec3::NEG_Z)] {
        let tilted = drawn(flat, cosine * Vec3::Y + sine * on_surface)?;
        let mapped = drawn(cosine * Vec3::Z + sine * to, Vec3::Y)?;
        let wrong_way = drawn(cosine * Vec3::Z - sine * to, Vec3::Y)?;
        let without = drawn(flat, Vec3::Y)?;
        let [right, wrong, without] = [mapped, wrong_way, without].map(|drawn| drawn.difference(&tilted).mean);
        assert!(4.0 * right < wrong.min(without), "{right} from the tilted one; {wrong} the other way, {without} flat");
    }
    Ok(())
}

/// What a matt square gives back grows with the light that arrives: by the cosine of its direction, the square of the distance
/// and the cone that it is in; whatever is far away or near, and not with lights of the surroundings.
pub fn lights_of_a_file_follow_their_laws(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |_| Ok(()))?;
    show_square(&mut renderer, Material { roughness: 1.0, ..Material::default() }, &[], Vec3::Y)?;
    let mut middle = |lights: &[PunctualLight]| -> Result<f64, Failed> {
        renderer.set_lights(lights.to_vec());
        let [red, green, blue] = picture(&mut renderer)?.pixel(WIDTH / 2, HEIGHT / 2).map(f64::from);
        Ok((red + green + blue) / 3.0)
    };
    let light = |place: Vec4, strength: f32| PunctualLight {
        place,
        axis: Vec4::new(0.0, -1.0, 0.0, 1.0),
        color: (strength * Vec3::ONE).extend(0.0),
    };
    let above = Vec4::Y;
    let (sine, cosine) = 1.0_f32.sin_cos();
    let tilted = Vec4::new(sine, cosine, 0.0, 0.0);
    let half = middle(&[light(above, 0.3)])?;
    let same = [
        ("the cosine", vec![light(tilted, 0.3 / cosine)]),
        ("the square of the distance", vec![light(Vec4::new(0.0, 2.0, 0.0, 1.0), 4.0 * 0.3)]),
        ("the sum", vec![light(above, 0.1), light(above, 0.2)]),
        // Half way from the edge of the cone to where it is whole: a quarter of the light.
        (
            "the cone",
            vec![PunctualLight {
                axis: Vec4::new(0.0, -1.0, 0.0, -1.5),
                color: Vec4::new(1.2, 1.2, 1.2, 2.0),
                ..light(above, 1.2)
            }],
        ),
    ];
    for (law, lights) in same {
        let found = middle(&lights)?;
        assert!((found - half).abs() <= 2.0, "{law}: {found} for {half}");
    }
    let dark = middle(&[light(-above, 0.3)])?;
    let outside = PunctualLight {
        axis: Vec4::new(0.0, 1.0, 0.0, 0.0),
        color: Vec4::new(9.0, 9.0, 9.0, 2.0),
        ..light(above, 9.0)
    };
    assert!((middle(&[outside])? - dark).abs() < 1.0, "nothing comes from behind or from outside of the cone");
    assert!(dark < half - 40.0, "{dark} in the dark, {half} under the light");
    Ok(())
}

/// Without light, a pixel has the base color, and where texels are smaller than it their mean as light.
pub fn unlit_colors_are_those_of_the_file(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |_| Ok(()))?;
    let mut middle = |material: Material, texels: &[Texels]| -> Result<[u8; 3], Failed> {
        show_square(&mut renderer, Material { is_unlit: true, ..material }, texels, Vec3::Y)?;
        Ok(picture(&mut renderer)?.pixel(WIDTH / 2, HEIGHT / 2))
    };
    let srgb = |light: f64| {
        let curved = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
        (255.0 * curved).round() as u8
    };
    let plain = Material { base_color: Vec4::new(0.5, 0.2, 0.05, 1.0), ..Material::default() };
    let pixel = middle(plain, &[])?;
    let expected = [0.5, 0.2, 0.05].map(srgb);
    assert!((0..3).all(|channel| pixel[channel].abs_diff(expected[channel]) <= 1), "{pixel:?} for {expected:?}");
    let squares = image(64, |u, v| {
        let is_light = ((64.0 * u) as u32 + (64.0 * v) as u32).is_multiple_of(2);
        if is_light { [255; 4] } else { [0, 0, 0, 255] }
    });
    let fine = Material { textures: textures(&[(BASE_COLOR, texture(0, 40.0))]), ..Material::default() };
    let pixel = middle(fine, &[squares])?;
    assert!(pixel.iter().all(|&channel| channel.abs_diff(srgb(0.5)) <= 2), "{pixel:?} for the mean of black and white");
    Ok(())
}
