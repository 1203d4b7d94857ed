//! Between places as the page knows them and places in the mesh. The page counts vertices and tetrahedra as the input does.

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_bindings::{Failure, Result, number, numbers};
use heatwalk_scene::DrawTransform;
use heatwalk_volume::{Error, TetId, TetMesh, TetPoint, TetSoup, TetSource, edge_polyline};
use wasm_bindgen::prelude::*;

/// What [`Drawn::point`] and [`Drawn::source`] read.
#[wasm_bindgen(typescript_custom_section)]
const PLACES: &str = "
/** A place in a tetrahedron of the input, with four weights of its corners that sum to 1. */
export type InnerPoint = { tetrahedron: number; weights: [number, number, number, number] };
";

/// A mesh whose boundary is drawn.
pub struct Drawn {
    soup: Arc<TetSoup>,
    mesh: Arc<TetMesh>,
    /// `#D`, the vertex that each drawn one is.
    vertices: Vec<VertexId>,
    /// `#F`, the tetrahedron that each drawn triangle is a face of.
    tetrahedra: Vec<Option<TetId>>,
    triangles: Vec<[u32; 3]>,
    /// `#T`, the tetrahedron of the input that each one is.
    input_of_tetrahedron: Vec<u32>,
    pub transform: DrawTransform,
}

impl Drawn {
    /// `inputs`: the vertices of the input that drawn ones are.
    pub fn new(
        soup: &Arc<TetSoup>,
        mesh: &Arc<TetMesh>,
        inputs: &[u32],
        triangles: &[[u32; 3]],
        transform: DrawTransform,
    ) -> Self {
        let own = |&input: &u32| mesh.vertex_of_input(input as usize).unwrap_or(VertexId(0));
        let vertices: Vec<VertexId> = inputs.iter().map(own).collect();
        let boundary = mesh.boundary();
        let faces: HashMap<[u32; 3], TetId> = (boundary.soup.triangles.iter())
            .map(|corners| sorted(corners.map(|corner| boundary.vertices[corner as usize].0)))
            .zip(boundary.tetrahedra)
            .collect();
        let tetrahedron =
            |corners: &[u32; 3]| faces.get(&sorted(corners.map(|corner| vertices[corner as usize].0))).copied();
        let mut input_of_tetrahedron = vec![0; mesh.tetrahedron_count()];
        for input in 0..soup.tetrahedra.len() {
            if let Some(tetrahedron) = mesh.tetrahedron_of_input(input) {
                input_of_tetrahedron[tetrahedron.index()] = input as u32;
            }
        }
        Self {
            tetrahedra: triangles.iter().map(tetrahedron).collect(),
            soup: Arc::clone(soup),
            mesh: Arc::clone(mesh),
            vertices,
            triangles: triangles.to_vec(),
            input_of_tetrahedron,
            transform,
        }
    }

