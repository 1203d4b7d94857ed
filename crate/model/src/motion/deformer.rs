//! Vertices that follow a node or the joints of a skin, after morph targets have displaced them.

use std::ops::Range;

use glam::{DMat3, DMat4, DVec3, Vec3};

use crate::error::{Error, Result};

/// Joints and where each was when the skin was bound to them.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Skin {
    /// Nodes.
    pub joints: Vec<usize>,
    /// For each joint, the map from the space of the mesh to that of the joint; the identity beyond the last.
    pub joint_from_mesh: Vec<DMat4>,
}

impl Skin {
    pub(crate) fn world_from_mesh(&self, world_from_node: &[DMat4]) -> Vec<DMat4> {
        let of_joint = |(joint, &node): (usize, &usize)| {
            world_from_node[node] * self.joint_from_mesh.get(joint).copied().unwrap_or(DMat4::IDENTITY)
        };
        self.joints.iter().enumerate().map(of_joint).collect()
    }
}

/// How much each vertex follows which joints of a skin.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Influences {
    /// Vertex after vertex, [`Self::per_vertex`] each: a joint of the skin and its weight. A vertex without any weight stays
    /// where it is.
    pub weights: Vec<(u16, f32)>,
    /// How many a vertex has.
    pub per_vertex: usize,
}

impl Influences {
    fn of(&self, vertex: usize) -> &[(u16, f32)] {
        self.weights.get(vertex * self.per_vertex..(vertex + 1) * self.per_vertex).unwrap_or_default()
    }
}

/// A displacement that a mesh can have more or less of.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct MorphTarget {
    /// Of the position of each vertex; empty where it has none.
    pub positions: Vec<DVec3>,
    /// Of the normal of each vertex; empty where it has none.
    pub normals: Vec<Vec3>,
}

/// What places consecutive vertices of a soup.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Deformer {
    /// The input vertices, `n` of them.
    pub vertices: Range<usize>,
    /// The node of their mesh.
    pub node: usize,
    /// The skin that they follow; without, they follow the node.
    pub skin: Option<usize>,
    /// `n × 3`, in the space of the mesh.
    pub positions: Vec<DVec3>,
    /// `n × 3`, in the space of the mesh; empty where it has none.
    pub normals: Vec<Vec3>,
    /// Of `n` vertices, where there is a skin.
    pub influences: Influences,
    /// Displacements.
    pub targets: Vec<MorphTarget>,
    /// How much of each target there is while nothing moves; 0 beyond the last.
    pub weights: Vec<f64>,
}

impl Deformer {
    /// Refuses what does not fit together.
    pub(crate) fn check(&self, nodes: usize, skins: &[Skin]) -> Result<()> {
        let count = self.vertices.len();
        let fits = |length: usize| length == 0 || length == count;
        let joints = match self.skin {
            None => Some(usize::MAX),
            Some(skin) => skins.get(skin).map(|skin| skin.joints.len()),
        };
        let problem = if self.node >= nodes {
            format!("node {} does not exist", self.node)
        } else if joints.is_none() {
            "a skin does not exist".to_owned()
        } else if let Some((joint, _)) =
            self.influences.weights.iter().find(|&&(joint, _)| Some(usize::from(joint)) >= joints)
        {
            format!("joint {joint} of the skin does not exist")
        } else if self.positions.len() != count
            || !fits(self.normals.len())
            || !fits(self.influences.weights.len().checked_div(self.influences.per_vertex).unwrap_or(0))
            || !self.targets.iter().all(|target| fits(target.positions.len()) && fits(target.normals.len()))
        {
            format!("arrays have other lengths than the {count} vertices from {} on", self.vertices.start)
        } else {
            return Ok(());
        };
        Err(Error::Motion { problem })
    }

