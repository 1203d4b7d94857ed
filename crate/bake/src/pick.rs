//! What lies under the pointer.

use glam::{DVec2, DVec3, Vec3};

use crate::hierarchy::Hierarchy;
use crate::ray::{Hit, Ray};

/// Triangles in a bounding volume hierarchy, for finding what lies under the pointer.
pub struct Picker {
    hierarchy: Hierarchy,
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Picker {
    /// The indices must be in range, the positions finite, and the hierarchy that of the triangles.
    #[must_use]
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>, hierarchy: Hierarchy) -> Self {
        Self { hierarchy, positions, triangles }
    }

    /// Moves the vertices, to as many finite positions.
    ///
    /// # Panics
    /// Where there are more or fewer.
    pub fn pose(&mut self, positions: Vec<Vec3>) {
        assert_eq!(positions.len(), self.positions.len(), "one position a vertex");
        self.hierarchy.fit(&positions, &self.triangles);
        self.positions = positions;
    }

    /// The nearest triangle in front of the ray's origin, seen from either side.
    #[must_use]
    pub fn cast(&self, ray: Ray) -> Option<Hit> {
        self.cast_where(ray, |_| true)
    }

    /// The nearest of the places where the ray meets a triangle and `is_there` is true.
    #[must_use]
    pub fn cast_where(&self, ray: Ray, is_there: impl Fn(Vec3) -> bool) -> Option<Hit> {
        let meet =
            |triangle: u32| meet(ray, triangle, self.corners(triangle).map(|vertex| self.positions[vertex as usize]));
        self.hierarchy.nearest(ray, |triangle| meet(triangle).filter(|hit| is_there(ray.at(hit.depth))))
    }

    /// The vertices, `#V × 3`; world space.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// The triangles, `#F × 3`, indices of vertices.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The triangles in the order of the hierarchy's leaves: neighbours in it are neighbours in space.
    #[must_use]
    pub fn in_leaf_order(&self) -> &[u32] {
        self.hierarchy.order()
    }

    /// The three corners of a triangle, as vertex indices.
    #[must_use]
    pub fn corners(&self, triangle: u32) -> [u32; 3] {
        self.triangles[triangle as usize]
    }
}

/// The nearest triangle in front of the ray's origin, seen from either side; looks at all, for triangles that change too often
/// to be worth a hierarchy. The indices must be in range.
#[must_use]
pub fn cast_at_all(ray: Ray, positions: &[Vec3], triangles: &[[u32; 3]]) -> Option<Hit> {
    // The ray is a point where it is looked along: most triangles lie on one side of it, which is quickly told.
    let (right, up) = ray.direction.as_dvec3().any_orthonormal_pair();
    let seen = |place: &Vec3| {
        let from_ray = place.as_dvec3() - ray.origin.as_dvec3();
        DVec2::new(right.dot(from_ray), up.dot(from_ray))
    };
    let seen: Vec<DVec2> = positions.iter().map(seen).collect();
    let surrounds = |corners: [DVec2; 3]| {
        let [a, b, c] = corners;
        a.min(b).min(c).max_element() <= 0.0 && a.max(b).max(c).min_element() >= 0.0
    };
    let hits = (0..).zip(triangles).filter_map(|(index, triangle)| {
        let is_near = surrounds(triangle.map(|vertex| seen[vertex as usize]));
        is_near.then(|| meet(ray, index, triangle.map(|vertex| positions[vertex as usize]))).flatten()
    });
    hits.min_by(|one, other| one.depth.total_cmp(&other.depth))
}

