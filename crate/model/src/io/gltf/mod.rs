//! glTF 2.0 and GLB. The JSON is parsed by the gltf crate; buffers, accessors and the scene are read here, with every
//! index and offset checked, since the crate's own readers panic on damaged files. Geometry may be compressed by Draco or
//! meshoptimizer.

mod accessor;
mod animation;
mod appearance;
mod attributes;
mod camera;
mod container;
mod deform;
mod document;
mod draco;
mod format;
mod instancing;
mod light;
mod meshopt;
mod pointer;
mod primitive;
mod scene;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use glam::{DMat4, DVec3, Vec3};
use gltf::json::{Mesh, Node, Root};
use heatwalk_surface::{Soup, Unit, WarningCode, Warnings};

use super::budget::Budget;
use super::format::Format;
use super::reader::Resources;
use crate::appearance::Run;
use crate::error::{Error, Result};
use crate::model::Model;
use crate::motion::{Clip, Deformer, Motion, Skin, Target};
use accessor::Accessors;
use appearance::{Collector, attributes_of};
use attributes::Named;
use container::Buffers;
use deform::Vertices;
use draco::Compressed;
use format::{GLB_MAGIC, element};
use scene::Scene;

pub const FORMAT: Format = Format {
    extensions: &["gltf", "glb"],
    is: |bytes| bytes.starts_with(GLB_MAGIC) || looks_like_json(bytes),
    read: |budget, _, bytes, resources| read(budget, bytes, resources),
    upward: Some(DVec3::Y),
};

fn looks_like_json(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.starts_with(b"{") && text.windows(7).any(|window| window == b"\"asset\"")
}

fn read(budget: &Budget, bytes: &[u8], resources: Resources) -> Result<Model> {
    let container = container::open(bytes)?;
    let root = document::parse(container.json)?;
    let buffers = Buffers::new(budget, &root, container.binary, resources);
    let accessors = Accessors { root: &root, buffers: &buffers, compressed: None };
    let scene = Scene::new(&root)?;
    let skins = deform::skins(&root, accessors)?;
    let clips = animation::clips(&root, accessors);
    let mut reading = Reading {
        root: &root,
        accessors,
        weighted_nodes: weighted(&clips),
        clips,
        world_from_mesh: skins.iter().map(|skin| skin.world_from_mesh(&scene.world_from_node)).collect(),
        scene: &scene,
        named: Named::new(container.json),
        skins,
        soup: Soup { unit: Some(Unit::Meter), ..Soup::default() },
        normals: Vec::new(),
        collector: Collector::default(),
        deformers: Vec::new(),
        warnings: Warnings::default(),
        points: Vec::new(),
    };
    for &index in &scene.mesh_nodes {
        reading.add_node(index)?;
    }
    if scene.mesh_nodes.is_empty() && !root.meshes.is_empty() {
        let reason = "no node of the scene that is shown has a mesh of the file; export it with its scene".to_owned();
        return Err(Error::empty(reason));
    }
    reading.finish()
}

fn weighted(clips: &[Clip]) -> HashSet<usize> {
    let channels = clips.iter().flat_map(|clip| &clip.channels);
    channels.filter(|channel| matches!(channel.target, Target::Weights(_))).map(|channel| channel.node).collect()
}

/// What has been read of a file.
struct Reading<'a> {
    root: &'a Root,
    accessors: Accessors<'a>,
    scene: &'a Scene,
    /// Attributes of no meaning to glTF.
    named: Named,
    skins: Vec<Skin>,
    /// Of each joint, for each skin.
    world_from_mesh: Vec<Vec<DMat4>>,
    clips: Vec<Clip>,
    /// Those whose weights of morph targets a clip changes.
    weighted_nodes: HashSet<usize>,
    soup: Soup,
    /// Of each vertex, zero for none.
    normals: Vec<Vec3>,
    collector: Collector,
    /// Of all vertices, where there are clips.
    deformers: Vec<Deformer>,
    warnings: Warnings,
    /// Those of primitives that are points, as they stand.
    points: Vec<DVec3>,
}

