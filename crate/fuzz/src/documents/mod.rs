//! Documents that are sound as JSON, XML or ZIP and say anything: what bytes alone seldom come to.

pub mod gltf;
pub mod threemf;
pub mod vtk;

use arbitrary::{Arbitrary, Result, Unstructured};

/// Items of a list at most.
const MOST_ITEMS: usize = 6;

/// Numbers at which sums and products are at their ends.
const EDGES: [u64; 12] = [
    0,
    1 << 16,
    (1 << 31) - 1,
    1 << 31,
    (1 << 32) - 1,
    1 << 32,
    (1 << 53) + 1,
    (1 << 62) - 1,
    1 << 62,
    (1 << 63) - 1,
    1 << 63,
    u64::MAX,
];

/// A count, an offset or an index: mostly small, at times hostile.
#[derive(Debug, Clone, Copy)]
pub struct Number(pub u64);

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(data: &mut Unstructured<'a>) -> Result<Self> {
        let kind: u8 = data.arbitrary()?;
        Ok(Self(match kind {
            0..20 => *data.choose(&EDGES)?,
            20..60 => 4 * u64::from(kind),
            _ => u64::from(kind % 8),
        }))
    }
}

/// A short list.
fn list<'a, T: Arbitrary<'a>>(data: &mut Unstructured<'a>) -> Result<Vec<T>> {
    (0..data.int_in_range(0..=MOST_ITEMS)?).map(|_| data.arbitrary()).collect()
}
