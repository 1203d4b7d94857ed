//! Straightening to a locally shortest path, after Sharp and Crane, "You Can Find Geodesic Paths in Triangle Meshes by
//! Just Flipping Edges" (2020).
//!
//! As there, the vertex where the path turns most sharply goes first: the path is led through the faces on the side
//! where it turns by less than π, and shortened there, until no vertex is left to do that at. There, that means to
//! flip edges of an intrinsic triangulation; here, it means to take the shortest path in the unfolded strip of faces
//! between the vertices before and after, which is the same path and needs neither a manifold nor an orientation.
//!
//! That goes in rounds, in each of which no segment changes twice: so segments that grow together double, where one that grew
//! vertex by vertex would be unfolded as often as it has faces. One that grows alone, along a line of vertices that the path
//! runs straight through, doubles by being led around more and more of these at once.

use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Path, PathPoint};

use super::chain::{Chain, begun_at};
use crate::error::{Error, Result};

/// Faces unfolded per point of the path given and face of the surface, at most. Each vertex that is led around shortens the
/// path, so that this bounds time and makes no path longer than it was.
const LONGEST_WORK: usize = 1000;

/// Shortens a path of this surface to a locally shortest one with the same ends, never longer than it was.
///
/// Where it crosses portals, it still does. Every segment of the result is straight once the faces that it goes through are unfolded, and at every vertex between
/// its ends all turns around it within the surface are π at least.
///
/// # Errors
/// [`Error::Surface`] with `ForeignSurface` for a path on another surface.
pub fn straighten(surface: &Surface, path: &Path) -> Result<Path> {
    surface.require_own(path.surface(), "path")?;
    let pieces = path.points.chunk_by(|a, b| b.location.lies_on(surface, a.face));
    let straight = pieces.map(|piece| straightened(surface, &Path::new(surface, piece.to_vec())).points);
    Ok(Path::new(surface, straight.flatten().collect()))
}

/// The same for a path on one component.
fn straightened(surface: &Surface, path: &Path) -> Path {
    let Some(mut chain) = Chain::open(surface, path) else { return path.clone() };
    chain.shorten(most_work(surface, path));
    let straight = Path::new(surface, chain.points());
    // Where it was straight already, rounding may make it longer.
    if straight.length() <= path.length() { straight } else { path.clone() }
}

/// Tightens a closed curve, a path that ends where it begins, to a closed geodesic that it can be deformed into, never longer than it
/// was: straight segments and turns of π at least at every vertex, also where it begins, which may be anywhere on it.
///
/// One that crosses portals stays where it does so, and is straight between.
///
/// # Errors
/// [`Error::Contractible`] for a curve that shrinks to a point; [`Error::BadParameter`] for one that is not closed;
/// [`Error::Surface`] with `ForeignSurface` for one on another surface.
pub fn closed_geodesic(surface: &Surface, path: &Path) -> Result<Path> {
    surface.require_own(path.surface(), "path")?;
    if !path.is_closed(surface) {
        let range = "closed: each path begins where the one before ends";
        return Err(Error::BadParameter { name: "curve", value: "open".to_owned(), range });
    }
    let hop = |pair: &[PathPoint]| !pair[1].location.lies_on(surface, pair[0].face);
    if let Some(hop) = path.points.windows(2).position(hop) {
        let around = &path.points[..path.points.len() - 1];
        return straighten(surface, &Path::new(surface, begun_at(around, (hop + 1) % around.len())));
    }
    let mut chain = Chain::closed(surface, path).ok_or(Error::Contractible)?;
    chain.shorten(most_work(surface, path));
    if chain.is_point() {
        return Err(Error::Contractible);
    }
    let tight = Path::new(surface, chain.points());
    Ok(if tight.length() <= path.length() { tight } else { path.clone() })
}

fn most_work(surface: &Surface, path: &Path) -> usize {
    LONGEST_WORK * (path.points.len() + surface.face_count())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use glam::{DVec2, DVec3};
    use heatwalk_surface::{Soup, VertexId};

    use super::*;

    /// A surface, vertices of a path along its edges, and the length of the shortest one.
    type Case = (Soup, Vec<u32>, f64);

    /// A square cut across into slivers, and a zigzag over all of them.
    fn ladder(count: u32) -> Case {
        let at = |index: u32| DVec3::new(f64::from(index / 2) / f64::from(count / 2), f64::from(index % 2), 0.0);
        let triangles = (0..count).map(|index| [index, index + 1, index + 2]);
        (Soup::single("ladder", (0..count + 2).map(at).collect(), triangles.collect()), (0..count + 1).collect(), 1.0)
    }

    /// A triangle cut from one corner into needles, and a path around it.
    fn needles(count: u32) -> Case {
        let side = (0..=count).map(|index| DVec3::new(1.0, f64::from(index) / f64::from(count), 0.0));
        let triangles = (1..=count).map(|index| [0, index, index + 1]);
        let positions = [DVec3::ZERO].into_iter().chain(side).collect();
        (Soup::single("needles", positions, triangles.collect()), (0..count + 2).collect(), 2_f64.sqrt())
    }

    /// The same triangle, and a path from the end of each needle to the next by way of their common corner.
    fn spokes(count: u32) -> Case {
        let (soup, ..) = needles(count);
        let path = (1..count + 2).flat_map(|index| [index, 0]).take(2 * count as usize + 1);
        (soup, path.collect(), 1.0)
    }

    /// The same with needles of the other kind beyond their side, so that paths may go on either side of it.
    fn kite(count: u32) -> Case {
        let (mut soup, path, length) = needles(count);
        let last = soup.positions.len() as u32;
        soup.positions.push(DVec3::new(2.0, 1.0, 0.0));
        soup.triangles.extend((1..=count).map(|index| [last, index + 1, index]));
        (soup, path, length)
    }

    /// Triangles around a vertex, and a path along a third of their rim.
    fn hub(count: u32) -> Case {
        let rim =
            (0..count).map(|index| DVec3::from((DVec2::from_angle(TAU * f64::from(index) / f64::from(count)), 0.0)));
        let triangles = (0..count).map(|index| [0, 1 + index, 1 + (index + 1) % count]);
        let positions = [DVec3::ZERO].into_iter().chain(rim).collect();
        (Soup::single("hub", positions, triangles.collect()), (1..count / 3 + 2).collect(), 3_f64.sqrt())
    }

    #[test]
    fn on_slivers_the_faces_unfolded_grow_hardly_faster_than_their_number() {
        for make in [ladder, needles, spokes, kite, hub] {
            let work = [300, 1200, 4800].map(|count| {
                let (soup, through, length) = make(count);
                let name = soup.parts[0].name.clone();
                let surface = Surface::build(&soup).expect("a surface");
                let through: Vec<VertexId> = through.into_iter().map(VertexId).collect();
                let path = Path::along_edges(&surface, &through).expect("edges");
                let mut chain = Chain::open(&surface, &path).expect("a path with points");
                chain.shorten(usize::MAX);
                let straight = Path::new(&surface, chain.points()).length();
                // Rounding of a chain of thousands of unfoldings.
                assert!((straight - length).abs() < 1e-9, "{name}: {straight} for {length}");
                chain.work as f64
            });
            for pair in work.windows(2) {
                assert!(pair[1] < pair[0] * 4_f64.powf(1.3), "{work:?}");
            }
        }
    }
}
