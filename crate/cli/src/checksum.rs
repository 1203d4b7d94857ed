//! Checksums of what is on the disk.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use rawzip::Crc32;

/// Bytes that are read at once.
const CHUNK: usize = 1 << 20;

/// Of the next bytes of a file; none where there are fewer.
pub fn checksum(file: &mut File, length: u64) -> io::Result<Option<u32>> {
    let (mut checksum, mut left) = (Crc32::new(), length);
    let mut bytes = vec![0; CHUNK];
    while left > 0 {
        let some = &mut bytes[..CHUNK.min(usize::try_from(left).unwrap_or(CHUNK))];
        match file.read(some)? {
            0 => return Ok(None),
            read => {
                checksum.update(&some[..read]);
                left -= read as u64;
            }
        }
    }
    Ok(Some(checksum.checksum()))
}

/// How many bytes a file has, and their checksum; none of what cannot be read as a whole.
pub fn of_file(path: &Path) -> Option<(u64, u32)> {
    let mut file = File::open(path).ok()?;
    let length = file.metadata().ok().filter(|metadata| metadata.is_file())?.len();
    Some((length, checksum(&mut file, length).ok()??))
}
