//! What is done with surfaces.

use std::sync::Arc;

use anyhow::{Context, Result};
use glam::DVec3;
use heatwalk::{
    BridgeRule, Bridges, Distance, DistanceOptions, DistanceSolver, Element, FaceId, Method, Path, Place, Soup,
    Surface, VertexId, Walls, WeldRule, descend, edge_polyline, go_on, straighten, straightest,
};
use heatwalk_base::parallel::ONE;
use heatwalk_curves::{Field, Isolines, Levels, Sheet, Strips, write};
use heatwalk_volume::fill::{Resolution, Solid};

use crate::{Operation, does};

/// Isolines of a field.
const LEVELS: usize = 5;

/// Makes what an operation works on.
pub type Prepare = fn(&Soup) -> Result<Operation>;

pub const OPERATIONS: [(&str, Prepare); 21] = [
    ("read", |soup| {
        let mut text = String::new();
        soup.positions.iter().for_each(|point| text += &format!("v {} {} {}\n", point.x, point.y, point.z));
        let corners = soup.triangles.iter().map(|corners| corners.map(|corner| corner + 1));
        corners.for_each(|[a, b, c]| text += &format!("f {a} {b} {c}\n"));
        does(move || heatwalk_model::io::read("a.obj", text.as_bytes(), &|_| None))
    }),
    ("build", |soup| {
        let soup = soup.clone();
        does(move || Surface::build_by(&soup, WeldRule::Exact, ONE))
    }),
    ("contacts", |soup| {
        let surface = surface(soup)?;
        does(move || anyhow::Ok(Bridges::find(&surface, BridgeRule::Automatic)))
    }),
    ("links", |soup| {
        let surface = surface(soup)?;
        does(move || anyhow::Ok(Bridges::find(&surface, BridgeRule::Off).links(&surface)))
    }),
    ("heat", |soup| {
        let mut solver = DistanceSolver::new(surface(soup)?);
        let source = Place::Vertex(VertexId(1));
        does(move || solver.distance(&[source], &DistanceOptions::by(Method::Heat), &mut go_on))
    }),
    ("walls of triangles", |soup| {
        let surface = surface(soup)?;
        let faces = (0..surface.face_count()).step_by(2).map(FaceId::from_index).collect();
        does(move || surface.walled(&Walls { faces, edges: Vec::new() }))
    }),
    ("walls of edges", |soup| {
        let surface = surface(soup)?;
        let edges = (0..surface.face_count()).step_by(2).map(|face| FaceId::from_index(face).halfedge(0)).collect();
        does(move || surface.walled(&Walls { faces: Vec::new(), edges }))
    }),
    ("sources at vertices", |soup| {
        let surface = surface(soup)?;
        let sources: Vec<Place> = surface.vertices().map(Place::Vertex).collect();
        propagates(surface, sources)
    }),
    ("sources on edges", |soup| {
        let surface = surface(soup)?;
        let faces = (0..surface.face_count()).map(FaceId::from_index);
        let on_edge = |face: FaceId| Place::Edge { halfedge: face.halfedge(0), fraction: 0.5 };
        let sources = faces.map(on_edge).collect();
        propagates(surface, sources)
    }),
    ("sources along an edge", |soup| {
        let surface = surface(soup)?;
        let count = surface.face_count();
        let halfedge = FaceId(0).halfedge(0);
        let sources = (0..count).map(|k| Place::Edge { halfedge, fraction: (k as f64 + 0.5) / count as f64 });
        let sources = sources.collect();
        propagates(surface, sources)
    }),
    ("sources at one vertex", |soup| {
        let surface = surface(soup)?;
        let sources = vec![Place::Vertex(VertexId(0)); surface.face_count()];
        propagates(surface, sources)
    }),
    ("sources along a line", |soup| {
        let surface = surface(soup)?;
        let mut through = walk(&surface);
        through.dedup();
        does(move || edge_polyline(&surface, &through, false))
    }),
    ("descent", |soup| {
        let (surface, distance, from) = field(soup)?;
        does(move || descend(&surface, &distance, from))
    }),
    ("straightened descent", |soup| {
        let (surface, distance, from) = field(soup)?;
        let path = descend(&surface, &distance, from)?;
        does(move || straighten(&surface, &path))
    }),
    ("straightened walk", |soup| {
        let surface = surface(soup)?;
        let path = Path::along_edges(&surface, &walk(&surface))?;
        does(move || straighten(&surface, &path))
    }),
    ("straightest", |soup| {
        let surface = surface(soup)?;
        let from = Place::Face { face: FaceId(0), weights: [0.3, 0.3, 0.4] };
        let length = 3.0 * surface.bounding_radius();
        let direction =
            surface.position(surface.faces()[FaceId(0)][1]) - surface.position(surface.faces()[FaceId(0)][2]);
        does(move || straightest(&surface, from, None, direction, length))
    }),
    ("isolines", |soup| {
        let (field, levels) = curves(soup)?;
        does(move || anyhow::Ok(Isolines::trace(&field, &levels)))
    }),
    ("svg", |soup| {
        let (field, levels) = curves(soup)?;
        let isolines = Isolines::trace(&field, &levels);
        let view = write::View::from_direction(&field, DVec3::new(1.0, 2.0, 3.0), DVec3::Y).context("a view")?;
        does(move || anyhow::Ok(write::svg(&isolines, &field, &view, None)))
    }),
    ("other files", |soup| {
        let (field, levels) = curves(soup)?;
        let isolines = Isolines::trace(&field, &levels);
        does(move || {
            let files = [write::obj, write::dxf, write::csv].map(|file| file(&isolines, None));
            anyhow::Ok((files, write::glb(&isolines), write::strips_obj(&Strips::cut(&field, &levels)?, None)))
        })
    }),
    ("unrolled", |soup| {
        let (field, levels) = curves(soup)?;
        does(move || {
            let strips = Strips::cut(&field, &levels)?;
            // Those of curved surfaces are refused.
            anyhow::Ok(Sheet::unroll(&field, &strips).ok().map(|sheet| write::sheet_dxf(&sheet, &strips, None)))
        })
    }),
    ("fill", |soup| {
        let (soup, surface) = (soup.clone(), surface(soup)?);
        // What is open is refused.
        does(move || {
            let solid = Solid::new(&soup, &surface, ONE).ok();
            anyhow::Ok(solid.map(|solid| solid.fill(Resolution::Tetrahedra(soup.triangles.len()), &mut go_on)))
        })
    }),
];

