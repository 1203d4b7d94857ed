//! How much of its surroundings the scene hides from each place in it: ambient occlusion, in a coarse grid.
//!
//! Light from one direction is carried through the grid slice by slice and dimmed where there is surface. The share that
//! arrives, over all directions, is kept in spherical harmonics of the first degree: Ramamoorthi and Hanrahan, "An
//! efficient representation for irradiance environment maps" (2001). So shading can ask for any normal and any mirrored
//! direction.

use glam::{Quat, Vec3, Vec4};

use crate::bounding_sphere::BoundingSphere;
use crate::scatter::scatter;

/// Cells along a side of the grid.
pub const OCCLUSION_SIZE: usize = 64;
/// Cells between the scene and the sides of the grid.
const MARGIN: f32 = 2.5;
/// What one layer of surface does: of the light e^−DEPTH comes through.
const DEPTH: f32 = 3.0;
/// Cells over which what hides the surroundings loses all but 1/e of its effect: what is far away is lit itself.
const REACH: f32 = 28.0;

const CELLS: usize = OCCLUSION_SIZE * OCCLUSION_SIZE * OCCLUSION_SIZE;
/// Cells along a side of a slice with a rim of one cell, where all is open.
const RIMMED: usize = OCCLUSION_SIZE + 2;

/// The cube that the grid fills.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube {
    /// Least corner; world space.
    pub low: Vec3,
    /// World units.
    pub side: f32,
}

impl Cube {
    /// Around a scene.
    #[must_use]
    pub fn around(scene: BoundingSphere) -> Self {
        let cells = OCCLUSION_SIZE as f32;
        let side = scene.side * cells / (cells - 2.0 * MARGIN);
        Self { low: scene.center - 0.5 * side, side }
    }
}

/// A grid that is being filled with surface.
pub(crate) struct Occlusion {
    cube: Cube,
    /// Layers of surface in each cell, x fastest.
    layers: Vec<f32>,
}

impl Occlusion {
    pub(crate) fn new(cube: Cube) -> Self {
        Self { cube, layers: vec![0.0; CELLS] }
    }

    fn cell(&self) -> f32 {
        self.cube.side / OCCLUSION_SIZE as f32
    }

    /// Adds the triangles of a mesh, which must lie in the cube.
    pub(crate) fn add(&mut self, positions: &[Vec3], triangles: &[[u32; 3]]) {
        let (low, cell) = (self.cube.low, self.cell());
        let layers = &mut self.layers;
        scatter(positions, triangles, 0.7 * cell, |point, area| {
            let place = (point - low) / cell - 0.5;
            let first = place.floor();
            let high = place - first;
            let corner = first.as_usizevec3();
            let start = corner.x + OCCLUSION_SIZE * (corner.y + OCCLUSION_SIZE * corner.z);
            let weights = [Vec3::ONE - high, high];
            for [x, y, z] in (0..8).map(|corner| [corner & 1, corner >> 1 & 1, corner >> 2]) {
                let weight = weights[x].x * weights[y].y * weights[z].z;
                layers[start + x + OCCLUSION_SIZE * (y + OCCLUSION_SIZE * z)] += weight * area / (cell * cell);
            }
        });
    }

    /// Four bytes a cell, x fastest, 0 to 255: the mean direction from which light comes, shifted and scaled from ±1/4 to
    /// 0..1, and the mean share of light that comes.
    pub(crate) fn into_texels(self) -> Vec<u8> {
        let mut light = vec![Vec4::ZERO; CELLS];
        for direction in directions() {
            self.carry(direction, &mut light);
        }
        let share = 1.0 / directions().count() as f32;
        let texel = |sum: Vec4| {
            let mean = share * sum;
            let unit = (0.5 + 2.0 * mean.truncate()).extend(mean.w);
            (255.0 * unit + 0.5).to_array().map(|byte| byte as u8)
        };
        light.into_iter().flat_map(texel).collect()
    }

