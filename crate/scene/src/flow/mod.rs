//! The descent of a distance from any point of the surface, leg by leg.

mod homes;

use glam::DVec3;
use heatwalk::Distance;
use heatwalk::SNAP;
use heatwalk::Surface;
use heatwalk::path::descent::{DescentDirection, leaves};
use heatwalk::surface::triangle;
use heatwalk::{Error, FaceData, FaceId, Result, VertexData};

use homes::{Arrival, Homes};

/// A point of the surface in one of the faces that it lies on. Weights that are exactly 0 tell edges and vertices.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub face: FaceId,
    /// Barycentric, non-negative, of sum 1.
    pub weights: [f64; 3],
}

impl Place {
    fn is_vertex(&self) -> bool {
        self.weights.contains(&1.0)
    }
}

/// The sum of vectors at the corners of a triangle with these weights.
pub(crate) fn combined([p, q, r]: [DVec3; 3], [a, b, c]: [f64; 3]) -> DVec3 {
    p * a + q * b + r * c
}

/// A straight segment of a descent, in one face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leg {
    pub from: Place,
    to: [f64; 3],
    /// In the file's unit.
    pub length: f64,
    /// Whether a source is at its end.
    pub is_last: bool,
    /// Where a portal at its end leads.
    leads_to: Option<Place>,
}

impl Leg {
    fn to_point(surface: &Surface, from: Place, to: [f64; 3], is_last: bool) -> Self {
        let leg = Self { from, to, length: 0.0, is_last, leads_to: None };
        Self { length: triangle::length(leg.vector(surface)), ..leg }
    }

    /// From the start to the end, in the file's unit; not of unit length.
    pub fn vector(&self, surface: &Surface) -> DVec3 {
        let change = [0, 1, 2].map(|k| self.to[k] - self.from.weights[k]);
        combined(surface.corners(self.from.face), change)
    }

    /// Where the next one begins.
    pub fn end(&self) -> Place {
        self.leads_to.unwrap_or(Place { weights: self.to, ..self.from })
    }

    /// Whether it ends at a portal, beyond which the way goes on.
    pub fn leads_on(&self) -> bool {
        self.leads_to.is_some()
    }

    /// The point at a share of the way.
    pub fn at(&self, share: f64) -> Place {
        let weights = [0, 1, 2].map(|k| self.from.weights[k] * (1.0 - share) + self.to[k] * share);
        Place { weights, ..self.from }
    }
}

/// A distance, made ready to be walked down.
#[derive(Debug, Clone)]
pub(crate) struct Flow {
    /// `#F × 3`, rates at which the barycentric weights change for each length walked down the steepest descent; zero
    /// where the distance is constant or infinite.
    rates: FaceData<[f64; 3]>,
    /// `#V`, in the file's unit.
    values: VertexData<f64>,
    pub homes: Homes,
}

impl Flow {
    /// Of no distance yet.
    pub fn new(surface: &Surface) -> Self {
        Self { rates: FaceData::default(), values: VertexData::default(), homes: Homes::new(surface) }
    }

    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Descends this distance from now on.
    ///
    /// # Errors
    /// [`Error::NoSource`] for a distance without sources; [`Error::Surface`] with `ForeignSurface` for a distance of another
    /// surface.
    pub fn follow(&mut self, surface: &Surface, distance: &Distance) -> Result<()> {
        if distance.sources.is_empty() {
            return Err(Error::NoSource);
        }
        surface.require_own(distance.surface(), "distance")?;
        self.homes.follow(surface, distance);
        self.values.clone_from(&distance.values);
        self.rates = surface.mesh().faces().map(|face| self.descent(surface, face).rates_by_length()).collect();
        Ok(())
    }

    /// The linear interpolation of the distance; infinite where there is none.
    pub fn value(&self, surface: &Surface, place: Place) -> f64 {
        let values = self.corner_values(surface, place.face);
        (0..3).filter(|&k| place.weights[k] > 0.0).map(|k| place.weights[k] * values[k]).sum()
    }

    fn descent(&self, surface: &Surface, face: FaceId) -> DescentDirection {
        DescentDirection::new(surface.corners(face), self.corner_values(surface, face))
    }

    fn corner_values(&self, surface: &Surface, face: FaceId) -> [f64; 3] {
        surface.faces()[face].map(|vertex| self.values[vertex])
    }

