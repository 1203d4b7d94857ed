//! Fill-reducing orderings.
//!
//! Amestoy, Davis, Duff, "An approximate minimum degree ordering algorithm" (1996); Liu, "The role of elimination trees
//! in sparse factorization" (1990), sections 3 and 4, for the postorder.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use crate::dissection::{Graph, nested_dissection};
use crate::error::{Error, Result};
use crate::pattern::{NONE, Pattern};

#[cfg(test)]
mod tests;

/// Multiplications per unknown of a factorisation from which on nested dissection pays. It takes about as long as
/// minimum degree, roughly 20 000 multiplications' time per unknown, and saves about half of those of two factorisations.
const DISSECTION_PAYS: f64 = 10_000.0;

/// Unknowns from which on nested dissection is chosen unseen: it paid on both surfaces measured, and to find out takes
/// as long as to dissect.
const DISSECTION_CERTAIN: usize = 500_000;

/// An elimination order: a postorder of the elimination tree of the pattern that it was made for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Permutation {
    /// Old number of each new one.
    pub(crate) old_of_new: Vec<u32>,
    /// New number of each old one.
    pub(crate) new_of_old: Vec<u32>,
}

impl Permutation {
    /// Orders the unknowns of a pattern for little fill: by approximate minimum degree, or by nested dissection where that
    /// leaves much to do.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn fill_reducing(pattern: &Pattern) -> Result<Self> {
        let graph = Graph::of_lower_triangle(pattern);
        if pattern.size() < DISSECTION_CERTAIN {
            let (permutation, multiplications) = minimum_degree(pattern)?;
            if multiplications < DISSECTION_PAYS * pattern.size() as f64 {
                return Ok(postordered(&graph, &permutation));
            }
        }
        Ok(postordered(&graph, &Self::of_order(nested_dissection(&graph))))
    }

    /// The same for unknowns that were renumbered: minimum degree is a tie most of the time, and on a mesh that was refined
    /// level by level the order in which its vertices came leaves a tenth less fill than one along a curve. `numbering` has
    /// the row of each place in that order.
    ///
    /// # Errors
    /// As [`fill_reducing`](Self::fill_reducing), and as [`new`](Self::new) for `numbering`.
    pub fn fill_reducing_by(pattern: &Pattern, numbering: Vec<u32>) -> Result<Self> {
        let numbering = Self::checked(pattern.size(), numbering)?;
        let order = Self::fill_reducing(&pattern.renumbered(&numbering.new_of_old))?;
        Ok(Self::of_order(order.old_of_new.iter().map(|&row| numbering.old_of_new[row as usize]).collect()))
    }

    /// An order given as the row of each place. It becomes a postorder of the pattern's elimination tree, which has the
    /// same fill.
    ///
    /// # Errors
    /// [`Error::InvalidPermutation`] where it has not every row of the pattern once.
    pub fn new(pattern: &Pattern, old_of_new: Vec<u32>) -> Result<Self> {
        let order = Self::checked(pattern.size(), old_of_new)?;
        Ok(postordered(&Graph::of_lower_triangle(pattern), &order))
    }

    fn checked(size: usize, old_of_new: Vec<u32>) -> Result<Self> {
        let mut is_placed = vec![false; size];
        for (place, &row) in old_of_new.iter().enumerate() {
            match is_placed.get_mut(row as usize) {
                Some(is_placed) if !*is_placed => *is_placed = true,
                _ => return Err(Error::InvalidPermutation { place, size }),
            }
        }
        if old_of_new.len() < size {
            return Err(Error::InvalidPermutation { place: old_of_new.len(), size });
        }
        Ok(Self::of_order(old_of_new))
    }

    fn of_order(old_of_new: Vec<u32>) -> Self {
        let mut new_of_old = vec![0; old_of_new.len()];
        for (new, &old) in old_of_new.iter().enumerate() {
            new_of_old[old as usize] = new as u32;
        }
        Self { old_of_new, new_of_old }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.old_of_new.len()
    }

    /// Row of the matrix of each place in the elimination order.
    pub fn old_of_new(&self) -> &[u32] {
        &self.old_of_new
    }

    /// Place in the elimination order of each row of the matrix.
    pub fn new_of_old(&self) -> &[u32] {
        &self.new_of_old
    }
}

/// The pattern as faer takes it.
pub(crate) fn view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let size = pattern.size();
    SymbolicSparseColMatRef::new_checked(size, size, pattern.column_start(), None, pattern.rows())
}

/// The order, and a bound of the multiplications of a factorisation.
fn minimum_degree(pattern: &Pattern) -> Result<(Permutation, f64)> {
    let out_of_memory = || Error::OutOfMemory { stage: "ordering the unknowns" };
    let pattern = view(pattern);
    let size = pattern.nrows();
    let mut permutation = Permutation { old_of_new: vec![0; size], new_of_old: vec![0; size] };
    let scratch = amd::order_scratch::<u32>(size, pattern.compute_nnz());
    let mut memory = MemBuffer::try_new(scratch).map_err(|_| out_of_memory())?;
    // The rows of each column of a pattern are sorted, which this demands.
    let work = amd::order(
        &mut permutation.old_of_new,
        &mut permutation.new_of_old,
        pattern,
        amd::Control::default(),
        MemStack::new(&mut memory),
    )
    .map_err(|_| out_of_memory())?;
    Ok((permutation, work.n_mult_subs_ldl))
}

/// An order of the same fill in which every subtree of the elimination tree is consecutive, so that columns of the
/// same rows come together.
fn postordered(graph: &Graph, permutation: &Permutation) -> Permutation {
    let parent = elimination_tree(graph, permutation);
    let size = parent.len();
    let mut subtree = vec![1; size];
    for (vertex, &parent) in parent.iter().enumerate().filter(|&(_, &parent)| parent != NONE) {
        subtree[parent as usize] += subtree[vertex];
    }
    // Parents come after their children, so from the end each finds its place before its children ask for theirs: the last
    // child ends just before it, the others before that one's subtree.
    let mut end_of_roots = size as u32;
    let mut end_of_children = vec![0; size];
    let mut old_of_new = vec![0; size];
    for (vertex, &parent) in parent.iter().enumerate().rev() {
        let end = if parent == NONE { &mut end_of_roots } else { &mut end_of_children[parent as usize] };
        let place = *end - 1;
        *end -= subtree[vertex];
        end_of_children[vertex] = place;
        old_of_new[place as usize] = permutation.old_of_new[vertex];
    }
    Permutation::of_order(old_of_new)
}

/// The parent of each unknown, all in the elimination order: the row of the first entry below the diagonal in its
/// column of the factor, or [`NONE`].
fn elimination_tree(graph: &Graph, permutation: &Permutation) -> Vec<u32> {
    let size = graph.size();
    let mut parent = vec![NONE; size];
    // The furthest known ancestor, which shortens the ways to the root.
    let mut ancestor = vec![NONE; size];
    for (new, &old) in (0..).zip(&permutation.old_of_new) {
        for &neighbour in graph.neighbours(old) {
            let mut vertex = permutation.new_of_old[neighbour as usize];
            while vertex < new {
                let next = std::mem::replace(&mut ancestor[vertex as usize], new);
                if next == NONE {
                    parent[vertex as usize] = new;
                }
                vertex = next;
            }
        }
    }
    parent
}
