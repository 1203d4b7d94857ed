//! What the methods answer on a mesh whose distances are known.

use heatwalk::surface::Error as SurfaceError;
use heatwalk::{DistanceOptions, DistanceSolver, Element, Error, Method, Surface, VertexId, go_on};

use super::{Case, Random, Right};

/// Exact distances are right to this share of the extent, the diagonal of the bounding box.
pub const EXACT: f64 = 1e-6;

/// Propagation with one window a half-edge is right to this share of the extent.
pub const PROPAGATED: f64 = 2e-2;

/// Both directions of a path are as long, to this share of the extent.
pub const SYMMETRIC: f64 = 1e-9;

/// By what share of an edge the distances of its ends may differ more than by its length.
pub const STEEP: f64 = 1e-12;

/// What 64-bit floats lose where a distance is many times the edge, as a share of the distance: some units of the last place.
pub const ROUNDING: f64 = 1e-15;

/// Sources on a mesh whose distances need no search.
const SOURCES: usize = 4;

pub const METHODS: [Method; 4] = [Method::Exact, Method::Auto, Method::Propagation, Method::Heat];

/// What was found of the answers of a method.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Findings {
    pub answers: usize,
    /// Farther off than the method promises.
    pub wrong: usize,
    /// Infinite where there is a path.
    pub lost: usize,
    /// Pairs of sources with two distances.
    pub asymmetric: usize,
    /// Edges whose ends differ by more than their length.
    pub steep: usize,
    /// The largest error of a finite answer, as a share of the extent.
    pub worst: f64,
}

impl Findings {
    pub fn is_right(&self) -> bool {
        self.wrong + self.lost + self.asymmetric + self.steep == 0
    }

    pub fn add(&mut self, other: &Self) {
        self.answers += other.answers;
        self.wrong += other.wrong;
        self.lost += other.lost;
        self.asymmetric += other.asymmetric;
        self.steep += other.steep;
        self.worst = self.worst.max(other.worst);
    }
}

/// A mesh with its right distances.
pub struct Examined {
    solver: DistanceSolver,
    sources: Vec<VertexId>,
    right: Vec<Vec<f64>>,
    /// Of the soup, where that is another surface.
    unwelded: Option<Vec<Vec<f64>>>,
    along_edges: Vec<Vec<f64>>,
    extent: f64,
}

impl Examined {
    /// `None` where nothing is left of the mesh.
    ///
    /// # Errors
    /// Those of [`Surface::build`].
    pub fn new(case: &Case, seed: u64) -> Result<Option<Self>, SurfaceError> {
        let surface = match Surface::build(&case.soup) {
            Err(SurfaceError::Empty { .. }) => return Ok(None),
            surface => surface?,
        };
        let mut sources: Vec<VertexId> = surface.vertices().collect();
        if let Right::Unrolled(_) = case.right {
            Random::new(seed).shuffle(&mut sources);
            sources.truncate(SOURCES);
        }
        let positions = surface.positions();
        let low = positions.iter().copied().reduce(|a, b| a.min(b)).unwrap_or_default();
        let high = positions.iter().copied().reduce(|a, b| a.max(b)).unwrap_or_default();
        let right = case.right_distances(&surface);
        let unwelded = case.right_distances_unwelded(&surface);
        let along_edges = sources.iter().map(|&source| along_edges(&surface, source)).collect();
        let extent = high.distance(low);
        Ok(Some(Self { solver: DistanceSolver::new(surface), sources, right, unwelded, along_edges, extent }))
    }

    /// # Errors
    /// Those of [`DistanceSolver::distance`].
    pub fn findings(&mut self, method: Method) -> Result<Findings, Error> {
        let mut found = Findings::default();
        let mut rows = Vec::new();
        for (at, &source) in self.sources.iter().enumerate() {
            let answer = self.solver.distance(&[source], &DistanceOptions::by(method), &mut go_on)?;
            self.compare(method, at, answer.distance.values.as_slice(), &mut found);
            rows.push(answer.distance.values);
        }
        for (i, row) in rows.iter().enumerate() {
            for (j, other) in rows.iter().enumerate().take(i) {
                let (there, back) = (row[self.sources[j]], other[self.sources[i]]);
                let is_symmetric = there == back || (there - back).abs() <= SYMMETRIC * self.extent;
                found.asymmetric += usize::from(is_exact(method) && !is_symmetric);
            }
        }
        Ok(found)
    }

    fn compare(&self, method: Method, source: usize, values: &[f64], found: &mut Findings) {
        let surface = self.solver.surface();
        let from = self.sources[source];
        let right = &self.right[from.index()];
        for (vertex, (&value, &right)) in values.iter().zip(right).enumerate() {
            found.answers += 1;
            if value.is_infinite() && right.is_finite() {
                found.lost += 1;
                continue;
            }
            if value == right {
                continue;
            }
            let error = (value - right) / self.extent;
            found.worst = found.worst.max(error.abs());
            let straight = surface.position(from).distance(surface.position(VertexId::from_index(vertex)));
            let is_right = match method {
                Method::Exact | Method::Auto => error.abs() <= EXACT,
                Method::Propagation => (-SYMMETRIC..=PROPAGATED).contains(&error),
                Method::Heat => {
                    let rounding = SYMMETRIC * self.extent;
                    value >= straight - rounding && value <= self.along_edges[source][vertex] + rounding
                }
            };
            let unwelded = self.unwelded.as_ref().map_or(right, |all| all[from.index()][vertex]);
            let is_same_unwelded = !is_exact(method) || (value - unwelded).abs() <= EXACT * self.extent;
            found.wrong += usize::from(!(is_right && is_same_unwelded));
        }
        if method == Method::Heat {
            return;
        }
        for face in surface.faces() {
            for [a, b] in [[face[0], face[1]], [face[1], face[2]], [face[2], face[0]]] {
                let (x, y) = (values[a.index()], values[b.index()]);
                let length = surface.position(a).distance(surface.position(b));
                let is_steep = x != y && (x - y).abs() > length * (1.0 + STEEP) + ROUNDING * x.max(y);
                found.steep += usize::from(is_steep && x.is_finite() && y.is_finite());
            }
        }
    }
}

fn is_exact(method: Method) -> bool {
    matches!(method, Method::Exact | Method::Auto)
}

/// Lengths of the shortest ways along edges (Bellman and Ford).
fn along_edges(surface: &Surface, source: VertexId) -> Vec<f64> {
    let mut lengths = vec![f64::INFINITY; surface.vertex_count()];
    lengths[source.index()] = 0.0;
    loop {
        let mut is_done = true;
        for face in surface.faces() {
            for (i, j) in [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)] {
                let length = lengths[face[i].index()] + surface.position(face[i]).distance(surface.position(face[j]));
                let known = &mut lengths[face[j].index()];
                if length < *known {
                    (*known, is_done) = (length, false);
                }
            }
        }
        if is_done {
            return lengths;
        }
    }
}
