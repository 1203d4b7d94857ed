//! Small shapes and measures for the solver's tests.
#![allow(dead_code, reason = "each test binary uses some of it")]

pub mod exact_distances;
pub mod media;
pub mod meshes;
pub mod pieces;
pub mod searches;
pub mod shortness;
pub mod truth;

use std::f64::consts::TAU;
use std::ops::Range;

use glam::DVec3;
use heatwalk::{
    Boundary, Distance, ExactRadius, HeatSolver, InputVertex, Parameters, Soup, Surface, TimeStep, VertexId, go_on,
};
use truth::Random;

pub fn soup(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Soup {
    Soup::single("test", positions, triangles)
}

/// Points in the plane z = 0.
pub fn flat(points: &[(f64, f64)]) -> Vec<DVec3> {
    points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect()
}

/// Band of `segments` quads around a circle of radius 2, with this many half twists: 0 a cylinder, 1 a Möbius strip.
pub fn band(segments: u32, half_twists: u32) -> Soup {
    let rows = 4;
    let mut positions = Vec::new();
    for segment in 0..segments {
        let angle = TAU * f64::from(segment) / f64::from(segments);
        let (sin, cos) = (angle * 0.5 * f64::from(half_twists)).sin_cos();
        for row in 0..=rows {
            let across = f64::from(row) / f64::from(rows) - 0.5;
            let radius = 2.0 + across * sin;
            positions.push(DVec3::new(radius * angle.cos(), radius * angle.sin(), across * cos));
        }
    }
    let vertex = |segment: u32, row: u32| {
        let is_mirrored = segment == segments && half_twists % 2 == 1;
        (segment % segments) * (rows + 1) + if is_mirrored { rows - row } else { row }
    };
    soup(positions, quads(0..segments, rows, vertex).collect())
}

/// Triangles of quads in columns and rows, whose corners in both `vertex` numbers.
pub fn quads(columns: Range<u32>, rows: u32, vertex: impl Fn(u32, u32) -> u32) -> impl Iterator<Item = [u32; 3]> {
    columns.flat_map(move |column| (0..rows).map(move |row| (column, row))).flat_map(move |(column, row)| {
        let [a, b] = [vertex(column, row), vertex(column + 1, row)];
        let [d, c] = [vertex(column, row + 1), vertex(column + 1, row + 1)];
        [[a, b, c], [a, c, d]]
    })
}

/// Triangles of `n × n` quads over rows of `n + 1` vertices that begin at `first`.
pub fn grid_triangles(first: u32, n: u32) -> impl Iterator<Item = [u32; 3]> {
    let corners = (0..n).flat_map(move |i| (0..n).map(move |j| first + i * (n + 1) + j));
    corners.flat_map(move |a| {
        let [b, c, d] = [a + n + 1, a + n + 2, a + 1];
        [[a, b, c], [a, c, d]]
    })
}

/// A soup made so many times as long along x.
pub fn stretched(mut soup: Soup, factor: f64) -> Soup {
    soup.positions.iter_mut().for_each(|position| position.x *= factor);
    soup
}

/// Triangles between random points: edges of many faces, faces through each other, points that hold only tips together.
pub fn any_triangles(points: usize, random: &mut Random) -> Soup {
    let positions = (0..points).map(|_| 0.5 * random.point()).collect();
    let triangles = (0..2 * points).map(|_| [(); 3].map(|()| random.below(points) as u32)).collect();
    soup(positions, triangles)
}

/// Surfaces of some random triangles.
pub fn for_any_triangles(seed: u64, mut try_surface: impl FnMut(&Surface, &mut Random)) {
    let mut random = Random::new(seed);
    for points in [5, 7, 9, 12, 20, 40] {
        for _ in 0..8 {
            try_surface(&surface(&any_triangles(points, &mut random)), &mut random);
        }
    }
}

/// `pages` rectangles of `n × n` quads joined along one edge on the z axis.
pub fn book(pages: u32, n: u32) -> Soup {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for page in 0..pages {
        let angle = TAU * f64::from(page) / f64::from(pages);
        let out = DVec3::new(angle.cos(), angle.sin(), 0.0);
        let first = positions.len() as u32;
        for i in 0..=n {
            for j in 0..=n {
                positions.push(out * f64::from(i) / f64::from(n) + DVec3::Z * f64::from(j) / f64::from(n));
            }
        }
        triangles.extend(grid_triangles(first, n));
    }
    soup(positions, triangles)
}

/// A square of side 1 in z = 0 of `n × n` quads, each cut into four at its middle, so that no direction is preferred.
pub fn square(n: u32) -> Soup {
    let mut positions = Vec::new();
    let at = |i: f64, j: f64| DVec3::new(i, j, 0.0) / f64::from(n);
    for i in 0..=n {
        positions.extend((0..=n).map(|j| at(f64::from(i), f64::from(j))));
    }
    let mut triangles = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let middle = positions.len() as u32;
            positions.push(at(f64::from(i) + 0.5, f64::from(j) + 0.5));
            let a = i * (n + 1) + j;
            let [b, c, d] = [a + n + 1, a + n + 2, a + 1];
            triangles.extend([[a, b, middle], [b, c, middle], [c, d, middle], [d, a, middle]]);
        }
    }
    soup(positions, triangles)
}

