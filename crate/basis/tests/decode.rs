//! Images that another program encoded are decoded; damaged ones are refused.

use heatwalk_basis::{Error, Image, decode};

/// Red and white squares of 16 × 16 texels, encoded by the reference encoder (Basis Universal 2): as ETC1S, as ETC1S with an
/// alpha of a quarter in the four columns on the right, as UASTC, and as UASTC with that alpha, levels and Zstandard.
const FILES: [(&str, &[u8], bool); 4] = [
    ("etc1s", include_bytes!("data/etc1s.ktx2"), false),
    ("etc1s-alpha", include_bytes!("data/etc1s-alpha.ktx2"), true),
    ("uastc", include_bytes!("data/uastc.ktx2"), false),
    ("uastc-zstd", include_bytes!("data/uastc-zstd.ktx2"), true),
];

/// ETC1S has five bits a channel and eight distances from them for all channels: half of the largest gaps, of 255.
const TOLERANCE: u8 = 12;

fn squares(x: usize, y: usize, has_alpha: bool) -> [u8; 4] {
    let [red, green, blue] = if (x < 8) == (y < 8) { [200, 30, 40] } else { [245, 240, 230] };
    [red, green, blue, if has_alpha && x >= 12 { 64 } else { 255 }]
}

#[test]
fn decodes_the_colors_that_were_encoded() {
    for (name, file, has_alpha) in FILES {
        let Image { width, height, texels } = decode(file, 4096).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!((width, height), (16, 16), "{name}");
        for (index, texel) in texels.chunks_exact(4).enumerate() {
            let expected = squares(index % 16, index / 16, has_alpha);
            let difference = texel.iter().zip(expected).map(|(&found, wanted)| found.abs_diff(wanted)).max();
            assert!(difference <= Some(TOLERANCE), "{name}, texel {index}: {texel:?} for {expected:?}");
        }
    }
}

#[test]
fn takes_the_level_that_is_wanted() {
    let (_, file, _) = FILES[3];
    let sizes = [16, 15, 8, 4, 3, 1, 0].map(|wanted| decode(file, wanted).map(|image| image.width));
    assert_eq!(sizes, [16, 8, 8, 4, 2, 1, 1].map(Ok));
    // One without levels comes as it is.
    assert_eq!(decode(FILES[2].1, 4).map(|image| image.width), Ok(16));
}

#[test]
fn rejects_what_is_no_image_of_gltf() {
    assert_eq!(decode(b"no image", 4096), Err(Error::Header));
    let (_, file, _) = FILES[2];
    let changed = |offset: usize, value: u32| {
        let mut file = file.to_vec();
        file[offset..offset + 4].copy_from_slice(&value.to_le_bytes());
        decode(&file, 4096)
    };
    // Six faces, then four layers.
    assert_eq!(changed(36, 6), Err(Error::Kind));
    assert_eq!(changed(32, 4), Err(Error::Kind));
    assert_eq!(changed(20, 1 << 20), Err(Error::TooLarge(1 << 20, 16)));
    // Wider than its texels reach.
    assert_eq!(changed(20, 32), Err(Error::Texels));
    // A descriptor beyond the file.
    assert_eq!(changed(48, u32::MAX), Err(Error::Header));
}

#[test]
fn damaged_files_are_refused_or_decoded_without_panic() {
    for (_, file, _) in FILES {
        for length in 0..file.len() {
            let _ = decode(&file[..length], 4096);
        }
        for position in 0..file.len() {
            for change in [0x01, 0x80, 0xff] {
                let mut damaged = file.to_vec();
                damaged[position] ^= change;
                let _ = decode(&damaged, 4096);
            }
        }
    }
}
