//! Vertex separators: grown from a vertex, and refined by moving one vertex at a time.
//!
//! Fiduccia and Mattheyses, "A linear-time heuristic for improving network partitions" (1982), on vertex separators as
//! in Hendrickson and Rothberg, "Improving the run time and quality of nested dissection ordering" (1998), section 2.

use std::collections::BinaryHeap;

use super::graph::Graph;

/// Label of a vertex between the two parts, whose labels are 0 and 1.
pub(super) const SEPARATOR: u8 = 2;

/// Passes of the refinement. Measured: more leave no less fill.
const PASSES: usize = 4;

/// Moves without gain after which a pass ends. Measured: three times as many leave no less fill.
const PATIENCE: usize = 100;

/// Two parts of a graph that no edge joins, and the separator between them.
#[derive(Debug, Clone)]
pub(super) struct Separation {
    /// `#V`: 0, 1 or [`SEPARATOR`].
    pub(super) label: Vec<u8>,
    /// Weight of the vertices of each label.
    pub(super) weights: [u32; 3],
}

impl Separation {
    /// To be compared: what the larger part weighs above `most`, the weight of the separator, the imbalance.
    pub(super) fn cost(&self, most: u32) -> (u32, u32, u32) {
        let [a, b, separator] = self.weights;
        (a.max(b).saturating_sub(most), separator, a.abs_diff(b))
    }

    /// The same separation of the graph that was contracted.
    pub(super) fn project(&self, cluster_of: &[u32]) -> Self {
        Self { label: cluster_of.iter().map(|&cluster| self.label[cluster as usize]).collect(), weights: self.weights }
    }

    fn set(&mut self, vertex: u32, weight: u32, label: u8) {
        let old = std::mem::replace(&mut self.label[vertex as usize], label);
        self.weights[old as usize] -= weight;
        self.weights[label as usize] += weight;
    }
}

/// Room for refinements.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    /// Of each vertex of the separator, the weight of its neighbours in each part.
    beside: Vec<[u32; 2]>,
    /// The pass in which each vertex left the separator last.
    left_in: Vec<u32>,
    pass: u32,
    /// By the part to move to, gain and vertex of the moves; some are out of date.
    moves: [BinaryHeap<(i32, u32)>; 2],
    /// Vertices that changed their label in this pass, each move's vertex before those that it pulled.
    trail: Vec<u32>,
    /// Where each move begins in `trail`.
    marks: Vec<usize>,
}

/// A separation being changed.
struct Refinement<'a> {
    graph: &'a Graph,
    separation: &'a mut Separation,
    scratch: &'a mut Scratch,
}

/// A separation whose first part grows from a vertex until it outweighs the second.
pub(super) fn grow(graph: &Graph, seed: u32, scratch: &mut Scratch) -> Separation {
    let mut separation = Separation { label: vec![1; graph.size()], weights: [0, graph.total(), 0] };
    let mut growth = Refinement::new(graph, &mut separation, scratch);
    let mut seeds = std::iter::once(seed).chain(0..graph.size() as u32);
    while growth.separation.weights[0] < growth.separation.weights[1] {
        if let Some((_, vertex)) = growth.best(0) {
            growth.move_out(vertex, 0);
        } else if let Some(seed) = seeds.find(|&vertex| growth.separation.label[vertex as usize] == 1) {
            growth.pull_in(seed, 1);
        }
    }
    separation
}

/// Makes a separator lighter, and no part heavier than `most`, as far as single moves lead there.
pub(super) fn refine(graph: &Graph, separation: &mut Separation, most: u32, scratch: &mut Scratch) {
    let vertices = 0..graph.size() as u32;
    let mut separator: Vec<u32> = vertices.filter(|&v| separation.label[v as usize] == SEPARATOR).collect();
    for _ in 0..PASSES {
        let before = separation.cost(most);
        let mut refinement = Refinement::new(graph, separation, scratch);
        for &vertex in &separator {
            refinement.enter(vertex);
        }
        let after = refinement.pass(before, most);
        if after >= before {
            break;
        }
        separator.extend_from_slice(&scratch.trail);
        separator.sort_unstable();
        separator.dedup();
        separator.retain(|&vertex| separation.label[vertex as usize] == SEPARATOR);
    }
}

impl<'a> Refinement<'a> {
    fn new(graph: &'a Graph, separation: &'a mut Separation, scratch: &'a mut Scratch) -> Self {
        if scratch.beside.len() < graph.size() {
            scratch.beside.resize(graph.size(), [0; 2]);
            scratch.left_in.resize(graph.size(), 0);
        }
        scratch.pass += 1;
        scratch.moves.iter_mut().for_each(BinaryHeap::clear);
        scratch.trail.clear();
        scratch.marks.clear();
        Self { graph, separation, scratch }
    }

