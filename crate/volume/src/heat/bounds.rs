//! What distance cannot be: above the shortest way along edges, or below the straight line.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;

use crate::march::Medium;
use crate::mesh::TetMesh;
use crate::point::TetSource;

/// Straight lines lead to so many sources or groups of them, at most: each vertex is measured against all.
const GROUPS: usize = 32;

/// Where a value is more than an edge above that at its other end, the latter and the edge take its place, and so on along the edges. From
/// sources on, no value is then above the way along edges.
pub(super) fn cap(mesh: &TetMesh, medium: &Medium, sources: &[TetSource], values: &mut [f64]) {
    for source in sources {
        let place = source.point.position(mesh);
        let touched = medium.touching(mesh, source.point.corner(mesh)).into_iter();
        let cost = touched.map(|tetrahedron| medium.cost(tetrahedron)).fold(f64::INFINITY, f64::min);
        for (vertex, _) in source.point.support(mesh) {
            let straight = source.initial_distance + cost * place.distance(mesh.position(vertex));
            values[vertex.0 as usize] = values[vertex.0 as usize].min(straight);
        }
    }
    let mut queue: BinaryHeap<Reverse<(u64, u32)>> = BinaryHeap::new();
    // Bits of non-negative floats order as the floats do.
    let push = |queue: &mut BinaryHeap<Reverse<(u64, u32)>>, value: f64, vertex: u32| {
        queue.push(Reverse((value.to_bits(), vertex)));
    };
    for vertex in 0..mesh.vertex_count() as u32 {
        let value = values[vertex as usize];
        if value.is_finite() && along(mesh, medium, vertex).any(|(other, edge)| value + edge < values[other as usize]) {
            push(&mut queue, value, vertex);
        }
    }
    while let Some(Reverse((bits, vertex))) = queue.pop() {
        let value = f64::from_bits(bits);
        if value > values[vertex as usize] {
            continue;
        }
        for (other, edge) in along(mesh, medium, vertex) {
            if value + edge < values[other as usize] {
                values[other as usize] = value + edge;
                push(&mut queue, value + edge, other);
            }
        }
    }
}

/// The vertices at the other ends of the edges of a vertex, with what those cost; some more than once.
fn along<'a>(mesh: &'a TetMesh, medium: &'a Medium, vertex: u32) -> impl Iterator<Item = (u32, f64)> + 'a {
    let place = mesh.positions()[vertex as usize];
    let length = move |other: u32| place.distance(mesh.positions()[other as usize]);
    let uniform = medium.uniform_cost();
    let edges = uniform.map(|cost| mesh.adjacent().row(vertex).iter().map(move |&other| (other, cost * length(other))));
    let by_tetrahedra = uniform.is_none().then(|| {
        let open = mesh.around().row(vertex).iter().filter(|&&tetrahedron| medium.cost(tetrahedron).is_finite());
        open.flat_map(move |&tetrahedron| {
            let corners = mesh.tetrahedra()[tetrahedron as usize].into_iter().filter(move |&other| other != vertex);
            corners.map(move |other| (other, medium.cost(tetrahedron) * length(other)))
        })
    });
    edges.into_iter().flatten().chain(by_tetrahedra.into_iter().flatten())
}

/// No value below the straight line to a source through the least cost, or, where there are many sources, to the box around some.
pub(super) fn raise(mesh: &TetMesh, medium: &Medium, sources: &[TetSource], values: &mut [f64]) {
    let cost = medium.least_cost();
    let none = (f64::INFINITY, DVec3::INFINITY, DVec3::NEG_INFINITY);
    let around = |(initial, low, high): (f64, DVec3, DVec3), source: &TetSource| {
        let place = source.point.position(mesh);
        (initial.min(source.initial_distance), low.min(place), high.max(place))
    };
    let groups: Vec<_> =
        sources.chunks(sources.len().div_ceil(GROUPS)).map(|group| group.iter().fold(none, around)).collect();
    for (value, &place) in values.iter_mut().zip(mesh.positions()) {
        let straight =
            groups.iter().map(|&(initial, low, high)| initial + cost * place.distance(place.clamp(low, high)));
        *value = value.max(straight.fold(f64::INFINITY, f64::min));
    }
}
