//! Surfaces of point clouds: triangles between points that have none, so that all that works on surfaces works on clouds.
//!
//! Each point is laid with its neighbours into the plane in which they spread most, where the triangles around it are those of a Delaunay
//! triangulation (Sharp and Crane, "A Laplacian for nonmanifold triangle meshes", 2020; there their union is the surface). A triangle that
//! all three of its points find is nearly always right. Here those come first, then those that two points find and those of one, wherever
//! they do not overlap what is there around any of their points, so that the surface is a manifold; small holes that remain are filled.
//!
//! ```
//! use heatwalk_cloud::Cloud;
//! use heatwalk::{Surface, VertexId, exact::exact_distance, go_on};
//!
//! let points = heatwalk_shapes::icosphere(4).positions;
//! let cloud = Cloud::join("ball", points, std::num::NonZeroUsize::MIN)?;
//! assert_eq!((cloud.report.unjoined_points, cloud.report.boundary_loops), (0, 0));
//! let surface = std::sync::Arc::new(Surface::build(&cloud.soup)?);
//! let distances = exact_distance(&surface, &[VertexId(0)], &mut go_on)?;
//! assert!((distances.iter().copied().fold(0.0, f64::max) - std::f64::consts::PI).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod circle;
mod error;
mod fans;
mod holes;
mod model;
mod neighbours;
mod outward;
mod plane;
mod sides;
mod star;
mod strays;
pub mod text;

use std::fmt;
use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_base::memory::has_room;
use heatwalk_base::parallel;
use heatwalk_base::sort;
use heatwalk_surface::Soup;
use heatwalk_surface::index::along_curve;

pub use error::{Error, Result};
pub use model::{join, read_within};

use crate::circle::circumradius;
use crate::fans::Fans;
use crate::neighbours::Neighbours;
use crate::outward::Outward;
use crate::plane::Plane;
use crate::sides::{orient, without_flaps};
use crate::star::Stars;

/// Bytes that joining takes at once, a point: positions twice, planes, and about six triangles, each found three times and then kept
/// with its corners.
const BYTES_PER_POINT: u64 = 640;

/// Points and the triangles between them.
#[derive(Debug, Clone)]
pub struct Cloud {
    /// All points in their order, and triangles that agree in orientation, as one part. Points of equal position are joined by triangles
    /// without area, so that welding makes them one.
    pub soup: Soup,
    /// What was made of how many.
    pub report: Report,
}

/// What a cloud was joined by. It is written as a sentence without an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Report {
    /// Points given.
    pub points: usize,
    /// Triangles with area.
    pub triangles: usize,
    /// Loops of edges that have one triangle only: holes, and where the surface ends.
    pub boundary_loops: usize,
    /// Points on no triangle, those that are not finite among them.
    pub unjoined_points: usize,
}

impl fmt::Display for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, triangles, boundary_loops, unjoined_points } = self;
        let s = |count: usize| if count == 1 { "" } else { "s" };
        write!(
            formatter,
            "{points} points without faces were joined by {triangles} triangle{}; {boundary_loops} boundary loop{}; {unjoined_points} point{} on no triangle",
            s(*triangles),
            s(*boundary_loops),
            s(*unjoined_points)
        )
    }
}

impl Cloud {
    /// Joins points, on so many threads, with the same result to the last bit however many. `name`: of the part.
    ///
    /// # Errors
    /// As [`Self::join_oriented`].
    ///
    /// # Panics
    /// As [`Self::join_oriented`].
    pub fn join(name: &str, points: Vec<DVec3>, threads: NonZeroUsize) -> Result<Self> {
        Self::join_oriented(name, points, &[], threads)
    }

