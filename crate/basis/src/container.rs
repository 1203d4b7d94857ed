//! Where a KTX 2.0 file has its parts. Sections are those of the KTX File Format Specification 2.0.

use basisu::ktx2::{BasisFormat, Ktx2Header};

use crate::error::Error;

/// Of `supercompressionScheme` (3.6).
pub const ZSTANDARD: u32 = 2;

/// Bytes before the offset of the data format descriptor (3.1).
const DESCRIPTOR_OFFSET: usize = 48;

/// Bytes of the descriptor that its reader looks at: it does not ask whether they are there on 32-bit machines.
const DESCRIPTOR_READ: usize = 32;

/// The header of a file that holds one image in ETC1S or UASTC (KHR_texture_basisu: no cubes, arrays or high dynamic range).
pub fn header_of(file: &[u8]) -> Result<Ktx2Header, Error> {
    let descriptor = u32_at(file, DESCRIPTOR_OFFSET).ok_or(Error::Header)?;
    section(file, descriptor.into(), DESCRIPTOR_READ as u64).ok_or(Error::Header)?;
    let header = Ktx2Header::parse(file).ok_or(Error::Header)?;
    let is_one = header.face_count == 1 && header.layer_count <= 1;
    if !is_one || !matches!(header.format, BasisFormat::Etc1s | BasisFormat::Uastc) {
        return Err(Error::Kind);
    }
    Ok(header)
}

/// The bytes of a level, as the file has them.
pub fn level<'a>(file: &'a [u8], header: &Ktx2Header, level: usize) -> Option<&'a [u8]> {
    let index = header.levels.get(level)?;
    section(file, index.byte_offset, index.byte_length)
}

/// So many bytes from an offset on.
pub fn section(bytes: &[u8], offset: u64, length: u64) -> Option<&[u8]> {
    bytes.get(usize::try_from(offset).ok()?..usize::try_from(offset.checked_add(length)?).ok()?)
}

/// A number of 16 bits at an offset.
pub fn u16_at(bytes: &[u8], offset: usize) -> Option<u32> {
    let bytes = bytes.get(offset..offset.checked_add(2)?)?;
    Some(u16::from_le_bytes(bytes.try_into().ok()?).into())
}

/// A number of 32 bits at an offset.
pub fn u32_at(bytes: &[u8], offset: usize) -> Option<u32> {
    let bytes = bytes.get(offset..offset.checked_add(4)?)?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}
