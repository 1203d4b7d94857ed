//! glTF and GLB: containers, scenes, accessors, deformation, damage.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod document;
mod motion;
use crate::reading;
mod unusual;

use glam::{DVec3, Vec3};
use heatwalk_model::{Error, LightKind, Projection, io};
use heatwalk_surface::Error as SurfaceError;
use serde_json::{Value, json};

use crate::reading::{areas, part_names, read};
use document::square;

#[test]
fn gltf_from_glb_data_uri_and_file() {
    let builder = square(json!([{ "mesh": 0, "name": "Square" }]));
    let expected = builder.read().unwrap();
    assert_eq!(part_names(&expected), ["Square"]);
    assert_eq!(expected.triangles, [[0, 1, 2], [0, 2, 3]]);
    let external = builder.gltf("my%20buffer.bin");
    let resources = |uri: &str| (uri == "my buffer.bin").then(|| builder.binary.clone());
    assert_eq!(io::read("mesh.gltf", external.as_bytes(), &resources).unwrap(), builder.model().unwrap());
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
fn attributes_of_an_application_are_read_by_their_names() {
    let mut builder = square(json!([{ "mesh": 0 }, { "mesh": 0 }]));
    builder.floats("SCALAR", 4, &[1., 2., 3., 4.]);
    builder.floats("VEC3", 4, &[0.; 12]);
    builder.root["meshes"][0]["primitives"][0]["attributes"]["_WEIGHT"] = json!(2);
    builder.root["meshes"][0]["primitives"][0]["attributes"]["_FLOW"] = json!(3);
    builder.root["meshes"][0]["primitives"][0]["attributes"]["_GONE"] = json!(99);
    let soup = builder.read().unwrap();
    assert_eq!(soup.attribute("_WEIGHT").unwrap(), [1., 2., 3., 4., 1., 2., 3., 4.]);
    let names: Vec<&str> = soup.attributes.iter().map(|attribute| attribute.name.as_str()).collect();
    assert_eq!(names, ["_WEIGHT"], "a vector and what is not there are left out");
    assert_eq!(soup.select(&[1]).unwrap().attribute("_WEIGHT").unwrap(), [1., 2., 3., 4.]);
    let error = soup.attribute("_MUD").unwrap_err();
    assert!(error.to_string().contains("_MUD") && error.to_string().contains("_WEIGHT"), "{error}");
}

#[test]
fn instances_stand_below_their_node() {
    let mut builder = square(json!([{ "mesh": 0, "translation": [10, 0, 0] }]));
    builder.floats("VEC3", 3, &[0., 0., 0., 0., 5., 0., 0., 0., 7.]);
    builder.floats("VEC3", 3, &[1., 1., 1., 2., 3., 1., -1., 1., 1.]);
    builder.root["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    builder.root["nodes"][0]["extensions"] =
        json!({ "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": 2, "SCALE": 3 } } });
    let soup = builder.read().unwrap();
    assert_eq!((soup.positions.len(), part_names(&soup)), (12, vec!["node 0"]));
    assert_eq!(soup.positions[2], DVec3::new(11.0, 1.0, 0.0));
    assert_eq!(soup.positions[6], DVec3::new(12.0, 8.0, 0.0));
    assert_eq!(soup.positions[10], DVec3::new(9.0, 1.0, 7.0));
    assert!(areas(&soup).iter().all(|&area| area > 0.0), "a mirrored instance keeps its outside");
    builder.root["accessors"][3]["count"] = json!(2);
    assert!(matches!(builder.read(), Err(Error::Malformed { .. })), "three places and two sizes");
}

