//! Minimum degree ordering of small graphs, with the degrees exact.
//!
//! George and Liu, "The evolution of the minimum degree ordering algorithm" (1989).

use super::graph::Graph;
use crate::pattern::NONE;

/// Room for the elimination graphs of small parts of one graph.
#[derive(Debug)]
pub(super) struct Leaves {
    /// `#V`, number within the leaf in hand, or [`NONE`].
    number: Vec<u32>,
    /// Of each vertex of the leaf its neighbours, one bit a vertex: those of the leaf first, then those around it.
    adjacency: Vec<u64>,
    degree: Vec<u32>,
}

impl Leaves {
    /// Room for parts of a graph of this size.
    pub(super) fn new(size: usize) -> Self {
        Self { number: vec![NONE; size], adjacency: Vec::new(), degree: Vec::new() }
    }

    /// Appends the vertices of a leaf to an elimination order. Vertices around the leaf, which are eliminated later,
    /// count for the degrees.
    pub(super) fn order(&mut self, graph: &Graph, leaf: &[u32], order: &mut Vec<u32>) {
        if leaf.is_empty() {
            return;
        }
        let words = self.fill(graph, leaf);
        let mut pivot_row = vec![0; words];
        let mut remaining: Vec<usize> = (0..leaf.len()).collect();
        while let Some((place, &pivot)) = remaining.iter().enumerate().min_by_key(|&(_, &vertex)| self.degree[vertex]) {
            remaining.swap_remove(place);
            order.push(leaf[pivot]);
            pivot_row.copy_from_slice(&self.adjacency[pivot * words..][..words]);
            for vertex in bits(&pivot_row).take_while(|&vertex| vertex < leaf.len()) {
                let row = &mut self.adjacency[vertex * words..][..words];
                for (target, source) in row.iter_mut().zip(&pivot_row) {
                    *target |= source;
                }
                for gone in [pivot, vertex] {
                    row[gone / 64] &= !(1 << (gone % 64));
                }
                self.degree[vertex] = count(row);
            }
        }
    }

    /// Sets `adjacency` and `degree` up; returns the words of a row.
    fn fill(&mut self, graph: &Graph, leaf: &[u32]) -> usize {
        let mut numbered = leaf.to_vec();
        for (index, &vertex) in leaf.iter().enumerate() {
            self.number[vertex as usize] = index as u32;
        }
        for &other in leaf.iter().flat_map(|&vertex| graph.neighbours(vertex)) {
            if self.number[other as usize] == NONE {
                self.number[other as usize] = numbered.len() as u32;
                numbered.push(other);
            }
        }
        let words = numbered.len().div_ceil(64);
        self.adjacency.clear();
        self.adjacency.resize(leaf.len() * words, 0);
        self.degree.clear();
        for (row, &vertex) in self.adjacency.chunks_exact_mut(words).zip(leaf) {
            for &other in graph.neighbours(vertex) {
                let number = self.number[other as usize];
                row[number as usize / 64] |= 1 << (number % 64);
            }
            self.degree.push(count(row));
        }
        for vertex in numbered {
            self.number[vertex as usize] = NONE;
        }
        words
    }
}

fn count(row: &[u64]) -> u32 {
    row.iter().map(|word| word.count_ones()).sum()
}

/// The places of the bits that are set, ascending.
fn bits(row: &[u64]) -> impl Iterator<Item = usize> + '_ {
    row.iter().enumerate().flat_map(|(index, &word)| {
        let rests = std::iter::successors(Some(word), |&word| Some(word & word.wrapping_sub(1)));
        rests.take_while(|&rest| rest != 0).map(move |rest| index * 64 + rest.trailing_zeros() as usize)
    })
}
