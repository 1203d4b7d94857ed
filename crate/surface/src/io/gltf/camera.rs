//! Cameras of the scene. One that cannot be read is left out.

use std::f64::consts::PI;

use glam::DVec3;
use gltf::json::Root;

use super::scene::Scene;
use crate::soup::Camera;

/// The perspective cameras of the nodes that are shown, in their order.
pub fn cameras(root: &Root, scene: &Scene) -> Vec<Camera> {
    let camera = |&node: &usize| {
        let number = root.nodes[node].camera?.value();
        let given = root.cameras.get(number)?;
        let field_of_view = f64::from(given.perspective.as_ref()?.yfov);
        let world_from_node = scene.world_from_node[node];
        // A camera looks along −z (glTF 2.0, 3.10).
        let forward = world_from_node.transform_vector3(DVec3::NEG_Z).normalize_or_zero();
        let position = world_from_node.transform_point3(DVec3::ZERO);
        let name = root.nodes[node].name.as_ref().or(given.name.as_ref()).filter(|name| !name.is_empty());
        let is_sound = position.is_finite() && forward != DVec3::ZERO && field_of_view > 0.0 && field_of_view < PI;
        let name = name.cloned().unwrap_or_else(|| format!("camera {number}"));
        is_sound.then_some(Camera { name, position, forward, field_of_view })
    };
    scene.camera_nodes.iter().filter_map(camera).collect()
}
