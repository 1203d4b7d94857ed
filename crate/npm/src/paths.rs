//! Paths and walks.

use heatwalk::{
    Path, PathKind, Straightest, bezier, closed_geodesic, geodesic_loop, handle_loops, straighten, straightest,
};
use heatwalk_bindings::{Failure, Message, Result, reporter};
use js_sys::{Function, Object};
use wasm_bindgen::prelude::*;

use crate::distance::without;
use crate::given::{parsed, property};
use crate::mesh::Mesh;
use crate::options::distance_options;
use crate::places::Places;
use crate::vectors::vector;

/// A path on the surface.
#[derive(Message)]
pub struct ToldPath {
    /// Of each point a face that it lies on.
    pub faces: Vec<u32>,
    /// Three of each point: of the corners of its face, of sum 1.
    pub weights: Vec<f64>,
    /// Three coordinates of each point.
    pub points: Vec<f64>,
    /// In the unit of positions.
    pub length: f64,
    /// Its length, each part times what a unit of it costs.
    pub cost: f64,
}

/// A walk as straight as the surface lets one.
#[derive(Message)]
pub struct Walk {
    /// As those of a path.
    pub faces: Vec<u32>,
    /// As those of a path.
    pub weights: Vec<f64>,
    /// As those of a path.
    pub points: Vec<f64>,
    /// How far it came.
    pub length: f64,
    /// Unit vector of the direction at its end.
    pub direction: Vec<f64>,
    /// Whether the surface ended before.
    pub is_at_boundary: bool,
}

#[wasm_bindgen]
impl Mesh {
    /// The path from a place to another, in the order in which both are given.
    pub fn path(&self, places: &[f64], options: &Object, progress: &Function) -> Result<ToldPath> {
        let [start, end] = self.points(places)?[..] else {
            return Err(Failure::of("bad-place", "a path has two ends"));
        };
        let kind: PathKind = property(options, "kind").map_or(Ok(PathKind::default()), |kind| parsed("kind", &kind))?;
        let options = distance_options(&without(options, "kind"))?;
        let progress = &mut reporter(progress);
        let (path, cost) = self.with_solver(|solver| -> Result<_> {
            let path = if kind == PathKind::Exact {
                solver.path_between(start, end, progress)?
            } else {
                let answer = solver.distance(&[end], &options, progress)?;
                solver.path(&answer, start, kind)?
            };
            let cost = solver.cost_of(&path);
            Ok((path, cost))
        })?;
        Ok(self.told_as_path(&path, cost))
    }

    /// A locally shortest path beside the one that goes through places in turn.
    pub fn path_through(&self, places: &[f64], progress: &Function) -> Result<ToldPath> {
        let (points, progress) = (self.points(places)?, &mut reporter(progress));
        if points.len() < 2 {
            return Err(Failure::of("bad-place", "a path goes through two places at least"));
        }
        let (path, cost) = self.with_solver(|solver| -> Result<_> {
            let mut through = Vec::new();
            for ends in points.windows(2) {
                through.extend(solver.path_between(ends[0], ends[1], progress)?.points);
            }
            let surface = solver.surface();
            let path = straighten(surface, &Path::new(surface, through))?;
            let cost = solver.cost_of(&path);
            Ok((path, cost))
        })?;
        Ok(self.told_as_path(&path, cost))
    }

    /// The Bézier curve of control places.
    pub fn bezier(&self, places: &[f64], progress: &Function) -> Result<ToldPath> {
        let curve = bezier(&self.geometry(), &self.points(places)?, &mut reporter(progress))?;
        Ok(self.told_as_path(&curve.path, curve.path.length()))
    }

    /// The closed curve through places in turn, or the closed geodesic that it tightens to where it may leave them.
    pub fn loop_through(&self, places: &[f64], is_free: bool, progress: &Function) -> Result<ToldPath> {
        let held = geodesic_loop(&self.geometry(), &self.points(places)?, &mut reporter(progress))?;
        let path = if is_free { closed_geodesic(self.surface(), &held)? } else { held };
        Ok(self.told_as_path(&path, path.length()))
    }

    /// Closed geodesics around the handles and through them, the shortest first.
    pub fn handle_loops(&self, progress: &Function) -> Result<Vec<ToldPath>> {
        let loops = handle_loops(self.surface(), &mut reporter(progress))?;
        Ok(loops.iter().map(|path| self.told_as_path(path, path.length())).collect())
    }

    /// Walks straight on.
    pub fn walk(&self, start: &[f64], direction: &[f64], length: f64, face: Option<f64>) -> Result<Walk> {
        let (start, direction) = (self.point(start)?, vector(direction)?);
        let face = face.map(|face| self.surface().require_face(self.soup(), face as usize)).transpose()?;
        let Straightest { path, direction, is_at_boundary } =
            straightest(self.surface(), start, face, direction, length)?;
        let Places { faces, weights, points } = self.told_path(&path);
        let (length, direction) = (path.length(), direction.to_array().to_vec());
        Ok(Walk { faces, weights, points, length, direction, is_at_boundary })
    }
}

impl Mesh {
    fn told_as_path(&self, path: &Path, cost: f64) -> ToldPath {
        let Places { faces, weights, points } = self.told_path(path);
        ToldPath { faces, weights, points, length: path.length(), cost }
    }
}
