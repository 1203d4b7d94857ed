//! Repair by moving vertices: the apex of a bad triangle goes to the mean of its neighbours.
//!
//! He and Hung, "The heat method" (INF555 project), the section on broken meshes. Kept for comparison: it changes the
//! surface, the intrinsic Delaunay operator does not.

use glam::DVec3;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{VertexData, triangle};

/// A triangle is bad where its height over the longest edge is less than this share of that edge: an angle of more
/// than about 157°, or one below about 6°.
const FLATNESS: f64 = 0.1;

/// A moved apex may spoil its neighbours, so the faces are gone through again, but not for ever.
const SWEEPS: usize = 10;

/// Positions (`#V`) after the repair, and how many vertices were moved.
pub(crate) fn relocated(surface: &Surface) -> (VertexData<DVec3>, usize) {
    let mut positions = surface.positions().clone();
    let mut is_moved: VertexData<bool> = vec![false; positions.len()].into();
    for _ in 0..SWEEPS {
        let mut any = false;
        for &face in surface.faces() {
            let Some(apex) = bad_apex(face.map(|vertex| positions[vertex])).map(|k| face[k]) else { continue };
            let (mut sum, mut count) = (DVec3::ZERO, 0.0);
            for other in surface.neighbours(apex) {
                sum += positions[other];
                count += 1.0;
            }
            positions[apex] = sum / count;
            is_moved[apex] = true;
            any = true;
        }
        if !any {
            break;
        }
    }
    (positions, is_moved.iter().filter(|&&moved| moved).count())
}

/// The corner opposite the longest edge of a bad triangle.
fn bad_apex(corners: [DVec3; 3]) -> Option<usize> {
    let lengths = triangle::edges(corners).map(triangle::length);
    let apex = (0..3).max_by(|&i, &j| lengths[i].total_cmp(&lengths[j]))?;
    let height = triangle::length(triangle::area_vector(corners)) / lengths[apex];
    (height < FLATNESS * lengths[apex]).then_some(apex)
}
