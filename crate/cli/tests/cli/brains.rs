//! Files of brains: overlays of values, labels.

use std::fs;

use crate::{difference, distances, folder, json, refused, succeed};

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

/// Labels of the flat square, whose vertices are columns of nine: the first is "left", the last "right, far", the fifth but for its end the "wall".
fn label_gii() -> String {
    let label = |vertex: usize| match (vertex / 9, vertex % 9) {
        (0, _) => "1 ",
        (8, _) => "2 ",
        (4, 0..8) => "3 ",
        _ => "0 ",
    };
    let labels: String = (0..81).map(label).collect();
    format!(
        "<GIFTI><LabelTable><Label Key=\"0\">???</Label><Label Key=\"1\">left</Label><Label Key=\"2\">right, far</Label>\
         <Label Key=\"3\">wall</Label></LabelTable><DataArray Intent=\"NIFTI_INTENT_LABEL\" DataType=\"NIFTI_TYPE_INT32\" \
         Dim0=\"81\" Encoding=\"ASCII\"><Data>{labels}</Data></DataArray></GIFTI>"
    )
}

#[test]
fn labels_are_sources_and_walls() {
    let folder = folder("labels");
    fs::write(folder.join("lh.label.gii"), label_gii()).unwrap();
    let left = distances(&folder, &["flat.ply", "--sources", "lh.label.gii#left", "--exact"]);
    let expected: Vec<f64> = (0..81).map(|vertex: u32| f64::from(vertex / 9) / 8.0).collect();
    assert!(difference(&left, &expected) < 1e-12);
    let walled =
        distances(&folder, &["flat.ply", "--sources", "lh.label.gii#left", "--exact", "--walls", "lh.label.gii#wall"]);
    assert!((0..81).all(|vertex| walled[vertex].is_infinite() == (vertex / 9 == 4 && vertex % 9 < 8)));
    assert!(walled[72] > left[72] + 0.1 && (walled[9] - left[9]).abs() < 1e-12);
    for (file, said) in [
        ("lh.label.gii", "name one of them, as in lh.label.gii#???: ???, left, right, far, wall"),
        ("lh.label.gii#top", "lh.label.gii has no label \"top\"; it has ???, left"),
        ("missing.annot#left", "cannot read missing.annot"),
    ] {
        for option in ["--sources", "--walls"] {
            let line = refused(&folder, &["distance", "flat.ply", "--source", "0", option, file]);
            assert!(line.contains(said), "{line}");
        }
    }
}

#[test]
fn parcels_have_a_matrix() {
    let folder = folder("parcels");
    fs::write(folder.join("lh.label.gii"), label_gii()).unwrap();
    let matrix = |arguments: &[&str]| {
        let command =
            ["matrix", "flat.ply", "--parcels", "lh.label.gii", "--method", "exact", "--output", "parcels.csv"];
        let told = json(&folder, &[&command, arguments].concat());
        (told, fs::read_to_string(folder.join("parcels.csv")).unwrap())
    };
    let numbers = |text: &str| -> Vec<f64> {
        let cells =
            text.lines().skip(1).flat_map(|line| line.rsplit(',').take(3).collect::<Vec<_>>().into_iter().rev());
        cells.map(|cell| cell.parse().unwrap()).collect()
    };
    let (told, text) = matrix(&["--between", "minimum"]);
    assert_eq!(told["parcels"], serde_json::json!(["left", "right, far", "wall"]));
    assert_eq!(told["vertices_of_parcels"], serde_json::json!([9, 9, 8]));
    assert!(text.starts_with("parcel,left,\"right, far\",wall\nleft,"), "{text}");
    assert!(difference(&numbers(&text), &[0.0, 1.0, 0.5, 1.0, 0.0, 0.5, 0.5, 0.5, 0.0]) < 1e-12);
    // Of two columns of nine, over all pairs.
    let between = |apart: f64| -> f64 {
        let pairs = (0..9).flat_map(|a| (0..9).map(move |b| f64::from(a - b) / 8.0));
        pairs.map(|along: f64| along.hypot(apart)).sum::<f64>() / 81.0
    };
    let (_, text) = matrix(&["--threads", "2"]);
    let means = numbers(&text);
    assert!(difference(&[means[0], means[1], means[3]], &[between(0.0), between(1.0), between(1.0)]) < 1e-12);
    let (_, again) = matrix(&["--threads", "1"]);
    assert_eq!(again, text);
    let (_, walled) = matrix(&["--walls", "lh.label.gii#wall"]);
    let walled = numbers(&walled);
    assert!(walled[1] > means[1] + 0.05 && walled[1].is_finite(), "{walled:?}");
    assert!(walled[0] == means[0] && walled[2].is_infinite() && walled[8].is_infinite(), "{walled:?}");

    succeed(&folder, &["matrix", "flat.ply", "--parcels", "lh.label.gii", "--dtype", "f32", "--output", "parcels.npy"]);
    let bytes = fs::read(folder.join("parcels.npy")).unwrap();
    assert!(bytes.starts_with(b"\x93NUMPY") && bytes.len() % 64 == 36);
    let matrix = |mesh: &str, arguments: &[&str]| {
        refused(&folder, &[&["matrix", mesh, "--parcels", "lh.label.gii"], arguments].concat())
    };
    assert!(
        matrix("torus.ply", &["--output", "a.csv"])
            .contains("lh.label.gii labels 81 vertices, and the surface has 288")
    );
    assert!(matrix("flat.ply", &["--output", "a.npz"]).contains("not sparse"));
    assert!(
        matrix("flat.ply", &["--output", "a.csv", "--max-distance", "1"])
            .contains("--max-distance leaves distances out")
    );
}
