//! The node hierarchy: which nodes are shown and where they stand.

use glam::{DMat4, DQuat, DVec3, DVec4};
use gltf::json::{self, Root};

use super::format::{GLTF, element};
use crate::error::{Error, Result};
use crate::motion::{Node, NodeTree, Placement};

pub struct Scene {
    /// Every node of the file, in the scene or not: joints of a skin may stand outside.
    pub hierarchy: NodeTree,
    /// Where each of them stands.
    pub world_from_node: Vec<DMat4>,
    /// Nodes of the scene that carry a mesh, parents before children, in file order.
    pub mesh_nodes: Vec<usize>,
    /// All nodes of the scene, in that order.
    pub nodes: Vec<usize>,
}

impl Scene {
    pub fn new(root: &Root) -> Result<Self> {
        let mut is_child = vec![false; root.nodes.len()];
        for child in root.nodes.iter().flat_map(|node| node.children.iter().flatten()) {
            element(&root.nodes, *child, "node")?;
            is_child[child.value()] = true;
        }
        let roots: Vec<usize> = (0..root.nodes.len()).filter(|&node| !is_child[node]).collect();
        let mut nodes: Vec<Node> =
            root.nodes.iter().map(|node| Node { parent: None, placement: placement(node) }).collect();
        let mut is_below_root = vec![false; nodes.len()];
        walk(root, &roots, |parent, node| {
            nodes[node].parent = parent;
            let is_second = std::mem::replace(&mut is_below_root[node], true);
            if is_second { Err(no_tree(node)) } else { Ok(true) }
        })?;
        let hierarchy = NodeTree::new(nodes)?;
        let world_from_node = hierarchy.world_at_rest();

        let shown = match root.scene {
            Some(index) => Some(element(&root.scenes, index, "scene")?),
            None => root.scenes.first(),
        };
        let shown: Vec<usize> = match shown {
            Some(scene) => scene
                .nodes
                .iter()
                .map(|&node| element(&root.nodes, node, "node").map(|_| node.value()))
                .collect::<Result<_>>()?,
            // What is below no root is part of a cycle, or below one.
            None => roots.into_iter().chain(0..root.nodes.len()).collect(),
        };
        let mut nodes = Vec::new();
        let mut is_shown = vec![false; root.nodes.len()];
        walk(root, &shown, |_, node| {
            if !is_below_root[node] {
                return Err(no_tree(node));
            }
            // Some programs list all nodes of a scene, not its roots alone.
            let is_first = !std::mem::replace(&mut is_shown[node], true);
            nodes.extend(is_first.then_some(node));
            Ok(is_first)
        })?;
        let mesh_nodes = nodes.iter().copied().filter(|&node| root.nodes[node].mesh.is_some()).collect();
        Ok(Self { hierarchy, world_from_node, mesh_nodes, nodes })
    }
}

/// Visits the nodes below `roots` with their parents, parents first, and those below a node if the visit says so. An explicit
/// stack: files can be deep.
fn walk(root: &Root, roots: &[usize], mut visit: impl FnMut(Option<usize>, usize) -> Result<bool>) -> Result<()> {
    let mut stack: Vec<(Option<usize>, usize)> = roots.iter().rev().map(|&node| (None, node)).collect();
    while let Some((parent, node)) = stack.pop() {
        if visit(parent, node)? {
            // `Scene::new` has checked the children.
            stack.extend(root.nodes[node].children.iter().flatten().rev().map(|child| (Some(node), child.value())));
        }
    }
    Ok(())
}

fn no_tree(node: usize) -> Error {
    GLTF.at(
        format!("node {node}"),
        "it has two parents or is its own ancestor; the nodes must form trees, export the file again",
    )
}

fn placement(node: &json::Node) -> Placement {
    if let Some(matrix) = node.matrix {
        return Placement::Matrix(DMat4::from_cols_array(&matrix.map(f64::from)));
    }
    let rotation = DVec4::from(node.rotation.unwrap_or_default().0.map(f64::from));
    Placement::Parts {
        translation: DVec3::from(node.translation.unwrap_or_default().map(f64::from)),
        // Written with f32, a quaternion is of unit length to six digits only.
        rotation: DQuat::from_vec4(rotation.normalize_or(DVec4::W)),
        scale: DVec3::from(node.scale.unwrap_or([1.0; 3]).map(f64::from)),
    }
}
