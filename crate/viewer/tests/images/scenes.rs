//! What the images show: spheres and a ring around them, with distances that are known in closed form.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3, Vec4};
use heatwalk_viewer::{
    Blend, CrowdPose, Error, Finish, Hierarchy, MeshAppearance, MeshArrays, Pattern, RAMP_BYTES, Renderer, Style,
    Surroundings, View,
};

use crate::inside;

/// A picture and how its scene is set up.
pub struct Scene {
    pub name: &'static str,
    pub show: fn(&mut Renderer) -> Result<(), Error>,
}

pub const SCENES: [Scene; 14] = [
    Scene { name: "stripes", show: stripes },
    Scene { name: "lines_and_edges", show: lines_and_edges },
    Scene { name: "pins_path_and_walker", show: pins_path_and_walker },
    Scene { name: "crowd", show: crowd },
    Scene { name: "scenery_and_unreachable", show: scenery_and_unreachable },
    Scene { name: "arrows", show: arrows },
    Scene { name: "ground", show: ground },
    Scene { name: "materials_of_a_file", show: crate::materials::belts },
    Scene { name: "cut_open", show: inside::cut_open },
    Scene { name: "hollow", show: inside::hollow },
    Scene { name: "wedge", show: inside::wedge },
    Scene { name: "shells", show: inside::shells },
    Scene { name: "whole_cells", show: inside::whole_cells },
    Scene { name: "arrows_inside", show: inside::arrows_inside },
];

/// Where distance is measured from; unit length.
pub const SOURCE: Vec3 = Vec3::new(-0.48, 0.6, 0.64);

