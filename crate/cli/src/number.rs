//! Numbers of a matrix.

use clap::ValueEnum;

/// How numbers are written.
#[derive(Debug, Clone, Copy, Default, PartialEq, ValueEnum)]
pub enum Number {
    F32,
    #[default]
    F64,
}

impl Number {
    /// As NumPy writes it.
    pub fn descriptor(self) -> &'static str {
        match self {
            Self::F32 => "<f4",
            Self::F64 => "<f8",
        }
    }

    pub fn bytes(self) -> usize {
        match self {
            Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub fn push(self, value: f64, bytes: &mut Vec<u8>) {
        match self {
            Self::F32 => bytes.extend((value as f32).to_le_bytes()),
            Self::F64 => bytes.extend(value.to_le_bytes()),
        }
    }

    /// With as many digits as tell it from all others.
    pub fn written(self, value: f64) -> String {
        match self {
            Self::F32 => format!("{:.8e}", value as f32),
            Self::F64 => format!("{value:.16e}"),
        }
    }
}
