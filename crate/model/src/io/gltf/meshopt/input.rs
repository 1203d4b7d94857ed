//! The bytes of a stream, each read checked.

/// A value, or what is wrong with the stream.
pub type Decoded<T> = Result<T, &'static str>;

pub const CUT_SHORT: &str = "its compressed data is cut short";
pub const TOO_LONG: &str = "its compressed data is too long";

pub struct Input<'a>(pub &'a [u8]);

impl<'a> Input<'a> {
    pub fn take(&mut self, count: usize) -> Decoded<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count).ok_or(CUT_SHORT)?;
        self.0 = rest;
        Ok(taken)
    }

    pub fn byte(&mut self) -> Decoded<u8> {
        let (&byte, rest) = self.0.split_first().ok_or(CUT_SHORT)?;
        self.0 = rest;
        Ok(byte)
    }

    /// An unsigned LEB128 number of at most five bytes.
    pub fn varint(&mut self) -> Decoded<u32> {
        let mut value = 0;
        for shift in [0, 7, 14, 21, 28] {
            let byte = self.byte()?;
            value |= u32::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err("a number in its compressed data is too long")
    }

    /// A stream must be used up exactly.
    pub fn end(&self) -> Decoded<()> {
        if self.0.is_empty() { Ok(()) } else { Err(TOO_LONG) }
    }
}
