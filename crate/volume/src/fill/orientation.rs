//! The triangles of a soup with outsides that agree.
//!
//! Within a patch, triangles joined by edges of two triangles, the surface has made them agree. A patch that lies in no other one
//! has to be outward; one inside of another one is left as it is relative to that: a cavity is inward, a part within a part
//! outward.

use glam::DVec3;
use heatwalk::surface::{Element, InputTriangle, InputVertex};
use heatwalk::{FaceId, Soup, Surface, VertexId};
use heatwalk_base::union_find::UnionFind;

use super::triangle::{Triangle, area_vector, solid_angle};

/// Volume of a patch, as a share of that of its bounding box, from which it tells in from out. Rounding is far below, and what
/// encloses less is as good as flat.
const LEAST_SHARE: f64 = 1e-6;

/// Triangles joined by edges of two triangles.
struct Patch {
    triangles: Vec<Triangle>,
    low: DVec3,
    high: DVec3,
    /// Enclosed, positive where the patch is outward.
    volume: f64,
}

impl Patch {
    fn of(triangles: Vec<Triangle>) -> Self {
        let corners = || triangles.iter().flatten().copied();
        let (low, high) = (corners().fold(DVec3::MAX, DVec3::min), corners().fold(DVec3::MIN, DVec3::max));
        let centre = 0.5 * (low + high);
        let volume =
            triangles.iter().map(|triangle| area_vector(triangle).dot(triangle[0] - centre)).sum::<f64>() / 6.0;
        Self { triangles, low, high, volume }
    }

    /// Whether it is told by the volume that it is inward.
    fn is_inward(&self) -> bool {
        let size = self.high - self.low;
        self.volume < -LEAST_SHARE * size.x * size.y * size.z
    }

    /// Whether it winds around a point, either way.
    fn encloses(&self, point: DVec3) -> bool {
        let angle: f64 = self.triangles.iter().map(|triangle| solid_angle(triangle, point)).sum();
        angle.abs() > 2.0 * std::f64::consts::PI
    }

    fn contains_box(&self, other: &Self) -> bool {
        self.low.cmplt(other.low).all() && self.high.cmpgt(other.high).all()
    }
}

/// The triangles of a soup, oriented. Degenerate ones are left out, duplicates are not: walls of two bodies that touch are there
/// twice, in either orientation.
pub fn oriented(soup: &Soup, surface: &Surface) -> Vec<Triangle> {
    let mut patches = patches(soup, surface);
    patches.sort_by(|a, b| b.volume.abs().total_cmp(&a.volume.abs()));
    let mut is_flipped = vec![false; patches.len()];
    for index in 0..patches.len() {
        let own = &patches[index];
        // Of those around it the smallest, which comes last.
        let mut larger = (0..index).rev().filter(|&other| patches[other].contains_box(own));
        is_flipped[index] = match larger.find(|&other| patches[other].encloses(own.triangles[0][0])) {
            Some(container) => is_flipped[container],
            None => own.is_inward(),
        };
    }
    let flip = |(mut triangle, is_flipped): (Triangle, bool)| {
        if is_flipped {
            triangle.swap(1, 2);
        }
        triangle
    };
    let all = patches.into_iter().zip(is_flipped);
    all.flat_map(|(patch, is_flipped)| patch.triangles.into_iter().map(move |triangle| flip((triangle, is_flipped))))
        .collect()
}

fn patches(soup: &Soup, surface: &Surface) -> Vec<Patch> {
    let faces = surface.faces();
    let joined = UnionFind::new(faces.len());
    let edges = surface.edges();
    for last in edges.representatives() {
        let mut around = edges.around(last);
        if let (Some(first), Some(second), None) = (around.next(), around.next(), around.next()) {
            joined.join(first.triangle().0, second.triangle().0);
        }
    }
    let mut patch_of: Vec<Option<usize>> = vec![None; faces.len()];
    let mut patches: Vec<Vec<Triangle>> = Vec::new();
    for index in soup.ranges().into_iter().flatten() {
        let Some((face, corners)) = face_of(soup, surface, InputTriangle::from_index(index)) else { continue };
        let root = joined.least(face.0) as usize;
        let patch = *patch_of[root].get_or_insert_with(|| {
            patches.push(Vec::new());
            patches.len() - 1
        });
        patches[patch].push(corners.map(|vertex| surface.positions()[vertex]));
    }
    patches.into_iter().map(Patch::of).collect()
}

/// The face that a triangle of the input became, or is a duplicate of, and its corners, turned as those of the face were.
fn face_of(soup: &Soup, surface: &Surface, triangle: InputTriangle) -> Option<(FaceId, [VertexId; 3])> {
    if let Some(face) = surface.face_of_triangle(triangle) {
        return Some((face, surface.faces()[face]));
    }
    let welded = |triangle: InputTriangle| {
        let corners = soup.triangles[triangle.index()].map(|corner| surface.vertex_of_input(InputVertex(corner)));
        match corners {
            [Some(a), Some(b), Some(c)] if a != b && b != c && c != a => Some([a, b, c]),
            _ => None,
        }
    };
    let own = welded(triangle)?;
    let has_same = |face: FaceId| own.iter().all(|vertex| surface.faces()[face].contains(vertex));
    let (face, _) = surface.corners_of_vertex(own[0]).find(|&(face, _)| has_same(face))?;
    let kept = welded(surface.triangle_of_face(face))?;
    let [a, b, c] = own;
    let is_flipped = !is_rotation(kept, surface.faces()[face]);
    Some((face, if is_flipped { [a, c, b] } else { own }))
}

/// Whether both have the same corners in the same order around.
fn is_rotation([a, b, c]: [VertexId; 3], other: [VertexId; 3]) -> bool {
    other == [a, b, c] || other == [b, c, a] || other == [c, a, b]
}
