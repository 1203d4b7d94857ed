//! Lights of the scene (KHR_lights_punctual). One that cannot be read is left out.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::{DVec3, Vec3};
use gltf::json::Root;
use gltf::json::Value;

use super::scene::Scene;
use crate::light::{Light, LightKind};

const LIGHTS: &str = "KHR_lights_punctual";

/// The lights of the nodes that are shown, in their order.
pub fn lights(root: &Root, scene: &Scene) -> Vec<Light> {
    let Some(given) = root.extensions.as_ref().and_then(|all| all.others.get(LIGHTS)) else { return Vec::new() };
    let light = |&node: &usize| {
        let number = root.nodes[node].extensions.as_ref()?.others.get(LIGHTS)?.get("light")?.as_u64()?;
        read(given.get("lights")?.get(usize::try_from(number).ok()?)?, scene, node)
    };
    scene.nodes.iter().filter_map(light).collect()
}

fn read(given: &Value, scene: &Scene, node: usize) -> Option<Light> {
    let number = |place: &str, default: f64| given.pointer(place).and_then(Value::as_f64).unwrap_or(default);
    let color = ["/color/0", "/color/1", "/color/2"].map(|channel| number(channel, 1.0) as f32);
    let intensity = number("/intensity", 1.0) as f32;
    let world_from_node = scene.world_from_node[node];
    let position = world_from_node.transform_point3(DVec3::ZERO);
    // A light shines along −z.
    let forward = world_from_node.transform_vector3(DVec3::NEG_Z).normalize_or_zero();
    let kind = match given.get("type")?.as_str()? {
        "directional" => LightKind::Directional,
        "point" => LightKind::Point,
        "spot" => {
            let outer = number("/spot/outerConeAngle", FRAC_PI_4).clamp(0.0, FRAC_PI_2);
            let inner = number("/spot/innerConeAngle", 0.0).clamp(0.0, outer);
            LightKind::Spot { inner, outer }
        }
        _ => return None,
    };
    let radiance = intensity * Vec3::from_array(color);
    let is_sound =
        position.is_finite() && forward != DVec3::ZERO && radiance.is_finite() && radiance.min_element() >= 0.0;
    (is_sound && radiance != Vec3::ZERO).then_some(Light { kind, position, forward, color: radiance })
}
