//! Parts of a surface and their separators, and where labels are.

use std::iter;
use std::ops::Range;

use heatwalk::sparse::Part;

/// In place of a number: there is none.
pub const NONE: u32 = u32::MAX;

/// A part: its separator in the order of all vertices, and how many labels there are above it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Node {
    pub parent: u32,
    pub separator: u32,
    pub end: u32,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Tree {
    /// In postorder: the whole is last.
    nodes: Vec<Node>,
    /// Of each node, where the labels of its separator begin in those of all vertices below.
    label_start: Vec<usize>,
    /// Of each place, the node whose separator it is in.
    node_of: Vec<u32>,
    /// `#places + 1`, where the labels of each place begin.
    start: Vec<usize>,
}

impl Tree {
    /// Of parts in postorder.
    pub fn of_parts(parts: &[Part]) -> Self {
        let mut nodes: Vec<Node> = Vec::with_capacity(parts.len());
        // Those without a parent so far.
        let mut open: Vec<usize> = Vec::new();
        for (number, part) in parts.iter().enumerate() {
            while let Some(&child) = open.last()
                && parts[child].start >= part.start
            {
                nodes[child].parent = number as u32;
                open.pop();
            }
            open.push(number);
            nodes.push(Node { parent: NONE, separator: part.separator as u32, end: part.end as u32 });
        }
        Self::of_nodes(nodes)
    }

    /// Of nodes in postorder, whose separators follow each other without gaps.
    pub fn of_nodes(nodes: Vec<Node>) -> Self {
        let mut label_start = vec![0; nodes.len()];
        for (number, node) in nodes.iter().enumerate().rev() {
            if node.parent != NONE {
                let parent = node.parent as usize;
                label_start[number] = label_start[parent] + length(&nodes[parent]);
            }
        }
        let (mut node_of, mut start) = (Vec::new(), vec![0]);
        for (number, node) in nodes.iter().enumerate() {
            let labels = label_start[number] + length(node);
            for _ in node.separator..node.end {
                node_of.push(number as u32);
                start.push(start[start.len() - 1] + labels);
            }
        }
        Self { nodes, label_start, node_of, start }
    }

    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The node whose separator has a place.
    pub fn part_of(&self, place: usize) -> usize {
        self.node_of[place] as usize
    }

    /// Of all places together.
    pub fn label_count(&self) -> usize {
        self.start[self.node_of.len()]
    }

    /// Where those of a place are.
    pub fn labels_of(&self, place: usize) -> Range<usize> {
        self.start[place]..self.start[place + 1]
    }

    /// Which of the labels of all places below is the distance to this one.
    pub fn label_of(&self, hub: usize) -> usize {
        let node = self.part_of(hub);
        self.label_start[node] + hub - self.nodes[node].separator as usize
    }

    /// The smallest part that has both places.
    pub fn common(&self, a: usize, b: usize) -> usize {
        let [mut a, mut b] = [a, b].map(|place| self.part_of(place));
        // Parents come after their children.
        while a != b {
            let lower = if a < b { &mut a } else { &mut b };
            *lower = self.nodes[*lower].parent as usize;
        }
        a
    }

    /// From a node to the whole: the labels of each, and the places of its separator.
    pub fn upward(&self, node: usize) -> impl Iterator<Item = (Range<usize>, Range<usize>)> {
        let parent = |&node: &usize| (self.nodes[node].parent != NONE).then_some(self.nodes[node].parent as usize);
        iter::successors(Some(node), parent).map(|node| {
            let Node { separator, end, .. } = self.nodes[node];
            let start = self.label_start[node];
            (start..start + (end - separator) as usize, separator as usize..end as usize)
        })
    }
}

fn length(node: &Node) -> usize {
    (node.end - node.separator) as usize
}
