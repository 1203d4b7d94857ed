//! Waves: distance that spreads along straight lines from a place, or from an edge that it bends around.

use glam::DVec3;
use heatwalk::surface::triangle::hypotenuse;

use crate::mesh::{NONE, Start};

/// Distances at the ends of an edge may differ by more than its length by this share of it, for rounding.
const ALONG: f64 = 1e-9;

/// Distance at cost `cost` from a virtual source. Behind a straight edge it spreads as if its source were turned around the edge
/// into the plane of edge and target (Keller, "Geometrical theory of diffraction" 1962), so that the edge, how far the source is
/// from it and where along it say all. A source that is a place is at distance 0 from an edge of length 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wave {
    /// The first end of the edge.
    base: DVec3,
    /// Unit vector to its other end.
    direction: DVec3,
    length: f64,
    /// Where the virtual source is along the edge, from the first end.
    along: f64,
    /// How far it is from the edge.
    apart: f64,
    /// Distance at the virtual source.
    initial: f64,
    /// Cost of each unit of length.
    pub(super) cost: f64,
    /// The ends of the edge; none for sources.
    pub(super) ends: Option<[u32; 2]>,
    /// The waves that it goes on from, at the ends of the edge; [`NONE`] for none.
    pub(super) parents: [u32; 2],
}

/// Where a wave comes from on its way to a place.
pub(super) struct Ray {
    /// The distance.
    pub(super) distance: f64,
    /// The last place before it is straight.
    pub(super) from: DVec3,
}

impl Wave {
    /// From a place.
    pub(super) fn from_place(place: DVec3, initial: f64, cost: f64, vertex: Option<u32>) -> Self {
        Self {
            base: place,
            direction: DVec3::X,
            length: 0.0,
            along: 0.0,
            apart: 0.0,
            initial,
            cost,
            ends: vertex.map(|vertex| [vertex; 2]),
            parents: [NONE; 2],
        }
    }

    /// From an edge, whose ends have these distances of waves that started with `initial` where they last began at a place. None
    /// where these do not belong to one virtual source.
    pub(super) fn from_edge(
        ends: [u32; 2],
        [base, end]: [DVec3; 2],
        distances: [f64; 2],
        initial: f64,
        cost: f64,
    ) -> Option<Self> {
        let [near, far] = distances.map(|distance| (distance - initial) / cost);
        let edge = end - base;
        let length = edge.length();
        // Written so that not a number is refused. Rounding may miss the equality of a wave that runs along the edge.
        let is_triangle = near + far >= length && (near - far).abs() <= length * (1.0 + ALONG);
        if !(near >= 0.0 && far >= 0.0 && length > 0.0 && is_triangle) {
            return None;
        }
        let along = ((near - far) * (near + far) / length + length) / 2.0;
        // Below 0 by rounding where the wave runs along the edge.
        let apart = (near * near - along * along).max(0.0).sqrt();
        let direction = edge / length;
        Some(Self { base, direction, length, along, apart, initial, cost, ends: Some(ends), parents: [NONE; 2] })
    }

    /// The same as the continuation of other waves.
    pub(super) fn after(self, parents: [u32; 2]) -> Self {
        Self { parents, ..self }
    }

    /// The distance of a place if the edge went on beyond its ends.
    pub(super) fn continued(&self, place: DVec3) -> f64 {
        let across = place - self.base;
        let along = across.dot(self.direction);
        let apart = (across - along * self.direction).length();
        self.initial + self.cost * hypotenuse(self.apart + apart, along - self.along)
    }

    /// The distance of a place, and where it comes from straight.
    #[inline]
    pub(super) fn ray(&self, place: DVec3) -> Ray {
        let across = place - self.base;
        if self.length == 0.0 {
            return Ray { distance: self.initial + self.cost * across.length(), from: self.base };
        }
        let along = across.dot(self.direction);
        let apart = (across - along * self.direction).length();
        let between = self.apart + apart;
        let crossing = if between > 0.0 { self.along + (along - self.along) * self.apart / between } else { along };
        let from = self.base + crossing.clamp(0.0, self.length) * self.direction;
        let length = if (0.0..=self.length).contains(&crossing) {
            hypotenuse(between, along - self.along)
        } else {
            // Around the end of the edge.
            let end = crossing.clamp(0.0, self.length);
            hypotenuse(self.apart, end - self.along) + hypotenuse(apart, along - end)
        };
        Ray { distance: self.initial + self.cost * length, from }
    }

    /// Whether it comes from a source.
    pub(super) fn is_first(&self) -> bool {
        self.ends.is_none()
    }

    /// Where in the mesh a line that comes from a place on the edge begins; none for sources.
    pub(super) fn start_at(&self, place: DVec3) -> Option<Start> {
        let [first, second] = self.ends?;
        let along = (place - self.base).dot(self.direction);
        Some(if along <= ALONG * self.length {
            Start::Vertex(first)
        } else if along >= (1.0 - ALONG) * self.length {
            Start::Vertex(second)
        } else {
            Start::Edge([first, second])
        })
    }

    /// The distance at which it began at a place.
    pub(super) fn initial(&self) -> f64 {
        self.initial
    }
}