    /// The same for points whose surface has these normals there (`#P × 3`, of any length, zero where none is known; or none at all): they tell
    /// apart the sides of what is as thin as points are apart, and which side is outside.
    ///
    /// # Errors
    /// [`Error::TooFew`] for less than three different finite points; [`Error::Line`] where all of them lie on a line;
    /// [`Error::OutOfMemory`].
    ///
    /// # Panics
    /// Where there are no threads, as on wasm32, and more than one is asked for; where there are other than no or `#P` normals.
    pub fn join_oriented(name: &str, points: Vec<DVec3>, normals: &[DVec3], threads: NonZeroUsize) -> Result<Self> {
        assert!(normals.is_empty() || normals.len() == points.len(), "one normal a point");
        if !has_room(&[BYTES_PER_POINT * points.len() as u64]) {
            return Err(Error::OutOfMemory { points: points.len() });
        }
        let (different, twins) = different(&points, threads);
        if different.len() < 3 {
            return Err(Error::TooFew { points: points.len(), different: different.len() });
        }
        let positions: Vec<DVec3> = different.iter().map(|&point| points[point as usize]).collect();
        let outward = Outward::new(&different, &twins, normals);
        let neighbours = Neighbours::new(&positions);
        let (planes, found) = stars(&positions, &outward, &neighbours, threads);
        if found.is_empty() {
            return Err(Error::Line { points: points.len() });
        }
        let mut fans = Fans::new(&positions, &planes);
        for triangle in ranked(&positions, found) {
            fans.take(triangle);
        }
        let mut fans = Fans::of(&positions, &planes, &without_flaps(&fans.triangles, positions.len()));
        let holes = orient(&mut fans.triangles, &positions, &planes, &outward);
        holes::fill(&mut fans, &positions, &planes, holes);
        let mut triangles = fans.triangles;
        let alone = unjoined(&triangles, positions.len());
        strays::attach(&mut triangles, &positions, &planes, &neighbours, &alone);
        let boundary_loops = orient(&mut triangles, &positions, &planes, &outward).len();
        let count = triangles.len();
        triangles.as_flattened_mut().iter_mut().for_each(|vertex| *vertex = different[*vertex as usize]);
        let alone = unjoined(&triangles, points.len());
        let twins = twins.into_iter().filter(|[first, _]| alone.binary_search(first).is_err());
        triangles.extend(twins.map(|[first, twin]| [first, twin, twin]));
        let report = Report {
            points: points.len(),
            triangles: count,
            boundary_loops,
            unjoined_points: alone.len() - (triangles.len() - count),
        };
        Ok(Self { soup: Soup::single(name, points, triangles), report })
    }
}

/// The first point of each position that is finite, in an order in which neighbours are near each other, whatever that of the file is, and pairs
/// of such a one and another there.
fn different(points: &[DVec3], threads: NonZeroUsize) -> (Vec<u32>, Vec<[u32; 2]>) {
    let mut order: Vec<u32> = (0..points.len() as u32).filter(|&point| points[point as usize].is_finite()).collect();
    // −0 and +0 are one place.
    let key = |point: u32| (points[point as usize] + DVec3::ZERO).to_array();
    sort::sort_by(&mut order, |&a, &b| {
        let [p, q] = [key(a), key(b)];
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(p[2].total_cmp(&q[2])).then(a.cmp(&b))
    });
    let (mut firsts, mut twins) = (Vec::with_capacity(order.len()), Vec::new());
    for equal in order.chunk_by(|&a, &b| key(a) == key(b)) {
        firsts.push(equal[0]);
        twins.extend(equal[1..].iter().map(|&twin| [equal[0], twin]));
    }
    let order = along_curve(firsts.len(), |index| points[firsts[index] as usize], threads);
    (order.into_iter().map(|index| firsts[index as usize]).collect(), twins)
}

/// The points on no triangle, ascending.
fn unjoined(triangles: &[[u32; 3]], points: usize) -> Vec<u32> {
    let mut is_joined = vec![false; points];
    triangles.as_flattened().iter().for_each(|&vertex| is_joined[vertex as usize] = true);
    (0..points as u32).filter(|&point| !is_joined[point as usize]).collect()
}

/// The planes of all points, and the triangles that they find around them, each as often as it is found, corners ascending.
fn stars(
    positions: &[DVec3],
    outward: &Outward,
    neighbours: &Neighbours,
    threads: NonZeroUsize,
) -> (Vec<Plane>, Vec<[u32; 3]>) {
    let found = parallel::map(parallel::ranges(positions.len(), threads), |range| {
        let mut stars = Stars::default();
        let (mut planes, mut triangles) = (Vec::with_capacity(range.len()), Vec::new());
        for point in range.map(|point| point as u32) {
            let (plane, around) =
                stars.around(neighbours, positions, outward, point).unwrap_or((Plane::NONE, Vec::new()));
            planes.push(plane);
            for [a, b] in around {
                let mut triangle = [point, a, b];
                triangle.sort_unstable();
                triangles.push(triangle);
            }
        }
        (planes, triangles)
    });
    let (planes, triangles): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    (planes.concat(), triangles.concat())
}

/// Each triangle once: first those that all three of their points find, which do not overlap, then those of two and of one, each by the circle
/// around it, the smallest first.
fn ranked(positions: &[DVec3], mut found: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    found.sort_unstable();
    let rank = |equal: &[[u32; 3]]| match equal.len() {
        3 => (0, 0, equal[0]),
        count => {
            let radius = circumradius(equal[0].map(|vertex| positions[vertex as usize]));
            // Bits of non-negative floats order as the floats do.
            (3 - count, radius.to_bits(), equal[0])
        }
    };
    let mut ranked: Vec<_> = found.chunk_by(|a, b| a == b).map(rank).collect();
    sort::sort(&mut ranked);
    ranked.into_iter().map(|(.., triangle)| triangle).collect()
}