    /// Moves every vertex of the separator at most once, then returns to the best state met and its cost.
    fn pass(&mut self, mut best: (u32, u32, u32), most: u32) -> (u32, u32, u32) {
        let mut kept = 0;
        while self.scratch.marks.len() < kept + PATIENCE {
            let Some((vertex, to)) = self.next(most) else { break };
            self.move_out(vertex, to);
            let cost = self.separation.cost(most);
            if cost < best {
                (best, kept) = (cost, self.scratch.marks.len());
            }
        }
        self.roll_back(kept);
        best
    }

    /// The move to make: into the lighter part if the other is too heavy, else the one of most gain.
    fn next(&mut self, most: u32) -> Option<(u32, usize)> {
        let [a, b, _] = self.separation.weights;
        let lighter = usize::from(b < a);
        let moves = [self.best(0), self.best(1)];
        let first = match moves {
            [Some((gain_a, _)), Some((gain_b, _))] if gain_a != gain_b && a.max(b) <= most => {
                usize::from(gain_b > gain_a)
            }
            _ => lighter,
        };
        let fits = |&(vertex, to): &(u32, usize)| self.separation.weights[to] + self.graph.weight(vertex) <= most;
        [first, 1 - first].into_iter().filter_map(|to| moves[to].map(|(_, vertex)| (vertex, to))).find(fits)
    }

    /// The best move to a part, with its gain.
    fn best(&mut self, to: usize) -> Option<(i32, u32)> {
        while let Some(&(gain, vertex)) = self.scratch.moves[to].peek() {
            if self.is_free(vertex) && gain == self.gain(vertex, to) {
                return Some((gain, vertex));
            }
            self.scratch.moves[to].pop();
        }
        None
    }

    fn is_free(&self, vertex: u32) -> bool {
        self.separation.label[vertex as usize] == SEPARATOR
            && self.scratch.left_in[vertex as usize] != self.scratch.pass
    }

    /// By how much a move makes the separator lighter: the vertex leaves, its neighbours in the other part come.
    fn gain(&self, vertex: u32, to: usize) -> i32 {
        self.graph.weight(vertex) as i32 - self.scratch.beside[vertex as usize][1 - to] as i32
    }

    fn offer(&mut self, vertex: u32, to: usize) {
        if self.is_free(vertex) {
            let gain = self.gain(vertex, to);
            self.scratch.moves[to].push((gain, vertex));
        }
    }

    /// Offers the moves of a vertex that is in the separator now.
    fn enter(&mut self, vertex: u32) {
        let mut beside = [0; 3];
        for &other in self.graph.neighbours(vertex) {
            beside[self.separation.label[other as usize] as usize] += self.graph.weight(other);
        }
        self.scratch.beside[vertex as usize] = [beside[0], beside[1]];
        self.offer(vertex, 0);
        self.offer(vertex, 1);
    }

    /// Moves a vertex of a part into the separator.
    fn pull_in(&mut self, vertex: u32, from: usize) {
        let weight = self.graph.weight(vertex);
        self.separation.set(vertex, weight, SEPARATOR);
        self.scratch.trail.push(vertex);
        for &other in self.graph.neighbours(vertex) {
            if self.separation.label[other as usize] == SEPARATOR {
                self.scratch.beside[other as usize][from] -= weight;
                self.offer(other, 1 - from);
            }
        }
        self.enter(vertex);
    }

    /// Moves a vertex of the separator into a part, and its neighbours in the other part into the separator.
    fn move_out(&mut self, vertex: u32, to: usize) {
        let weight = self.graph.weight(vertex);
        self.separation.set(vertex, weight, to as u8);
        self.scratch.left_in[vertex as usize] = self.scratch.pass;
        self.scratch.marks.push(self.scratch.trail.len());
        self.scratch.trail.push(vertex);
        for &other in self.graph.neighbours(vertex) {
            let label = self.separation.label[other as usize];
            if label == SEPARATOR {
                self.scratch.beside[other as usize][to] += weight;
                self.offer(other, 1 - to);
            } else if label as usize != to {
                self.pull_in(other, 1 - to);
            }
        }
    }

    /// Takes all moves back but the first `kept`.
    fn roll_back(&mut self, kept: usize) {
        for &mark in self.scratch.marks[kept..].iter().rev() {
            let vertex = self.scratch.trail[mark];
            let to = self.separation.label[vertex as usize];
            for &pulled in &self.scratch.trail[mark + 1..] {
                self.separation.set(pulled, self.graph.weight(pulled), 1 - to);
            }
            self.separation.set(vertex, self.graph.weight(vertex), SEPARATOR);
            self.scratch.trail.truncate(mark);
        }
    }
}
