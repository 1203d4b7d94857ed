//! Motion: clips, nodes, skins and morph targets over time.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::FRAC_1_SQRT_2;

use glam::{DQuat, DVec3, Vec3};
use heatwalk_model::motion::{
    Channel, Clip, Deformer, Influences, Interpolation, Motion, Node, NodeTree, Placement, Target, Track,
};
use heatwalk_model::{Error, Model};
use heatwalk_surface::{Error as SurfaceError, Soup};
use serde_json::{Value, json};

use super::document::{Builder, square};
use crate::reading::flip_bytes;

/// Rounding of values that a file holds in single precision.
const SINGLE: f64 = 1e-6;

/// Adds a channel of node 0 with these times and values; their accessors.
fn animate(builder: &mut Builder, path: &str, times: &[f32], kind: &str, count: usize, values: &[f32]) -> [usize; 2] {
    builder.floats("SCALAR", times.len(), times);
    builder.floats(kind, count, values);
    let accessors = builder.root["accessors"].as_array().unwrap().len();
    builder.root["animations"] = json!([{
        "name": "Walk",
        "channels": [{ "sampler": 0, "target": { "node": 0, "path": path } }],
        "samplers": [{ "input": accessors - 2, "output": accessors - 1 }]
    }]);
    [accessors - 2, accessors - 1]
}

/// Where the square's first corner, which is at the origin, goes.
fn corner(model: &Model, seconds: f64) -> DVec3 {
    model.posed(0, seconds).unwrap().soup.positions[0]
}

fn close(found: DVec3, expected: DVec3) {
    assert!(found.distance(expected) < SINGLE, "{found} for {expected}");
}

#[test]
fn translations_are_interpolated_between_keyframes_and_stay_beyond_them() {
    let mut builder = square(json!([{ "mesh": 0, "translation": [9, 0, 0] }]));
    animate(&mut builder, "translation", &[1.0, 3.0], "VEC3", 2, &[0., 0., 0., 4., 0., 8.]);
    let model = builder.model().unwrap();
    assert_eq!(model.soup.positions[0], DVec3::new(9.0, 0.0, 0.0), "a file opens as its nodes stand");
    let [clip] = model.motion.clips() else { panic!("one clip") };
    assert_eq!((clip.name.as_str(), clip.duration()), ("Walk", 3.0));
    for (seconds, share) in [(0.0, 0.0), (1.0, 0.0), (1.5, 0.25), (3.0, 1.0), (99.0, 1.0)] {
        close(corner(&model, seconds), share * DVec3::new(4.0, 0.0, 8.0));
    }
    builder.root["animations"][0]["samplers"][0]["interpolation"] = json!("STEP");
    let model = builder.model().unwrap();
    for (seconds, x) in [(2.99, 0.0), (3.0, 4.0)] {
        close(corner(&model, seconds), DVec3::new(x, 0.0, 2.0 * x));
    }
}

#[test]
fn cubic_splines_leave_and_reach_keyframes_at_their_tangents() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    // Along x: from 0 at 3 units a second to 8 at 12, in 2 seconds: the cube (t + 1)³ − 1, scaled.
    let cube = |t: f64| ((t + 1.0).powi(3) - 1.0) * 8.0 / 26.0;
    let slope = |t: f64| 3.0 * (t + 1.0) * (t + 1.0) * 8.0 / 26.0;
    let numbers = [9.0, 0.0, slope(0.0), slope(2.0), cube(2.0), 9.0];
    let values: Vec<f32> = numbers.iter().flat_map(|&x| [x as f32, 0.0, 0.0]).collect();
    animate(&mut builder, "translation", &[0.0, 2.0], "VEC3", 6, &values);
    builder.root["animations"][0]["samplers"][0]["interpolation"] = json!("CUBICSPLINE");
    let model = builder.model().unwrap();
    for seconds in [0.0, 0.3, 1.0, 1.9, 2.0, 5.0] {
        close(corner(&model, seconds), DVec3::new(cube(f64::min(seconds, 2.0)), 0.0, 0.0));
    }
}

#[test]
fn rotations_take_the_shorter_arc_at_even_speed_and_turn_normals() {
    let mut builder = square(json!([{ "children": [1] }, { "mesh": 0, "translation": [1, 0, 0] }]));
    builder.floats("VEC3", 4, &[0.0, 0.0, 1.0].repeat(4));
    builder.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = json!(2);
    // A quarter turn about y; the second quaternion is written with its other sign.
    let half = FRAC_1_SQRT_2 as f32;
    animate(&mut builder, "rotation", &[0.0, 1.0], "VEC4", 2, &[0., 0., 0., 1., 0., -half, 0., -half]);
    let model = builder.model().unwrap();
    for seconds in [0.0, 0.25, 0.5, 1.0] {
        let turn = DQuat::from_rotation_y(seconds * std::f64::consts::FRAC_PI_2);
        let posed = model.posed(0, seconds).unwrap();
        close(posed.soup.positions[0], turn * DVec3::X);
        close(posed.appearance.normals[0].as_dvec3(), turn * DVec3::Z);
    }
}

