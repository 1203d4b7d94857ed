//! Which parts of a surface are behind others in a picture.

use glam::{DVec2, DVec3};

/// Share of the depth of a picture, −1 to 1, by which a triangle must be nearer than a point to hide it: a point on a triangle is
/// off its plane by rounding.
const NEARER: f64 = 1e-6;

/// Places along a segment that are looked at first; a part that is hidden between two of them is not seen as such.
const SAMPLES: usize = 5;

/// Share of a segment by which the outer ones are away from its ends, which lie on edges of triangles that may hide them.
const INSET: f64 = 1e-6;

/// Halvings of the stretch in which a segment goes out of sight: a thousandth of a stretch is far below a pixel.
const HALVINGS: usize = 10;

/// Triangles in a picture, by the square cells that they are in.
pub(super) struct Occluders {
    /// Pixels, and depth toward the eye.
    corners: Vec<[DVec3; 3]>,
    /// Where the triangles of each cell begin, row by row.
    starts: Vec<u32>,
    triangles: Vec<u32>,
    cells: usize,
    size: DVec2,
}

impl Occluders {
    /// `size`: of the picture, in pixels.
    pub fn new(corners: Vec<[DVec3; 3]>, size: DVec2) -> Self {
        // As many cells as triangles.
        let cells = (corners.len() as f64).sqrt().ceil().max(1.0) as usize;
        let mut own = Self { corners, starts: vec![0; cells * cells + 1], triangles: Vec::new(), cells, size };
        for corners in &own.corners {
            for cell in covered(corners, cells, size) {
                own.starts[cell + 1] += 1;
            }
        }
        for cell in 0..cells * cells {
            own.starts[cell + 1] += own.starts[cell];
        }
        own.triangles = vec![0; own.starts[cells * cells] as usize];
        let mut next = own.starts.clone();
        for (triangle, corners) in own.corners.iter().enumerate() {
            for cell in covered(corners, cells, size) {
                own.triangles[next[cell] as usize] = triangle as u32;
                next[cell] += 1;
            }
        }
        own
    }

    /// The parts of a segment that nothing hides, as shares of it from its start.
    pub fn visible(&self, from: DVec3, to: DVec3) -> Vec<[f64; 2]> {
        let is_seen = |share: f64| !self.hides(from.lerp(to, share));
        let within = |share: f64| share.clamp(INSET, 1.0 - INSET);
        let shares: Vec<f64> = (0..SAMPLES).map(|index| within(index as f64 / (SAMPLES - 1) as f64)).collect();
        let seen: Vec<bool> = shares.iter().map(|&share| is_seen(share)).collect();
        let mut parts = Vec::new();
        let mut start = seen[0].then_some(0.0);
        for index in 1..SAMPLES {
            if seen[index] == seen[index - 1] {
                continue;
            }
            let [mut low, mut high] = [shares[index - 1], shares[index]];
            for _ in 0..HALVINGS {
                let middle = 0.5 * low + 0.5 * high;
                if is_seen(middle) == seen[index - 1] { low = middle } else { high = middle }
            }
            match start.take() {
                Some(start) => parts.push([start, low]),
                None => start = Some(high),
            }
        }
        parts.extend(start.map(|start| [start, 1.0]));
        parts
    }

    /// Whether a triangle is before a point.
    fn hides(&self, point: DVec3) -> bool {
        let [column, row] = cell_of(point, self.cells, self.size);
        let cell = row * self.cells + column;
        let [start, end] = [self.starts[cell], self.starts[cell + 1]].map(|at| at as usize);
        self.triangles[start..end].iter().any(|&triangle| is_before(&self.corners[triangle as usize], point))
    }
}

/// Whether a triangle covers a point and is nearer to the eye there.
fn is_before(corners: &[DVec3; 3], point: DVec3) -> bool {
    let [a, b, c] = corners.map(|corner| corner.truncate() - point.truncate());
    let areas = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)];
    let whole: f64 = areas.iter().sum();
    if whole == 0.0 || areas.iter().any(|&area| area * whole < 0.0) {
        return false;
    }
    let depth: f64 = corners.iter().zip(areas).map(|(corner, area)| corner.z * area / whole).sum();
    depth > point.z + NEARER
}

/// The cells that the box around a triangle touches.
fn covered(corners: &[DVec3; 3], cells: usize, size: DVec2) -> impl Iterator<Item = usize> + use<> {
    let [low, high] = [corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2])];
    let [[left, top], [right, bottom]] = [cell_of(low, cells, size), cell_of(high, cells, size)];
    (top..=bottom).flat_map(move |row| (left..=right).map(move |column| row * cells + column))
}

/// Column and row of the cell that a point is in; of the nearest one for a point outside the picture.
fn cell_of(point: DVec3, cells: usize, size: DVec2) -> [usize; 2] {
    let at = point.truncate() / size * cells as f64;
    [at.x, at.y].map(|at| (at.max(0.0) as usize).min(cells - 1))
}
