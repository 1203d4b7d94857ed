//! Distance by waves that march from vertex to vertex: nothing is factored, and it is exact where straight lines lead to the source.
//!
//! Space inside a mesh is flat, so a virtual source is a place: a source, or where a shortest path bends around a concave edge. Each
//! vertex has the wave that its distance comes from, and offers it to its neighbors. One is accepted, nearest first, if the straight
//! line to where it comes from stays inside the mesh. Where both ends of a concave edge have a distance, a wave starts that bends
//! around it. Where costs change, waves end; there the virtual source of each tetrahedron is placed by what is known at its corners.
//!
//! Virtual sources are those of fast marching on triangles (Kimmel and Sethian 1998) and of windows (Mitchell, Mount, Papadimitriou
//! 1987); how distance goes on behind an edge is Keller's (1962) law of diffraction.

mod medium;
mod nodes;
mod refraction;
mod search;
mod sights;
mod taut;
mod wave;

pub use medium::COSTS;
pub(crate) use medium::Medium;
pub(crate) use taut::pull;

use glam::DVec3;
use heatwalk::VertexId;

use crate::corner::Corner;
use crate::mesh::{Crossing, NONE, Start, TetMesh};
use crate::point::{TetPoint, TetSource};
use search::Search;
use sights::{Sights, Tree};
use wave::Wave;

