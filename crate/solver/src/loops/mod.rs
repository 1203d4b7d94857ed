//! Closed curves: through places, and around handles. Those that no deformation takes into each other are told apart by a tree of paths and
//! the graph that is left of the faces beyond it (Erickson and Whittlesey, "Greedy optimal homotopy and homology generators", 2005).

mod cut_graph;
mod homology;

use std::sync::Arc;

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{CutVertex, HalfedgeId, Path, PathPoint, Place, SurfacePoint, ToPoint, VertexId};

use self::cut_graph::{Caps, Tree, least_loops};
use self::homology::{Class, Cocycles, independent};
use crate::directions::searched;
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, shortest_path};
use crate::path::{closed_geodesic, straighten};

/// Loops around handles from which shorter ones are looked for once more, the longest first.
const MOST_ROOTS: usize = 8;

/// A closed curve through places, in their order, of shortest paths from each to the next and back to the first. It begins and ends at the
/// first place. Places that are where the one before is count once.
///
/// Through one place it is the shortest loop found that does not shrink to a point when it is let go, and through two a shortest path and
/// the shortest way back found with which it forms such a loop: on each of all classes of loops that the tree of shortest paths
/// from the first place tells apart, straightened.
///
/// # Errors
/// [`Error::NoSource`] without a place; [`Error::Contractible`] for one or two places where all loops shrink to points;
/// [`Error::Unreachable`] for places that no path joins; those of [`ToPoint::to_point`]; [`Error::NotExact`] where faces have different
/// costs; [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn geodesic_loop<P: ToPoint>(geometry: &Arc<ExactGeometry>, places: &[P], progress: Progress<'_>) -> Result<Path> {
    let surface = geometry.surface();
    let mut points: Vec<SurfacePoint> = Vec::new();
    for place in places {
        let point = place.to_point(surface)?;
        if points.last().is_none_or(|last| !is_one(surface, last, &point)) {
            points.push(point);
        }
    }
    while points.len() > 1 && is_one(surface, &points[0], &points[points.len() - 1]) {
        points.pop();
    }
    match points[..] {
        [] => Err(Error::NoSource),
        [place] => {
            let loops = loops_at(geometry, place, progress)?;
            let straight = loops.iter().map(|path| straighten(surface, path)).collect::<Result<Vec<_>>>()?;
            shortest(straight).ok_or(Error::Contractible)
        }
        [first, second] => {
            let there = shortest_path(geometry, first, &[second])?;
            let back = there.reversed(surface);
            let mut ways = Vec::new();
            for path in loops_at(geometry, first, progress)? {
                for around in [path.reversed(surface), path] {
                    ways.push(straighten(surface, &back.followed_by(surface, &around))?);
                }
            }
            let way = shortest(ways).ok_or(Error::Contractible)?;
            Ok(there.followed_by(surface, &way))
        }
        _ => {
            let mut path = shortest_path(geometry, points[0], &[points[1]])?;
            for (index, from) in points.iter().enumerate().skip(1) {
                report(progress, Stage::Searching { radius: 0.0 }, index as f64 / points.len() as f64)?;
                let leg = shortest_path(geometry, *from, &[points[(index + 1) % points.len()]])?;
                path = path.followed_by(surface, &leg);
            }
            Ok(path)
        }
    }
}

/// Closed geodesics around the handles and through them, two a handle, the shortest first; none on a surface without handles.
///
/// They are independent: no set of them bounds a part of the surface, its boundary loops aside. Among the loops found they are the
/// shortest ones of that kind; others may be shorter. Where triangles are no oriented manifold they do not cross its
/// [cuts](Surface::mesh).
///
/// # Errors
/// [`Error::Cancelled`].
pub fn handle_loops(surface: &Surface, progress: Progress<'_>) -> Result<Vec<Path>> {
    let mesh = surface.mesh();
    let tree = Tree::new(surface, mesh.vertices(), None);
    let cocycles = Cocycles::new(mesh, &tree);
    if cocycles.count() == 0 {
        return Ok(Vec::new());
    }
    let mut search = |tree: &Tree| {
        let mut found = Vec::new();
        for halfedge in least_loops(surface, tree, Caps::Filled) {
            report(progress, Stage::Searching { radius: 0.0 }, 0.0)?;
            let around = tree.around(mesh, halfedge);
            let class = cocycles.class(mesh, &around);
            if class.iter().any(|&word| word != 0) {
                found.push((closed_geodesic(surface, &along(surface, &around)?)?, class));
            }
        }
        Ok::<_, Error>(found)
    };
    let mut found = independent(search(&tree)?);
    let on_loop = |(path, _): &(Path, Class)| CutVertex(path.points[0].location.nearest_vertex(surface).0);
    let roots: Vec<CutVertex> = found.iter().rev().take(MOST_ROOTS).map(on_loop).collect();
    for root in roots {
        found.extend(search(&Tree::new(surface, [root].into_iter(), None))?);
    }
    Ok(independent(found).into_iter().map(|(path, _)| path).collect())
}

/// One loop at a place of each class that the tree of shortest paths from there tells apart, along edges.
fn loops_at(geometry: &Arc<ExactGeometry>, at: SurfacePoint, progress: Progress<'_>) -> Result<Vec<Path>> {
    let surface = geometry.surface();
    let front = searched(geometry, &[at], progress)?;
    let root = at.place().nearest_vertex(surface);
    let tree = Tree::new(surface, [CutVertex(root.0)].into_iter(), Some(front.values()));
    let face = at.place().faces(surface)[0];
    let point = |location: Place| PathPoint { position: location.position(surface), location, face };
    let to_root = Path::new(surface, vec![point(at.place()), point(Place::Vertex(root))]);
    let from_root = to_root.reversed(surface);
    let loops = least_loops(surface, &tree, Caps::Open).into_iter().map(|halfedge| {
        let around = along(surface, &tree.around(surface.mesh(), halfedge))?;
        Ok(to_root.followed_by(surface, &around).followed_by(surface, &from_root))
    });
    loops.collect()
}

/// The closed path along half-edges of the mesh that follow each other.
fn along(surface: &Surface, around: &[HalfedgeId]) -> Result<Path> {
    let mesh = surface.mesh();
    let begin = around.first().map(|&first| mesh.vertex(first));
    let through = begin.into_iter().chain(around.iter().map(|&halfedge| mesh.tip(halfedge)));
    let vertices: Vec<VertexId> = through.map(|vertex| surface.vertex_of_cut(vertex)).collect();
    Ok(Path::along_edges(surface, &vertices)?)
}

fn shortest(paths: Vec<Path>) -> Option<Path> {
    paths.into_iter().min_by(|a, b| a.length().total_cmp(&b.length()))
}

fn is_one(surface: &Surface, a: &SurfacePoint, b: &SurfacePoint) -> bool {
    let [a, b] = [a, b].map(|point| point.place().reduced(surface));
    a.component(surface) == b.component(surface) && a.is_at(surface, b)
}
