//! A bounding volume hierarchy over the triangles of all components: component after component along a Morton curve, the
//! triangles of each along one of their own, in leaves of a few, under a complete tree (Lauterbach and others, "Fast BVH
//! construction on GPUs", 2009) whose nodes have as many children, so that all are compared at once (Dammertz, Hanika & Keller,
//! "Shallow bounding volume hierarchies", 2008). Nearly every box holds a single component.

use std::ops::Range;

use glam::DVec3;

use super::bounds::Bounds;
use super::boxes::{Boxes, WIDTH};
use super::scene::Scene;
use super::triangles::Triangle;
use crate::order::along_curve;
use crate::parallel;

/// Triangles of a leaf, but for the last one.
pub const LEAF: usize = WIDTH;

/// Nodes on the way from a block to a leaf.
const LEVELS_OF_BLOCK: u32 = 2;

/// Triangles of a block.
const BLOCK: usize = LEAF * WIDTH.pow(LEVELS_OF_BLOCK);

/// A triangle of the hierarchy.
#[derive(Clone, Copy)]
pub struct Item {
    pub corners: Triangle,
    /// Unit normal; zero where there is none.
    pub normal: DVec3,
    /// The least box that holds it.
    pub bounds: Bounds,
    /// Length of its longest side.
    pub longest: f64,
    pub face: u32,
    pub component: u32,
}

/// A box of the hierarchy.
#[derive(Clone, Copy)]
pub struct Node {
    pub bounds: Bounds,
    /// The greatest length of a triangle's longest side.
    pub longest: f64,
    /// The component of all its triangles, if they are of one.
    pub component: Option<u32>,
}

impl Node {
    fn around(self, other: Self) -> Self {
        Self {
            bounds: self.bounds.around(other.bounds),
            longest: self.longest.max(other.longest),
            component: self.component.filter(|_| self.component == other.component),
        }
    }
}

/// Triangles in groups of at most so many neighbours of one component.
fn groups(items: &[Item], most: usize) -> impl Iterator<Item = &[Item]> {
    items.chunks(most).flat_map(|leaf| leaf.chunk_by(|a, b| a.component == b.component))
}

/// What is below a node.
pub enum Below<'a> {
    Nodes(Range<usize>),
    Items(&'a [Item]),
}

/// The triangles of a scene in boxes.
pub struct Hierarchy {
    items: Vec<Item>,
    /// The root, then the children of node `i` from `4 i + 1` to `4 i + 4`, as far as there are nodes; the leaves come last.
    nodes: Vec<Node>,
    /// `#nodes`, the boxes of what is below each.
    boxes: Vec<Boxes>,
    /// How many nodes are no leaves.
    inner: usize,
}

impl Hierarchy {
    /// Of a scene that has triangles.
    pub fn new(scene: &Scene) -> Self {
        let centre = |component: usize| 0.5 * (scene.bounds[component].low + scene.bounds[component].high);
        let mut items = Vec::with_capacity(scene.surface.face_count());
        for component in along_curve(scene.bounds.len(), centre, parallel::ONE) {
            let faces = scene.faces_of(component as usize);
            let middle = |index: usize| scene.triangle(faces[index]).iter().sum();
            for index in along_curve(faces.len(), middle, parallel::ONE) {
                let face = faces[index as usize];
                let corners = scene.triangle(face);
                let normal = scene.normal(face);
                let bounds = Bounds::of_points(corners);
                items.push(Item { corners, normal, bounds, longest: scene.longest(face), face, component });
            }
        }
        let of_item =
            |item: &Item| Node { bounds: item.bounds, longest: item.longest, component: Some(item.component) };
        let leaves = items.chunks(LEAF).filter_map(|leaf| leaf.iter().map(of_item).reduce(Node::around));
        let leaf_count = items.len().div_ceil(LEAF);
        let inner = (leaf_count - 1).div_ceil(WIDTH - 1);
        let empty = Node { bounds: Bounds::EMPTY, longest: 0.0, component: None };
        let mut nodes = vec![empty; inner];
        nodes.extend(leaves);
        let mut hierarchy = Self { items, nodes, boxes: Vec::new(), inner };
        for node in (0..inner).rev() {
            let below = hierarchy.children(node);
            hierarchy.nodes[node] = below.map(|child| hierarchy.nodes[child]).reduce(Node::around).unwrap_or(empty);
        }
        let of_node = |node| match hierarchy.below(node) {
            Below::Nodes(children) => Boxes::new(children.map(|child| hierarchy.nodes[child].bounds)),
            Below::Items(items) => Boxes::new(items.iter().map(|item| item.bounds)),
        };
        hierarchy.boxes = (0..hierarchy.nodes.len()).map(of_node).collect();
        hierarchy
    }

    /// All triangles, in groups of at most [`LEAF`] neighbours of one component.
    pub fn groups(&self) -> impl Iterator<Item = &[Item]> {
        groups(&self.items, LEAF)
    }

    /// The same in blocks of at most [`BLOCK`] neighbours.
    pub fn blocks(&self) -> impl Iterator<Item = &[Item]> {
        groups(&self.items, BLOCK)
    }

    /// The same blocks in successive parts of so many.
    pub fn parts(&self, blocks: usize) -> impl Iterator<Item = impl Iterator<Item = &[Item]>> {
        self.items.chunks(BLOCK.saturating_mul(blocks)).map(|items| groups(items, BLOCK))
    }

    /// What the components of all triangles below a node have in common, by node.
    pub fn common<T: Copy + PartialEq>(&self, of: impl Fn(u32) -> T) -> Vec<Option<T>> {
        let mut common = vec![None; self.nodes.len()];
        for node in (0..self.nodes.len()).rev() {
            common[node] = match (self.below(node), self.nodes[node].component) {
                (_, Some(component)) => Some(of(component)),
                (Below::Nodes(children), None) => {
                    let first = common[children.start];
                    first.filter(|_| common[children].iter().all(|&other| other == first))
                }
                (Below::Items(items), None) => {
                    let mut values = items.iter().map(|item| of(item.component));
                    let first = values.next();
                    first.filter(|&first| values.all(|value| value == first))
                }
            };
        }
        common
    }

    /// A node; 0 is the root.
    #[inline]
    pub fn node(&self, node: usize) -> &Node {
        &self.nodes[node]
    }

    /// The boxes of what is below a node.
    #[inline]
    pub fn boxes(&self, node: usize) -> &Boxes {
        &self.boxes[node]
    }

    /// Whether there are no more triangles below a node than in a block.
    #[inline]
    pub fn is_block(&self, node: usize) -> bool {
        let level = |node: usize| ((WIDTH - 1) * node + 1).ilog(WIDTH);
        level(node) + LEVELS_OF_BLOCK >= level(self.nodes.len() - 1)
    }

    /// The nodes below a node that is no leaf.
    #[inline]
    fn children(&self, node: usize) -> Range<usize> {
        let first = WIDTH * node + 1;
        first..self.nodes.len().min(first + WIDTH)
    }

    /// What is below a node.
    #[inline]
    pub fn below(&self, node: usize) -> Below<'_> {
        if node < self.inner {
            return Below::Nodes(self.children(node));
        }
        let first = LEAF * (node - self.inner);
        Below::Items(&self.items[first..self.items.len().min(first + LEAF)])
    }
}
