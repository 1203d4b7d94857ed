//! Cycles among the modules beside each other, on every level.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, VecDeque};

use super::arrows::Arrow;
use super::modules::Module;

/// A cycle among the children of one module, which is itself a node by the code of its own.
pub struct Cycle<'a> {
    pub parent: usize,
    pub steps: Vec<Step<'a>>,
}

/// Why one node comes after another.
pub struct Step<'a> {
    pub from: usize,
    pub to: usize,
    pub arrows: Vec<&'a Arrow>,
}

type Level<'a> = BTreeMap<usize, BTreeMap<usize, Vec<&'a Arrow>>>;

/// Cycles, such that no other is left once each has lost the step with the fewest arrows.
pub fn cycles<'a>(modules: &[Module], arrows: &'a [Arrow]) -> Vec<Cycle<'a>> {
    let mut levels: BTreeMap<usize, Level> = BTreeMap::new();
    for arrow in arrows {
        let (parent, from, to) = on_one_level(modules, arrow);
        levels.entry(parent).or_default().entry(from).or_default().entry(to).or_default().push(arrow);
    }
    let mut cycles = Vec::new();
    for (parent, mut level) in levels {
        while let Some(nodes) = shortest(&level) {
            let next = nodes.iter().copied().cycle().skip(1);
            let steps: Vec<Step> = std::iter::zip(nodes.iter().copied(), next)
                .map(|(from, to)| Step { from, to, arrows: level[&from][&to].clone() })
                .collect();
            if let Some(weakest) = steps.iter().min_by_key(|step| step.arrows.len()) {
                level.entry(weakest.from).or_default().remove(&weakest.to);
            }
            cycles.push(Cycle { parent, steps });
        }
    }
    cycles
}

/// The innermost module that holds both ends, and what the ends belong to there.
fn on_one_level(modules: &[Module], arrow: &Arrow) -> (usize, usize, usize) {
    let way_up = |module| {
        let mut way: Vec<usize> = std::iter::successors(Some(module), |&at: &usize| modules[at].parent).collect();
        way.reverse();
        way
    };
    let (from, to) = (way_up(arrow.from), way_up(arrow.to));
    let shared = std::iter::zip(&from, &to).take_while(|(from, to)| from == to).count();
    let parent = from[shared - 1];
    (parent, *from.get(shared).unwrap_or(&parent), *to.get(shared).unwrap_or(&parent))
}

/// The nodes of a shortest cycle, in its order.
fn shortest(level: &Level) -> Option<Vec<usize>> {
    level.keys().filter_map(|&start| around(level, start)).min_by_key(Vec::len)
}

/// The nodes of a shortest cycle through `start`, by breadth first.
fn around(level: &Level, start: usize) -> Option<Vec<usize>> {
    let mut came_from = BTreeMap::new();
    let mut queue = VecDeque::from([start]);
    while let Some(node) = queue.pop_front() {
        for &next in level.get(&node).into_iter().flat_map(BTreeMap::keys) {
            if next == start {
                let mut nodes: Vec<usize> =
                    std::iter::successors(Some(node), |at| came_from.get(at).copied()).collect();
                nodes.reverse();
                return Some(nodes);
            }
            if let Entry::Vacant(unseen) = came_from.entry(next) {
                unseen.insert(node);
                queue.push_back(next);
            }
        }
    }
    None
}
