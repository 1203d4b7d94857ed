//! `cargo xtask cycles` on small crates.

use std::fs;
use std::path::Path;
use std::process::Command;

/// What it says of a crate of these files, and whether it finds no cycle.
fn check(name: &str, files: &[(&str, &str)]) -> (bool, String) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    // Left over from the last run.
    let _ = fs::remove_dir_all(&folder);
    for (path, text) in files {
        let path = folder.join("only/src").join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder can be made");
        fs::write(path, text).expect("a file can be written");
    }
    let output = Command::new(env!("CARGO_BIN_EXE_xtask")).arg("cycles").arg(&folder).output().expect("xtask runs");
    (output.status.success(), String::from_utf8(output.stderr).expect("it speaks Unicode"))
}

fn finds(name: &str, cycle: &str, files: &[(&str, &str)]) -> String {
    let (passes, said) = check(name, files);
    assert!(!passes && said.contains(cycle), "{said}");
    said
}

fn passes(name: &str, files: &[(&str, &str)]) {
    let (passes, said) = check(name, files);
    assert!(passes, "{said}");
}

#[test]
fn names_the_cycle_with_files_and_lines() {
    let said = finds(
        "three",
        "src: a → b → c → a\n",
        &[
            ("lib.rs", "mod a;\nmod b;\nmod c;\n"),
            ("a.rs", "pub struct A;\n\npub fn f() {\n    crate::b::g();\n}\n"),
            ("b.rs", "pub fn g() {\n    super::c::h(super::c::C);\n}\n"),
            ("c.rs", "use crate::a::A;\npub struct C;\npub fn h(_: C) -> A { A }\n"),
        ],
    );
    for place in ["a.rs:4 crate::b::g", "b.rs:2 super::c::h", "c.rs:1 crate::a::A"] {
        assert!(said.contains(place), "{place} is missing in:\n{said}");
    }
}

#[test]
fn follows_re_exports_to_the_definition() {
    let files = [
        ("lib.rs", "mod a;\nmod b;\npub use a::A;\npub use b::B;\n"),
        ("a.rs", "use crate::B;\npub struct A(B);\n"),
        ("b.rs", "pub struct B;\npub fn f(_: crate::A) {}\n"),
    ];
    finds("exported", "src: a → b → a\n", &files);
}

#[test]
fn sees_paths_in_macro_calls() {
    let files = [
        ("lib.rs", "mod a;\nmod b;\n"),
        ("a.rs", "pub fn f() {\n    println!(\"{}\", 1 + crate::b::g());\n}\n"),
        ("b.rs", "pub fn g() -> u32 { 1 }\npub fn h() { crate::a::f(); }\n"),
    ];
    finds("macro", "src: a → b → a\n", &files);
}

#[test]
fn a_child_and_its_parent_do_not_use_each_other() {
    let child = ("folder/child.rs", "use super::Parent;\npub fn f(_: Parent) {}\n");
    let root = ("lib.rs", "mod folder;\n");
    let uses = ("folder/mod.rs", "mod child;\npub struct Parent;\npub fn g() { child::f(Parent); }\n");
    finds("parent", "folder: mod.rs → child → mod.rs\n", &[root, uses, child]);
    let re_exports = ("folder/mod.rs", "mod child;\npub use child::f;\npub struct Parent;\n");
    passes("re-exports", &[root, re_exports, child]);
}

#[test]
fn finds_cycles_within_a_folder_and_between_folders() {
    let files = [
        ("lib.rs", "mod folder;\n"),
        ("folder/mod.rs", "mod a;\nmod b;\n"),
        ("folder/a.rs", "pub fn f() { super::b::g(); }\n"),
        ("folder/b.rs", "pub fn g() { super::a::f(); }\n"),
    ];
    finds("inside", "folder: a → b → a\n", &files);
    finds(
        "folders",
        "src: one → two → one\n",
        &[
            ("lib.rs", "mod one;\nmod two;\n"),
            ("one/mod.rs", "mod a;\nmod b;\n"),
            ("one/a.rs", "pub fn f() { crate::two::g(); }\n"),
            ("one/b.rs", "pub const B: u32 = 1;\n"),
            ("two.rs", "pub fn g() { crate::one::b::B; }\n"),
        ],
    );
}

#[test]
fn tests_and_variables_are_no_arrows() {
    passes(
        "tests",
        &[
            ("lib.rs", "mod a;\nmod b;\n"),
            ("a.rs", "pub fn f() {}\n#[cfg(test)]\nmod tests {\n    use crate::b::g;\n    fn t() { g(); }\n}\n"),
            ("b.rs", "pub fn g() { let a = 1; crate::a::f(); drop(a); }\n"),
        ],
    );
}
