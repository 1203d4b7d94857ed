//! Many meshes by one command, and that what is done is done once.

use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use heatwalk_model::io::write;
use heatwalk_shapes as shapes;
use serde_json::Value;

use crate::{folder, refused, run, succeed};

/// A folder with meshes in it, of a test of its own, without what an earlier run of the test has left.
fn meshes(test: &str, names: &[&str]) -> PathBuf {
    let folder = folder(test);
    let _ = fs::remove_dir_all(folder.join("out"));
    let _ = fs::remove_dir_all(folder.join("scans"));
    for (number, name) in (0..).zip(names) {
        let path = folder.join("scans").join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        let soup = shapes::torus(1.0, 0.4, 24 + number, 12);
        fs::write(path, write::distance_ply(&soup, &vec![0.0; soup.positions.len()])).unwrap();
    }
    folder
}

/// What a run tells as an object, and what it complains of.
fn told(folder: &Path, arguments: &[&str]) -> (Value, String, Option<i32>) {
    let output = run(folder, &[&["batch", "scans", "--output", "out", "--json"], arguments].concat());
    let told = serde_json::from_slice(&output.stdout).unwrap_or_default();
    (told, String::from_utf8(output.stderr).unwrap(), output.status.code())
}

fn counts((told, _, _): &(Value, String, Option<i32>)) -> [u64; 4] {
    ["meshes", "done", "done_before", "failed"].map(|name| told[name].as_u64().unwrap())
}

/// Lines of the manifest, without what is not the same at each run.
fn manifest(folder: &Path, out: &str) -> Vec<Value> {
    let text = fs::read_to_string(folder.join(out).join("manifest.jsonl")).unwrap();
    let line = |line: &str| {
        let mut line: Value = serde_json::from_str(line).unwrap();
        line["seconds"] = Value::Null;
        for timed in ["timings_ms", "threads", "rows_before"] {
            line["result"].as_object_mut().map(|result| result.remove(timed));
        }
        line
    };
    text.lines().map(line).collect()
}

/// All files below a folder but the manifest, with what is in them.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(self::files(&path));
        } else if path.file_name().unwrap() != "manifest.jsonl" {
            files.insert(path.clone(), fs::read(path).unwrap());
        }
    }
    files
}

/// The same by names below the folder.
fn files_of(folder: &Path, out: &str) -> BTreeMap<PathBuf, Vec<u8>> {
    let out = folder.join(out);
    files(&out).into_iter().map(|(path, bytes)| (path.strip_prefix(&out).unwrap().to_owned(), bytes)).collect()
}

#[test]
fn files_are_those_of_the_command_on_each_mesh() {
    let folder = meshes("batch_files", &["a.ply", "b.ply", "inner/a.ply", ".hidden.ply"]);
    fs::write(folder.join("scans/notes.txt"), "not a mesh").unwrap();
    let distance = ["distance", "--source", "5", "--method", "exact", "--output", "fields/{}.csv"];
    assert_eq!(counts(&told(&folder, &distance)), [3, 3, 0, 0]);
    for name in ["a", "b", "inner/a"] {
        let mesh = format!("scans/{name}.ply");
        let single = ["distance", &mesh, "--source", "5", "--method", "exact", "--output", "single.csv"];
        succeed(&folder, &single);
        let written = fs::read(folder.join(format!("out/fields/{name}.csv"))).unwrap();
        assert!(written == fs::read(folder.join("single.csv")).unwrap(), "{name}");
    }
    let lines = manifest(&folder, "out");
    let names: Vec<&str> = lines.iter().map(|line| line["mesh"].as_str().unwrap()).collect();
    assert_eq!(names, ["scans/a.ply", "scans/b.ply", "scans/inner/a.ply"]);
    assert_eq!(lines[0]["result"]["method"], "exact");
    assert_eq!(lines[0]["files"][0]["file"], "fields/a.csv");

    // Of a command that writes no file, the result is in the manifest; those of a list are taken in place of a folder.
    fs::write(folder.join("list.txt"), "# two\nscans/b.ply\n\nshape:torus\n").unwrap();
    let list = ["batch", "list.txt", "--output", "out/facts", "info"];
    succeed(&folder, &list);
    let faces: Vec<Value> = manifest(&folder, "out/facts").iter().map(|line| line["result"]["faces"].clone()).collect();
    assert_eq!(faces, [600.into(), Value::from(17_280)]);
}

