//! Whether a path is valid and locally shortest, measured apart from what makes it so.

use std::collections::HashMap;

use glam::{DVec2, DVec3};
use heatwalk::{FaceId, Path, Place, Surface, VertexId};

/// Points follow each other through the faces that they name.
pub fn check_valid(surface: &Surface, path: &Path) {
    assert_eq!(path.points.len(), path.normals.len());
    for pair in path.points.windows(2) {
        assert!(pair[0].location != pair[1].location, "{pair:?}");
        for point in pair {
            let corners = surface.faces()[pair[0].face];
            let lies_in_face = point.location.support(surface).all(|(corner, _)| corners.contains(&corner));
            assert!(lies_in_face, "{point:?} is not in {:?}", pair[0].face);
        }
    }
    for point in &path.points {
        let position = point.location.position(surface);
        assert!(position.distance(point.position) <= 1e-12 * surface.mean_edge().max(position.length()));
    }
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    let (a, b) = (a.normalize(), b.normalize());
    a.cross(b).length().atan2(a.dot(b))
}

/// The smallest angle by which a path can turn around its vertices, by relaxing all of each link (Bellman and Ford).
pub fn sharpest_turn(surface: &Surface, path: &Path) -> f64 {
    let mut sharpest = f64::INFINITY;
    for triple in path.points.windows(3) {
        let Place::Vertex(vertex) = triple[1].location else { continue };
        let at = surface.position(vertex);
        let sides = |face: FaceId| {
            let others: Vec<VertexId> = surface.faces()[face].into_iter().filter(|&corner| corner != vertex).collect();
            [others[0], others[1]]
        };
        let from_side = |face: FaceId, other: DVec3, side: VertexId| {
            assert!(sides(face).contains(&side));
            angle(other - at, surface.position(side) - at)
        };
        let mut far: HashMap<VertexId, f64> = HashMap::new();
        for side in sides(triple[0].face) {
            far.insert(side, from_side(triple[0].face, triple[0].position, side));
        }
        let arcs: Vec<([VertexId; 2], f64)> = surface
            .corners_of_vertex(vertex)
            .map(|(face, _)| {
                let [p, q] = sides(face);
                ([p, q], angle(surface.position(p) - at, surface.position(q) - at))
            })
            .collect();
        loop {
            let mut is_done = true;
            for &([p, q], arc) in &arcs {
                for [p, q] in [[p, q], [q, p]] {
                    let Some(&known) = far.get(&p) else { continue };
                    let other = far.entry(q).or_insert(f64::INFINITY);
                    if known + arc < *other {
                        *other = known + arc;
                        is_done = false;
                    }
                }
            }
            if is_done {
                break;
            }
        }
        if triple[0].face == triple[1].face {
            sharpest = sharpest.min(angle(triple[0].position - at, triple[2].position - at));
        }
        for side in sides(triple[1].face) {
            let rest = from_side(triple[1].face, triple[2].position, side);
            sharpest = sharpest.min(far.get(&side).map_or(f64::INFINITY, |known| known + rest));
        }
    }
    sharpest
}

/// How far a path runs beside the straight line at its crossings of edges, the two faces unfolded, in mean edges.
pub fn largest_kink(surface: &Surface, path: &Path) -> f64 {
    let mut largest: f64 = 0.0;
    for triple in path.points.windows(3) {
        let Place::Edge { halfedge, .. } = triple[1].location else {
            assert!(matches!(triple[1].location, Place::Vertex(_)), "a point inside a face: {triple:?}");
            continue;
        };
        assert!(triple[0].face != triple[1].face, "an edge that is not crossed: {triple:?}");
        let [a, b] = surface.ends(halfedge).map(|point| surface.position(point));
        let along = (b - a).normalize();
        let flat = |offset: DVec3, side: f64| DVec2::new(along.dot(offset), side * along.cross(offset).length());
        let before = flat(triple[0].position - triple[1].position, -1.0);
        let after = flat(triple[2].position - triple[1].position, 1.0);
        largest = largest.max(before.perp_dot(after).abs() / before.distance(after) / surface.mean_edge());
    }
    largest
}