#[test]
fn joints_move_the_vertices_of_a_skin() {
    let mut builder = square(json!([{}, { "mesh": 0, "skin": 0 }]));
    builder.accessor(5121, "VEC4", 4, &[0; 16]);
    builder.floats("VEC4", 4, &[1., 0., 0., 0., 1., 0., 0., 0., 0.5, 0., 0., 0., 0., 0., 0., 0.]);
    builder.root["skins"] = json!([{ "joints": [0] }]);
    let attributes = &mut builder.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = json!(2);
    attributes["WEIGHTS_0"] = json!(3);
    animate(&mut builder, "scale", &[0.0, 1.0], "VEC3", 2, &[1., 1., 1., 3., 3., 3.]);
    let posed = builder.model().unwrap().posed(0, 0.5).unwrap();
    assert_eq!(posed.soup.positions[1..], [DVec3::new(2., 0., 0.), DVec3::new(2., 2., 0.), DVec3::new(0., 1., 0.)]);
    assert!(posed.motion.is_empty(), "a pose does not move");
}

#[test]
fn weights_of_morph_targets_change() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    builder.floats("VEC3", 4, &[0., 0., 2., 0., 0., 0., 0., 0., 0., 0., 0., 0.]);
    builder.floats("VEC3", 4, &[0., 6., 0., 0., 0., 0., 0., 0., 0., 0., 0., 0.]);
    builder.root["meshes"][0]["primitives"][0]["targets"] = json!([{ "POSITION": 2 }, { "POSITION": 3 }]);
    builder.root["meshes"][0]["weights"] = json!([1.0, 0.0]);
    // Of both targets at each of two times.
    let [_, output] = animate(&mut builder, "weights", &[0.0, 1.0], "SCALAR", 4, &[0., 0., 0., 1.]);
    let model = builder.model().unwrap();
    assert_eq!(model.soup.positions[0], DVec3::new(0.0, 0.0, 2.0));
    assert_eq!(corner(&model, 0.5), DVec3::new(0.0, 3.0, 0.0));
    builder.root["accessors"][output]["count"] = json!(3);
    assert!(builder.model().unwrap().motion.is_empty(), "three weights are not of two times");
}

#[test]
fn chosen_parts_move_as_they_did() {
    let mut builder = square(json!([{ "mesh": 0 }, { "mesh": 0, "translation": [5, 0, 0] }, { "mesh": 0 }]));
    animate(&mut builder, "translation", &[0.0, 1.0], "VEC3", 2, &[0., 0., 0., 0., 0., 7.]);
    builder.root["animations"][0]["channels"][0]["target"]["node"] = json!(2);
    let model = builder.model().unwrap();
    let chosen = model.select(&[1, 2]).unwrap().posed(0, 1.0).unwrap();
    assert_eq!(chosen.soup.positions, model.posed(0, 1.0).unwrap().soup.positions[4..]);
    assert_eq!((chosen.soup.positions[0], chosen.soup.positions[4]), (DVec3::new(5., 0., 0.), DVec3::new(0., 0., 7.)));
    let alone = model.select(&[1]).unwrap();
    assert_eq!(alone.posed(0, 1.0).unwrap().soup.positions, alone.soup.positions);
}

#[test]
fn clips_are_found_by_name_and_by_number() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    animate(&mut builder, "translation", &[0.0], "VEC3", 1, &[1., 2., 3.]);
    let model = builder.model().unwrap();
    assert_eq!((model.motion.clip_named("Walk"), model.motion.clip_named("0")), (Ok(0), Ok(0)));
    let expected = Error::NoSuchClip { clip: "Run".to_owned(), clips: "Walk".to_owned() };
    assert_eq!(model.motion.clip_named("Run").unwrap_err(), expected);
    assert_eq!(expected.to_string(), "there is no animation Run; the file has Walk");
    assert!(matches!(model.posed(1, 0.0), Err(SurfaceError::BadParameter { name: "animation", .. })));
    for seconds in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(model.posed(0, seconds), Err(SurfaceError::BadParameter { name: "time", .. })));
    }
}

