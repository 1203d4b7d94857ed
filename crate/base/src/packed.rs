//! How numbers are packed as bytes, by which one program hands them to another of the same build.

/// Lists of plain numbers, as the bytes that they are: a number at a time would take as long as reading a file does.
pub mod plain {
    use bytemuck::Pod;
    use serde::{Deserialize, Deserializer, Serializer};

    /// For serde's `with`.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: Serializer, T: Pod>(list: &[T], to: S) -> Result<S::Ok, S::Error> {
        to.serialize_bytes(bytemuck::cast_slice(list))
    }

    /// For serde's `with`.
    ///
    /// # Errors
    /// Those of the deserializer, and where a list is cut short.
    pub fn deserialize<'de, D: Deserializer<'de>, T: Pod>(from: D) -> Result<Vec<T>, D::Error> {
        use serde::de::Error;
        let bytes = <&[u8]>::deserialize(from)?;
        if bytes.len() % size_of::<T>() != 0 {
            return Err(D::Error::custom("a list is cut short"));
        }
        Ok(bytemuck::pod_collect_to_vec(bytes))
    }
}

/// Rows of `N` numbers, which serde takes only as one list of numbers.
pub mod rows {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    /// For serde's `with`.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: Serializer, const N: usize>(rows: &[[f32; N]], to: S) -> Result<S::Ok, S::Error> {
        rows.as_flattened().serialize(to)
    }

    /// For serde's `with`.
    ///
    /// # Errors
    /// Those of the deserializer, and where a row is cut short.
    pub fn deserialize<'de, D: Deserializer<'de>, const N: usize>(from: D) -> Result<Vec<[f32; N]>, D::Error> {
        match Vec::<f32>::deserialize(from)?.as_chunks() {
            (rows, []) => Ok(rows.to_vec()),
            _ => Err(D::Error::custom("a row is cut short")),
        }
    }
}
