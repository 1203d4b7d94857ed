//! The order in which triangles that let light through are drawn: the farthest first.

use std::cmp::Ordering;

use glam::Vec3;

use crate::appearance::MeshRun;

/// Triangles that are put in order: more would take a noticeable part of each frame while the camera turns.
const MOST_TRIANGLES: usize = 1 << 17;

/// Changes of material; where the order of all triangles would need more, one material comes after the other.
const MOST_DRAWS: usize = 1 << 10;

/// Triangles in the order in which they are drawn.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Order {
    /// Indices of triangles.
    pub(crate) triangles: Vec<u32>,
    /// Consecutive ones of one material: ranges of `triangles`.
    pub(crate) draws: Vec<MeshRun>,
}

struct Listed {
    depth: f32,
    triangle: u32,
    run: usize,
}

/// The triangles of these runs, that with the farthest middle along `ahead` first; at one depth in the order of the file.
/// None for more than are put in order.
pub(crate) fn back_to_front(
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    runs: &[MeshRun],
    ahead: Vec3,
) -> Option<Order> {
    if runs.iter().map(|run| run.triangles.len()).sum::<usize>() > MOST_TRIANGLES {
        return None;
    }
    let list = |run: usize, triangle: u32| {
        let [a, b, c] = triangles[triangle as usize].map(|vertex| positions[vertex as usize]);
        Listed { depth: ahead.dot(a + b + c), triangle, run }
    };
    let of_run = |(run, MeshRun { triangles, .. }): (usize, &MeshRun)| {
        triangles.clone().map(move |triangle| list(run, triangle))
    };
    let mut listed: Vec<Listed> = runs.iter().enumerate().flat_map(of_run).collect();
    let farther =
        |one: &Listed, other: &Listed| other.depth.total_cmp(&one.depth).then(one.triangle.cmp(&other.triangle));
    listed.sort_unstable_by(farther);
    let mut draws = draws_of(&listed, runs);
    if draws.len() > MOST_DRAWS {
        let mut depths = vec![0.0; runs.len()];
        for Listed { depth, run, .. } in &listed {
            depths[*run] += depth / runs[*run].triangles.len() as f32;
        }
        let by_run = |one: &Listed, other: &Listed| match one.run == other.run {
            true => Ordering::Equal,
            false => depths[other.run].total_cmp(&depths[one.run]).then(one.run.cmp(&other.run)),
        };
        listed.sort_unstable_by(|one, other| by_run(one, other).then_with(|| farther(one, other)));
        draws = draws_of(&listed, runs);
    }
    Some(Order { triangles: listed.iter().map(|listed| listed.triangle).collect(), draws })
}

fn draws_of(listed: &[Listed], runs: &[MeshRun]) -> Vec<MeshRun> {
    let mut start = 0;
    let same = |one: &Listed, other: &Listed| runs[one.run].material == runs[other.run].material;
    let draw = |chunk: &[Listed]| {
        let triangles = start..start + chunk.len() as u32;
        start = triangles.end;
        MeshRun { triangles, material: runs[chunk[0].run].material }
    };
    listed.chunk_by(same).map(draw).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triangles across the z axis, one at each of these places on it.
    fn stack(places: &[f32]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let corners = |&z: &f32| [Vec3::new(0.0, 0.0, z), Vec3::new(1.0, 0.0, z), Vec3::new(0.0, 1.0, z)];
        let positions = places.iter().flat_map(corners).collect();
        (positions, (0..places.len() as u32).map(|index| [3 * index, 3 * index + 1, 3 * index + 2]).collect())
    }

    fn run(triangles: std::ops::Range<u32>, material: u32) -> MeshRun {
        MeshRun { triangles, material }
    }

    #[test]
    fn the_farthest_comes_first_whatever_its_material() {
        let (positions, triangles) = stack(&[1.0, 3.0, 9.0, 2.0, 2.0, 4.0]);
        // The third is not among them.
        let runs = [run(0..2, 7), run(3..6, 8)];
        let order = back_to_front(&positions, &triangles, &runs, Vec3::Z);
        let draws = vec![run(0..1, 8), run(1..2, 7), run(2..4, 8), run(4..5, 7)];
        assert_eq!(order, Some(Order { triangles: vec![5, 1, 3, 4, 0], draws }));
        let order = back_to_front(&positions, &triangles, &runs, Vec3::NEG_Z);
        assert_eq!(order.map(|order| order.triangles), Some(vec![0, 3, 4, 1, 5]));
    }

    #[test]
    fn many_changes_of_material_give_way_to_an_order_of_materials() {
        // Two runs that alternate in depth, the second half a step nearer.
        let count = MOST_DRAWS as u32;
        let places: Vec<f32> = (0..count).chain(0..count).map(|index| index as f32).collect();
        let (mut positions, triangles) = stack(&places);
        positions[3 * count as usize..].iter_mut().for_each(|place| place.z -= 0.5);
        let order = back_to_front(&positions, &triangles, &[run(0..count, 0), run(count..2 * count, 1)], Vec3::Z);
        let order = order.expect("few enough to be put in order");
        assert_eq!(order.draws, [run(0..count, 0), run(count..2 * count, 1)]);
        let expected: Vec<u32> = (0..count).rev().chain((count..2 * count).rev()).collect();
        assert!(order.triangles == expected, "within each the farthest first");
    }

    #[test]
    fn too_many_stay_in_the_order_of_the_file() {
        let count = MOST_TRIANGLES as u32 + 1;
        let order = back_to_front(&[Vec3::ZERO; 3], &vec![[0, 1, 2]; count as usize], &[run(0..count, 0)], Vec3::Z);
        assert_eq!(order, None);
    }
}
