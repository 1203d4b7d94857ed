//! The real binary on small files.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use heatwalk::io::write;
use heatwalk::shapes;
use serde_json::Value;

/// A folder of its own for each test, with a torus, a maze and a damaged file.
fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    fs::create_dir_all(&folder).unwrap();
    for (name, soup) in [("torus.ply", shapes::torus(1.0, 0.4, 24, 12)), ("grid.ply", shapes::grid(10, 10))] {
        fs::write(folder.join(name), write::distance_ply(&soup, &vec![0.0; soup.positions.len()])).unwrap();
    }
    let whole = fs::read(folder.join("torus.ply")).unwrap();
    fs::write(folder.join("cut.ply"), &whole[..whole.len() / 2]).unwrap();
    let two = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 9 9 9\ng near\nf 1 2 3\ng far\nf 4 5 6\n";
    fs::write(folder.join("two.obj"), two).unwrap();
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_heatwalk")).current_dir(folder).args(arguments).output().unwrap()
}

fn succeed(folder: &Path, arguments: &[&str]) -> String {
    let output = run(folder, arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && stderr.is_empty(), "{arguments:?}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(folder: &Path, arguments: &[&str]) -> Value {
    let text = succeed(folder, &[arguments, &["--json"]].concat());
    serde_json::from_str(&text).unwrap()
}

/// Exit code 2, nothing on standard output, exactly one line on standard error, which is returned.
fn refused(folder: &Path, arguments: &[&str]) -> String {
    let output = run(folder, arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert_eq!(stderr.lines().count(), 1, "{arguments:?}: {stderr}");
    assert!(stderr.ends_with('\n'));
    stderr
}

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
    assert_eq!((&two["vertices"], &two["components"], &two["boundary_loops"]), (&3.into(), &1.into(), &1.into()));
    assert!(succeed(&folder, &["info", "two.obj"]).contains("near"));
}

#[test]
fn distance_to_csv_ply_and_glb() {
    let folder = folder("distance");
    for name in ["d.csv", "d.ply", "d.glb"] {
        let answer = json(&folder, &["distance", "torus.ply", "--source", "0", "--output", name, "--repeat", "3"]);
        for key in ["read", "build", "precompute", "solve"] {
            assert!(answer["timings_ms"][key].as_f64().unwrap() >= 0.0, "{key}");
        }
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
fn dials_change_the_answer() {
    let folder = folder("dials");
    let max = |dials: &[&str]| {
        let arguments = [&["distance", "grid.ply", "--source", "0"], dials].concat();
        json(&folder, &arguments)["max_distance"].as_f64().unwrap()
    };
    assert_ne!(max(&[]), max(&["--t", "20"]));
    assert_ne!(max(&["--boundary", "neumann"]), max(&["--boundary", "dirichlet"]));
    max(&["--boundary", "average"]);
}

#[test]
fn path_across_the_grid() {
    let folder = folder("path");
    // Along the diagonal of the unit square, corner to corner.
    for name in ["p.obj", "p.csv"] {
        let answer = json(&folder, &["path", "grid.ply", "--from", "0", "--to", "120", "--output", name]);
        let points = answer["points"].as_array().unwrap();
        assert_eq!(points[0], serde_json::json!([0.0, 0.0, 0.0]));
        assert_eq!(points[points.len() - 1], serde_json::json!([1.0, 0.0, -1.0]));
        let (length, distance) = (answer["length"].as_f64().unwrap(), answer["distance"].as_f64().unwrap());
        // No way is shorter than the straight one; ten cells across, the heat method is good to some percent.
        assert!((2.0_f64.sqrt() - 1e-9..1.5).contains(&length), "{length}");
        assert!((distance - 2.0_f64.sqrt()).abs() < 0.15, "{distance}");
    }
    assert!(fs::read_to_string(folder.join("p.obj")).unwrap().contains("\nl 1 2"));
    assert!(fs::read_to_string(folder.join("p.csv")).unwrap().starts_with("x,y,z\n"));
    assert!(succeed(&folder, &["path", "grid.ply", "--from", "3", "--to", "3"]).contains("length"));
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
fn bad_usage_and_bad_input_take_one_line() {
    let folder = folder("refused");
    fs::write(folder.join("noise.glb"), b"glTF\x02\0\0\0\xff\xff\xff\xff\xff\xff\xff\xffJSON{").unwrap();
    fs::write(folder.join("empty.off"), "").unwrap();
    fs::write(folder.join("text.txt"), "hello").unwrap();
    for (arguments, hint) in [
        (&[][..], "give a command"),
        (&["fly"], "fly"),
        (&["info"], "<MESH>"),
        (&["info", "torus.ply", "--loud"], "--loud"),
        (&["info", "missing.off"], "missing.off"),
        (&["info", "."], "not a file"),
        (&["info", "cut.ply"], "cut short"),
        (&["info", "noise.glb"], "cut short"),
        (&["info", "empty.off"], "empty.off"),
        (&["info", "text.txt"], "not a mesh format"),
        (&["info", "torus.ply", "--part", "1"], "part 1"),
        (&["distance", "torus.ply"], "--source"),
        (&["distance", "torus.ply", "--source", "288"], "288"),
        (&["distance", "torus.ply", "--source", "-1"], "-1"),
        (&["distance", "torus.ply", "--source", "0", "--t", "0"], "positive"),
        (&["distance", "torus.ply", "--source", "0", "--t", "-1"], "positive"),
        (&["distance", "torus.ply", "--source", "0", "--t", "nan"], "positive"),
        (&["distance", "torus.ply", "--source", "0", "--repeat", "0"], "repeat"),
        (&["distance", "torus.ply", "--source", "0", "--boundary", "warm"], "warm"),
        (&["distance", "torus.ply", "--source", "0", "--output", "d.txt"], ".csv"),
        (&["distance", "torus.ply", "--source", "0", "--output", "no/such/folder/d.csv"], "cannot write"),
        (&["path", "torus.ply", "--from", "0", "--to", "1", "--output", "p.glb"], ".obj"),
        (&["path", "torus.ply", "--from", "0"], "--to"),
    ] {
        let line = refused(&folder, arguments);
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
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

#[test]
fn help_and_version_succeed() {
    let folder = folder("help");
    assert!(succeed(&folder, &["--help"]).contains("distance"));
    assert!(succeed(&folder, &["path", "--help"]).contains("--from"));
    assert!(succeed(&folder, &["--version"]).starts_with("heatwalk "));
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_error() {
    let folder = folder("pipe");
    let command = format!(
        "'{}' path grid.ply --from 0 --to 120 --json | true; exit ${{PIPESTATUS[0]}}",
        env!("CARGO_BIN_EXE_heatwalk")
    );
    let output = Command::new("bash").current_dir(&folder).args(["-c", &command]).output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
}
