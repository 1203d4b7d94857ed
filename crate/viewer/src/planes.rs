//! The planes of a cut.

use glam::{Vec3, Vec4};

use crate::error::Error;

/// Planes that cut the surface open; world space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Cut {
    /// Normal and offset; one twice where there is one.
    planes: Option<[Vec4; 2]>,
}

impl Cut {
    /// Of none, one or two planes.
    ///
    /// # Errors
    /// When there are more, or a number is not finite.
    pub(crate) fn new(planes: &[Vec4]) -> Result<Self, Error> {
        if let Some(index) = planes.iter().position(|plane| !plane.is_finite()) {
            return Err(Error::NotFinite { what: "planes of the cut", index });
        }
        match *planes {
            [] => Ok(Self { planes: None }),
            [plane] => Ok(Self { planes: Some([plane; 2]) }),
            [first, second] => Ok(Self { planes: Some([first, second]) }),
            _ => Err(Error::WrongLength { what: "planes of the cut", expected: 8, found: 4 * planes.len() }),
        }
    }

    pub(crate) fn is_none(self) -> bool {
        self.planes.is_none()
    }

    /// Whether what is at a place is cut away: it is beyond both planes.
    pub(crate) fn takes(self, place: Vec3) -> bool {
        self.planes.is_some_and(|planes| planes.iter().all(|plane| plane.truncate().dot(place) > plane.w))
    }

    /// As shared.wgsl has them.
    pub(crate) fn uniform(self) -> [Vec4; 2] {
        self.planes.unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_plane_takes_a_half_and_two_a_wedge() {
        let (right, front) = (Vec3::X.extend(0.5), Vec3::Z.extend(0.0));
        let [right_only, both, neither] =
            [Vec3::new(1.0, 0.0, -1.0), Vec3::new(1.0, 0.0, 1.0), Vec3::new(0.5, 0.0, -1.0)];
        let taken = |planes: &[Vec4]| {
            let cut = Cut::new(planes).expect("planes");
            [right_only, both, neither].map(|place| cut.takes(place))
        };
        assert_eq!(taken(&[]), [false; 3]);
        assert_eq!(taken(&[right]), [true, true, false], "what lies in the plane stays");
        assert_eq!(taken(&[right, front]), [false, true, false]);
    }

    #[test]
    fn refuses_what_is_no_plane() {
        let plane = Vec4::X;
        assert!(matches!(Cut::new(&[plane; 3]), Err(Error::WrongLength { expected: 8, found: 12, .. })));
        assert!(matches!(Cut::new(&[plane, Vec4::NAN]), Err(Error::NotFinite { index: 1, .. })));
    }
}
