//! glTF extensions: compressed geometry, quantized geometry, and what of a file may be unknown or wrong.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::reading;

use glam::DVec3;
use heatwalk_model::{Error, Result, io};
use heatwalk_surface::{Error as SurfaceError, Soup};
use serde_json::{Value, json};

// A grid of 3 × 3 vertices (i, j, i·j / 2) with texture coordinates, colors, joints (i mod 2) and weights as attributes 0 to
// 4, compressed by draco3d 1.5.7: by Edgebreaker at speed 5, with 11 bits a coordinate, and sequentially without loss.
const EDGEBREAKER: &str = "\
    445241434f02020101000000090804080200037fda07ff0111ff028840ff028840ff028840ff02884005ff00000000000100000200000300\
    000100090300000201030902000102010202040002010104020400030101040904000402010101000c279123711c03742c7affff3f00ff0f\
    80ff01e0ff00000080ff010000000200c0ff0000e03f0000f40f0000ff0300000000ff070000000000000000000000000000000000400b01\
    0101000b03ad2a1f5515032a624cffffff3f0000fc0f0000000000ff03000000000000000000000000803f0a0101010102c90151359103ff\
    ffff139103910306dc538a25d77d00000000ff000000010101010102ad3a55050415d5ef9a00000000010000000101010101010140010000\
    000000000000000000803f0000000000000000000000000000803f08";
const SEQUENTIAL: &str = "\
    445241434f020201000000080901000104000403010205010504030407030706040508040807010500090300000309020001020204000204\
    02040003040904000400000101000000000000000000000000000000803f0000000000000000000000400000000000000000000000000000\
    803f000000000000803f0000803f0000003f000000400000803f0000803f0000000000000040000000000000803f000000400000803f0000\
    0040000000400000004000000000000000000000003f000000000000803f00000000000000000000003f0000003f0000003f0000803f0000\
    003f000000000000803f0000003f0000803f0000803f0000803f0001010101c901a92a9103ffb79103ff5b390e0800702b40cdb4af4a0000\
    0000ff00000000010100020301400100100111100100000000010000000000803f0000000000000000000000000000803f00000000000000\
    00000000000000803f0000000000000000000000000000803f0000000000000000000000000000803f000000000000000000000000000080\
    3f0000000000000000000000000000803f0000000000000000000000000000803f0000000000000000000000000000803f00000000000000\
    0000000000";

// The square of `SQUARE`: positions as ATTRIBUTES of version 1, corners as TRIANGLES, by meshoptimizer 1.3.0.
const POSITIONS: &str = "\
    a1faeaaa000000ff007f007e00007f00000000000000000000000000000000000000000000010100";
const CORNERS: &str = "e1f000007687566778a9866589689801690000";
const SQUARE: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];

fn bytes(hex: &str) -> Vec<u8> {
    hex.as_bytes().chunks(2).map(|two| u8::from_str_radix(str::from_utf8(two).unwrap(), 16).unwrap()).collect()
}

/// Reads a document whose one file is `data`.
fn read(document: &Value, data: &[u8]) -> Result<Soup> {
    io::read("mesh.gltf", document.to_string().as_bytes(), &|uri| (uri == "data.bin").then(|| data.to_vec()))
        .map(|model| model.soup)
}

