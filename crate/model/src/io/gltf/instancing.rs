//! `EXT_mesh_gpu_instancing`: a mesh many times below one node.

use glam::{DMat4, DQuat, DVec3, DVec4};
use gltf::json::Node;

use super::accessor::Accessors;
use super::format::GLTF;
use crate::error::Result;

pub const INSTANCING: &str = "EXT_mesh_gpu_instancing";

/// Where the instances of a node's mesh stand below it; one that stands where the node does, for a node without the extension.
pub fn instances(accessors: Accessors, number: usize, node: &Node) -> Result<Vec<DMat4>> {
    let extension = node.extensions.as_ref().and_then(|extensions| extensions.others.get(INSTANCING));
    let Some(extension) = extension else { return Ok(vec![DMat4::IDENTITY]) };
    let attributes = extension.get("attributes");
    let accessor = |name: &str| attributes.and_then(|all| u32::try_from(all.get(name)?.as_u64()?).ok());
    let translations = accessor("TRANSLATION").map(|index| accessors.vectors(index)).transpose()?;
    let rotations = accessor("ROTATION").map(|index| accessors.rotations(index)).transpose()?;
    let scales = accessor("SCALE").map(|index| accessors.vectors(index)).transpose()?;
    let counts = [translations.as_ref().map(Vec::len), rotations.as_ref().map(Vec::len), scales.as_ref().map(Vec::len)];
    let count = counts.into_iter().flatten().next().unwrap_or(1);
    if counts.into_iter().flatten().any(|other| other != count) {
        let problem = "its instances have attributes of different lengths; export the file again";
        return Err(GLTF.at(format!("node {number}"), problem));
    }
    accessors.buffers.budget.lend(count as u64 * size_of::<DMat4>() as u64)?;
    let instance = |index: usize| {
        let translation = translations.as_ref().map_or(DVec3::ZERO, |translations| translations[index]);
        let rotation = rotations.as_ref().map_or(DVec4::W, |rotations| DVec4::from(rotations[index]));
        let scale = scales.as_ref().map_or(DVec3::ONE, |scales| scales[index]);
        let rotation = DQuat::from_vec4(rotation.normalize_or(DVec4::W));
        DMat4::from_scale_rotation_translation(scale, rotation, translation)
    };
    Ok((0..count).map(instance).collect())
}
