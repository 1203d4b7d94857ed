use glam::Vec3;

/// A polyline on the surface with the surface's normals, walked by arc length.
#[derive(Clone, Debug)]
pub struct Track {
    points: Vec<Vec3>,
    normals: Vec<Vec3>,
    /// Arc length from the start to each point; non-decreasing.
    arcs: Vec<f32>,
}

/// A place on a track, and how something that walks there stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// On the polyline; world space.
    pub position: Vec3,
    /// Up, unit length.
    pub normal: Vec3,
    /// Ahead, unit length, at right angles to the normal.
    pub tangent: Vec3,
}

/// How one of the crowd stands.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct CrowdPose {
    /// World space.
    pub position: Vec3,
    /// Up, unit length.
    pub normal: Vec3,
    /// Ahead, unit length.
    pub heading: Vec3,
    /// Length walked so far; world units.
    pub arc: f32,
}

impl CrowdPose {
    pub(crate) fn is_finite(&self) -> bool {
        self.position.is_finite() && self.normal.is_finite() && self.heading.is_finite() && self.arc.is_finite()
    }
}

impl Track {
    /// A track through points with one normal each, or None when fewer than two points differ.
    #[must_use]
    pub fn new(points: Vec<Vec3>, normals: Vec<Vec3>) -> Option<Self> {
        assert_eq!(points.len(), normals.len(), "one normal a point");
        let mut arcs = Vec::with_capacity(points.len());
        // Thousands of short segments add up: single precision would drift.
        let mut arc = 0.0_f64;
        for (index, point) in points.iter().enumerate() {
            if index > 0 {
                arc += f64::from(point.distance(points[index - 1]));
            }
            arcs.push(arc as f32);
        }
        (arc > 0.0).then_some(Self { points, normals, arcs })
    }

    /// Length from start to end; world units.
    #[must_use]
    pub fn length(&self) -> f32 {
        *self.arcs.last().expect("a track has points")
    }

    /// Index of the segment that holds the arc length, and the fraction along it.
    fn segment(&self, arc: f32) -> (usize, f32) {
        let end = self.arcs.partition_point(|&known| known <= arc).clamp(1, self.arcs.len() - 1);
        let (low, high) = (self.arcs[end - 1], self.arcs[end]);
        let fraction = if high > low { ((arc - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
        (end - 1, fraction)
    }

    /// World position at an arc length; clamped to the ends.
    #[must_use]
    pub fn position(&self, arc: f32) -> Vec3 {
        let (index, fraction) = self.segment(arc);
        self.points[index].lerp(self.points[index + 1], fraction)
    }

    /// How a walker stands at an arc length (clamped to the ends). The heading is the chord over `reach` to either
    /// side: a path over a mesh bends at every edge, and a walker that turned with each bend would twitch.
    #[must_use]
    pub fn pose(&self, arc: f32, reach: f32) -> Pose {
        let (index, fraction) = self.segment(arc);
        let (near, far) = (self.normals[index], self.normals[index + 1]);
        let position = self.points[index].lerp(self.points[index + 1], fraction);
        let normal = near.lerp(far, fraction).try_normalize().or_else(|| near.try_normalize()).unwrap_or(Vec3::Y);
        let chord = self.position(arc + reach) - self.position(arc - reach);
        let tangent = chord
            .reject_from_normalized(normal)
            .try_normalize()
            .or_else(|| (self.points[index + 1] - self.points[index]).reject_from_normalized(normal).try_normalize())
            .unwrap_or_else(|| normal.any_orthonormal_vector());
        Pose { position, normal, tangent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a few operations on numbers near one.
    const TOLERANCE: f32 = 1e-5;

    fn corner() -> Track {
        let points = vec![Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0), Vec3::new(2.0, 0.0, 1.0)];
        Track::new(points, vec![Vec3::Y; 3]).expect("two segments")
    }

    #[test]
    fn arc_length_finds_positions_and_clamps() {
        let track = corner();
        assert_eq!(track.length(), 3.0);
        assert_eq!(track.position(0.5), Vec3::new(0.5, 0.0, 0.0));
        assert_eq!(track.position(2.25), Vec3::new(2.0, 0.0, 0.25));
        assert_eq!(track.position(-1.0), Vec3::ZERO);
        assert_eq!(track.position(9.0), Vec3::new(2.0, 0.0, 1.0));
    }

    #[test]
    fn heading_turns_gradually_around_a_corner() {
        let track = corner();
        assert!((track.pose(0.5, 0.1).tangent - Vec3::X).length() < TOLERANCE);
        let diagonal = Vec3::new(1.0, 0.0, 1.0).normalize();
        assert!((track.pose(2.0, 0.1).tangent - diagonal).length() < TOLERANCE);
        assert!((track.pose(3.0, 0.1).tangent - Vec3::Z).length() < TOLERANCE);
    }

    #[test]
    fn poses_are_orthonormal_on_a_sphere() {
        let points: Vec<Vec3> =
            (0..=40).map(|step| Vec3::new((step as f32 * 0.05).cos(), (step as f32 * 0.05).sin(), 0.0)).collect();
        let track = Track::new(points.clone(), points).expect("an arc");
        for step in 0..100 {
            let pose = track.pose(step as f32 * 0.02, 0.03);
            assert!(pose.normal.is_normalized() && pose.tangent.is_normalized());
            assert!(pose.normal.dot(pose.tangent).abs() < TOLERANCE);
            assert!(pose.normal.cross(pose.tangent).z > 0.99, "walks counter-clockwise");
        }
    }

    #[test]
    fn repeated_points_are_harmless_and_a_point_is_no_track() {
        let track = Track::new(vec![Vec3::ZERO, Vec3::ZERO, Vec3::X], vec![Vec3::Z; 3]).expect("one real segment");
        assert_eq!(track.pose(0.0, 0.0).tangent, Vec3::X);
        assert!(Track::new(vec![Vec3::ONE; 2], vec![Vec3::Z; 2]).is_none());
        assert!(Track::new(vec![], vec![]).is_none());
    }
}