    /// Adds the light that comes from a direction (unit length) to every cell: the direction, and 1, by the share.
    fn carry(&self, direction: Vec3, light: &mut [Vec4]) {
        let axis = direction.abs().max_position();
        let across = [(axis + 1) % 3, (axis + 2) % 3];
        let stride = [1, OCCLUSION_SIZE, OCCLUSION_SIZE * OCCLUSION_SIZE];
        // From the middle of a cell to the slice before it, the one that light comes from.
        let step = direction / direction[axis].abs();
        let length = step.length();
        let depth = DEPTH * length;
        let fade = (-length / REACH).exp();
        let shift = across.map(|axis| step[axis]);
        let whole = shift.map(|shift| shift.floor().min(0.0));
        let [u, v] = [shift[0] - whole[0], shift[1] - whole[1]];
        let weights = [(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v];
        let offset = (whole[0] as isize + 1) + (whole[1] as isize + 1) * RIMMED as isize;

        let mut before = vec![1.0_f32; RIMMED * RIMMED];
        let mut behind = before.clone();
        for index in 0..OCCLUSION_SIZE {
            let slice = if direction[axis] > 0.0 { OCCLUSION_SIZE - 1 - index } else { index };
            for row in 0..OCCLUSION_SIZE {
                let start = slice * stride[axis] + row * stride[across[1]];
                let rimmed = (row * RIMMED).wrapping_add_signed(offset);
                let near = &before[rimmed..=rimmed + OCCLUSION_SIZE];
                let far = &before[rimmed + RIMMED..=rimmed + RIMMED + OCCLUSION_SIZE];
                let leaving = &mut behind[(row + 1) * RIMMED + 1..][..OCCLUSION_SIZE];
                for column in 0..OCCLUSION_SIZE {
                    let arriving = weights[0] * near[column]
                        + weights[1] * near[column + 1]
                        + weights[2] * far[column]
                        + weights[3] * far[column + 1];
                    let cell = start + column * stride[across[0]];
                    light[cell] += arriving * direction.extend(1.0);
                    // e^−x to its second order.
                    let x = depth * self.layers[cell];
                    leaving[column] = 1.0 - fade * (1.0 - arriving / (1.0 + x + 0.5 * x * x));
                }
            }
            std::mem::swap(&mut before, &mut behind);
        }
    }
}

/// Even over the sphere: corners of an icosahedron and of a dodecahedron, in opposite pairs, turned so that none of them
/// runs along walls that stand along the axes.
fn directions() -> impl Iterator<Item = Vec3> {
    let golden = 0.5 * (1.0 + 5.0_f32.sqrt());
    let rectangles = [(1.0, golden), (1.0, -golden), (golden.recip(), golden), (golden.recip(), -golden)];
    let turned =
        rectangles.into_iter().flat_map(|(a, b)| [Vec3::new(0.0, a, b), Vec3::new(a, b, 0.0), Vec3::new(b, 0.0, a)]);
    let diagonals = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(y, z)| Vec3::new(1.0, y, z));
    let tilt = Quat::from_scaled_axis(Vec3::new(0.2, 0.35, 0.5));
    turned.chain(diagonals).map(move |corner| tilt * corner.normalize()).flat_map(|direction| [direction, -direction])
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f32; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

    /// What shared.wgsl makes of the texels: the share of the surroundings that a matt surface sees, `above` cells over it.
    fn share(cube: Cube, texels: &[u8], point: Vec3, normal: Vec3, above: f32) -> f32 {
        let cells = OCCLUSION_SIZE as f32;
        let place = (point + normal * above * cube.side / cells - cube.low) * (cells / cube.side) - 0.5;
        let corner = place.floor();
        let high = place - corner;
        let weights = [Vec3::ONE - high, high];
        let mut sum = Vec4::ZERO;
        for [x, y, z] in (0..8).map(|corner| [corner & 1, corner >> 1 & 1, corner >> 2]) {
            let cell = corner.as_usizevec3() + glam::USizeVec3::new(x, y, z);
            let index = cell.x + OCCLUSION_SIZE * (cell.y + OCCLUSION_SIZE * cell.z);
            let texel = Vec4::from_array([0, 1, 2, 3].map(|channel| f32::from(texels[4 * index + channel]) / 255.0));
            sum += weights[x].x * weights[y].y * weights[z].z * texel;
        }
        sum.w + (sum.truncate() - 0.5).dot(normal)
    }

