//! Searches from sources, and where these are.

use std::sync::Arc;

use super::truth::Random;
use super::{any_triangles, band, book, square};
use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Element, FaceId, Place, Propagation, Soup, Surface, VertexId};
use heatwalk_shapes as shapes;

pub fn geometry(surface: &Arc<Surface>) -> Arc<ExactGeometry> {
    Arc::new(ExactGeometry::new(Arc::clone(surface)))
}

pub fn exact(geometry: &Arc<ExactGeometry>, sources: &[(Place, f64)]) -> Wavefront {
    let mut front = Wavefront::new(Arc::clone(geometry), sources).expect("valid sources");
    front.advance(f64::INFINITY, usize::MAX).expect("room for windows");
    front
}

pub fn at(vertex: u32) -> [(Place, f64); 1] {
    [(Place::Vertex(VertexId(vertex)), 0.0)]
}

/// Sources at a vertex, inside a face and, later than these, at another vertex.
pub fn mixed_sources(surface: &Surface, random: &mut Random) -> [(Place, f64); 3] {
    let vertex = |random: &mut Random| Place::Vertex(VertexId::from_index(random.below(surface.vertex_count())));
    let face = FaceId::from_index(random.below(surface.face_count()));
    let inside = Place::Face { face, weights: [0.2, 0.5, 0.3] };
    [(vertex(random), 0.0), (inside, 0.0), (vertex(random), 0.7 * surface.mean_edge())]
}

fn shapes_of_all_kinds() -> Vec<Soup> {
    let mut random = Random::new(17);
    let mut crumpled = square(14);
    for position in &mut crumpled.positions {
        position.x *= 1e-3;
        position.z = 1e-3 * random.share();
    }
    vec![
        shapes::icosphere(4),
        shapes::torus(2.0, 0.7, 60, 30),
        shapes::high_genus(0.12),
        shapes::maze(6, 2),
        band(60, 1),
        book(3, 14),
        any_triangles(80, &mut random),
        crumpled,
    ]
}

/// A question on a surface, and its exact answer.
pub struct Case {
    pub surface: Arc<Surface>,
    pub geometry: Arc<ExactGeometry>,
    pub sources: [(Place, f64); 3],
    pub exact: Wavefront,
}

/// One on a surface of each kind.
pub fn cases_of_all_kinds() -> impl Iterator<Item = Case> {
    let mut random = Random::new(3);
    shapes_of_all_kinds().into_iter().map(move |soup| {
        let surface = Arc::new(super::surface(&soup));
        let geometry = geometry(&surface);
        let sources = mixed_sources(&surface, &mut random);
        let exact = exact(&geometry, &sources);
        Case { surface, geometry, sources, exact }
    })
}

/// Grown to the end.
pub fn grown(mut propagation: Propagation) -> Propagation {
    assert!(propagation.advance(f64::INFINITY, usize::MAX).expect("room"));
    propagation
}

/// Neither slices nor a solver that has answered before change what is found.
pub fn slices_and_use_change_nothing(start: impl Fn(&Arc<ExactGeometry>, &[(Place, f64)]) -> Propagation) {
    let surface = Arc::new(super::surface(&shapes::torus(2.0, 0.7, 90, 40)));
    let geometry = geometry(&surface);
    let whole = grown(start(&geometry, &at(3)));
    let mut sliced = start(&geometry, &at(3));
    while !sliced.advance(f64::INFINITY, 100).expect("room") {}
    assert_eq!(sliced.values(), whole.values());
    assert_eq!(sliced.windows(), whole.windows());

    let mut used = grown(start(&geometry, &mixed_sources(&surface, &mut Random::new(8))));
    used.restart(&at(3)).expect("a valid source");
    let used = grown(used);
    assert_eq!(used.values(), whole.values());
    assert_eq!(used.nearest_sources(), whole.nearest_sources());
}

/// Each value is near to the exact distance from the source that it is told to come from.
pub fn nearest_sources_are_told(
    start: impl Fn(&Arc<ExactGeometry>, &[(Place, f64)]) -> Propagation,
    is_near: impl Fn(f64, f64) -> bool,
) {
    let surface = Arc::new(super::surface(&shapes::torus(2.0, 0.7, 90, 40)));
    let geometry = geometry(&surface);
    let sources = mixed_sources(&surface, &mut Random::new(5));
    let together = grown(start(&geometry, &sources));
    let alone: Vec<Wavefront> = sources.iter().map(|&source| exact(&geometry, &[source])).collect();
    let nearest = together.nearest_sources();
    for vertex in surface.vertices() {
        let number = nearest[vertex].expect("a closed surface");
        let (value, least) = (together.values()[vertex], alone[number].values()[vertex]);
        assert!(is_near(value, least), "{value} from source {number}, {least}");
    }
    assert!((0..3).all(|number| nearest.iter().any(|&nearest| nearest == Some(number))));
}

/// A mesh that is as many times as large has distances as many times as large.
pub fn size_does_not_matter(start: impl Fn(&Arc<ExactGeometry>, &[(Place, f64)]) -> Propagation) {
    let soup = shapes::torus(2.0, 0.7, 40, 20);
    let values = |scale: f64| {
        let mut scaled = soup.clone();
        scaled.positions.iter_mut().for_each(|position| *position *= scale);
        let surface = Arc::new(super::surface(&scaled));
        let found = grown(start(&geometry(&surface), &at(0)));
        found.values().iter().map(|value| value / scale).collect::<Vec<_>>()
    };
    // Powers of two, so that rounding is the same.
    for exponent in [-60, 60] {
        assert_eq!(values(2.0_f64.powi(exponent)), values(1.0));
    }
}
