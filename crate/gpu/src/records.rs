//! What the shaders read, as they lay it out.

use bytemuck::{Pod, Zeroable};

/// In place of a number: there is none.
pub const NONE: u32 = u32::MAX;

/// Added to the number of an edge of a patch, where a side has it instead of a half-edge of the same patch.
pub const LEAVING: u32 = 1 << 31;

/// Bits of infinity.
pub const INFINITE: u32 = f32::INFINITY.to_bits();

/// In the state of a slot: its window waits to cross.
pub const WAITING: u32 = 1 << 31;

/// The bits of a value that are not the number of the thread that offered it.
pub const VALUE: u32 = !0x3f;

/// Bits of the number of a vertex in its patch.
pub const CORNER_BITS: u32 = 10;

/// Shares of a half-edge that the interval of a window is kept in.
const SHARES: u32 = 0xffff;

/// `Face` of the shaders.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct FaceRecord {
    pub lengths: [f32; 3],
    pub area: f32,
    pub cosines: [f32; 3],
    pub corners: u32,
    pub neighbors: [u32; 3],
    pub padding: u32,
}

/// Numbers of a patch in the tables.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct PatchRecord {
    pub first_face: u32,
    pub face_count: u32,
    pub first_edge: u32,
    pub edge_count: u32,
    pub vertex_count: u32,
    /// Where its edges are in the tables, three numbers each: half-edge in the patch, patch behind, edge there.
    pub edges: u32,
    /// Where its vertices are in the tables, two numbers each: vertex, and where the patches around it are, if there are several:
    /// their number, then each.
    pub vertices: u32,
    /// Where its numbers begin in the state.
    pub state: u32,
}

/// Words of a [`PatchRecord`].
pub const PATCH_WORDS: usize = size_of::<PatchRecord>() / size_of::<u32>();

/// `Round` of the shaders.
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct RoundRecord {
    pub now: u32,
    pub next: u32,
    pub later: u32,
    pub parity: u32,
    pub workgroups: u32,
    pub patches: u32,
    pub edges: u32,
    pub padding: u32,
}

/// A window of all of a half-edge, from a source that is there along it and so far behind it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    pub offset: f32,
    pub x: f32,
    pub depth: f32,
}

impl Beam {
    /// As the shaders pack it.
    pub fn label(self) -> [u32; 4] {
        [self.offset.to_bits(), self.x.to_bits(), self.depth.to_bits(), SHARES << 16]
    }

    /// Distance at a position of the half-edge.
    pub fn at(self, position: f32) -> f32 {
        self.offset + (position - self.x).hypot(self.depth)
    }
}
