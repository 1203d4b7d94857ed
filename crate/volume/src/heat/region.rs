//! Exact distances around the sources, and the field of which distance beyond is the potential.

use glam::DVec3;
use heatwalk::ExactRadius;
use heatwalk::heat::Constraint;

use crate::heat::elements::Elements;
use crate::march::{March, Medium};
use crate::mesh::TetMesh;
use crate::point::TetSource;

/// Share of the vertices that the region has where its radius is chosen: the march there takes no more time than the rest of a solve.
const SHARE: f64 = 0.5;

/// Vertices that it may have on any mesh.
const LEAST_VERTICES: usize = 300;

/// Exact distances below a radius.
pub(super) struct Region {
    distances: Vec<f64>,
    radius: f64,
}

/// Right side of the Poisson equation, and the tetrahedra that are partly in the region.
pub(super) struct Field {
    pub(super) divergence: Vec<f64>,
    /// Corners, and whether all are in the region.
    pub(super) touched: Vec<([u32; 4], bool)>,
}

impl Region {
    pub(super) fn new(
        mesh: &TetMesh,
        medium: &Medium,
        sources: &[TetSource],
        radius: ExactRadius,
        mean_edge: f64,
    ) -> Self {
        let least = sources.iter().map(|source| source.initial_distance).fold(f64::INFINITY, f64::min);
        let mut march = March::new(mesh, medium, sources);
        let radius = match radius {
            ExactRadius::Edges(edges) => march.advance(least + edges * mean_edge, usize::MAX),
            ExactRadius::Automatic => {
                let vertices = (SHARE * mesh.vertex_count() as f64) as usize;
                march.advance(f64::INFINITY, vertices.max(LEAST_VERTICES))
            }
        };
        Self { distances: march.into_distances(), radius }
    }

    /// Every distance below it is exact.
    pub(super) fn radius(&self) -> f64 {
        self.radius
    }

    /// The distance of a vertex, if it is in the region.
    fn value(&self, vertex: u32) -> Option<f64> {
        Some(self.distances[vertex as usize]).filter(|&distance| distance < self.radius)
    }

    /// The field that should be the gradient of distance: that of exact distance in tetrahedra whose corners are all in the region,
    /// elsewhere of length w against the gradient of heat, as the metric w² g has it, and zero where heat is constant.
    pub(super) fn field(&self, mesh: &TetMesh, medium: &Medium, elements: &Elements, heat: &[f64]) -> Field {
        let mut divergence = vec![0.0; mesh.vertex_count()];
        let mut touched = Vec::new();
        for (tetrahedron, &corners) in mesh.tetrahedra().iter().enumerate() {
            let tetrahedron = tetrahedron as u32;
            let cost = medium.cost(tetrahedron);
            if cost.is_infinite() {
                continue;
            }
            let exact = corners.map(|vertex| self.value(vertex));
            if exact.iter().any(Option::is_some) {
                touched.push((corners, exact.iter().all(Option::is_some)));
            }
            let vector = match exact {
                [Some(a), Some(b), Some(c), Some(d)] => elements.gradient([a, b, c, d], tetrahedron),
                _ => {
                    let heat = corners.map(|vertex| heat[vertex as usize]);
                    // Heat falls by hundreds of orders of magnitude; only ratios within the tetrahedron matter.
                    let largest = heat.iter().map(|value| value.abs()).fold(0.0, f64::max);
                    if largest == 0.0 {
                        DVec3::ZERO
                    } else {
                        -cost * elements.gradient(heat.map(|value| value / largest), tetrahedron).normalize_or_zero()
                    }
                }
            };
            // The stiffness of w² g is w times that of g.
            elements.add_divergence(corners, tetrahedron, cost * vector, &mut divergence);
        }
        Field { divergence, touched }
    }

    /// What distance beyond the region has to meet: on the rim of each patch of it the mean of the exact distances, and the initial
    /// distances of sources that no patch contains.
    pub(super) fn constraints(
        &self,
        mesh: &TetMesh,
        touched: &[([u32; 4], bool)],
        sources: &[TetSource],
    ) -> Vec<Constraint> {
        let touched = touched.iter().copied();
        let mut constraints = Constraint::of_rims(mesh.vertex_count(), touched, |vertex| self.value(vertex));
        let is_beyond =
            |source: &&TetSource| source.point.support(mesh).any(|(vertex, _)| self.value(vertex.0).is_none());
        let at_source = |source: &TetSource| Constraint::new(source.point.support(mesh), source.initial_distance);
        constraints.extend(sources.iter().filter(is_beyond).map(at_source));
        constraints
    }

    /// Puts exact values in their places, and infinity where no source is.
    pub(super) fn complete(&self, mesh: &TetMesh, components: &[u32], sources: &[TetSource], values: &mut [f64]) {
        let mut has_source = vec![false; components.iter().max().map_or(0, |&last| last as usize + 1)];
        for (vertex, _) in sources.iter().flat_map(|source| source.point.support(mesh)) {
            has_source[components[vertex.0 as usize] as usize] = true;
        }
        let least = if self.radius.is_finite() { self.radius } else { 0.0 };
        for (vertex, (value, &component)) in values.iter_mut().zip(components).enumerate() {
            *value = match self.value(vertex as u32) {
                Some(exact) => exact,
                None if has_source[component as usize] => value.max(least),
                None => f64::INFINITY,
            };
        }
    }
}
