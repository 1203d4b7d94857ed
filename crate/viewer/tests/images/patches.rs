//! What lies on the surface.

use glam::{Vec2, Vec3, Vec4};
use heatwalk_viewer::{Context, Error, Material, MeshAppearance, MeshRun, PatchArrays, Renderer};
use libtest_mimic::Failed;

use crate::image::{HEIGHT, Image, WIDTH};
use crate::scenes;
use crate::{picture, shown};

/// How far above the surface, as a share of its radius.
const LIFT: f32 = 1e-3;

/// A film on the upper half of the sphere, of an opacity, in a vertex color.
fn film(renderer: &mut Renderer, opacity: f32, color: [u16; 3]) -> Result<(), Error> {
    let arrays = scenes::sphere().arrays();
    let is_above = |triangle: &&[u32; 3]| triangle.iter().all(|&vertex| arrays.positions[vertex as usize].y > 0.0);
    let triangles: Vec<_> = arrays.triangles.iter().filter(is_above).copied().collect();
    let lifted = arrays.positions.iter().zip(&arrays.normals).map(|(&position, &normal)| position + LIFT * normal);
    let [red, green, blue] = color;
    let patches = PatchArrays {
        positions: lifted.collect(),
        appearance: MeshAppearance {
            colors: vec![[red, green, blue, u16::MAX]; arrays.positions.len()],
            runs: vec![MeshRun { triangles: 0..triangles.len() as u32, material: 0 }],
            ..MeshAppearance::default()
        },
        triangles,
        normals: arrays.normals,
    };
    let base_color = Vec4::new(1.0, 1.0, 1.0, opacity);
    renderer.set_patches(patches, &[Material { base_color, is_blended: true, ..Material::default() }], &[])
}

/// Pixels where the surface is clearly above the middle, or clearly not, and how many of them differ.
fn differing(renderer: &Renderer, one: &Image, other: &Image) -> [(usize, usize); 2] {
    let mut counts = [(0, 0); 2];
    for (x, y) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))) {
        let hit = renderer.pick(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
        let Some(height) = hit.map(|hit| hit.point.y).filter(|height| height.abs() > 0.2) else { continue };
        let (all, apart) = &mut counts[usize::from(height < 0.0)];
        *all += 1;
        *apart += usize::from(one.pixel(x, y) != other.pixel(x, y));
    }
    counts
}

/// Whatever the style, on the visible half alone, by its opacity, and until it is taken away or the surface is another one.
pub fn patches_lie_on_the_surface_and_let_it_through(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, scenes::alone)?;
    let bare = picture(&mut renderer)?;
    let red = [u16::MAX, 0, 0];
    let mut drawn = Vec::new();
    for opacity in [0.0, 0.5, 1.0] {
        film(&mut renderer, opacity, red)?;
        drawn.push(picture(&mut renderer)?);
    }
    let [clear, half, full] = drawn.try_into().map_err(|_| "three pictures")?;
    assert_eq!(clear.difference(&bare).pixels, 0, "nothing is seen of what is clear");
    let [(above, covered), (below, touched)] = differing(&renderer, &full, &bare);
    assert!(above > 1000 && below > 1000, "{above} and {below} pixels");
    // Stripes may have its color here and there.
    assert!(touched == 0 && covered > above * 9 / 10, "{covered} of {above} above, {touched} below");
    let top = renderer.project(0.9 * Vec3::Y).expect("before the eye");
    let reds = [&bare, &half, &full].map(|image| {
        let [red, green, _] = image.pixel(top.x as u32, top.y as u32).map(i32::from);
        red - green
    });
    assert!(reds[0] + 10 < reds[1] && reds[1] + 10 < reds[2], "{reds:?}");
    film(&mut renderer, 1.0, red)?;
    scenes::alone(&mut renderer)?;
    assert_eq!(picture(&mut renderer)?.difference(&bare).pixels, 0, "another surface is bare");
    let wrong = PatchArrays {
        positions: Vec::new(),
        normals: Vec::new(),
        triangles: vec![[0, 1, 2]],
        appearance: MeshAppearance::default(),
    };
    assert!(renderer.set_patches(wrong, &[], &[]).is_err(), "a vertex that is not there");
    Ok(())
}
