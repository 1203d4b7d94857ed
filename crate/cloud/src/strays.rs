//! Points beside the surface, such as noise leaves behind, become part of it.

use std::collections::HashMap;
use std::num::NonZeroUsize;

use glam::DVec3;

use crate::neighbours::Neighbours;
use crate::plane::Plane;

/// Neighbours whose triangles are looked at.
const NEIGHBOURS: NonZeroUsize = NonZeroUsize::new(16).expect("not 0");

/// What is farther from the surface than so many spacings stays alone.
const FARTHEST: f64 = 1.0;

/// Parts the nearest triangle of each of some points that are on none into three, or adds one at an edge of the boundary that is nearest. Triangles
/// keep their orientation.
pub fn attach(
    triangles: &mut Vec<[u32; 3]>,
    positions: &[DVec3],
    planes: &[Plane],
    neighbours: &Neighbours,
    strays: &[u32],
) {
    let mut near = Vec::new();
    let mut beside: HashMap<u32, Vec<u32>> = HashMap::new();
    for &stray in strays {
        neighbours.nearest(positions[stray as usize], NEIGHBOURS, &mut near);
        beside.extend(near.iter().map(|&(_, point)| (point, Vec::new())));
    }
    for (triangle, corners) in triangles.iter().enumerate() {
        for corner in corners {
            if let Some(list) = beside.get_mut(corner) {
                list.push(triangle as u32);
            }
        }
    }
    for &stray in strays {
        let place = positions[stray as usize];
        neighbours.nearest(place, NEIGHBOURS, &mut near);
        let around = near.iter().flat_map(|(_, point)| &beside[point]).copied();
        let nearest = around.map(|triangle| {
            let corners = triangles[triangle as usize].map(|vertex| positions[vertex as usize]);
            let (distance, edge) = nearest_of(corners, place);
            (distance, triangle, edge)
        });
        let Some((distance, triangle, edge)) = nearest.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        let corners = triangles[triangle as usize];
        let spacing = planes[corners[0] as usize].spacing;
        if distance > FARTHEST * spacing {
            continue;
        }
        let [a, b, c] = corners;
        let others = match edge {
            Some(k) if is_open(triangles, &beside, [corners[k], corners[(k + 1) % 3]]) => {
                vec![[corners[(k + 1) % 3], corners[k], stray]]
            }
            _ => {
                triangles[triangle as usize] = [a, b, stray];
                beside.entry(stray).or_default().push(triangle);
                vec![[b, c, stray], [c, a, stray]]
            }
        };
        for other in others {
            for vertex in other {
                if let Some(list) = beside.get_mut(&vertex) {
                    list.push(triangles.len() as u32);
                }
            }
            triangles.push(other);
        }
    }
}

/// Whether an edge has one triangle.
fn is_open(triangles: &[[u32; 3]], beside: &HashMap<u32, Vec<u32>>, edge: [u32; 2]) -> bool {
    let there = edge.iter().find_map(|end| beside.get(end)).map_or(&[][..], Vec::as_slice);
    let is_beside = |&&triangle: &&u32| edge.iter().all(|end| triangles[triangle as usize].contains(end));
    there.iter().filter(is_beside).count() == 1
}

/// How far a place is from a triangle, and the side that is nearest, by its first corner; none where that is the inside.
fn nearest_of(corners: [DVec3; 3], place: DVec3) -> (f64, Option<usize>) {
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
    let is_beyond = |k: usize| {
        let [a, b] = [corners[k], corners[(k + 1) % 3]];
        (b - a).cross(place - a).dot(normal) < 0.0
    };
    let to_side = |k: usize| {
        let [a, b] = [corners[k], corners[(k + 1) % 3]];
        let along = b - a;
        let share = (along.dot(place - a) / along.length_squared()).clamp(0.0, 1.0);
        place.distance(a + share * along)
    };
    let sides = (0..3).filter(|&k| is_beyond(k)).map(|k| (to_side(k), Some(k)));
    sides.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or(((place - corners[0]).dot(normal).abs(), None))
}
