//! What paths cost where the front goes, and how windows bend where that changes.

use heatwalk_surface::FaceId;

use crate::cost::Costs;
use crate::exact::{Beam, length};
use crate::extremum::{larger, smaller};

/// What a unit of length costs in each face.
pub(super) trait Medium: Send + Sync + 'static {
    /// Whether it is 1 everywhere, which takes no work.
    const IS_UNIFORM: bool;

    /// In this face; positive and finite.
    fn cost(&self, face: u32) -> f64;
}

/// A unit of length costs 1 everywhere.
#[derive(Debug)]
pub(super) struct Uniform;

impl Medium for Uniform {
    const IS_UNIFORM: bool = true;

    #[inline(always)]
    fn cost(&self, _: u32) -> f64 {
        1.0
    }
}

impl Medium for Costs {
    const IS_UNIFORM: bool = false;

    #[inline(always)]
    fn cost(&self, face: u32) -> f64 {
        self.of(FaceId(face))
    }
}

/// The largest sine of the angle of refraction that is followed. Beyond, rays run along the edge, which windows from its
/// ends do better.
const MOST_SINE: f64 = 0.9999;

/// Edges that the source of a window lies behind its half-edge that stands for a plane wave.
const FAR: f64 = 1e4;

/// A window beyond an edge where the cost changes, as seen in the face behind it; `None` where all of it is reflected.
/// Lengths stay, distances are in units of the cost on each side. `ratio` is the cost before over that behind.
///
/// Refracted waves have no source that is a point. The one that stands for it sends the ray through the window's middle by
/// Snell's law, and its wave has the curvature of the refracted one there: its distance on the edge differs by terms of the
/// third order in the window's width.
pub(super) fn refracted(beam: &Beam, ratio: f64) -> Option<Beam> {
    let mut within = *beam;
    if ratio * MOST_SINE.recip() > 1.0 {
        // Total reflection beyond.
        let sine = MOST_SINE / ratio;
        let reach = beam.depth * sine / (1.0 - sine * sine).sqrt();
        within.begin = larger(beam.begin, beam.x - reach);
        within.end = smaller(beam.end, beam.x + reach);
        if within.begin >= within.end {
            return None;
        }
    }
    let middle = 0.5 * (within.begin + within.end);
    let from_source = length(middle - beam.x, beam.depth);
    let (sine, cosine) = ((middle - beam.x) / from_source, beam.depth / from_source);
    let sine_behind = ratio * sine;
    let cosine_behind = (1.0 - sine_behind * sine_behind).sqrt();
    let radius = from_source / ratio * (cosine_behind / cosine).powi(2);
    let refracted = Beam {
        x: middle - radius * sine_behind,
        depth: radius * cosine_behind,
        offset: ratio * (beam.offset + from_source) - radius,
        ..within
    };
    // No nearer at either end than it is.
    let short = [within.begin, within.end].map(|at| ratio * beam.at(at) - refracted.at(at));
    let refracted = Beam { offset: refracted.offset + larger(larger(short[0], short[1]), 0.0), ..refracted };
    (refracted.depth > 0.0).then_some(refracted)
}

/// The wave that a path along a half-edge sends into its face, where the other side of the edge costs a share of the face:
/// it leaves the edge under the critical angle everywhere. The path begins at the half-edge's begin, at this distance, in
/// units of the face's cost.
pub(super) fn head_wave(along: f64, distance: f64, share: f64, root: u32) -> Beam {
    let radius = FAR * along;
    Beam {
        begin: 0.0,
        end: along,
        x: -radius * share,
        depth: radius * (1.0 - share * share).sqrt(),
        offset: distance - radius,
        root,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn window(x: f64) -> Beam {
        Beam { begin: 0.45, end: 0.55, x, depth: 2.0, offset: 3.0, root: 0 }
    }

    #[test]
    fn a_refracted_window_has_the_distance_its_slope_and_its_curvature() {
        for ratio in [0.2, 0.7, 1.3] {
            let before = window(-0.4);
            let behind = refracted(&before, ratio).expect("no total reflection");
            let difference = |at: f64| ratio * before.at(at) - behind.at(at);
            let step = 0.01;
            assert!(difference(0.5).abs() < 1e-4, "what keeps the ends from being too near");
            let slope = (difference(0.5 + step) - difference(0.5 - step)) / (2.0 * step);
            let bent = difference(0.5 + step) - 2.0 * difference(0.5) + difference(0.5 - step);
            let curvature = bent / (step * step);
            // What is left are the terms of third and fourth order.
            assert!(slope.abs() < 1e-4 && curvature.abs() < 1e-4, "{ratio}: {slope:e}, {curvature:e}");
        }
    }

    #[test]
    fn what_meets_the_edge_beyond_the_critical_angle_stays_on_its_side() {
        assert_eq!(refracted(&window(-9.0), 2.0), None);
        let cut = refracted(&Beam { begin: 0.0, end: 9.0, ..window(0.0) }, 2.0).expect("some of it passes");
        // The critical angle is 30°.
        assert!((cut.end - 2.0 / 3.0_f64.sqrt()).abs() < 1e-3, "{cut:?}");
    }

    #[test]
    fn a_head_wave_grows_along_its_edge_as_the_cheaper_side_costs() {
        let wave = head_wave(0.5, 7.0, 0.3, 0);
        assert!((wave.at(0.0) - 7.0).abs() < 1e-9);
        assert!((wave.at(0.5) - 7.15).abs() < 1e-4, "{}", wave.at(0.5));
    }
}
