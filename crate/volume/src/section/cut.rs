//! What is taken away of a mesh to look inside.

use glam::DVec3;

use crate::mesh::TetMesh;

/// A plane, and the half-space beyond it that is taken away: where `normal · p > offset`. What lies in the plane itself stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Of length 1, to the side that is taken away.
    pub normal: DVec3,
    /// How far the plane is from the origin along `normal`, in the file's unit.
    pub offset: f64,
}

impl Plane {
    /// Through a place, taking away what is ahead of it in a direction of any length; none where that has no direction.
    pub fn through(place: DVec3, direction: DVec3) -> Option<Self> {
        let normal = direction.try_normalize()?;
        Some(Self { normal, offset: normal.dot(place) })
    }

    /// How far a place is beyond the plane, in the file's unit; negative or 0 where it stays.
    #[inline]
    pub fn beyond(&self, place: DVec3) -> f64 {
        self.normal.dot(place) - self.offset
    }
}

/// What is taken away of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Cut {
    /// Nothing.
    #[default]
    Whole,
    /// What is beyond a plane.
    Plane(Plane),
    /// What is beyond both of two planes.
    Wedge([Plane; 2]),
}

impl Cut {
    /// Whether a place is taken away.
    #[inline]
    pub fn removes(&self, place: DVec3) -> bool {
        match self {
            Self::Whole => false,
            Self::Plane(plane) => plane.beyond(place) > 0.0,
            Self::Wedge(planes) => planes.iter().all(|plane| plane.beyond(place) > 0.0),
        }
    }

    /// The planes that bound what is taken away.
    pub fn planes(&self) -> &[Plane] {
        match self {
            Self::Whole => &[],
            Self::Plane(plane) => std::slice::from_ref(plane),
            Self::Wedge(planes) => planes,
        }
    }
}

/// A part of a mesh that is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Left,
    TakenAway,
}

/// On which sides of the planes of a cut the vertices of a mesh are.
pub(super) struct Sides {
    /// `#V`, one bit for each plane that a vertex is beyond.
    of_vertex: Vec<u8>,
    all: u8,
}

/// Where a tetrahedron is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// Before one of the planes with all of it: it stays.
    Before,
    /// Beyond all planes with all of it: it is taken away.
    Beyond,
    /// Some of it may stay and some not. It crosses the planes of these bits.
    Across(u8),
}

impl Sides {
    pub(super) fn new(mesh: &TetMesh, cut: &Cut) -> Self {
        let mut of_vertex = vec![0; mesh.vertex_count()];
        for (bit, plane) in cut.planes().iter().enumerate() {
            for (side, &place) in of_vertex.iter_mut().zip(mesh.positions()) {
                *side |= u8::from(plane.beyond(place) > 0.0) << bit;
            }
        }
        // Without planes there is one that nothing is beyond.
        Self { of_vertex, all: (1 << cut.planes().len().max(1)) - 1 }
    }

    /// The side of a tetrahedron with these corners.
    #[inline]
    pub(super) fn of(&self, corners: &[u32; 4]) -> Side {
        let [a, b, c, d] = corners.map(|vertex| self.of_vertex[vertex as usize]);
        let (some, every) = (a | b | c | d, a & b & c & d);
        if some != self.all {
            Side::Before
        } else if every == self.all {
            Side::Beyond
        } else {
            Side::Across(some ^ every)
        }
    }
}

/// What is seen where a mesh is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Faces {
    /// The cut itself: polygons in which planes cross tetrahedra.
    #[default]
    Smooth,
    /// Whole tetrahedra: those whose centroid stays.
    Tetrahedra,
}
