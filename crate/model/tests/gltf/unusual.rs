//! What is rare, or written against the specification and still clear: the square is read as from any other file.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use heatwalk_model::Error;
use serde_json::{Value, json};

use super::document::square;
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
        (Vec::new(), "mesh.gltf is empty"),
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

/// Puts each of some values in the place of each value of a document.
fn with_each_value_replaced(document: &Value, mut read: impl FnMut(&Value)) {
    fn places(value: &Value, place: &str, all: &mut Vec<String>) {
        all.push(place.to_owned());
        match value {
            Value::Object(object) => {
                object.iter().for_each(|(key, value)| places(value, &format!("{place}/{key}"), all));
            }
            Value::Array(list) => {
                list.iter().enumerate().for_each(|(at, value)| places(value, &format!("{place}/{at}"), all));
            }
            _ => {}
        }
    }
    let mut all = Vec::new();
    places(document, "", &mut all);
    for place in all {
        for other in [
            json!(null),
            json!(true),
            json!(7),
            json!(-1.5),
            json!(1e300),
            json!("a"),
            json!([]),
            json!([1]),
            json!({}),
        ] {
            let mut document = document.clone();
            *document.pointer_mut(&place).expect("a place of the document") = other;
            read(&document);
        }
    }
}

#[test]
fn no_value_of_another_type_anywhere_makes_a_reader_panic() {
    let mut builder = square(json!([{
        "mesh": 0, "camera": 0, "name": "a", "weights": [0.5], "rotation": [0, 0, 0, 1],
        "extensions": { "KHR_lights_punctual": { "light": 0 }, "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": 0 } } }
    }, { "mesh": 0, "skin": 0 }]));
    let more = json!({
        "scenes": [{ "nodes": [0, 1] }], "scene": 0,
        "extensionsUsed": ["KHR_animation_pointer"], "extensionsRequired": [],
        "cameras": [{ "type": "perspective", "perspective": { "yfov": 1, "znear": 1 } }],
        "skins": [{ "joints": [0], "inverseBindMatrices": 0 }],
        "extensions": { "KHR_lights_punctual": { "lights": [
            { "type": "spot", "color": [1, 1, 1], "intensity": 2, "spot": { "innerConeAngle": 0.1, "outerConeAngle": 0.2 } }
        ] } },
        "animations": [{ "name": "b", "samplers": [{ "input": 0, "output": 0, "interpolation": "LINEAR" }], "channels": [
            { "sampler": 0, "target": { "node": 0, "path": "translation" } },
            { "sampler": 0, "target": { "path": "pointer",
                "extensions": { "KHR_animation_pointer": { "pointer": "/nodes/0/translation" } } } }
        ] }],
        "images": [{ "uri": "a.png" }, { "bufferView": 0, "mimeType": "image/png" }],
        "samplers": [{ "wrapS": 33071, "magFilter": 9728 }],
        "textures": [{ "source": 0, "sampler": 0, "extensions": { "EXT_texture_webp": { "source": 1 } } }],
        "materials": [{
            "pbrMetallicRoughness": { "baseColorTexture": { "index": 0, "texCoord": 0, "extensions": {
                "KHR_texture_transform": { "offset": [0, 1], "scale": [1, 2], "rotation": 1, "texCoord": 1 } } } },
            "normalTexture": { "index": 0, "scale": 1 }, "occlusionTexture": { "index": 0, "strength": 1 },
            "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 2 }, "KHR_materials_sheen": { "a": 1 },
                "KHR_materials_pbrSpecularGlossiness": { "diffuseFactor": [1, 1, 1, 1], "glossinessFactor": 0.5,
                    "diffuseTexture": { "index": 0 } } }
        }],
    });
    let root = builder.root.as_object_mut().expect("a document");
    root.extend(more.as_object().expect("more of it").clone());
    builder.root["meshes"][0]["weights"] = json!([1]);
    let primitive = &mut builder.root["meshes"][0]["primitives"][0];
    primitive["material"] = json!(0);
    primitive["targets"] = json!([{ "POSITION": 0 }]);
    primitive["attributes"]["_OWN"] = json!(0);
    let draco = json!({ "KHR_draco_mesh_compression": { "bufferView": 0, "attributes": { "POSITION": 0 } } });
    let meshopt = json!({ "EXT_meshopt_compression":
        { "buffer": 0, "byteOffset": 0, "byteLength": 8, "byteStride": 4, "count": 2, "mode": "ATTRIBUTES", "filter": "NONE" } });
    for (place, extensions) in
        [("/meshes/0", json!({})), ("/meshes/0/primitives/0", draco), ("/bufferViews/0", meshopt)]
    {
        let uri = format!("data:;base64,{}", "AAAA".repeat(builder.binary.len().div_ceil(3)));
        let mut document: Value = serde_json::from_str(&builder.gltf(&uri)).expect("a document");
        document.pointer_mut(place).expect("a place of the document")["extensions"] = extensions;
        with_each_value_replaced(&document, |document| drop(read("a.gltf", document.to_string())));
    }
    for document in
        [r#"{"asset":{"version":"2.0"},"animations":[1]}"#, r#"{"asset":1,"animations":[{"channels":[[]]}]}"#]
    {
        assert!(read("a.gltf", document).is_err(), "{document}");
    }
}
