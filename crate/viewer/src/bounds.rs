use glam::Vec3;

/// A bounding sphere around the centre of the axis-aligned box; world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Centre of the box.
    pub center: Vec3,
    /// Greatest distance of a point from the centre; positive.
    pub radius: f32,
}

impl Bounds {
    /// Stands in while nothing is shown, so that the camera always has a scale.
    pub const UNIT: Self = Self { center: Vec3::ZERO, radius: 1.0 };

    /// Bounds of points, or None when there are none.
    #[must_use]
    pub fn of_points(points: &[Vec3]) -> Option<Self> {
        let first = *points.first()?;
        let (low, high) = points.iter().fold((first, first), |(low, high), &point| (low.min(point), high.max(point)));
        let center = 0.5 * (low + high);
        let radius = points.iter().map(|point| point.distance_squared(center)).fold(0.0, f32::max).sqrt();
        // A single point still needs a scale to be looked at.
        Some(Self { center, radius: if radius > 0.0 { radius } else { 1.0 } })
    }

    /// The smallest sphere around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        let gap = self.center.distance(other.center);
        if gap + other.radius <= self.radius {
            return self;
        }
        if gap + self.radius <= other.radius {
            return other;
        }
        let radius = 0.5 * (gap + self.radius + other.radius);
        let center = self.center + (other.center - self.center) * ((radius - self.radius) / gap);
        Self { center, radius }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn union_touches_both_spheres() {
        let left = Bounds { center: Vec3::new(-2.0, 0.0, 0.0), radius: 1.0 };
        let right = Bounds { center: Vec3::new(3.0, 0.0, 0.0), radius: 2.0 };
        let both = left.union(right);
        assert_eq!(both, Bounds { center: Vec3::new(1.0, 0.0, 0.0), radius: 4.0 });
        assert_eq!(both.union(left), both, "a sphere inside changes nothing");
    }

    #[test]
    fn a_single_point_has_a_scale() {
        let bounds = Bounds::of_points(&[Vec3::splat(3.0)]).expect("one point");
        assert_eq!((bounds.center, bounds.radius), (Vec3::splat(3.0), 1.0));
        assert_eq!(Bounds::of_points(&[]), None);
    }
}
