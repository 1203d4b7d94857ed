//! Isosurface stuffing (Labelle & Shewchuk, "Isosurface stuffing: fast tetrahedral meshes with good dihedral angles", SIGGRAPH 2007),
//! with cells of one size.
//!
//! Lattice points that are too near to a point where the surface cuts one of their edges move there. The tetrahedra that the surface
//! still cuts are replaced by the stencils of figure 3. With the thresholds of table 1 all dihedral angles are between 9.31° and
//! 161.65°, however the surface runs. What is thinner than a cell is kept, too: points are pulled to it from outside.

use glam::DVec3;

use super::lattice::{DIRECTIONS, Lattice, is_long, opposite};
use super::quality::{dihedral_angles_of, volume};
use super::stencil::{Corner, Sign, split};
use crate::soup::TetSoup;

/// Shares of an edge within which a cut moves an end of it: α_long and α_short of table 1.
const LONG_THRESHOLD: f64 = 0.24999;
const SHORT_THRESHOLD: f64 = 0.41189;

/// Dihedral angles that these thresholds guarantee, in degrees; of table 1, too.
const LEAST_ANGLE: f64 = 9.31;
const GREATEST_ANGLE: f64 = 161.65;

/// Sides of a cell that a point may be pulled; more would gain little.
const REACH: f64 = 0.75;

/// No row, vertex or cut.
const NONE: u32 = u32::MAX;

/// A lattice point with the surface on some of its edges.
struct Row {
    point: usize,
    /// Share of the way along each edge, from this point, at which it is cut; infinite where it is not.
    cuts: [f64; DIRECTIONS],
    /// Vertices of the result at these cuts; of points inside.
    vertices: [u32; DIRECTIONS],
    /// Where the point moved to.
    moved: Option<DVec3>,
}

/// A lattice that is cut by a surface.
pub struct Stuffing<'a> {
    lattice: &'a Lattice,
    signs: Vec<Sign>,
    /// By point.
    row_of: Vec<u32>,
    rows: Vec<Row>,
}

impl<'a> Stuffing<'a> {
    /// `is_inside`: by lattice point; none in the outermost layer. `cuts`: of the edges from points inside to points outside, in the
    /// order of [`cut_edges`], the share of the way to the point outside.
    pub fn new(lattice: &'a Lattice, is_inside: &[bool], edges: &[(u32, u8)], cuts: &[f64]) -> Self {
        let sign = |&is_inside: &bool| if is_inside { Sign::Inside } else { Sign::Outside };
        let mut stuffing = Self {
            lattice,
            signs: is_inside.iter().map(sign).collect(),
            row_of: vec![NONE; lattice.len()],
            rows: Vec::new(),
        };
        for (&(point, direction), &share) in edges.iter().zip(cuts) {
            let (point, direction) = (point as usize, usize::from(direction));
            stuffing.row(point).cuts[direction] = share;
            stuffing.row(lattice.neighbour(point, direction)).cuts[opposite(direction)] = 1.0 - share;
        }
        stuffing
    }

    fn row(&mut self, point: usize) -> &mut Row {
        if self.row_of[point] == NONE {
            self.row_of[point] = self.rows.len() as u32;
            self.rows.push(Row { point, cuts: [f64::INFINITY; DIRECTIONS], vertices: [NONE; DIRECTIONS], moved: None });
        }
        &mut self.rows[self.row_of[point] as usize]
    }

    /// Moves points to the nearest cut that is too near to them. The edges of a point on the surface are not cut.
    pub fn warp(&mut self) {
        for index in 0..self.rows.len() {
            let row = &self.rows[index];
            let length = |direction: usize| if is_long(direction) { 1.0 } else { 0.75_f64.sqrt() };
            let threshold = |direction: usize| if is_long(direction) { LONG_THRESHOLD } else { SHORT_THRESHOLD };
            let near = (0..DIRECTIONS).filter(|&direction| row.cuts[direction] < threshold(direction));
            let distance = |direction: usize| row.cuts[direction] * length(direction);
            let Some(nearest) = near.min_by(|&a, &b| distance(a).total_cmp(&distance(b))) else { continue };
            let point = row.point;
            let cuts = row.cuts;
            let row = &mut self.rows[index];
            row.moved = Some(self.lattice.cut(point, nearest, cuts[nearest]));
            row.cuts = [f64::INFINITY; DIRECTIONS];
            self.signs[point] = Sign::Surface;
            for direction in (0..DIRECTIONS).filter(|&direction| cuts[direction].is_finite()) {
                let neighbour = self.row_of[self.lattice.neighbour(point, direction)];
                self.rows[neighbour as usize].cuts[opposite(direction)] = f64::INFINITY;
            }
        }
    }

