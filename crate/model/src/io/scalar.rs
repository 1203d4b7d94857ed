//! Numbers as bytes. Every type fits into an f64, but for whole numbers above 2⁵³, which no index is.

#[cfg(any(feature = "gifti", feature = "vtk"))]
use super::budget::Budget;
#[cfg(any(feature = "gifti", feature = "vtk"))]
use crate::error::Result;

/// A type of numbers.
#[derive(Clone, Copy, PartialEq)]
pub enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Scalar {
    /// By its name in PLY, in legacy and XML files of VTK, and in GIFTI.
    pub fn parse(word: &str) -> Option<Self> {
        Some(match word.to_ascii_lowercase().as_str() {
            "char" | "int8" | "vtktypeint8" => Self::I8,
            "uchar" | "unsigned_char" | "uint8" | "vtktypeuint8" => Self::U8,
            "short" | "int16" | "vtktypeint16" => Self::I16,
            "ushort" | "unsigned_short" | "uint16" | "vtktypeuint16" => Self::U16,
            "int" | "int32" | "vtktypeint32" | "vtkidtype" => Self::I32,
            "uint" | "unsigned_int" | "uint32" | "vtktypeuint32" => Self::U32,
            "long" | "int64" | "vtktypeint64" => Self::I64,
            "ulong" | "unsigned_long" | "uint64" | "vtktypeuint64" => Self::U64,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a number.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// The number that as many bytes hold, in ascending order of significance where `is_little`.
    pub fn number(self, bytes: &[u8], is_little: bool) -> f64 {
        let mut word = [0; 8];
        word[..bytes.len()].copy_from_slice(bytes);
        if !is_little {
            word[..bytes.len()].reverse();
        }
        let bits = u64::from_le_bytes(word);
        match self {
            Self::I8 => f64::from(bits as i8),
            Self::I16 => f64::from(bits as i16),
            Self::I32 => f64::from(bits as i32),
            Self::I64 => bits as i64 as f64,
            Self::U8 | Self::U16 | Self::U32 | Self::U64 => bits as f64,
            Self::F32 => f32::from_bits(bits as u32).into(),
            Self::F64 => f64::from_bits(bits),
        }
    }

    /// The numbers that bytes hold.
    ///
    /// # Errors
    /// Where the budget has no room for them.
    #[cfg(any(feature = "gifti", feature = "vtk"))]
    pub fn numbers(self, budget: &Budget, bytes: &[u8], is_little: bool) -> Result<Vec<f64>> {
        let mut numbers = budget.list(bytes.len() / self.size())?;
        numbers.extend(bytes.chunks_exact(self.size()).map(|bytes| self.number(bytes, is_little)));
        Ok(numbers)
    }
}

/// The value as a count or an index, if it is one.
pub fn whole(value: f64) -> Option<u64> {
    (value >= 0.0 && value < (1_u64 << 53) as f64 && value.fract() == 0.0).then_some(value as u64)
}