#[test]
fn cameras_stand_where_their_nodes_do() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut builder = square(json!([
        { "mesh": 0, "children": [1], "translation": [10, 0, 0] },
        { "camera": 0, "name": "from the left", "translation": [0, 2, 0], "rotation": [0, half, 0, half] },
        { "camera": 1 },
        { "camera": 2 }
    ]));
    builder.root["cameras"] = json!([
        { "type": "perspective", "perspective": { "yfov": 0.5, "znear": 0.1 } },
        { "type": "orthographic", "orthographic": { "xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9 } },
        { "type": "perspective", "perspective": { "yfov": -1, "znear": 0.1 } }
    ]);
    let [camera, along] = &builder.model().unwrap().cameras[..] else { panic!("those that can be shown") };
    assert_eq!((camera.name.as_str(), camera.position), ("from the left", DVec3::new(10.0, 2.0, 0.0)));
    assert!(camera.forward.distance(DVec3::NEG_X) < 1e-6);
    assert_eq!(camera.projection, Projection::Perspective { field_of_view: 0.5 });
    assert_eq!(along.projection, Projection::Orthographic { height: 2.0 });
}

#[test]
fn lights_shine_where_their_nodes_point() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let light = |number: usize| json!({ "KHR_lights_punctual": { "light": number } });
    let mut builder = square(json!([
        { "mesh": 0, "children": [1, 2, 3, 4], "translation": [10, 0, 0] },
        { "translation": [0, 2, 0], "rotation": [0, half, 0, half], "extensions": light(2) },
        { "extensions": light(0) },
        { "extensions": light(1) },
        { "extensions": light(9) }
    ]));
    builder.root["extensions"] = json!({ "KHR_lights_punctual": { "lights": [
        { "type": "directional", "color": [1, 0.5, 0], "intensity": 4 },
        { "type": "lamp" },
        { "type": "spot", "spot": { "innerConeAngle": 0.2, "outerConeAngle": 0.4 } }
    ] } });
    let lights = builder.model().unwrap().lights;
    let [spot, sun] = &lights[..] else { panic!("those of a known type: {lights:?}") };
    assert_eq!((spot.kind, spot.position), (LightKind::Spot { inner: 0.2, outer: 0.4 }, DVec3::new(10.0, 2.0, 0.0)));
    assert!(spot.forward.distance(DVec3::NEG_X) < 1e-6);
    assert_eq!((spot.color, sun.kind), (Vec3::ONE, LightKind::Directional));
    assert_eq!((sun.color, sun.forward), (Vec3::new(4.0, 2.0, 0.0), DVec3::NEG_Z));
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
    builder.root["accessors"][0]["count"] = json!(1000);
    assert_eq!(builder.read().unwrap().positions.len(), 1000, "zeros need no bytes");
    builder.root["accessors"][0]["count"] = json!(1_u64 << 30);
    assert!(matches!(builder.read(), Err(Error::OverBudget { .. })), "a count without bytes reserves nothing");
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
    let lines = builder.read().unwrap_err().to_string();
    assert!(lines.contains("mesh.glb holds no faces: 1 point or line was left out"), "{lines}");
    builder.root["meshes"][0]["primitives"][0]["mode"] = json!(0);
    builder.root["nodes"][0]["translation"] = json!([0, 0, 5]);
    assert!(builder.read().unwrap_err().to_string().contains("1 point or line was left out"));
    let file = builder.glb();
    let budget = io::Budget::of_file(file.len());
    let cloud = io::read_mesh_or_points_within(&budget, "mesh.glb", &file, &|_| None).unwrap().soup;
    assert!(cloud.triangles.is_empty() && cloud.positions.len() == 4);
    assert!(cloud.positions.iter().all(|position| position.z == 5.0));
    for nodes in [json!([]), json!([{ "name": "empty" }])] {
        let hidden = square(nodes).read().unwrap_err().to_string();
        assert!(hidden.contains("no node of the scene that is shown has a mesh"), "{hidden}");
    }
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
fn gltf_indices_are_checked() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    builder.binary[48] = 9;
    assert_eq!(
        builder.read().unwrap_err(),
        SurfaceError::IndexOutOfRange { triangle: 0, vertex: 9, vertices: 4 }.into()
    );
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

#[test]
fn damaged_files_do_not_panic() {
    let builder = square(json!([{ "mesh": 0, "scale": [1, 2, 3] }]));
    for (name, bytes) in [("a.glb", builder.glb()), ("a.gltf", builder.gltf("data:;base64,AAAA").into_bytes())] {
        reading::cut_short_at_every_byte(name, &bytes);
        reading::flip_bytes(name, &bytes);
    }
}
