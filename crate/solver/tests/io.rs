//! Readers and writers: good files, odd files, damaged files.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use glam::DVec3;
use heatwalk::error::{Error, Result};
use heatwalk::io::{self, write};
use heatwalk::shapes;
use heatwalk::soup::Soup;
use serde_json::{Value, json};

fn read(name: &str, bytes: impl AsRef<[u8]>) -> Result<Soup> {
    io::read(name, bytes.as_ref(), &|_| None)
}

fn part_names(soup: &Soup) -> Vec<&str> {
    soup.parts.iter().map(|part| part.name.as_str()).collect()
}

/// Area of each triangle's projection on the plane z = 0, signed.
fn areas(soup: &Soup) -> Vec<f64> {
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|corner| soup.positions[corner as usize]);
        (b - a).cross(c - a).z / 2.0
    };
    soup.triangles.iter().map(area).collect()
}

// ---- OFF

const SQUARE_OFF: &str = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

#[test]
fn off_variants_hold_the_same_square() {
    let square = read("square.off", SQUARE_OFF).unwrap();
    assert_eq!(square.positions[2], DVec3::new(1.0, 1.0, 0.0));
    assert_eq!(square.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(part_names(&square), ["square"]);
    for variant in [
        "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
        "OFF4 1 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3",
        "# made by hand\nOFF # header\n\n4 1\n0 0 0 # a corner\n1 0 0\n\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n",
        "COFF\n4 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 0 0 0 0\n0 1 0 9 9 9 9\n4 0 1 2 3 0.5 0.5 0.5\n",
        "STCNOFF\n4 1 0\n0 0 0 0 0 1 9\n1 0 0 0 0 1 9\n1 1 0 0 0 1 9\n0 1 0 0 0 1 9\n4 0 1 2 3\n",
        "4OFF\n4 1 0\n0 0 0 2\n2 0 0 2\n2 2 0 2\n0 2 0 2\n4 0 1 2 3\n",
    ] {
        assert_eq!(read("square.off", variant).unwrap(), square, "{variant}");
    }
    assert_eq!(read("square", SQUARE_OFF).unwrap(), square, "told by its first bytes");
}

#[test]
fn off_errors_name_the_place() {
    let index = read("a.off", SQUARE_OFF.replace("4 0 1 2 3", "3 0 1 4")).unwrap_err();
    assert_eq!(index, Error::IndexOutOfRange { triangle: 0, vertex: 4, vertices: 4 });
    for (bad, place) in [
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 x 0\n0 1 0\n4 0 1 2 3\n", "line 5"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2\n", "line 7"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 -3\n", "line 7"),
        ("OFF\n99999999999999 1 0\n0 0 0\n", "end of file"),
        ("OFF\n4 99999999999999 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "end of file"),
        ("OFF\n-4 1 0\n", "line 2"),
        ("", "end of file"),
    ] {
        let error = read("a.off", bad).unwrap_err();
        assert!(error.to_string().contains(place), "{error}");
    }
    assert!(matches!(read("a.off", "OFF BINARY\n\0\0\0\x04"), Err(Error::Unsupported { .. })));
    assert!(matches!(read("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), Err(Error::Empty { .. })));
    assert!(matches!(read("picture.png", "\u{1}PNG"), Err(Error::UnknownFormat { .. })));
}

// ---- OBJ

const TWO_GROUPS_OBJ: &str = "# two groups\r\nmtllib x.mtl\r\nv 0 0 0 1 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\n\
                              vn 0 0 1\r\ng empty\r\ng left\r\nf 1/1/1 2/1/1 3/1/1\r\ng right\r\nf 1//1 3//1 \\\r\n4//1\r\n\
                              g left\r\nf -4/1 -3/1 -1/1\r\n";

#[test]
fn obj_groups_are_parts() {
    let soup = read("two.obj", TWO_GROUPS_OBJ).unwrap();
    assert_eq!(part_names(&soup), ["left", "right"], "reopened groups join, empty ones drop");
    assert_eq!(soup.triangles, [[0, 1, 2], [0, 1, 3], [0, 2, 3]]);
    assert_eq!(soup.parts[1].triangles, 2..3);
    let soup = read("o.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no A\ng x\nf 1 2 3\no B\ng x\nf 3 2 1\n").unwrap();
    assert_eq!(part_names(&soup), ["x", "x"], "groups of different objects are different parts");
    let soup = read("plain.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").unwrap();
    assert_eq!(part_names(&soup), ["plain"]);
}

#[test]
fn polygons_are_triangulated_without_turning_a_triangle() {
    // An arrowhead whose fan from the first corner would fold over, an L, and a comb with collinear corners.
    for (outline, area) in [
        (vec![(0.0, 0.0), (2.0, -2.0), (1.0, 0.0), (2.0, 2.0)], 2.0),
        (vec![(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)], 5.0),
        (
            vec![
                (0.0, 0.0),
                (1.0, 0.0),
                (2.0, 0.0),
                (5.0, 0.0),
                (5.0, 3.0),
                (4.0, 3.0),
                (4.0, 1.0),
                (3.0, 1.0),
                (3.0, 3.0),
                (2.0, 3.0),
                (2.0, 1.0),
                (1.0, 1.0),
                (1.0, 3.0),
                (0.0, 3.0),
            ],
            11.0,
        ),
        (vec![(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.0, 1.0)], 1.0),
    ] {
        let count = outline.len();
        for start in 0..count {
            let mut text: String = outline.iter().map(|(x, y)| format!("v {x} {y} 7\n")).collect();
            text += "f";
            (0..count).for_each(|i| text += &format!(" {}", (start + i) % count + 1));
            let soup = read("polygon.obj", &text).unwrap();
            assert_eq!(soup.triangles.len(), count - 2);
            let areas = areas(&soup);
            assert!(areas.iter().all(|&area| area > 0.0), "{areas:?} from {start} of {outline:?}");
            assert!((areas.iter().sum::<f64>() - area).abs() < 1e-12);
        }
    }
}

#[test]
fn obj_errors_name_the_place() {
    for (bad, place) in [
        ("v 0 0\n", "line 1"),
        ("v 0 0 0\nf 1 2 0\n", "line 2"),
        ("v 0 0 0\nf 1 one 1\n", "line 2"),
        ("v 0 0 0\nf -1 -1 -2\n", "line 2"),
    ] {
        let error = read("a.obj", bad).unwrap_err();
        assert!(error.to_string().contains(place), "{error}");
    }
    let error = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n").unwrap_err();
    assert_eq!(error, Error::IndexOutOfRange { triangle: 1, vertex: 8, vertices: 3 });
    assert!(matches!(read("a.obj", "f 1 2 99999999999\n"), Err(Error::IndexOutOfRange { .. })));
}

// ---- PLY

const SQUARE_PLY: &str = "ply\nformat ascii 1.0\ncomment x\nelement tag 1\nproperty list uchar float numbers\n\
    element vertex 4\nproperty uchar red\nproperty float z\nproperty double y\nproperty short x\n\
    element face 1\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n\
    2 0.5 0.25\n255 0 0 0\n255 0 0 1\n255 0 1 1\n255 0 1 0\n4 0 1 2 3 0.5\n";

fn binary_ply(little: bool) -> Vec<u8> {
    let encoding = if little { "binary_little_endian" } else { "binary_big_endian" };
    let (header, _) = SQUARE_PLY.split_once("end_header\n").unwrap();
    let mut bytes = (header.replace("ascii", encoding) + "end_header\n").into_bytes();
    let mut put = |value: &[u8]| bytes.extend(value.iter().rev());
    let mut value = |big: &[u8]| if little { put(big) } else { put(&big.iter().rev().copied().collect::<Vec<_>>()) };
    value(&[2]);
    value(&0.5_f32.to_be_bytes());
    value(&0.25_f32.to_be_bytes());
    for (x, y) in [(0_i16, 0.0_f64), (1, 0.0), (1, 1.0), (0, 1.0)] {
        value(&[255]);
        value(&0_f32.to_be_bytes());
        value(&y.to_be_bytes());
        value(&x.to_be_bytes());
    }
    value(&[4]);
    (0..4_i32).for_each(|index| value(&index.to_be_bytes()));
    value(&0.5_f32.to_be_bytes());
    bytes
}

#[test]
fn ply_in_three_encodings() {
    let square = read("square.off", SQUARE_OFF).unwrap();
    assert_eq!(read("square.ply", SQUARE_PLY).unwrap(), square);
    assert_eq!(read("square.ply", binary_ply(true)).unwrap(), square);
    assert_eq!(read("square.ply", binary_ply(false)).unwrap(), square);
    assert_eq!(read("square.ply", SQUARE_PLY.replace('\n', "\r\n")).unwrap(), square);
    let strips =
        SQUARE_PLY.replace("element face 1", "element tristrips 1").replace("4 0 1 2 3 0.5", "8 0 1 3 2 -1 0 1 2 0.5");
    assert_eq!(read("strips.ply", strips).unwrap().triangles, [[0, 1, 3], [3, 1, 2], [0, 1, 2]]);
}

#[test]
fn ply_errors_name_the_place() {
    for (from, to, place) in [
        ("4 0 1 2 3 0.5", "4 0 1 -2 3 0.5", "face 0"),
        ("4 0 1 2 3 0.5", "4 0 1", "face 0"),
        ("property short x\n", "property short u\n", "element vertex"),
        ("uchar int", "uchar quad", "line 12"),
        ("element vertex 4", "element vertex 4000000000000", "vertex 5"),
        ("end_header\n", "", "header"),
        ("element tag 1\n", "element nothing 99999999999999\nelement tag 1\n", "face 0"),
    ] {
        let bad = SQUARE_PLY.replace(from, to);
        match read("a.ply", &bad) {
            Err(error) => assert!(error.to_string().contains(place), "{error}"),
            // An element without properties takes no bytes, however many there are.
            Ok(_) => assert!(from.starts_with("element tag"), "{bad}"),
        }
    }
    let error = read("a.ply", SQUARE_PLY.replace("4 0 1 2 3 0.5", "4 0 1 2 7 0.5")).unwrap_err();
    assert_eq!(error, Error::IndexOutOfRange { triangle: 0, vertex: 7, vertices: 4 });
}

// ---- STL

const TWO_SOLIDS_STL: &str = "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n\
    endfacet\nendsolid one\nsolid\n  FACET normal 0 0 1\n outer loop\n vertex 0 0 1e0\n vertex 1 0 1\n VERTEX 0 1 1\n\
    endloop\nendfacet\nendsolid\n";

fn binary_stl(header: &[u8], triangles: u32) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(triangles.to_le_bytes());
    for triangle in 0..triangles {
        for value in [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, triangle as f32] {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend([0, 0]);
    }
    bytes
}

#[test]
fn stl_ascii_and_binary() {
    let soup = read("two.stl", TWO_SOLIDS_STL).unwrap();
    assert_eq!(part_names(&soup), ["one", "two"], "a solid without a name takes the file's");
    assert_eq!((soup.positions.len(), soup.triangles.len()), (6, 2));
    for header in [&b"made by hand"[..], b"solid facet that lies about being text"] {
        let soup = read("b.stl", binary_stl(header, 3)).unwrap();
        assert_eq!(soup.triangles, [[0, 1, 2], [3, 4, 5], [6, 7, 8]]);
        assert_eq!(soup.positions[8], DVec3::new(0.0, 1.0, 2.0));
    }
    assert!(read("unnamed", binary_stl(b"", 2)).is_ok(), "told by its length");
    let mut long = binary_stl(b"", 2);
    long.push(0);
    assert_eq!(read("a.stl", &long).unwrap().triangles.len(), 2, "bytes after the last triangle are ignored");
    assert!(read("a.stl", &long[..130]).unwrap_err().to_string().contains("2 triangles are missing"));
    assert!(
        read("a.stl", TWO_SOLIDS_STL.replace("vertex 1 0 0", "vertex 1 0")).unwrap_err().to_string().contains("line 5")
    );
    assert!(read("a.stl", TWO_SOLIDS_STL.replace("vertex 1 0 0\n", "")).unwrap_err().to_string().contains("line 7"));
}

// ---- glTF

/// Builds a glTF document around a growing buffer.
struct Builder {
    root: Value,
    binary: Vec<u8>,
}

impl Builder {
    fn new(nodes: Value, meshes: Value) -> Self {
        let root = json!({
            "asset": { "version": "2.0" }, "nodes": nodes, "meshes": meshes, "accessors": [], "bufferViews": []
        });
        Self { root, binary: Vec::new() }
    }

    fn view(&mut self, bytes: &[u8]) -> usize {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() });
        self.binary.extend(bytes);
        let views = self.root["bufferViews"].as_array_mut().unwrap();
        views.push(view);
        views.len() - 1
    }

    fn accessor(&mut self, component: u32, kind: &str, count: usize, bytes: &[u8]) -> &mut Value {
        let view = self.view(bytes);
        let accessors = self.root["accessors"].as_array_mut().unwrap();
        accessors.push(json!({ "bufferView": view, "componentType": component, "type": kind, "count": count }));
        accessors.last_mut().unwrap()
    }

    fn floats(&mut self, kind: &str, count: usize, values: &[f32]) -> &mut Value {
        self.accessor(5126, kind, count, &values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>())
    }

    fn glb(&self) -> Vec<u8> {
        let mut root = self.root.clone();
        root["buffers"] = json!([{ "byteLength": self.binary.len() }]);
        let mut text = root.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF\x02\0\0\0".to_vec();
        bytes.extend((28 + text.len() as u32 + self.binary.len() as u32).to_le_bytes());
        bytes.extend((text.len() as u32).to_le_bytes());
        bytes.extend(b"JSON");
        bytes.extend(text);
        bytes.extend((self.binary.len() as u32).to_le_bytes());
        bytes.extend(b"BIN\0");
        bytes.extend(&self.binary);
        bytes
    }

    fn gltf(&self, uri: &str) -> String {
        let mut root = self.root.clone();
        root["buffers"] = json!([{ "byteLength": self.binary.len(), "uri": uri }]);
        root.to_string()
    }

    fn read(&self) -> Result<Soup> {
        read("mesh.glb", self.glb())
    }
}

const SQUARE: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];

/// A unit square: accessor 0 positions, accessor 1 the indices of two triangles.
fn square(nodes: Value) -> Builder {
    let mut builder =
        Builder::new(nodes, json!([{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }]));
    builder.floats("VEC3", 4, &SQUARE);
    builder.accessor(5121, "SCALAR", 6, &[0, 1, 2, 0, 2, 3]);
    builder
}

#[test]
fn gltf_from_glb_data_uri_and_file() {
    let builder = square(json!([{ "mesh": 0, "name": "Square" }]));
    let expected = builder.read().unwrap();
    assert_eq!(part_names(&expected), ["Square"]);
    assert_eq!(expected.triangles, [[0, 1, 2], [0, 2, 3]]);
    let external = builder.gltf("my%20buffer.bin");
    let resources = |uri: &str| (uri == "my buffer.bin").then(|| builder.binary.clone());
    assert_eq!(io::read("mesh.gltf", external.as_bytes(), &resources).unwrap(), expected);
    assert_eq!(read("mesh.gltf", &external).unwrap_err(), Error::MissingResource { uri: "my buffer.bin".to_owned() });
    const ALPHABET: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut encoded = String::from("data:application/octet-stream;base64,");
    for chunk in builder.binary.chunks(3) {
        let word = chunk.iter().fold(0_u32, |word, &byte| word << 8 | u32::from(byte)) << (8 * (3 - chunk.len()));
        (0..=chunk.len()).for_each(|i| encoded.push(ALPHABET[(word >> (18 - 6 * i) & 63) as usize].into()));
        encoded.extend(std::iter::repeat_n('=', 3 - chunk.len()));
    }
    assert_eq!(read("no_extension", builder.gltf(&encoded)).unwrap(), expected);
    assert!(matches!(read("mesh.gltf", builder.gltf("data:;base64,AA?A")), Err(Error::Malformed { .. })));
}

#[test]
fn node_transforms_compose_and_meshes_are_instanced() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let builder = square(json!([
        { "children": [1, 2], "translation": [10, 0, 0], "rotation": [0, 0, half, half] },
        { "mesh": 0, "scale": [2, 3, 1] },
        { "mesh": 0, "name": "mirror", "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1] }
    ]));
    let soup = builder.read().unwrap();
    assert_eq!(part_names(&soup), ["node 1", "mirror"]);
    assert_eq!((soup.positions.len(), soup.triangles.len()), (8, 4));
    // (1, 1) scaled to (2, 3), turned by 90° to (-3, 2), moved. The quaternion is read as f32 and normalised.
    assert!(soup.positions[2].distance(DVec3::new(7.0, 2.0, 0.0)) < 1e-7);
    assert!(soup.positions[6].distance(DVec3::new(9.0, 4.0, 0.0)) < 1e-7);
    assert!(areas(&soup).iter().all(|&area| area > 0.0), "a mirrored node keeps its outside");
}

#[test]
fn only_the_default_scene_is_read() {
    let mut builder = square(json!([{ "mesh": 0 }, { "mesh": 0, "name": "shown" }]));
    builder.root["scenes"] = json!([{ "nodes": [0] }, { "nodes": [1] }]);
    builder.root["scene"] = json!(1);
    assert_eq!(part_names(&builder.read().unwrap()), ["shown"]);
    builder.root["scene"] = json!(7);
    assert!(matches!(builder.read(), Err(Error::Malformed { .. })));
}

#[test]
fn nodes_that_are_no_tree_are_refused() {
    for nodes in [
        json!([{ "children": [1] }, { "children": [0], "mesh": 0 }]),
        json!([{ "children": [0], "mesh": 0 }]),
        json!([{ "children": [1, 1] }, { "mesh": 0 }]),
        json!([{ "children": [9], "mesh": 0 }]),
    ] {
        let mut builder = square(nodes);
        builder.root["scenes"] = json!([{ "nodes": [0] }]);
        assert!(matches!(builder.read(), Err(Error::Malformed { .. })));
    }
    let mut nodes: Vec<Value> = (1..20_000).map(|child| json!({ "children": [child] })).collect();
    nodes.push(json!({ "mesh": 0 }));
    assert!(square(Value::Array(nodes)).read().is_ok(), "depth does not matter");
}

#[test]
fn quantised_positions() {
    let normalized = [0_i16, 0, 0, 0, 32767, 0, 0, 0, 32767, 32767, 0, 0, 0, 32767, 0, 0];
    let mut builder = square(json!([{ "mesh": 0 }]));
    let bytes: Vec<u8> = normalized.iter().flat_map(|value| value.to_le_bytes()).collect();
    *builder.accessor(5122, "VEC3", 4, &bytes) =
        json!({ "bufferView": 2, "componentType": 5122, "type": "VEC3", "count": 4, "normalized": true });
    builder.root["bufferViews"][2]["byteStride"] = json!(8);
    builder.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(2);
    let expected = square(json!([{ "mesh": 0 }])).read().unwrap();
    assert_eq!(builder.read().unwrap(), expected);
    for (component, bytes) in [(5120, [0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0]), (5121, [0; 16])] {
        let mut builder = square(json!([{ "mesh": 0 }]));
        builder.accessor(component, "VEC3", 4, &bytes);
        builder.root["bufferViews"][2]["byteStride"] = json!(4);
        builder.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(2);
        let soup = builder.read().unwrap();
        assert_eq!(soup.positions[2].x, f64::from(bytes[8]));
    }
}

#[test]
fn sparse_accessors_replace_elements() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    let indices = builder.view(&[2, 0]);
    let values = builder.view(&[3.0_f32, 4.0, 5.0].map(f32::to_le_bytes).concat());
    builder.root["accessors"][0]["sparse"] = json!({
        "count": 1, "indices": { "bufferView": indices, "componentType": 5123 }, "values": { "bufferView": values }
    });
    assert_eq!(builder.read().unwrap().positions[2], DVec3::new(3.0, 4.0, 5.0));
    let base = builder.root["accessors"][0].as_object_mut().unwrap();
    base.remove("bufferView");
    let soup = builder.read().unwrap();
    assert_eq!((soup.positions[1], soup.positions[2]), (DVec3::ZERO, DVec3::new(3.0, 4.0, 5.0)));
    builder.root["accessors"][0]["count"] = json!(1_u64 << 40);
    assert!(matches!(builder.read(), Err(Error::Malformed { .. })), "a count without bytes reserves nothing");
}

#[test]
fn strips_fans_lists_and_what_is_no_surface() {
    for (mode, indices, expected) in [
        (4, Some([0, 1, 2, 0, 2, 3]), vec![[0, 1, 2], [0, 2, 3]]),
        (5, None, vec![[0, 1, 2], [1, 3, 2]]),
        (6, None, vec![[1, 2, 0], [2, 3, 0]]),
        (4, None, vec![[0, 1, 2]]),
    ] {
        let mut builder = square(json!([{ "mesh": 0 }]));
        let primitive = &mut builder.root["meshes"][0]["primitives"][0];
        primitive["mode"] = json!(mode);
        if indices.is_none() {
            primitive.as_object_mut().unwrap().remove("indices");
        }
        assert_eq!(builder.read().unwrap().triangles, expected, "mode {mode}");
    }
    let mut builder = square(json!([{ "mesh": 0 }]));
    builder.root["meshes"][0]["primitives"][0]["mode"] = json!(1);
    assert!(matches!(builder.read(), Err(Error::Empty { .. })), "lines are no surface");
    let primitive = json!({ "attributes": { "POSITION": 0 }, "indices": 1 });
    builder.root["meshes"][0]["primitives"] = json!([primitive, primitive]);
    let soup = builder.read().unwrap();
    assert_eq!((soup.positions.len(), soup.parts.len()), (4, 1), "primitives share their vertices and make one part");
}

#[test]
fn skins_stand_in_their_rest_pose() {
    let mut builder = square(json!([
        { "mesh": 0, "skin": 0, "translation": [100, 0, 0] },
        { "translation": [0, 0, 1], "children": [2] },
        { "translation": [0, 0, 2] }
    ]));
    builder.accessor(5121, "VEC4", 4, &[0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0]);
    builder.floats("VEC4", 4, &[1., 0., 0., 0., 0., 1., 0., 0., 0.5, 0.5, 0., 0., 0., 0., 0., 0.]);
    let bind = [1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 5., 0., 1.];
    builder.floats("MAT4", 2, &[bind, bind].concat());
    builder.root["skins"] = json!([{ "joints": [1, 2], "inverseBindMatrices": 4 }]);
    let attributes = &mut builder.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = json!(2);
    attributes["WEIGHTS_0"] = json!(3);
    let positions = builder.read().unwrap().positions;
    assert_eq!(positions[..3], [DVec3::new(0., 5., 1.), DVec3::new(1., 5., 3.), DVec3::new(1., 6., 2.)]);
    assert_eq!(positions[3], DVec3::new(0.0, 1.0, 0.0), "no weights, no move");
    builder.root["skins"][0]["joints"] = json!([1]);
    assert!(matches!(builder.read(), Err(Error::Malformed { .. })), "a joint that does not exist");
}

#[test]
fn morph_targets_apply_their_default_weights() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    builder.floats("VEC3", 4, &[0., 0., 2., 0., 0., 0., 0., 0., 0., 0., 0., 0.]);
    builder.root["meshes"][0]["primitives"][0]["targets"] = json!([{ "POSITION": 2 }]);
    assert_eq!(builder.read().unwrap().positions[0].z, 0.0);
    builder.root["meshes"][0]["weights"] = json!([0.5]);
    assert_eq!(builder.read().unwrap().positions[0].z, 1.0);
    builder.root["nodes"][0]["weights"] = json!([0.25]);
    assert_eq!(builder.read().unwrap().positions[0].z, 0.5);
}