/// A mesh in one primitive, compressed by Draco, with all attributes of the grid.
fn draco(data: &[u8]) -> Value {
    json!({
        "asset": { "version": "2.0" },
        "extensionsRequired": ["KHR_draco_mesh_compression"],
        "buffers": [{ "uri": "data.bin", "byteLength": data.len() }],
        "bufferViews": [{ "buffer": 0, "byteLength": data.len() }],
        "accessors": [
            { "componentType": 5123, "type": "SCALAR", "count": 24 },
            { "componentType": 5126, "type": "VEC3", "count": 9 },
            { "componentType": 5121, "type": "VEC4", "count": 9 },
            { "componentType": 5126, "type": "VEC4", "count": 9 }
        ],
        "meshes": [{ "primitives": [{
            "attributes": { "POSITION": 1, "JOINTS_0": 2, "WEIGHTS_0": 3 },
            "indices": 0,
            "extensions": { "KHR_draco_mesh_compression": {
                "bufferView": 0,
                "attributes": { "POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 2, "JOINTS_0": 3, "WEIGHTS_0": 4 }
            } }
        }] }],
        "nodes": [{ "mesh": 0 }]
    })
}

/// The triangles of the grid by the places of their corners, each from its least corner on.
fn grid() -> Vec<[[i64; 3]; 3]> {
    let place = |i: i64, j: i64| [2 * i, 2 * j, i * j];
    let cells = (0..4).map(|cell| (cell % 2, cell / 2));
    let triangles = cells.flat_map(|(i, j)| {
        let diagonal = [place(i, j), place(i + 1, j + 1)];
        [[diagonal[0], place(i + 1, j), diagonal[1]], [diagonal[0], diagonal[1], place(i, j + 1)]]
    });
    sorted(triangles.collect())
}

/// The triangles of a file in the same way, in halves.
fn halves(soup: &Soup) -> Vec<[[i64; 3]; 3]> {
    let place = |corner: u32| (2.0 * soup.positions[corner as usize]).round().to_array().map(|half| half as i64);
    sorted(soup.triangles.iter().map(|triangle| triangle.map(place)).collect())
}

fn sorted(mut triangles: Vec<[[i64; 3]; 3]>) -> Vec<[[i64; 3]; 3]> {
    for triangle in &mut triangles {
        let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap();
        triangle.rotate_left(least);
    }
    triangles.sort_unstable();
    triangles
}

#[test]
fn draco_primitives() {
    for (stream, accuracy) in [(EDGEBREAKER, 2.0 / 2047.0), (SEQUENTIAL, 0.0)] {
        let data = bytes(stream);
        let mut document = draco(&data);
        let soup = read(&document, &data).unwrap();
        assert_eq!((soup.positions.len(), halves(&soup)), (9, grid()));
        for &position in &soup.positions {
            assert!(position.distance((2.0 * position).round() / 2.0) <= accuracy, "{position}");
        }
        document["meshes"][0]["primitives"][0]["mode"] = json!(5);
        assert_eq!(read(&document, &data).unwrap(), soup, "a strip is stored as a list too");
        document["nodes"] = json!([{ "mesh": 0 }, { "mesh": 0, "translation": [0, 0, 8] }]);
        let twice = read(&document, &data).unwrap();
        assert_eq!((twice.positions.len(), twice.triangles.len()), (18, 16), "two instances");
        let primitive = document["meshes"][0]["primitives"][0].clone();
        document["meshes"][0]["primitives"] = json!([primitive, primitive]);
        let shared = read(&document, &data).unwrap();
        assert_eq!((shared.positions.len(), shared.triangles.len()), (18, 32), "primitives share vertices");
    }
}

#[test]
fn skins_of_draco_primitives() {
    for stream in [EDGEBREAKER, SEQUENTIAL] {
        let data = bytes(stream);
        let mut document = draco(&data);
        document["nodes"] = json!([{ "mesh": 0, "skin": 0 }, {}, { "translation": [0, 0, 100] }]);
        document["skins"] = json!([{ "joints": [1, 2] }]);
        for position in read(&document, &data).unwrap().positions {
            let lifted = position.x.round() == 1.0;
            assert_eq!(position.z >= 99.0, lifted, "the middle row follows the second joint: {position}");
        }
    }
}

#[test]
fn broken_draco_primitives_name_the_place() {
    let data = bytes(EDGEBREAKER);
    let change = |change: &dyn Fn(&mut Value)| {
        let mut document = draco(&data);
        change(&mut document);
        read(&document, &data).unwrap_err().to_string()
    };
    let extension = |document: &mut Value, key: &str, value: Value| {
        document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"][key] = value;
    };
    let error = change(&|document| extension(document, "attributes", json!({ "POSITION": 77 })));
    assert!(error.contains("buffer view 0") && error.contains("attribute 77"), "{error}");
    let error = change(&|document| extension(document, "attributes", json!({ "POSITION": 2 })));
    assert!(error.contains("accessor 1"), "colors have four components: {error}");
    let error = change(&|document| extension(document, "bufferView", json!(5)));
    assert!(error.contains("buffer view 5"), "{error}");
    let error = change(&|document| extension(document, "bufferView", Value::Null));
    assert!(error.contains("names no buffer view"), "{error}");
    let error = change(&|document| document["bufferViews"][0]["byteLength"] = json!(100));
    assert!(error.contains("buffer view 0") && error.contains("damaged"), "{error}");
}

#[test]
fn damaged_draco_data_does_not_panic() {
    for stream in [EDGEBREAKER, SEQUENTIAL] {
        let data = bytes(stream);
        let document = draco(&data);
        let refused = |damaged: &[u8]| match read(&document, damaged) {
            Ok(soup) => {
                assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
                false
            }
            Err(_) => true,
        };
        assert!((0..data.len()).all(|length| refused(&data[..length])), "cut short");
        assert!(reading::damaged_copies(&data).filter(|damaged| refused(damaged)).count() > 100);
    }
}

/// The square with both views compressed, and a fallback buffer without bytes.
fn meshopt(extension: &str) -> (Value, Vec<u8>) {
    let [positions, corners] = [POSITIONS, CORNERS].map(bytes);
    let view = |offset: usize, length: usize, stride: usize, mode: &str, count: usize| {
        let compressed = json!({
            "buffer": 0, "byteOffset": offset, "byteLength": length, "byteStride": stride, "mode": mode, "count": count
        });
        json!({ "buffer": 1, "byteLength": count * stride, "extensions": { extension: compressed } })
    };
    let document = json!({
        "asset": { "version": "2.0" },
        "extensionsRequired": [extension],
        "buffers": [
            { "uri": "data.bin", "byteLength": positions.len() + corners.len() },
            { "byteLength": 60, "extensions": { extension: { "fallback": true } } }
        ],
        "bufferViews": [
            view(0, positions.len(), 12, "ATTRIBUTES", 4),
            view(positions.len(), corners.len(), 2, "TRIANGLES", 6)
        ],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4 },
            { "bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 6 }
        ],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "nodes": [{ "mesh": 0 }]
    });
    (document, [positions, corners].concat())
}