    /// Whether a point is outside, beside none inside.
    pub fn is_apart(&self, point: usize) -> bool {
        let mut neighbours = (0..DIRECTIONS).map(|direction| self.lattice.neighbour(point, direction));
        self.signs[point] == Sign::Outside
            && !self.lattice.is_outermost(point)
            && neighbours.all(|neighbour| self.signs[neighbour] != Sign::Inside)
    }

    /// Moves those points that are [apart](Self::is_apart), after warping, by these ways to the surface, the shortest way first, where
    /// no tetrahedron turns over. What is thinner than a cell is then between tetrahedra's corners.
    pub fn pull(&mut self, points: &[usize], ways: &[DVec3]) {
        let longest = (REACH * self.lattice.side).powi(2);
        let is_pulled = |&index: &usize| ways[index].length_squared() <= longest && self.is_apart(points[index]);
        let mut order: Vec<usize> = (0..points.len()).filter(is_pulled).collect();
        order.sort_by(|&a, &b| ways[a].length_squared().total_cmp(&ways[b].length_squared()));
        for index in order {
            let point = points[index];
            let place = self.lattice.position(point) + ways[index];
            if !self.turns_over(point, place) {
                self.row(point).moved = Some(place);
                self.signs[point] = Sign::Surface;
            }
        }
    }

    /// Whether a tetrahedron would if a point were there.
    fn turns_over(&self, point: usize, place: DVec3) -> bool {
        let is_left_handed = |others: [usize; 3]| {
            let [a, b, c] = others.map(|other| self.place(other));
            volume([place, a, b, c]) <= 0.0
        };
        self.lattice.tetrahedra_around(point).any(is_left_handed)
    }

    /// The tetrahedra inside, and by vertex whether it is on the surface. Of those with all corners on the surface, signs do not tell:
    /// they are kept where `is_inside` says so of their lattice points and middle, and where they are as good as all others.
    pub fn tetrahedra(mut self, mut is_inside: impl FnMut([usize; 4], DVec3) -> bool) -> (TetSoup, Vec<bool>) {
        let mut soup = TetSoup::default();
        let mut is_on_surface = Vec::new();
        let mut vertex_of = vec![NONE; self.lattice.len()];
        let lattice = self.lattice;
        for centre in lattice.centres() {
            lattice.tetrahedra_at(centre, |corners, directions| {
                let signs = corners.map(|corner| self.signs[corner]);
                let is_on_sides = signs == [Sign::Surface; 4];
                if is_on_sides {
                    let places = corners.map(|corner| self.place(corner));
                    if !is_good(places) || !is_inside(corners, places.iter().sum::<DVec3>() / 4.0) {
                        return;
                    }
                }
                let mut add = |tetrahedron: [Corner; 4]| {
                    let vertices = tetrahedron.map(|corner| match corner {
                        Corner::Lattice(corner) => self.vertex(corners[corner], &mut vertex_of, &mut soup.positions),
                        Corner::Cut(inside, outside) => {
                            self.cut_vertex(corners[inside], directions[inside][outside], &mut soup.positions)
                        }
                    });
                    is_on_surface.resize(soup.positions.len(), false);
                    for (corner, vertex) in tetrahedron.into_iter().zip(vertices) {
                        let is_inside = matches!(corner, Corner::Lattice(corner) if signs[corner] == Sign::Inside);
                        is_on_surface[vertex as usize] = !is_inside;
                    }
                    soup.tetrahedra.push(vertices);
                };
                if is_on_sides {
                    add([0, 1, 2, 3].map(Corner::Lattice));
                } else {
                    split(signs, corners, directions, add);
                }
            });
        }
        (soup, is_on_surface)
    }

    /// Where a lattice point is now.
    fn place(&self, point: usize) -> DVec3 {
        let row = self.rows.get(self.row_of[point] as usize);
        row.and_then(|row| row.moved).unwrap_or_else(|| self.lattice.position(point))
    }

    fn vertex(&self, point: usize, vertex_of: &mut [u32], positions: &mut Vec<DVec3>) -> u32 {
        if vertex_of[point] == NONE {
            vertex_of[point] = positions.len() as u32;
            positions.push(self.place(point));
        }
        vertex_of[point]
    }

    fn cut_vertex(&mut self, point: usize, direction: usize, positions: &mut Vec<DVec3>) -> u32 {
        let row = &mut self.rows[self.row_of[point] as usize];
        if row.vertices[direction] == NONE {
            row.vertices[direction] = positions.len() as u32;
            positions.push(self.lattice.cut(point, direction, row.cuts[direction]));
        }
        row.vertices[direction]
    }
}

