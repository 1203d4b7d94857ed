//! Files read and written.

use std::fs;
use std::io::Write;

use flate2::Compression;
use flate2::write::GzEncoder;
use rawzip::ZipArchiveWriter;

use crate::{folder, json, refused, run, succeed};

#[test]
fn info_counts() {
    let folder = folder("info");
    let info = json(&folder, &["info", "torus.ply"]);
    for (key, value) in
        [("vertices", 288), ("faces", 576), ("welded_vertices", 288), ("components", 1), ("boundary_loops", 0)]
    {
        assert_eq!(info[key], value, "{key}");
    }
    assert_eq!(info["parts"][0]["name"], "torus");
    assert!(info["timings_ms"]["read"].is_number() && info["timings_ms"]["build"].is_number());
    let two = json(&folder, &["info", "two.obj", "--part", "1"]);
    assert_eq!((&two["vertices"], &two["components"], &two["boundary_loops"]), (&7.into(), &1.into(), &1.into()));
    assert!(succeed(&folder, &["info", "two.obj"]).contains("near"));
}

#[test]
fn what_was_read_otherwise_than_it_is_written_is_told() {
    let folder = folder("warnings");
    fs::write(folder.join("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\ng left\\\nf 1 2 3\nl 2 3\n").unwrap();
    for command in [
        &["info", "a.obj"][..],
        &["distance", "a.obj", "--source", "0"],
        &["path", "a.obj", "--from", "0", "--to", "1"],
    ] {
        let output = run(&folder, &[command, &["--json"]].concat());
        assert!(output.status.success());
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(
            told,
            "heatwalk: warning: a.obj, line 4: 2 points or lines were left out\n\
             heatwalk: warning: a.obj, line 5: 1 backslash ends a line; the next one begins a statement of its own and was not joined to it\n"
        );
        let object: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let lines = serde_json::json!({ "code": "lines-left-out", "what": "2 points or lines were left out", "where": "line 4" });
        assert_eq!((&object["warnings"][0], object["warnings"].as_array().unwrap().len()), (&lines, 2));
    }
    assert_eq!(json(&folder, &["info", "torus.ply"])["warnings"], serde_json::json!([]));
}

#[test]
fn faces_of_files_that_may_hold_tetrahedra_are_a_surface() {
    let folder = folder("faces");
    let mesh =
        "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 Quadrilaterals 1 1 2 3 4 0 End";
    fs::write(folder.join("a.mesh"), mesh).unwrap();
    let info = json(&folder, &["info", "a.mesh"]);
    assert_eq!((&info["vertices"], &info["faces"]), (&4.into(), &2.into()));
    fs::write(folder.join("b.mesh"), "MeshVersionFormatted 2 Dimension 3 Vertices 1 0 0 0 0 End").unwrap();
    let told = refused(&folder, &["info", "b.mesh"]);
    assert!(told.contains("holds neither tetrahedra nor faces"), "{told}");
    let cells = "# vtk DataFile Version 3.0\na\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 7\n\
                 4 0 1 2 3\n1 0\nCELL_TYPES 2\n10\n42\n";
    fs::write(folder.join("c.vtk"), cells).unwrap();
    let told = refused(&folder, &["info", "c.vtk"]);
    assert!(told.contains("volume cell 1, a polyhedron, is not supported"), "{told}");
}

#[test]
fn info_names_what_is_missing() {
    let folder = folder("missing");
    fs::create_dir_all(folder.join("materials")).unwrap();
    fs::write(folder.join("materials/a.mtl"), "newmtl red\nKd 1 0 0\nmap_Kd red.png\n").unwrap();
    let libraries = "mtllib materials/a.mtl\nmtllib ../b.mtl\n";
    fs::write(folder.join("a.obj"), format!("{libraries}v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n")).unwrap();
    assert_eq!(json(&folder, &["info", "a.obj"])["missing"], serde_json::json!(["../b.mtl", "red.png"]));
    assert!(succeed(&folder, &["info", "a.obj"]).contains("missing                red.png\n"));
    assert_eq!(json(&folder, &["info", "torus.ply"])["missing"], serde_json::json!([]));
}

#[test]
fn the_unit_is_that_of_the_format_or_of_the_size_or_as_asked() {
    let folder = folder("unit");
    succeed(&folder, &["distance", "torus.ply", "--source", "0", "--output", "d.glb"]);
    assert_eq!(json(&folder, &["info", "d.glb"])["unit"], "m");
    assert_eq!(json(&folder, &["path", "d.glb", "--from", "0", "--to", "9"])["unit"], "m");
    assert!(succeed(&folder, &["info", "d.glb"]).contains("unit                   m\n"));
    let unit = |arguments: &[&str]| {
        let told = json(&folder, arguments);
        (told["unit"].clone(), told["unit_assumed"].clone())
    };
    assert_eq!(unit(&["info", "d.glb"]), ("m".into(), false.into()));
    assert_eq!(unit(&["info", "torus.ply"]), ("m".into(), true.into()));
    assert_eq!(unit(&["info", "torus.ply", "--unit", "in"]), ("in".into(), false.into()));
    assert_eq!(unit(&["info", "d.glb", "--unit", "none"]), (serde_json::Value::Null, false.into()));
    assert_eq!(unit(&["info", "shape:torus"]), (serde_json::Value::Null, false.into()));
    // No length changes with it.
    let edge = |unit| json(&folder, &["info", "d.glb", "--unit", unit])["mean_edge"].clone();
    assert_eq!(edge("m"), edge("mm"));
    let text = succeed(&folder, &["info", "torus.ply"]);
    assert!(text.contains("unit                   m\n") && text.contains("unit assumed           true\n"), "{text}");
    assert!(refused(&folder, &["info", "torus.ply", "--unit", "yard"]).contains("the unit"));
}

const HEAT: [&str; 6] = ["distance", "torus.ply", "--source", "0", "--method", "heat"];

#[test]
fn distance_to_csv_ply_and_glb() {
    let folder = folder("distance");
    for name in ["d.csv", "d.ply", "d.glb"] {
        let answer = json(&folder, &[&HEAT[..], &["--output", name, "--repeat", "3"]].concat());
        for key in ["read", "build", "precompute", "solve"] {
            assert!(answer["timings_ms"][key].as_f64().unwrap() >= 0.0, "{key}");
        }
        let stages = answer["stages_ms"].as_object().unwrap();
        let total: f64 = stages.values().map(|time| time.as_f64().unwrap()).sum();
        let precompute = answer["timings_ms"]["precompute"].as_f64().unwrap();
        assert!(stages.contains_key("ordering"), "{stages:?}");
        assert!((total - precompute).abs() <= 1e-9 * precompute, "{total} is not {precompute}");
        let sources = answer["timed_sources"].as_array().unwrap();
        assert!(sources.len() == 3 && sources.iter().all(|source| source.as_u64().unwrap() < 288), "{sources:?}");
        assert!(answer["factor_nonzeros"].as_u64().unwrap() > 288);
        assert_eq!(answer["unreachable"], 0);
        // Half around the ring along its inside and over the tube: between π · 0.6 and π · 1.8.
        let max = answer["max_distance"].as_f64().unwrap();
        assert!((1.9..5.7).contains(&max), "{max}");
    }
    let csv = fs::read_to_string(folder.join("d.csv")).unwrap();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("vertex,distance"));
    assert_eq!(lines.next(), Some("0,0.0000000000000000e0"));
    assert_eq!(lines.count(), 287);
    assert_eq!(json(&folder, &["info", "d.glb"])["faces"], 576);
    assert_eq!(json(&folder, &["info", "d.ply"])["faces"], 576);
    assert!(succeed(&folder, &["distance", "torus.ply", "--source", "0"]).contains("max distance"));
}