/// A march in work.
pub(crate) enum March<'a> {
    /// By waves.
    Waves(Search<'a>),
    /// In a riddled mesh.
    Sights(Sights<'a>),
}

impl<'a> March<'a> {
    /// From sources that were checked.
    pub(crate) fn new(mesh: &'a TetMesh, medium: &'a Medium, sources: &[TetSource]) -> Self {
        if let Some(sights) = medium.nodes().and_then(|nodes| Sights::new(mesh, medium, nodes, sources)) {
            return Self::Sights(sights);
        }
        let mut search = Search::new(mesh, medium);
        sources.iter().for_each(|source| search.start(source));
        Self::Waves(search)
    }

    /// Goes on until every distance below `radius` is final, or so much work is done: about that of so many faces that straight lines
    /// pass. Returns the radius below which all are: infinity where nothing is left to do.
    pub(crate) fn advance(&mut self, radius: f64, work: usize) -> f64 {
        match self {
            Self::Waves(search) => search.advance(radius, work),
            Self::Sights(search) => search.advance(radius, work),
        }
    }

    /// The distances that are at most `most`, infinite elsewhere, and what they come from.
    pub(crate) fn within(self, most: f64) -> Found {
        // What riddled meshes take is bounded by their nodes.
        let work = if let Self::Waves(search) = &self { search.most_work } else { usize::MAX };
        self.within_work(most, work)
    }

    fn within_work(mut self, most: f64, work: usize) -> Found {
        // Paths over nodes are longer than what they are pulled to, by how much is not known.
        let radius = if matches!(self, Self::Waves(_)) { most.next_up() } else { f64::INFINITY };
        let reached = self.advance(radius, work);
        if let (Self::Waves(search), true) = (&mut self, reached < radius) {
            search.end_along_edges();
        }
        let (mut distances, origins, is_pulled) = self.finish();
        distances.iter_mut().filter(|distance| **distance > most).for_each(|distance| *distance = f64::INFINITY);
        let exact_below = if !is_pulled {
            0.0
        } else if reached < radius {
            reached
        } else {
            f64::INFINITY
        };
        Found { distances, origins, exact_below }
    }

    /// The distances (`#V`).
    pub(crate) fn into_distances(self) -> Vec<f64> {
        self.finish().0
    }

    /// The distances (`#V`), what they come from, and whether paths were pulled where they are to be.
    fn finish(self) -> (Vec<f64>, Origins, bool) {
        match self {
            Self::Waves(search) => {
                (search.distances, Origins::Waves(Waves { waves: search.waves, of_vertex: search.wave_of }), true)
            }
            Self::Sights(search) => {
                let (distances, tree, is_pulled) = search.finish();
                (distances, Origins::Sights(tree), is_pulled)
            }
        }
    }
}

/// What a march has found.
pub(crate) struct Found {
    /// `#V`.
    pub(crate) distances: Vec<f64>,
    /// What they come from.
    pub(crate) origins: Origins,
    /// Those above are ways along edges, because the march would have been too much work; infinite where none is.
    pub(crate) exact_below: f64,
}

/// Where distances come from.
#[derive(Debug, Clone)]
pub(crate) enum Origins {
    /// Waves.
    Waves(Waves),
    /// Lines of sight in a riddled mesh.
    Sights(Tree),
}

impl Origins {
    /// Whether the distance of a vertex comes from a source, straight and through one cost.
    pub(crate) fn is_straight(&self, vertex: VertexId) -> bool {
        match self {
            Self::Waves(waves) => waves.is_straight(vertex),
            Self::Sights(tree) => tree.is_straight(vertex.0),
        }
    }

    /// The waves, where there are some.
    pub(crate) fn waves(&self) -> Option<&Waves> {
        match self {
            Self::Waves(waves) => Some(waves),
            Self::Sights(_) => None,
        }
    }

    /// The path from a place over lines of sight; none in a mesh that is not riddled, or where there is none.
    pub(crate) fn path(&self, mesh: &TetMesh, medium: &Medium, from: TetPoint) -> Option<Vec<Corner>> {
        match (self, medium.nodes()) {
            (Self::Sights(tree), Some(nodes)) => {
                tree.path(mesh, medium, nodes, from.corner(mesh)).map(|(_, path)| path)
            }
            _ => None,
        }
    }
}

/// The waves that distances come from.
#[derive(Debug, Clone)]
pub(crate) struct Waves {
    waves: Vec<Wave>,
    /// Of each vertex; [`NONE`] where distance is refracted or infinite.
    of_vertex: Vec<u32>,
}

/// A straight part of a path towards the source.
pub(crate) struct Leg {
    /// Where it ends.
    pub(crate) to: DVec3,
    /// What each unit of its length costs.
    pub(crate) cost: f64,
    /// Where in the mesh that is; none at a source.
    pub(crate) start: Option<Start>,
}

impl Waves {
    /// Whether the wave of a vertex comes from a source, straight and through one cost.
    pub(crate) fn is_straight(&self, vertex: VertexId) -> bool {
        let wave = self.of_vertex[vertex.0 as usize];
        wave != NONE && self.waves[wave as usize].is_first()
    }

    /// The straight part of the shortest path from a place among `vertices`, whose waves it may come by. None where none comes there
    /// straight.
    pub(crate) fn leg(
        &self,
        mesh: &TetMesh,
        medium: &Medium,
        place: DVec3,
        start: Start,
        vertices: impl Iterator<Item = u32>,
    ) -> Option<Leg> {
        let mut waves: Vec<u32> =
            vertices.map(|vertex| self.of_vertex[vertex as usize]).filter(|&wave| wave != NONE).collect();
        let parents: Vec<u32> = waves.iter().flat_map(|&wave| self.waves[wave as usize].parents).collect();
        waves.extend(parents.into_iter().filter(|&wave| wave != NONE));
        waves.sort_unstable();
        waves.dedup();
        let mut rays: Vec<(u32, wave::Ray)> =
            waves.into_iter().map(|wave| (wave, self.waves[wave as usize].ray(place))).collect();
        rays.sort_by(|a, b| a.1.distance.total_cmp(&b.1.distance));
        rays.into_iter().find_map(|(wave, ray)| {
            let wave = &self.waves[wave as usize];
            let may_enter = |tetrahedron: u32| medium.cost(tetrahedron) == wave.cost;
            let sight = medium.sight(mesh);
            let is_clear =
                ray.from == place || sight.walk(start, [place, ray.from], may_enter, |_| Crossing::On).is_some();
            is_clear.then_some(Leg { to: ray.from, cost: wave.cost, start: wave.start_at(ray.from) })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn what_would_be_too_much_work_is_the_way_along_edges() {
        let mesh = TetMesh::build(&shapes::cube(8, 0.2)).unwrap();
        let medium = Medium::new(&mesh, None).unwrap();
        let march = || March::new(&mesh, &medium, &[TetPoint::Vertex(VertexId(0)).into()]);
        let (whole, some) = (march().within(f64::INFINITY), march().within_work(f64::INFINITY, 2000));
        assert_eq!(whole.exact_below, f64::INFINITY);
        let exact = some.distances.iter().filter(|distance| **distance < some.exact_below).count();
        assert!((100..mesh.vertex_count() / 2).contains(&exact), "{exact}");
        for (vertex, (&whole, &some_distance)) in (0..).zip(whole.distances.iter().zip(&some.distances)) {
            if some_distance < some.exact_below {
                assert_eq!(some_distance, whole);
            } else {
                assert!(some_distance >= whole, "{some_distance} {whole}");
            }
            for &other in mesh.adjacent().row(vertex) {
                let [here, there] = [vertex, other].map(|end| mesh.positions()[end as usize]);
                let along = some.distances[other as usize] + here.distance(there);
                assert!(some_distance <= along * (1.0 + 1e-8), "{some_distance} {along}");
            }
        }
        assert!(!some.origins.is_straight(VertexId(mesh.vertex_count() as u32 - 1)));
    }
}
