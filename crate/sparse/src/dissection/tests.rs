//! Separators and orders of graphs of known shape, and of degenerate ones.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::collections::BTreeSet;

use super::*;

/// A graph by its edges.
fn graph(size: usize, edges: &[[u32; 2]]) -> Graph {
    let mut columns = vec![Vec::new(); size];
    for &[a, b] in edges {
        columns[a.min(b) as usize].push(a.max(b));
    }
    let mut start = vec![0];
    let mut rows = Vec::new();
    for (column, below) in (0..).zip(&columns) {
        rows.push(column);
        rows.extend(below.iter().copied().collect::<BTreeSet<u32>>());
        start.push(rows.len() as u32);
    }
    Graph::of_lower_triangle(&Pattern::new(start, rows).expect("a pattern"))
}

/// Edges of `side × side` squares' corners, every square cut by one diagonal, numbered from `first`.
fn grid(side: u32, first: u32) -> Vec<[u32; 2]> {
    let mut edges = Vec::new();
    for y in 0..side {
        for x in 0..side {
            let at = |x: u32, y: u32| first + y * side + x;
            edges.extend((x + 1 < side).then(|| [at(x, y), at(x + 1, y)]));
            edges.extend((y + 1 < side).then(|| [at(x, y), at(x, y + 1)]));
            edges.extend((x + 1 < side && y + 1 < side).then(|| [at(x, y), at(x + 1, y + 1)]));
        }
    }
    edges
}

fn separate(graph: &Graph) -> Separation {
    let leaves = Leaves::new(graph.size());
    Dissection { whole: graph, leaf: LEAF, scratch: Scratch::default(), leaves, order: Vec::new(), parts: Vec::new() }
        .separate(graph)
}

/// Asserts that no edge joins the parts, and that the weights are those of the labels.
fn assert_separates(graph: &Graph, separation: &Separation) {
    let mut weights = [0; 3];
    for vertex in 0..graph.size() as u32 {
        let label = separation.label[vertex as usize];
        weights[label as usize] += graph.weight(vertex);
        for &other in graph.neighbours(vertex) {
            let labels = [label, separation.label[other as usize]];
            assert!(labels != [0, 1], "an edge joins {vertex} and {other} past the separator");
        }
    }
    assert_eq!(weights, separation.weights);
}

fn assert_permutation(graph: &Graph, mut order: Vec<u32>) {
    order.sort_unstable();
    assert!(order.iter().copied().eq(0..graph.size() as u32), "every vertex comes once");
}

#[test]
fn a_grid_is_cut_across() {
    for side in [20, 70, 150] {
        let graph = graph((side * side) as usize, &grid(side, 0));
        let separation = separate(&graph);
        assert_separates(&graph, &separation);
        let [a, b, separator] = separation.weights;
        assert!(a.max(b) <= heaviest_part(&graph), "parts of {a} and {b} at side {side}");
        // A straight cut has `side` vertices, one off the middle by a tenth that turns a corner somewhat more.
        assert!(separator * 10 <= side * 13, "{separator} vertices cut a grid of side {side}");
    }
}

#[test]
fn a_waist_is_found() {
    // Two grids that one path joins: one vertex separates them, though most cuts are a side long.
    let (side, path) = (40, 9);
    let count = side * side;
    let mut edges = grid(side, 0);
    edges.extend(grid(side, count));
    edges.extend((0..path - 1).map(|k| [2 * count + k, 2 * count + k + 1]));
    edges.extend([[count - 1, 2 * count], [2 * count + path - 1, count]]);
    let graph = graph((2 * count + path) as usize, &edges);
    let separation = separate(&graph);
    assert_separates(&graph, &separation);
    assert_eq!(separation.weights[2], 1);
}

#[test]
fn contraction_keeps_weight_and_edges() {
    let fine = graph(900, &grid(30, 0));
    let (coarse, cluster_of) = fine.contract(FOLLOWERS, 4);
    assert_eq!(coarse.total(), 900);
    assert!(coarse.size() <= 450, "{} clusters", coarse.size());
    for vertex in 0..900 {
        let cluster = cluster_of[vertex as usize];
        assert!(coarse.weight(cluster) <= 4);
        for &other in fine.neighbours(vertex) {
            let other = cluster_of[other as usize];
            assert_eq!(coarse.neighbours(cluster).contains(&other), cluster != other);
        }
    }
}

#[test]
fn degenerate_graphs_are_ordered() {
    let star: Vec<[u32; 2]> = (1..5000).map(|k| [0, k]).collect();
    let fan: Vec<[u32; 2]> = (1..5000).flat_map(|k| [[0, k], [k, k % 4999 + 1]]).collect();
    let path: Vec<[u32; 2]> = (1..20_000).map(|k| [k - 1, k]).collect();
    let apart: Vec<[u32; 2]> = (0..50).flat_map(|k| grid(8, 80 * k)).collect();
    let complete: Vec<[u32; 2]> = (0..300).flat_map(|a| (a + 1..300).map(move |b| [a, b])).collect();
    let cases = [(0, vec![]), (1, vec![]), (4000, vec![]), (5000, star), (5000, fan), (20_000, path), (4000, apart)];
    for (size, edges) in cases.into_iter().chain([(300, complete)]) {
        let graph = graph(size, &edges);
        assert_permutation(&graph, nested_dissection(&graph));
        if size > 0 {
            assert_separates(&graph, &separate(&graph));
        }
    }
}

#[test]
fn the_order_is_the_same_every_time() {
    let graph = graph(2500, &grid(50, 0));
    assert_eq!(nested_dissection(&graph), nested_dissection(&graph));
}

#[test]
fn parts_hold_their_sides_and_no_edge_joins_these() {
    let side = 60;
    let edges = grid(side, 0);
    let mut columns = vec![BTreeSet::new(); (side * side) as usize];
    for &[a, b] in &edges {
        columns[a.min(b) as usize].insert(a.max(b));
    }
    let (mut start, mut rows) = (vec![0], Vec::new());
    for (column, below) in (0..).zip(&columns) {
        rows.push(column);
        rows.extend(below);
        start.push(rows.len() as u32);
    }
    let Separators { order, parts } = Separators::of(&Pattern::new(start, rows).expect("a pattern"), 32);
    assert_permutation(&graph((side * side) as usize, &edges), order.clone());
    let mut place_of = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, &vertex)| place_of[vertex as usize] = place);
    assert_eq!(parts.last().map(|part| (part.start, part.end)), Some((0, order.len())));
    for (number, &Part { start, separator, end }) in parts.iter().enumerate() {
        if start == separator {
            assert!(end - start <= 32);
            continue;
        }
        // The second side comes just before its whole, and the first one before all of the second.
        let middle = parts[number - 1].start;
        assert!(start < middle && parts[number - 1].end == separator);
        for &[a, b] in &edges {
            let [a, b] = [a, b].map(|vertex| place_of[vertex as usize]);
            let is_across = (start..middle).contains(&a.min(b)) && (middle..separator).contains(&a.max(b));
            assert!(!is_across, "an edge joins two sides of part {number}");
        }
    }
}
