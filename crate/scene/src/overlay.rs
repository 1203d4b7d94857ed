//! Lines on the surface that show how it is meshed: its edges, its boundary, and the edges that the operators see.

use std::collections::{BTreeMap, HashMap};

use glam::DVec3;

use heatwalk::HeatSolver;
use heatwalk::Surface;
use heatwalk::exact::Wavefront;
use heatwalk::surface::triangle;
use heatwalk::{Source, SurfacePoint};

/// Two lengths are the same within this share: intrinsic lengths have been made longer by 10⁻⁵ of the mean edge at most.
const SAME_LENGTH: f64 = 1e-3;

/// Both ends of a straight piece of a line; in the file's unit.
pub type Segment = [DVec3; 2];

/// Each edge between two or more faces once.
pub fn inner_edges(surface: &Surface) -> Vec<Segment> {
    edges_where(surface, |halfedge| !surface.edges.is_single(halfedge))
}

/// Each edge with one face.
pub fn boundary_edges(surface: &Surface) -> Vec<Segment> {
    edges_where(surface, |halfedge| surface.edges.is_single(halfedge))
}

fn edges_where(surface: &Surface, is_wanted: impl Fn(u32) -> bool) -> Vec<Segment> {
    let wanted = surface.edges.lasts().filter(|&halfedge| is_wanted(halfedge));
    wanted.map(|halfedge| ends(surface, halfedge).map(|point| surface.position(point))).collect()
}

/// The ends of a half-edge's edge, the lower first, and its length.
fn edge(surface: &Surface, halfedge: u32) -> ([u32; 2], f64) {
    let [a, b] = ends(surface, halfedge);
    ([a.min(b), a.max(b)], triangle::length(surface.position(b) - surface.position(a)))
}

/// The points that half-edge `3 f + k` runs between.
fn ends(surface: &Surface, halfedge: u32) -> [u32; 2] {
    let (face, k) = (halfedge as usize / 3, halfedge as usize % 3);
    let points = surface.faces.as_slice()[face];
    [points[k], points[(k + 1) % 3]]
}

/// The edges of the triangles that carry the operators, drawn on the surface: edges of the mesh are one segment, others
/// cross faces. An edge that is not the shortest path between its ends is left out.
pub fn operator_edges(solver: &HeatSolver) -> Vec<Segment> {
    let surface = solver.surface();
    let mut segments = Vec::new();
    // Ends and length of those that are no edges of the mesh, by their lower end.
    let mut crossing: BTreeMap<u32, Vec<(u32, f64)>> = BTreeMap::new();
    let mesh: HashMap<[u32; 2], f64> = surface.edges.lasts().map(|halfedge| edge(surface, halfedge)).collect();
    for ([low, high], length) in solver.operator_edges(SAME_LENGTH) {
        match mesh.get(&[low, high]) {
            Some(&known) if is_same(known, length) => {
                segments.push([low, high].map(|point| surface.position(point)));
            }
            _ => crossing.entry(low).or_default().push((high, length)),
        }
    }
    let mut front: Option<Wavefront> = None;
    for (low, others) in crossing {
        let source = [Source::from(SurfacePoint::Vertex(low))];
        match &mut front {
            Some(front) => front.restart(&source),
            None => front = Some(solver.wavefront(&source)),
        }
        let Some(front) = &mut front else { continue };
        for (high, length) in others {
            front.advance(length * (1.0 + SAME_LENGTH), usize::MAX);
            if !is_same(front.values()[high as usize], length) {
                continue;
            }
            if let Ok(path) = front.path_from_point(high) {
                let positions: Vec<DVec3> = path.points.iter().map(|point| point.position).collect();
                segments.extend(positions.array_windows().copied());
            }
        }
    }
    segments
}

fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_LENGTH * a.max(b)
}