#[test]
fn compressed_geometry_names_the_extension_and_the_remedy() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    builder.root["extensionsUsed"] = json!(["KHR_draco_mesh_compression"]);
    assert!(builder.read().is_ok(), "uncompressed data beside it is fine");
    builder.root["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    let error = builder.read().unwrap_err().to_string();
    assert!(error.contains("KHR_draco_mesh_compression") && error.contains("export"), "{error}");
}

#[test]
fn gltf_indices_are_checked() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    builder.binary[48] = 9;
    assert_eq!(builder.read().unwrap_err(), Error::IndexOutOfRange { triangle: 0, vertex: 9, vertices: 4 });
    for (key, value) in [
        ("count", json!(5)),
        ("byteOffset", json!(4)),
        ("byteOffset", json!(u64::MAX)),
        ("componentType", json!(5130)),
        ("type", json!("VEC2")),
        ("bufferView", json!(77)),
    ] {
        let mut builder = square(json!([{ "mesh": 0 }]));
        builder.root["accessors"][0][key] = value;
        assert!(matches!(builder.read(), Err(Error::Malformed { .. })), "{key}");
    }
}

// ---- writers

#[test]
fn written_meshes_read_back() {
    let soup = shapes::torus(1.0, 0.4, 8, 6);
    let mut distance: Vec<f64> = soup.positions.iter().map(|position| position.x + 2.0).collect();
    distance[3] = f64::INFINITY;
    let ply = read("torus.ply", write::distance_ply(&soup, &distance)).unwrap();
    assert_eq!(ply, soup);
    let glb = write::distance_glb(&soup, &distance);
    let back = read("torus.glb", &glb).unwrap();
    assert_eq!(back.triangles, soup.triangles);
    assert_eq!(back.positions[5], soup.positions[5].as_vec3().as_dvec3());
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let root: Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
    assert_eq!(root["accessors"][1]["min"], json!([write::UNREACHABLE_IN_GLB]));
    let greatest = distance.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max) as f32;
    assert_eq!(root["accessors"][1]["max"], json!([greatest]));
    assert_eq!(glb.len() % 4, 0);
    let path = write::polyline_obj(&[DVec3::ZERO, DVec3::new(0.1, 1.0, -2.0)]);
    assert!(String::from_utf8(path).unwrap().ends_with("v 0 0 0\nv 0.1 1 -2\nl 1 2\n"));
}