impl<'a> Reading<'a> {
    fn budget(&self) -> &'a Budget {
        self.accessors.buffers.budget
    }

    /// Adds the mesh of a node as a part.
    fn add_node(&mut self, index: usize) -> Result<()> {
        let root = self.root;
        let node = &root.nodes[index];
        let Some(mesh_index) = node.mesh else { return Ok(()) };
        let mesh = element(&root.meshes, mesh_index, "mesh")?;
        // What a skin places is not below its node.
        let instances = match node.skin {
            Some(_) => vec![DMat4::IDENTITY],
            None => instancing::instances(self.accessors, index, node)?,
        };
        for &node_from_mesh in &instances {
            self.add_instance((index, node), mesh, node_from_mesh)?;
        }
        let name = node.name.as_ref().or(mesh.name.as_ref()).filter(|name| !name.is_empty());
        self.budget().take_part(name.map_or("", String::as_str))?;
        self.soup.end_part(name.cloned().unwrap_or_else(|| format!("node {index}")));
        Ok(())
    }

    /// Adds a mesh as it stands below its node.
    fn add_instance(&mut self, (index, node): (usize, &Node), mesh: &Mesh, node_from_mesh: DMat4) -> Result<()> {
        let weights = node.weights.as_deref().or(mesh.weights.as_deref()).unwrap_or_default();
        let is_weighted = self.weighted_nodes.contains(&index);
        let budget = self.budget();
        let start = self.soup.triangles.len();
        let mut first_vertices = HashMap::new();
        for (number, primitive) in mesh.primitives.iter().enumerate() {
            budget.take_items::<Run>(1)?;
            // What moves keeps all that was read of it.
            let _loan = self.clips.is_empty().then(|| budget.loan());
            let Some(position) = primitive::triangles_over(primitive)? else {
                self.warnings.add(WarningCode::LinesLeftOut, || format!("primitive {number} of node {index}"));
                if let Some(position) = primitive::points_over(primitive) {
                    let positions = self.accessors.vectors(position)?;
                    let world_from_mesh = self.scene.world_from_node[index] * node_from_mesh;
                    budget.reserve(&mut self.points, positions.len())?;
                    self.points.extend(positions.into_iter().map(|at| world_from_mesh.transform_point3(at)));
                }
                continue;
            };
            let compressed = Compressed::of(primitive, self.accessors.buffers)?;
            let accessors = self.accessors.of(compressed.as_ref());
            // Primitives of one mesh often index one set of vertices; morph targets could make the same set differ.
            let attributes = (position, attributes_of(primitive), draco::view(primitive));
            let shared = first_vertices.get(&attributes).filter(|_| primitive.targets.is_none());
            let (first, count) = if let Some(&first) = shared {
                (first, accessors.count(position)?)
            } else {
                let first = self.soup.positions.len();
                let positions = accessors.vectors(position)?;
                let range = first..first + positions.len();
                self.collector.add_vertices(accessors, primitive, &range)?;
                let place = (node.mesh.map_or(0, |mesh| mesh.value()), number);
                self.named.add(accessors, place, &range, &mut self.soup.attributes)?;
                let count = positions.len();
                let vertices = Vertices { accessors, primitive, positions, range };
                let deformer = vertices.deformer((index, node), &self.skins, weights, is_weighted)?;
                self.place(deformer.below(node_from_mesh))?;
                first_vertices.entry(attributes).or_insert(first);
                (first, count)
            };
            let first_triangle = self.soup.triangles.len();
            primitive::append_triangles(accessors, primitive, first, count, &mut self.soup.triangles)?;
            self.collector.add_triangles(primitive, first_triangle..self.soup.triangles.len());
        }
        // A mirroring transform turns every triangle inside out (glTF 2.0, 3.7.4). A skin places the vertices in the scene by
        // itself: the node's own transform is ignored (3.7.3.3).
        let world_from_mesh = self.scene.world_from_node[index] * node_from_mesh;
        if node.skin.is_none() && world_from_mesh.determinant() < 0.0 {
            self.soup.triangles[start..].iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        Ok(())
    }

    /// Places vertices as they stand in the file.
    fn place(&mut self, deformer: Deformer) -> Result<()> {
        let budget = self.budget();
        let Self { scene, world_from_mesh, soup, normals, .. } = self;
        budget.resize(&mut soup.positions, deformer.vertices.end, DVec3::ZERO)?;
        budget.resize(normals, deformer.vertices.end, Vec3::ZERO)?;
        deformer.place(&scene.world_from_node, world_from_mesh, &deformer.weights, &mut soup.positions, normals);
        if !self.clips.is_empty() {
            budget.push(&mut self.deformers, deformer)?;
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Model> {
        let Self { root, accessors, normals, collector, warnings, .. } = self;
        self.soup.warnings = warnings.into_vec();
        let budget = accessors.buffers.budget;
        let appearance = collector.finish(root, accessors.buffers, self.soup.positions.len(), normals)?;
        let vertices = self.soup.positions.len();
        for attribute in &mut self.soup.attributes {
            budget.resize(&mut attribute.values, vertices, f64::NAN)?;
        }
        if vertices == 0 {
            // A cloud, of which surfaces can be made.
            self.soup.positions = self.points;
        }
        let motion = Motion::new(self.scene.hierarchy.clone(), self.skins, self.deformers, self.clips)?;
        Ok(Model {
            soup: self.soup,
            appearance: Arc::new(appearance),
            motion: Arc::new(motion),
            cameras: camera::cameras(budget, root, self.scene)?,
            lights: light::lights(root, self.scene),
        })
    }
}