fn surface(soup: &Soup) -> Result<Arc<Surface>> {
    Ok(Arc::new(Surface::build_by(soup, WeldRule::Exact, ONE)?))
}

/// Distances from many sources.
fn propagates(surface: Arc<Surface>, sources: Vec<Place>) -> Result<Operation> {
    let mut solver = DistanceSolver::new(surface);
    solver.exact_geometry();
    does(move || solver.distance(&sources, &DistanceOptions::by(Method::Propagation), &mut go_on))
}

/// The distance to a place of the last triangle, and the vertex farthest from there.
fn field(soup: &Soup) -> Result<(Arc<Surface>, Distance, VertexId)> {
    let surface = surface(soup)?;
    let source = Place::Face { face: FaceId::from_index(surface.face_count() / 3), weights: [0.3, 0.3, 0.4] };
    let mut solver = DistanceSolver::new(Arc::clone(&surface));
    let options = DistanceOptions::by(Method::Propagation);
    let distance = solver.distance(&[source], &options, &mut go_on)?.distance;
    let reached = surface.vertices().filter(|&vertex| distance.values[vertex] < f64::INFINITY);
    let from = reached.max_by(|&a, &b| distance.values[a].total_cmp(&distance.values[b]));
    Ok((surface, distance, from.context("a vertex")?))
}

fn curves(soup: &Soup) -> Result<(Field, Levels)> {
    let (surface, distance, _) = field(soup)?;
    let triangles = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
    let field = Field::new(surface.positions().clone().into_vec(), triangles, distance.values.into_vec())?;
    let levels = Levels::counted(LEVELS, field.largest())?;
    Ok((field, levels))
}

/// Half of the vertices in their order, joined by edges where there are any, else by way of others.
fn walk(surface: &Surface) -> Vec<VertexId> {
    let mut walk: Vec<VertexId> = Vec::new();
    for face in (0..surface.face_count() / 2).map(FaceId::from_index) {
        let corners = surface.faces()[face];
        for vertex in corners {
            if walk.last().is_none_or(|&last| last != vertex && (corners.contains(&last))) {
                walk.push(vertex);
            }
        }
    }
    walk
}