#[test]
fn what_is_done_is_done_again_only_where_something_changed() {
    let folder = meshes("batch_again", &["a.ply", "b.ply", "c.ply"]);
    for (name, source) in [("a", "1"), ("b", "2"), ("c", "3")] {
        fs::write(folder.join(format!("scans/{name}.sources")), source).unwrap();
    }
    let command = ["distance", "--sources", "scans/{}.sources", "--output", "{}.csv"];
    assert_eq!(counts(&told(&folder, &command)), [3, 3, 0, 0]);
    assert_eq!(counts(&told(&folder, &command)), [3, 0, 3, 0]);
    // The mesh; the file of sources; the written file.
    let grid = fs::read(folder.join("grid.ply")).unwrap();
    fs::write(folder.join("scans/a.ply"), grid).unwrap();
    assert_eq!(counts(&told(&folder, &command)), [3, 1, 2, 0]);
    fs::write(folder.join("scans/b.sources"), "7").unwrap();
    assert_eq!(counts(&told(&folder, &command)), [3, 1, 2, 0]);
    let csv = fs::read_to_string(folder.join("out/b.csv")).unwrap();
    assert!(csv.contains("\n7,0.0000000000000000e0\n"));
    fs::write(folder.join("out/c.csv"), "cut").unwrap();
    assert_eq!(counts(&told(&folder, &command)), [3, 1, 2, 0]);
    // Options.
    let exact = [&command[..], &["--method", "exact"]].concat();
    assert_eq!(counts(&told(&folder, &exact)), [3, 3, 0, 0]);
    assert_eq!(counts(&told(&folder, &exact)), [3, 0, 3, 0]);
}

#[test]
fn one_bad_mesh_does_not_end_the_run() {
    let folder = meshes("batch_bad", &["a.ply", "b.ply", "c.ply"]);
    fs::copy(folder.join("cut.ply"), folder.join("scans/b.ply")).unwrap();
    fs::copy(folder.join("flat.ply"), folder.join("scans/c.obj")).unwrap();
    let command = ["distance", "--source", "3", "--output", "{}.csv"];
    let first = told(&folder, &command);
    assert_eq!(counts(&first), [4, 2, 0, 2]);
    assert_eq!(first.2, Some(2));
    let sentences: Vec<&str> = first.1.lines().collect();
    assert_eq!(sentences.len(), 2, "{sentences:?}");
    assert!(sentences[0].contains("scans/b.ply") && sentences[0].contains("cut short"), "{sentences:?}");
    // Another one that has the same name.
    assert!(
        sentences[1].contains("scans/c.ply") && sentences[1].contains("is written for scans/c.obj"),
        "{sentences:?}"
    );
    let lines = manifest(&folder, "out");
    assert_eq!(lines[1]["error"]["code"], "malformed");
    assert!(lines[1]["error"]["sentence"].as_str().unwrap().contains("cut short"));
    // It is tried again.
    fs::copy(folder.join("torus.ply"), folder.join("scans/b.ply")).unwrap();
    fs::remove_file(folder.join("scans/c.obj")).unwrap();
    let next = told(&folder, &command);
    assert_eq!((counts(&next), next.2), ([3, 2, 1, 0], Some(0)));
}