/// Two squares, one above the other, and the first vertex of the second.
pub fn two_squares(n: u32) -> (Soup, u32) {
    let (mut two, other) = (square(n), square(n));
    let first = two.positions.len() as u32;
    two.add(other.positions.iter().map(|&position| position + DVec3::Z), &other.triangles);
    (two, first)
}

/// What is done to a shape.
#[derive(Clone, Copy)]
pub struct Damage {
    /// How far vertices move, in the file's unit.
    pub jitter: f64,
    /// What the y axis shrinks to.
    pub squeeze: f64,
    /// Share of the triangles that are torn out.
    pub tear: f64,
}

/// A shape bent, squeezed and torn by random numbers: slivers, saddles, holes, several pieces.
pub fn damaged(mut soup: Soup, seed: u64, Damage { jitter, squeeze, tear }: Damage) -> Soup {
    let mut random = Random::new(seed);
    for position in &mut soup.positions {
        *position += 0.5 * jitter * random.point();
        position.y *= squeeze;
    }
    soup.triangles.retain(|_| !random.chance(tear));
    if soup.triangles.is_empty() {
        soup.triangles.push([0, 1, 2]);
    }
    self::soup(soup.positions, soup.triangles)
}

pub fn surface(soup: &Soup) -> Surface {
    Surface::build(soup).expect("a usable test shape")
}

/// The heat method alone, without an exact region.
pub fn heat_only(time_factor: f64, boundary: Boundary) -> Parameters {
    let time_step = TimeStep::Factor(time_factor);
    Parameters { time_step, boundary, exact_radius: ExactRadius::Edges(0.0), ..Parameters::default() }
}

pub fn solver_with(soup: &Soup, parameters: Parameters) -> HeatSolver {
    HeatSolver::new(surface(soup), parameters, &mut go_on).expect("factors")
}

pub fn solver(soup: &Soup, time_factor: f64, boundary: Boundary) -> HeatSolver {
    solver_with(soup, heat_only(time_factor, boundary))
}

/// From a vertex of the soup.
pub fn distance_from(soup: &Soup, vertex: u32) -> (HeatSolver, Distance) {
    let solver = solver(soup, 1.0, Boundary::Neumann);
    let source = solver.surface().vertex_of_input(InputVertex(vertex)).expect("a vertex in use");
    let distance = solver.distance(&[source]).expect("a valid source");
    (solver, distance)
}

/// The vertex nearest to a position.
pub fn nearest(surface: &Surface, position: DVec3) -> VertexId {
    let distance = |&vertex: &VertexId| surface.position(vertex).distance_squared(position);
    surface.vertices().min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("vertices")
}
