use glam::Vec3;

/// A bounding sphere around the centre of the axis-aligned box; world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundingSphere {
    /// Centre of the box.
    pub center: Vec3,
    /// Greatest distance of a point from the centre; positive.
    pub radius: f32,
    /// Height of the lowest point.
    pub lowest: f32,
    /// Longest side of the box; positive.
    pub side: f32,
}

impl BoundingSphere {
    /// Stands in while nothing is shown, so that the camera always has a scale.
    pub const UNIT: Self = Self { center: Vec3::ZERO, radius: 1.0, lowest: -1.0, side: 2.0 };

    /// Least and greatest corner of a box that holds the points: as low as they are, as wide as the sphere elsewhere.
    #[must_use]
    pub fn cube(&self) -> [Vec3; 2] {
        let (low, high) = (self.center - self.radius, self.center + self.radius);
        [Vec3::new(low.x, self.lowest, low.z), high]
    }

    /// Bounds of points, or None when there are none.
    #[must_use]
    pub fn of_points<'a>(points: impl Iterator<Item = &'a Vec3> + Clone) -> Option<Self> {
        let first = *points.clone().next()?;
        let (low, high) = points.clone().fold((first, first), |(low, high), &point| (low.min(point), high.max(point)));
        let center = 0.5 * (low + high);
        let radius = points.map(|point| point.distance_squared(center)).fold(0.0, f32::max).sqrt();
        let side = (high - low).max_element();
        // A single point still needs a scale to be looked at. Squares vanish before sides do.
        let [radius, side] = if radius > 0.0 { [radius, side] } else { [1.0, 2.0] };
        Some(Self { center, radius, lowest: low.y, side })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sphere_is_centred_on_the_box() {
        let points = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(3.0, 0.0, 0.0), Vec3::new(0.0, 1.0, -1.0)];
        let bounds = BoundingSphere::of_points(points.iter()).expect("three points");
        assert_eq!((bounds.center, bounds.side), (Vec3::new(1.0, 0.5, -0.5), 4.0));
        // (2, 0.5, 0.5) from the centre; the square root rounds once.
        assert!((bounds.radius - 4.5_f32.sqrt()).abs() < 1e-6);
    }

    #[test]
    fn a_single_point_has_a_scale() {
        let bounds = BoundingSphere::of_points([Vec3::splat(3.0)].iter()).expect("one point");
        assert_eq!(bounds, BoundingSphere { center: Vec3::splat(3.0), radius: 1.0, lowest: 3.0, side: 2.0 });
        let nearly_one = BoundingSphere::of_points([Vec3::ZERO, Vec3::splat(1e-30)].iter()).expect("two points");
        assert_eq!((nearly_one.radius, nearly_one.side), (1.0, 2.0));
        assert_eq!(BoundingSphere::of_points([].iter()), None);
    }
}
