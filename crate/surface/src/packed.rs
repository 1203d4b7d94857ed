//! Soups as bytes, by which one program hands them to another of the same build.

use crate::soup::Soup;

impl Soup {
    /// All of it as bytes, which [`Self::unpacked`] takes.
    ///
    /// # Panics
    /// Never: what a soup is made of can be written.
    pub fn packed(&self) -> Vec<u8> {
        postcard::to_allocvec(self).expect("a soup can be written")
    }

    /// The soup whose bytes [`Self::packed`] gave; None for other bytes.
    pub fn unpacked(bytes: &[u8]) -> Option<Self> {
        postcard::from_bytes(bytes).ok()
    }
}

/// Rows of `N` numbers, which serde takes only as one list of numbers.
pub(crate) mod rows {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer, const N: usize>(rows: &[[f32; N]], to: S) -> Result<S::Ok, S::Error> {
        rows.as_flattened().serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>, const N: usize>(from: D) -> Result<Vec<[f32; N]>, D::Error> {
        match Vec::<f32>::deserialize(from)?.as_chunks() {
            (rows, []) => Ok(rows.to_vec()),
            _ => Err(D::Error::custom("a row is cut short")),
        }
    }
}