#[test]
fn channels_that_cannot_be_read_move_nothing_and_refuse_nothing() {
    let animated = || {
        let mut builder = square(json!([{ "mesh": 0 }]));
        let accessors = animate(&mut builder, "translation", &[0.0, 1.0], "VEC3", 2, &[0., 0., 0., 1., 0., 0.]);
        (builder, accessors)
    };
    let (builder, [input, output]) = animated();
    assert_eq!(builder.model().unwrap().motion.clips().len(), 1);
    let damaged: [(&str, Value); 6] = [
        ("/animations/0/channels/0/target/node", json!(7)),
        ("/animations/0/channels/0/target/path", json!("pointer")),
        ("/animations/0/channels/0/sampler", json!(7)),
        ("/animations/0/samplers/0/interpolation", json!("BEZIER")),
        (&format!("/accessors/{output}/type"), json!("VEC4")),
        (&format!("/accessors/{input}/count"), json!(1)),
    ];
    for (pointer, value) in damaged {
        let (mut builder, _) = animated();
        if let Some(place) = builder.root.pointer_mut(pointer) {
            *place = value;
        } else {
            builder.root["animations"][0]["samplers"][0]["interpolation"] = value;
        }
        let model = builder.model().unwrap_or_else(|error| panic!("{pointer}: {error}"));
        assert!(model.motion.is_empty(), "{pointer}");
    }
    assert!(Track::new(vec![1.0, 1.0], vec![[0.0]; 2], Interpolation::Linear).is_none(), "times must increase");
    assert!(Track::new(vec![0.0], vec![[f32::NAN]], Interpolation::Linear).is_none());
}

#[test]
fn pointers_to_properties_of_nodes_move_them() {
    let mut builder = square(json!([{}, { "mesh": 0 }]));
    animate(&mut builder, "pointer", &[0.0, 1.0], "VEC3", 2, &[0., 0., 0., 0., 5., 0.]);
    let channel = |pointer: &str| {
        let extensions = json!({ "KHR_animation_pointer": { "pointer": pointer } });
        json!({ "sampler": 0, "target": { "path": "pointer", "extensions": extensions } })
    };
    let by_node = json!({ "sampler": 0, "target": { "node": 0, "path": "translation" } });
    builder.root["animations"][0]["channels"] = json!([
        channel("/nodes/1/translation"),
        by_node,
        channel("/nodes/9/translation"),
        channel("/nodes/1/translation/0"),
        channel("/materials/0/emissiveFactor"),
        { "sampler": 0, "target": { "path": "translation" } },
    ]);
    builder.root["extensionsRequired"] = json!(["KHR_animation_pointer"]);
    let model = builder.model().unwrap();
    let [clip] = model.motion.clips() else { panic!("one clip") };
    let nodes: Vec<usize> = clip.channels.iter().map(|channel| channel.node).collect();
    assert_eq!((nodes, clip.left_out), (vec![1, 0], 4));
    close(corner(&model, 1.0), DVec3::new(0.0, 5.0, 0.0));
}

#[test]
fn damaged_animations_do_not_panic() {
    let mut builder = square(json!([{ "mesh": 0 }]));
    animate(&mut builder, "rotation", &[0.0, 1.0], "VEC4", 2, &[0., 0., 0., 1., 1., 0., 0., 0.]);
    flip_bytes("mesh.glb", &builder.glb());
}

#[test]
fn motions_made_in_code_are_checked() {
    let node = |parent| Node { parent, placement: Placement::IDENTITY };
    assert!(matches!(NodeTree::new(vec![node(Some(1)), node(Some(0))]), Err(Error::Motion { .. })));
    assert!(matches!(NodeTree::new(vec![node(Some(1))]), Err(Error::Motion { .. })));
    let deformer = Deformer {
        vertices: 0..1,
        node: 0,
        skin: None,
        positions: vec![DVec3::X],
        normals: vec![Vec3::Z],
        influences: Influences::default(),
        targets: Vec::new(),
        weights: Vec::new(),
    };
    let track = Track::new(vec![0.0], vec![[0.0, 2.0, 0.0]], Interpolation::Step).unwrap();
    let clip = |node| Clip {
        name: "Up".to_owned(),
        channels: vec![Channel { node, target: Target::Translation(track.clone()) }],
        left_out: 0,
    };
    let motion = |deformer: Deformer, clip| {
        Motion::new(NodeTree::new(vec![node(None)])?, Vec::new(), vec![deformer], vec![clip])
    };
    let sound = motion(deformer.clone(), clip(0)).unwrap();
    let mut pose = Model::from(Soup::single("point", vec![DVec3::X], Vec::new())).pose();
    sound.apply(0, 0.0, &mut pose).unwrap();
    assert_eq!(pose.positions, [DVec3::new(1.0, 2.0, 0.0)]);
    for broken in [
        motion(deformer.clone(), clip(1)),
        motion(Deformer { node: 1, ..deformer.clone() }, clip(0)),
        motion(Deformer { skin: Some(0), ..deformer.clone() }, clip(0)),
        motion(Deformer { vertices: 0..2, ..deformer }, clip(0)),
    ] {
        assert!(matches!(broken, Err(Error::Motion { .. })));
    }
}
