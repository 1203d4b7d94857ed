//! The body-centred cubic lattice: the corners of cubic cells and their centres. Each centre is joined to the corners of its cell
//! (short edges) and to the centres of the six cells beside it, each corner to its six neighbours (long edges). Around each edge
//! between centres lie four tetrahedra, which fill space.

use std::array;

use glam::DVec3;

/// Neighbours of a point.
pub const DIRECTIONS: usize = 14;

/// The first of them are along the axes: up x, y, z, then down.
const LONG: usize = 6;

/// Tetrahedra around the edges from a centre up the three axes.
const AROUND: usize = 12;

/// Cells along each side of a block, of which a `u128` has a bit a point.
pub const BLOCK: usize = 4;

/// The directions from each corner of a lattice tetrahedron to the others.
pub type Directions = [[usize; 4]; 4];

/// Whether the neighbours in a direction are joined by a long edge.
#[inline]
pub fn is_long(direction: usize) -> bool {
    direction < LONG
}

/// The direction back.
#[inline]
pub fn opposite(direction: usize) -> usize {
    if is_long(direction) { (direction + LONG / 2) % LONG } else { LONG + (7 - (direction - LONG)) }
}

/// A lattice tetrahedron relative to its first corner, a centre: what to add to the centre's number for each corner, and the
/// directions between them.
struct Tetrahedron {
    offsets: [isize; 4],
    directions: Directions,
}

/// Points of the lattice in a box, numbered along x, then y, then z, each cell's low corner before its centre.
pub struct Lattice {
    /// Of the corner 0.
    origin: DVec3,
    /// Side of a cell.
    pub side: f64,
    /// Cells along each axis.
    cells: [usize; 3],
    /// What to add to the number of a corner, or of a centre, to get that of its neighbour.
    offsets: [[isize; DIRECTIONS]; 2],
    tetrahedra: [Tetrahedron; AROUND],
}

impl Lattice {
    pub fn new(origin: DVec3, side: f64, cells: [usize; 3]) -> Self {
        let strides = [2, 2 * cells[0] as isize, 2 * (cells[0] * cells[1]) as isize];
        let offset = |is_centre: usize, direction: usize| {
            if direction < LONG {
                let stride = strides[direction % 3];
                return if direction < LONG / 2 { stride } else { -stride };
            }
            let bits = direction - LONG;
            let step = |axis: usize| strides[axis] * ((bits >> axis & 1) as isize + is_centre as isize - 1);
            step(0) + step(1) + step(2) + if is_centre == 1 { -1 } else { 1 }
        };
        let offsets = array::from_fn(|is_centre| array::from_fn(|direction| offset(is_centre, direction)));
        let tetrahedra = array::from_fn(|index| Tetrahedron::new(index / 4, index % 4, &offsets));
        Self { origin, side, cells, offsets, tetrahedra }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        2 * self.cells.iter().product::<usize>()
    }

    pub fn position(&self, point: usize) -> DVec3 {
        let shift = 0.5 * (point % 2) as f64;
        self.origin + self.side * DVec3::from(self.cell_of(point).map(|along| along as f64 + shift))
    }

    /// A place among those that are nearer to a point than to any other one, half a cell, for numbers from 0 to 1: evenly by volume.
    pub fn place_around(&self, point: usize, numbers: DVec3) -> DVec3 {
        let in_cube = numbers - 0.5;
        // In the cube around a point, the half beyond the octahedron is nearer to its corners.
        let is_near = in_cube.abs().element_sum() <= 0.75;
        let way = if is_near { in_cube } else { in_cube - 0.5 * in_cube.signum() };
        self.position(point) + self.side * way
    }

    /// The cell of a point, counted along each axis.
    fn cell_of(&self, point: usize) -> [usize; 3] {
        let [x, y, _] = self.cells;
        let cell = point / 2;
        [cell % x, cell / x % y, cell / (x * y)]
    }

    /// The first cells of the blocks that hold all points.
    pub fn blocks(&self) -> Vec<[usize; 3]> {
        let [x, y, z] = self.cells.map(|cells| (0..cells).step_by(BLOCK));
        z.flat_map(|k| {
            y.clone().flat_map({
                let x = x.clone();
                move |j| x.clone().map(move |i| [i, j, k])
            })
        })
        .collect()
    }