#[test]
fn meshopt_buffer_views() {
    for extension in ["EXT_meshopt_compression", "KHR_meshopt_compression"] {
        let (document, data) = meshopt(extension);
        let soup = read(&document, &data).unwrap();
        let expected: Vec<DVec3> = SQUARE.as_chunks().0.iter().map(|&[x, y, z]| glam::vec3(x, y, z).into()).collect();
        assert_eq!((soup.positions, soup.triangles), (expected, vec![[0, 1, 2], [0, 2, 3]]));
    }
}

#[test]
fn broken_meshopt_views_name_the_place() {
    let (document, data) = meshopt("EXT_meshopt_compression");
    for (key, value) in [
        ("count", json!(5)),
        ("byteLength", json!(20)),
        ("byteLength", json!(2000)),
        ("byteOffset", json!(1)),
        ("buffer", Value::Null),
        ("mode", json!("SOMETHING")),
        ("filter", json!("QUATERNION")),
    ] {
        let mut document = document.clone();
        document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
        let error = read(&document, &data).unwrap_err().to_string();
        assert!(error.contains("buffer view 0"), "{key}: {error}");
    }
    let mut huge = document.clone();
    huge["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = json!(1_u64 << 30);
    assert_eq!(read(&huge, &data).unwrap_err().code(), "over-budget");
    for damaged in reading::damaged_copies(&data) {
        if let Ok(soup) = read(&document, &damaged) {
            assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
        }
    }
}

/// The square, not compressed.
fn square() -> (Value, Vec<u8>) {
    let mut data = SQUARE.map(f32::to_le_bytes).concat();
    data.extend([0, 1, 2, 0, 2, 3]);
    let document = json!({
        "asset": { "version": "2.0" },
        "buffers": [{ "uri": "data.bin", "byteLength": data.len() }],
        "bufferViews": [{ "buffer": 0, "byteLength": 48 }, { "buffer": 0, "byteOffset": 48, "byteLength": 6 }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4 },
            { "bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": 6 }
        ],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "nodes": [{ "mesh": 0 }]
    });
    (document, data)
}

#[test]
fn quantized_morph_targets() {
    let (mut document, mut data) = square();
    data.extend([0; 2]);
    data.extend([127_u8, 0, 0, 0, 0, 129, 0, 0, 0, 64, 128, 0, 0, 0, 0, 0]);
    document["bufferViews"].as_array_mut().unwrap().push(json!({
        "buffer": 0, "byteOffset": 56, "byteLength": 16, "byteStride": 4
    }));
    document["accessors"].as_array_mut().unwrap().push(json!({
        "bufferView": 2, "componentType": 5120, "type": "VEC3", "count": 4
    }));
    document["meshes"][0]["primitives"][0]["targets"] = json!([{ "POSITION": 2 }]);
    document["meshes"][0]["weights"] = json!([0.5]);
    for (normalized, unit) in [(true, 127.0), (false, 1.0)] {
        document["accessors"][2]["normalized"] = json!(normalized);
        let positions = read(&document, &data).unwrap().positions;
        let lowest = if normalized { -1.0 } else { -128.0 };
        let moved = [[127.0 / unit, 0.0, 0.0], [0.0, -127.0 / unit, 0.0], [0.0, 64.0 / unit, lowest], [0.0; 3]];
        for (vertex, moved) in moved.into_iter().enumerate() {
            let rest = DVec3::from_array(std::array::from_fn(|i| SQUARE[3 * vertex + i].into()));
            assert!(positions[vertex].distance(rest + 0.5 * DVec3::from(moved)) < 1e-12, "{normalized} {vertex}");
        }
    }
}