#[test]
fn what_points_up_is_y_in_the_output() {
    let folder = folder("up");
    let points = |name: &str, options: &[&str]| {
        let path = ["path", "torus.ply", "--from", "0", "--to", "100", "--output", name];
        succeed(&folder, &[&path[..], options].concat());
        let text = fs::read_to_string(folder.join(name)).unwrap();
        let point = |line: &str| line.split(' ').skip(1).map(|number| number.parse().unwrap()).collect::<Vec<f64>>();
        text.lines().filter(|line| line.starts_with("v ")).map(point).collect::<Vec<_>>()
    };
    let plain = points("plain.obj", &[]);
    assert!(plain.len() > 2);
    assert_eq!(points("y.obj", &["--up", "y"]), plain);
    for (up, turn) in [
        ("z", (|p: &Vec<f64>| vec![p[0], p[2], -p[1]]) as fn(&Vec<f64>) -> Vec<f64>),
        ("-x", |p: &Vec<f64>| vec![p[1], -p[0], p[2]]),
    ] {
        assert_eq!(points("turned.obj", &["--up", up]), plain.iter().map(turn).collect::<Vec<_>>(), "{up}");
    }
    let turned = |name: &str, up: &str| {
        succeed(&folder, &["distance", "torus.ply", "--source", "0", "--output", name, "--up", up]);
        fs::read(folder.join(name)).unwrap()
    };
    for (format, other) in [("a.ply", "b.ply"), ("a.glb", "b.glb")] {
        assert_ne!(turned(format, "y"), turned(other, "z"), "{format}");
    }
    assert!(refused(&folder, &["distance", "torus.ply", "--source", "0", "--up", "z"]).contains("--output"));
    assert!(refused(&folder, &["path", "torus.ply", "--from", "0", "--to", "1", "--up", "w"]).contains("-x"));
}

