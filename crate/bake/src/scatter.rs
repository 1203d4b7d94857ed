//! Points spread evenly over triangles, for what a mesh keeps off the light around it.

use glam::Vec3;

/// Points of a mesh in all, beside one a triangle: large triangles without number must not hold up the page.
const MOST: usize = 4_000_000;

/// Calls `visit` with points about `spacing` apart on every triangle, each with the area that it stands for; world units.
pub(crate) fn scatter(positions: &[Vec3], triangles: &[[u32; 3]], spacing: f32, mut visit: impl FnMut(Vec3, f32)) {
    let finest = (MOST / triangles.len().max(1)).isqrt().max(1) as u32;
    for corners in triangles {
        let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
        let (ab, ac) = (b - a, c - a);
        let longest = ab.length_squared().max(ac.length_squared()).max(b.distance_squared(c)).sqrt();
        let steps = ((longest / spacing).ceil() as u32).clamp(1, finest);
        let share = 1.0 / steps as f32;
        let area = 0.5 * ab.cross(ac).length() * share * share;
        // The triangle falls into steps² smaller ones, of which every second hangs upside down.
        for row in 0..steps {
            for column in 0..2 * (steps - row) - 1 {
                let inset = if column % 2 == 0 { 1.0 / 3.0 } else { 2.0 / 3.0 };
                let (v, w) = ((column / 2) as f32 + inset, row as f32 + inset);
                visit(a + share * (v * ab + w * ac), area);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [Vec3; 3] = [Vec3::ZERO, Vec3::new(3.0, 0.0, 0.0), Vec3::new(0.0, 0.0, 4.0)];

    #[test]
    fn points_lie_in_the_triangle_and_share_its_area() {
        let (mut count, mut whole, mut moment) = (0, 0.0, Vec3::ZERO);
        scatter(&CORNERS, &[[0, 1, 2]], 0.6, |point, area| {
            assert!(point.x > 0.0 && point.z > 0.0 && point.x / 3.0 + point.z / 4.0 < 1.0);
            (count, whole, moment) = (count + 1, whole + area, moment + area * point);
        });
        // The longest side, 5, in 9 parts.
        assert_eq!(count, 81);
        assert!((whole - 6.0).abs() < 1e-4 && (moment / whole - Vec3::new(1.0, 0.0, 4.0 / 3.0)).length() < 1e-4);
    }

    #[test]
    fn many_large_triangles_get_few_points_each() {
        let triangles = vec![[0, 1, 2]; 100_000];
        let mut count = 0;
        scatter(&CORNERS, &triangles, 1e-3, |_, _| count += 1);
        assert!(count >= triangles.len() && count <= MOST, "{count}");
    }
}
