//! Indices as bytes.
//!
//! All numbers are little-endian: eight bytes of [`MAGIC`], the version (u32), the counts of input vertices, places, nodes (u32 each), the fingerprint
//! of the surface (u64), the unit of the lengths (f64, in the file's); then the place of each input vertex (u32), of each node its parent, the begin and the end of its separator (u32 each), of each
//! place its longest edge (f32), the labels (f32), and the checksum of all before (u64).

use std::io::{self, Write};

use heatwalk::Surface;

use crate::DistanceIndex;
use crate::error::{Error, Result};
use crate::tree::{NONE, Node, Tree};

const MAGIC: &[u8; 8] = b"hwindex\n";
const VERSION: u32 = 2;

/// Bytes before the first array, and after the last.
const HEAD: usize = 8 + 4 * 4 + 8 + 8;
const TAIL: usize = 8;

/// A hash that is the same everywhere and at all times: FNV-1a of words of eight bytes.
struct Hash(u64);

impl Hash {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn word(&mut self, word: u64) {
        // Low bits would otherwise know nothing of high ones.
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(29);
    }

    fn bytes(&mut self, bytes: &[u8]) {
        let (words, rest) = bytes.as_chunks::<8>();
        words.iter().for_each(|&word| self.word(u64::from_le_bytes(word)));
        rest.iter().for_each(|&byte| self.word(u64::from(byte)));
    }
}

/// Of positions, faces, and the vertices of the input.
pub fn fingerprint(surface: &Surface) -> u64 {
    let mut hash = Hash::new();
    surface.positions().iter().flat_map(|position| position.to_array()).for_each(|number| hash.word(number.to_bits()));
    surface.faces().iter().flatten().for_each(|vertex| hash.word(u64::from(vertex.0)));
    let inputs = surface.vertices_of_inputs().iter();
    inputs.for_each(|vertex| hash.word(vertex.map_or(u64::MAX, |vertex| u64::from(vertex.0))));
    hash.0
}

impl DistanceIndex {
    /// Writes it as bytes, which [`Self::from_bytes`] reads.
    ///
    /// # Errors
    /// Those of `output`.
    pub fn write(&self, output: &mut dyn Write) -> io::Result<()> {
        let mut hash = Hash::new();
        let mut put = |bytes: &[u8]| {
            hash.bytes(bytes);
            output.write_all(bytes)
        };
        let nodes = self.tree.nodes();
        let counts = [self.place_of_input.len(), self.longest.len(), nodes.len()];
        put(MAGIC)?;
        put(&VERSION.to_le_bytes())?;
        put(&counts.map(|count| (count as u32).to_le_bytes()).concat())?;
        put(&self.fingerprint.to_le_bytes())?;
        put(&self.unit.to_le_bytes())?;
        let words = |words: &mut dyn Iterator<Item = [u8; 4]>| words.flatten().collect::<Vec<u8>>();
        put(&words(&mut self.place_of_input.iter().map(|place| place.to_le_bytes())))?;
        let of_node = |node: &Node| [node.parent, node.separator, node.end].map(u32::to_le_bytes);
        put(&words(&mut nodes.iter().flat_map(of_node)))?;
        put(&words(&mut self.longest.iter().map(|length| length.to_le_bytes())))?;
        for some in self.labels.chunks(1 << 16) {
            put(&words(&mut some.iter().map(|label| label.to_le_bytes())))?;
        }
        output.write_all(&hash.0.to_le_bytes())
    }

    /// Reads what [`Self::write`] has written.
    ///
    /// # Errors
    /// [`Error::NotAnIndex`], [`Error::OtherVersion`], [`Error::Damaged`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        if !bytes.starts_with(MAGIC) {
            return Err(Error::NotAnIndex);
        }
        let rest = bytes.len().checked_sub(HEAD + TAIL).ok_or(Error::Damaged)?;
        let (whole, checksum) = bytes.split_at(bytes.len() - TAIL);
        let word =
            |place: usize| u32::from_le_bytes([whole[place], whole[place + 1], whole[place + 2], whole[place + 3]]);
        let [version, inputs, places, nodes] = [8, 12, 16, 20].map(word);
        if version != VERSION {
            return Err(Error::OtherVersion { found: version, known: VERSION });
        }
        let double = |place: usize| u64::from(word(place)) | u64::from(word(place + 4)) << 32;
        let (fingerprint, unit) = (double(24), f64::from_bits(double(32)));
        // In the order and the pieces in which it was written.
        let mut hash = Hash::new();
        [0..8, 8..12, 12..24, 24..32, 32..HEAD].into_iter().for_each(|range| hash.bytes(&whole[range]));
        let (words, odd) = whole[HEAD..].as_chunks::<4>();
        let lengths = [inputs as usize, 3 * nodes as usize, places as usize];
        if !odd.is_empty() || lengths.iter().sum::<usize>() > rest / 4 {
            return Err(Error::Damaged);
        }
        let (place_of_input, words) = words.split_at(lengths[0]);
        let (of_nodes, words) = words.split_at(lengths[1]);
        let (longest, labels) = words.split_at(lengths[2]);
        [place_of_input, of_nodes, longest].into_iter().for_each(|array| hash.bytes(array.as_flattened()));
        labels.chunks(1 << 16).for_each(|some| hash.bytes(some.as_flattened()));
        if hash.0.to_le_bytes() != checksum {
            return Err(Error::Damaged);
        }
        let numbers = |array: &[[u8; 4]]| array.iter().map(|&word| u32::from_le_bytes(word)).collect::<Vec<u32>>();
        let lengths = |array: &[[u8; 4]]| array.iter().map(|&word| f32::from_le_bytes(word)).collect::<Vec<f32>>();
        let of_nodes = numbers(of_nodes);
        let nodes: Vec<Node> = of_nodes
            .as_chunks::<3>()
            .0
            .iter()
            .map(|&[parent, separator, end]| Node { parent, separator, end })
            .collect();
        let place_of_input = numbers(place_of_input);
        let is_sound = unit > 0.0 && unit.is_finite() && is_tree(&nodes, places);
        if !is_sound || place_of_input.iter().any(|&place| place != NONE && place >= places) {
            return Err(Error::Damaged);
        }
        let tree = Tree::of_nodes(nodes);
        if tree.label_count() != labels.len() {
            return Err(Error::Damaged);
        }
        Ok(Self { fingerprint, place_of_input, tree, unit, longest: lengths(longest), labels: lengths(labels) })
    }

    /// Refuses another surface than the one that it is of.
    ///
    /// # Errors
    /// [`Error::OtherSurface`].
    pub fn require(&self, surface: &Surface) -> Result<()> {
        if self.fingerprint == fingerprint(surface) { Ok(()) } else { Err(Error::OtherSurface) }
    }
}

/// Whether separators follow each other, and each node but the last one has a parent after it.
fn is_tree(nodes: &[Node], places: u32) -> bool {
    let mut end = 0;
    let is_sound = |(number, node): (usize, &Node)| {
        let is_next = node.separator == end && node.end >= node.separator;
        end = node.end;
        let is_last = number + 1 == nodes.len();
        is_next
            && if is_last {
                node.parent == NONE
            } else {
                (node.parent as usize) > number && (node.parent as usize) < nodes.len()
            }
    };
    nodes.iter().enumerate().all(is_sound) && end == places
}
