#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use super::*;

/// 40 elements of 12 bytes, whose bytes change in all the ways that have a coding of their own.
fn elements() -> Vec<u8> {
    let mut state = 1_u32;
    let mut random = || {
        state = state.wrapping_mul(1_103_515_245).wrapping_add(12_345);
        (state >> 16) as u8
    };
    (0..40_u16)
        .flat_map(|i| {
            let rare = if i % 5 == 0 { random() } else { 7 };
            let mut element = [0; 12];
            element[..2].copy_from_slice(&(3 * i).to_le_bytes());
            element[2..4].copy_from_slice(&(1000 - 7 * i).to_le_bytes());
            element[4..8].copy_from_slice(&(f32::from(i) / 8.0 - 1.0).to_le_bytes());
            element[8..].copy_from_slice(&[rare, random(), (i >> 2) as u8, 0]);
            element
        })
        .collect()
}

// Made by meshoptimizer 1.3.0: `encodeVertexBufferLevel` of these elements, in version 0, and in version 1 at levels 0, 2
// and 3; `encodeIndexBuffer` and `encodeIndexSequence`.
const VERSION_0: &str = "\
    a02a066666666666666666666666666666666666666600000000002a0ddddddddddddddddddddddddddddddddddddddd0000000010040000\
    0000001f003f3f3f3f7f7fff0000ff808040404040202020202020202010101010101010ffff00001010101010101010050010f080847c00\
    00800015303c0f0382494aeae954c0f03c0f53c0bf6a69696a03c000009c9b1f00062b3f9f00b2bb71447a75b3f4833ef038c5703e425ba2\
    435dddd885d01438ffff00006ec8304910ee9113150080808080808080808000000000000000000000000000000000000000000000000000\
    e803000080bfc67e0000";
const VERSION_1_BYTES: &str = "\
    a1595a952a0666666666666666666666666666666666666666000000002a0ddddddddddddddddddddddddddddddddddddddd000000000000\
    0000000400010cfefc3f3f3f3f7f7fffff808040404040202020202020202010101010101010ff00101010101010101000201301847c0200\
    0102000000628c82494aeae95431c653c0bf6a69696a18009c9b0f00062b3f9f00b2bb71447a75b3f4833ef038c5703e425ba2435dddd885\
    d01438ff006ec8304910ee9113150080808080808080808000000000000000000000000000e803000080bfc67e0000000000";
const VERSION_1_SHORTS: &str = "\
    a1993a9d2a0666666666666666666666666666666666666666000000002a0ddddddddddddddddddddddddddddddddddddddd00000000003f\
    3f3f3f7f7fff0000008080404040402020202020202020101010101010101010101010101010010007847c0100628c82494aeae95431c653\
    c0bf6a69696a18009c9b00062b3f9f00b2bb71447a75b3f4833ef038c5703e425ba2435dddd885d014386ec8304910ee9113150080808080\
    808080808000000000000000000000000000e803000080bfc67e0000010100";
const VERSION_1_XOR: &str = "\
    a199689d2a0666666666666666666666666666666666666666000000002a0ddddddddddddddddddddddddddddddddddddddd000000000500\
    03170700010f1a0f4c4f8ffff8f4c41c3810c0c01038f262e262f13171311cfedddd00000f03070300628c82494aeae95431c653c0bf6a69\
    696a18009c9b00062b3f9f00b2bb71447a75b3f4833ef038c5703e425ba2435dddd885d014386ec8304910ee911315008080808080808080\
    8000000000000000000000000000e803000080bfc67e0000015200";
const TRIANGLES: &str = "e1f010feffffff1e1ff00cff0202027f11e0c508ffcbc508020217007687566778a9866589689801690000";
const INDICES: &str = "d10004cd010407981fb701a0ec100500000000";

const CORNERS: [u32; 24] = [0, 1, 2, 2, 1, 3, 4, 6, 5, 7, 8, 9, 0, 3, 70000, 10, 11, 12, 12, 11, 13, 13, 11, 1];
const SEQUENCE: [u32; 9] = [0, 1, 51, 2, 49, 1000, 3, 70000, 4];

