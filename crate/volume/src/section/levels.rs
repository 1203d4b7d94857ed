//! Marching tetrahedra (Doi and Koide 1991): where a distance has given values.

use std::collections::HashMap;

use glam::DVec3;

use super::Cut;
use super::crossing::CROSSED;
use super::cut::{Part, Side, Sides};
use super::shells::Shells;
use crate::distance::VolumeDistance;
use crate::error::{Error, Result};
use crate::mesh::{TetId, TetMesh};

impl Shells {
    /// Where a distance has these values, in any order, as far as a cut leaves it: triangles are clipped at its planes. Tetrahedra with
    /// a corner at infinity have none. A vertex of the mesh at just a level counts as beyond it.
    ///
    /// ```
    /// use glam::DVec3;
    /// use heatwalk_volume::section::{Cut, Shells};
    /// use heatwalk_volume::{TetMesh, VolumeOptions, VolumeSolver, shapes};
    ///
    /// let mut solver = VolumeSolver::new(TetMesh::build(&shapes::cube(8, 0.0))?);
    /// let middle = solver.mesh().locate(DVec3::ZERO).expect("inside");
    /// let distance = solver.distance(&[middle], &VolumeOptions::default())?;
    /// let shells = Shells::of(solver.mesh(), &distance, &[0.4, 0.8], &Cut::Whole)?;
    /// for (position, level) in shells.positions.iter().zip(&shells.values) {
    ///     assert!((position.length() / level - 1.0).abs() < 0.15);
    /// }
    /// # Ok::<(), heatwalk_volume::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::ForeignMesh`]; [`Error::BadLevel`] for a level that is not finite.
    pub fn of(mesh: &TetMesh, distance: &VolumeDistance, levels: &[f64], cut: &Cut) -> Result<Self> {
        Self::on(mesh, distance, levels, cut, Part::Left)
    }

    /// The same in what a cut takes away: there nothing of the mesh stands before them. Without a cut, all of them.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn in_cut(mesh: &TetMesh, distance: &VolumeDistance, levels: &[f64], cut: &Cut) -> Result<Self> {
        Self::on(mesh, distance, levels, cut, Part::TakenAway)
    }

    fn on(mesh: &TetMesh, distance: &VolumeDistance, levels: &[f64], cut: &Cut, part: Part) -> Result<Self> {
        distance.require(mesh)?;
        if let Some(&level) = levels.iter().find(|level| !level.is_finite()) {
            return Err(Error::BadLevel { level });
        }
        let mut levels = levels.to_vec();
        levels.sort_unstable_by(f64::total_cmp);
        levels.dedup();
        let mut march = March { mesh, values: &distance.values, vertices: HashMap::new(), shells: Self::default() };
        let sides = Sides::new(mesh, cut);
        for (tetrahedron, corners) in mesh.tetrahedra().iter().enumerate() {
            let values = corners.map(|vertex| distance.values[vertex as usize]);
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            let most = values.iter().copied().fold(0.0, f64::max);
            if most == f64::INFINITY {
                continue;
            }
            let first = levels.partition_point(|&level| level <= least);
            let crossed = levels[first..].iter().take_while(|&&level| level <= most);
            if first == levels.len() || levels[first] > most {
                continue;
            }
            let is_elsewhere = match part {
                Part::Left => sides.of(corners) == Side::Beyond,
                Part::TakenAway => !cut.planes().is_empty() && sides.of(corners) == Side::Before,
            };
            if is_elsewhere {
                continue;
            }
            for (level, &value) in crossed.enumerate() {
                march.cross(TetId(tetrahedron as u32), (first + level) as u32, value);
            }
        }
        let mut shells = march.finish();
        shells.clip(cut, part);
        Ok(shells)
    }
}

/// Marching tetrahedra in work.
struct March<'a> {
    mesh: &'a TetMesh,
    values: &'a [f64],
    /// By level and edge, or twice a vertex where that is at just the level.
    vertices: HashMap<(u32, [u32; 2]), u32>,
    shells: Shells,
}

impl March<'_> {
    /// Adds the triangles of one level in a tetrahedron.
    fn cross(&mut self, tetrahedron: TetId, number: u32, level: f64) {
        let corners = self.mesh.tetrahedra()[tetrahedron.index()];
        let is_beyond = |corner: usize| self.values[corners[corner] as usize] >= level;
        let mask = (0..4).filter(|&corner| is_beyond(corner)).fold(0, |mask, corner| mask | 1 << corner);
        let edges = CROSSED[mask].edges();
        let mut polygon = [0; 4];
        for (vertex, edge) in polygon.iter_mut().zip(edges) {
            *vertex = self.vertex(edge.map(|corner| corners[corner]), number, level);
        }
        for next in 2..edges.len() {
            let triangle @ [a, b, c] = [polygon[0], polygon[next - 1], polygon[next]];
            if a == b || b == c || c == a {
                continue;
            }
            // Normals of triangles, weighted by area: in each tetrahedron distance is linear, so they are along its gradient.
            let [at_a, at_b, at_c] = triangle.map(|vertex| self.shells.positions[vertex as usize]);
            let area = (at_b - at_a).cross(at_c - at_a);
            for vertex in triangle {
                self.shells.normals[vertex as usize] += area;
            }
            self.shells.triangles.push(triangle);
        }
    }

    /// Where an edge from below to beyond a level crosses it.
    fn vertex(&mut self, ends: [u32; 2], number: u32, level: f64) -> u32 {
        let [below, beyond] = ends.map(|end| self.values[end as usize]);
        let key = if beyond == level { [ends[1]; 2] } else { ends };
        let Self { mesh, vertices, shells, .. } = self;
        *vertices.entry((number, key)).or_insert_with(|| {
            let [from, to] = ends.map(|end| mesh.positions()[end as usize]);
            let share = (level - below) / (beyond - below);
            shells.positions.push(if beyond == level { to } else { from.lerp(to, share) });
            shells.normals.push(DVec3::ZERO);
            shells.values.push(level);
            shells.positions.len() as u32 - 1
        })
    }

    /// With normals of length 1.
    fn finish(self) -> Shells {
        let mut shells = self.shells;
        let mut ends = vec![[0; 2]; shells.positions.len()];
        for ((_, edge), vertex) in self.vertices {
            ends[vertex as usize] = edge;
        }
        for (normal, [from, to]) in shells.normals.iter_mut().zip(ends) {
            // Where areas underflow, the edge rises, too.
            let along = self.mesh.positions()[to as usize] - self.mesh.positions()[from as usize];
            *normal = normal.try_normalize().unwrap_or_else(|| along.normalize_or(DVec3::Z));
        }
        shells
    }
}
