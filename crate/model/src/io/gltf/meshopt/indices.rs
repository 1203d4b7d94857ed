//! Modes 1 and 2 of the specification: the corners of triangles, and sequences of indices of any kind.

use super::input::{CUT_SHORT, Decoded, Input};

const TRIANGLES: u8 = 0xe1;
const SEQUENCE: u8 = 0xd1;
const WRONG_HEADER: &str = "its compressed indices are of another kind, or of a later version";

/// A nibble that stands for an index spelled out.
const SPELLED_OUT: u8 = 15;

/// The latest sixteen of what was pushed.
struct Recent<T> {
    entries: [T; 16],
    pushed: usize,
}

impl<T: Copy + Default> Recent<T> {
    fn new() -> Self {
        Self { entries: [T::default(); 16], pushed: 0 }
    }

    fn push(&mut self, entry: T) {
        self.entries[self.pushed % 16] = entry;
        self.pushed += 1;
    }

    /// The entry pushed `age` entries before the latest one.
    fn get(&self, age: u8) -> Decoded<T> {
        let index = self.pushed.checked_sub(1 + usize::from(age)).ok_or("it refers to a triangle before the first")?;
        Ok(self.entries[index % 16])
    }
}

/// The state of the decoder of triangles.
struct Corners<'a> {
    data: Input<'a>,
    /// The least index not seen yet.
    next: u32,
    /// The index spelled out last.
    last: u32,
    vertices: Recent<u32>,
}

impl Corners<'_> {
    fn fresh(&mut self) -> u32 {
        let index = self.next;
        self.next = index.wrapping_add(1);
        index
    }

    fn spelled_out(&mut self) -> Decoded<u32> {
        let coded = self.data.varint()?;
        self.last = self.last.wrapping_add(unzigzag(coded));
        Ok(self.last)
    }

    /// A corner by its nibble, and whether it is to be pushed.
    fn corner(&mut self, nibble: u8) -> Decoded<(u32, bool)> {
        match nibble {
            0 => Ok((self.fresh(), true)),
            SPELLED_OUT => Ok((self.spelled_out()?, true)),
            recent => Ok((self.vertices.get(recent - 1)?, false)),
        }
    }

    /// The third corner of a triangle on a recent edge, and whether it is to be pushed.
    fn opposite(&mut self, nibble: u8) -> Decoded<(u32, bool)> {
        match nibble {
            1..=12 => Ok((self.vertices.get(nibble)?, false)),
            13 | 14 => {
                self.last = if nibble == 13 { self.last.wrapping_sub(1) } else { self.last.wrapping_add(1) };
                Ok((self.last, true))
            }
            _ => self.corner(nibble),
        }
    }
}

/// The corners of `count / 3` triangles.
pub fn triangles(stream: &[u8], count: usize) -> Decoded<Vec<u32>> {
    if !count.is_multiple_of(3) {
        return Err("its number of corners is not divisible by 3");
    }
    let mut input = Input(stream);
    if input.byte()? != TRIANGLES {
        return Err(WRONG_HEADER);
    }
    let codes = input.take(count / 3)?;
    let (data, pairs) = input.0.split_last_chunk::<16>().ok_or(CUT_SHORT)?;
    let mut corners = Corners { data: Input(data), next: 0, last: 0, vertices: Recent::new() };
    let mut edges = Recent::new();
    let mut indices = Vec::with_capacity(count);
    for &code in codes {
        let (edge, nibble) = (code >> 4, code & 15);
        if edge < 15 {
            let (a, b) = edges.get(edge)?;
            let (c, push) = corners.opposite(nibble)?;
            indices.extend([a, b, c]);
            edges.push((c, b));
            edges.push((a, c));
            if push {
                corners.vertices.push(c);
            }
            continue;
        }
        let pair = if nibble < 14 { pairs[usize::from(nibble)] } else { corners.data.byte()? };
        if nibble >= 14 && pair == 0 {
            corners.next = 0;
        }
        let (a, _) = corners.corner(if nibble == 15 { SPELLED_OUT } else { 0 })?;
        let (b, push_b) = corners.corner(pair >> 4)?;
        let (c, push_c) = corners.corner(pair & 15)?;
        indices.extend([a, b, c]);
        [(b, a), (c, b), (a, c)].into_iter().for_each(|edge| edges.push(edge));
        corners.vertices.push(a);
        [(b, push_b), (c, push_c)].into_iter().filter(|&(_, push)| push).for_each(|(v, _)| corners.vertices.push(v));
    }
    corners.data.end()?;
    Ok(indices)
}

/// `count` indices, each a difference to one of two running values.
pub fn sequence(stream: &[u8], count: usize) -> Decoded<Vec<u32>> {
    let (stream, _reserved) = stream.split_last_chunk::<4>().ok_or(CUT_SHORT)?;
    let mut input = Input(stream);
    if input.byte()? != SEQUENCE {
        return Err(WRONG_HEADER);
    }
    if count > input.0.len() {
        return Err(CUT_SHORT);
    }
    let mut last = [0_u32; 2];
    let mut indices = Vec::with_capacity(count);
    for _ in 0..count {
        let coded = input.varint()?;
        let value = &mut last[(coded & 1) as usize];
        *value = value.wrapping_add(unzigzag(coded >> 1));
        indices.push(*value);
    }
    input.end()?;
    Ok(indices)
}

fn unzigzag(coded: u32) -> u32 {
    coded >> 1 ^ (coded & 1).wrapping_neg()
}
