//! Numbers and text of a file, the most significant byte first.

use glam::DVec3;

use crate::error::Result;
use crate::io::reader::Reporter;

pub const FREESURFER: Reporter = Reporter("FreeSurfer");

/// What is left of a file.
pub struct Bytes<'a> {
    all: &'a [u8],
    place: usize,
}

impl<'a> Bytes<'a> {
    pub fn new(all: &'a [u8]) -> Self {
        Self { all, place: 0 }
    }

    /// Bytes before.
    pub fn place(&self) -> usize {
        self.place
    }

    fn cut_short(&self) -> crate::Error {
        FREESURFER.at(format!("byte {}", self.all.len()), "the file is cut short; copy it again")
    }

    fn rest(&self) -> &[u8] {
        &self.all[self.place..]
    }

    /// Refuses a file that is too short for so many items of so many bytes.
    pub fn require(&self, count: u64, size: usize) -> Result<()> {
        let is_there = count.checked_mul(size as u64).is_some_and(|size| size <= self.rest().len() as u64);
        if is_there { Ok(()) } else { Err(self.cut_short()) }
    }

    pub fn take<const N: usize>(&mut self) -> Result<[u8; N]> {
        let taken = self.rest().first_chunk().copied().ok_or_else(|| self.cut_short())?;
        self.place += N;
        Ok(taken)
    }

    pub fn skip_line(&mut self) -> Result<()> {
        let end = self.rest().iter().position(|&byte| byte == b'\n').ok_or_else(|| self.cut_short())?;
        self.place += end + 1;
        Ok(())
    }

    /// Of three bytes.
    pub fn index(&mut self) -> Result<u32> {
        let [a, b, c] = self.take()?;
        Ok(u32::from_be_bytes([0, a, b, c]))
    }

    pub fn position(&mut self, width: usize) -> Result<DVec3> {
        let mut coordinates = [0.0; 3];
        for coordinate in &mut coordinates {
            *coordinate = if width == 2 {
                f64::from(i16::from_be_bytes(self.take()?)) / 100.0
            } else {
                f32::from_be_bytes(self.take()?).into()
            };
        }
        Ok(coordinates.into())
    }

    /// A number that counts something, where it is not negative.
    pub fn count(&mut self) -> Result<u32> {
        let place = self.place;
        let count = i32::from_be_bytes(self.take()?);
        let negative = || FREESURFER.at(format!("byte {place}"), "the count is not a whole number");
        u32::try_from(count).map_err(|_| negative())
    }

    /// Text of so many bytes, up to the first zero.
    pub fn text(&mut self, length: u32) -> Result<String> {
        self.require(length.into(), 1)?;
        let bytes = &self.rest()[..length as usize];
        let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
        let text = String::from_utf8_lossy(&bytes[..end]).into_owned();
        self.place += length as usize;
        Ok(text)
    }
}
