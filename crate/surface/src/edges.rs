//! Which half-edges of a triangle list lie on the same edge, and which triangles to turn so that neighbours agree.

use crate::csr::{Csr, NONE};
use crate::halfedge::Halfedge;

/// The edges of a triangle list. Half-edge `3 f + k` runs from corner `k` of face `f` to the next corner.
#[derive(Debug, Clone)]
pub struct Edges {
    /// `3 #F`, the next half-edge of the same edge, of either direction. Those of an edge form a cycle, ascending up to
    /// the step from the last to the first.
    beside: Vec<u32>,
}

impl Edges {
    /// Finds the half-edges between the same points. `corners` lists the corners `3 f + k` at each point.
    pub fn new(faces: &[[u32; 3]], corners: &Csr) -> Self {
        let mut beside: Vec<u32> = (0..3 * faces.len() as u32).collect();
        // Per point the lower one that it was last met from, and the latest half-edge between the two.
        let mut latest = vec![[NONE; 2]; corners.rows().len()];
        for (point, row) in corners.rows().enumerate() {
            for &corner in row {
                let (face, k) = (corner / 3, corner % 3);
                let before = (k + 2) % 3;
                let points = faces[face as usize];
                for (other, halfedge) in
                    [(points[(k as usize + 1) % 3], corner), (points[before as usize], 3 * face + before)]
                {
                    if other as usize <= point {
                        continue;
                    }
                    let [from, last] = std::mem::replace(&mut latest[other as usize], [point as u32, halfedge]);
                    if from as usize == point {
                        beside[halfedge as usize] = std::mem::replace(&mut beside[last as usize], halfedge);
                    }
                }
            }
        }
        Self { beside }
    }

    /// The next half-edge of the same edge, the given one where it is alone.
    pub fn beside(&self, halfedge: u32) -> u32 {
        self.beside[halfedge as usize]
    }

    /// The half-edges of the same edge, from the given one on.
    pub fn around(&self, halfedge: u32) -> impl Iterator<Item = u32> + '_ {
        let next = move |&at: &u32| Some(self.beside[at as usize]).filter(|&next| next != halfedge);
        std::iter::successors(Some(halfedge), next)
    }

    /// The last half-edge of each edge.
    pub fn lasts(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        (0..self.beside.len() as u32).filter(|&halfedge| self.beside[halfedge as usize] <= halfedge)
    }

    /// Whether the edge has one face only.
    pub fn is_single(&self, halfedge: u32) -> bool {
        self.beside[halfedge as usize] == halfedge
    }

    /// The other half-edge of the same edge where exactly two faces meet.
    pub fn mate(&self, halfedge: u32) -> Option<u32> {
        let next = self.beside[halfedge as usize];
        (next != halfedge && self.beside[next as usize] == halfedge).then_some(next)
    }

    /// Whether the edge has three faces or more.
    pub fn is_branching(&self, halfedge: u32) -> bool {
        !self.is_single(halfedge) && self.mate(halfedge).is_none()
    }

    /// The faces whose three points an earlier face has, in any order; ascending.
    pub fn duplicates(&self, faces: &[[u32; 3]]) -> Vec<u32> {
        let apex = |halfedge: u32| faces[halfedge as usize / 3][(halfedge as usize + 2) % 3];
        let mut duplicates = Vec::new();
        let mut apexes: Vec<(u32, u32)> = Vec::new();
        for last in self.lasts().filter(|&last| !self.is_single(last)) {
            if let Some(first) = self.mate(last) {
                if apex(first) == apex(last) {
                    duplicates.push(last / 3);
                }
                continue;
            }
            apexes.clear();
            apexes.extend(self.around(last).map(|halfedge| (apex(halfedge), halfedge / 3)));
            apexes.sort_unstable();
            duplicates.extend(apexes.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1));
        }
        duplicates.sort_unstable();
        duplicates.dedup();
        duplicates
    }

    /// The edges of the faces that are kept, in their order.
    pub fn kept(&self, is_kept: &[bool]) -> Self {
        let mut count = 0;
        let mut first_of_face = Vec::with_capacity(is_kept.len());
        for &is_kept in is_kept {
            first_of_face.push(count);
            count += 3 * u32::from(is_kept);
        }
        let is_kept = |halfedge: u32| is_kept[halfedge as usize / 3];
        let next_kept = |halfedge: u32| {
            let mut next = self.beside[halfedge as usize];
            while !is_kept(next) {
                next = self.beside[next as usize];
            }
            first_of_face[next as usize / 3] + next % 3
        };
        Self { beside: (0..self.beside.len() as u32).filter(|&halfedge| is_kept(halfedge)).map(next_kept).collect() }
    }

    /// The edges after corners 1 and 2 of some faces changed places.
    pub fn turned(&self, is_turned: impl Fn(u32) -> bool) -> Self {
        let place = |halfedge: u32| {
            let k = halfedge % 3;
            if is_turned(halfedge / 3) { halfedge - k + (2 - k) } else { halfedge }
        };
        Self { beside: (0..self.beside.len() as u32).map(|slot| place(self.beside[place(slot) as usize])).collect() }
    }

    /// The faces to turn so that as many neighbours as possible agree, the fewer in each connected piece.
    pub fn faces_to_turn(&self, faces: &[[u32; 3]]) -> Vec<u32> {
        let disagrees = |last: u32| self.mate(last).is_some_and(|mate| same_direction(faces, last, mate));
        if !self.lasts().any(disagrees) {
            return Vec::new();
        }
        let mut turned: Vec<Option<bool>> = vec![None; faces.len()];
        let mut piece: Vec<u32> = Vec::new();
        let mut result = Vec::new();
        for start in 0..faces.len() {
            if turned[start].is_some() {
                continue;
            }
            piece.clear();
            piece.push(start as u32);
            turned[start] = Some(false);
            let mut done = 0;
            let mut turns = 0;
            while done < piece.len() {
                let face = piece[done];
                done += 1;
                let turn = turned[face as usize] == Some(true);
                turns += usize::from(turn);
                for halfedge in face * 3..face * 3 + 3 {
                    let Some(mate) = self.mate(halfedge) else { continue };
                    if turned[mate as usize / 3].is_none() {
                        turned[mate as usize / 3] = Some(turn ^ same_direction(faces, halfedge, mate));
                        piece.push(mate / 3);
                    }
                }
            }
            let minority = turns * 2 <= piece.len();
            result.extend(piece.iter().copied().filter(|&face| turned[face as usize] == Some(minority)));
        }
        result
    }

    /// Twin of each half-edge: its mate where the two run in opposite directions, else [`NONE`].
    pub fn twins(&self, faces: &[[u32; 3]]) -> Vec<Halfedge> {
        let twin = |halfedge: u32| {
            let mate = self.mate(halfedge).filter(|&mate| !same_direction(faces, halfedge, mate));
            Halfedge(mate.unwrap_or(NONE))
        };
        (0..self.beside.len() as u32).map(twin).collect()
    }
}

/// Whether two half-edges of one edge leave the same point.
fn same_direction(faces: &[[u32; 3]], a: u32, b: u32) -> bool {
    let origin = |halfedge: u32| faces[halfedge as usize / 3][halfedge as usize % 3];
    origin(a) == origin(b)
}
