//! Models as bytes and back: nothing is lost, and other bytes are refused.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use heatwalk_model::appearance::Image;
use heatwalk_model::{Appearance, Model, io};
use heatwalk_surface::{Soup, Unit};

#[test]
fn what_was_read_survives_with_materials_motion_and_units() {
    let robot = heatwalk_shapes::by_name("robot").unwrap();
    assert!(!robot.motion.clips().is_empty() && !robot.appearance.materials.is_empty() && robot.soup.parts.len() > 1);
    let mut written = robot;
    written.soup.unit = Some(Unit::Inch);
    assert_eq!(Model::unpacked(&written.packed()), Some(written));
    let appearance = Appearance {
        texcoords: vec![[0.0, 0.25, 0.5, 1.0]; 3],
        colors: vec![[0, 1, 300, u16::MAX]; 3],
        normals: vec![Vec3::Z; 3],
        images: vec![Image { bytes: vec![0, 255, 128], ..Image::default() }],
        ..Appearance::default()
    };
    let colored = Model { appearance: Arc::new(appearance), ..Model::default() };
    assert_eq!(Model::unpacked(&colored.packed()), Some(colored));
    let plain = Soup::single("plain", vec![DVec3::NAN, DVec3::X, DVec3::Y * f64::MAX], vec![[0, 1, 2]]);
    let again = Model::unpacked(&Model::from(plain.clone()).packed()).unwrap().soup;
    assert!(again.positions[0].is_nan() && again.positions[1..] == plain.positions[1..]);
    assert_eq!(again.triangles, plain.triangles);
    let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let read = io::read("a.obj", text, &|_| None).unwrap();
    assert_eq!(Model::unpacked(&read.packed()), Some(read));
}

#[test]
fn bytes_that_are_no_model_are_refused() {
    let bytes = Model::from(Soup::single("plain", vec![DVec3::ZERO; 3], vec![[0, 1, 2]])).packed();
    for end in 0..bytes.len() {
        assert!(Model::unpacked(&bytes[..end]).is_none(), "{end} of {} bytes", bytes.len());
    }
    assert!(Model::unpacked(b"OFF 3 1 0").is_none());
}