#[test]
fn unreachable_and_unreferenced_vertices_are_infinite() {
    let folder = folder("unreachable");
    let answer = json(&folder, &["distance", "two.obj", "--source", "0", "--output", "d.csv"]);
    assert_eq!((&answer["unreachable"], &answer["components"]), (&4.into(), &2.into()));
    let csv = fs::read_to_string(folder.join("d.csv")).unwrap();
    assert_eq!(csv.lines().filter(|line| line.ends_with(",inf")).count(), 4);
    assert_eq!(csv.lines().count(), 8);
    let both = json(&folder, &["distance", "two.obj", "--source", "0", "--source", "3"]);
    assert_eq!(both["unreachable"], 1);
    refused(&folder, &["path", "two.obj", "--from", "0", "--to", "3"]);
    assert!(refused(&folder, &["distance", "two.obj", "--source", "6"]).contains("no triangle"));
}

#[test]
fn companions_are_read_beside_the_mesh_only() {
    let folder = folder("companions");
    let gltf = |uri: &str| {
        format!(
            r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}}],"buffers":[{{"byteLength":36,"uri":"{uri}"}}]}}"#
        )
    };
    let bytes: Vec<u8> = [0., 0., 0., 1., 0., 0., 0., 1., 0.].iter().flat_map(|v: &f32| v.to_le_bytes()).collect();
    fs::create_dir_all(folder.join("below")).unwrap();
    fs::write(folder.join("a b.bin"), &bytes).unwrap();
    fs::write(folder.join("inside.gltf"), gltf("a%20b.bin")).unwrap();
    fs::write(folder.join("below/outside.gltf"), gltf("../a%20b.bin")).unwrap();
    fs::write(folder.join("absolute.gltf"), gltf(folder.join("a b.bin").to_str().unwrap())).unwrap();
    assert_eq!(json(&folder, &["info", "inside.gltf"])["faces"], 1);
    assert!(refused(&folder, &["info", "below/outside.gltf"]).contains("not given"));
    refused(&folder, &["info", "absolute.gltf"]);
}

#[test]
fn files_cut_short_or_damaged_never_crash() {
    let folder = folder("damaged");
    let whole = fs::read(folder.join("torus.ply")).unwrap();
    for eighth in 0..8 {
        fs::write(folder.join("part.ply"), &whole[..whole.len() * eighth / 8]).unwrap();
        refused(&folder, &["distance", "part.ply", "--source", "0"]);
        let mut damaged = whole.clone();
        damaged[whole.len() * (2 * eighth + 1) / 16] ^= 0xff;
        fs::write(folder.join("damaged.ply"), damaged).unwrap();
        let output = run(&folder, &["distance", "damaged.ply", "--source", "0"]);
        assert!(matches!(output.status.code(), Some(0 | 2)), "{output:?}");
    }
}

/// A file and what it is packed as by gzip.
fn gzip(text: &str) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(text.as_bytes()).unwrap();
    encoder.finish().unwrap()
}

/// An archive of files that are stored.
fn zip(files: &[(&str, &str)]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    for (name, text) in files {
        let (mut entry, config) = archive.new_file(name).start().unwrap();
        let mut writer = config.wrap(Vec::new());
        writer.write_all(text.as_bytes()).unwrap();
        let (plain, descriptor) = writer.finish().unwrap();
        entry.write_all(&plain).unwrap();
        entry.finish(descriptor).unwrap();
    }
    archive.finish().unwrap();
    bytes
}

const SQUARE: &str = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const TETRAHEDRON: &str = "MeshVersionFormatted 2 Dimension 3 \
    Vertices 4 0 0 0 0  1 0 0 0  0 1 0 0  0 0 1 0 Tetrahedra 1 1 2 3 4 0 End";

