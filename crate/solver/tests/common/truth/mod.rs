//! Hostile meshes by random numbers, and the right distances on them.

pub mod brute_force;
pub mod developable;
mod double_double;
pub mod examine;
pub mod nasty;
mod random;
mod rows;
pub mod thin;

use glam::{DQuat, DVec2, DVec3};
use heatwalk::{Element, Soup, Surface};

use brute_force::all_distances;
pub use random::Random;

/// A mesh whose distances are known.
pub struct Case {
    pub kind: &'static str,
    pub soup: Soup,
    pub right: Right,
}

/// How distances are known.
pub enum Right {
    /// The surface unrolls to a convex piece of the plane, where the vertices of the soup lie here.
    Unrolled(Vec<DVec2>),
    /// The mesh is small.
    BruteForce,
}

impl Case {
    /// The triangles at any scale, in any position and order.
    fn placed(
        kind: &'static str,
        random: &mut Random,
        (mut positions, mut triangles): (Vec<DVec3>, Vec<[u32; 3]>),
        unrolled: Option<Vec<DVec2>>,
    ) -> Self {
        // Most often a size that files have, else one that only overflows where powers of lengths are taken.
        let exponent = random.between(-6.0, 6.0);
        let scale = 10_f64.powf(if exponent.abs() < 5.0 { exponent } else { 20.0 * exponent });
        let turn = if random.chance(0.8) { random.turn() } else { DQuat::IDENTITY };
        positions.iter_mut().for_each(|position| *position = turn * (*position * scale));
        let mut order: Vec<u32> = (0..positions.len() as u32).collect();
        if random.chance(0.8) {
            random.shuffle(&mut order);
            random.shuffle(&mut triangles);
            triangles.iter_mut().for_each(|triangle| random.shuffle(triangle));
        }
        let mut moved = positions.clone();
        order.iter().zip(&positions).for_each(|(&to, &position)| moved[to as usize] = position);
        triangles.iter_mut().flatten().for_each(|vertex| *vertex = order[*vertex as usize]);
        let right = unrolled.map_or(Right::BruteForce, |points| {
            let mut moved = points.clone();
            order.iter().zip(&points).for_each(|(&to, &point)| moved[to as usize] = point * scale);
            Right::Unrolled(moved)
        });
        Self { kind, soup: Soup::single(kind, moved, triangles), right }
    }

    /// `#V × #V` distances of a surface built from the soup.
    pub fn right_distances(&self, surface: &Surface) -> Vec<Vec<f64>> {
        match &self.right {
            Right::Unrolled(points) => {
                let at = |vertex| points[surface.inputs_of_vertex(vertex)[0].index()];
                let places: Vec<DVec2> = surface.vertices().map(at).collect();
                let row = |&from: &DVec2| places.iter().map(|to| to.distance(from)).collect();
                places.iter().map(row).collect()
            }
            Right::BruteForce => {
                let triangles: Vec<_> = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
                all_distances(surface.positions().as_slice(), &triangles)
            }
        }
    }

    /// `#V × #V` distances of the soup itself, of all its triangles that have three corners; `None` where welding joins
    /// vertices, which makes another surface of it.
    pub fn right_distances_unwelded(&self, surface: &Surface) -> Option<Vec<Vec<f64>>> {
        let report = surface.report();
        if report.welded_vertices > 0 || matches!(self.right, Right::Unrolled(_)) {
            return None;
        }
        let Soup { positions, triangles, .. } = &self.soup;
        let is_proper = |&[a, b, c]: &[u32; 3]| {
            let [p, q, r] = [a, b, c].map(|vertex| positions[vertex as usize]);
            p != q && q != r && r != p
        };
        let triangles: Vec<_> = triangles.iter().copied().filter(is_proper).collect();
        let inputs: Vec<usize> = surface.vertices().map(|vertex| surface.inputs_of_vertex(vertex)[0].index()).collect();
        let all = all_distances(positions, &triangles);
        Some(inputs.iter().map(|&from| inputs.iter().map(|&to| all[from][to]).collect()).collect())
    }
}
