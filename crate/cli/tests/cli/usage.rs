//! Bad usage, help and pipes.

use std::fs;
use std::process::Command;

use crate::{folder, refused, succeed};

#[test]
fn bad_usage_and_bad_input_take_one_line() {
    let folder = folder("refused");
    fs::write(folder.join("noise.glb"), b"glTF\x02\0\0\0\xff\xff\xff\xff\xff\xff\xff\xffJSON{").unwrap();
    fs::write(folder.join("empty.off"), "").unwrap();
    fs::write(folder.join("text.txt"), "hello").unwrap();
    fs::write(folder.join("text.doc"), "hello").unwrap();
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
        (&["info", "text.txt"], "a point needs three numbers"),
        (&["info", "text.doc"], "not a mesh format"),
        (&["info", "torus.ply", "--part", "1"], "part 1"),
        (&["distance", "torus.ply"], "--source"),
        (&["distance", "torus.ply", "--source", "288"], "288"),
        (&["distance", "torus.ply", "--source", "-1"], "-1"),
        (&["path", "torus.ply", "--from", "0", "--to", "1", "--output", "p.glb"], ".obj"),
        (&["path", "torus.ply", "--from", "0"], "--to"),
    ] {
        let line = refused(&folder, arguments);
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
    for (options, hint) in [
        ("--t 0", "positive"),
        ("--t -1", "positive"),
        ("--t nan", "positive"),
        ("--repeat 0", "repeat"),
        ("--boundary warm", "warm"),
        ("--operator best", "delaunay, plain, relocate"),
        ("--solver lu", "cholesky, cg"),
        ("--multi both", "exact, summed"),
        ("--near -1", "0 or more"),
        ("--near nan", "0 or more"),
        ("--exact --compare", "cannot be used"),
        ("--output d.txt", ".csv"),
        ("--output no/such/folder/d.csv", "cannot write"),
    ] {
        let source = ["distance", "torus.ply", "--source", "0"];
        let line = refused(&folder, &source.into_iter().chain(options.split(' ')).collect::<Vec<_>>());
        assert!(line.contains(hint), "{options}: {line}");
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
