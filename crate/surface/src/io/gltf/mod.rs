//! glTF 2.0 and GLB. The JSON is parsed by the gltf crate; buffers, accessors and the scene are read here, with every
//! index and offset checked, since the crate's own readers panic on damaged files. Geometry may be compressed by Draco or
//! meshoptimizer.

mod accessor;
mod container;
mod deform;
mod document;
mod draco;
mod format;
mod meshopt;
mod primitive;
mod scene;

use glam::DMat4;
use gltf::json::Root;

use super::reader::Resources;
use crate::error::{Error, Result};
use crate::soup::Soup;
use accessor::Accessors;
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
    let mut soup = Soup::default();
    for &index in &scene.mesh_nodes {
        add_node(&mut soup, &root, accessors, &scene, index)?;
    }
    Ok(soup)
}

/// Adds the mesh of a node as a part.
fn add_node(soup: &mut Soup, root: &Root, accessors: Accessors, scene: &Scene, index: usize) -> Result<()> {
    let node = &root.nodes[index];
    let Some(mesh_index) = node.mesh else { return Ok(()) };
    let mesh = element(&root.meshes, mesh_index, "mesh")?;
    let weights = node.weights.as_deref().or(mesh.weights.as_deref()).unwrap_or_default();
    // A skin places the vertices in the scene by itself: the node's own transform is ignored (glTF 2.0, 3.7.3.3).
    let joints = node.skin.map(|skin| deform::joint_matrices(root, accessors, scene, skin)).transpose()?;
    let world_from_node = if joints.is_some() { DMat4::IDENTITY } else { scene.world_from_node[index] };

    let start = soup.triangles.len();
    let mut first_vertices: Vec<((u32, Option<u32>), usize)> = Vec::new();
    for primitive in &mesh.primitives {
        let Some(position) = primitive::triangles_over(primitive)? else { continue };
        let compressed = Compressed::of(primitive, accessors.buffers)?;
        let accessors = accessors.of(compressed.as_ref());
        // Primitives of one mesh often index one set of vertices; morph targets could make the same set differ.
        let vertices = (position, draco::view(primitive));
        let shared = first_vertices.iter().find(|&&(known, _)| known == vertices && primitive.targets.is_none());
        let (first, count) = if let Some(&(_, first)) = shared {
            (first, accessors.count(position)?)
        } else {
            let first = soup.positions.len();
            let mut positions = accessors.vectors(position)?;
            if first + positions.len() > MAX_VERTICES {
                return Err(Error::OutOfMemory { stage: "reading the glTF file" });
            }
            deform::morph(accessors, primitive, weights, &mut positions)?;
            if let Some(joints) = &joints {
                deform::skin(accessors, primitive, joints, &mut positions)?;
            }
            soup.positions.extend(positions.iter().map(|&point| world_from_node.transform_point3(point)));
            first_vertices.push((vertices, first));
            (first, soup.positions.len() - first)
        };
        primitive::append_triangles(accessors, primitive, first, count, &mut soup.triangles)?;
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
