//! Nodes below nodes, each placed in its parent.

use glam::{DMat4, DQuat, DVec3};

use crate::error::{Error, Result};

/// Where a node stands in its parent.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Placement {
    /// By any affine map.
    Matrix(DMat4),
    /// Scaled, then rotated, then moved.
    Parts {
        /// In the unit of the parent.
        translation: DVec3,
        /// Of unit length.
        rotation: DQuat,
        /// Along each axis.
        scale: DVec3,
    },
}

impl Placement {
    /// Where its parent is.
    pub const IDENTITY: Self = Self::Parts { translation: DVec3::ZERO, rotation: DQuat::IDENTITY, scale: DVec3::ONE };

    /// The map to the parent.
    #[must_use]
    pub fn matrix(&self) -> DMat4 {
        match *self {
            Self::Matrix(matrix) => matrix,
            Self::Parts { translation, rotation, scale } => {
                DMat4::from_scale_rotation_translation(scale, rotation, translation)
            }
        }
    }

    /// Its translation, rotation and scale, to be changed; a matrix is taken apart, and shear is lost.
    pub(super) fn parts(&mut self) -> (&mut DVec3, &mut DQuat, &mut DVec3) {
        if let Self::Matrix(matrix) = *self {
            let (scale, rotation, translation) = matrix.to_scale_rotation_translation();
            *self = Self::Parts { translation, rotation, scale };
        }
        match self {
            Self::Parts { translation, rotation, scale } => (translation, rotation, scale),
            Self::Matrix(_) => unreachable!("taken apart above"),
        }
    }
}

/// A node of a hierarchy.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Node {
    /// None for a root.
    pub parent: Option<usize>,
    /// Where it stands while nothing moves.
    pub placement: Placement,
}

/// Nodes that form trees.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct NodeTree {
    nodes: Vec<Node>,
    /// Parents before children.
    order: Vec<usize>,
}

impl NodeTree {
    /// Of nodes in any order.
    ///
    /// # Errors
    /// [`Error::Motion`] for a parent that does not exist, and for a node that is its own ancestor.
    pub fn new(nodes: Vec<Node>) -> Result<Self> {
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
        let mut order = Vec::with_capacity(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            match node.parent {
                None => order.push(index),
                Some(parent) if parent < nodes.len() => children[parent].push(index),
                Some(parent) => {
                    return Err(Error::Motion {
                        problem: format!("node {parent}, the parent of node {index}, does not exist"),
                    });
                }
            }
        }
        let mut done = 0;
        while let Some(&node) = order.get(done) {
            order.extend(&children[node]);
            done += 1;
        }
        if order.len() < nodes.len() {
            return Err(Error::Motion { problem: "a node is its own ancestor".to_owned() });
        }
        Ok(Self { nodes, order })
    }

    /// In the order given.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Where each node stands in the scene, with these placements in its parent.
    #[must_use]
    pub fn world_from_nodes(&self, placements: &[Placement]) -> Vec<DMat4> {
        let mut world_from_node = vec![DMat4::IDENTITY; self.nodes.len()];
        for &node in &self.order {
            let world_from_parent = self.nodes[node].parent.map_or(DMat4::IDENTITY, |parent| world_from_node[parent]);
            world_from_node[node] = world_from_parent * placements[node].matrix();
        }
        world_from_node
    }

    /// The same while nothing moves.
    #[must_use]
    pub fn world_at_rest(&self) -> Vec<DMat4> {
        let placements: Vec<Placement> = self.nodes.iter().map(|node| node.placement).collect();
        self.world_from_nodes(&placements)
    }

    /// What holds for a node holds for those below it.
    pub(super) fn inherit(&self, holds: &mut [bool]) {
        for &node in &self.order {
            holds[node] |= self.nodes[node].parent.is_some_and(|parent| holds[parent]);
        }
    }
}