/// Whether a tetrahedron has volume, and angles within the bounds.
fn is_good(corners: [DVec3; 4]) -> bool {
    let [least, greatest] = dihedral_angles_of(corners);
    volume(corners) > 0.0 && least > LEAST_ANGLE.to_radians() && greatest < GREATEST_ANGLE.to_radians()
}

impl Lattice {
    /// The place so far along an edge.
    fn cut(&self, point: usize, direction: usize, share: f64) -> DVec3 {
        self.position(point).lerp(self.position(self.neighbour(point, direction)), share)
    }
}

/// The edges from points inside to points outside, in order of the points: point and direction.
pub fn cut_edges(lattice: &Lattice, is_inside: &[bool]) -> Vec<(u32, u8)> {
    let inside = (0..lattice.len()).filter(|&point| is_inside[point]);
    let edges = |point: usize| (0..DIRECTIONS as u8).map(move |direction| (point as u32, direction));
    let is_cut =
        |&(point, direction): &(u32, u8)| !is_inside[lattice.neighbour(point as usize, usize::from(direction))];
    inside.flat_map(edges).filter(is_cut).collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{Sign, Stuffing, cut_edges};
    use crate::fill::lattice::Lattice;
    use rand::{RngExt, SeedableRng};
    use rand_xoshiro::SplitMix64;

    use crate::fill::quality::{boundary, dihedral_angles, volume};
    use crate::soup::TetSoup;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// Whether faces of one tetrahedron are on the surface and close: each edge is of an even number of them.
    fn is_conforming(soup: &TetSoup, is_on_surface: &[bool]) -> bool {
        let faces = boundary(soup, &vec![true; soup.positions.len()]);
        if faces.as_flattened().iter().any(|&vertex| !is_on_surface[vertex as usize]) {
            return false;
        }
        let mut edges: Vec<[u32; 2]> = faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [a, c]]).collect();
        edges.sort_unstable();
        edges.chunk_by(|a, b| a == b).all(|same| same.len() % 2 == 0)
    }

    #[test]
    fn no_surface_makes_gaps_or_angles_worse_than_the_proven_bounds() {
        let lattice = Lattice::new(DVec3::ZERO, 1.0, [24, 24, 24]);
        let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
        for seed in 0..20 {
            let mut random = SplitMix64::seed_from_u64(seed);
            let mut random = || random.random::<f64>();
            let share = random();
            let is_inner = |point: usize| {
                lattice.position(point).cmpgt(DVec3::splat(1.75)).all()
                    && lattice.position(point).cmplt(DVec3::splat(22.0)).all()
            };
            let inside: Vec<bool> = (0..lattice.len()).map(|point| random() < share && is_inner(point)).collect();
            let edges = cut_edges(&lattice, &inside);
            // Cuts anywhere, at the thresholds, in the middle, and at the ends.
            let cut = |draw: f64, other: f64| match (draw * 5.0) as usize {
                0 => other,
                1 => 0.24999 + 0.00002 * (other - 0.5),
                2 => 0.75001 + 0.00002 * (other - 0.5),
                3 => 0.41189 + 0.00002 * (other - 0.5),
                _ => 0.58811 + 0.00002 * (other - 0.5),
            };
            let cuts: Vec<f64> = edges.iter().map(|_| cut(random(), random())).collect();
            let mut stuffing = Stuffing::new(&lattice, &inside, &edges, &cuts);
            stuffing.warp();
            let apart: Vec<usize> = (0..lattice.len()).filter(|&point| stuffing.is_apart(point)).collect();
            let way = |_: &usize| 0.8 * (DVec3::new(random(), random(), random()) - DVec3::splat(0.5));
            let ways: Vec<DVec3> = apart.iter().map(way).collect();
            stuffing.pull(&apart, &ways);
            let pulled: Vec<usize> =
                apart.into_iter().filter(|&point| stuffing.signs[point] == Sign::Surface).collect();
            assert!(!pulled.is_empty());
            for &point in &pulled {
                assert!(!stuffing.turns_over(point, stuffing.place(point)));
            }
            let (soup, is_on_surface) = stuffing.tetrahedra(|_, _| true);
            let flipped = soup
                .tetrahedra
                .iter()
                .filter(|tetrahedron| volume(tetrahedron.map(|corner| soup.positions[corner as usize])) <= 0.0)
                .count();
            assert_eq!(flipped, 0);
            assert!(is_conforming(&soup, &is_on_surface), "{seed}");
            let angles = dihedral_angles(&soup);
            least = least.min(angles[0]);
            greatest = greatest.max(angles[1]);
        }
        assert!(least.to_degrees() > 9.31 && greatest.to_degrees() < 161.65);
    }
}
