//! Distance from curves with a sign.

use std::collections::BTreeMap;
use std::sync::Arc;

use heatwalk_base::sort;
use heatwalk_sparse::Progress;
use heatwalk_surface::{Element, FaceId, Place, Surface, ToPoint, VertexData};

use super::Curve;
use super::distance::{Ends, curve_search};
use super::sides::{Joint, Side, sides};
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Segment, Wavefront};
use crate::heat::VectorHeat;
use crate::options::Sign;

/// Distance from curves, and how its sign was found.
#[derive(Debug, Clone, PartialEq)]
pub struct SignedDistance {
    /// `#V`, in the file's unit: as large as the exact distance, negative on the left of the curves; infinite where none is reached.
    pub values: VertexData<f64>,
    /// [`Sign::Nearest`] or [`Sign::Heat`].
    pub sign: Sign,
    /// `#V`, negative on the left and NaN where it is not known: what tells the sign by heat.
    heat: Option<VertexData<f64>>,
}

/// The exact distance of each vertex from the nearest point of any of the curves, negative on the left of these, so that a curve that runs
/// counterclockwise, as seen from outside, has its inside negative.
///
/// By heat, what is within a mean edge has the side from which it sees the curve, but for what sees an open end.
///
/// # Errors
/// As [`curve_search`]; [`Error::Cancelled`]; with [`Sign::Nearest`] [`Error::BadParameter`] for a curve that bends where the triangles
/// around are not one ring or fan of one orientation; with the others those of [`VectorHeat::new`].
pub fn signed_curve_distance(
    geometry: &Arc<ExactGeometry>,
    curves: &[Curve],
    sign: Sign,
    progress: Progress<'_>,
) -> Result<SignedDistance> {
    let Seen { front, near, joints, segments } = Seen::of(geometry, curves, &[], progress)?;
    let is_simple = || joints.iter().all(|joint| joint.is_passed_once()) && !cross(geometry, &segments);
    let near = match near {
        Err(error) if sign == Sign::Nearest => return Err(error),
        near => near.ok().map(|[of_vertices, _]| of_vertices),
    };
    let values = front.values();
    if let Some(near) = near.as_ref().filter(|_| sign == Sign::Nearest || (sign == Sign::Auto && is_simple())) {
        let values = values.iter().zip(near).map(|(&value, side)| signed(value, side.is_left)).collect();
        return Ok(SignedDistance { values, sign: Sign::Nearest, heat: None });
    }
    let near = optional(near, values.len());
    let surface = geometry.surface();
    let known = beside(surface, &segments, values, &near);
    let lines = curves.iter().flat_map(Curve::lines).map(|line| (line.face, line.ends));
    let heat = VectorHeat::new(surface, progress)?.signed_distance(lines, &known, progress)?;
    let close = surface.mean_edge();
    let of = |((&value, &heat), side)| by_heat(value, side, heat, close);
    let values = values.iter().zip(&heat).zip(near).map(of).collect();
    Ok(SignedDistance { values, sign: Sign::Heat, heat: Some(heat) })
}

impl SignedDistance {
    /// The distances of places from the curves that these are distances from, by one more search.
    ///
    /// By heat, what is beyond a mean edge has the sign that the values of the vertices around have in the mean.
    ///
    /// # Errors
    /// As [`curve_search`]; [`Error::Cancelled`].
    pub fn at<P: ToPoint>(
        &self,
        geometry: &Arc<ExactGeometry>,
        curves: &[Curve],
        places: &[P],
        progress: Progress<'_>,
    ) -> Result<Vec<f64>> {
        let surface = geometry.surface();
        let places = places.iter().map(|place| Ok(place.to_point(surface)?.place())).collect::<Result<Vec<Place>>>()?;
        let Seen { front, near, .. } = Seen::of(geometry, curves, &places, progress)?;
        let values = front.target_values();
        let Some(heat) = &self.heat else {
            let [_, sides] = near?;
            return Ok(values.iter().zip(sides).map(|(&value, side)| signed(value, side.is_left)).collect());
        };
        let close = surface.mean_edge();
        let sides = optional(near.ok().map(|[_, of_targets]| of_targets), values.len());
        let of = |((&value, place), side): ((&f64, &Place), Option<Side>)| {
            by_heat(value, side, place.interpolate(surface, heat), close)
        };
        Ok(values.iter().zip(&places).zip(sides).map(of).collect())
    }
}

