//! Fans of one surface that touch in a vertex without an edge or a vertex of the file in common. Distance must not take
//! a short cut there, so they are parted; but where the touch is all that holds two components together, it is kept.

use std::collections::HashSet;

use glam::DVec3;
use heatwalk_base::csr::NONE;
use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;

use crate::edges::{Corners, Edges};
use crate::element::{Element, FaceId, HalfedgeId, InputVertex, VertexId};

/// What tells the fans at welded vertices apart.
pub struct Fans<'a, I> {
    pub corners: &'a Corners,
    pub edges: &'a Edges,
    /// The vertex of the file at a corner.
    pub input: I,
}

/// What two corners at a vertex may have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Common {
    Neighbour(VertexId),
    Input(InputVertex),
}

/// Lists used at each vertex anew.
#[derive(Default)]
struct Scratch {
    /// What corners have in common, each with the place of a corner that has it.
    keys: Vec<(Common, usize)>,
    /// The fan of each corner, named by its first corner, and its place.
    fans: Vec<(u32, usize)>,
}

impl<I: Fn(HalfedgeId) -> InputVertex> Fans<'_, I> {
    /// Gives each further fan of a component at a vertex a vertex of its own, at the same position, after the last one.
    /// `vertex_of_input` has [`NONE`] for vertices that no face uses. Returns whether any fan got one.
    pub fn part_touching(
        &self,
        faces: &mut [[VertexId; 3]],
        positions: &mut Vec<DVec3>,
        vertex_of_input: &mut [u32],
    ) -> bool {
        let mut inputs = vec![0_u32; positions.len()];
        for &vertex in vertex_of_input.iter().filter(|&&vertex| vertex != NONE) {
            inputs[vertex as usize] += 1;
        }
        // The corners of each fan at vertices where there are several.
        let mut touching: Vec<Vec<Vec<HalfedgeId>>> = Vec::new();
        let mut scratch = Scratch::default();
        for (_, corners) in self.corners.rows().filter(|&(vertex, _)| inputs[vertex.index()] > 1) {
            touching.extend(self.at_vertex(corners, faces, &mut scratch));
        }
        if touching.is_empty() {
            return false;
        }
        let components = self.components(faces.len());
        let before = positions.len();
        for fans in touching {
            let mut here = HashSet::new();
            for fan in fans {
                let component = components.least(fan[0].triangle().0);
                if here.insert(component) {
                    continue;
                }
                positions.push(positions[faces[fan[0].triangle().index()][fan[0].corner()].index()]);
                let vertex = VertexId::from_index(positions.len() - 1);
                for corner in fan {
                    vertex_of_input[(self.input)(corner).index()] = vertex.0;
                    faces[corner.triangle().index()][corner.corner()] = vertex;
                }
            }
        }
        positions.len() > before
    }

    /// Groups the corners at a vertex by what they have in common: other ends of their edges, or vertices of the file.
    /// `None` where they are one fan.
    fn at_vertex(
        &self,
        corners: &[HalfedgeId],
        faces: &[[VertexId; 3]],
        scratch: &mut Scratch,
    ) -> Option<Vec<Vec<HalfedgeId>>> {
        let Scratch { keys, fans } = scratch;
        keys.clear();
        for (index, &corner) in corners.iter().enumerate() {
            let (face, k) = (faces[corner.triangle().index()], corner.corner());
            let neighbours = [face[(k + 1) % 3], face[(k + 2) % 3]].map(Common::Neighbour);
            keys.extend(neighbours.into_iter().chain([Common::Input((self.input)(corner))]).map(|key| (key, index)));
        }
        sort::sort(keys);
        let sets = UnionFind::new(corners.len());
        for pair in keys.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            sets.join(pair[0].1 as u32, pair[1].1 as u32);
        }
        fans.clear();
        fans.extend((0..corners.len()).map(|index| (sets.least(index as u32), index)));
        if fans.iter().all(|&(first, _)| first == 0) {
            return None;
        }
        sort::sort(fans);
        let of_fan = |fan: &[(u32, usize)]| fan.iter().map(|&(_, index)| corners[index]).collect();
        Some(fans.chunk_by(|a, b| a.0 == b.0).map(of_fan).collect())
    }

    /// Faces that edges or vertices of the file hold together.
    fn components(&self, faces: usize) -> UnionFind {
        let components = UnionFind::new(faces);
        for last in self.edges.representatives() {
            for side in self.edges.around(last) {
                components.join(last.triangle().0, side.triangle().0);
            }
        }
        let mut of_inputs: Vec<(InputVertex, FaceId)> = Vec::new();
        for (_, corners) in self.corners.rows() {
            of_inputs.clear();
            of_inputs.extend(corners.iter().map(|&corner| ((self.input)(corner), corner.triangle())));
            sort::sort(&mut of_inputs);
            for pair in of_inputs.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
                components.join(pair[0].1.0, pair[1].1.0);
            }
        }
        components
    }
}
