//! From the file's unit to what is drawn. Graphics cards calculate in single precision, which has seven digits and no
//! squares beyond 10³⁸: so positions are centred and scaled while they are double ones.

use glam::{DVec3, Vec3};
use heatwalk::{Soup, Surface, Up};

/// `drawn = (position − center) · scale`, turned so that the axis that points up in the file is drawn along Y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawTransform {
    /// What is drawn at the origin, in the file's unit.
    pub center: DVec3,
    /// Drawn length of the file's unit; positive.
    pub scale: f64,
    /// What points up in the file.
    pub up: Up,
}

impl DrawTransform {
    /// Draws everything in the file's unit.
    pub const IDENTITY: Self = Self { center: DVec3::ZERO, scale: 1.0, up: Up::Y };

    /// Puts the middle of the surface's box at the origin, and all triangles of the soup, which the surface is a part of,
    /// within ±1.
    pub fn around(surface: &Surface, soup: &Soup, up: Up) -> Self {
        let points = surface.positions();
        let Some(&first) = points.iter().next() else { return Self { up, ..Self::IDENTITY } };
        let (low, high) = points.iter().fold((first, first), |(low, high), &point| (low.min(point), high.max(point)));
        // Half of each first: the sum of two large numbers may be none.
        let center = 0.5 * low + 0.5 * high;
        let corners = soup.triangles.iter().flatten().filter_map(|&vertex| soup.positions.get(vertex as usize));
        let reach = corners
            .map(|&corner| (corner - center).abs().max_element())
            .filter(|reach| reach.is_finite())
            .fold(0.0, f64::max);
        // What has no size has any.
        Self { center, scale: if reach >= f64::MIN_POSITIVE { reach.recip() } else { 1.0 }, up }
    }

    /// Where a position is drawn.
    pub fn place(&self, position: DVec3) -> Vec3 {
        self.direction(self.scale * (position - self.center)).as_vec3()
    }

    /// How a direction is drawn.
    pub fn direction(&self, direction: DVec3) -> DVec3 {
        self.up.turned(direction)
    }

    /// `#V × 3`, how directions are drawn.
    pub fn directions(&self, directions: impl IntoIterator<Item = DVec3>) -> Vec<f32> {
        directions.into_iter().flat_map(|direction| self.direction(direction).as_vec3().to_array()).collect()
    }

    /// How long a length is drawn.
    pub fn length(&self, length: f64) -> f32 {
        (self.scale * length) as f32
    }

    /// `#P × 3`, where positions are drawn.
    pub fn places(&self, positions: impl IntoIterator<Item = DVec3>) -> Vec<f32> {
        positions.into_iter().flat_map(|position| self.place(position).to_array()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [DVec3; 4] = [DVec3::ZERO, DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 2.0, 0.0), DVec3::ONE];
    const TRIANGLES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

    fn drawn(size: f64, shift: DVec3) -> Vec<f32> {
        let positions: Vec<DVec3> = CORNERS.iter().map(|&corner| size * corner + shift).collect();
        let soup = Soup::single("tetrahedron", positions.clone(), TRIANGLES.to_vec());
        let surface = Surface::build(&soup).expect("a tetrahedron");
        DrawTransform::around(&surface, &soup, Up::Y).places(positions)
    }

    #[test]
    fn size_and_place_do_not_matter() {
        let expected = drawn(1.0, DVec3::ZERO);
        assert_eq!(expected, [-0.5, -1.0, -0.5, 0.5, -1.0, -0.5, -0.5, 1.0, -0.5, 0.5, 0.0, 0.5]);
        let on_a_map = DVec3::new(500_000.0, 4_649_776.0, 100.0);
        for (size, shift) in [(1e-30, DVec3::ZERO), (1e30, DVec3::ZERO), (1.3, on_a_map), (1e25, DVec3::splat(1e25))] {
            // Positions of a map have ten digits after the point: far more than single precision.
            let differs = drawn(size, shift).iter().zip(&expected).any(|(a, b)| (a - b).abs() > 2.0 * f32::EPSILON);
            assert!(!differs, "{size:e} at {shift}");
        }
    }

    #[test]
    fn what_points_up_is_drawn_up_and_right_hands_stay_right() {
        for (up, axis) in [
            (Up::X, DVec3::X),
            (Up::Y, DVec3::Y),
            (Up::Z, DVec3::Z),
            (Up::MinusX, DVec3::NEG_X),
            (Up::MinusY, DVec3::NEG_Y),
            (Up::MinusZ, DVec3::NEG_Z),
        ] {
            let transform = DrawTransform { center: DVec3::new(1.0, 2.0, 3.0), scale: 2.0, up };
            assert_eq!(transform.direction(axis), DVec3::Y, "{up}");
            let [x, y, z] = DVec3::AXES.map(|axis| transform.direction(axis));
            assert_eq!(x.cross(y), z, "{up}");
            assert_eq!(transform.place(transform.center + 3.0 * axis), Vec3::new(0.0, 6.0, 0.0), "{up}");
        }
    }

    #[test]
    fn scenery_fits_in_and_the_surface_is_in_the_middle() {
        let far = CORNERS.map(|corner| corner + DVec3::splat(7.0));
        let mut soup = Soup::single("near", [CORNERS, far].concat(), TRIANGLES.to_vec());
        soup.triangles.extend(TRIANGLES.map(|corners| corners.map(|vertex| vertex + 4)));
        soup.end_part("far");
        let surface = Surface::build(&soup.select(&[0]).expect("a part")).expect("a tetrahedron");
        let transform = DrawTransform::around(&surface, &soup, Up::Y);
        assert_eq!(transform.place(DVec3::new(0.5, 1.0, 0.5)), Vec3::ZERO);
        assert_eq!(transform.scale, 1.0 / 8.0);
        assert_eq!(transform.length(4.0), 0.5);
    }
}
