//! Matrices of small meshes, for tests.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::conjugate_gradients::ConjugateGradients;
use crate::matrix::SymmetricMatrix;
use crate::ordering::Permutation;
use crate::pattern::Pattern;
use crate::progress::go_on;
use crate::scalar::Scalar;
use crate::symbolic::Symbolic;
use crate::system::System;
use faer::c64;

type Vector = [f64; 3];

/// Triangles in space.
#[derive(Debug, Clone, Default)]
pub(crate) struct Mesh {
    positions: Vec<Vector>,
    triangles: Vec<[u32; 3]>,
    /// A vertex of each component.
    grounded: Vec<u32>,
}

impl Mesh {
    /// Squares, each cut by one diagonal; `shear` makes their triangles obtuse, `stretch` thin.
    pub(crate) fn grid(columns: u32, rows: u32, shear: f64, stretch: f64) -> Self {
        let at = |x: u32, y: u32| y * (columns + 1) + x;
        let squares = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        let position = |index: u32| {
            let [x, y] = [index % (columns + 1), index / (columns + 1)].map(f64::from);
            [stretch * x + shear * y, y, 0.0]
        };
        Self {
            positions: (0..(columns + 1) * (rows + 1)).map(position).collect(),
            triangles: squares
                .flat_map(|(x, y)| {
                    let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
                    [[a, b, c], [a, c, d]]
                })
                .collect(),
            grounded: vec![0],
        }
    }

    /// An icosahedron whose triangles are cut in four so many times, on the unit sphere.
    pub(crate) fn icosphere(subdivisions: usize) -> Self {
        let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
        let mut positions: Vec<Vector> = Vec::new();
        for [a, b] in [[1.0, golden], [-1.0, golden], [1.0, -golden], [-1.0, -golden]] {
            positions.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]].map(unit));
        }
        let is_edge = |a: usize, b: usize| length(difference(positions[a], positions[b])) < 1.1;
        let mut triangles: Vec<[u32; 3]> = Vec::new();
        for a in 0..12 {
            for b in a + 1..12 {
                triangles.extend(
                    (b + 1..12)
                        .filter(|&c| is_edge(a, b) && is_edge(b, c) && is_edge(a, c))
                        .map(|c| [a, b, c].map(|v| v as u32)),
                );
            }
        }
        for _ in 0..subdivisions {
            let mut middles: BTreeMap<[u32; 2], u32> = BTreeMap::new();
            let mut middle = |a: u32, b: u32| {
                *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    let [p, q] = [a, b].map(|v| positions[v as usize]);
                    positions.push(unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]]));
                    positions.len() as u32 - 1
                })
            };
            triangles = triangles
                .iter()
                .flat_map(|&[a, b, c]| {
                    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
                })
                .collect();
        }
        Self { positions, triangles, grounded: vec![0] }
    }

    /// Both meshes as one that is not connected.
    pub(crate) fn beside(mut self, other: &Self) -> Self {
        let first = self.positions.len() as u32;
        self.positions.extend(&other.positions);
        self.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + first)));
        self.grounded.extend(other.grounded.iter().map(|vertex| vertex + first));
        self
    }

    /// The cotan Laplacian, constrained at a vertex of each component.
    pub(crate) fn poisson(&self) -> SymmetricMatrix {
        self.matrix(0.0, &self.grounded.iter().copied().collect())
    }

    /// The lumped mass divided by the mean edge squared plus the cotan Laplacian, constrained at the boundary.
    pub(crate) fn heat(&self) -> SymmetricMatrix {
        let mut faces: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        for [_, i, j] in self.corners() {
            *faces.entry([i.min(j), i.max(j)]).or_default() += 1;
        }
        let edge = |&[i, j]: &[u32; 2]| length(difference(self.positions[i as usize], self.positions[j as usize]));
        let mean_edge = faces.keys().map(edge).sum::<f64>() / faces.len() as f64;
        let boundary = faces.iter().filter(|&(_, &count)| count == 1).flat_map(|(&ends, _)| ends);
        self.matrix(mean_edge.powi(-2), &boundary.collect())
    }

    /// Each corner of each triangle with the two others.
    fn corners(&self) -> impl Iterator<Item = [u32; 3]> {
        self.triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]])
    }

    fn matrix(&self, mass_scale: f64, constrained: &BTreeSet<u32>) -> SymmetricMatrix {
        let mut entries: BTreeMap<[u32; 2], f64> = BTreeMap::new();
        for [corner, i, j] in self.corners() {
            let [p, q, r] = [corner, i, j].map(|vertex| self.positions[vertex as usize]);
            let (a, b) = (difference(q, p), difference(r, p));
            let twice_area = length(cross(a, b));
            let weight = 0.5 * dot(a, b) / twice_area;
            *entries.entry([corner; 2]).or_default() += mass_scale * twice_area / 6.0;
            *entries.entry([i; 2]).or_default() += weight;
            *entries.entry([j; 2]).or_default() += weight;
            *entries.entry([i.min(j), i.max(j)]).or_default() -= weight;
        }
        for (&[column, row], value) in &mut entries {
            if constrained.contains(&column) || constrained.contains(&row) {
                *value = f64::from(u8::from(column == row));
            }
        }
        assemble(self.positions.len(), &entries)
    }
}

