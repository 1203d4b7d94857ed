//! Morph targets with their default weights, and skins in their rest pose.

use glam::{DMat4, DVec3};
use gltf::json::mesh::{Primitive, Semantic};
use gltf::json::skin::Skin;
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};

use super::accessor::{Accessors, number};
use super::format::{GLTF, element};
use super::scene::Scene;
use crate::error::Result;

/// Adds the weighted displacements of the morph targets.
pub fn morph(accessors: Accessors, primitive: &Primitive, weights: &[f32], positions: &mut [DVec3]) -> Result<()> {
    let targets = primitive.targets.as_deref().unwrap_or_default();
    for (target, &weight) in targets.iter().zip(weights).filter(|&(_, &weight)| weight != 0.0) {
        let Some(displacement) = target.positions else { continue };
        let displacements = accessors.vectors(number(displacement))?;
        if displacements.len() != positions.len() {
            return Err(GLTF.at(
                format!("accessor {}", displacement.value()),
                "a morph target has another number of vertices than its mesh; export the file again",
            ));
        }
        for (position, displacement) in positions.iter_mut().zip(displacements) {
            *position += f64::from(weight) * displacement;
        }
    }
    Ok(())
}

/// For each joint of the skin, `world_from_joint · joint_from_mesh` with the nodes as they stand in the file.
pub fn joint_matrices(root: &Root, accessors: Accessors, scene: &Scene, skin: Index<Skin>) -> Result<Vec<DMat4>> {
    let skin = element(&root.skins, skin, "skin")?;
    let inverse_binds = match skin.inverse_bind_matrices {
        Some(index) => accessors.matrices(number(index))?,
        None => Vec::new(),
    };
    let mut matrices = Vec::with_capacity(skin.joints.len());
    for (joint, &node) in skin.joints.iter().enumerate() {
        element(&root.nodes, node, "node")?;
        let joint_from_mesh = inverse_binds.get(joint).map_or(DMat4::IDENTITY, DMat4::from_cols_array);
        matrices.push(scene.world_from_node[node.value()] * joint_from_mesh);
    }
    Ok(matrices)
}

/// The matrix of each of `count` vertices by linear blend skinning over all sets of joints and weights.
pub fn skin(accessors: Accessors, primitive: &Primitive, joints: &[DMat4], count: usize) -> Result<Vec<DMat4>> {
    let mut blended = vec![DMat4::ZERO; count];
    let mut total = vec![0.0; count];
    let attribute = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).map(|&index| number(index));
    for set in 0.. {
        let (Some(joint_accessor), Some(weight_accessor)) =
            (attribute(Semantic::Joints(set)), attribute(Semantic::Weights(set)))
        else {
            break;
        };
        let influences = accessors.joints(joint_accessor)?.into_iter().zip(accessors.weights(weight_accessor)?);
        for (vertex, (influence, weights)) in influences.enumerate().take(count) {
            for (joint, weight) in influence.into_iter().zip(weights).filter(|&(_, weight)| weight != 0.0) {
                let world_from_mesh = joints.get(joint as usize).ok_or_else(|| {
                    GLTF.at(
                        format!("accessor {joint_accessor}"),
                        format!("joint {joint} of vertex {vertex} does not exist; export the file again"),
                    )
                })?;
                blended[vertex] += *world_from_mesh * weight;
                total[vertex] += weight;
            }
        }
    }
    // Quantised weights need not sum to 1 exactly; a vertex without any stays where it is.
    for (matrix, total) in blended.iter_mut().zip(total) {
        *matrix = if total == 0.0 { DMat4::IDENTITY } else { *matrix * (1.0 / total) };
    }
    Ok(blended)
}