// ---- damage

fn small_files() -> Vec<(&'static str, Vec<u8>)> {
    let builder = square(json!([{ "mesh": 0, "scale": [1, 2, 3] }]));
    vec![
        ("a.off", SQUARE_OFF.into()),
        ("a.obj", TWO_GROUPS_OBJ.into()),
        ("a.ply", SQUARE_PLY.into()),
        ("b.ply", binary_ply(true)),
        ("c.ply", binary_ply(false)),
        ("a.stl", TWO_SOLIDS_STL.into()),
        ("b.stl", binary_stl(b"solid", 2)),
        ("a.glb", builder.glb()),
        ("a.gltf", builder.gltf("data:;base64,AAAA").into()),
    ]
}

#[test]
fn files_cut_short_at_any_byte_do_not_panic() {
    for (name, bytes) in small_files() {
        for length in 0..bytes.len() {
            let _ = read(name, &bytes[..length]);
        }
    }
}

#[test]
fn flipped_bytes_do_not_panic() {
    let mut state = 1_u64;
    let mut random = |below: usize| {
        // Multiplier and increment of Knuth's MMIX.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    for (name, bytes) in small_files() {
        for _ in 0..3000 {
            let mut damaged = bytes.clone();
            for _ in 0..=random(3) {
                damaged[random(bytes.len())] = random(256) as u8;
            }
            if let Ok(soup) = read(name, &damaged) {
                assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
            }
        }
    }
}
