//! What was made on one surface is refused by another, be it of the same shape.

use crate::common;

use std::sync::Arc;

use glam::DVec3;
use heatwalk::exact::{ExactGeometry, Wavefront, exact_distance, shortest_path};
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    Error, HeatSolver, Parameters, Path, Place, Surface, SurfacePoint, VertexId, descend, go_on, straighten,
    straightest,
};
use heatwalk_scene::Crowd;
use heatwalk_shapes as shapes;

fn sphere() -> Arc<Surface> {
    Arc::new(common::surface(&shapes::icosphere(2)))
}

fn solver(surface: &Arc<Surface>) -> HeatSolver {
    HeatSolver::new(Arc::clone(surface), Parameters::default(), &mut go_on).unwrap()
}

/// The thing that is refused for belonging elsewhere.
fn refused<T>(answer: Result<T, impl Into<Error>>) -> Option<&'static str> {
    match answer.map_err(Into::into) {
        Err(Error::Surface(SurfaceError::ForeignSurface { thing })) => Some(thing),
        _ => None,
    }
}

struct Two {
    own: Arc<Surface>,
    /// Of the surface that is not `own`.
    point: SurfacePoint,
    other: Arc<Surface>,
}

fn two() -> Two {
    let (own, other) = (sphere(), sphere());
    Two { point: other.point(VertexId(7)).unwrap(), own, other }
}

#[test]
fn ids_tell_surfaces_apart() {
    let Two { own, other, .. } = two();
    assert_ne!(own.id(), other.id());
    assert_eq!(own.id(), Surface::clone(&own).id(), "a clone is the same surface");
    assert_ne!(own.id(), own.with_positions(own.positions().clone()).id(), "moved, it is another");
}

#[test]
fn points_and_sources() {
    let Two { own, point, other } = two();
    assert_eq!(refused(own.point(point)), Some("point"));
    assert_eq!(refused(own.source(point, 0.5)), Some("point"));
    assert_eq!(other.point(point), Ok(point));
    let source = other.source(point, 0.5).unwrap();
    let solver = solver(&own);
    assert_eq!(refused(solver.distance(&[source])), Some("source"));
    assert_eq!(refused(solver.distance(&[point])), Some("point"));
    assert_eq!(refused(solver.distance(&[(point, 1.0)])), Some("point"));
    assert_eq!(refused(solver.refine(&[source])), Some("source"));
    assert_eq!(refused(solver.wavefront(&[source])), Some("source"));
    assert_eq!(refused(exact_distance(&own, &[source], &mut go_on)), Some("source"));
    assert_eq!(refused(straightest(&own, point, None, DVec3::X, 1.0)), Some("point"));
}

#[test]
fn wavefronts() {
    let Two { own, point, other } = two();
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&own)));
    let here = VertexId(0);
    assert_eq!(refused(Wavefront::new(Arc::clone(&geometry), &[point])), Some("point"));
    assert_eq!(refused(Wavefront::with_targets(Arc::clone(&geometry), &[here], &[point])), Some("point"));
    assert_eq!(refused(shortest_path(&geometry, point, &[here])), Some("point"));
    assert_eq!(refused(shortest_path(&geometry, here, &[point])), Some("point"));
    let mut front = Wavefront::new(geometry, &[here]).unwrap();
    assert_eq!(refused(front.restart(&[other.source(point, 0.0).unwrap()])), Some("source"));
    front.advance(f64::INFINITY, usize::MAX).expect("room for windows");
    assert_eq!(front.values()[here], 0.0, "after the refusal it goes on as before");
    let absent = front.path_from_vertex(VertexId(9999));
    assert!(matches!(absent, Err(Error::Surface(SurfaceError::NoSuchVertex { vertex: 9999, .. }))));
}

#[test]
fn distances() {
    let Two { own, other, point } = two();
    let distance = solver(&other).distance(&[point]).unwrap();
    assert_eq!(refused(descend(&own, &distance, VertexId(0))), Some("distance"));
    assert_eq!(refused(descend(&other, &distance, own.point(VertexId(0)).unwrap())), Some("point"));
    assert_eq!(refused(distance.at(&own, VertexId(0))), Some("distance"));
    assert_eq!(refused(distance.at(&other, own.point(VertexId(0)).unwrap())), Some("point"));
    assert_eq!(refused(distance.gradients(&own)), Some("distance"));
    assert_eq!(refused(distance.heat_directions(&own)), Some("distance"));
    assert_eq!(refused(distance.directions(&own)), Some("distance"));
    assert_eq!(refused(distance.tangents(&own)), Some("distance"));
    let mut crowd = Crowd::new(Arc::clone(&own), 3, 0.1, 1).unwrap();
    assert_eq!(refused(crowd.follow(&distance)), Some("distance"));
}

#[test]
fn refinements_and_paths() {
    let Two { own, other, point } = two();
    let (here, there) = (solver(&own), solver(&other));
    let mut refinement = there.refine(&[point]).unwrap();
    assert_eq!(refused(refinement.step(here.factorization(), 10)), Some("refinement"));
    assert!(refinement.step(there.factorization(), 10).is_ok());
    let path = Path::along_edges(&other, &heatwalk::edge_path(&other, VertexId(0), VertexId(9)).unwrap()).unwrap();
    assert_eq!(refused(straighten(&own, &path)), Some("path"));
    assert!(straighten(&other, &path).is_ok());
}

#[test]
fn places_are_checked_where_they_are_used() {
    let solver = solver(&sphere());
    let absent = Place::Vertex(VertexId(9999));
    assert!(matches!(solver.distance(&[absent]), Err(Error::Surface(SurfaceError::NoSuchVertex { vertex: 9999, .. }))));
}