/// A grid of vertices around an axis, closed in both directions or ending in poles.
pub struct Grid {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Grid {
    fn new(columns: u32, rows: u32, at: impl Fn(f32, f32) -> (Vec3, Vec3)) -> Self {
        let corners = (0..=rows).flat_map(|row| (0..=columns).map(move |column| (column, row)));
        let (positions, normals) =
            corners.map(|(column, row)| at(column as f32 / columns as f32, row as f32 / rows as f32)).unzip();
        let squares = (0..rows).flat_map(|row| (0..columns).map(move |column| row * (columns + 1) + column));
        let triangles = squares
            .flat_map(|a| {
                let [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
                [[a, b, c], [a, c, d]]
            })
            .collect();
        Self { positions, normals, triangles }
    }

    pub fn arrays(&self) -> MeshArrays {
        let Self { positions, normals, triangles } = self;
        let hierarchy = Hierarchy::new(positions, triangles);
        let (positions, normals, triangles) = (positions.clone(), normals.clone(), triangles.clone());
        MeshArrays { positions, normals, triangles, hierarchy, appearance: MeshAppearance::default() }
    }
}

/// Of radius 1 about the origin.
pub fn sphere() -> Grid {
    Grid::new(96, 48, |around, along| {
        let (sin, cos) = (PI * along).sin_cos();
        let ring = Vec2::from_angle(-TAU * around) * sin;
        let place = Vec3::new(ring.x, cos, ring.y);
        (place, place)
    })
}

/// Around the sphere, level.
fn ring() -> Grid {
    Grid::new(64, 16, |around, along| {
        let (outward, section) = (Vec2::from_angle(-TAU * around), Vec2::from_angle(TAU * along));
        let normal = Vec3::new(outward.x * section.x, section.y, outward.y * section.x);
        (1.35 * Vec3::new(outward.x, 0.0, outward.y) + 0.12 * normal, normal)
    })
}

fn angle(place: Vec3) -> f32 {
    place.normalize().dot(SOURCE).clamp(-1.0, 1.0).acos()
}

/// Unit tangent of the sphere along which the distance grows.
fn away(place: Vec3) -> Vec3 {
    -SOURCE.reject_from_normalized(place.normalize()).normalize_or_zero()
}

/// Shows a sphere with the distance from the source, in units of so many radii; `reach` is where it becomes unreachable.
fn show_sphere(renderer: &mut Renderer, unit: f64, reach: f32, style: Style) -> Result<(), Error> {
    show_field(renderer, sphere().arrays(), unit, reach, style)
}

/// The same of a mesh that is this sphere.
pub fn show_field(
    renderer: &mut Renderer,
    arrays: MeshArrays,
    unit: f64,
    reach: f32,
    style: Style,
) -> Result<(), Error> {
    let positions = arrays.positions.clone();
    show_mesh(renderer, arrays, Style { period: unit * style.period, ..style })?;
    let max = unit * f64::from(reach.min(PI));
    renderer.set_field(positions.len(), max, false, |values, directions| {
        for (index, &place) in positions.iter().enumerate() {
            let distance = angle(place);
            values[index] = if distance <= reach { (unit * f64::from(distance)) as f32 } else { f32::INFINITY };
            let direction = (127.0 * away(place)).to_array().map(|component| component as i8);
            directions[4 * index..4 * index + 3].copy_from_slice(&direction);
        }
    })
}

/// Shows a mesh without a field.
pub fn show_mesh(renderer: &mut Renderer, arrays: MeshArrays, style: Style) -> Result<(), Error> {
    renderer.set_surface(arrays, None)?;
    renderer.set_environment(Surroundings::Studio, 0.4);
    renderer.set_background(Vec3::new(0.93, 0.94, 0.96), Vec3::new(0.78, 0.81, 0.85));
    renderer.set_ramps(&ramps())?;
    renderer.set_style(style);
    renderer.move_camera(|camera| {
        camera.set_view(View { yaw: -0.35, pitch: 0.5, distance: 4.2, target: glam::DVec3::ZERO });
    });
    Ok(())
}

/// A gradient of the surface, and one colour of the stripes.
fn ramps() -> [u8; RAMP_BYTES] {
    let mut texels = [255; RAMP_BYTES];
    for (index, texel) in texels.as_chunks_mut::<4>().0.iter_mut().enumerate() {
        let share = (index % 256) as u8;
        let color = if index < 256 { [255 - share / 4, 220 - share / 2, 90 + share / 2] } else { [30, 20, 60] };
        texel[..3].copy_from_slice(&color);
    }
    texels
}

pub const BANDS: Style = Style {
    period: 0.3,
    offset: 0.2,
    pattern: Pattern::Bands { width: 0.4, sharpness: 0.6, relief: -0.05 },
    stripe_opacity: 1.0,
    has_materials_of_file: false,
    blend: Blend::Over,
    surface: Finish { metalness: 1.0, roughness: 0.3, glow: 0.0 },
    stripe: Finish { metalness: 0.0, roughness: 0.4, glow: 0.1 },
    brush: Vec4::ZERO,
};

/// Little happens on the surface, so that what stands on it is seen.
pub const PLAIN: Style = Style {
    pattern: Pattern::Bands { width: 0.0, sharpness: 1.0, relief: 0.0 },
    surface: Finish { metalness: 0.0, roughness: 0.5, glow: 0.0 },
    ..BANDS
};

/// Bands of ground and a wall, sharp by triangle, beyond which distance jumps; and the outline of a brush.
fn ground(renderer: &mut Renderer) -> Result<(), Error> {
    show_sphere(renderer, 1.0, 4.0, BANDS)?;
    let MeshArrays { positions, triangles, .. } = sphere().arrays();
    let tint = |corners: &[u32; 3]| match corners.map(|vertex| positions[vertex as usize].y).iter().sum::<f32>() / 3.0 {
        height if height > 0.5 => [180, 120, 30, 200],
        height if height > 0.0 => [0; 4],
        height if height > -0.08 => [8, 9, 12, 255],
        _ => [60, 20, 5, 140],
    };
    let tints: Vec<[u8; 4]> = triangles.iter().map(tint).collect();
    renderer.set_tints(&tints, || Ok(MeshAppearance::default()))?;
    renderer.set_field(3 * triangles.len(), 5.0, true, |values, directions| {
        for (corner, &vertex) in triangles.as_flattened().iter().enumerate() {
            let place = positions[vertex as usize];
            let beyond = if tints[corner / 3] == [60, 20, 5, 140] { 1.5 } else { 0.0 };
            values[corner] = angle(place) + beyond;
            let direction = (127.0 * away(place)).to_array().map(|component| component as i8);
            directions[4 * corner..4 * corner + 3].copy_from_slice(&direction);
        }
    })?;
    renderer.set_brush(Vec3::new(-0.3, 0.1, 0.95).normalize(), 0.3);
    Ok(())
}

fn stripes(renderer: &mut Renderer) -> Result<(), Error> {
    stripes_in_unit(renderer, 1.0)
}

pub fn stripes_in_unit(renderer: &mut Renderer, unit: f64) -> Result<(), Error> {
    show_sphere(renderer, unit, 4.0, BANDS)
}

fn lines_and_edges(renderer: &mut Renderer) -> Result<(), Error> {
    show_sphere(renderer, 1.0, 4.0, Style { pattern: Pattern::Lines { width: 3.0 }, ..PLAIN })?;
    let meridian = |turn: f32| (0..24).map(move |step| [step, step + 1].map(|step| at(turn, step as f32 / 24.0)));
    let meridians: Vec<[Vec3; 2]> = (0..12).flat_map(|index| meridian(index as f32 / 12.0)).collect();
    renderer.add_edges(&meridians, Vec3::new(0.1, 0.4, 0.85), 1.2)
}

/// A place of the sphere: shares of a full turn about the vertical, and from pole to pole.
fn at(around: f32, along: f32) -> Vec3 {
    let (sin, cos) = (PI * along).sin_cos();
    let ring = Vec2::from_angle(TAU * around) * sin;
    Vec3::new(ring.x, cos, ring.y)
}

fn pins_path_and_walker(renderer: &mut Renderer) -> Result<(), Error> {
    show_sphere(renderer, 1.0, 4.0, PLAIN)?;
    let start = Vec3::new(0.5, 0.1, 0.86).normalize();
    let path: Vec<Vec3> = (0..=40).map(|step| start.lerp(SOURCE, step as f32 / 40.0).normalize()).collect();
    let pins = [SOURCE, Vec3::new(0.62, 0.66, 0.43).normalize()];
    renderer.set_pins(&pins, &pins, Some(1))?;
    renderer.set_path(&path, &path)?;
    renderer.set_walker(0.5);
    renderer.move_camera(|camera| {
        camera.set_view(View { distance: 1.9, target: glam::DVec3::new(0.05, 0.35, 0.6), ..camera.view() });
    });
    Ok(())
}

/// The sphere without stripes, seen from near.
pub fn alone(renderer: &mut Renderer) -> Result<(), Error> {
    show_sphere(renderer, 1.0, 4.0, PLAIN)?;
    renderer.move_camera(|camera| camera.set_view(View { distance: 3.2, ..camera.view() }));
    Ok(())
}

/// Pins in it, of which the second is selected and the third on the far side; their feet.
pub fn pins(renderer: &mut Renderer) -> Result<[Vec3; 3], Error> {
    let pins = [SOURCE, Vec3::new(0.62, 0.66, 0.43).normalize(), Vec3::new(-0.4, -0.3, -0.85).normalize()];
    renderer.set_pins(&pins, &pins, Some(1))?;
    Ok(pins)
}

/// Sixty walkers on the side that is seen, from near.
fn crowd(renderer: &mut Renderer) -> Result<(), Error> {
    show_sphere(renderer, 1.0, 4.0, PLAIN)?;
    let poses: Vec<CrowdPose> = (0..60)
        .map(|index| {
            let [column, row] = [index % 10, index / 10].map(|step| step as f32);
            let place = Vec3::new(-0.38 + 0.04 * column, 0.36 + 0.04 * row, 0.8).normalize();
            CrowdPose { position: place, normal: place, heading: -away(place), arc: 0.037 * index as f32 }
        })
        .collect();
    renderer.set_crowd(&poses, 0.03)?;
    let target = glam::DVec3::new(-0.2, 0.46, 0.85);
    renderer.move_camera(|camera| camera.set_view(View { yaw: -0.25, pitch: 0.5, distance: 0.6, target }));
    Ok(())
}

fn scenery_and_unreachable(renderer: &mut Renderer) -> Result<(), Error> {
    show_sphere(renderer, 1.0, 0.9, BANDS)?;
    renderer.set_scenery(vec![ring().arrays()])?;
    renderer.move_camera(|camera| camera.set_view(View { distance: 5.5, ..camera.view() }));
    Ok(())
}

/// One arrow a triangle of a coarse sphere.
fn arrows(renderer: &mut Renderer) -> Result<(), Error> {
    let dark = Pattern::Bands { width: 1.0, sharpness: 1.0, relief: 0.0 };
    show_sphere(renderer, 1.0, 4.0, Style { pattern: dark, ..PLAIN })?;
    let Grid { positions, triangles, .. } = sphere();
    let vectors: Vec<Vec3> =
        triangles.iter().map(|corners| away(corners.iter().map(|&vertex| positions[vertex as usize]).sum())).collect();
    renderer.set_arrows(&vectors)
}