    /// Straight to the source or portal on the faces around by which the nearest source is reached soonest, else where the linear interpolation falls most steeply: into
    /// one of those faces or along their sides, to where the face is left. `None` at a minimum that is no source, and
    /// where no source can be reached: there is nothing lower than infinity among infinities.
    pub fn leg(&self, surface: &Surface, place: Place) -> Option<Leg> {
        let mut home: Option<(f64, Leg)> = None;
        let mut best: Option<Place> = None;
        let values = self.corner_values(surface, place.face);
        let value: f64 = (0..3).map(|k| place.weights[k] * values[k]).sum();
        for_each_side(surface, place, |side| {
            for Arrival { weights, distance, leads_to } in self.homes.in_face(side.face) {
                // A portal is on the way down only where it is lower: nobody comes back through one.
                if leads_to.is_some() && distance >= value {
                    continue;
                }
                let leads_to = leads_to.map(|(face, weights)| Place { face, weights });
                let leg = Leg { leads_to, ..Leg::to_point(surface, side, weights, leads_to.is_none()) };
                if home.is_none_or(|(nearest, _)| leg.length + distance < nearest) {
                    home = Some((leg.length + distance, leg));
                }
            }
            // Most places have one way down, whose slope need not be known.
            if self.enters(side)
                && best.is_none_or(|other| {
                    self.descent(surface, side.face).slope() > self.descent(surface, other.face).slope()
                })
            {
                best = Some(side);
            }
        });
        if let Some((_, leg)) = home {
            return Some(leg);
        }
        // From a vertex an edge may fall more steeply than any face. From elsewhere it does not; there, sides and corners
        // are for where faces point back at each other, where the surface ends, and for faces without a gradient.
        if place.is_vertex() || best.is_none() {
            let slope = best.map_or(0.0, |side| self.descent(surface, side.face).slope());
            if let Some(leg) = self.to_corner(surface, place, slope) {
                return Some(leg);
            }
        }
        let from = best?;
        let rates = self.rates[from.face];
        let (exit, length) = leaves(from.weights, rates)?;
        let mut to = [0, 1, 2].map(|k| from.weights[k] + length * rates[k]);
        to[exit] = 0.0;
        Some(Leg { from, to: settled(to), length, is_last: false, leads_to: None })
    }

    /// Whether the steepest descent of a face leads from a place on it into it.
    fn enters(&self, Place { face, weights }: Place) -> bool {
        let rates = self.rates[face];
        (0..3).all(|k| weights[k] > 0.0 || rates[k] >= 0.0) && rates != [0.0; 3]
    }

    /// Straight to the corner of a face around that is lower by the greatest slope, if by more than `least_slope`.
    fn to_corner(&self, surface: &Surface, place: Place, least_slope: f64) -> Option<Leg> {
        let values = self.corner_values(surface, place.face);
        let value: f64 = (0..3).map(|k| place.weights[k] * values[k]).sum();
        let (mut steepest, mut best) = (least_slope, None);
        for_each_side(surface, place, |side| {
            let values = self.corner_values(surface, side.face);
            for k in (0..3).filter(|&k| values[k] < value) {
                let leg = Leg::to_point(surface, side, corner(k), false);
                let slope = (value - values[k]) / leg.length;
                if slope > steepest {
                    (steepest, best) = (slope, Some(leg));
                }
            }
        });
        best
    }
}

/// The faces that a place lies on, with its weights in each.
fn for_each_side(surface: &Surface, place: Place, mut visit: impl FnMut(Place)) {
    let Place { face, weights } = place;
    if let Some(k) = weights.iter().position(|&weight| weight == 1.0) {
        for (face, k) in surface.corners_of_vertex(surface.faces()[face][k]) {
            visit(Place { face, weights: corner(k) });
        }
        return;
    }
    visit(place);
    if let Some(k) = weights.iter().position(|&weight| weight == 0.0) {
        let [i, j] = [(k + 1) % 3, (k + 2) % 3];
        let first = surface.faces()[face][i];
        for halfedge in surface.edges().around(face.halfedge(i)).skip(1) {
            let (face, m) = (halfedge.triangle(), halfedge.corner());
            let is_along = surface.faces()[face][m] == first;
            let mut beyond = [0.0; 3];
            beyond[m] = weights[if is_along { i } else { j }];
            beyond[(m + 1) % 3] = weights[if is_along { j } else { i }];
            visit(Place { face, weights: beyond });
        }
    }
}

/// Barycentric weights of a corner.
fn corner(k: usize) -> [f64; 3] {
    let mut weights = [0.0; 3];
    weights[k] = 1.0;
    weights
}

/// On the edge or at the corner where within [`SNAP`] of one.
fn settled(weights: [f64; 3]) -> [f64; 3] {
    let cut = weights.map(|weight| if weight <= SNAP { 0.0 } else { weight });
    let sum: f64 = cut.iter().sum();
    cut.map(|weight| weight / sum)
}
