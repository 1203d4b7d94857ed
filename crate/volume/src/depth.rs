//! Distance from the boundary.

use glam::DVec3;
use heatwalk::{NearestPlaces, Soup, Surface, VertexId};

use crate::error::Result;
use crate::mesh::TetMesh;

/// How far each vertex (`#V`) is inside of the boundary around its component, cavities included, in the file's unit: 0 on it.
///
/// It is exact. The ball around a vertex that touches the boundary has no boundary inside, so that the straight line to where they touch
/// stays in the mesh, and no way out is shorter. Where a component overlaps itself, its other sheet counts too.
///
/// # Errors
/// Those of [`Surface::build`] on the boundary, where it has no triangle with an area.
pub fn boundary_distance(mesh: &TetMesh) -> Result<Vec<f64>> {
    let boundary = mesh.boundary();
    let components = mesh.components();
    let mut around = vec![Vec::new(); mesh.report().components];
    for &corners in &boundary.soup.triangles {
        let first = boundary.vertices[corners[0] as usize];
        around[components[first.0 as usize] as usize]
            .extend(corners.map(|corner| boundary.soup.positions[corner as usize]));
    }
    let index = |corners: Vec<DVec3>| {
        let triangles = (0..corners.len() as u32 / 3).map(|triangle| [0, 1, 2].map(|k| 3 * triangle + k));
        let triangles = triangles.collect();
        let surface = Surface::build(&Soup::single("boundary", corners, triangles)).map_err(heatwalk::Error::from)?;
        Ok((NearestPlaces::new(&surface), surface))
    };
    let indices = around.into_iter().map(index).collect::<Result<Vec<_>>>()?;
    let is_on_boundary = mesh.is_on_boundary();
    let depth = |vertex: usize| {
        let (places, surface) = &indices[components[vertex] as usize];
        let nearest = places.nearest(surface, mesh.position(VertexId(vertex as u32)));
        nearest.filter(|_| !is_on_boundary[vertex]).map_or(0.0, |(_, distance)| distance)
    };
    Ok((0..mesh.vertex_count()).map(depth).collect())
}
