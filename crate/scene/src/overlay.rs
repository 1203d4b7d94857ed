//! Lines on the surface that show how it is meshed: its edges, its boundary, the edges that the operators see, and the portals
//! between its components.

use std::collections::{BTreeMap, HashMap};

use glam::DVec3;

use heatwalk::HeatSolver;
use heatwalk::Surface;
use heatwalk::exact::Wavefront;
use heatwalk::surface::triangle;
use heatwalk::{Bridges, HalfedgeId, Portal, Result, VertexId};

/// Two lengths are the same within this share: intrinsic lengths have been made longer by 10⁻⁵ of the mean edge at most.
const SAME_LENGTH: f64 = 1e-3;

/// Length of each line of the cross that marks an end of a portal, in bounding radii of the surface.
const MARK: f64 = 0.012;

/// Gaps that are shorter than this share of such a line are not seen.
const SEEN: f64 = 0.01;

/// Both ends of a straight segment of a line; in the file's unit.
pub type Segment = [DVec3; 2];

/// Each edge between two or more faces once, but not those that cut polygons of the file.
pub fn inner_edges(surface: &Surface) -> Vec<Segment> {
    edges_where(surface, |halfedge| !surface.edges().is_single(halfedge) && !surface.is_within_polygon(halfedge))
}

/// Each edge with one face.
pub fn boundary_edges(surface: &Surface) -> Vec<Segment> {
    edges_where(surface, |halfedge| surface.edges().is_single(halfedge))
}

fn edges_where(surface: &Surface, is_wanted: impl Fn(HalfedgeId) -> bool) -> Vec<Segment> {
    let wanted = surface.edges().representatives().filter(|&halfedge| is_wanted(halfedge));
    wanted.map(|halfedge| surface.ends(halfedge).map(|vertex| surface.position(vertex))).collect()
}

/// The ends of a half-edge's edge, the lower first, and its length.
fn edge(surface: &Surface, halfedge: HalfedgeId) -> ([VertexId; 2], f64) {
    let [a, b] = surface.ends(halfedge);
    ([a.min(b), a.max(b)], triangle::length(surface.position(b) - surface.position(a)))
}

/// The edges of the triangles that carry the operators, drawn on the surface: edges of the mesh are one segment, others
/// cross faces. An edge that is not the shortest path between its ends is left out. They are drawn on `shown`, which is the
/// solver's surface in whatever pose.
///
/// # Errors
/// [`heatwalk::Error::Surface`] with `ForeignSurface` where `shown` is another surface.
pub fn operator_edges(solver: &HeatSolver, shown: &Surface) -> Result<Vec<Segment>> {
    let surface = solver.surface();
    let mut segments = Vec::new();
    // Ends and length of those that are no edges of the mesh, by their lower end.
    let mut crossing: BTreeMap<VertexId, Vec<(VertexId, f64)>> = BTreeMap::new();
    let mesh: HashMap<[VertexId; 2], f64> =
        surface.edges().representatives().map(|halfedge| edge(surface, halfedge)).collect();
    for ([low, high], length) in solver.operator_edges(SAME_LENGTH) {
        match mesh.get(&[low, high]) {
            Some(&known) if is_same(known, length) => {
                segments.push([low, high].map(|vertex| shown.position(vertex)));
            }
            _ => crossing.entry(low).or_default().push((high, length)),
        }
    }
    let mut front: Option<Wavefront> = None;
    for (low, others) in crossing {
        match &mut front {
            Some(front) => front.restart(&[low])?,
            None => front = Some(solver.wavefront(&[low])?),
        }
        let Some(front) = &mut front else { continue };
        for (high, length) in others {
            front.advance(length * (1.0 + SAME_LENGTH), usize::MAX)?;
            if !is_same(front.values()[high], length) {
                continue;
            }
            if let Ok(path) = front.path_from_vertex(high) {
                let path = path.carried(surface, shown)?;
                let positions: Vec<DVec3> = path.points.iter().map(|point| point.position).collect();
                segments.extend(positions.array_windows().copied());
            }
        }
    }
    Ok(segments)
}

/// The portals: a cross on the surface at each end, and a segment from one end to the other where they are apart.
pub fn contact_lines(surface: &Surface, bridges: &Bridges) -> Vec<Segment> {
    let arm = 0.5 * MARK * surface.bounding_radius();
    let mut segments = Vec::new();
    for Portal { ends, .. } in bridges.portals() {
        let middles = ends.map(|end| end.position(surface));
        if triangle::length(middles[1] - middles[0]) > SEEN * arm {
            segments.push(middles);
        }
        for (end, middle) in ends.iter().zip(middles) {
            let Some(&face) = end.faces(surface).first() else { continue };
            let [a, b, c] = surface.corners(face);
            let along = triangle::unit(b - a);
            let across = triangle::unit(triangle::area_vector([a, b, c])).cross(along);
            segments.extend([along, across].map(|direction| [middle - arm * direction, middle + arm * direction]));
        }
    }
    segments
}

fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_LENGTH * a.max(b)
}