    fn scene(squares: &[[Vec3; 4]]) -> (Cube, Vec<u8>) {
        let positions: Vec<Vec3> = squares.iter().flatten().copied().collect();
        let cube = Cube::around(BoundingSphere::of_points(positions.iter()).expect("points"));
        let mut occlusion = Occlusion::new(cube);
        let triangles: Vec<[u32; 3]> = (0..squares.len() as u32)
            .flat_map(|i| [[4 * i, 4 * i + 1, 4 * i + 2], [4 * i, 4 * i + 2, 4 * i + 3]])
            .collect();
        occlusion.add(&positions, &triangles);
        (cube, occlusion.into_texels())
    }

    #[test]
    fn directions_are_even() {
        let all: Vec<Vec3> = directions().collect();
        assert_eq!(all.len(), 32);
        assert!(all.iter().all(|direction| direction.is_normalized()));
        assert!(all.iter().sum::<Vec3>().length() < 1e-5);
        for axis in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ONE.normalize()] {
            let square = all.iter().map(|direction| direction.dot(axis).powi(2)).sum::<f32>() / all.len() as f32;
            assert!((square - 1.0 / 3.0).abs() < 1e-5, "{square}");
        }
    }

    #[test]
    fn a_floor_is_open_above_and_half_hidden_beside_a_wall() {
        let floor = SQUARE.map(|[x, z]| Vec3::new(x, 0.0, z));
        let wall = SQUARE.map(|[y, z]| Vec3::new(0.0, y + 1.0, z));
        let normal = Vec3::Y;
        let (cube, open) = scene(&[floor]);
        let middle = share(cube, &open, Vec3::ZERO, normal, 1.75);
        // Near-level light grazes the floor's own cells.
        assert!(middle > 0.9, "{middle}");
        let (cube, texels) = scene(&[floor, wall]);
        let at = |x: f32| share(cube, &texels, Vec3::new(x, 0.0, 0.0), normal, 1.75);
        // Right beside an endless wall it is a half; this one ends, and what is far counts less.
        assert!(at(0.1) > 0.45 && at(0.1) < 0.72, "{}", at(0.1));
        assert!(at(0.1) < at(0.4) && at(0.4) < at(0.8) && at(0.8) <= middle + 0.02);
        assert!((at(0.3) - at(-0.3)).abs() < 0.05, "either side is alike");
    }

    #[test]
    fn the_bottom_of_a_pit_is_dark() {
        let bottom = SQUARE.map(|[x, z]| Vec3::new(0.3 * x, -2.0, 0.3 * z));
        let sides = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]]
            .map(|[x, z]| SQUARE.map(|[along, y]| Vec3::new(0.3 * (x + z * along), y - 1.0, 0.3 * (z + x * along))));
        let (cube, texels) = scene(&[bottom, sides[0], sides[1], sides[2], sides[3]]);
        let at = |y: f32| share(cube, &texels, Vec3::new(0.0, y, 0.0), Vec3::Y, 1.75);
        // The sky is a thirtieth of what the bottom sees; the sides, a quarter of the reach away and more, hide half of it.
        assert!(at(-2.0) < 0.5 && at(-2.0) < at(-0.1) - 0.2, "{} {}", at(-2.0), at(-0.1));
    }

    #[test]
    fn a_point_has_a_cube_and_hides_nothing() {
        let cube = Cube::around(BoundingSphere::of_points([Vec3::X].iter()).expect("a point"));
        assert!(cube.side > 0.0 && (cube.low + 0.5 * cube.side - Vec3::X).length() < 1e-6);
        let mut occlusion = Occlusion::new(cube);
        occlusion.add(&[Vec3::X], &[[0, 0, 0]]);
        let texels = occlusion.into_texels();
        let (texels, _) = texels.as_chunks::<4>();
        assert!(
            texels
                .iter()
                .all(|&[x, y, z, open]| open == 255 && [x, y, z].iter().all(|byte| (127..=128).contains(byte)))
        );
    }
}