    /// Middle and radius of the ball around the points of so many cells along each side.
    pub fn ball(&self, first: [usize; 3], cells: usize) -> (DVec3, f64) {
        let half = 0.5 * (cells as f64 - 0.5);
        let middle = DVec3::from(first.map(|first| first as f64 + half));
        (self.origin + self.side * middle, self.side * half * 3.0_f64.sqrt())
    }

    /// The points of so many cells along each side of the box, as far as there are so many, each with its place in its block.
    pub fn points_of(&self, first: [usize; 3], cells: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let [x, y, z] = [0, 1, 2].map(|axis| first[axis]..self.cells[axis].min(first[axis] + cells));
        let all = z.flat_map(move |k| {
            let x = x.clone();
            y.clone().flat_map(move |j| x.clone().map(move |i| [i, j, k]))
        });
        all.flat_map(|[i, j, k]| {
            let bit = 2 * ((k % BLOCK * BLOCK + j % BLOCK) * BLOCK + i % BLOCK);
            let point = 2 * ((k * self.cells[1] + j) * self.cells[0] + i);
            [(bit, point), (bit + 1, point + 1)]
        })
    }

    /// The neighbour in a direction, of a point that is not in the outermost layer.
    #[inline]
    pub fn neighbour(&self, point: usize, direction: usize) -> usize {
        point.wrapping_add_signed(self.offsets[point % 2][direction])
    }

    /// Whether a point lacks neighbours.
    pub fn is_outermost(&self, point: usize) -> bool {
        self.cell_of(point).iter().zip(self.cells).any(|(&along, cells)| along == 0 || along + 1 == cells)
    }

    /// The other corners of the 24 tetrahedra at a point that has all neighbours, so that each is right-handed with the point before
    /// them.
    pub fn tetrahedra_around(&self, point: usize) -> impl Iterator<Item = [usize; 3]> + '_ {
        let corners = move |direction: usize, turn: usize| {
            let (axis, is_up) = (direction % 3, direction < LONG / 2);
            let [first, last] = [turn, turn + 1].map(|turn| self.neighbour(point, LONG + around(axis, is_up, turn)));
            let beyond = self.neighbour(point, direction);
            if is_up { [beyond, first, last] } else { [beyond, last, first] }
        };
        (0..LONG).flat_map(move |direction| (0..4).map(move |turn| corners(direction, turn)))
    }

    /// Calls `work` with the corners of each tetrahedron around the edges up from a centre, and the directions between them.
    #[inline]
    pub fn tetrahedra_at(&self, centre: usize, mut work: impl FnMut([usize; 4], &Directions)) {
        for tetrahedron in &self.tetrahedra {
            work(tetrahedron.offsets.map(|offset| centre.wrapping_add_signed(offset)), &tetrahedron.directions);
        }
    }

    /// The centres of the cells that are not in the outermost layer on the upper sides, in order.
    pub fn centres(&self) -> impl Iterator<Item = usize> + use<> {
        let [x, y, z] = self.cells;
        let rows = (0..z - 1).flat_map(move |k| (0..y - 1).map(move |j| (k * y + j) * x));
        rows.flat_map(move |row| (row..row + x - 1).map(|cell| 2 * cell + 1))
    }
}

impl Tetrahedron {
    /// Around the edge up an axis, the corners of the face between both cells taken from place `turn` of the ring on.
    fn new(axis: usize, turn: usize, offsets: &[[isize; DIRECTIONS]; 2]) -> Self {
        let [first, last] = [around(axis, true, turn), around(axis, true, turn + 1)];
        let changed = (first ^ last).ilog2() as usize;
        let along = if last > first { changed } else { changed + LONG / 2 };
        let below = |bits: usize| LONG + (bits & !(1 << axis));
        let mut directions = [[usize::MAX; 4]; 4];
        for (from, to, direction) in [
            (0, 1, axis),
            (0, 2, LONG + first),
            (0, 3, LONG + last),
            (1, 2, below(first)),
            (1, 3, below(last)),
            (2, 3, along),
        ] {
            directions[from][to] = direction;
            directions[to][from] = opposite(direction);
        }
        let offset = |to: usize| offsets[1][directions[0][to]];
        Self { offsets: [0, offset(1), offset(2), offset(3)], directions }
    }
}

