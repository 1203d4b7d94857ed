//! Bézier curves on a surface: de Casteljau's algorithm with shortest paths in place of lines.
//!
//! Park and Ravani, "Bézier curves on Riemannian manifolds and Lie groups with kinematics applications" (1995); Mancinelli, Nazzaro,
//! Pellacini, Puppo, "b/Surf: interactive Bézier splines on surface meshes" (2022), for halving again and again.

use std::sync::Arc;

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Path, Place, SurfacePoint, ToPoint};

use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, interruptible_path};

/// A piece of the curve is drawn straight once its control polygon is longer than the path between its ends by this share at most.
const STRAIGHT: f64 = 1e-4;

/// No piece is shorter than this, in the parameter of the curve.
const LEAST_PIECE: f64 = 1.0 / 1024.0;

/// A Bézier curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Bezier {
    /// Shortest paths between the points, one after another.
    pub path: Path,
    /// Points of the curve with their parameters, from 0 at the first control place to 1 at the last.
    pub points: Vec<(f64, SurfacePoint)>,
}

/// Places that control a piece of the curve, and the parameters of its ends.
struct Piece {
    controls: Vec<SurfacePoint>,
    begin: f64,
    end: f64,
}

/// The Bézier curve of control places, of which it begins at the first and ends at the last: its control polygon of shortest paths is
/// halved by de Casteljau's algorithm, and so are both halves, until they are all but straight. In a plane its points are those of the
/// polynomial. Where the paths between control places jump, across the cut locus, so does the curve.
///
/// # Errors
/// [`Error::NoSource`] without a place; [`Error::Unreachable`] for places that no path joins; those of [`ToPoint::to_point`];
/// [`Error::NotExact`] where faces have different costs; [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn bezier<P: ToPoint>(geometry: &Arc<ExactGeometry>, controls: &[P], progress: Progress<'_>) -> Result<Bezier> {
    let surface = geometry.surface();
    let controls = controls.iter().map(|place| Ok(place.to_point(surface)?)).collect::<Result<Vec<_>>>()?;
    let (Some(&first), Some(&last)) = (controls.first(), controls.last()) else { return Err(Error::NoSource) };
    let mut path: Option<Path> = None;
    let mut points = vec![(0.0, first)];
    let mut open = vec![Piece { controls, begin: 0.0, end: 1.0 }];
    while let Some(piece) = open.pop() {
        report(progress, Stage::Searching { radius: 0.0 }, piece.begin)?;
        let mut join = |from: &SurfacePoint, to: &SurfacePoint| interruptible_path(geometry, *from, &[*to], progress);
        let legs = legs(&piece.controls, &mut join)?;
        let chord = join(&piece.controls[0], &piece.controls[piece.controls.len() - 1])?;
        let around: f64 = legs.iter().map(Path::length).sum();
        if around <= (1.0 + STRAIGHT) * chord.length() || piece.end - piece.begin <= LEAST_PIECE {
            points.push((piece.end, piece.controls[piece.controls.len() - 1]));
            path = Some(path.map_or_else(|| chord.clone(), |path| path.followed_by(surface, &chord)));
        } else {
            let [before, behind] = halves(surface, piece, legs, &mut join)?;
            open.extend([behind, before]);
        }
    }
    let path = path.expect("the last piece is straight");
    debug_assert_eq!(points.last().map(|&(_, point)| point), Some(last));
    Ok(Bezier { path, points })
}

/// The paths from each place to the next.
fn legs(
    places: &[SurfacePoint],
    join: &mut impl FnMut(&SurfacePoint, &SurfacePoint) -> Result<Path>,
) -> Result<Vec<Path>> {
    places.windows(2).map(|ends| join(&ends[0], &ends[1])).collect()
}

/// The pieces before and behind the middle of one with these paths between its control places.
fn halves(
    surface: &Surface,
    piece: Piece,
    mut legs: Vec<Path>,
    join: &mut impl FnMut(&SurfacePoint, &SurfacePoint) -> Result<Path>,
) -> Result<[Piece; 2]> {
    let Piece { mut controls, begin, end } = piece;
    let (mut first, mut last) = (Vec::new(), Vec::new());
    loop {
        first.extend(controls.first().copied());
        last.extend(controls.last().copied());
        if legs.is_empty() {
            break;
        }
        controls = legs.iter().map(|leg| middle(surface, leg)).collect::<Result<_>>()?;
        legs = self::legs(&controls, join)?;
    }
    last.reverse();
    let between = 0.5 * (begin + end);
    Ok([Piece { controls: first, begin, end: between }, Piece { controls: last, begin: between, end }])
}

/// The point in the middle of a path.
fn middle(surface: &Surface, path: &Path) -> Result<SurfacePoint> {
    let mut left = 0.5 * path.length();
    for ends in path.points.windows(2) {
        let length = ends[0].position.distance(ends[1].position);
        if left <= length {
            let share = left / length;
            let [a, b] = [&ends[0], &ends[1]].map(|end| end.location.weights_in(surface, ends[0].face));
            let weights = std::array::from_fn(|k| (1.0 - share) * a[k] + share * b[k]);
            return Ok(surface.point(Place::Face { face: ends[0].face, weights })?);
        }
        left -= length;
    }
    Ok(surface.point(path.points[path.points.len() - 1].location)?)
}
