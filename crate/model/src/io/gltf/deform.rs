//! Morph targets, skins and what of them each vertex has.

use std::ops::Range;

use glam::{DMat4, DVec3, Vec3};
use gltf::json::mesh::{MorphTarget as TargetAccessors, Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Node, Root};

use super::accessor::{Accessors, number};
use super::format::{GLTF, element};
use crate::error::Result;
use crate::motion::{Deformer, Influences, MorphTarget, Skin};

/// Vertices of a primitive, as they are read.
pub struct Vertices<'a> {
    pub accessors: Accessors<'a>,
    pub primitive: &'a Primitive,
    pub positions: Vec<DVec3>,
    /// Their place in the soup.
    pub range: Range<usize>,
}

/// The skins of a file, with every joint checked.
pub fn skins(root: &Root, accessors: Accessors) -> Result<Vec<Skin>> {
    let skin = |skin: &gltf::json::Skin| {
        let joint_from_mesh = match skin.inverse_bind_matrices {
            Some(index) => accessors.matrices(number(index))?.iter().map(DMat4::from_cols_array).collect(),
            None => Vec::new(),
        };
        let joints = skin.joints.iter().map(|&node| element(&root.nodes, node, "node").map(|_| node.value()));
        Ok(Skin { joints: joints.collect::<Result<_>>()?, joint_from_mesh })
    };
    root.skins.iter().map(skin).collect()
}

impl Vertices<'_> {
    /// What places them: the node with this number, or its skin. `weights`: of the morph targets, which are all read where
    /// they `change`; else only those that show.
    pub fn deformer(self, node: (usize, &Node), skins: &[Skin], weights: &[f32], change: bool) -> Result<Deformer> {
        let Self { accessors, primitive, positions, range } = self;
        let (index, node) = node;
        let count = positions.len();
        let skin = node.skin.map(|skin| skin.value());
        let influences = match skin {
            None => Influences::default(),
            Some(skin) => {
                let found = skins.get(skin).ok_or_else(|| {
                    GLTF.at(format!("skin {skin}"), format!("there are only {}; export the file again", skins.len()))
                })?;
                influences(accessors, primitive, found.joints.len(), count)?
            }
        };
        let targets = primitive.targets.as_deref().unwrap_or_default();
        let budget = accessors.buffers.budget;
        budget.take_items::<MorphTarget>(targets.len())?;
        budget.take_items::<f64>(weights.len())?;
        let target = |(target, given): (usize, &TargetAccessors)| {
            if !change && weights.get(target).is_none_or(|&weight| weight == 0.0) {
                return Ok(MorphTarget::default());
            }
            let read = |index| displacements(accessors, number(index), count);
            let normals = given.normals.and_then(|index| read(index).ok()).unwrap_or_default();
            Ok(MorphTarget {
                positions: given.positions.map(read).transpose()?.unwrap_or_default(),
                normals: normals.into_iter().map(|normal| normal.as_vec3()).collect(),
            })
        };
        Ok(Deformer {
            vertices: range,
            node: index,
            skin,
            normals: normals(accessors, primitive, count),
            influences,
            targets: targets.iter().enumerate().map(target).collect::<Result<_>>()?,
            weights: weights.iter().map(|&weight| weight.into()).collect(),
            positions,
        })
    }
}

/// The normals of a primitive; none where they cannot be read.
fn normals(accessors: Accessors, primitive: &Primitive, count: usize) -> Vec<Vec3> {
    let normals = primitive.attributes.get(&Checked::Valid(Semantic::Normals));
    let normals = normals.and_then(|&index| accessors.vectors(number(index)).ok());
    let normals = normals.filter(|normals| normals.len() == count).unwrap_or_default();
    normals.into_iter().map(|normal| normal.as_vec3()).collect()
}

fn displacements(accessors: Accessors, index: u32, count: usize) -> Result<Vec<DVec3>> {
    let displacements = accessors.vectors(index)?;
    if displacements.len() != count {
        return Err(GLTF.at(
            format!("accessor {index}"),
            "a morph target has another number of vertices than its mesh; export the file again",
        ));
    }
    Ok(displacements)
}

/// All sets of joints and weights of `count` vertices, of a skin with so many joints.
fn influences(accessors: Accessors, primitive: &Primitive, joints: usize, count: usize) -> Result<Influences> {
    let attribute = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).map(|&index| number(index));
    let mut sets = Vec::new();
    for set in 0.. {
        let (Some(joint_accessor), Some(weight_accessor)) =
            (attribute(Semantic::Joints(set)), attribute(Semantic::Weights(set)))
        else {
            break;
        };
        let (of_joints, weights) = (accessors.joints(joint_accessor)?, accessors.weights(weight_accessor)?);
        for (vertex, (joints_of_vertex, weights)) in of_joints.iter().zip(&weights).enumerate() {
            let missing = |&(&joint, &weight): &(&f64, &f64)| weight != 0.0 && joint as usize >= joints;
            if let Some((joint, _)) = joints_of_vertex.iter().zip(weights).find(missing) {
                return Err(GLTF.at(
                    format!("accessor {joint_accessor}"),
                    format!("joint {joint} of vertex {vertex} does not exist; export the file again"),
                ));
            }
        }
        sets.push((of_joints, weights));
    }
    let of_vertex = |vertex: usize| {
        let of_set = move |(joints, weights): &(Vec<[f64; 4]>, Vec<[f64; 4]>)| {
            let [joints, weights] = [joints, weights].map(|rows| rows.get(vertex).copied().unwrap_or_default());
            // A joint without weight may be any number.
            std::array::from_fn::<_, 4, _>(|k| match weights[k] as f32 {
                0.0 => (0, 0.0),
                weight => (joints[k] as u16, weight),
            })
        };
        sets.iter().flat_map(of_set)
    };
    Ok(Influences { weights: (0..count).flat_map(of_vertex).collect(), per_vertex: 4 * sets.len() })
}
