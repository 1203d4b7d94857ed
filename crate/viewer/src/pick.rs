use glam::{DVec3, Vec3};

/// A leaf holds from this many to twice as many triangles: with fewer, memory grows and no ray gains.
const TRIANGLES_PER_LEAF: usize = 4;
/// Cells of the Morton curve along an axis, as a power of two: three axes and the index of a triangle share 64 bits.
const CELL_BITS: u32 = 10;
/// Depths along a ray come from three roundings on either side of a comparison: difference, reciprocal, product.
const ROUNDING: f32 = 1.0 + 6.0 * f32::EPSILON;

/// A half-line in world space.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Unit length.
    pub direction: Vec3,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the triangle.
    pub triangle: u32,
    /// Barycentric weights of the triangle's three corners; they sum to one.
    pub weights: Vec3,
    /// Distance along the ray; world units.
    pub depth: f32,
}

/// Triangles in a bounding volume hierarchy, for finding what lies under the pointer.
///
/// The hierarchy halves the triangles' order along a Morton curve, as in Lauterbach et al., "Fast BVH construction on
/// GPUs" (2009), section 3, so that building it is little more than a sort: a mesh of a million triangles must not hold
/// up the page.
pub struct Picker {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// Triangles along the curve; leaf `k` of `n` holds the `k`-th of `n` equal shares.
    order: Vec<u32>,
    /// A complete binary tree, root first: node `i` is above nodes `2 i + 1` and `2 i + 2`, the last level are leaves.
    boxes: Vec<Cuboid>,
}

impl Picker {
    /// Builds the hierarchy; the indices must be in range and the positions finite.
    #[must_use]
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Self {
        let order = along_curve(&positions, &triangles);
        let leaves = (triangles.len() / TRIANGLES_PER_LEAF).checked_ilog2().map_or(1, |levels| 1 << levels);
        let mut picker = Self { positions, triangles, order, boxes: vec![Cuboid::EMPTY; 2 * leaves - 1] };
        for leaf in 0..leaves {
            let corners = picker.leaf(leaf).iter().flat_map(|&triangle| picker.corners(triangle));
            let cuboid = Cuboid::of(corners.map(|vertex| picker.positions[vertex as usize]));
            picker.boxes[leaves - 1 + leaf] = cuboid;
        }
        for node in (0..leaves - 1).rev() {
            picker.boxes[node] = picker.boxes[2 * node + 1].join(picker.boxes[2 * node + 2]);
        }
        picker
    }

    fn leaf_count(&self) -> usize {
        self.boxes.len().div_ceil(2)
    }

    fn leaf(&self, leaf: usize) -> &[u32] {
        let start = |leaf: usize| (leaf as u64 * self.order.len() as u64 / self.leaf_count() as u64) as usize;
        &self.order[start(leaf)..start(leaf + 1)]
    }

    /// The nearest triangle in front of the ray's origin, seen from either side.
    #[must_use]
    pub fn cast(&self, ray: Ray) -> Option<Hit> {
        let inverse = ray.direction.recip();
        let mut nearest: Option<Hit> = None;
        let mut reach = f32::INFINITY;
        let mut open = vec![(0.0, 0)];
        while let Some((entry, node)) = open.pop() {
            if entry >= reach {
                continue;
            }
            if let Some(leaf) = (node + 1_usize).checked_sub(self.leaf_count()) {
                for hit in self.leaf(leaf).iter().filter_map(|&triangle| self.meet(ray, triangle)) {
                    if nearest.is_none_or(|nearest| hit.depth < nearest.depth) {
                        nearest = Some(hit);
                        reach = hit.depth * ROUNDING;
                    }
                }
                continue;
            }
            let [left, right] =
                [2 * node + 1, 2 * node + 2].map(|child| (self.boxes[child].entry(ray.origin, inverse), child));
            // The nearer one comes last, to be taken first.
            open.extend(if left.0 < right.0 { [right, left] } else { [left, right] });
        }
        nearest
    }

    /// Möller and Trumbore, "Fast, minimum storage ray/triangle intersection" (1997), in double precision so that
    /// the weights keep their digits when the camera is far away.
    fn meet(&self, ray: Ray, triangle: u32) -> Option<Hit> {
        let [a, b, c] = self.triangles[triangle as usize].map(|vertex| self.positions[vertex as usize].as_dvec3());
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

    /// The triangles in an order in which neighbours in it are neighbours in space.
    #[must_use]
    pub fn along_curve(&self) -> &[u32] {
        &self.order
    }

    /// The three corners of a triangle, as vertex indices.
    #[must_use]
    pub fn corners(&self, triangle: u32) -> [u32; 3] {
        self.triangles[triangle as usize]
    }
}

/// A box along the axes.
#[derive(Clone, Copy)]
struct Cuboid {
    low: Vec3,
    high: Vec3,
}

impl Cuboid {
    const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    fn of(points: impl Iterator<Item = Vec3>) -> Self {
        points.fold(Self::EMPTY, |it, point| Self { low: it.low.min(point), high: it.high.max(point) })
    }

