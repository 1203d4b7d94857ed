//! Lights of a file as the renderer takes them.

use glam::{Vec3, Vec4};
use heatwalk::surface::{Light, LightKind};
use heatwalk_bake::Bounds;
use heatwalk_scene::DrawTransform;

/// Light on a matt white surface at the middle of the model that faces all lights at once, as linear light: about as much as
/// that of the page's own studio. Files give their lights in units of photometry, by which a room is a thousand times darker than a
/// beach; cameras and eyes adapt.
const EXPOSURE: f32 = 1.6;

/// The least distance that a light is away, as a share of the radius of the surface: one that touches it is no infinite light.
const NEAREST: f32 = 0.02;

/// Three rows of four numbers a light: its position and 1, or the direction to one that is far away and 0; the direction to
/// which it shines and the offset of its cone; its color at unit distance and the slope of its cone, by the cosine of the
/// angle from its axis (KHR_lights_punctual, "Inner and outer cone angles"). `surface`: as it is drawn.
pub(crate) fn light_rows(lights: &[Light], transform: &DrawTransform, surface: Bounds) -> Vec<f32> {
    let row = |light: &Light| {
        let forward = transform.direction(light.forward).as_vec3();
        // Nothing becomes brighter by being drawn larger.
        let area = (transform.scale * transform.scale) as f32;
        let [offset, slope] = cone(light.kind);
        let (place, color) = match light.kind {
            LightKind::Directional => ((-forward).extend(0.0), light.color),
            LightKind::Point | LightKind::Spot { .. } => {
                (transform.place(light.position).extend(1.0), area * light.color)
            }
        };
        [place, forward.extend(offset), color.extend(slope)]
    };
    let mut rows: Vec<[Vec4; 3]> = lights.iter().map(row).collect();
    let nearest = (NEAREST * surface.radius).powi(2);
    let arriving = |[place, _, color]: &[Vec4; 3]| {
        let square = (place.truncate() - place.w * surface.center).length_squared().max(nearest);
        color.truncate().dot(Vec3::new(0.2126, 0.7152, 0.0722)) / square
    };
    rows.retain(|row| arriving(row).is_normal());
    // The brightest first: a renderer draws so many.
    rows.sort_by(|one, other| arriving(other).total_cmp(&arriving(one)));
    let exposure = EXPOSURE / rows.iter().map(arriving).sum::<f32>();
    for [_, _, color] in &mut rows {
        *color = (exposure * color.truncate()).extend(color.w);
    }
    rows.iter().flatten().flat_map(Vec4::to_array).collect()
}

/// Offset and slope of what of the light of a cone goes into a direction.
fn cone(kind: LightKind) -> [f32; 2] {
    /// Of two cosines, as the specification has it.
    const LEAST_DIFFERENCE: f64 = 0.001;
    let LightKind::Spot { inner, outer } = kind else { return [1.0, 0.0] };
    let slope = 1.0 / (inner.cos() - outer.cos()).max(LEAST_DIFFERENCE);
    [-outer.cos() * slope, slope].map(|number| number as f32)
}
