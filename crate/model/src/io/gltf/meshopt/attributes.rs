//! Mode 0 of the specification: elements of any kind, as differences of their bytes, in blocks of at most 256.

use super::input::{CUT_SHORT, Decoded, Input};

/// Elements of a group: their differences have one width.
const GROUP: usize = 16;
const MAX_BLOCK: usize = 256;
const MAX_BLOCK_BYTES: usize = 8192;

/// Widths in bits of the differences of a group, by the two bits of its header.
const WIDTHS_V0: [u32; 4] = [0, 2, 4, 8];
const WIDTHS_V1: [[u32; 4]; 2] = [[0, 1, 2, 4], [1, 2, 4, 8]];

/// How differences become values, for four bytes of each element.
#[derive(Clone, Copy)]
enum Channel {
    Bytes,
    Shorts,
    /// Exclusive or with the difference, which the encoder has rotated left.
    Xor(u32),
}

/// `count × stride` bytes.
pub fn decode(stream: &[u8], count: usize, stride: usize) -> Decoded<Vec<u8>> {
    let (&header, stream) = stream.split_first().ok_or(CUT_SHORT)?;
    // Bytes of the control header and of the channel modes, and the least length of the tail.
    let (channels, least_tail) = match header {
        0xa0 => (0, 32),
        0xa1 => (stride / 4, 24),
        _ => return Err("its compressed data is of another kind, or of a later version"),
    };
    let blocks = stream.len().checked_sub((stride + channels).max(least_tail)).ok_or(CUT_SHORT)?;
    let (mut input, tail) = (Input(&stream[..blocks]), &stream[stream.len() - stride - channels..]);
    let (baseline, modes) = tail.split_at(stride);
    let channels: Vec<Channel> = match header {
        0xa0 => vec![Channel::Bytes; stride / 4],
        _ => modes.iter().map(|&mode| channel(mode)).collect::<Decoded<_>>()?,
    };

    let block = (MAX_BLOCK_BYTES / stride / GROUP * GROUP).min(MAX_BLOCK);
    // Every block has headers of at least a byte per channel: a count without bytes reserves nothing.
    if count.div_ceil(block).saturating_mul(stride / 4) > blocks {
        return Err(CUT_SHORT);
    }
    let length = count.checked_mul(stride).ok_or(CUT_SHORT)?;
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(length).map_err(|_| "it does not fit into memory")?;
    bytes.resize(length, 0);

    let mut last: Vec<u32> = baseline.as_chunks().0.iter().map(|&four| u32::from_le_bytes(four)).collect();
    let mut planes = [[0_u8; MAX_BLOCK]; 4];
    for elements in bytes.chunks_mut(block * stride) {
        let count = elements.len() / stride;
        let control = input.take(modes.len())?;
        for (index, (&channel, last)) in channels.iter().zip(&mut last).enumerate() {
            for (byte, plane) in planes.iter_mut().enumerate() {
                match control.get(index).map(|modes| modes >> (2 * byte) & 3) {
                    None => read_groups(&mut input, WIDTHS_V0, count, plane)?,
                    Some(2) => plane.fill(0),
                    // Not padded to whole groups.
                    Some(3) => plane[..count].copy_from_slice(input.take(count)?),
                    Some(mode) => read_groups(&mut input, WIDTHS_V1[usize::from(mode)], count, plane)?,
                }
            }
            let elements = elements.chunks_exact_mut(stride).map(|element| &mut element[4 * index..4 * index + 4]);
            match channel {
                Channel::Bytes => restore(&planes, last, elements, |value, delta| add(value, delta, 0x0101_0101, 8)),
                Channel::Shorts => restore(&planes, last, elements, |value, delta| add(value, delta, 0x0001_0001, 16)),
                Channel::Xor(turns) => {
                    restore(&planes, last, elements, |value, delta| value ^ delta.rotate_right(turns));
                }
            }
        }
    }
    input.end()?;
    Ok(bytes)
}

fn channel(mode: u8) -> Decoded<Channel> {
    match (mode & 15, mode >> 4) {
        (0, 0) => Ok(Channel::Bytes),
        (1, 0) => Ok(Channel::Shorts),
        (2, turns) => Ok(Channel::Xor(turns.into())),
        _ => Err("a channel of its compressed data has an unknown mode"),
    }
}

/// The differences of one byte of `count` elements, rounded up to whole groups.
fn read_groups(input: &mut Input, widths: [u32; 4], count: usize, plane: &mut [u8; MAX_BLOCK]) -> Decoded<()> {
    let groups = count.div_ceil(GROUP);
    let header = input.take(groups.div_ceil(4))?;
    for (group, deltas) in plane.as_chunks_mut::<GROUP>().0.iter_mut().take(groups).enumerate() {
        match widths[usize::from(header[group / 4] >> (group % 4 * 2) & 3)] {
            0 => deltas.fill(0),
            1 => read_group::<1>(input, deltas)?,
            2 => read_group::<2>(input, deltas)?,
            4 => read_group::<4>(input, deltas)?,
            _ => deltas.copy_from_slice(input.take(GROUP)?),
        }
    }
    Ok(())
}

/// Differences of `BITS` bits; one with all bits set stands for a whole byte, which follows the group.
fn read_group<const BITS: usize>(input: &mut Input, deltas: &mut [u8; GROUP]) -> Decoded<()> {
    let packed = input.take(2 * BITS)?;
    let wide = (1 << BITS) - 1;
    let per_byte = 8 / BITS;
    for (index, delta) in deltas.iter_mut().enumerate() {
        let place = index % per_byte;
        // Single bits begin at the lowest one, wider fields at the highest.
        let shift = if BITS == 1 { place } else { 8 - BITS * (place + 1) };
        *delta = packed[index / per_byte] >> shift & wide;
        if *delta == wide {
            *delta = input.byte()?;
        }
    }
    Ok(())
}

/// Writes four bytes of each element, from the differences of these bytes and the value before the first.
fn restore<'a>(
    planes: &[[u8; MAX_BLOCK]; 4],
    last: &mut u32,
    elements: impl Iterator<Item = &'a mut [u8]>,
    next: impl Fn(u32, u32) -> u32,
) {
    for (index, element) in elements.enumerate().take(MAX_BLOCK) {
        let delta = u32::from_le_bytes([planes[0][index], planes[1][index], planes[2][index], planes[3][index]]);
        *last = next(*last, delta);
        element.copy_from_slice(&last.to_le_bytes());
    }
}

/// Adds zigzag-coded differences to the lanes of a word, each modulo its own size; `ones` is 1 in every lane of `bits`.
fn add(value: u32, delta: u32, ones: u32, bits: u32) -> u32 {
    let high = ones << (bits - 1);
    let negative = (delta & ones) * ((1 << bits) - 1);
    let delta = (delta >> 1 & !high) ^ negative;
    ((value & !high) + (delta & !high)) ^ ((value ^ delta) & high)
}