/// The matrix of these values by column and row.
pub(crate) fn assemble<T: Copy>(size: usize, entries: &BTreeMap<[u32; 2], T>) -> SymmetricMatrix<T> {
    let mut column_start = vec![0; size + 1];
    for [column, _] in entries.keys() {
        column_start[*column as usize + 1] += 1;
    }
    for column in 0..size {
        column_start[column + 1] += column_start[column];
    }
    let rows = entries.keys().map(|&[_, row]| row).collect();
    let pattern = Arc::new(Pattern::new(column_start, rows).expect("a pattern"));
    SymmetricMatrix::new(pattern, entries.values().copied().collect()).expect("values of the pattern")
}

/// The matrix by both solvers, with what their solutions of size 1 may differ by: rounding, and the residual at which
/// conjugate gradients stop, by condition numbers of some 10 to 100.
pub(crate) fn both_systems<T: Scalar>(matrix: &SymmetricMatrix<T>) -> [(System<T>, f64); 2] {
    let permutation = Permutation::fill_reducing(matrix.pattern()).expect("memory");
    let symbolic = Arc::new(Symbolic::analyse(matrix.pattern(), permutation).expect("memory"));
    let [factor] = symbolic.factor([matrix], &mut go_on).expect("positive definite");
    let iterative = ConjugateGradients::new(matrix.clone());
    [(System::cholesky(factor), 1e-12), (System::ConjugateGradients(iterative), 1e-9)]
}

/// The Hermitian matrix of a grid, whose couplings turn by angles that differ from edge to edge.
pub(crate) fn hermitian(side: u32, turn: f64) -> SymmetricMatrix<c64> {
    let mut entries = BTreeMap::new();
    for vertex in 0..side * side {
        entries.insert([vertex; 2], c64::new(4.1, 0.0));
        let right = (vertex % side + 1 < side).then_some(vertex + 1);
        for other in right.into_iter().chain((vertex + side < side * side).then_some(vertex + side)) {
            entries.insert([vertex, other], -c64::cis(turn * f64::from(vertex + 3 * other)));
        }
    }
    assemble((side * side) as usize, &entries)
}

/// Numbers of absolute value 1, each turned by an angle from the one before.
pub(crate) fn unit_numbers(count: usize, step: f64) -> Vec<c64> {
    (0..count).map(|index| c64::cis(step * index as f64)).collect()
}

/// Values between −1 and 1 that repeat late.
pub(crate) fn right_side(size: usize) -> Vec<f64> {
    (0..size).map(|row| (row as f64 * 1.7).sin()).collect()
}

fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: Vector) -> Vector {
    a.map(|coordinate| coordinate / length(a))
}
