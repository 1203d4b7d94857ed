//! Files of brains: overlays of values.

use std::fs;

use crate::{difference, distances, folder, refused, succeed};

/// Numbers of 32 bits, the most significant byte first.
fn floats(bytes: &[u8]) -> Vec<f64> {
    bytes.as_chunks::<4>().0.iter().map(|&number| f64::from(f32::from_be_bytes(number))).collect()
}

#[test]
fn distances_are_written_as_overlays() {
    let folder = folder("overlays");
    let exact = distances(&folder, &["torus.ply", "--source", "5"]);
    let write =
        |arguments: &[&str]| succeed(&folder, &[&["distance", "torus.ply", "--source", "5"], arguments].concat());
    write(&["--output", "lh.curv"]);
    let curvature = fs::read(folder.join("lh.curv")).unwrap();
    assert_eq!(curvature[..3], [0xFF; 3]);
    assert_eq!(curvature[3..15], [exact.len() as u32, 576, 1].map(u32::to_be_bytes).concat());
    assert!(difference(&floats(&curvature[15..]), &exact) < 1e-6);
    write(&["--source", "7", "--each", "--output", "lh.d.MGH"]);
    let volume = fs::read(folder.join("lh.d.MGH")).unwrap();
    assert_eq!(volume.len(), 284 + 8 * exact.len());
    assert!(difference(&floats(&volume[284..284 + 4 * exact.len()]), &exact) < 1e-6);
    for (file, intent) in [("lh.shape.gii", "NIFTI_INTENT_SHAPE"), ("lh.func.gii", "NIFTI_INTENT_NONE")] {
        write(&["--source", "7", "--each", "--output", file]);
        let text = fs::read_to_string(folder.join(file)).unwrap();
        assert_eq!(text.matches(intent).count(), 2);
        assert!(text.contains("<Value>distance_1</Value>"), "{text}");
    }
    let several = ["distance", "torus.ply", "--source", "5", "--each", "--output", "lh.curv"];
    let line = refused(&folder, &several);
    assert!(line.contains("the distances of --each are written as .csv, .shape.gii, .func.gii or .mgh"), "{line}");
    let line = refused(&folder, &["distance", "torus.ply", "--source", "5", "--output", "lh.gii"]);
    assert!(line.contains("distances are written as .csv, .ply, .glb, .shape.gii, .func.gii, .mgh or .curv"), "{line}");
}
