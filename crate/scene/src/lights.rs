//! Lights of a file as the renderer takes them.

use glam::{Vec3, Vec4};
use heatwalk_base::sort;
use heatwalk_model::{Light, LightKind};

use crate::transform::DrawTransform;

/// Light on a matt white surface at the middle of the model that faces all lights at once, as linear light: about as much as
/// that of the page's own studio. Files give their lights in units of photometry, by which a room is a thousand times darker than a
/// beach; cameras and eyes adapt.
const EXPOSURE: f32 = 1.6;

/// The least distance that a light is away, as a share of the radius of the surface: one that touches it is no infinite light.
const NEAREST: f32 = 0.02;

/// Three rows of four numbers a light: its position and 1, or the direction to one that is far away and 0; the direction to
/// which it shines and the offset of its cone; its color at unit distance and the slope of its cone, by the cosine of the
/// angle from its axis (KHR_lights_punctual, "Inner and outer cone angles"). `center` and `radius`: of the surface as it is drawn.
pub fn light_rows(lights: &[Light], transform: &DrawTransform, center: Vec3, radius: f32) -> Vec<f32> {
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
    let nearest = (NEAREST * radius).powi(2);
    let arriving = |[place, _, color]: &[Vec4; 3]| {
        let square = (place.truncate() - place.w * center).length_squared().max(nearest);
        color.truncate().dot(Vec3::new(0.2126, 0.7152, 0.0722)) / square
    };
    rows.retain(|row| arriving(row).is_normal());
    // The brightest first: a renderer draws so many.
    sort::sort_by(&mut rows, |one, other| arriving(other).total_cmp(&arriving(one)));
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

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use heatwalk::Up;

    use super::*;

    fn light(kind: LightKind, position: DVec3, strength: f32) -> Light {
        Light { kind, position, forward: DVec3::NEG_X, color: Vec3::splat(strength) }
    }

    fn rows(lights: &[Light], center: DVec3, scale: f64) -> Vec<[f32; 12]> {
        let transform = DrawTransform { center, scale, up: Up::Y };
        light_rows(lights, &transform, Vec3::ZERO, 1.0).as_chunks().0.to_vec()
    }

    fn arriving(row: &[f32; 12]) -> f32 {
        let square = if row[3] > 0.0 { Vec3::from_slice(row).length_squared() } else { 1.0 };
        row[8] / square
    }

    #[test]
    fn lights_are_exposed_for_the_model_whatever_its_unit_and_theirs() {
        for (scale, strength) in [(1.0, 1.0), (1e-3, 5000.0), (1e6, 1e-4)] {
            let center = DVec3::splat(7.0 / scale);
            let at = |x: f64| center + DVec3::new(x / scale, 0.0, 0.0);
            let (near, far) = (light(LightKind::Point, at(2.0), strength), light(LightKind::Point, at(-4.0), strength));
            let found = rows(&[far, near], center, scale);
            let [near, far] = [&found[0], &found[1]];
            assert!(
                (near[0] - 2.0).abs() < 1e-5 && (far[0] + 4.0).abs() < 1e-5,
                "the brightest comes first: {found:?}"
            );
            assert!((arriving(near) / arriving(far) - 4.0).abs() < 1e-3, "by the square of the distance: {found:?}");
            assert!((arriving(near) + arriving(far) - EXPOSURE).abs() < 1e-3, "{found:?} at scale {scale}");
        }
    }

    #[test]
    fn suns_have_directions_and_spots_their_cones() {
        let sun = light(LightKind::Directional, DVec3::splat(9.0), 2.0);
        assert_eq!(rows(&[sun], DVec3::ZERO, 1.0), [[1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 1.6, 1.6, 1.6, 0.0]]);
        let (inner, outer) = (0.2_f64, 0.5_f64);
        let [row] = rows(&[light(LightKind::Spot { inner, outer }, DVec3::X, 2.0)], DVec3::ZERO, 1.0)[..] else {
            panic!("one light")
        };
        let share = |angle: f64| row[11] * angle.cos() as f32 + row[7];
        assert!((share(inner) - 1.0).abs() < 1e-5 && share(outer).abs() < 1e-5, "{row:?}");
    }

    #[test]
    fn what_gives_no_light_is_left_out() {
        assert!(rows(&[light(LightKind::Point, DVec3::X, 0.0)], DVec3::ZERO, 1.0).is_empty());
        assert!(rows(&[light(LightKind::Point, DVec3::splat(1e300), 1.0)], DVec3::ZERO, 1.0).is_empty());
    }
}
