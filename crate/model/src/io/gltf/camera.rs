//! Cameras of the scene. One that cannot be read is left out.

use std::f64::consts::PI;

use glam::DVec3;
use gltf::json::Root;

use super::scene::Scene;
use crate::camera::{Camera, Projection};
use crate::error::Result;
use crate::io::budget::Budget;

/// The cameras of the nodes that are shown, in their order.
pub fn cameras(budget: &Budget, root: &Root, scene: &Scene) -> Result<Vec<Camera>> {
    let camera = |&node: &usize| {
        let number = root.nodes[node].camera?.value();
        let given = root.cameras.get(number)?;
        let projection = match (&given.perspective, &given.orthographic) {
            (Some(perspective), _) => Projection::Perspective { field_of_view: f64::from(perspective.yfov) },
            (None, Some(orthographic)) => Projection::Orthographic { height: 2.0 * f64::from(orthographic.ymag).abs() },
            (None, None) => return None,
        };
        let world_from_node = scene.world_from_node[node];
        // A camera looks along −z (glTF 2.0, 3.10).
        let forward = world_from_node.transform_vector3(DVec3::NEG_Z).normalize_or_zero();
        let position = world_from_node.transform_point3(DVec3::ZERO);
        let name = root.nodes[node].name.as_ref().or(given.name.as_ref()).filter(|name| !name.is_empty());
        let is_sound = position.is_finite() && forward != DVec3::ZERO && sees_something(projection);
        let name = name.cloned().unwrap_or_else(|| format!("camera {number}"));
        // Nodes may share one camera and its name.
        let taken = budget.take(size_of::<Camera>() as u64 + name.len() as u64);
        is_sound.then(|| taken.map(|()| Camera { name, position, forward, projection }))
    };
    scene.nodes.iter().filter_map(camera).collect()
}

fn sees_something(projection: Projection) -> bool {
    match projection {
        Projection::Perspective { field_of_view } => field_of_view > 0.0 && field_of_view < PI,
        Projection::Orthographic { height } => height > 0.0 && height.is_finite(),
    }
}
