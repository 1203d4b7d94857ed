//! Whether waves come straight to vertices.

use super::Search;
use crate::march::medium::AROUND;
use crate::march::wave::Wave;
use crate::mesh::{Crossing, NONE, Start};

/// Faces that a line passes before it is asked whether those corners see the source, too, that are farther away: on ordinary meshes
/// lines end before. Asked again whenever it has passed twice as many.
const ASKED: usize = 64;

/// Corners that turn out to be in the shadow of something may be more by this than those that are not; then no more are asked: where much is
/// in the way, that shortens few lines.
const HIDDEN: usize = 64;

impl Search<'_> {
    /// Whether a wave comes straight to a vertex.
    pub(super) fn is_seen(&mut self, wave: u32, vertex: u32) -> bool {
        self.looks(wave, vertex, true)
    }

    /// The same of a vertex that is on the way of others: kept, and its own line asks nothing but what is kept.
    fn is_shown(&mut self, wave: u32, vertex: u32) -> bool {
        if let Some(&is_shown) = self.shown.get(&(wave, vertex)) {
            return is_shown;
        }
        let is_shown = self.looks(wave, vertex, false);
        self.shown.insert((wave, vertex), is_shown);
        self.hidden += usize::from(!is_shown);
        is_shown
    }

    fn looks(&mut self, wave: u32, vertex: u32, may_ask: bool) -> bool {
        if wave == NONE {
            return true;
        }
        let (mesh, medium) = (self.mesh, self.medium);
        let Wave { cost, .. } = self.waves[wave as usize];
        let place = mesh.positions()[vertex as usize];
        let from = self.waves[wave as usize].ray(place).from;
        if from == place || self.comes_along(wave, vertex) {
            return true;
        }
        let may_enter = |tetrahedron: u32| medium.cost(tetrahedron) == cost;
        let sight = medium.sight(mesh);
        // Most lines that are not seen would leave the mesh at once, seen from where they come from.
        let start = self.waves[wave as usize].start_at(from);
        let ends = start.into_iter().chain([Start::Vertex(vertex)]);
        self.work += ends.map(|end| sight.around(end)).sum::<usize>() / AROUND;
        if start.is_some_and(|start| !sight.leaves(start, place, may_enter)) {
            return false;
        }
        // Where the other three corners of a tetrahedron see the source, so does all that is behind it, up to what is smaller than it.
        let (tetrahedra, wave_of) = (mesh.tetrahedra(), &self.wave_of);
        let has_wave = |&corner: &u32| corner == vertex || wave_of[corner as usize] == wave;
        let may_show =
            |tetrahedron: u32| tetrahedra[tetrahedron as usize].iter().all(has_wave) && may_enter(tetrahedron);
        if sight.leaves(Start::Vertex(vertex), from, may_show) {
            return true;
        }
        // Where the three corners of a face see the source, so does all of the face, up to what is smaller than it.
        let (mut passed, mut next) = (0, ASKED);
        let crossing = |corners: [u32; 3]| {
            self.work += 1;
            passed += 1;
            let is_next = may_ask && passed == next;
            if is_next {
                next *= 2;
            }
            let is_asked = is_next && 2 * self.hidden <= self.shown.len() + HIDDEN;
            let is_kept = !may_ask || passed >= ASKED;
            let sees = |&corner: &u32| {
                self.wave_of[corner as usize] == wave
                    || if is_asked {
                        self.is_shown(wave, corner)
                    } else {
                        is_kept && self.shown.get(&(wave, corner)) == Some(&true)
                    }
            };
            if corners.iter().all(sees) { Crossing::Known } else { Crossing::On }
        };
        sight.walk(Start::Vertex(vertex), [place, from], may_enter, crossing).is_some()
    }

    /// Whether a wave comes from the other end of an edge, along which nothing is in between.
    fn comes_along(&self, wave: u32, vertex: u32) -> bool {
        let Wave { cost, ends, .. } = self.waves[wave as usize];
        let Some([from, other]) = ends else { return false };
        from == other
            && self.mesh.adjacent().row(vertex).binary_search(&from).is_ok()
            && self.least_cost_at([from, vertex]) <= cost
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use glam::DVec3;

    use super::Search;
    use crate::march::Medium;
    use crate::mesh::TetMesh;
    use crate::soup::TetSoup;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    const COUNT: u32 = 12_000;

    /// A circle with a vertex above, one below and one in its middle.
    fn rim() -> Vec<DVec3> {
        let on_circle = |index: u32| {
            let (y, x) = (TAU * f64::from(index) / f64::from(COUNT)).sin_cos();
            DVec3::new(x, y, 0.0)
        };
        (0..COUNT).map(on_circle).chain([DVec3::Z, DVec3::NEG_Z, DVec3::ZERO]).collect()
    }

    fn around_edge() -> TetSoup {
        let tetrahedra = (0..COUNT).map(|corner| [COUNT, COUNT + 1, corner, (corner + 1) % COUNT]);
        TetSoup { positions: rim(), tetrahedra: tetrahedra.collect() }
    }

    fn around_vertex() -> TetSoup {
        let both = |corner| [COUNT, COUNT + 1].map(|end| [COUNT + 2, end, corner, (corner + 1) % COUNT]);
        TetSoup { positions: rim(), tetrahedra: (0..COUNT).flat_map(both).collect() }
    }

    /// A prism cut across into flat ones.
    fn slices() -> TetSoup {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let slice = |slice: u32| corners.map(|corner| corner + DVec3::Z * (f64::from(slice) / f64::from(COUNT)));
        let between = |slice: u32| [0, 1, 2].map(|first| [0, 1, 2, 3].map(|next| 3 * slice + first + next));
        let tetrahedra = (0..COUNT).flat_map(between).collect();
        TetSoup { positions: (0..=COUNT).flat_map(slice).collect(), tetrahedra }
    }

    #[test]
    fn what_lies_behind_n_faces_is_not_seen_through_each_of_them() {
        for soup in [around_edge(), around_vertex(), slices()] {
            let mesh = TetMesh::build(&soup).unwrap();
            let medium = Medium::new(&mesh, None).unwrap();
            let mut search = Search::new(&mesh, &medium);
            search.start_at(1, 0.0);
            assert_eq!(search.advance(f64::INFINITY, usize::MAX), f64::INFINITY);
            let each = search.work as f64 / mesh.tetrahedron_count() as f64;
            assert!(each < 100.0, "{each}");
            for (&place, &distance) in mesh.positions().iter().zip(&search.distances) {
                let straight = place.distance(mesh.positions()[1]);
                assert!((distance - straight).abs() <= 1e-12, "{distance} {straight}");
            }
        }
    }
}
