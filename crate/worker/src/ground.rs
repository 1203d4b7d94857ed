//! The ground as the page paints it: what a unit of length costs in each face, and walls.

use std::sync::Arc;

use glam::DVec3;
use heatwalk::surface::Error;
use heatwalk::{Costs, FaceData, FaceId, HalfedgeId, InputVertex, Place, Surface, VertexId, Walls, tobler};
use heatwalk_bindings::{Failure, Result};

use crate::drawn::Drawn;

/// What stands for a wall among costs.
const WALL: f64 = f64::INFINITY;

/// What the shape of the surface costs, on top of what is painted.
#[derive(Clone, Copy, PartialEq)]
pub struct Relief {
    /// Whether slopes cost what Tobler's hiking function says, as the mean of both directions.
    pub slope: bool,
    /// What it costs at the highest place, as a multiple of the lowest one; between, its logarithm grows with height.
    pub highest: f64,
}

impl Relief {
    const LEVEL: Self = Self { slope: false, highest: 1.0 };

    /// `#F`; none where it costs nothing.
    fn costs(self, surface: &Surface, up: DVec3) -> Result<Option<FaceData<f64>>> {
        let slope = if self.slope { Some(Costs::of_slope(surface, up, tobler)?) } else { None };
        let height = if self.highest == 1.0 { None } else { Some(self.height(surface, up)?) };
        Ok(match (slope, height) {
            (Some(slope), Some(height)) => {
                let both = slope.of_faces().iter().zip(height.of_faces()).map(|(slope, height)| slope * height);
                Some(both.collect())
            }
            (one, other) => one.or(other).map(|costs| costs.of_faces().clone()),
        })
    }

    fn height(self, surface: &Surface, up: DVec3) -> Result<Costs> {
        Ok(Costs::of_height(surface, up, |share| self.highest.powf(share))?)
    }
}

/// What is painted on a surface, and what follows from that.
#[derive(Clone)]
pub struct Ground {
    /// In the pose of the file, without walls.
    pub surface: Arc<Surface>,
    pub drawn: Arc<Drawn>,
    /// `#F`; infinite for walls.
    painted: FaceData<f64>,
    relief: Relief,
    /// `#F`, of the relief; none where it costs nothing.
    of_relief: Option<FaceData<f64>>,
    pub walls: Walls,
    /// None where all cost 1.
    pub costs: Option<Costs>,
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
            costs: None,
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
        self.costs = self.total()?;
        Ok(())
    }

    /// Of all faces; none where all cost 1. What a wall costs does not matter: as much as the first other face, so that it does
    /// not make costs differ.
    fn total(&self) -> Result<Option<Costs>> {
        let relief = |face: FaceId| self.of_relief.as_ref().map_or(1.0, |of_relief| of_relief[face]);
        let cost = |(face, &painted): (FaceId, &f64)| painted * relief(face);
        let Some(first) = self.painted.enumerate().map(cost).find(|&cost| cost != WALL) else { return Ok(None) };
        let in_range = |cost: f64| cost.clamp(*Costs::RANGE.start(), *Costs::RANGE.end());
        let of_face = self.painted.enumerate().map(cost).map(|cost| in_range(if cost == WALL { first } else { cost }));
        let costs = Costs::new(&self.surface, of_face.collect())?;
        Ok(Some(costs).filter(|costs| costs.constant() != Some(1.0)))
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
