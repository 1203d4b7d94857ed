//! Lists of items at half-edges, in memory for those that have any.

/// A list for each half-edge.
#[derive(Debug)]
pub(super) struct Pool<T> {
    /// `3 #F`, the number of the half-edge's list; 0 where it has none.
    numbers: Vec<u32>,
    /// Number 0 is always empty.
    lists: Vec<Vec<T>>,
    /// Numbers of lists that no half-edge has.
    free: Vec<u32>,
}

impl<T> Pool<T> {
    pub fn new(halfedges: usize) -> Self {
        Self { numbers: vec![0; halfedges], lists: vec![Vec::new()], free: Vec::new() }
    }

    /// Whether a half-edge has none.
    pub fn is_empty(&self, halfedge: u32) -> bool {
        self.numbers[halfedge as usize] == 0
    }

    /// Takes the items of a half-edge out; `items` is empty before, and its memory is kept for later.
    pub fn take(&mut self, halfedge: u32, items: &mut Vec<T>) {
        let number = std::mem::take(&mut self.numbers[halfedge as usize]);
        if number != 0 {
            std::mem::swap(&mut self.lists[number as usize], items);
            self.free.push(number);
        }
    }

    /// Those of a half-edge, to be changed.
    pub fn at(&mut self, halfedge: u32) -> &mut Vec<T> {
        let number = &mut self.numbers[halfedge as usize];
        if *number == 0 {
            *number = self.free.pop().unwrap_or_else(|| {
                self.lists.push(Vec::new());
                self.lists.len() as u32 - 1
            });
        }
        &mut self.lists[*number as usize]
    }
}
