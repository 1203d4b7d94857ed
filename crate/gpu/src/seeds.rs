//! Where a front starts: distances of vertices, windows of half-edges, and the patches that have some.

use std::collections::BTreeMap;

use heatwalk::{FaceId, Place, Source};

use crate::layout::Layout;
use crate::patches::Faces as _;
use crate::records::{Beam, VALUE, WAITING};

/// A source this near to a side of its triangle, in mean edges, lights the triangle behind as well: what passes the side at such a
/// slope is lost to rounding.
const BESIDE: f64 = 1e-5;

/// What sources give. Distances are in mean edges.
#[derive(Debug, Default)]
pub struct Seeds {
    /// Distances of vertices.
    pub vertices: BTreeMap<u32, f32>,
    /// Windows by their place among the labels.
    pub windows: BTreeMap<u32, Seed>,
    /// Least distance of what each patch has.
    pub patches: BTreeMap<u32, f32>,
}

/// A window that waits.
#[derive(Debug, Clone, Copy)]
pub struct Seed {
    /// Place of its value in the state.
    pub state: u32,
    /// The value and that it waits.
    pub word: u32,
    pub label: [u32; 4],
}

impl Seeds {
    /// Those of some sources.
    pub fn new(layout: &Layout, sources: &[Source]) -> Self {
        let mut seeds = Self::default();
        for source in sources {
            let (place, initial) = (source.place(), source.initial_distance() / layout.mean_edge);
            match place.vertex(layout.surface()) {
                Some(vertex) => seeds.add_vertex(layout, vertex.0, initial),
                None => seeds.add_place(layout, place, initial),
            }
        }
        seeds
    }

    fn add_vertex(&mut self, layout: &Layout, vertex: u32, distance: f64) {
        let distance = distance as f32;
        let known = self.vertices.entry(vertex).or_insert(f32::INFINITY);
        if distance < *known {
            *known = distance;
            layout.patches_around(vertex).iter().for_each(|&patch| self.list(patch, distance));
        }
    }

    fn list(&mut self, patch: u32, distance: f32) {
        let pending = self.patches.entry(patch).or_insert(distance);
        *pending = pending.min(distance);
    }

    /// A place in a face or on an edge.
    fn add_place(&mut self, layout: &Layout, place: Place, initial: f64) {
        let surface = layout.surface();
        let face = place.faces(surface)[0];
        let (FaceId(face), weights) = layout.flips.relocated(face, place.weights_in(surface, face));
        self.light(layout, (face, weights), initial);
        let twins = layout.triangles.twins(face);
        let depths = Laid::new(layout, face).seen(weights).map(|(_, depth)| depth);
        for (k, twin) in twins.into_iter().enumerate().filter(|&(k, _)| depths[k] < BESIDE) {
            let Some(twin) = twin else { continue };
            // As the face behind sees it, on the side itself.
            let share = weights[k] / (weights[k] + weights[(k + 1) % 3]);
            let mut behind = [0.0; 3];
            behind[twin as usize % 3] = 1.0 - share;
            behind[(twin as usize + 1) % 3] = share;
            self.light(layout, (twin / 3, behind), initial);
        }
    }

    /// Sends straight lines to the corners of a triangle, and windows out of its sides.
    fn light(&mut self, layout: &Layout, (face, weights): (u32, [f64; 3]), initial: f64) {
        let laid = Laid::new(layout, face);
        let corners = layout.triangles.vertices(face);
        let (seen, twins) = (laid.seen(weights), layout.triangles.twins(face));
        for k in 0..3 {
            let (along, depth) = seen[k];
            self.add_vertex(layout, corners[k], initial + along.hypot(depth));
            if let Some(twin) = twins[k].filter(|_| depth >= BESIDE) {
                let beam = Beam { offset: initial as f32, x: (laid.lengths[k] - along) as f32, depth: depth as f32 };
                self.add_window(layout, twin, laid.lengths[k] as f32, beam);
            }
        }
    }

    fn add_window(&mut self, layout: &Layout, halfedge: u32, length: f32, beam: Beam) {
        let patch = layout.patch_of(halfedge);
        let record = &layout.patches[patch as usize];
        for (stretch, share) in [(0, 0.25), (1, 0.75)] {
            let value = beam.at(share * length);
            let place = 2 * layout.place_of(halfedge) + stretch;
            let state = record.state + place - 6 * record.first_face;
            let seed = Seed { state, word: (value.to_bits() & VALUE) | WAITING, label: beam.label() };
            let known = self.windows.entry(place).or_insert(seed);
            if seed.word < known.word {
                *known = seed;
            }
            self.list(patch, value);
        }
    }
}

/// A triangle in the plane, in mean edges.
struct Laid {
    lengths: [f64; 3],
    corners: [[f64; 2]; 3],
}

impl Laid {
    fn new(layout: &Layout, face: u32) -> Self {
        let lengths = layout.triangles.lengths(face).map(|length| length / layout.mean_edge);
        let [base, right, left] = lengths;
        let x = (base * base + (left - right) * (left + right)) / (2.0 * base);
        let y = ((left - x) * (left + x)).max(0.0).sqrt();
        Self { lengths, corners: [[0.0, 0.0], [base, 0.0], [x, y]] }
    }

    /// How far along each side from its begin, and how far from it, a place of these weights is.
    fn seen(&self, weights: [f64; 3]) -> [(f64, f64); 3] {
        let place = [0, 1].map(|axis| (0..3).map(|k| weights[k] * self.corners[k][axis]).sum::<f64>());
        std::array::from_fn(|k| {
            let (from, to) = (self.corners[k], self.corners[(k + 1) % 3]);
            let side = [0, 1].map(|axis| (to[axis] - from[axis]) / self.lengths[k]);
            let there = [0, 1].map(|axis| place[axis] - from[axis]);
            (there[0] * side[0] + there[1] * side[1], (side[0] * there[1] - side[1] * there[0]).max(0.0))
        })
    }
}
