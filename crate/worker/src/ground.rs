//! The ground as the page paints it: what a unit of length costs in each face, and walls.

use std::sync::Arc;

use heatwalk::surface::Error;
use heatwalk::{Costs, FaceData, FaceId, HalfedgeId, InputVertex, Place, Relief, Surface, VertexId, Walls};
use heatwalk_bindings::{Failure, Result};

use crate::drawn::Drawn;

/// What stands for a wall among costs.
const WALL: f64 = f64::INFINITY;

/// What is painted on a surface, and what follows from that.
#[derive(Clone)]
pub struct Ground {
    /// In the pose of the file, without walls.
    pub surface: Arc<Surface>,
    pub drawn: Arc<Drawn>,
    /// `#F`; infinite for walls.
    painted: FaceData<f64>,
    relief: Relief,
    /// None where the relief costs nothing.
    of_relief: Option<Costs>,
    pub walls: Walls,
}

impl Ground {
    /// Where everything costs 1.
    pub fn new(surface: &Arc<Surface>, drawn: &Arc<Drawn>) -> Self {
        Self {
            surface: Arc::clone(surface),
            drawn: Arc::clone(drawn),
            painted: vec![1.0; surface.face_count()].into(),
            relief: Relief::LEVEL,
            of_relief: None,
            walls: Walls::default(),
        }
    }

    /// Paints drawn triangles, each at its cost; of walls along edges, `lines` are all that there are: how many vertices of the
    /// input one goes through, these, and so on.
    pub fn paint(&mut self, triangles: &[u32], costs: &[f64], lines: &[u32], relief: Relief) -> Result<()> {
        if triangles.len() != costs.len() {
            return Err(Failure::misuse("each triangle that is painted has one cost"));
        }
        for (&triangle, &cost) in triangles.iter().zip(costs) {
            let faces = self.surface.face_count();
            let absent = Error::NoSuchFace { face: triangle as usize, faces };
            self.painted[self.drawn.face(triangle).ok_or(absent)?] = cost;
        }
        if relief != self.relief {
            self.of_relief = relief.costs(&self.surface, self.drawn.up())?;
            self.relief = relief;
        }
        let faces = self.painted.enumerate().filter(|&(_, &cost)| cost == WALL).map(|(face, _)| face).collect();
        self.walls = Walls { faces, edges: self.edges(lines)? };
        Ok(())
    }

    /// Of all faces; none where nothing costs more or less than 1. What a wall costs makes no difference.
    pub fn costs(&self) -> Result<Option<Costs>> {
        let painted = if self.painted.iter().all(|&cost| cost == 1.0 || cost == WALL) {
            None
        } else {
            let cost = |&painted: &f64| if painted == WALL { 1.0 } else { painted };
            Some(Costs::new(&self.surface, self.painted.iter().map(cost).collect())?)
        };
        Ok(Costs::both(painted, self.of_relief.clone()))
    }

    /// The edges of lines through vertices of the input.
    fn edges(&self, lines: &[u32]) -> Result<Vec<HalfedgeId>> {
        let mut edges = Vec::new();
        let mut rest = lines;
        while let Some((&count, after)) = rest.split_first() {
            let through = after.get(..count as usize).ok_or_else(|| Failure::misuse("a line ends too soon"))?;
            rest = &after[count as usize..];
            let line: Vec<VertexId> = through
                .iter()
                .map(|&vertex| Ok(self.surface.require_vertex(InputVertex(vertex))?))
                .collect::<Result<_>>()?;
            for pair in line.windows(2) {
                let vertex = pair[1].0 as usize;
                edges.push(self.surface.halfedge_between(pair[0], pair[1]).ok_or(Error::NotAdjacent { vertex })?);
            }
        }
        Ok(edges)
    }

    /// The shortest line along edges from one vertex of the input to another, in vertices of the input.
    pub fn line(&self, from: u32, to: u32) -> Result<Vec<u32>> {
        let [from, to] = [from, to].map(|vertex| self.surface.require_vertex(InputVertex(vertex)));
        let line = heatwalk::edge_path(&self.surface, from?, to?)?;
        Ok(line.into_iter().map(|vertex| self.surface.inputs_of_vertex(vertex)[0].0).collect())
    }

    /// `#F × 3`, the drawn triangles beside each drawn one, across the edges from its corners to the next; itself at the
    /// boundary.
    pub fn neighbors(&self) -> Vec<u32> {
        let triangle_of = self.drawn.triangles();
        let across = |face: FaceId, k: usize| self.surface.edges().next_on_edge(face.halfedge(k)).triangle();
        let faces = self.drawn.faces().iter();
        faces.flat_map(|&face| [0, 1, 2].map(|k| triangle_of[across(face, k)])).collect()
    }

    /// Vertices that touch nothing but walls, of a surface that these have parted.
    pub fn vertices_in_walls(walled: &Surface) -> usize {
        walled.vertices().filter(|&vertex| walled.is_in_wall(Place::Vertex(vertex))).count()
    }
}
