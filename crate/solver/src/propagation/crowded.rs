//! Sources on edges of many faces.
//!
//! Each sends windows into all of these, so that as many sources as there are faces would take the square of their number before any
//! window has crossed a face. Where there are too many on an edge, those go that are nearest in equal parts of it: what starts at another
//! one is nearer by the length of a part at most.

use std::collections::BTreeMap;

use heatwalk_base::sort;
use heatwalk_surface::edges::EdgeNames;
use heatwalk_surface::{Place, Source};

use crate::distance::on_first;
use crate::exact::ExactGeometry;

/// Parts of an edge, and as many more for each source that there is to a face. On edges of no more faces all sources go.
const PARTS: usize = 64;

/// The numbers of the sources that go for all of them, ascending; none where each does.
pub(super) fn going(geometry: &ExactGeometry, sources: &[Source]) -> Option<Vec<u32>> {
    let surface = geometry.surface();
    let mut names = EdgeNames::default();
    let mut on_edges = Vec::new();
    for (number, source) in sources.iter().enumerate() {
        if let Place::Edge { halfedge, fraction } = geometry.settled(source.place())
            && surface.edges().is_branching(halfedge)
        {
            on_edges.push((on_first(&mut names, surface, (halfedge, fraction)), number));
        }
    }
    sort::sort_by_key(&mut on_edges, |&((edge, _), _)| edge);
    let mut goes = vec![true; sources.len()];
    for of_edge in on_edges.chunk_by(|a, b| a.0.0 == b.0.0) {
        let faces = surface.edges().around(of_edge[0].0.0).count();
        let parts = PARTS + PARTS * of_edge.len() / faces;
        if of_edge.len() <= parts {
            continue;
        }
        let mut nearest = BTreeMap::new();
        for &((_, along), number) in of_edge {
            let of_part = nearest.entry((along * parts as f64) as usize).or_insert(number);
            if sources[number].initial_distance() < sources[*of_part].initial_distance() {
                goes[std::mem::replace(of_part, number)] = false;
            } else if number != *of_part {
                goes[number] = false;
            }
        }
    }
    goes.contains(&false).then(|| (0..).zip(goes).filter(|&(_, goes)| goes).map(|(number, _)| number).collect())
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use glam::DVec3;
    use heatwalk_surface::{Element as _, FaceId, Soup, Surface};

    use super::*;
    use crate::exact::checked_sources;

    /// How many faces sources send windows into that lie along the edge of a book, half of them as its first page sees them and half
    /// as its last one does.
    fn lit(pages: usize, count: usize) -> usize {
        let mut positions = vec![DVec3::ZERO, DVec3::Y];
        positions.extend((0..pages).map(|page| DVec3::new(1.0, 0.5, page as f64)));
        let corners = (0..pages as u32).map(|page| if page == 0 { [0, 1, 2] } else { [1, 0, page + 2] });
        let surface = Surface::build(&Soup::single("book", positions, corners.collect())).expect("a surface");
        let place = |number: usize| {
            let halfedge = FaceId::from_index(if number.is_multiple_of(2) { 0 } else { pages - 1 }).halfedge(0);
            Place::Edge { halfedge, fraction: (number as f64 + 0.5) / count as f64 }
        };
        let places: Vec<Place> = (0..count).map(place).collect();
        let sources = checked_sources(&surface, &places).expect("sources");
        pages * going(&ExactGeometry::new(surface), &sources).map_or(count, |going| going.len())
    }

    #[test]
    fn faces_that_are_lit_grow_with_the_sources_and_the_faces_as_their_sum() {
        for (pages, count) in [(500, 500), (2000, 500), (500, 2000), (2000, 2000)] {
            let lit = lit(pages, count);
            assert!(lit <= PARTS * (pages + count), "{lit} of {pages} pages by {count} sources");
        }
    }

    #[test]
    fn on_an_edge_of_few_faces_or_with_few_sources_all_go() {
        for (pages, count) in [(2, 500), (64, 2000), (2000, 64)] {
            assert_eq!(lit(pages, count), pages * count);
        }
    }
}
