//! A bounding volume hierarchy over the triangles of all components: component after component along a Morton curve, the
//! triangles of each along one of their own, under a tree of as many children as triangles a leaf, so that all are compared at
//! once (Dammertz, Hanika & Keller, "Shallow bounding volume hierarchies", 2008). Nearly every box holds a single component.

use std::ops::Range;

use glam::DVec3;
use heatwalk_base::parallel;

use super::boxes::{Boxes, WIDTH};
use super::scene::Scene;
use super::triangles::Triangle;
use crate::index::{Below, Bounds, Tree, along_curve};

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

/// The triangles of a scene in boxes.
pub struct Hierarchy {
    items: Vec<Item>,
    tree: Tree<WIDTH, LEAF>,
    nodes: Vec<Node>,
    /// `#nodes`, the boxes of what is below each.
    boxes: Vec<Boxes>,
}

impl Hierarchy {
    /// Of a scene that has triangles.
    pub fn new(scene: &Scene) -> Self {
        let centre = |component: usize| scene.bounds[component].middle();
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
        let of_leaf = |leaf: &[Item]| leaf.iter().map(of_item).reduce(Node::around).expect("no leaf is empty");
        let tree = Tree::new(items.len());
        let nodes = tree.values(|leaf| of_leaf(&items[leaf]), Node::around);
        let boxes_below = |node| match tree.below(node) {
            Below::Nodes(children) => Boxes::new(nodes[children].iter().map(|node| node.bounds)),
            Below::Items(below) => Boxes::new(items[below].iter().map(|item| item.bounds)),
        };
        let boxes = (0..nodes.len()).map(boxes_below).collect();
        Self { items, tree, nodes, boxes }
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
        let join = |one: Option<T>, other| one.filter(|_| one == other);
        let of_leaf = |leaf: Range<usize>| self.items[leaf].iter().map(|item| Some(of(item.component))).reduce(join)?;
        self.tree.values(of_leaf, join)
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

    /// What is below a node.
    #[inline]
    pub fn below(&self, node: usize) -> Below {
        self.tree.below(node)
    }

    /// The triangles of a leaf.
    #[inline]
    pub fn items(&self, leaf: Range<usize>) -> &[Item] {
        &self.items[leaf]
    }
}
