//! Multilevel nested dissection: a small separator of the graph is eliminated last, its two sides before it, each
//! dissected in the same way. Separators are found on contracted graphs and refined on the way back.
//!
//! George, "Nested dissection of a regular finite element mesh" (1973); Karypis and Kumar, "A fast and high quality
//! multilevel scheme for partitioning irregular graphs" (1998); Hendrickson and Rothberg, "Improving the run time and
//! quality of nested dissection ordering" (1998).

mod graph;
mod leaf;
mod separator;
#[cfg(test)]
mod tests;

pub(crate) use graph::Graph;
use leaf::Leaves;
use separator::{SEPARATOR, Scratch, Separation};

use crate::pattern::Pattern;

/// Vertices up to which a part is ordered by minimum degree. Measured: smaller leaves cost time and leave no less fill.
const LEAF: usize = 256;

/// Vertices up to which a graph is not contracted further, and trials of growing a separator there.
const COARSEST: usize = 50;
const TRIALS: usize = 4;

/// Neighbours that follow a vertex into its cluster. With one, contracting takes longer and leaves no less fill.
const FOLLOWERS: usize = 3;

/// No cluster weighs more than this many times the mean of the coarsest graph, so that the parts can be balanced.
const HEAVIEST: f64 = 1.5;

/// Share of the vertices above which contracting has stalled, as at the hub of a star.
const STALLED: f64 = 0.9;

/// Share of the graph that a part may hold. Small separators count for more than even parts.
const BALANCE: f64 = 0.6;

/// An elimination order, the old number of each new one.
pub(crate) fn nested_dissection(graph: &Graph) -> Vec<u32> {
    dissected(graph, LEAF).order
}

fn dissected(graph: &Graph, leaf: usize) -> Dissection<'_> {
    let mut dissection = Dissection {
        whole: graph,
        leaf,
        scratch: Scratch::default(),
        leaves: Leaves::new(graph.size()),
        order: Vec::with_capacity(graph.size()),
        parts: Vec::new(),
    };
    let all: Vec<u32> = (0..graph.size() as u32).collect();
    dissection.dissect(graph, &all);
    dissection
}

/// A graph that is parted again and again by separators.
#[derive(Debug, Clone)]
pub struct Separators {
    /// The unknowns, each part in one piece: first its two sides, then its separator.
    pub order: Vec<u32>,
    /// In postorder, so that the sides of a part come before it, and the whole is last.
    pub parts: Vec<Part>,
}

/// A part of a graph: places in the order of [`Separators`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// Where its unknowns begin.
    pub start: usize,
    /// Where those of its separator begin. No edge joins two sides of the part; where it has none, all of it is its separator.
    pub separator: usize,
    /// Where both end.
    pub end: usize,
}

impl Separators {
    /// Those of the graph of a symmetric matrix, down to parts of `leaf` unknowns at most.
    #[must_use]
    pub fn of(pattern: &Pattern, leaf: usize) -> Self {
        let graph = Graph::of_lower_triangle(pattern);
        let Dissection { order, parts, .. } = dissected(&graph, leaf);
        Self { order, parts }
    }
}

struct Dissection<'a> {
    whole: &'a Graph,
    /// Vertices up to which a part is not dissected.
    leaf: usize,
    scratch: Scratch,
    leaves: Leaves,
    order: Vec<u32>,
    parts: Vec<Part>,
}

impl Dissection<'_> {
    /// Appends a part of the whole to the order. `vertices` are the part's numbers in the whole.
    fn dissect(&mut self, part: &Graph, vertices: &[u32]) {
        let start = self.order.len();
        if part.size() <= self.leaf {
            self.leaves.order(self.whole, vertices, &mut self.order);
            self.parts.push(Part { start, separator: start, end: self.order.len() });
            return;
        }
        let Separation { label, weights } = self.separate(part);
        assert!(weights[0].max(weights[1]) <= heaviest_part(part), "parts grow in steps of a cluster at most");
        let label = &label;
        let labelled = |wanted: u8| (0..part.size() as u32).filter(move |&v| label[v as usize] == wanted);
        for side in [0, 1] {
            let side: Vec<u32> = labelled(side).collect();
            let numbers: Vec<u32> = side.iter().map(|&v| vertices[v as usize]).collect();
            self.dissect(&part.part(&side), &numbers);
        }
        let separator = self.order.len();
        self.order.extend(labelled(SEPARATOR).map(|v| vertices[v as usize]));
        self.parts.push(Part { start, separator, end: self.order.len() });
    }

    fn separate(&mut self, graph: &Graph) -> Separation {
        let most = heaviest_part(graph);
        if graph.size() > COARSEST {
            let heaviest = (HEAVIEST * f64::from(graph.total()) / COARSEST as f64) as u32;
            let (coarse, cluster_of) = graph.contract(FOLLOWERS, heaviest);
            if coarse.size() as f64 <= STALLED * graph.size() as f64 {
                let mut separation = self.separate(&coarse).project(&cluster_of);
                separator::refine(graph, &mut separation, most, &mut self.scratch);
                return separation;
            }
        }
        let trial = |index: usize| {
            let seed = (index * graph.size() / TRIALS) as u32;
            let mut separation = separator::grow(graph, seed, &mut self.scratch);
            separator::refine(graph, &mut separation, most, &mut self.scratch);
            separation
        };
        let trials = (0..TRIALS).map(trial);
        trials.min_by_key(|separation| separation.cost(most)).unwrap_or_else(|| unreachable!("there are trials"))
    }
}

/// What a part of a graph may weigh.
fn heaviest_part(graph: &Graph) -> u32 {
    (BALANCE * f64::from(graph.total())) as u32
}
