//! Means on a surface: of weighted places, and of the cells of samples.
//!
//! Both follow log maps: the mean of the vectors to all that is to be averaged points to where squared distances sum to less (Karcher,
//! "Riemannian center of mass and mollifier smoothing", 1977; on meshes Sharp, Soliman, Crane, "The vector heat method", 2019). All
//! distances and directions are those of exact paths.

use std::sync::Arc;

use glam::DVec3;
use heatwalk_sparse::{Progress, Stage, c64, report};
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, FaceId, Place, SurfacePoint, ToPoint, triangle};

use crate::directions::{Plane, searched};
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Heading, Root, WORK_BETWEEN_CALLS, Wavefront};
use crate::path::straightest;

/// Most steps to a mean. On smooth surfaces it takes less than ten.
const MOST_STEPS: usize = 60;

/// A step is halved so often until squared distances sum to less.
const HALVINGS: i32 = 20;

/// Steps that are a smaller share of the distances are rounding.
const ROUNDING: f64 = 1e-13;

/// Where squared distances from weighted places sum to least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mean {
    /// There.
    pub place: Place,
    /// The sum of weight times squared distance, by the sum of weights, in the square of the file's unit.
    pub variance: f64,
}

/// The mean of places by their weights, each positive: from the one of them that is best, downhill to where squared exact distances sum to
/// least. Places that lie around much of a surface may have several such means; this is one.
///
/// # Errors
/// [`Error::NoSource`] without a place; [`Error::BadParameter`] for a weight that is not positive and finite, and where the way leads
/// through a place at which the surface has no tangent plane; [`Error::Unreachable`] for places that no path joins;
/// [`Error::NotExact`] where faces have different costs; those of [`ToPoint::to_point`]; [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn mean<P: ToPoint>(geometry: &Arc<ExactGeometry>, places: &[(P, f64)], progress: Progress<'_>) -> Result<Mean> {
    let surface = geometry.surface();
    let mut points: Vec<(Place, f64)> = Vec::new();
    for &(place, weight) in places {
        if !(weight > 0.0 && weight.is_finite()) {
            let range = "positive and finite";
            return Err(Error::BadParameter { name: "the weight", value: weight.to_string(), range });
        }
        points.push((place.to_point(surface)?.place(), weight));
    }
    let Some(first) = nearest_to_center(surface, &points) else { return Err(Error::NoSource) };
    let mut here = Pull::at(geometry, first, &points, progress)?;
    for _ in 0..MOST_STEPS {
        let length = here.step.norm();
        if length <= ROUNDING * here.variance.sqrt() {
            break;
        }
        let direction = here.plane.vector(here.step);
        let mut shares = (0..HALVINGS).map(|halvings| 0.5_f64.powi(halvings));
        let next = shares.find_map(|share| {
            let end = walked(surface, here.place, direction, share * length)?;
            match Pull::at(geometry, end, &points, progress) {
                Ok(next) if next.variance >= here.variance => None,
                next => Some(next),
            }
        });
        match next {
            Some(next) => here = next?,
            None => break,
        }
    }
    Ok(Mean { place: here.place, variance: here.variance })
}