    /// Writes positions and normals of its vertices, `positions` and `normals` being those of the soup; the latter may be empty.
    /// `world_from_mesh`: of each joint, for each skin.
    pub(crate) fn place(
        &self,
        world_from_node: &[DMat4],
        world_from_mesh: &[Vec<DMat4>],
        weights: &[f64],
        positions: &mut [DVec3],
        normals: &mut [Vec3],
    ) {
        let active: Vec<(&MorphTarget, f64)> = self
            .targets
            .iter()
            .zip(weights.iter().copied())
            .filter(|&(target, weight)| weight != 0.0 && !target.positions.is_empty())
            .collect();
        // Displaced vertices whose normals are not have those of their triangles.
        let has_normals = !self.normals.is_empty()
            && !normals.is_empty()
            && active.iter().all(|(target, _)| !target.normals.is_empty());
        let joints = self.skin.map(|skin| world_from_mesh[skin].as_slice());
        let world_from_mesh = world_from_node[self.node];
        let of_node = (world_from_mesh, Turn::of(world_from_mesh));
        for (vertex, place) in self.vertices.clone().enumerate() {
            let (world_from_mesh, turn) = match joints {
                None => of_node,
                Some(joints) => {
                    let matrix = blended(joints, self.influences.of(vertex));
                    (matrix, Turn::of(matrix))
                }
            };
            let position = displaced(self.positions[vertex], &active, |target| target.positions[vertex]);
            positions[place] = world_from_mesh.transform_point3(position);
            if let Some(normal) = normals.get_mut(place) {
                *normal = if has_normals {
                    let normal = self.normals[vertex].as_dvec3();
                    turn.normal(displaced(normal, &active, |target| target.normals[vertex].as_dvec3())).as_vec3()
                } else {
                    Vec3::ZERO
                };
            }
        }
    }

    /// That of a mesh which stands below its node. Not for a skin, whose joints place the vertices.
    #[must_use]
    pub fn below(mut self, node_from_mesh: DMat4) -> Self {
        if node_from_mesh == DMat4::IDENTITY {
            return self;
        }
        let turn = Turn::of(node_from_mesh);
        let turned = |normal: &mut Vec3| *normal = turn.normal(normal.as_dvec3()).as_vec3();
        for position in &mut self.positions {
            *position = node_from_mesh.transform_point3(*position);
        }
        self.normals.iter_mut().for_each(turned);
        for target in &mut self.targets {
            for displacement in &mut target.positions {
                *displacement = node_from_mesh.transform_vector3(*displacement);
            }
            // A change of a direction has no direction of its own that could be turned.
            target.normals.clear();
        }
        self
    }

    /// That of some of its vertices, ascending and counted from its first, which are consecutive from `first` on.
    pub(crate) fn select(&self, own: &[usize], first: usize) -> Self {
        fn chosen<T: Copy>(values: &[T], own: &[usize]) -> Vec<T> {
            if values.is_empty() { Vec::new() } else { own.iter().map(|&vertex| values[vertex]).collect() }
        }
        let target = |target: &MorphTarget| MorphTarget {
            positions: chosen(&target.positions, own),
            normals: chosen(&target.normals, own),
        };
        let influences = own.iter().flat_map(|&vertex| self.influences.of(vertex).iter().copied());
        Self {
            vertices: first..first + own.len(),
            positions: chosen(&self.positions, own),
            normals: chosen(&self.normals, own),
            influences: Influences { weights: influences.collect(), ..self.influences },
            targets: self.targets.iter().map(target).collect(),
            weights: self.weights.clone(),
            ..*self
        }
    }
}

fn displaced(start: DVec3, targets: &[(&MorphTarget, f64)], by: impl Fn(&MorphTarget) -> DVec3) -> DVec3 {
    targets.iter().fold(start, |sum, &(target, weight)| sum + weight * by(target))
}

/// Linear blend skinning. Quantised weights need not sum to 1 exactly.
fn blended(joints: &[DMat4], influences: &[(u16, f32)]) -> DMat4 {
    let (mut sum, mut total) = (DMat4::ZERO, 0.0);
    for &(joint, weight) in influences.iter().filter(|&&(_, weight)| weight != 0.0) {
        sum += joints[usize::from(joint)] * f64::from(weight);
        total += f64::from(weight);
    }
    if total == 0.0 { DMat4::IDENTITY } else { sum * (1.0 / total) }
}

/// How normals are turned: by the inverse transpose of the matrix that places are turned by, here without its scale, which may
/// be 0.
#[derive(Clone, Copy)]
struct Turn(DMat3);

impl Turn {
    fn of(world_from_mesh: DMat4) -> Self {
        let [x, y, z] =
            [world_from_mesh.x_axis, world_from_mesh.y_axis, world_from_mesh.z_axis].map(|axis| axis.truncate());
        let sign = x.cross(y).dot(z).signum();
        Self(DMat3::from_cols(y.cross(z) * sign, z.cross(x) * sign, x.cross(y) * sign))
    }

    fn normal(&self, normal: DVec3) -> DVec3 {
        (self.0 * normal).normalize_or_zero()
    }
}