fn bytes(hex: &str) -> Vec<u8> {
    hex.as_bytes().chunks(2).map(|two| u8::from_str_radix(str::from_utf8(two).unwrap(), 16).unwrap()).collect()
}

fn compression(mode: &str, filter: &str, count: usize, stride: usize) -> Decoded<Compression> {
    let extension = format!(
        r#"{{ "buffer": 0, "byteLength": 0, "mode": "{mode}", "filter": "{filter}", "count": {count}, "byteStride": {stride} }}"#
    );
    Compression::parse(&deserialize::from_str(&extension).unwrap())
}

fn decode(mode: &str, count: usize, stride: usize, stream: &[u8]) -> Decoded<Vec<u8>> {
    compression(mode, "NONE", count, stride)?.decode(stream)
}

#[test]
fn attributes_of_both_versions() {
    for stream in [VERSION_0, VERSION_1_BYTES, VERSION_1_SHORTS, VERSION_1_XOR] {
        assert_eq!(decode("ATTRIBUTES", 40, 12, &bytes(stream)), Ok(elements()), "{stream}");
    }
}

#[test]
fn attributes_of_many_blocks() {
    // Four blocks without differences, the padding, the element before the first one and the mode of its channel.
    let stream = [&[0xa1, 0xaa, 0xaa, 0xaa, 0xaa][..], &[0; 19], &[1, 2, 3, 4, 0]].concat();
    let decoded = decode("ATTRIBUTES", 1000, 4, &stream).unwrap();
    assert!(decoded.chunks(4).all(|element| element == [1, 2, 3, 4]) && decoded.len() == 4000);
}

#[test]
fn triangles_and_indices_of_both_sizes() {
    let wide: Vec<u8> = CORNERS.iter().flat_map(|corner| corner.to_le_bytes()).collect();
    assert_eq!(decode("TRIANGLES", 24, 4, &bytes(TRIANGLES)), Ok(wide));
    let wide: Vec<u8> = SEQUENCE.iter().flat_map(|index| index.to_le_bytes()).collect();
    assert_eq!(decode("INDICES", 9, 4, &bytes(INDICES)), Ok(wide));
    assert!(decode("INDICES", 9, 2, &bytes(INDICES)).is_err(), "70000 has 17 bits");
    let narrow = [0xd1, 0, 4, 8, 0, 0, 0, 0];
    assert_eq!(decode("INDICES", 3, 2, &narrow), Ok(vec![0, 0, 1, 0, 3, 0]));
}

/// The components of elements of `stride` bytes, four each.
fn components(bytes: &[u8], stride: usize) -> Vec<i32> {
    if stride == 4 {
        bytes.iter().map(|&byte| i32::from(byte as i8)).collect()
    } else {
        bytes.as_chunks().0.iter().map(|&two| i32::from(i16::from_le_bytes(two))).collect()
    }
}