fn spawn(folder: &Path, arguments: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_heatwalk"));
    command.current_dir(folder).args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// Waits for something that a process in the middle of its work has done.
fn wait(process: &mut Child, is_so: impl Fn() -> bool) {
    while !is_so() {
        assert!(process.try_wait().unwrap().is_none(), "it was to be ended in the middle");
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn line_count(path: &Path) -> usize {
    fs::read_to_string(path).map_or(0, |text| text.lines().count())
}

const MATRIX: [&str; 7] = ["matrix", "--landmarks", "100", "--method", "exact", "--output", "{}.npy"];

#[test]
fn a_killed_run_is_finished_by_the_next_to_the_last_bit() {
    let names = ["a.ply", "b.ply", "c.ply", "d.ply", "e.ply", "f.ply"];
    let folder = meshes("batch_killed", &names);
    let _ = fs::remove_dir_all(folder.join("whole"));
    succeed(&folder, &[&["batch", "scans", "--output", "whole"], &MATRIX[..]].concat());
    let batch = [&["batch", "scans", "--output", "out", "--jobs", "2"], &MATRIX[..]].concat();
    let path = folder.join("out/manifest.jsonl");
    for lines in [1, 3] {
        let mut process = spawn(&folder, &batch);
        wait(&mut process, || line_count(&path) >= lines);
        process.kill().unwrap();
        process.wait().unwrap();
        // A line that was being written does not count.
        OpenOptions::new().append(true).open(&path).unwrap().write_all(b"{\"mesh\":\"scans/f.ply\",\"resu").unwrap();
    }
    let (finished, stderr, code) = told(&folder, &[&["--jobs", "1"], &MATRIX[..]].concat());
    assert_eq!((code, finished["failed"].as_u64()), (Some(0), Some(0)), "{stderr}");
    assert!(finished["done_before"].as_u64().unwrap() >= 3, "{finished}");
    assert_eq!(manifest(&folder, "out"), manifest(&folder, "whole"));
    assert!(files_of(&folder, "out") == files_of(&folder, "whole"));
}

#[test]
fn a_matrix_of_a_killed_run_goes_on_in_its_middle() {
    let folder = meshes("batch_killed_matrix", &[]);
    fs::create_dir_all(folder.join("scans")).unwrap();
    let soup = shapes::torus(1.0, 0.4, 48, 24);
    let bytes = write::distance_ply(&soup, &vec![0.0; soup.positions.len()]);
    fs::write(folder.join("scans/large.ply"), bytes).unwrap();
    let matrix = ["matrix", "--all", "--method", "exact", "--output", "{}.npy"];
    let mut process = spawn(&folder, &[&["batch", "scans", "--output", "out"], &matrix[..]].concat());
    let waiting = || fs::read_dir(folder.join("out/.batch")).into_iter().flatten().flatten().map(|entry| entry.path());
    wait(&mut process, || waiting().any(|path| line_count(&path.join("0.npy.part.log")) >= 3));
    process.kill().unwrap();
    process.wait().unwrap();
    // The process of the mesh ends with the one that has started it, and nothing is written any more.
    let start = Instant::now();
    let part = waiting().map(|path| path.join("0.npy.part")).find(|path| path.exists()).unwrap();
    let is_free = || OpenOptions::new().write(true).open(&part).unwrap().try_lock().is_ok();
    while !is_free() {
        assert!(start.elapsed() < Duration::from_secs(5), "it goes on without the other");
        std::thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(counts(&told(&folder, &matrix)), [1, 1, 0, 0]);
    let text = fs::read_to_string(folder.join("out/manifest.jsonl")).unwrap();
    let line: Value = serde_json::from_str(&text).unwrap();
    assert!(line["result"]["rows_before"].as_u64().unwrap() >= 64, "{line}");
    succeed(
        &folder,
        &["matrix", "scans/large.ply", "--all", "--method", "exact", "--threads", "2", "--output", "whole.npy"],
    );
    assert!(fs::read(folder.join("out/large.npy")).unwrap() == fs::read(folder.join("whole.npy")).unwrap());
}

/// What the keys of a terminal send.
#[cfg(unix)]
#[test]
fn an_interrupted_run_is_finished_by_the_next() {
    let folder = meshes("batch_interrupted", &["a.ply", "b.ply", "c.ply", "d.ply"]);
    let mut process = spawn(&folder, &[&["batch", "scans", "--output", "out", "--jobs", "1"], &MATRIX[..]].concat());
    let path = folder.join("out/manifest.jsonl");
    wait(&mut process, || line_count(&path) >= 1);
    // Beside another one, nothing is written.
    let other = refused(&folder, &[&["batch", "scans", "--output", "out"], &MATRIX[..]].concat());
    assert!(other.contains("is being written by another run"), "{other}");
    let interrupt = Command::new("kill").args(["-INT", &process.id().to_string()]).status().unwrap();
    assert!(interrupt.success());
    let start = Instant::now();
    assert!(!process.wait().unwrap().success() && start.elapsed() < Duration::from_secs(1));
    assert!(line_count(&path) < 4);
    let finished = told(&folder, &MATRIX);
    assert_eq!((counts(&finished)[0], counts(&finished)[3], finished.2), (4, 0, Some(0)));
    assert_eq!(files_of(&folder, "out").len(), 4 + 1);
}

/// A file may have no more than so many blocks: what a full disk does, without one.
#[cfg(unix)]
#[test]
fn a_full_disk_is_told_and_what_is_finished_is_kept() {
    let folder = meshes("batch_full", &["a.ply", "b.ply"]);
    fs::copy(folder.join("flat.ply"), folder.join("scans/c.ply")).unwrap();
    let batch = ["batch", "scans", "--output", "out", "matrix", "--all", "--output", "{}.npy"];
    let limited = format!("trap '' XFSZ; ulimit -f 300; exec \"$0\" {}", batch.join(" "));
    let mut shell = Command::new("sh");
    let output = shell.current_dir(&folder).args(["-c", &limited, env!("CARGO_BIN_EXE_heatwalk")]).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("scans/a.ply") && stderr.contains("cannot write") && !stderr.contains("c.ply"), "{stderr}");
    assert!(folder.join("out/c.npy").exists() && !folder.join("out/a.npy").exists());
    assert_eq!(counts(&told(&folder, &batch[4..])), [3, 2, 1, 0]);
    for name in ["a", "b", "c"] {
        succeed(&folder, &["matrix", &format!("scans/{name}.ply"), "--all", "--output", "single.npy"]);
        let written = fs::read(folder.join(format!("out/{name}.npy"))).unwrap();
        assert!(written == fs::read(folder.join("single.npy")).unwrap(), "{name}");
    }
}

#[test]
fn bad_batches_are_refused() {
    let folder = meshes("batch_refused", &["a.ply"]);
    fs::create_dir_all(folder.join("empty")).unwrap();
    for (arguments, hint) in [
        (&["scans", "--output", "out"][..], "<COMMAND>"),
        (&["scans", "info"], "--output"),
        (&["missing", "--output", "out", "info"], "cannot read missing"),
        (&["empty", "--output", "out", "info"], "there is no mesh"),
        (&["scans", "--output", "out", "fly"], "fly"),
        (&["scans", "--output", "out", "table"], "not a command on one mesh"),
        (&["scans", "--output", "out", "distance", "--output", "{}.csv"], "--source"),
        (&["scans", "--output", "out", "distance", "--source", "0", "--output", "a.csv"], "put {}"),
        (&["scans", "--output", "out", "distance", "--source", "0", "--output=-"], "put {}"),
        (&["scans", "--output", "out", "distance", "--source", "0", "--output", "../{}.csv"], "not below"),
        (&["scans", "--output", "torus.ply", "info"], "cannot write torus.ply"),
        (&["scans", "--output", "out", "--jobs", "0", "info"], "--jobs"),
    ] {
        let line = refused(&folder, &[&["batch"], arguments].concat());
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
}
