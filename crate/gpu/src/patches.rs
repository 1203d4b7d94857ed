//! Faces in patches, each of which a workgroup takes into its memory.

use glam::DVec3;

/// The most that a patch has of each kind; the shaders' arrays are as long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capacity {
    /// Faces.
    pub faces: usize,
    /// Edges to other patches.
    pub edges: usize,
    /// Vertices.
    pub vertices: usize,
}

/// How many faces a patch has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatchSize {
    /// At most 64, so that also small meshes have a patch for each part of a card.
    Small,
    /// At most 96, so that less goes from patch to patch.
    Large,
}

const SMALL: Capacity = Capacity { faces: 64, edges: 64, vertices: 96 };
const LARGE: Capacity = Capacity { faces: 96, edges: 80, vertices: 128 };

/// Meshes of more faces have enough large patches for all of a card.
const LARGE_MESH: usize = 300_000;

impl PatchSize {
    /// That of patches of a mesh of so many faces.
    #[must_use]
    pub fn of_mesh(faces: usize) -> Self {
        if faces > LARGE_MESH { Self::Large } else { Self::Small }
    }

    /// The most that such a patch has.
    pub(crate) fn capacity(self) -> Capacity {
        match self {
            Self::Small => SMALL,
            Self::Large => LARGE,
        }
    }
}

/// A mesh as patches see it: half-edge `3 f + k` is side `k` of face `f`.
pub trait Faces {
    /// The vertices of a face.
    fn vertices(&self, face: u32) -> [u32; 3];

    /// The half-edges glued to its sides.
    fn twins(&self, face: u32) -> [Option<u32>; 3];
}

/// Parts faces with these centers: gives them in the order of patches, and where each of these begins and the last one ends.
///
/// Sets of faces are bisected along the widest axis of the box around their centers until they fit.
pub fn bisect(mesh: &impl Faces, centers: &[DVec3], capacity: Capacity) -> (Vec<u32>, Vec<u32>) {
    let mut faces: Vec<u32> = (0..centers.len() as u32).collect();
    let mut starts = Vec::new();
    let mut measure = Measure { owner: vec![u32::MAX; faces.len()], number: 0, vertices: Vec::new() };
    let all = 0..faces.len();
    let mut waiting = vec![all];
    while let Some(range) = waiting.pop() {
        let part = &mut faces[range.clone()];
        if part.len() <= capacity.faces && (part.len() == 1 || measure.fits(mesh, part, capacity)) {
            starts.push(range.start as u32);
            continue;
        }
        let box_of = |(low, high): (DVec3, DVec3), &face: &u32| {
            let center = centers[face as usize];
            (low.min(center), high.max(center))
        };
        let (low, high) = part.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), box_of);
        let axis = (high - low).max_position();
        // Whole patches on one side, so that all but a few are full.
        let half = part.len() / 2;
        let middle = if part.len() > capacity.faces { half.next_multiple_of(capacity.faces) } else { half };
        let middle = if middle < part.len() { middle } else { half };
        let key = |face: u32| centers[face as usize][axis];
        part.select_nth_unstable_by(middle, |&a, &b| key(a).total_cmp(&key(b)).then(a.cmp(&b)));
        let middle = range.start + middle;
        waiting.extend([middle..range.end, range.start..middle]);
    }
    starts.push(faces.len() as u32);
    (faces, starts)
}

/// Counts what sets of faces have.
struct Measure {
    /// The set that looked at each face last.
    owner: Vec<u32>,
    /// Number of the latest set.
    number: u32,
    /// Those of the latest set; kept for its memory.
    vertices: Vec<u32>,
}

impl Measure {
    /// Whether edges and vertices of a set are few enough.
    fn fits(&mut self, mesh: &impl Faces, set: &[u32], capacity: Capacity) -> bool {
        self.number += 1;
        set.iter().for_each(|&face| self.owner[face as usize] = self.number);
        let is_elsewhere = |&twin: &u32| self.owner[twin as usize / 3] != self.number;
        let leaving = |&face: &u32| mesh.twins(face).into_iter().flatten().filter(is_elsewhere).count();
        let edges: usize = set.iter().map(leaving).sum();
        self.vertices.clear();
        self.vertices.extend(set.iter().flat_map(|&face| mesh.vertices(face)));
        self.vertices.sort_unstable();
        self.vertices.dedup();
        edges <= capacity.edges && self.vertices.len() <= capacity.vertices
    }
}