/// A search from curves that has ended.
struct Seen {
    front: Wavefront,
    /// The sides from which vertices and targets see the curves; an error where a curve bends so that none are known.
    near: Result<[Vec<Side>; 2]>,
    joints: Vec<Joint>,
    segments: Vec<Segment>,
}

impl Seen {
    fn of(geometry: &Arc<ExactGeometry>, curves: &[Curve], targets: &[Place], progress: Progress<'_>) -> Result<Self> {
        let mut front = curve_search(geometry, curves, targets)?;
        front.grow(f64::INFINITY, progress)?;
        let Ends { joints, segments, .. } = Ends::of(geometry, curves)?;
        let near = match sides(&front, &joints) {
            Err(error @ Error::BadParameter { .. }) => Err(error),
            sides => Ok(sides?),
        };
        Ok(Self { front, near, joints, segments })
    }
}

fn optional(sides: Option<Vec<Side>>, count: usize) -> Vec<Option<Side>> {
    sides.map_or_else(|| vec![None; count], |sides| sides.into_iter().map(Some).collect())
}

/// The distance with its sign: that of the side up to `close`, else that of what heat tells.
fn by_heat(value: f64, side: Option<Side>, heat: f64, close: f64) -> f64 {
    match side {
        Some(side) if heat.is_nan() || (value <= close && !side.is_end) => signed(value, side.is_left),
        _ => signed(value, heat < 0.0),
    }
}

fn signed(value: f64, is_left: bool) -> f64 {
    if is_left && value.is_finite() && value > 0.0 { -value } else { value }
}

/// The distances of vertices of the faces that curves lead through, but of those that see an open end.
fn beside(
    surface: &Surface,
    segments: &[Segment],
    values: &VertexData<f64>,
    near: &[Option<Side>],
) -> VertexData<Option<f64>> {
    let mut known = vec![None; values.len()];
    for vertex in segments.iter().flat_map(|segment| surface.faces()[FaceId(segment.face)]) {
        let side = near[vertex.index()].filter(|side| !side.is_end);
        known[vertex.index()] = side.map(|side| if side.is_left { -values[vertex] } else { values[vertex] });
    }
    known.into()
}

/// Whether any segments of a face cross.
fn cross(geometry: &ExactGeometry, segments: &[Segment]) -> bool {
    let mut of_faces: BTreeMap<u32, Vec<[[f64; 2]; 2]>> = BTreeMap::new();
    for segment in segments {
        let frame = geometry.frame(segment.face);
        let mut ends = segment.ends.map(|weights| frame.place(0, weights));
        sort::sort_by(&mut ends, |a, b| a[0].total_cmp(&b[0]));
        of_faces.entry(segment.face).or_default().push(ends);
    }
    of_faces.values_mut().any(|lines| {
        // Along the first side of the face, so that few are compared.
        sort::sort_by(lines, |a, b| a[0][0].total_cmp(&b[0][0]));
        lines.iter().enumerate().any(|(first, line)| {
            let beside = lines[first + 1..].iter().take_while(|other| other[0][0] <= line[1][0]);
            beside.into_iter().any(|other| divides(line, other) && divides(other, line))
        })
    })
}

/// Whether the ends of one line lie on different sides of another.
fn divides([p, q]: &[[f64; 2]; 2], ends: &[[f64; 2]; 2]) -> bool {
    let side = |[x, y]: [f64; 2]| (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    side(ends[0]) * side(ends[1]) < 0.0
}
