//! How far exact distances on quadrilaterals cut into triangles are from those on the smooth surface, by how they are cut:
//! `cargo run --release -p heatwalk-model --example quadrilaterals`

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use glam::{DVec3, dvec3};
use heatwalk::exact::exact_distance;
use heatwalk::{InputVertex, RelativeError, Soup, Surface, go_on};

/// Quadrilaterals along each side.
const CELLS: usize = 24;
/// How many times finer the surface is that they are compared with: its error is that many times that smaller.
const FINER: usize = 12;
/// Vertices that distances are measured from, as shares of the sides.
const SOURCES: [[usize; 2]; 3] = [[0, 0], [5, 9], [12, 12]];

type Point = fn(f64, f64) -> DVec3;

/// A patch over the unit square; whether it is closed along each side.
struct Patch {
    name: &'static str,
    at: Point,
    is_closed: [bool; 2],
}

const PATCHES: [Patch; 5] = [
    Patch { name: "torus", at: torus, is_closed: [true; 2] },
    Patch { name: "sphere patch", at: |u, v| sphere(PI * (u - 0.5), 0.8 * PI * (v - 0.5)), is_closed: [false; 2] },
    Patch {
        name: "saddle",
        at: |u, v| dvec3(2.0 * u - 1.0, (2.0 * u - 1.0) * (2.0 * v - 1.0), 2.0 * v - 1.0),
        is_closed: [false; 2],
    },
    Patch { name: "waves", at: waves, is_closed: [false; 2] },
    Patch { name: "waves in sheared cells", at: |u, v| waves(u + 0.6 * v, v), is_closed: [false; 2] },
];

fn torus(u: f64, v: f64) -> DVec3 {
    let (sin, cos) = (TAU * u).sin_cos();
    let (height, out) = (TAU * v).sin_cos();
    dvec3((1.0 + 0.4 * out) * cos, 0.4 * height, -(1.0 + 0.4 * out) * sin)
}

fn sphere(longitude: f64, latitude: f64) -> DVec3 {
    dvec3(latitude.cos() * longitude.cos(), latitude.sin(), -latitude.cos() * longitude.sin())
}

fn waves(u: f64, v: f64) -> DVec3 {
    dvec3(u, 0.15 * (5.0 * u).sin() * (4.0 * v).cos(), -v)
}

/// How a quadrilateral is cut: its corners in order, and which triangles.
#[derive(Clone, Copy)]
enum Cut {
    /// From the first corner to the third, as readers do; from the second to the fourth.
    First,
    Second,
    /// The shorter diagonal.
    Shorter,
    /// The one across which the triangles turn less.
    Flatter,
    /// Both in turn, as on a chessboard.
    Alternating,
    /// Four triangles around the mean of the corners.
    Middle,
}

impl Patch {
    /// Points on a grid, and its quadrilaterals cut.
    fn cut(&self, cells: usize, cut: Cut) -> Soup {
        let [columns, rows] = self.is_closed.map(|is_closed| if is_closed { cells } else { cells + 1 });
        let share = |k: usize| k as f64 / cells as f64;
        let mut positions: Vec<DVec3> = (0..columns)
            .flat_map(|i| (0..rows).map(move |j| (i, j)))
            .map(|(i, j)| (self.at)(share(i), share(j)))
            .collect();
        let vertex = |i: usize, j: usize| ((i % columns) * rows + j % rows) as u32;
        let mut triangles = Vec::new();
        for i in 0..cells {
            for j in 0..cells {
                let quad = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
                let [a, b, c, d] = quad;
                let [p, q, r, s] = quad.map(|corner| positions[corner as usize]);
                let turn = |diagonal: DVec3, one: DVec3, other: DVec3| {
                    let [m, n] = [diagonal.cross(one), other.cross(diagonal)].map(DVec3::normalize);
                    -m.dot(n)
                };
                let is_first = match cut {
                    Cut::First | Cut::Middle => true,
                    Cut::Second => false,
                    Cut::Shorter => p.distance(r) <= q.distance(s),
                    Cut::Flatter => turn(r - p, q - p, s - p) <= turn(s - q, r - q, p - q),
                    Cut::Alternating => (i + j) % 2 == 0,
                };
                if let Cut::Middle = cut {
                    let middle = positions.len() as u32;
                    positions.push(0.25 * (p + q + r + s));
                    triangles.extend([[a, b, middle], [b, c, middle], [c, d, middle], [d, a, middle]]);
                } else {
                    triangles.extend(if is_first { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
                }
            }
        }
        Soup::single(self.name, positions, triangles)
    }

    /// Distances at the points of the grid of `CELLS`, from one of them, on a grid so many times finer.
    fn distances(&self, finer: usize, cut: Cut, [i, j]: [usize; 2]) -> heatwalk::Result<Vec<f64>> {
        let cells = finer * CELLS;
        let [columns, rows] = self.is_closed.map(|is_closed| if is_closed { CELLS } else { CELLS + 1 });
        let fine_rows = if self.is_closed[1] { cells } else { cells + 1 };
        let at = |i: usize, j: usize| finer * (i * fine_rows + j);
        let surface = Arc::new(Surface::build(&self.cut(cells, cut))?);
        let found = exact_distance(&surface, &[InputVertex(at(i, j) as u32)], &mut go_on)?;
        let all = surface.to_inputs(&found, f64::INFINITY);
        Ok((0..columns).flat_map(|i| (0..rows).map(move |j| (i, j))).map(|(i, j)| all[at(i, j)]).collect())
    }
}

fn main() -> heatwalk::Result<()> {
    println!("mean / largest error of distances, in percent\n");
    println!(
        "| surface | file's diagonal | the other | mean of both | shorter | flatter | alternating | four triangles |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for patch in PATCHES {
        let mut errors = [[0.0, 0.0_f64]; 7];
        for source in SOURCES {
            let truth = patch.distances(FINER, Cut::Alternating, source)?;
            let by = |cut| patch.distances(1, cut, source);
            let (first, second) = (by(Cut::First)?, by(Cut::Second)?);
            let mean = first.iter().zip(&second).map(|(a, b)| 0.5 * (a + b)).collect();
            let others = [Cut::Shorter, Cut::Flatter, Cut::Alternating, Cut::Middle]
                .map(by)
                .into_iter()
                .collect::<Result<Vec<_>, _>>()?;
            for (error, found) in errors.iter_mut().zip([first, second, mean].into_iter().chain(others)) {
                let own = RelativeError::between(&found, &truth);
                error[0] += 100.0 * own.mean / SOURCES.len() as f64;
                error[1] = error[1].max(100.0 * own.max);
            }
        }
        let cells: Vec<String> = errors.iter().map(|[mean, most]| format!("{mean:.3} / {most:.2}")).collect();
        println!("| {} | {} |", patch.name, cells.join(" | "));
    }
    Ok(())
}