    /// `#F × 3`, the drawn triangles beside each drawn one, across the edges from its corners to the next; itself where there is none.
    pub fn neighbors(&self) -> Vec<u32> {
        let sides = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|corner| self.vertices[corner as usize].0);
            [[a, b], [b, c], [c, a]]
        };
        let own: HashMap<[u32; 2], u32> =
            (0..).zip(&self.triangles).flat_map(|(face, triangle)| sides(triangle).map(|side| (side, face))).collect();
        let beside = |(face, triangle): (u32, &[u32; 3])| {
            sides(triangle).map(|[from, to]| own.get(&[to, from]).copied().unwrap_or(face))
        };
        (0..).zip(&self.triangles).flat_map(beside).collect()
    }

    /// The shortest line along edges between two vertices of the input, as such vertices, both included.
    pub fn line(&self, ends: [u32; 2]) -> Result<Vec<u32>> {
        let [from, to] = ends.map(|input| self.vertex(input));
        let mut input_of_vertex = vec![0; self.mesh.vertex_count()];
        for input in 0..self.soup.positions.len() as u32 {
            if let Some(vertex) = self.mesh.vertex_of_input(input as usize) {
                input_of_vertex[vertex.0 as usize] = input;
            }
        }
        let line = edge_polyline(&self.mesh, &[from?, to?], false)?;
        Ok(line.into_iter().map(|vertex| input_of_vertex[vertex.0 as usize]).collect())
    }

    fn vertex(&self, input: u32) -> Result<VertexId> {
        let absent = Error::NoSuchVertex { vertex: input as usize, vertices: self.soup.positions.len() };
        Ok(self.mesh.vertex_of_input(input as usize).ok_or(absent)?)
    }

    /// Values of vertices as values of drawn vertices.
    pub fn spread(&self, values: &[f64]) -> Vec<f32> {
        self.vertices.iter().map(|vertex| values[vertex.0 as usize] as f32).collect()
    }

    /// Unit vectors of vertices, as they are drawn, as four bytes a drawn vertex, the last one 0.
    pub fn spread_directions(&self, directions: &[DVec3]) -> Vec<i8> {
        self.vertices.iter().flat_map(|vertex| self.bytes(directions[vertex.0 as usize])).collect()
    }

    /// A vector of at most unit length as it is drawn: 127 for a unit; the fourth is 0.
    pub fn bytes(&self, vector: DVec3) -> [i8; 4] {
        (127.0 * self.transform.direction(vector)).as_i8vec3().extend(0).to_array()
    }

    /// Vectors of tetrahedra as vectors of the drawn triangles, turned as they are drawn, three numbers each.
    pub fn spread_vectors(&self, vectors: &[DVec3]) -> Vec<f32> {
        let of = |tetrahedron: &Option<TetId>| tetrahedron.map_or(DVec3::ZERO, |own| vectors[own.index()]);
        self.transform.directions(self.tetrahedra.iter().map(of))
    }

    /// The tetrahedron of the input that a tetrahedron is.
    pub fn input_of(&self, tetrahedron: TetId) -> u32 {
        self.input_of_tetrahedron[tetrahedron.index()]
    }

    /// Barycentric weights by the corners that a tetrahedron has in the input.
    pub fn input_weights(&self, tetrahedron: TetId, weights: [f64; 4]) -> [f64; 4] {
        let corners = self.mesh.tetrahedra()[tetrahedron.index()];
        self.corners_of_input(self.input_of(tetrahedron) as usize)
            .map(|vertex| corners.iter().position(|&corner| corner == vertex).map_or(0.0, |corner| weights[corner]))
    }

    /// The vertices that a tetrahedron of the input has, in its order there.
    fn corners_of_input(&self, input: usize) -> [u32; 4] {
        let own = |corner: u32| self.mesh.vertex_of_input(corner as usize).map_or(u32::MAX, |vertex| vertex.0);
        self.soup.tetrahedra[input].map(own)
    }

    /// The tetrahedra as they came.
    pub fn soup(&self) -> &TetSoup {
        &self.soup
    }

    /// Values of vertices as values of vertices of the input.
    pub fn to_inputs(&self, values: &[f64]) -> Vec<f32> {
        self.mesh.to_inputs(values, f64::INFINITY).into_iter().map(|value| value as f32).collect()
    }

    /// Reads `{ vertex }`, `{ face, weights }` of a drawn triangle, or `{ tetrahedron, weights }`.
    pub fn point(&self, place: &JsValue) -> Result<TetPoint> {
        if let Some(vertex) = number(place, "vertex") {
            return Ok(TetPoint::Vertex(self.vertex(vertex as u32)?));
        }
        let weights = numbers(place, "weights");
        let weight = |corner: usize| weights.get(corner).copied().unwrap_or(f64::NAN);
        let (tetrahedron, named): (TetId, Vec<(u32, f64)>) = if let Some(face) = number(place, "face") {
            let tetrahedron = self.tetrahedra.get(face as usize).copied().flatten();
            let tetrahedron = tetrahedron.ok_or_else(|| Failure::misuse("there is no such triangle"))?;
            let corners = self.triangles[face as usize].map(|corner| self.vertices[corner as usize].0);
            (tetrahedron, corners.into_iter().zip((0..3).map(weight)).collect())
        } else {
            let input =
                number(place, "tetrahedron").ok_or_else(|| Failure::misuse("this is no place in a mesh"))? as usize;
            let tetrahedra = self.soup.tetrahedra.len();
            let absent = Error::NoSuchTetrahedron { tetrahedron: input, tetrahedra };
            let tetrahedron = self.mesh.tetrahedron_of_input(input).ok_or(absent)?;
            (tetrahedron, self.corners_of_input(input).into_iter().zip((0..4).map(weight)).collect())
        };
        let weight_of = |vertex: u32| named.iter().find(|&&(other, _)| other == vertex).map_or(0.0, |&(_, own)| own);
        let weights = self.mesh.tetrahedra()[tetrahedron.index()].map(weight_of);
        Ok(TetPoint::Inside { tetrahedron, weights }.checked(&self.mesh)?)
    }

    /// Reads a place and its `offset`, the value that distances start from there; 0 when absent.
    pub fn source(&self, place: &JsValue) -> Result<TetSource> {
        Ok(TetSource { point: self.point(place)?, initial_distance: number(place, "offset").unwrap_or(0.0) })
    }
}

fn sorted(mut corners: [u32; 3]) -> [u32; 3] {
    corners.sort_unstable();
    corners
}
