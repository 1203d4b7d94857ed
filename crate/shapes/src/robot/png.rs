//! PNG files without compression (W3C, "Portable Network Graphics", third edition; RFC 1950 and 1951).

/// Most bytes of a stored block of deflate.
const LARGEST_BLOCK: usize = 0xFFFF;

/// A square image of `size²` RGB texels, row by row from the top.
pub fn encode(size: u32, texels: &[u8]) -> Vec<u8> {
    // Each row begins with its filter, which is none.
    let rows = texels.chunks(3 * size as usize);
    let filtered: Vec<u8> = rows.flat_map(|row| std::iter::once(0).chain(row.iter().copied())).collect();
    let mut packed = vec![0x78, 0x01];
    let mut blocks = filtered.chunks(LARGEST_BLOCK).peekable();
    while let Some(block) = blocks.next() {
        let length = block.len() as u16;
        packed.push(u8::from(blocks.peek().is_none()));
        packed.extend(length.to_le_bytes());
        packed.extend((!length).to_le_bytes());
        packed.extend(block);
    }
    packed.extend(adler32(&filtered).to_be_bytes());

    let mut file = b"\x89PNG\r\n\x1A\n".to_vec();
    let [width, height] = [size.to_be_bytes(); 2];
    // Eight bits a channel, RGB.
    add_chunk(&mut file, *b"IHDR", &[&width[..], &height, &[8, 2, 0, 0, 0]].concat());
    add_chunk(&mut file, *b"IDAT", &packed);
    add_chunk(&mut file, *b"IEND", &[]);
    file
}

fn add_chunk(file: &mut Vec<u8>, kind: [u8; 4], content: &[u8]) {
    file.extend((content.len() as u32).to_be_bytes());
    let start = file.len();
    file.extend(kind);
    file.extend(content);
    let check = crc32(&file[start..]);
    file.extend(check.to_be_bytes());
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 })
    })
}

fn adler32(bytes: &[u8]) -> u32 {
    const MODULUS: u32 = 65_521;
    let (a, b) = bytes.iter().fold((1, 0), |(a, b), &byte| {
        let a = (a + u32::from(byte)) % MODULUS;
        (a, (b + a) % MODULUS)
    });
    b << 16 | a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checks_are_those_of_the_specifications() {
        let file = encode(1, &[1, 2, 3]);
        assert_eq!(file[file.len() - 12..], *b"\0\0\0\0IEND\xAE\x42\x60\x82");
        assert_eq!(adler32(b"Wikipedia"), 0x11E6_0398);
    }

    #[test]
    fn blocks_hold_all_rows() {
        let texels: Vec<u8> = (0..3 * 200 * 200).map(|number| number as u8).collect();
        let file = encode(200, &texels);
        // Signature, header, then the length of the data, its name and the two bytes before its blocks.
        let mut rest = &file[8 + 25 + 8 + 2..];
        let mut stored = Vec::new();
        while let [is_last, a, b, c, d, after @ ..] = rest {
            let length = usize::from(u16::from_le_bytes([*a, *b]));
            assert_eq!([a ^ c, b ^ d], [0xFF; 2]);
            stored.extend_from_slice(&after[..length]);
            rest = &after[length..];
            if *is_last == 1 {
                break;
            }
        }
        let rows: Vec<u8> = stored.chunks(601).flat_map(|row| &row[1..]).copied().collect();
        assert_eq!(rows, texels);
    }
}