/// The short directions to the points around the long edge up or down an axis, counter-clockwise seen from its upper end; as bits.
fn around(axis: usize, is_up: bool, turn: usize) -> usize {
    let [second, third] = [(axis + 1) % 3, (axis + 2) % 3];
    let (b, c) = [(0, 0), (1, 0), (1, 1), (0, 1)][turn % 4];
    usize::from(is_up) << axis | b << second | c << third
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use glam::DVec3;

    use super::{DIRECTIONS, Lattice, is_long, opposite};

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn neighbours_are_where_their_directions_lead() {
        let lattice = Lattice::new(DVec3::new(0.5, -1.0, 2.0), 2.0, [5, 6, 7]);
        for point in [2 * (2 + 5 * (3 + 6 * 2)), 2 * (1 + 5 * (2 + 6 * 4)) + 1] {
            for direction in 0..DIRECTIONS {
                let neighbour = lattice.neighbour(point, direction);
                assert_eq!(lattice.neighbour(neighbour, opposite(direction)), point);
                let length = lattice.position(point).distance(lattice.position(neighbour));
                assert!((length - if is_long(direction) { 2.0 } else { 3.0_f64.sqrt() }).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn places_around_a_point_are_nearest_to_it_and_everywhere() {
        let lattice = Lattice::new(DVec3::ZERO, 2.0, [5, 5, 5]);
        let point = 2 * (2 + 5 * (2 + 5 * 2));
        let mut sum = DVec3::ZERO;
        let steps = 20_u32;
        for k in 0..steps.pow(3) {
            let numbers = [k % steps, k / steps % steps, k / steps.pow(2)].map(|step| f64::from(step) + 0.5);
            let way = lattice.place_around(point, DVec3::from(numbers) / f64::from(steps)) - lattice.position(point);
            let others = (0..DIRECTIONS).map(|direction| lattice.neighbour(point, direction));
            let nearest = others.map(|other| way.distance(lattice.position(other) - lattice.position(point)));
            assert!(nearest.fold(f64::INFINITY, f64::min) >= way.length() - 1e-12);
            sum += way * way;
        }
        // The mean square of a coordinate over a truncated octahedron of volume 4 (Conway & Sloane 1982); steps of a twentieth miss 1/400.
        let mean = sum / f64::from(steps.pow(3));
        assert!((mean - 19.0 / 96.0).abs().max_element() < 2e-3, "{mean}");
    }

    #[test]
    fn tetrahedra_fill_the_cells() {
        let lattice = Lattice::new(DVec3::ZERO, 1.0, [4, 5, 6]);
        let (mut count, mut sum) = (0, 0.0);
        for centre in lattice.centres() {
            lattice.tetrahedra_at(centre, |corners, directions| {
                let [a, b, c, d] = corners.map(|corner| lattice.position(corner));
                let volume = (b - a).cross(c - a).dot(d - a) / 6.0;
                assert!((volume - 1.0 / 12.0).abs() < 1e-12, "{volume}");
                for (i, &corner) in corners.iter().enumerate() {
                    for j in (0..4).filter(|&j| j != i) {
                        assert_eq!(lattice.neighbour(corner, directions[i][j]), corners[j]);
                    }
                }
                count += 1;
                sum += volume;
            });
        }
        assert_eq!(count, 12 * 3 * 4 * 5);
        assert!((sum - 60.0).abs() < 1e-9);
    }

    #[test]
    fn tetrahedra_around_a_point_are_those_of_the_cells() {
        let lattice = Lattice::new(DVec3::ZERO, 1.0, [5, 6, 7]);
        let mut all = HashSet::new();
        for centre in lattice.centres() {
            lattice.tetrahedra_at(centre, |mut corners, _| {
                corners.sort_unstable();
                all.insert(corners);
            });
        }
        for point in (0..lattice.len()).filter(|&point| !lattice.is_outermost(point)) {
            let mut count = 0;
            for [a, b, c] in lattice.tetrahedra_around(point) {
                let [to_a, to_b, to_c] = [a, b, c].map(|other| lattice.position(other) - lattice.position(point));
                assert!((to_a.cross(to_b).dot(to_c) - 0.5).abs() < 1e-12, "right-handed");
                let mut corners = [point, a, b, c];
                corners.sort_unstable();
                assert!(all.contains(&corners));
                count += 1;
            }
            assert_eq!(count, 24);
        }
    }
}
