//! How much the scene keeps light off the floor: dark where it stands, fading where it rises.

use glam::{Vec2, Vec3};

use crate::bounding_sphere::BoundingSphere;
use crate::scatter::scatter;

/// Cells along a side of the floor.
pub const CONTACT_SIZE: usize = 96;
/// Half a side of the floor, in bounding radii of the scene.
const REACH: f32 = 1.7;
/// Height from which on nothing is kept off, in bounding radii.
const HEIGHT: f32 = 0.55;
/// Half the width of the blur, in cells, and how often it is done: three boxes are nearly a bell.
const BLUR: usize = 2;
const BLURS: usize = 3;

/// A square of the floor under a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Floor {
    /// Its middle; world space.
    pub center: Vec3,
    /// Half a side; world units.
    pub reach: f32,
}

impl Floor {
    /// Under a scene.
    #[must_use]
    pub fn new(scene: BoundingSphere) -> Self {
        Self { center: scene.center.with_y(scene.lowest), reach: REACH * scene.radius }
    }
}

/// Darkness of the floor's cells, row by row along +z, 0 to 255.
pub(crate) struct Contact {
    floor: Floor,
    height: f32,
    cells: Vec<f32>,
}

impl Contact {
    pub(crate) fn new(floor: Floor, scene: BoundingSphere) -> Self {
        Self { floor, height: HEIGHT * scene.radius, cells: vec![0.0; CONTACT_SIZE * CONTACT_SIZE] }
    }

    /// Adds the triangles of a mesh.
    pub(crate) fn add(&mut self, positions: &[Vec3], triangles: &[[u32; 3]]) {
        let cell = 2.0 * self.floor.reach / CONTACT_SIZE as f32;
        scatter(positions, triangles, 0.7 * cell, |point, _| self.shade(point, cell));
    }

    fn shade(&mut self, point: Vec3, cell: f32) {
        let above = 1.0 - (point.y - self.floor.center.y) / self.height;
        let from_corner = point - self.floor.center + Vec3::splat(self.floor.reach);
        let place = Vec2::new(from_corner.x, from_corner.z) / cell;
        if above > 0.0 && place.min_element() >= 0.0 && place.max_element() < CONTACT_SIZE as f32 {
            let cell = &mut self.cells[place.y as usize * CONTACT_SIZE + place.x as usize];
            *cell = cell.max(above * above);
        }
    }

    /// The cells, softened.
    pub(crate) fn into_texels(mut self) -> Vec<u8> {
        for _ in 0..BLURS {
            blur(&mut self.cells, 1, CONTACT_SIZE);
            blur(&mut self.cells, CONTACT_SIZE, 1);
        }
        self.cells.iter().map(|cell| (255.0 * cell.clamp(0.0, 1.0)).round() as u8).collect()
    }
}

/// The mean over neighbours `along` apart, in lines `across` apart.
fn blur(cells: &mut [f32], along: usize, across: usize) {
    let mut line = [0.0; CONTACT_SIZE];
    for start in (0..CONTACT_SIZE).map(|index| index * across) {
        for (index, value) in line.iter_mut().enumerate() {
            *value = cells[start + index * along];
        }
        for index in 0..CONTACT_SIZE {
            let around = index.saturating_sub(BLUR)..(index + BLUR + 1).min(CONTACT_SIZE);
            // Beyond the floor there is light.
            cells[start + index * along] = line[around].iter().sum::<f32>() / (2 * BLUR + 1) as f32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_on_the_floor_darkens_it_and_what_floats_high_does_not() {
        let scene = BoundingSphere { center: Vec3::ZERO, radius: 1.0, lowest: -1.0, side: 2.0 };
        let floor = Floor::new(scene);
        let square =
            |height: f32| [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(|[x, z]| Vec3::new(x, height, z));
        let texels = |height| {
            let mut contact = Contact::new(floor, scene);
            contact.add(&square(height), &[[0, 1, 2], [0, 2, 3]]);
            contact.into_texels()
        };
        let (middle, corner) = (CONTACT_SIZE * CONTACT_SIZE / 2 + CONTACT_SIZE / 2, 0);
        let standing = texels(-1.0);
        assert_eq!((standing[middle], standing[corner]), (255, 0));
        assert!(texels(-0.9)[middle] < 255 && texels(-0.9)[middle] > 0);
        assert!(texels(0.0).iter().all(|&texel| texel == 0));
    }
}
