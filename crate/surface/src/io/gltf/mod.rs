//! glTF 2.0 and GLB. The JSON is parsed by the gltf crate; buffers, accessors and the scene are read here, with every
//! index and offset checked, since the crate's own readers panic on damaged files. Geometry may be compressed by Draco or
//! meshoptimizer.

mod accessor;
mod appearance;
mod container;
mod deform;
mod document;
mod draco;
mod format;
mod meshopt;
mod primitive;
mod scene;

use std::sync::Arc;

use glam::DMat4;
use gltf::json::Root;

use super::reader::Resources;
use crate::error::{Error, Result};
use crate::soup::{Soup, Unit};
use accessor::Accessors;
use appearance::{Collector, attributes_of};
use container::Buffers;
use draco::Compressed;
pub use format::GLB_MAGIC;
use format::{MAX_VERTICES, element};
use scene::Scene;

pub fn read(bytes: &[u8], resources: Resources) -> Result<Soup> {
    let container = container::open(bytes)?;
    let root = document::parse(container.json)?;
    let buffers = Buffers::new(&root, container.binary, resources);
    let accessors = Accessors { root: &root, buffers: &buffers, compressed: None };
    let scene = Scene::new(&root)?;
    let mut soup = Soup { unit: Some(Unit::Meter), ..Soup::default() };
    let mut collector = Collector::default();
    for &index in &scene.mesh_nodes {
        add_node(&mut soup, &mut collector, &root, accessors, &scene, index)?;
    }
    soup.appearance = Arc::new(collector.finish(&root, &buffers, soup.positions.len()));
    Ok(soup)
}

/// Adds the mesh of a node as a part.
fn add_node(
    soup: &mut Soup,
    collector: &mut Collector,
    root: &Root,
    accessors: Accessors,
    scene: &Scene,
    index: usize,
) -> Result<()> {
    let node = &root.nodes[index];
    let Some(mesh_index) = node.mesh else { return Ok(()) };
    let mesh = element(&root.meshes, mesh_index, "mesh")?;
    let weights = node.weights.as_deref().or(mesh.weights.as_deref()).unwrap_or_default();
    // A skin places the vertices in the scene by itself: the node's own transform is ignored (glTF 2.0, 3.7.3.3).
    let joints = node.skin.map(|skin| deform::joint_matrices(root, accessors, scene, skin)).transpose()?;
    let world_from_node = if joints.is_some() { DMat4::IDENTITY } else { scene.world_from_node[index] };

    let start = soup.triangles.len();
    let mut first_vertices = Vec::new();
    for primitive in &mesh.primitives {
        let Some(position) = primitive::triangles_over(primitive)? else { continue };
        let compressed = Compressed::of(primitive, accessors.buffers)?;
        let accessors = accessors.of(compressed.as_ref());
        // Primitives of one mesh often index one set of vertices; morph targets could make the same set differ.
        let attributes = (position, attributes_of(primitive), draco::view(primitive));
        let shared = first_vertices.iter().find(|&&(known, _)| known == attributes && primitive.targets.is_none());
        let (first, count) = if let Some(&(_, first)) = shared {
            (first, accessors.count(position)?)
        } else {
            let first = soup.positions.len();
            let mut positions = accessors.vectors(position)?;
            if first + positions.len() > MAX_VERTICES {
                return Err(Error::OutOfMemory { stage: "reading the glTF file" });
            }
            deform::morph(accessors, primitive, weights, &mut positions)?;
            let skin = joints.as_ref().map(|joints| deform::skin(accessors, primitive, joints, positions.len()));
            let skin = skin.transpose()?;
            let world_from_vertex = |vertex: usize| skin.as_ref().map_or(world_from_node, |skin| skin[vertex]);
            let places = positions.iter().enumerate();
            soup.positions.extend(places.map(|(vertex, &point)| world_from_vertex(vertex).transform_point3(point)));
            // Displacements of normals are not read: a morphed mesh has the normals of its triangles.
            let is_morphed = primitive.targets.is_some() && weights.iter().any(|&weight| weight != 0.0);
            let turn = (!is_morphed).then_some(world_from_vertex);
            collector.add_vertices(accessors, primitive, first..soup.positions.len(), turn);
            first_vertices.push((attributes, first));
            (first, soup.positions.len() - first)
        };
        let first_triangle = soup.triangles.len();
        primitive::append_triangles(accessors, primitive, first, count, &mut soup.triangles)?;
        collector.add_triangles(primitive, first_triangle..soup.triangles.len());
    }
    if soup.triangles.len() > MAX_VERTICES {
        return Err(Error::OutOfMemory { stage: "reading the glTF file" });
    }
    // A mirroring transform turns every triangle inside out (glTF 2.0, 3.7.4).
    if world_from_node.determinant() < 0.0 {
        soup.triangles[start..].iter_mut().for_each(|triangle| triangle.swap(1, 2));
    }
    let name = node.name.as_ref().or(mesh.name.as_ref()).filter(|name| !name.is_empty());
    soup.end_part(name.cloned().unwrap_or_else(|| format!("node {index}")));
    Ok(())
}
