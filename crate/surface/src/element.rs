//! Numbers of mesh elements, one type a meaning, and typed arrays of one value for each element.
//!
//! Three kinds of vertex are easily mixed up, so each has a type: [`InputVertex`] (of the file), [`VertexId`] (welded: the
//! unknown of every equation) and [`CutVertex`] (of the half-edges, where the surface may be cut). [`Surface`](crate::Surface)
//! converts between them.

use bytemuck::Zeroable;
pub use heatwalk_base::element::{Element, ElementData};

macro_rules! element {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Zeroable)]
        #[repr(transparent)]
        pub struct $name(pub u32);

        impl Element for $name {
            #[inline]
            fn from_index(index: usize) -> Self {
                debug_assert!(u32::try_from(index).is_ok(), "elements are numbered by 32 bits");
                Self(index as u32)
            }

            #[inline]
            fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.0.fmt(formatter)
            }
        }
    };
}

element!(
    /// A welded vertex of a [`Surface`](crate::Surface): one position, one unknown.
    VertexId
);
element!(
    /// A vertex of the input, as the file counts them: a row of [`Soup::positions`](crate::Soup::positions).
    InputVertex
);
element!(
    /// A vertex of a [`HalfedgeMesh`](crate::HalfedgeMesh). Several share one [`VertexId`] where the surface is cut.
    CutVertex
);
element!(
    /// A triangle of the input, as the file counts them: a row of [`Soup::triangles`](crate::Soup::triangles).
    InputTriangle
);
element!(
    /// A face of a [`HalfedgeMesh`](crate::HalfedgeMesh): a triangle, or, numbered after all triangles, the cap of a
    /// boundary loop.
    FaceId
);
element!(
    /// A half-edge of a [`HalfedgeMesh`](crate::HalfedgeMesh); number `3 f + k` leaves corner `k` of triangle `f` and stands
    /// for that corner, too.
    HalfedgeId
);

impl FaceId {
    /// The half-edge that leaves corner `k` (0 to 2) of this triangle.
    #[inline]
    pub fn halfedge(self, k: usize) -> HalfedgeId {
        HalfedgeId(3 * self.0 + k as u32)
    }
}

impl HalfedgeId {
    /// The triangle that this half-edge of a triangle belongs to.
    #[inline]
    pub fn triangle(self) -> FaceId {
        FaceId(self.0 / 3)
    }

    /// The corner (0 to 2) of its triangle that this half-edge of a triangle leaves.
    #[inline]
    pub fn corner(self) -> usize {
        self.0 as usize % 3
    }

    /// The half-edge after this one in its triangle.
    #[inline]
    pub fn next_in_triangle(self) -> Self {
        Self(if self.0 % 3 == 2 { self.0 - 2 } else { self.0 + 1 })
    }

    /// The half-edge before this one in its triangle.
    #[inline]
    pub fn previous_in_triangle(self) -> Self {
        Self(if self.0.is_multiple_of(3) { self.0 + 2 } else { self.0 - 1 })
    }
}

/// `#V` values, indexed by [`VertexId`].
pub type VertexData<T> = ElementData<VertexId, T>;
/// `#F` values, indexed by [`FaceId`].
pub type FaceData<T> = ElementData<FaceId, T>;
/// `#C` values, indexed by [`CutVertex`].
pub type CutVertexData<T> = ElementData<CutVertex, T>;
/// One value for each vertex of the input, indexed by [`InputVertex`].
pub type InputVertexData<T> = ElementData<InputVertex, T>;
/// One value for each triangle of the input, indexed by [`InputTriangle`].
pub type InputTriangleData<T> = ElementData<InputTriangle, T>;