#[test]
fn required_extensions_refuse_a_file_only_where_geometry_has_them() {
    let (mut document, data) = square();
    let expected = read(&document, &data).unwrap();
    let looks = ["KHR_texture_basisu", "EXT_texture_webp", "KHR_materials_unlit", "KHR_lights_punctual", "ACME_sounds"];
    document["extensionsRequired"] = json!(looks);
    document["textures"] = json!([{ "extensions": { "KHR_texture_basisu": { "source": 0 } } }]);
    document["extensions"] = json!({ "ACME_sounds": {} });
    document["nodes"][0]["extensions"] = json!({ "KHR_lights_punctual": { "light": 0 } });
    document["meshes"][0]["primitives"][0]["extensions"] = json!({ "ACME_voxels": {}, "KHR_materials_unlit": {} });
    assert_eq!(read(&document, &data), Ok(expected));
    document["extensionsRequired"] = json!(["ACME_voxels"]);
    let error = read(&document, &data).unwrap_err();
    assert!(matches!(&error, Error::Unsupported { feature, .. } if feature == "ACME_voxels"), "{error}");
}

#[test]
fn version_1_is_refused_by_name() {
    let document = json!({
        "asset": { "version": "1.0" },
        "accessors": { "positions": {} },
        "meshes": { "square": { "primitives": [{ "attributes": { "POSITION": "positions" } }] } }
    });
    for asset in [json!({ "version": "1.0" }), json!({ "version": 1.0 }), json!({})] {
        let mut document = document.clone();
        document["asset"] = asset;
        let error = read(&document, &[]).unwrap_err();
        assert_eq!(error.to_string(), "glTF: version 1.0 is not supported; export the file as glTF 2.0");
    }
    let glb = b"glTF\x01\0\0\0\x14\0\0\0\0\0\0\0\0\0\0\0";
    let error = reading::read("mesh.glb", glb).unwrap_err().to_string();
    assert_eq!(error, "GLB: version 1 is not supported; export the file as glTF 2.0");
    // A byte that is missing moves all that follow.
    let moved = b"glTF\0\0\0\x24\x01\0\0\0\0\0\0\0\0\0\0\0";
    let error = reading::read("mesh.glb", moved).unwrap_err().to_string();
    assert!(error.contains("the GLB file is damaged: 603979776 is no version"), "{error}");
}

#[test]
fn what_geometry_does_not_need_may_be_wrong() {
    let (document, data) = square();
    let expected = read(&document, &data).unwrap();
    let change = |key: &str, value: Value| {
        let mut document = document.clone();
        document[key] = value;
        read(&document, &data)
    };
    for (key, value) in [
        ("animations", json!([{ "channels": [], "samplers": [{ "input": 0 }] }])),
        ("cameras", json!([{ "type": 3 }])),
        ("materials", json!([{}, { "pbrMetallicRoughness": { "baseColorTexture": {} } }])),
        ("textures", json!([{ "source": "none" }])),
        ("images", json!({ "logo": {} })),
        ("samplers", json!([null])),
        ("extensions", json!([])),
        ("extras", json!([1, "two"])),
        ("asset", json!({ "version": "2.0", "generator": 7 })),
        ("asset", Value::Null),
        ("extensionsUsed", json!(7)),
        ("scenes", json!([{ "nodes": [0], "name": 7 }])),
        ("nodes", json!([{ "mesh": 0.0, "extensions": [] }])),
    ] {
        assert_eq!(change(key, value.clone()), Ok(expected.clone()), "{key}: {value}");
    }
    assert!(
        matches!(change("scenes", json!([{}])), Err(Error::Surface(SurfaceError::Empty { .. }))),
        "a scene may be empty"
    );
}

#[test]
fn what_geometry_needs_is_named() {
    let (document, data) = square();
    for (key, index, field) in
        [("accessors", 1, "count"), ("bufferViews", 0, "byteLength"), ("meshes", 0, "primitives")]
    {
        let mut document = document.clone();
        document[key][index].as_object_mut().unwrap().remove(field);
        let error = read(&document, &data).unwrap_err().to_string();
        assert!(error.contains(&format!("{key}[{index}]")) && error.contains(field), "{error}");
    }
    let error = reading::read("mesh.gltf", "{ \"asset\": {},\n  \"nodes\": [ }").unwrap_err().to_string();
    assert!(error.contains("JSON line 2 column 14"), "{error}");
}