/// Möller and Trumbore, "Fast, minimum storage ray/triangle intersection" (1997), in double precision so that
/// the weights keep their digits when the camera is far away.
fn meet(ray: Ray, triangle: u32, corners: [Vec3; 3]) -> Option<Hit> {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let direction = ray.direction.as_dvec3();
    let (ab, ac) = (b - a, c - a);
    let across: DVec3 = direction.cross(ac);
    let determinant = ab.dot(across);
    // Exactly zero only for a degenerate triangle or a ray in its plane: nothing to stand on.
    if determinant == 0.0 {
        return None;
    }
    let from_a = ray.origin.as_dvec3() - a;
    let v = from_a.dot(across) / determinant;
    let along = from_a.cross(ab);
    let w = direction.dot(along) / determinant;
    let depth = ac.dot(along) / determinant;
    if v < 0.0 || w < 0.0 || v + w > 1.0 || depth <= 0.0 {
        return None;
    }
    Some(Hit { triangle, weights: DVec3::new(1.0 - v - w, v, w).as_vec3(), depth: depth as f32 })
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_xoshiro::SplitMix64;

    use super::*;

    impl Picker {
        fn meet(&self, ray: Ray, triangle: u32) -> Option<Hit> {
            meet(ray, triangle, self.corners(triangle).map(|vertex| self.positions[vertex as usize]))
        }
    }

    fn point(random: &mut SplitMix64) -> Vec3 {
        2.0 * Vec3::from_array(random.random()) - 1.0
    }

    fn soup(count: u32, seed: u64) -> Picker {
        let mut random = SplitMix64::seed_from_u64(seed);
        let mut positions = Vec::new();
        for _ in 0..count {
            let center = point(&mut random);
            positions.extend((0..3).map(|_| center + 0.15 * point(&mut random)));
        }
        picker_of(positions, (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect())
    }

    fn picker_of(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Picker {
        let hierarchy = Hierarchy::new(&positions, &triangles);
        Picker::new(positions, triangles, hierarchy)
    }

    #[test]
    fn agrees_with_brute_force() {
        for count in [1, 2, 5, 700] {
            let picker = soup(count, 7);
            let mut random = SplitMix64::seed_from_u64(11);
            let mut hits = 0;
            for _ in 0..1000 {
                let origin = 3.0 * point(&mut random);
                let ray = Ray { origin, direction: (point(&mut random) - origin).normalize() };
                let nearest = (0..count)
                    .filter_map(|triangle| picker.meet(ray, triangle))
                    .min_by(|left, right| left.depth.total_cmp(&right.depth));
                assert_eq!(picker.cast(ray), nearest);
                assert_eq!(cast_at_all(ray, picker.positions(), picker.triangles()), nearest);
                hits += usize::from(nearest.is_some());
            }
            assert!(count < 700 || hits > 300, "the rays must meet something: {hits}");
        }
    }

    #[test]
    fn goes_on_through_what_is_not_there() {
        let picker = soup(700, 7);
        let mut random = SplitMix64::seed_from_u64(17);
        let mut farther = 0;
        for _ in 0..1000 {
            let origin = 3.0 * point(&mut random);
            let ray = Ray { origin, direction: (point(&mut random) - origin).normalize() };
            let is_there = |place: Vec3| place.x + place.y < 0.1;
            let nearest = (0..700)
                .filter_map(|triangle| picker.meet(ray, triangle))
                .filter(|hit| is_there(ray.at(hit.depth)))
                .min_by(|left, right| left.depth.total_cmp(&right.depth));
            assert_eq!(picker.cast_where(ray, is_there), nearest);
            farther += usize::from(nearest.is_some() && nearest != picker.cast(ray));
        }
        assert!(farther > 20, "some rays must meet something behind what is not there: {farther}");
    }

    #[test]
    fn agrees_with_brute_force_in_another_pose() {
        let mut picker = soup(700, 7);
        let turned = picker.positions().iter().map(|place| Vec3::new(place.y, -2.0 * place.x, place.z + place.y));
        let turned: Vec<Vec3> = turned.collect();
        picker.pose(turned.clone());
        assert_eq!(picker.positions(), turned);
        let mut random = SplitMix64::seed_from_u64(13);
        let mut hits = 0;
        for _ in 0..1000 {
            let origin = 4.0 * point(&mut random);
            let ray = Ray { origin, direction: (point(&mut random) - origin).normalize() };
            let nearest = (0..700)
                .filter_map(|triangle| picker.meet(ray, triangle))
                .min_by(|left, right| left.depth.total_cmp(&right.depth));
            assert_eq!(picker.cast(ray), nearest);
            hits += usize::from(nearest.is_some());
        }
        assert!(hits > 200, "the rays must meet something: {hits}");
    }

    #[test]
    fn weights_rebuild_the_point_from_either_side() {
        let corners = vec![Vec3::ZERO, Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 4.0, 0.0)];
        let picker = picker_of(corners.clone(), vec![[0, 1, 2]]);
        for side in [1.0, -1.0] {
            let ray = Ray { origin: Vec3::new(1.0, 2.0, 3.0 * side), direction: Vec3::NEG_Z * side };
            let hit = picker.cast(ray).expect("a hit");
            assert_eq!(hit.depth, 3.0);
            let point = corners[0] * hit.weights.x + corners[1] * hit.weights.y + corners[2] * hit.weights.z;
            assert_eq!(point, Vec3::new(1.0, 2.0, 0.0));
        }
    }

    #[test]
    fn nothing_behind_and_nothing_in_an_empty_scene() {
        let picker = picker_of(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]);
        assert_eq!(picker.cast(Ray { origin: Vec3::new(0.2, 0.2, 1.0), direction: Vec3::Z }), None);
        let empty = picker_of(vec![], vec![]);
        assert_eq!(empty.cast(Ray { origin: Vec3::Z, direction: Vec3::NEG_Z }), None);
    }

    /// Rays along an axis within the sides of boxes, onto the corners of a sheet without thickness.
    #[test]
    fn no_box_hides_what_lies_in_its_side() {
        let n = 12;
        let corner = |i: u32, j: u32| i + (n + 1) * j;
        let at = |vertex: u32| 0.1 * Vec3::new((vertex % (n + 1)) as f32, (vertex / (n + 1)) as f32, 0.0);
        let squares = (0..n).flat_map(|j| (0..n).map(move |i| (i, j)));
        let triangles = squares.flat_map(|(i, j)| {
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            [[a, b, c], [a, c, d]]
        });
        let vertices = (n + 1) * (n + 1);
        let picker = picker_of((0..vertices).map(at).collect(), triangles.collect());
        let mut hits = 0;
        for vertex in 0..vertices {
            let ray = Ray { origin: at(vertex) + Vec3::Z, direction: Vec3::NEG_Z };
            let is_met = (0..2 * n * n).any(|triangle| picker.meet(ray, triangle).is_some());
            assert_eq!(picker.cast(ray).map(|hit| hit.depth), is_met.then_some(1.0));
            hits += u32::from(is_met);
        }
        assert!(hits > vertices / 2, "most corners are met within the rounding of the weights: {hits}");
    }
}