/// Moves samples to the middles of what is nearer to each than to all others, for so many rounds (Lloyd, "Least squares quantization in PCM",
/// 1982): of the areas there, the mean. Samples at places where the surface has no tangent plane stay.
///
/// # Errors
/// [`Error::NoSource`] without a sample; [`Error::NotExact`] where faces have different costs; those of [`ToPoint::to_point`];
/// [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn relaxed<P: ToPoint>(
    geometry: &Arc<ExactGeometry>,
    samples: &[P],
    rounds: usize,
    progress: Progress<'_>,
) -> Result<Vec<SurfacePoint>> {
    if samples.is_empty() {
        return Err(Error::NoSource);
    }
    let surface = geometry.surface();
    let mut samples =
        samples.iter().map(|sample| Ok(sample.to_point(surface)?)).collect::<Result<Vec<SurfacePoint>>>()?;
    let areas = vertex_areas(surface);
    for _ in 0..rounds {
        let front = searched(geometry, &samples, progress)?;
        let planes: Vec<Option<Plane>> =
            samples.iter().map(|sample| Plane::at(geometry, sample.place()).ok()).collect();
        // The sample that each leg comes from, and the direction in which it leaves.
        let mut ways: Vec<Option<(usize, c64)>> = vec![None; surface.vertex_count() + front.end_values().len()];
        front.for_each_leg(f64::INFINITY, |stop, leg| {
            ways[stop] = match (front.start_of_leg(leg), leg.root) {
                (Some(start), _) => ways[start],
                (None, Root::Source(sample)) => {
                    planes[sample].as_ref().map(|plane| (sample, c64::cis(plane.angle(&leg.departure))))
                }
                (None, _) => None,
            };
        })?;
        let mut sums = vec![(c64::new(0.0, 0.0), 0.0); samples.len()];
        for ((way, &distance), area) in ways.iter().zip(front.values()).zip(&areas) {
            if let Some((sample, direction)) = *way {
                sums[sample].0 += direction * (distance * area);
                sums[sample].1 += area;
            }
        }
        for ((sample, (sum, area)), plane) in samples.iter_mut().zip(sums).zip(&planes) {
            let step = sum / area;
            let end = plane
                .as_ref()
                .filter(|_| area > 0.0 && step.norm() > 0.0)
                .and_then(|plane| walked(surface, sample.place(), plane.vector(step), step.norm()));
            if let Some(end) = end {
                *sample = surface.point(end)?;
            }
        }
    }
    Ok(samples)
}

/// What a place is drawn by.
struct Pull {
    place: Place,
    plane: Plane,
    /// The mean of the vectors to all points, in the plane.
    step: c64,
    variance: f64,
}

impl Pull {
    fn at(
        geometry: &Arc<ExactGeometry>,
        place: Place,
        points: &[(Place, f64)],
        progress: Progress<'_>,
    ) -> Result<Self> {
        let place = geometry.settled(place);
        let targets: Vec<Place> = points.iter().map(|point| point.0).collect();
        let mut front = Wavefront::with_targets(Arc::clone(geometry), &[place], &targets)?;
        let farthest = |front: &Wavefront| front.target_values().iter().copied().fold(0.0, f64::max);
        while !front.is_done() && front.radius() <= farthest(&front) {
            front.advance(f64::INFINITY, WORK_BETWEEN_CALLS)?;
            report(progress, Stage::Searching { radius: front.radius() }, 0.0)?;
        }
        let plane = Plane::at(geometry, place)?;
        let (mut sum, mut variance, mut whole) = (c64::new(0.0, 0.0), 0.0, 0.0);
        for (number, &(_, weight)) in points.iter().enumerate() {
            let distance = front.target_values()[number];
            if distance.is_infinite() {
                return Err(Error::Unreachable);
            }
            variance += weight * distance * distance;
            whole += weight;
            let path = front.path_from_target(number)?;
            if let [.., before, _] = path.points[..] {
                let heading = Heading::towards(geometry, before.face.0, [place, geometry.settled(before.location)]);
                let direction = heading.map_or(c64::new(0.0, 0.0), |heading| c64::cis(plane.angle(&heading)));
                sum += direction * (weight * distance);
            }
        }
        Ok(Self { place, plane, step: sum / whole, variance: variance / whole })
    }
}

/// The end of a straight walk; none where there is no direction.
fn walked(surface: &Surface, from: Place, direction: DVec3, length: f64) -> Option<Place> {
    let walk = straightest(surface, from, None, direction, length).ok()?;
    walk.path.points.last().map(|point| point.location)
}

/// The point that is nearest to the weighted mean of all in space.
fn nearest_to_center(surface: &Surface, points: &[(Place, f64)]) -> Option<Place> {
    let whole: f64 = points.iter().map(|point| point.1).sum();
    let center: DVec3 = points.iter().map(|&(place, weight)| place.position(surface) * (weight / whole)).sum();
    let from_center = |place: &Place| place.position(surface).distance(center);
    let places = points.iter().map(|point| point.0);
    places.min_by(|a, b| from_center(a).total_cmp(&from_center(b)))
}

/// A third of the faces around each vertex (`#V`).
fn vertex_areas(surface: &Surface) -> Vec<f64> {
    let mut areas = vec![0.0; surface.vertex_count()];
    for face in (0..surface.face_count()).map(FaceId::from_index) {
        let share = triangle::length(triangle::area_vector(surface.corners(face))) / 6.0;
        surface.faces()[face].into_iter().for_each(|vertex| areas[vertex.index()] += share);
    }
    areas
}
