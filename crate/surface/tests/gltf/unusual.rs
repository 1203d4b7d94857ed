//! What is rare, or written against the specification and still clear: the square is read as from any other file.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use heatwalk_surface::Error;
use serde_json::json;

use crate::document::square;
use crate::reading::{part_names, read};

const MARK: &[u8] = b"\xEF\xBB\xBF";

/// The bytes of a GLB file with another JSON chunk.
fn with_json(glb: &[u8], json: &[u8]) -> Vec<u8> {
    let length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
    let mut bytes = glb[..12].to_vec();
    bytes.extend((json.len() as u32).to_le_bytes());
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend(&glb[20 + length..]);
    bytes
}

#[test]
fn what_is_around_the_chunks_of_a_container_does_not_matter() {
    let glb = square(json!([{ "mesh": 0 }])).glb();
    let expected = read("mesh.glb", &glb).unwrap();
    let length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
    let json = &glb[20..20 + length];
    let zeros = with_json(&glb, &[json, &[0; 4]].concat());
    let marked = with_json(&glb, &[MARK, json].concat());
    let behind = [&glb[..], b"left behind the end of the file"].concat();
    let mut unknown_length = glb.clone();
    unknown_length[8..12].fill(0);
    for (bytes, what) in [
        (zeros, "zeros for spaces"),
        (marked, "a byte order mark"),
        (behind, "bytes behind the end"),
        (unknown_length, "no length"),
    ] {
        assert_eq!(read("mesh.glb", bytes).as_ref(), Ok(&expected), "{what}");
    }
    assert!(matches!(read("mesh.glb", &glb[..glb.len() - 4]), Err(Error::Malformed { .. })), "the data are cut short");
}

#[test]
fn text_that_cannot_be_read_is_told_in_plain_words() {
    let text = square(json!([{ "mesh": 0 }])).gltf("data:,");
    let units = |bytes: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(bytes).collect::<Vec<_>>();
    let nested = |depth: usize| format!("{{\"extras\":{}{}}}", "[".repeat(depth), "]".repeat(depth)).into_bytes();
    for (bytes, words) in [
        (units(u16::to_le_bytes), "this is UTF-16 text"),
        ([&[0xFF, 0xFE], &*units(u16::to_le_bytes)].concat(), "this is UTF-16 text"),
        ([&[0xFE, 0xFF], &*units(u16::to_be_bytes)].concat(), "this is UTF-16 text"),
        (nested(500), "more than 127 deep"),
        (text.as_bytes()[..text.len() / 2].to_vec(), "the text is cut short here"),
        (Vec::new(), "mesh.gltf is an empty file"),
    ] {
        let error = read("mesh.gltf", bytes).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
        assert!(!error.contains("EOF") && !error.contains("recursion"), "{error}");
    }
    assert!(!read("mesh.gltf", nested(126)).unwrap_err().to_string().contains("deep"));
}

#[test]
fn data_uris_are_percent_encoded_or_in_base64_of_any_layout() {
    let builder = square(json!([{ "mesh": 0 }]));
    let expected = builder.read().unwrap();
    let percent: String = builder.binary.iter().map(|byte| format!("%{byte:02X}")).collect();
    // The binary of the square by another program's base64.
    let lines = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAA\r\nAACAPwAAgD8AAAAA\n AAAAAAAAgD8AAAAAAAECAAID";
    assert_eq!(builder.binary.len(), 54);
    for uri in [
        format!("data:application/octet-stream,{percent}"),
        format!("data:;base64,{lines}"),
        format!("DATA:text/plain;charset=utf-8;Base64,{}", lines.replace('I', "%49")),
    ] {
        assert_eq!(read("mesh.gltf", builder.gltf(&uri)).as_ref(), Ok(&expected), "{uri}");
    }
    let without_data = read("mesh.gltf", builder.gltf("data:application/octet-stream")).unwrap_err();
    assert!(without_data.to_string().contains("buffer 0"), "{without_data}");
}

#[test]
fn a_scene_may_list_nodes_that_are_not_roots() {
    let mut builder = square(json!([{ "children": [1], "translation": [1, 0, 0] }, { "mesh": 0, "name": "below" }]));
    let expected = builder.read().unwrap();
    for nodes in [json!([0, 1]), json!([1, 0]), json!([0, 0])] {
        builder.root["scenes"] = json!([{ "nodes": nodes }]);
        let soup = builder.read().unwrap();
        assert_eq!(part_names(&soup), ["below"], "{nodes}");
        assert_eq!(soup.positions, expected.positions, "{nodes}");
    }
}

#[test]
fn a_cycle_is_named_where_there_is_no_scene() {
    let error = square(json!([{}, { "mesh": 0, "children": [1] }])).read().unwrap_err();
    assert!(error.to_string().contains("node 1"), "{error}");
}

#[test]
fn a_pointer_to_a_large_file_is_called_so() {
    for name in ["mesh.glb", "mesh.obj"] {
        let error = read(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0a\nsize 3\n").unwrap_err();
        assert!(error.to_string().contains(&format!("Git LFS, {name}")), "{error}");
    }
}
