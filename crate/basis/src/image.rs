//! Texels of an image. The formats are those of the Khronos Data Format Specification 1.3: ETC1S (24) and UASTC (25).

use basisu::basislz::etc1s::Etc1sTranscoder;
use basisu::ktx2::{BasisFormat, Ktx2Header};
use basisu::uastc::unpack::unpack_uastc;
use ruzstd::decoding::StreamingDecoder;
use ruzstd::io::Read;

use crate::container::{ZSTANDARD, header_of, level, section, u16_at, u32_at};
use crate::error::Error;

/// Texels either way that are decoded at most: their 256 MiB fit beside the rest of a page.
pub const LARGEST_SIDE: u32 = 8192;

/// Texels either way of a block, and its bytes in UASTC.
const BLOCK_SIDE: u32 = 4;
const BLOCK_BYTES: usize = 16;

/// Bytes of the BasisLZ global header and of what follows it for each image (KTX 2.0, annex BasisLZ).
const GLOBAL_HEADER: usize = 20;
const IMAGE_DESCRIPTION: usize = 20;

/// A decoded image.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Image {
    /// Texels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `height × width × 4`: red, green, blue and alpha, alpha not multiplied in; from the top row down.
    pub texels: Vec<u8>,
}

/// Decodes the largest level with at most `wanted` texels either way, else the smallest.
///
/// # Errors
/// Where the file is damaged, no image of glTF, or has no level of at most [`LARGEST_SIDE`] texels either way.
pub fn decode(file: &[u8], wanted: u32) -> Result<Image, Error> {
    let header = header_of(file)?;
    let size = |level: usize| [header.width, header.height].map(|side| (side >> level).max(1));
    let fits = |&level: &usize| size(level).into_iter().all(|side| side <= wanted);
    let levels = header.levels.len();
    let index = (0..levels).find(fits).unwrap_or(levels - 1);
    let [width, height] = size(index);
    if width.max(height) > LARGEST_SIDE {
        return Err(Error::TooLarge(width, height));
    }
    let bytes = level(file, &header, index).ok_or(Error::Texels)?;
    let mut image = Image { width, height, texels: vec![0; 4 * width as usize * height as usize] };
    let decoded = match header.format {
        BasisFormat::Etc1s => decode_etc1s(file, &header, index, bytes, &mut image),
        _ => decode_uastc(&header, bytes, &mut image),
    };
    decoded.ok_or(Error::Texels)?;
    Ok(image)
}

fn decode_uastc(header: &Ktx2Header, bytes: &[u8], image: &mut Image) -> Option<()> {
    let [columns, rows] = blocks_of(image);
    let length = columns as usize * rows as usize * BLOCK_BYTES;
    let inflated;
    let blocks = if header.supercompression == ZSTANDARD {
        inflated = inflate(bytes, length)?;
        &inflated
    } else {
        bytes.get(..length)?
    };
    let (blocks, _) = blocks.as_chunks::<BLOCK_BYTES>();
    for (index, block) in (0..).zip(blocks) {
        // Without the rounding of sRGB in ASTC, as the reference decoder gives texels of either color space.
        let texels = unpack_uastc(block, false)?;
        let [left, top] = [BLOCK_SIDE * (index % columns), BLOCK_SIDE * (index / columns)];
        for (y, row) in (top..image.height).zip(texels.chunks_exact(BLOCK_SIDE as usize)) {
            for (x, texel) in (left..image.width).zip(row) {
                let at = 4 * (y as usize * image.width as usize + x as usize);
                image.texels[at..at + 4].copy_from_slice(&texel.c);
            }
        }
    }
    Some(())
}

/// Exactly so many bytes that Zstandard packed.
fn inflate(packed: &[u8], length: usize) -> Option<Vec<u8>> {
    let mut stream = StreamingDecoder::new(packed).ok()?;
    let mut bytes = vec![0; length];
    stream.read_exact(&mut bytes).ok()?;
    Some(bytes)
}

fn decode_etc1s(file: &[u8], header: &Ktx2Header, level: usize, bytes: &[u8], image: &mut Image) -> Option<()> {
    let global = section(file, header.sgd_byte_offset, header.sgd_byte_length)?;
    let [endpoints, selectors] = [u16_at(global, 0)?, u16_at(global, 2)?];
    let mut rest = global.get(GLOBAL_HEADER + IMAGE_DESCRIPTION * header.levels.len()..)?;
    let mut parts = [&[][..]; 3];
    for (index, part) in parts.iter_mut().enumerate() {
        (*part, rest) = rest.split_at_checked(u32_at(global, 4 + 4 * index)? as usize)?;
    }
    let [endpoint_data, selector_data, tables] = parts;
    let mut codebooks = Etc1sTranscoder::new();
    let is_intact = codebooks.decode_palettes(endpoints, endpoint_data, selectors, selector_data)
        && codebooks.decode_tables(tables);
    if !is_intact {
        return None;
    }
    let description = global.get(GLOBAL_HEADER + IMAGE_DESCRIPTION * level..)?;
    let slice = |offset: usize, length: usize| {
        section(bytes, u32_at(description, offset)?.into(), u32_at(description, length)?.into())
    };
    let color = slice(4, 8)?;
    let [columns, rows] = blocks_of(image);
    let (width, height, texels) = (image.width, image.height, &mut image.texels);
    if header.has_alpha {
        let alpha = slice(12, 16)?;
        codebooks.transcode_image_rgba32(color, alpha, columns, rows, width, height, None, texels)
    } else {
        codebooks.transcode_slice_rgba32(color, columns, rows, width, height, None, texels)
    }
}

/// Blocks in a row, and rows of them.
fn blocks_of(image: &Image) -> [u32; 2] {
    [image.width, image.height].map(|side| side.div_ceil(BLOCK_SIDE))
}