// Made by meshoptimizer 1.3.0, with as many bits as the comments say.
#[test]
fn filters() {
    let near = |found: Vec<i32>, expected: &[f64], largest: f64, bits: u32| {
        assert_eq!(found.len(), expected.len());
        // Half a step of the coded components, which a square root or a division can double.
        let bound = 2.0 / f64::from(1 << bits) + 1.0 / largest;
        for (&found, &expected) in found.iter().zip(expected) {
            let found = f64::from(found) / largest;
            assert!((found - expected).abs() <= bound, "{found} should be {expected}");
        }
    };
    let vectors = [1., 0., 0., 1., 0., 0.6, 0.8, -1., 0., 0., -1., 1., -0.48, 0.6, -0.64, -1.];
    let mut coded = bytes("7f007f7f00367f817f7f7f7fad5c7f81"); // 8 bits
    filter::octahedral(&mut coded, 4);
    near(components(&coded, 4), &vectors, 127.0, 8);
    let mut coded = bytes("ff070000ff07ff7f00006d03ff070180ff07ff07ff07ff7fcbfac405ff070180"); // 12 bits
    filter::octahedral(&mut coded, 8);
    near(components(&coded, 8), &vectors, 32767.0, 12);

    let mut coded = bytes("000000000000ff7f825a825a825afc7f1a124a81e6edfd7f000064930000fc7f"); // 16 bits
    filter::quaternion(&mut coded, 8);
    let rotations = [0., 0., 0., 1., 0.5, 0.5, 0.5, 0.5, -0.1, 0.7, 0.1, -0.7, 0.8, 0., -0.6, 0.];
    near(components(&coded, 8), &rotations, 32767.0, 14);

    let mut coded = bytes("000006ee9a99f9ea18a8040f35f9fbd5000000ea000007f0"); // 20 bits
    filter::exponential(&mut coded, 12);
    let found = coded.as_chunks().0.iter().map(|&four| f32::from_le_bytes(four));
    for (found, expected) in found.zip([1.5_f32, -0.1, 1e10, -3e-8, 0.0, 7.0]) {
        assert!((found - expected).abs() <= expected.abs() * 1e-5, "{found} should be {expected}");
    }

    let colors = [1., 0., 0., 1., 0.2, 0.4, 0.6, 0.8, 0., 0., 0., 0., 1., 1., 1., 0.5];
    let mut coded = bytes("407fc1ff66cd00e600000080ff0000c0"); // 8 bits
    filter::color(&mut coded, 4);
    near(coded.iter().map(|&byte| byte.into()).collect(), &colors, 255.0, 7);
    let mut coded = bytes("0004ff0701fcff0f6606cdfc0000660e0000000000000008ff0f00000000000c"); // 12 bits
    filter::color(&mut coded, 8);
    near(components(&coded, 8).into_iter().map(|signed| signed & 0xffff).collect(), &colors, 65535.0, 11);
}

#[test]
fn impossible_views_are_refused() {
    for (mode, filter, stride) in [
        ("ATTRIBUTES", "NONE", 0),
        ("ATTRIBUTES", "NONE", 6),
        ("ATTRIBUTES", "NONE", 260),
        ("ATTRIBUTES", "QUATERNION", 4),
        ("ATTRIBUTES", "OCTAHEDRAL", 12),
        ("ATTRIBUTES", "SOMETHING", 4),
        ("TRIANGLES", "NONE", 1),
        ("INDICES", "NONE", 8),
        ("SOMETHING", "NONE", 4),
    ] {
        assert!(compression(mode, filter, 3, stride).is_err(), "{mode} {filter} {stride}");
    }
}

#[test]
fn counts_without_bytes_reserve_nothing() {
    for count in [1 << 20, 1 << 30, usize::MAX] {
        assert!(decode("ATTRIBUTES", count, 12, &bytes(VERSION_0)).is_err());
        assert!(decode("ATTRIBUTES", count, 12, &bytes(VERSION_1_XOR)).is_err());
        assert!(decode("TRIANGLES", count / 3 * 3, 4, &bytes(TRIANGLES)).is_err());
        assert!(decode("INDICES", count, 4, &bytes(INDICES)).is_err());
    }
}

#[test]
fn damaged_streams_do_not_panic() {
    let mut random = SplitMix64::seed_from_u64(1);
    for (mode, count, stride, stream) in [
        ("ATTRIBUTES", 40, 12, VERSION_0),
        ("ATTRIBUTES", 40, 12, VERSION_1_BYTES),
        ("ATTRIBUTES", 40, 12, VERSION_1_XOR),
        ("TRIANGLES", 24, 4, TRIANGLES),
        ("INDICES", 9, 4, INDICES),
    ] {
        let stream = bytes(stream);
        for length in 0..stream.len() {
            assert!(
                decode(mode, count, stride, &stream[..length]).is_err(),
                "{mode}, {length} bytes of {}",
                stream.len()
            );
        }
        for _ in 0..2000 {
            let mut damaged = stream.clone();
            for _ in 0..random.random_range(1..=3) {
                damaged[random.random_range(0..stream.len())] = random.random();
            }
            if let Ok(decoded) = decode(mode, count, stride, &damaged) {
                assert_eq!(decoded.len(), count * stride);
            }
        }
    }
}
