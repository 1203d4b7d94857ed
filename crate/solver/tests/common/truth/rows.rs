//! Rectangles of rows of points, each two neighbours sewn together by triangles.

use glam::DVec2;

use super::Random;

/// How two rows are sewn together.
#[derive(Clone, Copy, PartialEq)]
pub enum Seam {
    /// By any triangles.
    Any,
    /// By quads of points that correspond, each cut by either of its diagonals.
    Quads,
}

/// A flat mesh that grows row by row. Each row ascends along x, from 0 to the same end.
#[derive(Default)]
pub struct Rows {
    pub points: Vec<DVec2>,
    pub triangles: Vec<[u32; 3]>,
    last: Vec<u32>,
}

impl Rows {
    /// A row at this height.
    pub fn push(&mut self, along: &[f64], height: f64, seam: Seam, random: &mut Random) {
        let first = self.points.len() as u32;
        self.points.extend(along.iter().map(|&x| DVec2::new(x, height)));
        self.sew((first..self.points.len() as u32).collect(), seam, random);
    }

    /// A row at the height of the last one, with which it shares its ends: the triangles between them have no area.
    pub fn push_again(&mut self, along: &[f64], random: &mut Random) {
        let [Some(&start), Some(&end)] = [self.last.first(), self.last.last()] else { return };
        let height = self.points[start as usize].y;
        let first = self.points.len() as u32;
        self.points.extend(along[1..along.len() - 1].iter().map(|&x| DVec2::new(x, height)));
        let row = [start].into_iter().chain(first..self.points.len() as u32).chain([end]).collect();
        self.sew(row, Seam::Any, random);
    }

    fn sew(&mut self, row: Vec<u32>, seam: Seam, random: &mut Random) {
        if let (Some(below), Some(above)) = (self.last.len().checked_sub(1), row.len().checked_sub(1)) {
            let (mut i, mut j) = (0, 0);
            while i < below || j < above {
                let is_below = match seam {
                    _ if i == below => false,
                    _ if j == above => true,
                    Seam::Quads if i != j => i < j,
                    _ => random.chance(0.5),
                };
                let (a, b) = (self.last[i], row[j]);
                let next = if is_below { self.last[i + 1] } else { row[j + 1] };
                if a != b && next != a && next != b {
                    self.triangles.push([a, next, b]);
                }
                (i, j) = if is_below { (i + 1, j) } else { (i, j + 1) };
            }
        }
        self.last = row;
    }
}
