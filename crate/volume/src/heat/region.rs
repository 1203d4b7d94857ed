//! Exact distances around the sources, and the field of which distance beyond is the potential.

use glam::DVec3;
use heatwalk::ExactRadius;
use heatwalk::heat::{Constraint, scale};

use crate::heat::elements::Elements;
use crate::march::{March, Medium};
use crate::mesh::TetMesh;
use crate::point::TetSource;

/// Work of the march for each vertex of the mesh where the radius is chosen: it takes about half as long as the rest of a solve. Where
/// all vertices see the sources, the region has half of them; around obstacles it is smaller.
const WORK: f64 = 5.5;

/// Work on any mesh: that of some 300 vertices.
const LEAST_WORK: f64 = 3000.0;

/// Tetrahedra whose lengths are divided by together: one by one, each would wait for the root and the division before.
const BLOCK: usize = 16;

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
                let work = (WORK * mesh.vertex_count() as f64).max(LEAST_WORK);
                march.advance(f64::INFINITY, work as usize)
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
        let blocks = mesh.tetrahedra().chunks(BLOCK).zip(elements.shapes().chunks(BLOCK));
        for (block, (tetrahedra, shapes)) in blocks.enumerate() {
            let mut vectors = [DVec3::ZERO; BLOCK];
            // Squared lengths that divide them.
            let mut squares = [1.0; BLOCK];
            for (place, (corners, shape)) in tetrahedra.iter().zip(shapes).enumerate() {
                let cost = medium.cost((block * BLOCK + place) as u32);
                if cost.is_infinite() {
                    continue;
                }
                let exact = corners.map(|vertex| self.distances[vertex as usize]);
                let inside = exact.iter().filter(|&&distance| distance < self.radius).count();
                if inside > 0 {
                    touched.push((*corners, inside == exact.len()));
                }
                // The stiffness of w² g is w times that of g.
                if inside == exact.len() {
                    vectors[place] = cost * shape.gradient(exact);
                    continue;
                }
                let heat = corners.map(|vertex| heat[vertex as usize]);
                let sum: f64 = heat.iter().map(|value| value.abs()).sum();
                let scale = scale(sum);
                let gradient = shape.gradient(heat.map(|value| scale * value));
                vectors[place] = -cost * cost * gradient;
                // Where heat is constant the vector is 0 whatever divides it.
                squares[place] = gradient.length_squared() + f64::MIN_POSITIVE;
            }
            let factors = squares.map(|square| 1.0 / square.sqrt());
            for (((corners, shape), vector), factor) in tetrahedra.iter().zip(shapes).zip(vectors).zip(factors) {
                for (&vertex, part) in corners.iter().zip(shape.divergence(factor * vector)) {
                    divergence[vertex as usize] += part;
                }
            }
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