    fn join(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Depth at which a ray comes in, 0 from inside, infinite where it misses. Kay and Kajiya, "Ray tracing complex
    /// scenes" (1986).
    fn entry(self, origin: Vec3, inverse: Vec3) -> f32 {
        let (low, high) = ((self.low - origin) * inverse, (self.high - origin) * inverse);
        // 0 times infinity: the ray lies in the plane of a side, which belongs to the box.
        let within = low.is_nan_mask() | high.is_nan_mask();
        let entry = Vec3::select(within, Vec3::NEG_INFINITY, low.min(high)).max_element().max(0.0);
        let exit = Vec3::select(within, Vec3::INFINITY, low.max(high)).min_element();
        if entry <= exit * ROUNDING { entry } else { f32::INFINITY }
    }
}

/// Triangles in the order in which a Morton curve passes their centres. Morton, "A computer oriented geodetic data base
/// and a new technique in file sequencing" (1966).
fn along_curve(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<u32> {
    let bounds = Cuboid::of(positions.iter().copied());
    let cells = ((1 << CELL_BITS) - 1) as f32 / (bounds.high - bounds.low);
    let mut keys: Vec<u64> = triangles
        .iter()
        .zip(0_u64..)
        .map(|(corners, index)| {
            let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
            // Along an axis without extent this is not a number, which as an integer is 0.
            let cell = ((a + b + c) / 3.0 - bounds.low) * cells;
            let [x, y, z] = cell.to_array().map(|along| spread(along as u32));
            u64::from(x | y << 1 | z << 2) << 32 | index
        })
        .collect();
    keys.sort_unstable();
    keys.into_iter().map(|key| key as u32).collect()
}

/// Moves bit `i` of a cell number to place `3 i`.
fn spread(cell: u32) -> u32 {
    let cell = (cell | cell << 16) & 0x0300_00ff;
    let cell = (cell | cell << 8) & 0x0300_f00f;
    let cell = (cell | cell << 4) & 0x030c_30c3;
    (cell | cell << 2) & 0x0924_9249
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small deterministic generator: tests must not vary from run to run.
    struct Lcg(u64);
    impl Lcg {
        fn unit(&mut self) -> f32 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 40) as f32 / (1u64 << 24) as f32
        }
        fn point(&mut self) -> Vec3 {
            2.0 * Vec3::new(self.unit(), self.unit(), self.unit()) - 1.0
        }
    }

    fn soup(count: u32, seed: u64) -> Picker {
        let mut random = Lcg(seed);
        let mut positions = Vec::new();
        for _ in 0..count {
            let center = random.point();
            positions.extend((0..3).map(|_| center + 0.15 * random.point()));
        }
        Picker::new(positions, (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect())
    }

    #[test]
    fn agrees_with_brute_force() {
        for count in [1, 2, 5, 700] {
            let picker = soup(count, 7);
            let mut random = Lcg(11);
            let mut hits = 0;
            for _ in 0..1000 {
                let origin = 3.0 * random.point();
                let ray = Ray { origin, direction: (random.point() - origin).normalize() };
                let nearest = (0..count)
                    .filter_map(|triangle| picker.meet(ray, triangle))
                    .min_by(|left, right| left.depth.total_cmp(&right.depth));
                assert_eq!(picker.cast(ray), nearest);
                hits += usize::from(nearest.is_some());
            }
            assert!(count < 700 || hits > 300, "the rays must meet something: {hits}");
        }
    }

    #[test]
    fn weights_rebuild_the_point_from_either_side() {
        let corners = vec![Vec3::ZERO, Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 4.0, 0.0)];
        let picker = Picker::new(corners.clone(), vec![[0, 1, 2]]);
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
        let picker = Picker::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]);
        assert_eq!(picker.cast(Ray { origin: Vec3::new(0.2, 0.2, 1.0), direction: Vec3::Z }), None);
        let empty = Picker::new(vec![], vec![]);
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
        let picker = Picker::new((0..vertices).map(at).collect(), triangles.collect());
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
