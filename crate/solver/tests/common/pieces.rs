//! Closed surfaces cut into pieces that share no vertex, as the parts of assemblies do.

use std::collections::HashMap;
use std::num::NonZeroUsize;
use std::sync::Arc;

use super::truth::Random;
use glam::DVec3;
use heatwalk::{Element, Soup, Surface, VertexData, VertexId, WeldRule};
use heatwalk_shapes as shapes;

/// Pieces that a surface is cut into.
const PIECES: usize = 10;

/// Rounds in which the pieces become compact.
const ROUNDS: usize = 8;

/// What happens to the pieces after the cut.
#[derive(Debug, Clone, Copy)]
pub enum Change {
    /// Each coordinate of each vertex moves by up to this share of the diagonal.
    Noise(f64),
    /// Each piece grows by this factor about the mean of its vertices.
    Scale(f64),
}

/// The changes that are measured.
pub const CHANGES: [(&str, Change); 3] = [
    ("disturbed by 1e-5 of the diagonal", Change::Noise(1e-5)),
    ("shrunk by 0.3 %", Change::Scale(0.997)),
    ("enlarged by 0.3 %", Change::Scale(1.003)),
];

/// A surface before the cut.
pub struct Whole {
    pub name: &'static str,
    pub surface: Arc<Surface>,
    pub source: VertexId,
}

/// A torus of 10,800 triangles, a sphere with bumps of 20,480 and an animal of 25,700.
pub fn wholes() -> [Whole; 3] {
    let mut bumpy = shapes::icosphere(5);
    for position in &mut bumpy.positions {
        let [x, y, z] = (7.0 * *position).to_array();
        *position *= 1.0 + 0.08 * (x.sin() + y.sin() + z.sin());
    }
    let all = [("torus", shapes::torus(1.0, 0.4, 90, 60)), ("bumpy sphere", bumpy), ("animal", shapes::animal(0.03))];
    all.map(|(name, soup)| {
        let surface = Arc::new(Surface::build(&soup).expect("a surface"));
        Whole { name, surface, source: VertexId(5) }
    })
}

/// The pieces of a surface.
pub struct Pieces {
    pub surface: Arc<Surface>,
    /// `#V`, the vertex of the whole surface that each is a copy of.
    originals: Vec<VertexId>,
    pub source: VertexId,
}

impl Pieces {
    /// Cuts along edges and changes the pieces.
    pub fn new(whole: &Whole, change: Change, rule: WeldRule) -> Self {
        let (faces, positions) = (whole.surface.faces().as_slice(), whole.surface.positions());
        let mut pieces = vec![(Vec::<VertexId>::new(), Vec::<[u32; 3]>::new()); PIECES];
        let mut numbers = vec![HashMap::new(); PIECES];
        for (face, piece) in faces.iter().zip(clusters(&whole.surface)) {
            let (vertices, triangles) = &mut pieces[piece];
            triangles.push(face.map(|vertex| {
                *numbers[piece].entry(vertex).or_insert_with(|| {
                    vertices.push(vertex);
                    vertices.len() as u32 - 1
                })
            }));
        }
        let corner = |by: fn(DVec3, DVec3) -> DVec3| positions.iter().copied().reduce(by).expect("a vertex");
        let diagonal = corner(DVec3::min).distance(corner(DVec3::max));
        let mut random = Random::new(1);
        let (mut soup, mut of_input) = (Soup::default(), Vec::new());
        for (vertices, triangles) in pieces {
            let sum: DVec3 = vertices.iter().map(|&vertex| positions[vertex]).sum();
            let centre = sum / vertices.len() as f64;
            let changed = vertices.iter().map(|&vertex| match change {
                Change::Noise(share) => {
                    let mut part = |_| random.between(-1.0, 1.0);
                    positions[vertex] + share * diagonal * DVec3::from_array([0, 1, 2].map(&mut part))
                }
                Change::Scale(factor) => centre + factor * (positions[vertex] - centre),
            });
            soup.add(changed, &triangles);
            soup.end_part("piece");
            of_input.extend(vertices);
        }
        let surface = Surface::build_by(&soup, rule, NonZeroUsize::MIN).expect("a surface");
        let original = |vertex| of_input[surface.inputs_of_vertex(vertex)[0].index()];
        let originals: Vec<VertexId> = surface.vertices().map(original).collect();
        let copy = originals.iter().position(|&original| original == whole.source).expect("a copy of every vertex");
        Self { surface: Arc::new(surface), originals, source: VertexId::from_index(copy) }
    }

    /// `#V`, what values on the whole surface are on the pieces.
    pub fn copied(&self, values: &VertexData<f64>) -> VertexData<f64> {
        self.originals.iter().map(|&original| values[original]).collect()
    }
}

/// Errors relative to the exact distance, in per cent.
#[derive(Debug, Clone, Copy)]
pub struct Errors {
    pub mean: f64,
    /// 99th percentile.
    pub high: f64,
}

impl Errors {
    /// Of values against exact ones, where these are above 0.
    pub fn between(values: &VertexData<f64>, exact: &VertexData<f64>) -> Self {
        let pairs = values.iter().zip(exact).filter(|&(_, &exact)| exact > 0.0);
        let mut errors: Vec<f64> = pairs.map(|(value, exact)| 100.0 * (value / exact - 1.0).abs()).collect();
        errors.sort_by(f64::total_cmp);
        Self { mean: errors.iter().sum::<f64>() / errors.len() as f64, high: errors[errors.len() * 99 / 100] }
    }
}

/// The piece of each face: by the nearest of some centers, which move to the means of their pieces (Lloyd, "Least squares
/// quantization in PCM", 1982).
fn clusters(surface: &Surface) -> Vec<usize> {
    let middle = |face: &[VertexId; 3]| face.iter().map(|&vertex| surface.position(vertex)).sum::<DVec3>() / 3.0;
    let middles: Vec<DVec3> = surface.faces().as_slice().iter().map(middle).collect();
    let mut centres: Vec<DVec3> = (0..PIECES).map(|piece| middles[piece * middles.len() / PIECES]).collect();
    let nearest = |centres: &[DVec3], middle: DVec3| {
        let squared = |piece: usize| centres[piece].distance_squared(middle);
        (0..PIECES).min_by(|&a, &b| squared(a).total_cmp(&squared(b))).expect("a piece")
    };
    for _ in 0..ROUNDS {
        let mut sums = [(DVec3::ZERO, 0.0); PIECES];
        for &middle in &middles {
            let (sum, count) = &mut sums[nearest(&centres, middle)];
            *sum += middle;
            *count += 1.0;
        }
        centres = sums.iter().map(|&(sum, count)| sum / count).collect();
    }
    middles.iter().map(|&middle| nearest(&centres, middle)).collect()
}