#[test]
fn packed_files_are_read() {
    let folder = folder("packed");
    fs::write(folder.join("square.off.gz"), gzip(SQUARE)).unwrap();
    fs::write(folder.join("corner.mesh.gz"), gzip(TETRAHEDRON)).unwrap();
    let halves = [gzip(&SQUARE[..9]), gzip(&SQUARE[9..])].concat();
    fs::write(folder.join("halves.off.GZ"), halves).unwrap();
    for name in ["square.off.gz", "halves.off.GZ"] {
        assert_eq!(json(&folder, &["info", name])["faces"], 2, "{name}");
    }
    assert_eq!(json(&folder, &["info", "square.off.gz"])["parts"][0]["name"], "square");
    assert_eq!(json(&folder, &["info", "corner.mesh.gz"])["tetrahedra"], 1);

    let text = "mtllib skin.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    let files = [("farm/cow.obj", text), ("farm/skin.mtl", "newmtl a\nmap_Kd maps/cow.png\n"), ("readme.txt", "")];
    fs::write(folder.join("cow.zip"), zip(&files)).unwrap();
    let told = json(&folder, &["info", "cow.zip"]);
    assert_eq!((&told["faces"], &told["missing"]), (&1.into(), &serde_json::json!(["maps/cow.png"])));
    fs::write(folder.join("corner.zip"), zip(&[("a/corner.mesh", TETRAHEDRON), (".hidden.off", SQUARE)])).unwrap();
    assert_eq!(json(&folder, &["info", "corner.zip"])["tetrahedra"], 1);
}

#[test]
fn packed_files_that_are_none_are_refused() {
    let folder = folder("not_packed");
    let whole = gzip(SQUARE);
    let bomb = gzip(&"#".repeat(80 << 20));
    for (name, bytes, part) in [
        ("cut.off.gz", &whole[..whole.len() - 9], "damaged or cut short"),
        ("bomb.off.gz", &bomb, "of memory"),
        ("none.zip", &zip(&[("readme.txt", "")]), "holds no mesh"),
        ("two.zip", &zip(&[("a.off", SQUARE), ("b/c.obj", "")]), "2 meshes (a.off, b/c.obj)"),
        ("twice.zip", &zip(&[("a.off", SQUARE), ("a.off", SQUARE)]), "two files of the archive have this name"),
        ("cut.zip", b"PK\x03\x04", "damaged or cut short"),
    ] {
        fs::write(folder.join(name), bytes).unwrap();
        let told = refused(&folder, &["info", name]);
        assert!(told.contains(part) && told.contains(name), "{told}");
    }
}

#[test]
#[cfg(unix)]
fn an_earlier_file_stays_where_a_new_one_cannot_be_written() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::Command;

    let folder = folder("earlier");
    let place = folder.join("d.csv");
    let stumps = || {
        let paths = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
        paths.filter(|path| path.file_name().unwrap().to_string_lossy().starts_with(".heatwalk"))
    };
    stumps().for_each(|path| fs::remove_file(path).unwrap());
    // The disk is full after a kilobyte: the program is told, or ended.
    for (signal, left) in [("trap '' XFSZ; ", 0), ("", 1)] {
        fs::write(&place, "earlier").unwrap();
        let script = format!(
            "{signal}ulimit -f 1; exec '{}' distance torus.ply --source 0 --output d.csv",
            env!("CARGO_BIN_EXE_heatwalk")
        );
        let status = Command::new("sh").current_dir(&folder).args(["-c", &script]).output().unwrap().status;
        assert!(!status.success());
        assert_eq!(fs::read_to_string(&place).unwrap(), "earlier");
        assert_eq!(stumps().count(), left, "{signal}");
    }
    // Its permissions stay, and a link to it stays one.
    fs::set_permissions(&place, fs::Permissions::from_mode(0o640)).unwrap();
    let link = folder.join("link.csv");
    let _ = fs::remove_file(&link);
    symlink("d.csv", &link).unwrap();
    succeed(&folder, &["distance", "torus.ply", "--source", "0", "--output", "link.csv"]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read_to_string(&place).unwrap().starts_with("vertex,distance"));
    assert_eq!(fs::metadata(&place).unwrap().permissions().mode() & 0o777, 0o640);
    // What is no file is written as it is.
    let device = folder.join("device.csv");
    let _ = fs::remove_file(&device);
    symlink("/dev/null", &device).unwrap();
    succeed(&folder, &["distance", "torus.ply", "--source", "0", "--output", "device.csv"]);
    assert!(!fs::metadata(&device).unwrap().is_file());
}
